"""Truncated Taylor series in several variables: jets.

A jet of order d is f(a + h) = Σ f_α h^α, |α| ≤ d, at one point a, with coefficients in a prime field (or
reals of eighty digits, where a point has no residues). Sums and products are those of polynomials cut off
at degree d; a derivative loses one order. A function of a jet g = g_0 + ν, whose constant term g_0 is a
number and whose ν is nilpotent, is a polynomial in ν:

    g^e = g_0^e Σ binom(e, k) (ν/g_0)^k,   exp g = e^{g_0} Σ ν^k/k!,   cos g = cos g_0 cos ν - sin g_0 sin ν,
    log g = log g_0 + Σ (-1)^{k+1} (ν/g_0)^k/k,
    atan2(y, x) = atan2(y_0, x_0) + atan((x_0 y - y_0 x)/(x_0 x + y_0 y)),

so that a root, an angle or a logarithm at the point comes from whoever evaluates expressions there, and all
that follows is arithmetic.

A jet is stored by degree, as dictionaries from monomials to coefficients; four bits of a monomial's key are
the exponent of one variable, so that the product of monomials is the sum of their keys.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import factorial
from typing import Any

from lagrange.algebra.exact.linear_algebra import Arithmetic
from lagrange.algebra.exact.prime_field import PrimeField

Level = dict[int, Any]
Jet = tuple[Level, ...]

BITS = 4
HIGHEST_ORDER = (1 << BITS) - 1
REAL_WEIGHT = 8  # what the product of two reals of eighty digits costs, in products of residues


class WorkLimitError(Exception):
    """The limit on arithmetic operations is reached."""


class Ring:
    """Jets over some arithmetic, in any number of variables, of any order up to 15, with a limit on the work.

    `work` counts products of coefficients and of jets; `WorkLimitError` is raised when it passes `limit`. A
    division by zero raises what the arithmetic raises.
    """

    def __init__(self, arithmetic: Arithmetic, limit: int = 1 << 62) -> None:
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
