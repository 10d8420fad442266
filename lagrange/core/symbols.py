"""The symbols of mechanics, and the state slots.

A coordinate q, its velocity q' and its acceleration q'' are three independent symbols ("slots"), and the total time
derivative is an explicit sum,

    d/dt = ∂/∂t + Σ q' ∂/∂q + Σ q'' ∂/∂q' ,

so that ∂T/∂q' is an ordinary partial derivative. A prescribed motion u(t) has slots of the same kind, but is a
function of time alone: ∂/∂t at a frozen configuration includes its rate u'. The name of a symbol is its text form in
the language of problem files (`theta''`, `d(x)`, `delta(x)`, `lambda_rod`), so that printed text can be read back.

Signs of functions of parameters that have a range: the sine and the cosine of an acute angle are positive.

A sine, cosine or tangent of Σ c_i α_i + b keeps its sign between two neighbouring zeros, and Σ c_i α_i + b itself is
considered over the whole range. At an end of the range where the function vanishes it has no sign.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Sequence
from functools import lru_cache

import sympy as sp
from sympy.core.symbol import Str
from sympy.printing.str import StrPrinter

from lagrange.core.effort import remembered
from lagrange.core.records import record

t = sp.Symbol("t", real=True)

CONSTANT = sp.Symbol("const", real=True)
"""The constant value of a finite relation: x − R φ = const."""


@lru_cache(maxsize=1000)
def symbols_in(e: sp.Expr) -> frozenset[sp.Symbol]:
    """The free symbols of an expression; SymPy joins the sets of all parts each time it is asked."""
    symbols: set[sp.Symbol] = set()
    seen: set[sp.Basic] = set()
    waiting: list[sp.Basic] = [e]
    while waiting:
        part = waiting.pop()
        if part in seen:
            continue
        seen.add(part)
        if type(part).free_symbols is sp.Basic.free_symbols:
            waiting += part.args
        else:  # a symbol, or what binds some: Subs
            symbols |= part.free_symbols
    return frozenset(symbols)


class Sign(sp.Symbol):
    """A symbol with the value +1 or -1; its even powers are 1."""

    __slots__ = ()

    def __new__(cls, name: str) -> Sign:
        """The sign with this name."""
        symbol: Sign = super().__new__(cls, name, real=True, nonzero=True)
        return symbol

    def _eval_power(self, exponent: sp.Expr) -> sp.Expr | None:
        if exponent.is_Integer:
            return sp.S.One if exponent.is_even else self
        return None

    def _eval_Abs(self) -> sp.Expr:
        return sp.S.One


class Decimal(sp.Symbol):
    """A decimal in an answer, which stands for all numbers that round to it.

    written     the number itself
    half_width  how far a number that rounds to it may be from it

    Its name is the decimal and the place where it was written, so that each place has a symbol of its own.
    """

    __slots__ = ("half_width", "written")

    def __new__(cls, text: str, place: str) -> Decimal:
        """The decimal with this text, `14.01` or `1.2e-3`; of the zeros in 346000 only three digits count."""
        symbol: Decimal = cls.__xnew__(cls, f"{text} at {place}", positive=True)
        mantissa, _, power = text.lower().partition("e")
        whole, point, decimals = mantissa.partition(".")
        zeros = len(whole) - max(len(whole.rstrip("0")), 3)
        places = len(decimals) if point else -max(zeros, 0)
        symbol.written = sp.Rational(text)
        symbol.half_width = sp.Rational(1, 2) * sp.Integer(10) ** (int(power or 0) - places)
        return symbol

    @staticmethod
    def is_rounded(text: str) -> bool:
        """Whether a number may have been rounded.

        One with a decimal point and two digits that count, but not 2.0; or a whole number with three digits, 353.
        """
        mantissa = text.lower().partition("e")[0]
        whole, point, places = mantissa.partition(".")
        digits = (whole + places).lstrip("0")
        if not point:
            return len(digits) > 2
        return len(digits) > 1 and not (len(digits) == 2 and not places.strip("0"))

    @property
    def text(self) -> str:
        """The decimal as it was written."""
        return str(self.name).partition(" ")[0]

    def __getnewargs_ex__(self) -> tuple[tuple[object, ...], dict[str, bool]]:
        return (self.text, self.name.partition(" at ")[2]), {}


class Bounded(sp.Symbol):
    """A parameter between two numbers: an acute angle α, 0 < α < π/2, or one with a closed range [a, b].

    strict  whether it is never the lower end, and never the higher one
    """

    __slots__ = ("high", "low", "strict")

    def __new__(cls, name: str, low: sp.Expr, high: sp.Expr, strict: tuple[bool, bool] = (False, False)) -> Bounded:
        """The parameter with this name."""
        assumptions: dict[str, bool] = {"real": True}
        if low > 0 or (low == 0 and strict[0]):
            assumptions = {"positive": True}
        elif high < 0 or (high == 0 and strict[1]):
            assumptions = {"negative": True}
        elif low == 0:
            assumptions = {"nonnegative": True}
        elif high == 0:
            assumptions = {"nonpositive": True}
        symbol: Bounded = cls.__xnew__(cls, name, **assumptions)  # the cache of symbols knows no ends
        symbol.low, symbol.high, symbol.strict = low, high, strict
        return symbol

    def _hashable_content(self) -> tuple[object, ...]:
        return (*super()._hashable_content(), self.low, self.high, self.strict)

    def __getnewargs_ex__(self) -> tuple[tuple[object, ...], dict[str, bool]]:
        return (self.name, self.low, self.high, self.strict), {}


class UnitVector(sp.Symbol):
    """A unit vector i, j, k, e_r, ..., for printing components. A scalar `k` is another symbol."""

    __slots__ = ()


class VectorSymbol(sp.Symbol):
    """A named vector such as r_P, r_P'' or delta(r_P), for printing formulas such as (m r'' - F)·δr = 0."""

    __slots__ = ()


class UnitSymbol(sp.Symbol):
    """A unit of measurement after a number, `m/s^2`, for printing."""

    __slots__ = ()


class FormSymbol(sp.Symbol):
    """A named differential form ω_1, for printing combinations such as y ω_1 + ω_2."""

    __slots__ = ()


class Unspecified(sp.Expr):
    """An undefined function, or a partial derivative of one, at given arguments.

    `Unspecified(f, (X, Y, Z), (1, 0, 0), x - u*t, y, z)` is ∂f/∂X at X = x - u t, Y = y, Z = z.
    """

    is_commutative = True
    is_real = True
    is_extended_real = True

    def __new__(cls, name: Str, names: sp.Tuple, orders: sp.Tuple, *arguments: sp.Expr) -> Unspecified:
        """The function `name`, differentiated `orders` times with respect to each of its arguments `names`."""
        function: Unspecified = super().__new__(cls, name, names, orders, *arguments)
        return function

    @classmethod
    def of(cls, name: str, names: Iterable[str], *arguments: sp.Expr) -> Unspecified:
        """The function itself at the given arguments, which are called `names`."""
        slots = sp.Tuple(*(Str(n) for n in names))
        return cls(Str(name), slots, sp.Tuple(*([0] * len(slots))), *arguments)

    @property
    def name(self) -> str:
        """The function's name."""
        return str(self.args[0])

    @property
    def argument_names(self) -> tuple[str, ...]:
        """The names of the arguments: X, Y, Z."""
        return tuple(str(n) for n in self.args[1])

    @property
    def orders(self) -> tuple[int, ...]:
        """The order of the derivative with respect to each argument."""
        return tuple(int(n) for n in self.args[2])

    @property
    def arguments(self) -> tuple[sp.Expr, ...]:
        """The arguments at which it is taken."""
        return tuple(self.args[3:])

    def _sympystr(self, printer: StrPrinter) -> str:
        text = f"{self.name}({', '.join(map(printer.doprint, self.arguments))})"
        for name, order in zip(self.argument_names, self.orders, strict=True):
            for _ in range(order):
                text = f"diff({text}, {name})"
        return text

    def partial(self, index: int) -> Unspecified:
        """The partial derivative with respect to argument `index`."""
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


def velocity_before(coordinate: sp.Symbol) -> sp.Symbol:
    """The velocity just before an impact, x'_0."""
    return sp.Symbol(f"{coordinate.name}'_0", real=True)


def multiplier(constraint: str) -> sp.Symbol:
    """The multiplier of a constraint, λ_rod."""
    return sp.Symbol(f"lambda_{constraint}", real=True)


def free_letter(*candidates: str, taken: Collection[str], of: Sequence[str] = ()) -> str:
    """The first letter that no name uses, with each of the subscripts `of` if there are any."""
    for letter in candidates:
        if not any(name in taken for name in ([f"{letter}_{s}" for s in of] or [letter])):
            return letter
    return candidates[-1] + "_"


@lru_cache(maxsize=1000)
def counting(name: str) -> str:
    """A sort key for a name, with its numbers as numbers: m_2 before m_10."""
    return re.sub(r"\d+", lambda n: n[0].zfill(4), name)


def base(symbol: sp.Symbol) -> sp.Symbol:
    """The coordinate of a slot: q'' -> q."""
    return sp.Symbol(symbol.name.rstrip("'"), real=True) if symbol.name.endswith("'") else symbol


@record
class Slots:
    """The quantities that change in time: the coordinates q, and the prescribed motions u(t)."""

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
        return self.time_derivation()(expression)

    def time_derivation(self) -> Callable[[sp.Expr], sp.Expr]:
        """d/dt of several expressions: momenta share the velocities, and positions along a chain those before them."""
        kept = remembered()
        rate: Callable[[sp.Expr], sp.Expr] | None = kept.get(self)
        if rate is None:
            rate = kept[self] = derivation(self._rate({*self.coordinates, *self.prescribed}))
        return rate

    def frozen_derivative(self, expression: sp.Expr) -> sp.Expr:
        """∂/∂t with the configuration and the velocities frozen; prescribed motions continue."""
        return derivative(expression, self._rate(set(self.prescribed)))

    def _rate(self, moving: set[sp.Symbol]) -> Callable[[sp.Symbol], sp.Expr]:
        def rate(symbol: sp.Symbol) -> sp.Expr:
            if symbol == t:
                return sp.S.One
            return prime(symbol) if base(symbol) in moving else sp.S.Zero

        return rate


def derivative(expression: sp.Expr, rate: Callable[[sp.Symbol], sp.Expr]) -> sp.Expr:
    """The derivative Σ ∂e/∂s · rate(s) of an expression whose symbols s have the derivatives `rate(s)`.

    Shared parts are differentiated once, and one pass serves all symbols; SymPy would need one pass for each.
    """
    return derivation(rate)(expression)


def derivation(rate: Callable[[sp.Symbol], sp.Expr]) -> Callable[[sp.Expr], sp.Expr]:
    """The derivatives of several expressions, as `derivative` takes them, the parts that they share once."""
    known: dict[sp.Basic, sp.Expr] = {}

    def of(e: sp.Basic) -> sp.Expr:
        result = known.get(e)
        if result is None:
            result = known[e] = _by_chain_rule(e, of, rate)
        return result

    return of


@lru_cache(maxsize=1 << 15)
def partial(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """∂/∂symbol. Parts that occur in several expressions, as positions along a chain do, are differentiated once."""
    return _by_chain_rule(expression, lambda e: partial(e, symbol), lambda s: sp.S.One if s == symbol else sp.S.Zero)


def _by_chain_rule(e: sp.Basic, of: Callable[[sp.Basic], sp.Expr], rate: Callable[[sp.Symbol], sp.Expr]) -> sp.Expr:
    """The derivative of a node from those of its arguments, which `of` returns."""
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
    if isinstance(e, sp.sign):
        return sp.S.Zero  # constant except where it jumps, and there the motion has no acceleration
    if isinstance(e, sp.Abs):
        return sp.sign(e.args[0]) * changing[0][1]
    if isinstance(e, sp.Function):
        return sp.Add(*(e.fdiff(k + 1) * r for k, r in changing))
    return sp.Add(*(e.diff(s) * rate(s) for s in sorted(e.free_symbols, key=lambda s: s.name)))


class Inert(sp.Expr):
    """An operation that is printed unevaluated."""

    is_commutative = True


class DotProduct(Inert):
    """a·b of two vectors that are named or given by their components."""


class CrossProduct(Inert):
    """a × b, likewise."""


class Partial(Inert):
    """∂e/∂x, for printing a derivative before it is evaluated."""


class TimeDerivative(Inert):
    """d/dt(e), for printing a total derivative before it is evaluated."""


class Wedge(Inert):
    """dx ∧ dy ∧ dθ."""


# Ranges


FIRST_ZERO = {sp.sin: sp.S.Zero, sp.cos: -sp.pi / 2}
"""Where a function of period 2π begins to be positive for half of it."""


@record
class Ends:
    """The values between which an expression lies; `strict`: whether it is never the lower, and never the higher."""

    low: sp.Expr
    high: sp.Expr
    strict: tuple[bool, bool]


def sign_in_range(f: sp.Expr) -> int | None:
    """+1 or −1 where a function has this sign in the whole range of its parameters; None elsewhere."""
    symbols = f.free_symbols
    if not symbols or not all(isinstance(s, Bounded) for s in symbols):
        return None
    if isinstance(f, sp.sin | sp.cos):
        ends = range_of(f.args[0])
        return None if ends is None else sign_between(f.func, ends.low, ends.high, ends.strict)
    if isinstance(f, sp.tan | sp.cot):
        signs = [sign_in_range(g(f.args[0])) for g in (sp.sin, sp.cos)]
        return None if signs[0] is None or signs[1] is None else signs[0] * signs[1]
    if isinstance(f, sp.sec | sp.csc):
        return sign_in_range((sp.cos if isinstance(f, sp.sec) else sp.sin)(f.args[0]))
    ends = range_of(f)
    if ends is None:
        return None
    if ends.low > 0 or (ends.low == 0 and ends.strict[0]):
        return 1
    return -1 if ends.high < 0 or (ends.high == 0 and ends.strict[1]) else None


def without_known_magnitudes(e: sp.Expr) -> sp.Expr:
    """|cos α| as cos α for an acute angle α."""
    signs = {a: sign_in_range(a.args[0]) for a in e.atoms(sp.Abs)}
    return e.xreplace({a: sign * a.args[0] for a, sign in signs.items() if sign is not None})


def range_of(e: sp.Expr) -> Ends | None:
    """The range of a linear expression in parameters that have one; None for any other."""
    low = high = sp.S.Zero
    below = above = False
    for term in sp.Add.make_args(e):
        if term.is_number:
            low, high = low + term, high + term
            continue
        constant, symbol = term.as_independent(*term.free_symbols, as_Add=False)
        if not isinstance(symbol, Bounded):
            return None
        ends, strict = (symbol.low, symbol.high), symbol.strict
        if constant.is_negative:
            ends, strict = ends[::-1], strict[::-1]
        low, high = low + constant * ends[0], high + constant * ends[1]
        below, above = below or strict[0], above or strict[1]
    return Ends(low, high, (below, above))


def sign_between(f: type[sp.Function], low: sp.Expr, high: sp.Expr, strict: tuple[bool, bool]) -> int | None:
    """The sign of sine or cosine between two angles; `strict`: whether the angle is never the lower, the higher one."""
    first = FIRST_ZERO[f]
    half = sp.floor((low - first) / sp.pi)
    begin, end = first + half * sp.pi, first + (half + 1) * sp.pi
    if high > end or (low == begin and not strict[0]) or (high == end and not strict[1]):
        return None
    return 1 if half % 2 == 0 else -1


def never_vanishes(f: sp.Expr) -> bool:
    """Whether a factor is known to be different from zero: m, or the sine of an acute angle."""
    return bool(f.is_nonzero) or sign_in_range(f) is not None
