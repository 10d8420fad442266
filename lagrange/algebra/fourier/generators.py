"""What Fourier sums are made of: generators and angles, numbered as they turn up in one computation.

A generator is a symbol, a function that is left alone (exp x, F_x(x, y)), or something that obeys

    g^n = base,     base an element:

a sign σ² = 1, a root g² = l² - y², cosh² x = 1 + sinh² x, and, for denominators, 1/(l² - y²) = g^-2.
Positive powers are reduced to exponents below n; negative ones too, if the base can be inverted.
Frequencies are counted in units of 1/5040 of an angle, so that θ/2 and θ/3 are whole numbers.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import gcd, lcm

import sympy as sp

from lagrange.algebra.fourier.fourier import Element, Number, Terms
from lagrange.algebra.fourier.packing import WIDTH, unpack
from lagrange.core.records import record

UNIT = 5040


@record
class Generator:
    """What monomials are made of: a symbol, a function that is left alone, or a root of an element.

    With a base it obeys generator ** order = base; `radical` says that it is printed as base ** (1/order).
    """

    expression: sp.Expr
    base: Element | None = None
    order: int = 1
    radical: bool = False


class Basis:
    """The generators and angles that occur in one computation, numbered as they turn up."""

    def __init__(self) -> None:
        self.generators: list[Generator] = []
        self.angles: list[sp.Expr] = []
        self.steps: list[int] = []  # the least frequency of each angle: UNIT, or UNIT/2 where θ/2 occurs
        self.related: list[int] = []  # generators that obey a relation
        self._places: dict[sp.Expr, int] = {}
        self._angle_places: dict[sp.Expr, int] = {}
        self._roots: dict[tuple[object, int], int] = {}
        self._powers: dict[tuple[int, int], Element] = {}

    @property
    def zero(self) -> Element:
        """The element 0."""
        return Element(self, {})

    @property
    def one(self) -> Element:
        """The element 1."""
        return Element(self, {(0, 0): (1, 0)})

    def number(self, value: Number) -> Element:
        """A rational constant."""
        value = Fraction(value)
        return self.element({(0, 0): (value.numerator, 0)}, value.denominator)

    def place_of(self, expression: sp.Expr) -> int:
        """The number of a generator without a relation, which is made if it is new."""
        index = self._places.get(expression)
        if index is None:
            index = self._places[expression] = len(self.generators)
            self.generators.append(Generator(expression))
        return index

    def find(self, expression: sp.Expr) -> int | None:
        """The number of a generator, if it occurs."""
        return self._places.get(expression)

    def related_place(self, expression: sp.Expr, order: int, base: Element, radical: bool = False) -> int:
        """The number of a generator with expression ** order = base."""
        index = self._places.get(expression)
        if index is None:
            index = self._places[expression] = len(self.generators)
            self.generators.append(Generator(expression, base, order, radical))
            self.related.append(index)
        return index

    def root_place(self, base: Element, order: int) -> int:
        """The number of the generator base ** (1/order)."""
        name = (base.key, order)
        index = self._roots.get(name)
        if index is None:
            expression = sp.Pow(base.to_sympy(), sp.Rational(1, order))
            index = self._roots[name] = self.related_place(expression, order, base, radical=True)
        return index

    def angle_place(self, angle: sp.Expr, denominator: int = 1) -> int:
        """The number of an angle, of which whole multiples of angle/denominator occur."""
        index = self._angle_places.get(angle)
        if index is None:
            index = self._angle_places[angle] = len(self.angles)
            self.angles.append(angle)
            self.steps.append(UNIT)
        self.steps[index] = gcd(self.steps[index], UNIT // denominator)
        return index

    def half(self, frequency: int, fine: bool = False) -> int | None:
        """Half of a frequency, if that is whole; `fine`: if it is a multiple of what occurs, such as θ/2."""
        steps = self.steps if fine else [UNIT] * len(self.steps)
        if all(value % (2 * steps[index]) == 0 for index, value in unpack(frequency)):
            return frequency // 2
        return None

    def is_whole(self, frequency: int) -> bool:
        """Whether it is a sum of whole multiples of angles."""
        return all(value % UNIT == 0 for _, value in unpack(frequency))

    def power_of(self, index: int, exponent: int = 1) -> Element:
        """A power of a generator, as an element."""
        return self.element({(exponent << (WIDTH * index), 0): (1, 0)})

    def circle(self, frequency: int, sine: bool = False) -> Element:
        """cos or sin of a frequency of either sign."""
        if not sine:
            return self.element({(0, abs(frequency)): (1, 0)})
        if not frequency:
            return self.zero
        return self.element({(0, abs(frequency)): (0, 1 if frequency > 0 else -1)})

    def angle_expression(self, frequency: int) -> sp.Expr:
        """The angle w·x as SymPy writes it."""
        return sp.Add(*(self.angles[i] * sp.Rational(f, UNIT) for i, f in unpack(frequency)))

    def element(self, terms: Terms, denominator: int = 1) -> Element:
        """The element with these terms, in its reduced form."""
        if self.related and any(self._excess(monomial) for monomial, _ in terms):
            return self._reduced(terms, denominator)
        terms = {key: value for key, value in terms.items() if value[0] or value[1]}
        if denominator != 1:
            common = gcd(denominator, *(c for pair in terms.values() for c in pair))
            if common != 1:
                terms = {key: (a // common, b // common) for key, (a, b) in terms.items()}
                denominator //= common
        return Element(self, terms, denominator)

    def inverse(self, element: Element) -> Element:
        """1/element of a sum: number and monomial are inverted, the rest becomes a generator g^-2."""
        if not element:
            raise ZeroDivisionError("division by zero in the ring")
        number, monomial = element.content()
        rest = element.over_monomial(monomial) / number
        if ((-rest).key, 2) in self._roots:
            number, rest = -number, -rest
        front = Element(self, {(monomial, 0): (1, 0)}) * number
        return front**-1 * self.power_of(self.root_place(rest, 2), -2)

    def total(self, elements: Iterable[Element]) -> Element:
        """The sum of many elements."""
        summands = [e for e in elements if e.terms]
        if len(summands) < 2:
            return summands[0] if summands else self.zero
        denominator = lcm(*(e.denominator for e in summands))
        terms: Terms = dict(summands[0].scaled_terms(denominator))
        for summand in summands[1:]:
            for key, (a, b) in summand.scaled_terms(denominator).items():
                old = terms.get(key)
                terms[key] = (a, b) if old is None else (old[0] + a, old[1] + b)
        return self.element(terms, denominator)

    def _excess(self, monomial: int) -> tuple[int, int] | None:
        """A generator whose relation applies to the monomial, and how often."""
        for index, exponent in unpack(monomial):
            generator = self.generators[index]
            if generator.base is None:
                continue
            times = exponent // generator.order
            if times > 0 or (times < 0 and generator.base.is_monomial):
                return index, times
        return None

    def _reduced(self, terms: Terms, denominator: int) -> Element:
        """The relations g ** order = base applied as long as there is one that applies."""
        settled: Terms = {}
        pending: dict[tuple[int, int], Terms] = {}
        for (monomial, frequency), value in terms.items():
            excess = self._excess(monomial)
            if excess is None:
                settled[monomial, frequency] = value
                continue
            index, times = excess
            lower = monomial - ((times * self.generators[index].order) << (WIDTH * index))
            pending.setdefault(excess, {})[lower, frequency] = value
        summands = [self.element(settled, denominator)]
        for (index, times), part in pending.items():
            summands.append(self.element(part, denominator) * self._base_power(index, times))
        return self.total(summands)

    def _base_power(self, index: int, times: int) -> Element:
        power = self._powers.get((index, times))
        if power is None:
            base = self.generators[index].base
            assert base is not None
            power = self._powers[index, times] = base**times
        return power
