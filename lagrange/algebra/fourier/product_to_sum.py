"""From sums of cosines and sines to products of them, the way they are written by hand.

    cos a + cos b = 2 cos (a + b)/2 cos (a − b)/2,      1 − cos 2θ = 2 sin²θ,      sin 2θ = 2 sin θ cos θ,

wherever the halves are whole. A sum is written as the fewest products: it is divided by the sines and cosines that
divide it (`division`); then the best is chosen of the sum as it is, pairs of terms joined, and a polynomial in the
sines and cosines of single angles, as in 2 + 2 cos²θ for 3 + cos 2θ. The choice does not depend on the order in which
symbols turned up.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, product
from math import comb, prod

import sympy as sp

from lagrange.algebra.fourier.division import Complex, highest_multiples, may_divide, over_wave
from lagrange.algebra.fourier.elements import UNIT, Basis, Element
from lagrange.algebra.fourier.limits import (
    HIGHEST_SEPARATED,
    LONGEST_PAIRED,
    LONGEST_SEARCHED,
    MOST_SEPARATED_ANGLES,
    PAIRS_IN_A_UNIT,
    STEPS_OF_A_LETTER,
    TRIED_IN_A_UNIT,
)
from lagrange.algebra.fourier.polynomials import WIDTH, unpack
from lagrange.core.effort import spend, take_steps
from lagrange.core.records import record

WavePart = tuple[int, Fraction, bool]  # frequency, coefficient, whether it is a sine
Powers = tuple[tuple[int, int], ...]  # (exponent of cos, exponent of sin) of each angle


@record
class Atom:
    """cos or sin of one frequency, which is positive."""

    frequency: int
    sine: bool


@record
class TrigProduct:
    """A number times powers of atoms, sorted by the names of their angles."""

    number: Fraction
    powers: tuple[tuple[Atom, int], ...] = ()


class Factoring:
    """The product forms of one ring, remembered."""

    def __init__(self, basis: Basis) -> None:
        self._basis = basis
        self._found: dict[object, tuple[TrigProduct, ...]] = {}
        self._angles: dict[int, tuple[int, sp.Expr]] = {}
        self._names: dict[int, str] = {}
        self._waves: dict[tuple[int, bool], tuple[tuple[Atom, int], ...]] = {}

    def products(self, element: Element) -> tuple[TrigProduct, ...]:
        """The sum of products that equals an element without generators."""
        if len(element) < 2:
            parts = list(_parts(element))
            if len(parts) < 2:
                return tuple(self._single(*part) for part in parts)
        number = element.content()[0]
        primitive = element / number
        products = self._found.get(primitive.key)
        if products is None:
            products = self._found[primitive.key] = self._best(primitive)
        return tuple(TrigProduct(p.number * number, p.powers) for p in products)

    def angle(self, frequency: int) -> tuple[int, sp.Expr]:
        """The sign that SymPy takes out of a sine of the angle, and the angle without it."""
        signed = self._angles.get(frequency)
        if signed is None:
            angle = self._basis.angle_expression(frequency)
            signed = (-1, -angle) if self._is_turned(frequency, angle) else (1, angle)
            self._angles[frequency] = signed
        return signed

    def _is_turned(self, frequency: int, angle: sp.Expr) -> bool:
        """Whether SymPy takes a minus sign out of an angle.

        Out of u − v it does where v comes first in its order, a comparison of the whole that takes ten times as long.
        """
        moving = [(self._basis.angles[i], f) for i, f in unpack(frequency)]
        if len(moving) == 2 and moving[0][1] * moving[1][1] < 0 and all(s.is_Symbol for s, _ in moving):
            (_, first), _ = sorted(moving, key=lambda pair: pair[0].sort_key())
            return first < 0
        return bool(angle.could_extract_minus_sign())

    def _name(self, frequency: int) -> str:
        """The sort key of an angle: the same in every ring."""
        name = self._names.get(frequency)
        if name is None:
            name = self._names[frequency] = str(self.angle(frequency)[1])
            take_steps(STEPS_OF_A_LETTER * len(name))
        return name

    def _key(self, atom: Atom) -> tuple[str, bool]:
        return self._name(atom.frequency), atom.sine

    def _best(self, element: Element) -> tuple[TrigProduct, ...]:
        parts = sorted(_parts(element), key=lambda part: (self._name(part[0]), part[2]))
        plain = tuple(self._single(*part) for part in parts)
        if len(plain) < 2:
            return plain
        # A factor of the whole sum is better than any way to write its terms.
        divided = self._divided(element)
        if divided is not None:
            return divided
        forms = (*self._joined(element, parts), *self._apart(parts), *self._separated(element))
        return min((plain, *map(gathered, forms)), key=self._cost)

    def _single(self, w: int, number: Fraction, sine: bool) -> TrigProduct:
        """One term; sin 2u is 2 sin u cos u."""
        if not w:
            return TrigProduct(number)
        powers = self._waves.get((w, sine))
        if powers is None:
            half = self._basis.half(w) if sine else None
            atoms = (Atom(w, sine),) if half is None else (Atom(half, False), Atom(half, True))
            powers = self._waves[w, sine] = tuple((atom, 1) for atom in atoms)
        return TrigProduct(2 * number if len(powers) > 1 else number, powers)

    def _sorted(self, number: Fraction, powers: dict[Atom, int]) -> TrigProduct:
        return TrigProduct(number, tuple(sorted(powers.items(), key=lambda p: self._key(p[0]))))

    def atoms(self, element: Element) -> tuple[list[Atom], Element]:
        """The sines and cosines that divide an element without making it longer, and the quotient."""
        atoms = []
        while (division := self._division(element)) is not None:
            atom, quotient = division
            atoms.append(atom)
            element = quotient * self._sign(atom)
        return atoms, element

    def _division(self, element: Element) -> tuple[Atom, Element] | None:
        """The first atom that divides an element without making it longer, and the quotient.

        A sine is divided by with the sign that SymPy gives it: the quotient is the same in every ring.
        """
        length = len(list(_parts(element)))
        highest = highest_multiples(element)
        for u in self._halves(element):
            spend(length / TRIED_IN_A_UNIT)
            if not may_divide(u, element, highest):
                continue
            for atom in (Atom(u, False), Atom(u, True)):
                quotient = over_wave(element, u, atom.sine)
                if quotient is not None and len(list(_parts(quotient))) <= length:
                    return atom, quotient * self._sign(atom)
        return None

    def _divided(self, element: Element) -> tuple[TrigProduct, ...] | None:
        """The element as the product of an atom that divides it and the quotient."""
        division = self._division(element)
        if division is None:
            return None
        atom, quotient = division
        front = self._single(atom.frequency, Fraction(self._sign(atom)), atom.sine)
        return gathered(self._product(front, p) for p in self.products(quotient))

    def _product(self, p: TrigProduct, q: TrigProduct) -> TrigProduct:
        powers = dict(p.powers)
        for atom, e in q.powers:
            powers[atom] = powers.get(atom, 0) + e
        return self._sorted(p.number * q.number, powers)

    def _halves(self, element: Element) -> list[int]:
        """Half sums and half differences of the frequencies, the simplest first."""
        # cos u divides Σ of waves only if these pair up into frequencies v ± u: u is half a sum or half a difference.
        frequencies = sorted({w for _, w in element.terms})
        spend(min(len(frequencies), LONGEST_PAIRED) * len(frequencies) / PAIRS_IN_A_UNIT)
        fine = not all(map(self._basis.is_whole, frequencies))
        if len(frequencies) <= LONGEST_PAIRED:
            sums = set[int]().union(*(_sums(a, frequencies) for a in frequencies))
        else:  # every frequency has its partner, and of a dozen together there are few
            sums = set.intersection(*(_sums(a, frequencies) for a in frequencies[:: len(frequencies) // 12]))
        halves = {self._basis.half(w, fine) for w in sums if w}
        return sorted((w for w in halves if w), key=lambda w: (self._weight(w), self._name(w)))

    def _joined(self, element: Element, parts: list[WavePart]) -> Iterator[tuple[TrigProduct, ...]]:
        """The element as a joined pair of terms and the rest; if long, one pair of equal coefficient."""
        # All pairs in all orders would take exponential time: a long sum is joined pair by pair, as they come, and of a
        # very long one the terms are left as they are.
        if len(parts) > LONGEST_PAIRED:
            return
        searched = len(parts) <= LONGEST_SEARCHED
        for one, two in combinations(parts, 2):
            alike = abs(one[1]) == abs(two[1])
            constant = not (one[0] and two[0])
            if one[2] != two[2] or not (alike or (searched and constant) or len(parts) == 2):
                continue
            for pair in self._pairs(one, two):
                rest = element - pair
                if rest:
                    yield (*self.products(pair), *self.products(rest))
                    if not searched:
                        return

    def _apart(self, parts: list[WavePart]) -> Iterator[tuple[TrigProduct, ...]]:
        """The terms of equal coefficient each for themselves, or those of the same angles."""
        for kind in (_size, _support):
            classes: dict[object, list[WavePart]] = {}
            for part in parts:
                classes.setdefault(kind(part), []).append(part)
            if len(classes) > 1:
                sums = [self._basis.total(self._wave(*part) for part in members) for members in classes.values()]
                yield tuple(p for element in sums for p in self.products(element))

    def _wave(self, frequency: int, number: Fraction, sine: bool) -> Element:
        return self._basis.circle(frequency, sine) * number

    def _pairs(self, one: WavePart, two: WavePart) -> Iterator[Element]:
        """c (cos w1 ± cos w2), or of sines, with c one of the coefficients, if the halves are whole."""
        (w1, a, sine), (w2, b, _) = one, two
        basis = self._basis
        if basis.half(w1 + w2, fine=not (basis.is_whole(w1) and basis.is_whole(w2))) is None:
            return
        for size in sorted({abs(a), abs(b)}):
            first, second = (size if a > 0 else -size), (size if b > 0 else -size)
            yield self._wave(w1, first, sine) + self._wave(w2, second, sine)

    def _separated(self, element: Element) -> Iterator[tuple[TrigProduct, ...]]:
        """The element as a polynomial in sines and cosines of single angles, reduced by sin² + cos² = 1."""
        frequencies = {w for _, w in element.terms}
        angles = sorted({i for w in frequencies for i, _ in unpack(w)})
        steps = [self._step(i, frequencies) for i in angles]
        degree = dict(zip(angles, steps, strict=True))
        highest = max(sum(abs(f) // degree[i] for i, f in unpack(w)) for w in frequencies)
        if len(angles) > MOST_SEPARATED_ANGLES or highest > HIGHEST_SEPARATED:
            return
        units = [step << (WIDTH * i) for i, step in degree.items()]
        # sin² or cos² may be the one to keep, for each angle: 2 + 2 cos²θ, but 1 + sin²φ.
        for kept in product((False, True), repeat=len(angles)):
            sums = angle_numerators(element, angles, steps, kept)
            yield tuple(self._monomial(Fraction(n, element.denominator), units, p) for p, n in sums.items())

    def _step(self, angle: int, frequencies: Iterable[int]) -> int:
        """The frequency that the others of this angle are whole multiples of."""
        is_whole = all(f % UNIT == 0 for w in frequencies for i, f in unpack(w) if i == angle)
        return UNIT if is_whole else self._basis.steps[angle]

    def _monomial(self, number: Fraction, units: Sequence[int], powers: Powers) -> TrigProduct:
        atoms = {}
        for unit, (cosines, sines) in zip(units, powers, strict=True):
            atoms.update({Atom(unit, False): cosines, Atom(unit, True): sines})
        return self._sorted(number, {atom: e for atom, e in atoms.items() if e})

    def _cost(self, form: tuple[TrigProduct, ...]) -> tuple[object, ...]:
        """Few products of few atoms first, then plus signs, small numbers, names."""
        heavy = sum(self._weight(atom.frequency) + (e > 1) for p in form for atom, e in p.powers)
        numbers = [p.number * prod(self._sign(atom) ** e for atom, e in p.powers) for p in form]
        names = [tuple((self._key(atom), e) for atom, e in p.powers) for p in form]
        size = sum(n * n for n in numbers)
        return len(form), heavy, sum(n < 0 for n in numbers), size, sorted(zip(names, numbers, strict=True))

    def _sign(self, atom: Atom) -> int:
        return self.angle(atom.frequency)[0] if atom.sine else 1

    def _weight(self, frequency: int) -> int:
        """2 for cos θ, 4 for cos(θ - φ), 6 for cos 2θ and cos(2θ - φ)."""
        places = unpack(frequency)
        if any(abs(value) > UNIT for _, value in places):
            return 6
        return 2 if len(places) == 1 else 4


def _sums(a: int, frequencies: Sequence[int]) -> set[int]:
    """The sums and differences of one frequency with all of them and 0."""
    return {abs(a + b) for b in (0, *frequencies, *(-w for w in frequencies))}


def _size(part: WavePart) -> Fraction:
    return abs(part[1])


def _support(part: WavePart) -> tuple[int, ...]:
    return tuple(i for i, _ in unpack(part[0]))


def gathered(form: Iterable[TrigProduct]) -> tuple[TrigProduct, ...]:
    """The sum with products of the same powers added up."""
    numbers: dict[tuple[tuple[Atom, int], ...], Fraction] = {}
    for p in form:
        numbers[p.powers] = numbers.get(p.powers, Fraction(0)) + p.number
    return tuple(TrigProduct(number, powers) for powers, number in numbers.items() if number)


def _parts(element: Element) -> Iterator[WavePart]:
    """The terms one by one: frequency, coefficient, whether it is a sine."""
    for _, w, a, b in element.items():
        if a:
            yield w, a, False
        if b:
            yield w, b, True


def angle_numerators(
    element: Element, angles: Sequence[int], steps: Sequence[int], sines: Sequence[bool]
) -> dict[Powers, int]:
    """The numerators of a polynomial in cos and sin of single angles.

    Even powers of the cosine are eliminated where `sines` is True, of the sine elsewhere.
    """
    total: dict[Powers, int] = {}
    for (_, w), (a, b) in element.terms.items():
        frequencies = dict(unpack(w))
        partial: dict[Powers, Complex] = {(): (a, -b)}
        for angle, step, sine in zip(angles, steps, sines, strict=True):
            rotation = _rotation(frequencies.get(angle, 0) // step, sine)
            partial = {
                (*powers, power): (x * u - y * v, x * v + y * u)
                for powers, (x, y) in partial.items()
                for power, (u, v) in rotation.items()
            }
        for powers, (x, _) in partial.items():
            total[powers] = total.get(powers, 0) + x
    return {powers: x for powers, x in total.items() if x}


@lru_cache(maxsize=256)
def _rotation(n: int, sine: bool) -> dict[tuple[int, int], Complex]:
    """(cos θ + i sin θ)^n as a polynomial: cos² is replaced by 1 - sin² (`sine`), or sin² by 1 - cos²."""
    total: dict[tuple[int, int], Complex] = {}
    for k in range(abs(n) + 1):
        size = comb(abs(n), k) * (-1 if n < 0 and k % 2 else 1)
        re, im = ((size, 0), (0, size), (-size, 0), (0, -size))[k % 4]
        c, s = abs(n) - k, k
        replaced = c if sine else s
        for j in range(replaced // 2 + 1):
            sign = comb(replaced // 2, j) * (-1) ** j
            power = (c % 2, s + 2 * j) if sine else (c + 2 * j, s % 2)
            x, y = total.get(power, (0, 0))
            total[power] = (x + re * sign, y + im * sign)
    return {power: z for power, z in total.items() if z != (0, 0)}
