"""Multiple and common roots of polynomials whose coefficients are related: w² − 2√14 w + 14 = (w − √14)².

A factorization over the rational functions of the parameters takes √14, sin α and their like for letters without
relations, and misses a factor that exists by p² = 14 only. Euclid's algorithm with the exact zero test finds it: the
greatest common divisor of f and f' has the roots of f that are multiple, that of f and g those they share. Degrees and
sizes are bounded, and where a coefficient is undecided, the factors stay as they are.

Reference: D. Y. Y. Yun, On square-free decomposition algorithms, 1976.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.limits import HIGHEST_DEGREE, LARGEST_FACTORED
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.operations import count_operations

Coefficients = list[sp.Expr]


def with_repeated_roots_apart(pieces: Sequence[tuple[sp.Expr, int]], letter: sp.Symbol) -> list[tuple[sp.Expr, int]]:
    """Factors with multiplicities as factors without multiple roots, no two of which have a root in common."""
    try:
        separated = [part for f, n in pieces for part in _square_free(_coefficients(f, letter), n)]
        separated = _without_common_roots(separated)
    except (InadmissibleError, DivisionByZeroError):
        return [*pieces]
    if sorted((len(f) - 1, n) for f, n in separated) == sorted((int(sp.degree(f, letter)), n) for f, n in pieces):
        return [*pieces]
    return [(_written(f, letter), n) for f, n in separated]


def reduced_by_zero_test(x: sp.Expr) -> sp.Expr:
    """An expression over one denominator; 0 if it is zero. Raises InadmissibleError where that is undecided."""
    if x == 0 or x.is_Rational:
        return x
    vanishes = is_zero(x)
    if vanishes is None:
        raise InadmissibleError
    return sp.S.Zero if vanishes else _shortened(x)


def _shortened(x: sp.Expr) -> sp.Expr:
    above, below = sp.fraction(sp.together(x))
    if count_operations(above) + count_operations(below) > LARGEST_FACTORED:
        raise InadmissibleError
    shortened: sp.Expr = sp.cancel(sp.expand(above) / sp.expand(below))
    return sp.radsimp(shortened) if not shortened.free_symbols else shortened


def _coefficients(f: sp.Expr, letter: sp.Symbol) -> Coefficients:
    """The coefficients, that of the highest power first. Raises InadmissibleError beyond the highest degree."""
    coefficients: Coefficients = sp.Poly(f, letter).all_coeffs()
    if len(coefficients) > HIGHEST_DEGREE + 1:
        raise InadmissibleError
    return coefficients


def _written(f: Coefficients, letter: sp.Symbol) -> sp.Expr:
    """The polynomial without denominators."""
    terms = (c * letter**n for n, c in enumerate(reversed(f)))
    return sp.expand(sp.fraction(sp.together(sp.Add(*terms)))[0])


def _square_free(f: Coefficients, n: int) -> list[tuple[Coefficients, int]]:
    """The factors of fⁿ without multiple roots: those that f has once, twice, ..."""
    if len(f) < 3:
        return [(f, n)]
    top = len(f) - 1
    repeated = _common_divisor(f, [c * (top - k) for k, c in enumerate(f[:-1])])
    once = _divided(f, repeated)[0]
    parts = []
    times = 1
    while len(once) > 1:
        more = _common_divisor(once, repeated)
        part = _divided(once, more)[0]
        if len(part) > 1:
            parts.append((part, n * times))
        once, repeated, times = more, _divided(repeated, more)[0], times + 1
    return parts


def _without_common_roots(pieces: list[tuple[Coefficients, int]]) -> list[tuple[Coefficients, int]]:
    """The factors with their common divisors as factors of their own, whose multiplicities add up."""
    for (k, (f, m)), (j, (g, n)) in combinations(enumerate(pieces), 2):
        common = _common_divisor(f, g)
        if len(common) > 1:
            others = [p for i, p in enumerate(pieces) if i not in (k, j)]
            rest = [(_divided(f, common)[0], m), (_divided(g, common)[0], n), (common, m + n)]
            return _without_common_roots([*others, *(p for p in rest if len(p[0]) > 1)])
    return pieces


def _common_divisor(f: Coefficients, g: Coefficients) -> Coefficients:
    """The greatest common divisor, with leading coefficient 1; [1] for polynomials without a common root."""
    while g:
        f, g = g, _divided(f, g)[1]
    return [reduced_by_zero_test(c / f[0]) for c in f]


def _divided(f: Coefficients, g: Coefficients) -> tuple[Coefficients, Coefficients]:
    """Quotient and remainder; the remainder without leading zeros."""
    rest = [*f]
    quotient = []
    while len(rest) >= len(g):
        factor = reduced_by_zero_test(rest[0] / g[0])
        quotient.append(factor)
        padded = [*g, *[sp.S.Zero] * (len(rest) - len(g))]
        rest = [reduced_by_zero_test(a - factor * b) for a, b in zip(rest[1:], padded[1:], strict=True)]
    while rest and rest[0] == 0:
        rest = rest[1:]
    return quotient, rest
