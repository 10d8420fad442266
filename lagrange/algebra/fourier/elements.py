"""Fourier sums: monomial · (A cos w·x + B sin w·x), added, multiplied and reduced exactly.

An element is a dictionary (monomial, frequency) -> (A, B) of whole numbers over one common denominator. Monomials are
products of generators, frequencies w are coefficients of angles, counted in units of 1/5040 so that θ/2 and θ/3 are
whole numbers; both are packed (`polynomials`), and of w and −w the positive one is kept. Products are taken by

    2 cos a cos b = cos(a − b) + cos(a + b),  and so on,

so that sin²θ + cos²θ is 1 at once, and an element without denominators is zero only if it is empty. A generator is a
symbol, a function that is left alone (exp x, F_x(x, y)), or something that obeys g^n = base, the base an element: a
sign σ² = 1, a root g² = l² − y², cosh² x = 1 + sinh² x, and, for denominators, 1/(l² − y²) = g^−2. Positive powers are
reduced to exponents below n; negative ones too, if the base can be inverted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import gcd, lcm

import sympy as sp

from lagrange.algebra.fourier.limits import MANY_TERMS, PRODUCTS_PER_UNIT, TERMS_PER_UNIT
from lagrange.algebra.fourier.polynomials import LARGEST, WIDTH, lowest, part_at, unpack
from lagrange.core.effort import ensure, spend
from lagrange.core.records import record

WaveKey = tuple[int, int]
Terms = dict[WaveKey, tuple[int, int]]
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
        spend(len(self) * len(other) / PRODUCTS_PER_UNIT)
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
        # A packed exponent must not run into its neighbour.
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
        if not chosen and self.terms:
            return {0: self}
        part_of = part_at(chosen, len(self.basis.generators))
        split: dict[int, Terms] = {}
        for (monomial, frequency), value in self.terms.items():
            part = part_of(monomial)
            split.setdefault(part, {})[monomial - part, frequency] = value
        if split.keys() == {0}:
            return {0: self}
        return {part: self.basis.element(terms, self.denominator) for part, terms in split.items()}

    def by_monomial(self) -> dict[int, Element]:
        """The element split into one for each monomial, which it keeps."""
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
        if len(result) > MANY_TERMS:
            ensure(2 * len(result))  # what `element` takes for them: before they fill the memory
        for (m2, w2), (a2, b2) in right.items():
            m = m1 + m2
            cc, ss, cs, sc = a1 * a2, b1 * b2, a1 * b2, b1 * a2
            # cos w1 cos w2 = [cos(w1 + w2) + cos(w1 − w2)]/2, doubled; with w1 = 0 or w2 = 0 both terms are the same.
            contributions: tuple[tuple[WaveKey, int, int], ...]
            if not w1 or not w2:
                contributions = (((m, w1 + w2), 2 * cc, 2 * (cs + sc)),)
            else:
                w, sine = (w1 - w2, sc - cs) if w1 > w2 else (w2 - w1, cs - sc)
                contributions = (((m, w1 + w2), cc - ss, cs + sc), ((m, w), cc + ss, sine if w else 0))
            for key, a, b in contributions:
                old = result.get(key)
                result[key] = (a, b) if old is None else (old[0] + a, old[1] + b)
    return result


# 5040 = 7!: halves, thirds, ... up to tenths of an angle are whole multiples of the unit.
UNIT = 5040


@record
class Generator:
    """A factor of monomials: a symbol, a function that is left alone, or a root of an element.

    With a base it obeys generator ** order = base; with `radical` it is printed as base ** (1/order).
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
    def is_plain(self) -> bool:
        """Whether elements have one form, whatever was read before: no roots, reciprocals or halves of angles."""
        return not self.related and all(step == UNIT for step in self.steps)

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
        # The step is what halving may go down to: θ/2 is a frequency to write only where it occurs.
        self.steps[index] = gcd(self.steps[index], UNIT // denominator)
        return index

    def half(self, frequency: int, fine: bool = False) -> int | None:
        """Half of a frequency, if that is an integer; with `fine`, if it is a multiple of what occurs, such as θ/2."""
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
        spend(len(terms) / TERMS_PER_UNIT if len(terms) < MANY_TERMS else 2 * len(terms))
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
        # Only the primitive part gets a generator, of either sign: 1/(2a − 2b), 1/(a − b) and 1/(b − a) share one, and
        # cancel. Its square root is the generator, because √(a − b) may occur as well.
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
        spend(sum(map(len, summands)) / PRODUCTS_PER_UNIT)
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
            # g^-2 of a sum cannot be reduced: it is the denominator. That of a monomial can, 1/√2 = √2/2.
            times = exponent // generator.order
            if times > 0 or (times < 0 and generator.base.is_monomial):
                return index, times
        return None

    def _reduced(self, terms: Terms, denominator: int) -> Element:
        """The relations g ** order = base applied as long as there is one that applies."""
        # Terms with the same excess are collected first, so that each power of a base is multiplied only once.
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
