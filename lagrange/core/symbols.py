"""The symbols of mechanics, and the state slots.

A coordinate q, its velocity q' and its acceleration q'' are three independent symbols ("slots"), and the total time
derivative is an explicit sum,

    d/dt = ∂/∂t + Σ q' ∂/∂q + Σ q'' ∂/∂q' ,

so that ∂T/∂q' is an ordinary partial derivative. A prescribed motion u(t) has slots of the same kind, but belongs to
time: ∂/∂t at a frozen configuration takes u along. The name of a symbol is its text form in the language of problem
files (`theta''`, `d(x)`, `delta(x)`, `lambda_rod`), so that what is printed can be read back.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import lru_cache

import sympy as sp
from sympy.core.symbol import Str
from sympy.printing.str import StrPrinter

from lagrange.core.records import record

t = sp.Symbol("t", real=True)

CONSTANT = sp.Symbol("const", real=True)
"""The value that a finite relation keeps: x − R φ = const."""


class Sign(sp.Symbol):
    """A symbol that is +1 or -1; its even powers are 1."""

    __slots__ = ()

    def __new__(cls, name: str) -> Sign:
        """The sign of this name."""
        symbol: Sign = super().__new__(cls, name, real=True, nonzero=True)
        return symbol

    def _eval_power(self, exponent: sp.Expr) -> sp.Expr | None:
        if exponent.is_Integer:
            return sp.S.One if exponent.is_even else self
        return None

    def _eval_Abs(self) -> sp.Expr:
        return sp.S.One


class UnitVector(sp.Symbol):
    """i, j, k, e_r, ...: what components are printed with. A scalar `k` is another symbol."""

    __slots__ = ()


class VectorSymbol(sp.Symbol):
    """A named vector such as r_P, r_P'' or delta(r_P), for printing formulas such as (m r'' - F)·δr = 0."""

    __slots__ = ()


class FormSymbol(sp.Symbol):
    """A named differential form ω_1, for printing combinations such as y ω_1 + ω_2."""

    __slots__ = ()


class Unspecified(sp.Expr):
    """An undefined function, or a partial derivative of one, at its arguments.

    `Unspecified(f, (X, Y, Z), (1, 0, 0), x - u*t, y, z)` is ∂f/∂X at X = x - u t, Y = y, Z = z.
    """

    is_commutative = True
    is_real = True
    is_extended_real = True

    def __new__(cls, name: Str, names: sp.Tuple, orders: sp.Tuple, *arguments: sp.Expr) -> Unspecified:
        """The function `name`, differentiated `orders` times by each of its arguments `names`."""
        function: Unspecified = super().__new__(cls, name, names, orders, *arguments)
        return function

    @classmethod
    def of(cls, name: str, names: Iterable[str], *arguments: sp.Expr) -> Unspecified:
        """The function itself at the given arguments; `names` are what its arguments are called."""
        slots = sp.Tuple(*(Str(n) for n in names))
        return cls(Str(name), slots, sp.Tuple(*([0] * len(slots))), *arguments)

    @property
    def name(self) -> str:
        """The function's name."""
        return str(self.args[0])

    @property
    def argument_names(self) -> tuple[str, ...]:
        """What the arguments are called: X, Y, Z."""
        return tuple(str(n) for n in self.args[1])

    @property
    def orders(self) -> tuple[int, ...]:
        """How often it is differentiated by each argument."""
        return tuple(int(n) for n in self.args[2])

    @property
    def arguments(self) -> tuple[sp.Expr, ...]:
        """Where it is taken."""
        return tuple(self.args[3:])

    def _sympystr(self, printer: StrPrinter) -> str:
        text = f"{self.name}({', '.join(map(printer.doprint, self.arguments))})"
        for name, order in zip(self.argument_names, self.orders, strict=True):
            for _ in range(order):
                text = f"diff({text}, {name})"
        return text

    def partial(self, index: int) -> Unspecified:
        """The partial derivative by argument `index`."""
        orders = [n + (k == index) for k, n in enumerate(self.orders)]
        return Unspecified(self.args[0], self.args[1], sp.Tuple(*orders), *self.arguments)

    def _eval_derivative(self, symbol: sp.Symbol) -> sp.Expr:
        terms = ((self.partial(k), a.diff(symbol)) for k, a in enumerate(self.arguments))
        return sp.Add(*(f * da for f, da in terms if da != 0))


def prime(symbol: sp.Symbol, order: int = 1) -> sp.Symbol:
    """The slot of the time derivative: q -> q'."""
    return sp.Symbol(symbol.name + "'" * order, real=True)


def differential(symbol: sp.Symbol) -> sp.Symbol:
    """The differential dq of a coordinate or of t."""
    return sp.Symbol(f"d({symbol.name})", real=True)


def variation(symbol: sp.Symbol) -> sp.Symbol:
    """The virtual displacement δq of a coordinate."""
    return sp.Symbol(f"delta({symbol.name})", real=True)


def multiplier(constraint: str) -> sp.Symbol:
    """The multiplier of a constraint, λ_rod."""
    return sp.Symbol(f"lambda_{constraint}", real=True)


def counting(name: str) -> str:
    """A name to sort by, with its numbers as numbers: m_2 before m_10."""
    return re.sub(r"\d+", lambda n: n[0].zfill(4), name)


def base(symbol: sp.Symbol) -> sp.Symbol:
    """The coordinate that a slot belongs to: q'' -> q."""
    return sp.Symbol(symbol.name.rstrip("'"), real=True) if symbol.name.endswith("'") else symbol


@record
class Slots:
    """What moves: the coordinates, and the prescribed motions u(t) that move by themselves."""

    coordinates: tuple[sp.Symbol, ...]
    prescribed: tuple[sp.Symbol, ...] = ()

    @property
    def velocities(self) -> tuple[sp.Symbol, ...]:
        """The slots q'."""
        return tuple(prime(q) for q in self.coordinates)

    @property
    def accelerations(self) -> tuple[sp.Symbol, ...]:
        """The slots q''."""
        return tuple(prime(q, 2) for q in self.coordinates)

    def time_derivative(self, expression: sp.Expr) -> sp.Expr:
        """The total derivative d/dt = ∂/∂t + Σ q' ∂/∂q + Σ q'' ∂/∂q' + ..."""
        return self._derivative(expression, {*self.coordinates, *self.prescribed})

    def frozen_derivative(self, expression: sp.Expr) -> sp.Expr:
        """∂/∂t with the configuration and the velocities frozen; prescribed motions go on."""
        return self._derivative(expression, set(self.prescribed))

    def _derivative(self, expression: sp.Expr, moving: set[sp.Symbol]) -> sp.Expr:
        def rate(symbol: sp.Symbol) -> sp.Expr:
            if symbol == t:
                return sp.S.One
            return prime(symbol) if base(symbol) in moving else sp.S.Zero

        return derivative(expression, rate)


def derivative(expression: sp.Expr, rate: Callable[[sp.Symbol], sp.Expr]) -> sp.Expr:
    """The derivative of an expression whose symbols have the given derivatives, in one pass.

    It is Σ ∂e/∂s · rate(s), with shared parts differentiated once; SymPy alone would take a pass for each symbol.
    """
    known: dict[sp.Basic, sp.Expr] = {}

    def of(e: sp.Basic) -> sp.Expr:
        found = known.get(e)
        if found is None:
            found = known[e] = _by_chain_rule(e, of, rate)
        return found

    return of(expression)


@lru_cache(maxsize=1 << 15)
def partial(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """∂/∂symbol. Parts of expressions that occur again, as positions along a chain do, are differentiated once."""
    return _by_chain_rule(expression, lambda e: partial(e, symbol), lambda s: sp.S.One if s == symbol else sp.S.Zero)


def _by_chain_rule(e: sp.Basic, of: Callable[[sp.Basic], sp.Expr], rate: Callable[[sp.Symbol], sp.Expr]) -> sp.Expr:
    """One step down: the derivative from those of the arguments, which `of` gives."""
    if e.is_Symbol:
        return rate(e)
    if not e.args:
        return sp.S.Zero
    if e.is_Add:
        return sp.Add(*(r for a in e.args if (r := of(a)) is not sp.S.Zero))
    rates = [(k, of(a)) for k, a in enumerate(e.args) if isinstance(a, sp.Expr)]
    changing = [(k, r) for k, r in rates if r != 0]
    if not changing:
        return sp.S.Zero
    if e.is_Mul:
        return sp.Add(*(sp.Mul(*e.args[:k], r, *e.args[k + 1 :]) for k, r in changing))
    if e.is_Pow and changing[-1][0] == 0:
        return e.exp * e.base ** (e.exp - 1) * changing[0][1]
    if isinstance(e, Unspecified):
        return sp.Add(*(e.partial(k - 3) * r for k, r in changing))
    if isinstance(e, sp.Function):
        return sp.Add(*(e.fdiff(k + 1) * r for k, r in changing))
    return sp.Add(*(e.diff(s) * rate(s) for s in sorted(e.free_symbols, key=lambda s: s.name)))


class Inert(sp.Expr):
    """An operation that is shown and not carried out."""

    is_commutative = True


class Dot(Inert):
    """a·b of two vectors that are named or given by their components."""


class Partial(Inert):
    """∂e/∂x, standing for the derivative that is about to be taken."""


class Rate(Inert):
    """d/dt(e), standing for the total derivative that is about to be taken."""


class Wedge(Inert):
    """dx ∧ dy ∧ dθ."""
