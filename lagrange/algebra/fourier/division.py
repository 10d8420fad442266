"""Exact division in the ring, and fractions brought over one denominator where that is shorter.

With z = e^{iθ} an element is a Laurent polynomial with coefficients in Q(i), so that long division decides whether one
element divides another: (M² − m² cos²θ)/(M − m cos θ) = M + m cos θ. A denominator is a negative power of a generator g
with g^n = base, and powers that differ by multiples of n belong together:

    y'' + y² y''/(l² − y²)  =  l² y''/(l² − y²) .

Division by a single sine or cosine needs no polynomials: the frequencies v, v + 2w, v + 4w, ... form chains, and on
each chain the divisor is z ± 1/z with z = e^{iw}, which synthetic division removes.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from sympy import QQ, QQ_I

from lagrange.algebra.fourier.elements import Basis, Element, Terms
from lagrange.algebra.fourier.limits import LARGEST_DIVISION, LONGEST_CHAIN, MOST_JOINING_ROUNDS
from lagrange.algebra.fourier.polynomials import lowest, pack, polynomials_in, unpack, value_at_place

Complex = tuple[int, int]


def exact_quotient(dividend: Element, divisor: Element) -> Element | None:
    """dividend/divisor, or None if that is not in the ring (or too long to be tried)."""
    if divisor.is_monomial:
        return dividend / divisor
    if not dividend or len(dividend) * len(divisor) > LARGEST_DIVISION:
        return None
    # In e^{iθ} and not in sin θ, cos θ: these obey sin² + cos² = 1, and division with remainder would not be unique.
    variables = _LaurentVariables(dividend, divisor)
    low, p = variables.polynomial(dividend)
    lower, q = variables.polynomial(divisor)
    quotient, remainder = p.div(q)
    if remainder:
        return None
    return variables.element(quotient, [a - b for a, b in zip(low, lower, strict=True)])


def over_wave(element: Element, frequency: int, sine: bool) -> Element | None:
    """element/cos w or element/sin w, or None if that is not a Fourier sum."""
    quotient: dict[tuple[int, int], Complex] = {}
    for (monomial, foot), chain in _chains(element, frequency).items():
        part = _chain_quotient(chain, sine)
        if part is None:
            return None
        for k, value in part.items():
            quotient[monomial, foot + (2 * k - 1) * frequency] = value
    return _from_exponentials(element.basis, quotient, element.denominator)


def highest_multiples(element: Element) -> dict[int, int]:
    """The highest multiple of each angle in the frequencies of an element, in units of an angle."""
    highest: dict[int, int] = {}
    for _, w in element.terms:
        for i, multiple in unpack(w):
            highest[i] = max(highest.get(i, 0), abs(multiple))
    return highest


def may_divide(frequency: int, element: Element, highest: dict[int, int]) -> bool:
    """Whether cos w or sin w may divide an element, by its frequencies alone: none is by itself in its chain.

    highest  of the element, `highest_multiples`
    """
    index, step = unpack(frequency)[0]
    longest = min(highest.get(index, 0) // abs(step), LONGEST_CHAIN)
    shifts = [s for k in range(1, longest + 1) for s in (2 * k * frequency, -2 * k * frequency)]
    return all(any((m, abs(v + shift)) in element.terms for shift in shifts) for m, v in element.terms)


def _chains(element: Element, frequency: int) -> dict[tuple[int, int], dict[int, Complex]]:
    """Twice the coefficients of e^{iv}, by the chains v = foot + 2 k w of equal monomial."""
    index, step = unpack(frequency)[0]
    chains: dict[tuple[int, int], dict[int, Complex]] = {}

    def put(monomial: int, v: int, value: Complex) -> None:
        k = next((f for i, f in unpack(v) if i == index), 0) // (2 * step)
        chains.setdefault((monomial, v - 2 * k * frequency), {})[k] = value

    for (monomial, w), (a, b) in element.terms.items():
        if w:
            put(monomial, w, (a, -b))
            put(monomial, -w, (a, b))
        else:
            put(monomial, 0, (2 * a, 0))
    return chains


def _chain_quotient(chain: dict[int, Complex], sine: bool) -> dict[int, Complex] | None:
    """Synthetic division of Σ c_k z^2k by (z ± 1/z), from the top; None if a remainder is left."""
    top, bottom = max(chain), min(chain)
    if top - bottom > LONGEST_CHAIN:
        return None
    re, im = 0, 0
    quotient: dict[int, Complex] = {}
    for k in range(top, bottom - 1, -1):
        a, b = chain.get(k, (0, 0))
        re, im = (a + re, b + im) if sine else (a - re, b - im)
        quotient[k] = (-2 * im, 2 * re) if sine else (2 * re, 2 * im)
    return None if re or im else quotient


def _from_exponentials(basis: Basis, values: dict[tuple[int, int], Complex], denominator: int) -> Element:
    """The element with twice the given coefficients of e^{iv}."""
    terms: Terms = {}
    for (monomial, v), (re, im) in values.items():
        if v > 0:
            terms[monomial, v] = (2 * re, -2 * im)
        elif v == 0:
            terms[monomial, 0] = (re, 0)
    return basis.element(terms, 2 * denominator)


def without_denominator(element: Element, index: int) -> Element:
    """The element multiplied by the lowest power of a generator that clears its denominators of that kind."""
    generator = element.basis.generators[index]
    least = min((value_at_place(m, index) for m, _ in element.terms), default=0)
    if least >= 0:
        return element
    element = element.over_monomial(pack([(index, least)]))
    if generator.base is not None and least <= -generator.order:
        element, _ = _shortened(element, generator.base, least, generator.order)
    return element


def _shortened(numerator: Element, base: Element, exponent: int, order: int) -> tuple[Element, int]:
    """numerator · g^exponent, with the base taken out of the numerator while the exponent stays negative."""
    while exponent <= -order and (quotient := exact_quotient(numerator, base)) is not None:
        numerator, exponent = quotient, exponent + order
    return numerator, exponent


def over_one_denominator(element: Element) -> Element:
    """The element with fractions joined where that saves terms, and reduced."""
    # Joining over one denominator may expose a common one with another: until nothing changes.
    for _ in range(MOST_JOINING_ROUNDS):
        joined = _joined_by_each_denominator(element)
        if joined == element:
            break
        element = joined
    return element


def _joined_by_each_denominator(element: Element) -> Element:
    for index in element.basis.related:
        base = element.basis.generators[index].base
        if base is not None and not base.is_monomial and any(value_at_place(m, index) < 0 for m, _ in element.terms):
            element = _joined(element, index, base, element.basis.generators[index].order)
    return element


def as_fraction(element: Element) -> tuple[Element, int]:
    """Numerator and (packed) denominator: symbols, sines, cosines, and anything else that does not lengthen it.

    R²/h² + 1 is (R² + h²)/h², but 1/(l² - y²) + 1 stays.
    """
    generators = element.basis.generators
    denominator = 0
    for index, exponent in unpack(lowest(m for m, _ in element.terms)):
        if exponent < 0:
            power = pack([(index, -exponent)])
            numerator = element.over_monomial(-power)
            base = generators[index].base
            if base is None or len(base) == 1 or len(numerator) <= len(element):
                element, denominator = numerator, denominator + power
    return element, denominator


def by_denominator(element: Element) -> list[Element]:
    """The element split by the sums, sines and cosines in its denominators, roots excepted."""
    generators = element.basis.generators
    split: dict[int, Terms] = {}
    for (monomial, frequency), value in element.terms.items():
        below = pack(
            (i, e) for i, e in unpack(monomial) if e < 0 and generators[i].base and e % generators[i].order == 0
        )
        split.setdefault(below, {})[monomial, frequency] = value
    return [element.basis.element(terms, element.denominator) for terms in split.values()]


def _joined(element: Element, index: int, base: Element, order: int) -> Element:
    """The terms whose denominators are powers of one generator, over one denominator where that is shorter.

    A base without generators divides what multiplies each monomial by itself, cos θ in 1 + x sin θ/cos θ.
    """
    apart = all(not m for m, _ in base.terms)
    classes: dict[tuple[int, int], dict[int, Element]] = {}
    for power, part in element.by_exponents((index,)).items():
        exponent = value_at_place(power, index)
        for monomial, piece in part.by_monomial().items() if apart else ((0, part),):
            classes.setdefault((exponent % order, monomial), {})[exponent] = piece
    return element.basis.total(_class_joined(parts, index, base, order) for parts in classes.values())


def _class_joined(parts: dict[int, Element], index: int, base: Element, order: int) -> Element:
    """Σ part · g^exponent, the exponents equal modulo the order."""
    basis = base.basis
    if len(parts) > 1:
        parts = _each_shortened(parts, base, order)
    least = min(parts)
    # Over the common denominator only if it cancels against the numerator or is no longer than the parts were.
    if least < 0:
        numerator = basis.total(part * base ** ((e - least) // order) for e, part in parts.items())
        numerator, joined = _shortened(numerator, base, least, order)
        if joined > least or len(numerator) <= sum(map(len, parts.values())):
            parts = {joined: numerator}
    return basis.total(part * basis.power_of(index, e) for e, part in parts.items())


def _each_shortened(parts: dict[int, Element], base: Element, order: int) -> dict[int, Element]:
    """The parts, each in lowest terms on its own: sin 2θ/(sin θ cos θ) is 2, whatever the other terms over sin²θ."""
    shortened: dict[int, Element] = {}
    for exponent, part in parts.items():
        numerator, lower = _shortened(part, base, exponent, order)
        shortened[lower] = shortened[lower] + numerator if lower in shortened else numerator
    return shortened


class _LaurentVariables:
    """The generators and the exponentials e^{iθ} of two elements, as variables of a polynomial ring."""

    def __init__(self, *elements: Element) -> None:
        keys = [key for e in elements for key in e.terms]
        self._basis: Basis = elements[0].basis
        self._generators = sorted({i for m, _ in keys for i, _ in unpack(m)})
        self._angles = sorted({i for _, w in keys for i, _ in unpack(w)})
        self._ring = polynomials_in(len(self._generators) + len(self._angles), QQ_I)

    def polynomial(self, element: Element) -> tuple[list[int], Any]:
        """The lowest exponents, and twice the element divided by the monomial that they make."""
        values: dict[tuple[int, ...], tuple[Fraction, Fraction]] = {}
        for m, w, a, b in element.items():
            values[self._exponents(m, w)] = (a, -b)
            values[self._exponents(m, -w)] = (a, b) if w else (2 * a, b)
        # A Laurent polynomial is a polynomial times its lowest monomial, which is a unit.
        low = [min(column) for column in zip(*values, strict=True)]
        shifted = {
            tuple(e - d for e, d in zip(exponents, low, strict=True)): QQ_I(
                QQ(re.numerator, re.denominator), QQ(im.numerator, im.denominator)
            )
            for exponents, (re, im) in values.items()
        }
        return low, self._ring.from_dict(shifted)

    def _exponents(self, monomial: int, frequency: int) -> tuple[int, ...]:
        powers, angles, steps = dict(unpack(monomial)), dict(unpack(frequency)), self._basis.steps
        return (
            *(powers.get(i, 0) for i in self._generators),
            *(angles.get(i, 0) // steps[i] for i in self._angles),
        )

    def element(self, polynomial: Any, low: list[int]) -> Element:
        """The real part of a polynomial times the monomial of `low`, as an element."""
        basis, cut = self._basis, len(self._generators)
        summands = []
        for exponents, z in polynomial.terms():
            powers = [a + b for a, b in zip(exponents, low, strict=True)]
            monomial = pack(zip(self._generators, powers[:cut], strict=True))
            turns = zip(self._angles, powers[cut:], strict=True)
            frequency = pack((i, n * basis.steps[i]) for i, n in turns)
            wave = basis.circle(frequency) * _fraction(z.x) - basis.circle(frequency, sine=True) * _fraction(z.y)
            summands.append(wave * Element(basis, {(monomial, 0): (1, 0)}))
        return basis.total(summands)


def _fraction(number: Any) -> Fraction:
    return Fraction(int(number.numerator), int(number.denominator))
