"""Fourier sums: monomial · (A cos w·x + B sin w·x), added, multiplied and reduced exactly.

An element is a dictionary (monomial, frequency) -> (A, B) of whole numbers over one common denominator;
monomials are products of generators (`generators.py`), frequencies w are coefficients of angles, both
packed (`packing.py`), and of w and -w the positive one is kept. Products are taken by

    2 cos a cos b = cos(a - b) + cos(a + b),  and so on,

so that sin²θ + cos²θ is 1 without further ado, and an element without denominators is zero only if it is
empty.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import gcd
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.fourier.packing import LARGEST, lowest, pack, unpack

if TYPE_CHECKING:
    from lagrange.algebra.fourier.generators import Basis

Key = tuple[int, int]
Terms = dict[Key, tuple[int, int]]
Number = int | Fraction


class Element:
    """A finite sum of monomial · (A cos w·x + B sin w·x). Immutable."""

    __slots__ = ("basis", "denominator", "terms")

    def __init__(self, basis: Basis, terms: Terms, denominator: int = 1) -> None:
        self.basis = basis
        self.terms = terms
        self.denominator = denominator

    def __bool__(self) -> bool:
        return bool(self.terms)

    def __len__(self) -> int:
        return len(self.terms)

    @property
    def key(self) -> object:
        """Equal for equal elements of one basis."""
        return self.denominator, frozenset(self.terms.items())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Element):
            return NotImplemented
        return self.basis is other.basis and self.denominator == other.denominator and self.terms == other.terms

    def __hash__(self) -> int:
        return hash(self.key)

    def __repr__(self) -> str:
        return f"Element({self.to_sympy()})"

    @property
    def is_monomial(self) -> bool:
        """Whether this is one number times one monomial: then it can be inverted."""
        return len(self.terms) == 1 and all(not frequency for _, frequency in self.terms)

    @property
    def is_number(self) -> bool:
        """Whether this is a rational constant."""
        return all(key == (0, 0) for key in self.terms)

    def items(self) -> Iterator[tuple[int, int, Fraction, Fraction]]:
        """Monomial, frequency, A and B of each term."""
        for (monomial, frequency), (a, b) in self.terms.items():
            yield monomial, frequency, Fraction(a, self.denominator), Fraction(b, self.denominator)

    def scaled_terms(self, denominator: int) -> Terms:
        """The terms over a multiple of the denominator."""
        factor = denominator // self.denominator
        if factor == 1:
            return self.terms
        return {key: (a * factor, b * factor) for key, (a, b) in self.terms.items()}

    def __add__(self, other: Element | Number) -> Element:
        return self.basis.total((self, self._element(other)))

    __radd__ = __add__

    def __neg__(self) -> Element:
        return Element(self.basis, {key: (-a, -b) for key, (a, b) in self.terms.items()}, self.denominator)

    def __sub__(self, other: Element | Number) -> Element:
        return self + (-self._element(other))

    def __rsub__(self, other: Element | Number) -> Element:
        return self._element(other) - self

    def __mul__(self, other: Element | Number) -> Element:
        if isinstance(other, int | Fraction):
            return self._scaled(Fraction(other))
        if self.is_monomial:
            return other._times_monomial(self)
        if other.is_monomial:
            return self._times_monomial(other)
        return self.basis.element(_product(self.terms, other.terms), 2 * self.denominator * other.denominator)

    __rmul__ = __mul__

    def __truediv__(self, other: Element | Number) -> Element:
        if isinstance(other, int | Fraction):
            return self._scaled(1 / Fraction(other))
        return self * other**-1

    def __pow__(self, exponent: int) -> Element:
        """A whole power. A negative one of a sum introduces a generator for the denominator."""
        if self.is_monomial:
            return self._monomial_power(exponent)
        if exponent < 0:
            return self.basis.inverse(self) ** -exponent
        result, square = self.basis.one, self
        while exponent:
            if exponent & 1:
                result = result * square
            exponent >>= 1
            if exponent:
                square = square * square
        return result

    def _element(self, value: Element | Number) -> Element:
        return value if isinstance(value, Element) else self.basis.number(value)

    def _scaled(self, factor: Fraction) -> Element:
        p = factor.numerator
        terms = {key: (a * p, b * p) for key, (a, b) in self.terms.items()}
        return self.basis.element(terms, self.denominator * factor.denominator)

    def _times_monomial(self, other: Element) -> Element:
        ((shift, _), (factor, _)) = next(iter(other.terms.items()))
        terms = {(m + shift, w): (a * factor, b * factor) for (m, w), (a, b) in self.terms.items()}
        return self.basis.element(terms, self.denominator * other.denominator)

    def _monomial_power(self, exponent: int) -> Element:
        ((monomial, _), (a, _)) = next(iter(self.terms.items()))
        if any(abs(e * exponent) > LARGEST for _, e in unpack(monomial)):
            raise OverflowError("an exponent is too large")
        number = Fraction(a, self.denominator) ** exponent
        terms = {(monomial * exponent, 0): (number.numerator, 0)}
        return self.basis.element(terms, number.denominator)

    def content(self) -> tuple[Fraction, int]:
        """The largest number and the largest monomial that divide every term.

        A monomial with negative exponents counts too: the content of a/r + b is 1/r.
        """
        number = Fraction(gcd(*(c for pair in self.terms.values() for c in pair)), self.denominator)
        return number, lowest(m for m, _ in self.terms)

    def over_monomial(self, monomial: int) -> Element:
        """This element divided by a (packed) monomial."""
        terms = {(m - monomial, w): value for (m, w), value in self.terms.items()}
        return self.basis.element(terms, self.denominator)

    def by_exponents(self, places: Iterable[int]) -> dict[int, Element]:
        """The element split by its powers of some generators: packed power -> coefficient."""
        chosen = places if isinstance(places, set) else frozenset(places)
        split: dict[int, Terms] = {}
        for (monomial, frequency), value in self.terms.items():
            part = pack((i, e) for i, e in unpack(monomial) if i in chosen)
            split.setdefault(part, {})[monomial - part, frequency] = value
        return {part: self.basis.element(terms, self.denominator) for part, terms in split.items()}

    def by_monomial(self) -> dict[int, Element]:
        """The element split into one for each monomial, which is left in it."""
        split: dict[int, Terms] = {}
        for (monomial, frequency), value in self.terms.items():
            split.setdefault(monomial, {})[monomial, frequency] = value
        return {m: self.basis.element(terms, self.denominator) for m, terms in split.items()}

    def to_sympy(self) -> sp.Expr:
        """The sum as SymPy writes it, term by term, without any arrangement."""
        basis = self.basis
        summands = []
        for monomial, frequency, a, b in self.items():
            factors = [basis.generators[i].expression ** e for i, e in unpack(monomial)]
            angle = basis.angle_expression(frequency)
            for number, function in ((a, sp.cos), (b, sp.sin)):
                if number:
                    summands.append(sp.Mul(sp.Rational(number), *factors, function(angle)))
        return sp.Add(*summands)


def _product(left: Terms, right: Terms) -> Terms:
    """Twice the product, by product-to-sum."""
    result: Terms = {}
    for (m1, w1), (a1, b1) in left.items():
        for (m2, w2), (a2, b2) in right.items():
            m = m1 + m2
            cc, ss, cs, sc = a1 * a2, b1 * b2, a1 * b2, b1 * a2
            contributions: tuple[tuple[Key, int, int], ...]
            if not w1 or not w2:
                contributions = (((m, w1 + w2), 2 * cc, 2 * (cs + sc)),)
            else:
                w, sine = (w1 - w2, sc - cs) if w1 > w2 else (w2 - w1, cs - sc)
                contributions = (((m, w1 + w2), cc - ss, cs + sc), ((m, w), cc + ss, sine if w else 0))
            for key, a, b in contributions:
                old = result.get(key)
                result[key] = (a, b) if old is None else (old[0] + a, old[1] + b)
    return result
