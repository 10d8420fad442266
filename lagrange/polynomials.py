"""Polynomials with packed monomials: content, factors, the effort of writing them.

Factors are worth having only if they take fewer operations than the sum: (l + x)² does, (l - y) (l + y) does
not, being l² - y². Monomials are packed (`packing.py`).
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import gcd, lcm
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyRing

from lagrange.packing import pack, unpack

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
        found = [(1, [(self._inside(polynomial), 1)])]
        for number, factors in (polynomial.sqf_list(), polynomial.factor_list()):
            found.append((int(number), [(self._inside(f), int(e)) for f, e in factors]))
        return found

    def _inside(self, polynomial: Any) -> Polynomial:
        places = self._places
        return {pack(zip(places, powers, strict=True)): Fraction(int(c)) for powers, c in polynomial.terms()}
