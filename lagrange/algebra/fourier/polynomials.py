"""Polynomials with packed monomials: content, factors, and how many operations it takes to write them.

A monomial, or a frequency, is one whole number: the value at place i is counted in units of 2^(32 i), so that
multiplying monomials and adding frequencies is adding whole numbers, and the sign of a frequency is the sign of its
last place. Values may be negative. A polynomial is a dictionary from packed monomials to rational coefficients.

Factors are worth having only if they take fewer operations than the sum: (l + x)² does, (l − y) (l + y) does not, being
l² − y². Reference: Monagan and Pearce, *Polynomial division using dynamic arrays, heaps, and packed exponent vectors*
(2007).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import lru_cache
from itertools import combinations
from math import gcd, isqrt, lcm
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

WIDTH = 32
# Larger values are not packed, so that sums of thousands of them stay within their 32 bits.
LARGEST = 1 << 16
_MASK = (1 << WIDTH) - 1
_HALF = 1 << (WIDTH - 1)


@lru_cache(maxsize=1 << 16)
def unpack(packed: int) -> tuple[tuple[int, int], ...]:
    """The places that are not zero: (index, value), in the order of the index."""
    places = []
    index = 0
    while packed:
        skip = ((packed & -packed).bit_length() - 1) // WIDTH
        packed >>= skip * WIDTH
        index += skip
        value = packed & _MASK
        # A negative value borrows from the place above it: given back by the subtraction below.
        if value >= _HALF:
            value -= 1 << WIDTH
        places.append((index, value))
        packed = (packed - value) >> WIDTH
        index += 1
    return tuple(places)


def pack(places: Iterable[tuple[int, int]]) -> int:
    """The whole number with these values at these places."""
    return sum(value << (WIDTH * index) for index, value in places)


def value_at_place(packed: int, index: int) -> int:
    """The value at one place."""
    return next((value for i, value in unpack(packed) if i == index), 0)


def part_at(places: Iterable[int], width: int) -> Callable[[int], int]:
    """What takes the values at these places, still packed, out of whole numbers of no more than `width` places."""
    # A half is added at every place, so that none borrows from the next, and taken off again.
    halves = _HALF * (((1 << (WIDTH * width)) - 1) // _MASK)
    mask = sum(_MASK << (WIDTH * index) for index in places)
    below = halves & mask
    return lambda packed: ((packed + halves) & mask) - below


def lowest(monomials: Iterable[int]) -> int:
    """The largest monomial whose removal leaves no negative exponents: 1/r of a/r + b, r of a r + b r²."""
    least: dict[int, int] | None = None
    for monomial in monomials:
        powers = dict(unpack(monomial))
        if least is None:
            least = powers
        else:
            minima = {i: min(powers.get(i, 0), least.get(i, 0)) for i in powers.keys() | least.keys()}
            least = {i: e for i, e in minima.items() if e}
    return pack(least.items()) if least else 0


def common(monomials: Iterable[int]) -> int:
    """The monomial in front of a bracket: 1/r of a/r + b/r², but 1 of a/r + b."""
    powers = [dict(unpack(m)) for m in monomials]
    exponents_of = {}
    for i in powers[0]:
        exponents = [p.get(i, 0) for p in powers]
        if exponents[0] > 0:
            exponents_of[i] = max(min(exponents), 0)
        else:
            exponents_of[i] = min(max(exponents), 0)
    return pack(exponents_of.items())


def shared(a: int, b: int) -> int:
    """The greatest common divisor of two monomials, without negative powers."""
    return pack((i, e) for i, e in unpack(common((a, b))) if e > 0)


def divides(factor: int, monomial: int) -> bool:
    """Whether a monomial with positive exponents divides another."""
    powers = dict(unpack(monomial))
    return all(powers.get(i, 0) >= e for i, e in unpack(factor))


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
    exponents_of: dict[int, list[int]] = {}
    for m in polynomial:
        for i, e in unpack(m):
            exponents_of.setdefault(i, []).append(e)
    return any(exponents == [1] for exponents in exponents_of.values())


def factorization(polynomial: Polynomial, known: Iterable[Polynomial] = ()) -> tuple[int, Factorization]:
    """Sign and factors of a polynomial without common number or monomial, if factors save operations.

    Known factors are taken out first, as they are; of the rest the whole, the square-free or the irreducible
    factors, whichever are shortest. A known factor with negative exponents, 1 + x²/y², divides no polynomial as it is.
    """
    unfactored = [(polynomial, 1)]
    if is_irreducible(polynomial) or not _is_polynomial(polynomial):
        return 1, unfactored
    variables = _PolynomialVariables(polynomial)
    rest, known_factors = variables.outside(polynomial), []
    for base in filter(_is_polynomial, known):
        divisor, exponent = variables.outside(base), 0
        # Only division by a polynomial that is no number lowers the degree, and so comes to an end.
        while not divisor.is_ground and not (division := rest.div(divisor))[1]:
            rest, exponent = division[0], exponent + 1
        if exponent:
            known_factors.append((base, exponent))
    candidates = [(1, unfactored), *((sign, [*known_factors, *factors]) for sign, factors in variables.factored(rest))]
    return min(candidates, key=lambda c: _effort(c[1]))


def _is_polynomial(sum_of_monomials: Polynomial) -> bool:
    """Whether no exponent is negative."""
    return all(e >= 0 for m in sum_of_monomials for _, e in unpack(m))


def _effort(factors: Factorization) -> int:
    return sum(operations(f) + (e > 1) for f, e in factors) + len(factors) - 1


def irreducible_factors(polynomial: Any) -> tuple[int, list[tuple[Any, int]]]:
    """Number and irreducible factors, with exponents, of one of SymPy's sparse polynomials with whole coefficients.

    Masses, spring constants and weights occur to the first power. In such a variable p = a x + b is g times an
    irreducible factor, g = gcd(a, b): only g, which does not contain x, remains to be factored.
    """
    # A greatest common divisor instead of a multivariate factorization, whose time grows exponentially.
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


@lru_cache(maxsize=64)
def polynomials_in(number: int, coefficients: Any) -> PolyRing:
    """SymPy's ring of polynomials in so many variables, for each of which it compiles seven functions."""
    return PolyRing([f"x{i}" for i in range(number)], coefficients)


class _PolynomialVariables:
    """The generators of a polynomial as variables of SymPy's sparse polynomials."""

    def __init__(self, polynomial: Polynomial) -> None:
        self._places = sorted({i for m in polynomial for i, _ in unpack(m)})
        self._ring = polynomials_in(len(self._places), sp.ZZ)

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
        factorizations = [(1, [(self._inside(polynomial), 1)])]
        for several in ([(f, e) for e, f in squarefree.items()], factors):
            factorizations.append((number, [(self._inside(f), e) for f, e in several]))
        return factorizations

    def _inside(self, polynomial: Any) -> Polynomial:
        places = self._places
        return {pack(zip(places, powers, strict=True)): Fraction(int(c)) for powers, c in polynomial.terms()}
