"""Truncated Taylor series in several variables (jets), and the expansion of SymPy expressions into them.

A jet of order d is f(a + h) = Σ f_α h^α, |α| ≤ d, at one point a, with coefficients in a prime field (or reals of
eighty digits, where a point has no residues). Sums and products are those of polynomials cut off at degree d; a
derivative loses one order. A function of a jet g = g_0 + ν, whose ν is nilpotent, is a polynomial in ν:

    g^e = g_0^e Σ binom(e, k) (ν/g_0)^k,   exp g = e^{g_0} Σ ν^k/k!,   cos g = cos g_0 cos ν − sin g_0 sin ν,
    log g = log g_0 + Σ (−1)^{k+1} (ν/g_0)^k/k,
    atan2(y, x) = atan2(y_0, x_0) + atan((x_0 y − y_0 x)/(x_0 x + y_0 y)).

Only numbers at the point (parameters, roots, cosines, undefined functions and their derivatives) are asked of the
sampler, through `value`; the rest is arithmetic. A prescribed motion is expanded in t with its own slots,
u = u_0 + u_0' τ + u_0'' τ²/2 + ..., and an undefined function in all its arguments, f(a + ν) = Σ ∂^α f(a) ν^α/α!, where
the derivatives are independent numbers. Piecewise, Max and unknown functions raise `NoExpansionError`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from math import factorial
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import NumberField
from lagrange.algebra.exact.prime_field import PrimeField
from lagrange.algebra.forms.antiderivatives import in_sine_and_cosine
from lagrange.core.symbols import Unspecified, base, prime, t

Level = dict[int, Any]
Jet = tuple[Level, ...]

# A jet is stored by degree, as dictionaries from monomials to coefficients. Four bits of a monomial's key are the
# exponent of one variable, so that the key of a product is the sum of the keys; hence orders up to 15.
BITS = 4
HIGHEST_ORDER = (1 << BITS) - 1
REAL_WEIGHT = 8  # what the product of two reals of eighty digits costs, in products of residues


class WorkLimitError(Exception):
    """The limit on arithmetic operations is reached."""


class JetRing:
    """Jets over some arithmetic, in any number of variables, of any order up to 15, with a limit on the work.

    `work` counts products of coefficients and of jets; `WorkLimitError` is raised when it passes `limit`. A
    division by zero raises what the arithmetic raises.
    """

    def __init__(self, arithmetic: NumberField, limit: int = 1 << 62) -> None:
        self.arithmetic = arithmetic
        self._modulus = arithmetic.p if isinstance(arithmetic, PrimeField) else 0
        self._weight = 1 if self._modulus else REAL_WEIGHT
        self.limit = limit
        self.work = 0

    def constant(self, value: Any, order: int) -> Jet:
        """The number `value`."""
        if isinstance(value, int) and not self._modulus:
            value = self.arithmetic.number(value)
        return (self._reduced({0: value}), *({} for _ in range(order)))

    def variable(self, index: int, value: Any, order: int) -> Jet:
        """The variable number `index`, which is `value` at the point."""
        jet = self.constant(value, order)
        if order:
            jet[1][1 << BITS * index] = self.arithmetic.number(1)
        return jet

    def add(self, a: Jet, b: Jet) -> Jet:
        """The sum a + b, to the lower of both orders."""
        return tuple(self._sum(x, y, 1) for x, y in zip(a, b, strict=False))

    def subtract(self, a: Jet, b: Jet) -> Jet:
        """The difference a - b."""
        return tuple(self._sum(x, y, -1) for x, y in zip(a, b, strict=False))

    def scale(self, a: Jet, factor: Any) -> Jet:
        """The multiple factor · a."""
        return tuple(self._reduced({k: c * factor for k, c in level.items()}) for level in a)

    def multiply(self, a: Jet, b: Jet) -> Jet:
        """The product a · b, to the lower of both orders."""
        return self.sum_of_products([(a, b)], min(len(a), len(b)) - 1)

    def sum_of_products(self, pairs: Iterable[tuple[Jet, Jet]], order: int) -> Jet:
        """Σ a b, cut off at `order`; a factor of lower order counts as a polynomial of that degree."""
        totals: list[Level] = [{} for _ in range(order + 1)]
        for a, b in pairs:
            self.work += self._weight
            for i, x in enumerate(a[: order + 1]):
                for j, y in enumerate(b[: order + 1 - i] if x else ()):
                    if y:
                        self._accumulate(totals[i + j], x, y)
        return tuple(self._reduced(total) for total in totals)

    def power(self, a: Jet, exponent: int) -> Jet:
        """The integer power of a jet, by repeated squaring."""
        if exponent < 0:
            return self.inverse(self.power(a, -exponent))
        result, square = self.constant(1, len(a) - 1), a
        while exponent:
            if exponent & 1:
                result = self.multiply(result, square)
            exponent >>= 1
            if exponent:
                square = self.multiply(square, square)
        return result

    def inverse(self, a: Jet) -> Jet:
        """1/a."""
        # 1/(g_0 + ν) = (1/g_0) Σ (−ν/g_0)^k.
        first = self._reciprocal(a)
        geometric = [1 if k % 2 == 0 else -1 for k in range(len(a))]
        return self.scale(self.compose(geometric, self.scale(nilpotent(a), first)), first)

    def real_power(self, a: Jet, exponent: Any, root: Any) -> Jet:
        """The power a^e of a jet; `root` is its value at the point."""
        terms = self.binomials(exponent, len(a) - 1)
        return self.scale(self.compose(terms, self.scale(nilpotent(a), self._reciprocal(a))), root)

    def exponential(self, a: Jet, value: Any) -> Jet:
        """The exponential exp a; `value` is its value at the point."""
        return self.scale(self.compose(self._factorials(len(a)), nilpotent(a)), value)

    def logarithm(self, a: Jet, value: Any) -> Jet:
        """The logarithm of a; `value` is its value at the point."""
        terms = [0, *(self.arithmetic.number((-1) ** (k + 1), k) for k in range(1, len(a)))]
        series = self.compose(terms, self.scale(nilpotent(a), self._reciprocal(a)))
        return self.add(series, self.constant(value, len(a) - 1))

    def rotation(self, a: Jet, cosine: Any, sine: Any) -> tuple[Jet, Jet]:
        """The jets of cos a and sin a; `cosine` and `sine` are their values at the point."""
        return self._addition_theorem(a, cosine, sine, -1)

    def hyperbolic(self, a: Jet, cosh: Any, sinh: Any) -> tuple[Jet, Jet]:
        """The jets of cosh a and sinh a, likewise."""
        return self._addition_theorem(a, cosh, sinh, 1)

    def angle(self, y: Jet, x: Jet, value: Any) -> Jet:
        """The angle atan2(y, x); `value` is its value at the point."""
        x0, y0 = constant_term(x), constant_term(y)
        across = self.subtract(self.scale(y, x0), self.scale(x, y0))
        along = self.add(self.scale(x, x0), self.scale(y, y0))
        tangent = self.multiply(across, self.inverse(along))
        order = len(tangent) - 1
        terms = [self.arithmetic.number((-1) ** (k // 2), k) if k % 2 else 0 for k in range(order + 1)]
        return self.add(self.compose(terms, tangent), self.constant(value, order))

    def compose(self, terms: Sequence[Any], small: Jet) -> Jet:
        """Σ terms[k] small^k for a jet without constant term, by Horner's rule with growing order."""
        if not any(small):
            return self.constant(terms[0], len(small) - 1)
        # The innermost products need the lowest order only, because each factor of `small` raises it by one.
        result = self.constant(terms[-1], 0)
        for order, term in enumerate(reversed(terms[:-1]), start=1):
            product = self.sum_of_products([(small, result)], order)
            result = self.add(product, self.constant(term, order))
        return result

    def derivative(self, a: Jet, index: int) -> Jet:
        """The partial derivative by variable `index`; one order is lost."""
        shift = BITS * index
        result: list[Level] = []
        for level in a[1:]:
            lowered: Level = {}
            for key, c in level.items():
                exponent = key >> shift & HIGHEST_ORDER
                if exponent:
                    lowered[key - (1 << shift)] = c * exponent
            result.append(self._reduced(lowered))
        return tuple(result)

    def binomials(self, exponent: Any, order: int) -> list[Any]:
        """The numbers binom(e, k), k = 0 ... order."""
        row = [self.arithmetic.number(1)]
        for k in range(order):
            row.append(self.arithmetic.reduce(row[-1] * (exponent - k) * self.arithmetic.number(1, k + 1)))
        return row

    def _addition_theorem(self, a: Jet, c: Any, s: Any, sign: int) -> tuple[Jet, Jet]:
        """The even and the odd part of the exponential series in the argument, with i² = `sign`."""
        small, factorials = nilpotent(a), self._factorials(len(a))
        even = self.compose([f * sign ** (k // 2) if k % 2 == 0 else 0 for k, f in enumerate(factorials)], small)
        odd = self.compose([f * sign ** (k // 2) if k % 2 else 0 for k, f in enumerate(factorials)], small)
        cosine = self.add(self.scale(even, c), self.scale(odd, sign * s))
        sine = self.add(self.scale(even, s), self.scale(odd, c))
        return cosine, sine

    def _factorials(self, count: int) -> list[Any]:
        return [self.arithmetic.number(1, factorial(k)) for k in range(count)]

    def _reciprocal(self, a: Jet) -> Any:
        return self.arithmetic.inverse(constant_term(a))

    def _accumulate(self, total: Level, x: Level, y: Level) -> None:
        self.work += len(x) * len(y) * self._weight
        if self.work > self.limit:
            raise WorkLimitError
        known = total.get
        for key, c in x.items():
            for other, e in y.items():
                product = key + other
                total[product] = known(product, 0) + c * e

    def _sum(self, x: Level, y: Level, sign: int) -> Level:
        if not y:
            return x
        total = dict(x)
        for key, c in y.items():
            total[key] = total.get(key, 0) + sign * c
        return self._reduced(total)

    def _reduced(self, total: Level) -> Level:
        if not total:
            return total
        if self._modulus:
            p = self._modulus
            return {key: r for key, c in total.items() if (r := c % p)}
        return {key: c for key, c in total.items() if not self.arithmetic.vanishes(c)}


def constant_term(a: Jet) -> Any:
    """The value at the point."""
    return a[0].get(0, 0)


def nilpotent(a: Jet) -> Jet:
    """The jet without its constant term."""
    return ({}, *a[1:])


def is_zero_jet(a: Jet) -> bool:
    """Whether all coefficients vanish."""
    return not any(a)


def truncated(a: Jet, order: int) -> Jet:
    """The jet cut off at a lower order."""
    return a[: order + 1]


def terms_in(a: Jet) -> int:
    """How many coefficients are not zero."""
    return sum(len(level) for level in a)


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
        ring: JetRing,
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
            case sp.tan() | sp.cot() | sp.sec() | sp.csc() | sp.tanh():
                return self(in_sine_and_cosine(e))
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
        # Both come from one addition theorem, and where one occurs the other usually does.
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


def _multi_indices(count: int, total: int) -> Iterator[tuple[int, ...]]:
    """All tuples of `count` natural numbers with a sum up to `total`."""
    if count == 0:
        yield ()
        return
    for first in range(total + 1):
        for rest in _multi_indices(count - 1, total - first):
            yield first, *rest
