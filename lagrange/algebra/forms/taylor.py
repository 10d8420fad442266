"""Expressions expanded about a point: SymPy in, jets out.

The variables of an expansion are symbols with a jet of their own (a coordinate q = q_0 + h, or a coordinate
that the constraints make a function of others). Everything else is a constant. Numbers at the point
(parameters, roots, cosines, undefined functions and their derivatives) are asked of the sampler, through
`value`; the rest follows by the rules of `jets`. A prescribed motion is expanded in t with its own slots,
and an undefined function in all its arguments,

    u = u_0 + u_0' τ + u_0'' τ²/2 + ... ,      f(a + ν) = Σ ∂^α f(a) ν^α/α! ,

where the derivatives are as many independent numbers; that mixed partial derivatives commute is in their
notation. What has no expansion (Piecewise, Max, an unknown function) raises `NoExpansionError`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from math import factorial
from typing import Any

import sympy as sp

from lagrange.algebra.forms.jets import Jet, Ring, constant_term, nilpotent
from lagrange.core.symbols import Unspecified, base, prime, t


class NoExpansionError(Exception):
    """An expression without a Taylor series that is known here."""


class Expansion:
    """The jets of expressions at one point.

    value       an expression without expansion variables' increments: its number at the point
    variables   symbol -> jet, all of one order; t among them
    prescribed  the symbols u of prescribed motions; u, u', ... are functions of t
    """

    def __init__(
        self,
        ring: Ring,
        value: Callable[[sp.Expr], Any],
        variables: Mapping[sp.Symbol, Jet],
        prescribed: Sequence[sp.Symbol] = (),
    ) -> None:
        self.ring = ring
        self.value = value
        self.order = len(variables[t]) - 1
        self._prescribed = frozenset(prescribed)
        self._variables = frozenset(variables)
        self._known: dict[sp.Expr, Jet] = dict(variables)
        self._varies: dict[sp.Basic, bool] = {}

    def __call__(self, expression: sp.Expr) -> Jet:
        """The jet of an expression."""
        known = self._known.get(expression)
        if known is None:
            known = self._expand(expression) if self._moves(expression) else self._constant(self.value(expression))
            self._known[expression] = known
        return known

    def _moves(self, e: sp.Basic) -> bool:
        """Whether an expansion variable occurs in it."""
        if e.is_Symbol:
            return e in self._variables or base(e) in self._prescribed
        known = self._varies.get(e)
        if known is None:
            known = self._varies[e] = any(self._moves(a) for a in e.args)
        return known

    def _expand(self, e: sp.Expr) -> Jet:
        if e.is_Symbol:
            return self._motion(e)
        if e.is_Add:
            total = self(e.args[0])
            for a in e.args[1:]:
                total = self.ring.add(total, self(a))
            return total
        if e.is_Mul:
            return self._product(e)
        if e.is_Pow:
            return self._power(e)
        if isinstance(e, Unspecified):
            return self._undefined(e)
        return self._function(e)

    def _product(self, e: sp.Mul) -> Jet:
        moving = [a for a in e.args if self._moves(a)]
        jet = self(moving[0])
        for a in moving[1:]:
            jet = self.ring.multiply(jet, self(a))
        if len(moving) < len(e.args):
            jet = self.ring.scale(jet, self.value(sp.Mul(*(a for a in e.args if not self._moves(a)))))
        return jet

    def _power(self, e: sp.Pow) -> Jet:
        if e.exp.is_Integer:
            return self.ring.power(self(e.base), int(e.exp))
        if self._moves(e.exp):
            return self._exponential(e, e.exp * sp.log(e.base))
        return self.ring.real_power(self(e.base), self.value(e.exp), self.value(e))

    def _exponential(self, e: sp.Expr, exponent: sp.Expr) -> Jet:
        return self.ring.exponential(self(exponent), self.value(e))

    def _function(self, e: sp.Expr) -> Jet:
        if isinstance(e, sp.exp):
            return self._exponential(e, e.args[0])
        if isinstance(e, sp.sin | sp.cos):
            return self._circular(e)
        if isinstance(e, sp.sinh | sp.cosh):
            return self._hyperbolic(e)
        if isinstance(e, sp.atan2):
            return self._arc(e, *e.args)
        if len(e.args) != 1:
            raise NoExpansionError(e)
        (a,) = e.args
        match e:
            case sp.tan() | sp.cot() | sp.sec() | sp.csc():
                return self(_quotient(e, a))
            case sp.tanh():
                return self(sp.sinh(a) / sp.cosh(a))
            case sp.log():
                return self.ring.logarithm(self(a), self.value(e))
            case sp.Abs():
                return self.ring.scale(self(a), self._sign(a))
            case sp.sign():
                return self._constant(self._sign(a))
            case sp.atan():
                return self._arc(e, a, sp.S.One)
            case sp.asin():
                return self._arc(e, a, sp.sqrt(1 - a**2))
            case sp.acos():
                return self._arc(e, sp.sqrt(1 - a**2), a)
        raise NoExpansionError(e)

    def _circular(self, e: sp.Expr) -> Jet:
        (a,) = e.args
        c, s = sp.cos(a), sp.sin(a)
        cosine, sine = self.ring.rotation(self(a), self.value(c), self.value(s))
        self._known[c], self._known[s] = cosine, sine
        return cosine if isinstance(e, sp.cos) else sine

    def _hyperbolic(self, e: sp.Expr) -> Jet:
        (a,) = e.args
        c, s = sp.cosh(a), sp.sinh(a)
        even, odd = self.ring.hyperbolic(self(a), self.value(c), self.value(s))
        self._known[c], self._known[s] = even, odd
        return even if isinstance(e, sp.cosh) else odd

    def _arc(self, e: sp.Expr, y: sp.Expr, x: sp.Expr) -> Jet:
        return self.ring.angle(self(y), self(x), self.value(e))

    def _sign(self, a: sp.Expr) -> Any:
        self.ring.arithmetic.inverse(constant_term(self(a)))  # no sign at 0: another point
        return self.value(sp.sign(a))

    def _motion(self, symbol: sp.Symbol) -> Jet:
        """A slot of a prescribed motion: Σ u^(k) τ^k/k!."""
        terms = [self.value(prime(symbol, k) if k else symbol) for k in range(self.order + 1)]
        divided = [v * self.ring.arithmetic.number(1, factorial(k)) for k, v in enumerate(terms)]
        return self.ring.compose(divided, nilpotent(self(t)))

    def _undefined(self, e: Unspecified) -> Jet:
        """Σ ∂^α f(a) ν^α/α!, over the increments ν of the arguments."""
        increments = [nilpotent(self(a)) if self._moves(a) else self._constant(0) for a in e.arguments]
        moving = [k for k, nu in enumerate(increments) if any(nu)]
        powers = {k: self._powers(increments[k]) for k in moving}
        total = self._constant(0)
        for alpha in _multi_indices(len(moving), self.order):
            derivative, term, divisor = e, self._constant(1), 1
            for k, n in zip(moving, alpha, strict=True):
                divisor *= factorial(n)
                if n:
                    term = self.ring.multiply(term, powers[k][n])
                for _ in range(n):
                    derivative = derivative.partial(k)
            factor = self.value(derivative) * self.ring.arithmetic.number(1, divisor)
            total = self.ring.add(total, self.ring.scale(term, factor))
        return total

    def _powers(self, nu: Jet) -> list[Jet]:
        row = [self._constant(1)]
        for _ in range(self.order):
            row.append(self.ring.multiply(row[-1], nu))
        return row

    def _constant(self, value: Any) -> Jet:
        return self.ring.constant(value, self.order)


def _quotient(e: sp.Expr, a: sp.Expr) -> sp.Expr:
    match e:
        case sp.tan():
            return sp.sin(a) / sp.cos(a)
        case sp.cot():
            return sp.cos(a) / sp.sin(a)
        case sp.sec():
            return 1 / sp.cos(a)
        case _:
            return 1 / sp.sin(a)


def _multi_indices(count: int, total: int) -> Iterator[tuple[int, ...]]:
    """All tuples of `count` natural numbers with a sum up to `total`."""
    if count == 0:
        yield ()
        return
    for first in range(total + 1):
        for rest in _multi_indices(count - 1, total - first):
            yield first, *rest
