"""Polynomials with packed monomials: content, factors, the effort of writing them.

Factors are worth having only if they take fewer operations than the sum: (l + x)² does, (l - y) (l + y) does
not, being l² - y². Monomials are packed (`packing.py`).
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import combinations
from math import gcd, isqrt, lcm
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from lagrange.algebra.fourier.packing import pack, unpack

Polynomial = dict[int, Fraction]  # (packed) monomial -> coefficient
Factorization = list[tuple[Polynomial, int]]  # factors and their exponents


def common_number(numbers: Iterable[Fraction]) -> Fraction:
    """The largest rational number of which all are whole multiples."""
    listed = list(numbers)
    return Fraction(gcd(*(n.numerator for n in listed)), lcm(*(n.denominator for n in listed)))


def negated(polynomial: Polynomial) -> Polynomial:
    """The polynomial times -1."""
    return {m: -c for m, c in polynomial.items()}


def multiplications(monomial: int) -> int:
    """How many more operations it takes to write a product with this monomial in it."""
    return sum(1 + (e != 1) for _, e in unpack(monomial))


def operations(polynomial: Polynomial) -> int:
    """How many operations it takes to write the sum."""
    products = sum(max(multiplications(m) + (abs(c) != 1) - 1, 0) for m, c in polynomial.items())
    return len(polynomial) - 1 + products


def is_irreducible(polynomial: Polynomial) -> bool:
    """Whether some generator occurs in one term only, and there to the first power: c·v + rest.

    A factor would divide the monomial c and the rest, but nothing divides all terms. False is unsure.
    """
    found: dict[int, list[int]] = {}
    for m in polynomial:
        for i, e in unpack(m):
            found.setdefault(i, []).append(e)
    return any(exponents == [1] for exponents in found.values())


def factorization(polynomial: Polynomial, known: Iterable[Polynomial] = ()) -> tuple[int, Factorization]:
    """Sign and factors of a polynomial without common number or monomial, if factors save operations.

    Known factors are taken out first, as they are; of the rest the whole, the square-free or the irreducible
    factors, whichever are shortest.
    """
    whole = [(polynomial, 1)]
    if is_irreducible(polynomial) or any(e < 0 for m in polynomial for _, e in unpack(m)):
        return 1, whole
    variables = _Variables(polynomial)
    rest, found = variables.outside(polynomial), []
    for base in known:
        divisor, exponent = variables.outside(base), 0
        while divisor and not (division := rest.div(divisor))[1]:
            rest, exponent = division[0], exponent + 1
        if exponent:
            found.append((base, exponent))
    candidates = [(1, whole), *((sign, [*found, *factors]) for sign, factors in variables.factored(rest))]
    return min(candidates, key=lambda c: _effort(c[1]))


def _effort(factors: Factorization) -> int:
    return sum(operations(f) + (e > 1) for f, e in factors) + len(factors) - 1


def irreducible_factors(polynomial: Any) -> tuple[int, list[tuple[Any, int]]]:
    """Number and irreducible factors, with exponents, of one of SymPy's sparse polynomials with whole coefficients.

    Masses, spring constants and weights occur to the first power. In such a variable p = a x + b is g times a factor
    that cannot be divided, g = gcd(a, b): only g, which knows nothing of x, is left to be factored.
    """
    linear = _linear_variable(polynomial)
    if linear is None:
        number, factors = polynomial.factor_list()
        return int(number), [(f, int(e)) for f, e in factors]
    a, b = linear
    shared = a.gcd(b)
    number, factors = irreducible_factors(shared) if not shared.is_ground else (int(shared.LC), [])
    rest = polynomial.exquo(shared)
    if rest.LC < 0:
        number, rest = -number, -rest
    return number, [(rest, 1), *factors]


def _linear_variable(polynomial: Any) -> tuple[Any, Any] | None:
    """a and b of p = a x + b, with x the variable that occurs in the fewest terms, and only to the first power."""
    degrees = polynomial.degrees()
    counts = [sum(map(bool, powers)) for powers in zip(*polynomial.keys(), strict=True)]
    linear = [(n, k) for k, (degree, n) in enumerate(zip(degrees, counts, strict=True)) if degree == 1]
    if not linear:
        return None
    _, k = min(linear)
    ring = polynomial.ring
    a = ring.from_dict({(*m[:k], 0, *m[k + 1 :]): c for m, c in polynomial.items() if m[k]})
    b = ring.from_dict({m: c for m, c in polynomial.items() if not m[k]})
    return a, b


def square_of_two(polynomial: Polynomial) -> Polynomial | None:
    """The sum of two of which three terms are the square: x_1 − x_2 for x_1² − 2 x_1 x_2 + x_2²."""
    roots = [(m, root) for m, c in polynomial.items() if (root := _root(m, c)) is not None]
    for (u, a), (v, b) in combinations(roots, 2):
        number = polynomial.get((u + v) // 2, Fraction(0))
        if abs(number) == 2 * a * b:
            return {u // 2: a, v // 2: b if number > 0 else -b}
    return None


def _root(monomial: int, number: Fraction) -> Fraction | None:
    """The number in the square root of a term, if it has a root without negative powers."""
    above, below = (isqrt(abs(n)) for n in (number.numerator, number.denominator))
    square = Fraction(above, below) ** 2 == number and all(e > 0 and e % 2 == 0 for _, e in unpack(monomial))
    return Fraction(above, below) if square else None


class _Variables:
    """The generators of a polynomial as variables of SymPy's sparse polynomials."""

    def __init__(self, polynomial: Polynomial) -> None:
        self._places = sorted({i for m in polynomial for i, _ in unpack(m)})
        self._ring = PolyRing([f"x{i}" for i in self._places], sp.ZZ)

    def outside(self, polynomial: Polynomial) -> Any:
        """The polynomial in SymPy's form; zero if it has other generators."""
        terms = {}
        for m, c in polynomial.items():
            powers = dict(unpack(m))
            terms[tuple(powers.pop(i, 0) for i in self._places)] = sp.ZZ(c.numerator)
            if powers or c.denominator != 1:
                return self._ring.zero
        return self._ring.from_dict(terms)

    def factored(self, polynomial: Any) -> Iterable[tuple[int, Factorization]]:
        """Sign and factors: the whole, its square-free and its irreducible factors."""
        if polynomial.is_ground:
            return [(int(polynomial.LC), [])]
        number, factors = irreducible_factors(polynomial)
        squarefree: dict[int, Any] = {}
        for f, e in factors:
            squarefree[e] = squarefree.get(e, 1) * f
        found = [(1, [(self._inside(polynomial), 1)])]
        for several in ([(f, e) for e, f in squarefree.items()], factors):
            found.append((number, [(self._inside(f), e) for f, e in several]))
        return found

    def _inside(self, polynomial: Any) -> Polynomial:
        places = self._places
        return {pack(zip(places, powers, strict=True)): Fraction(int(c)) for powers, c in polynomial.terms()}
