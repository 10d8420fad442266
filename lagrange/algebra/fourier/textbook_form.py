"""The textbook form of an equation of motion.

A ring element is written as

    Σ (parameter polynomial) · (sines and cosines) · (dynamic monomial) ,

one product for each of q_j'', q_j'², q_i' q_j', ...; forces, which contain no velocity, stay separate terms:

    (m1 + m2) l1 θ1'' + m2 l2 θ2'' cos(θ1 − θ2) + m2 l2 θ2'² sin(θ1 − θ2) + (m1 + m2) g sin θ1 .

Virtual displacements are outermost: m x'' δx + m (y'' − g) δy. Sums of cosines become products (`product_to_sum`).
Parameter polynomials are split into number, monomial and primitive part, which is factored where that saves operations
(l² − y² stays), and a sum that does not factor is grouped: l1² (m1 + m2) + l2² m2. A bracket has more plus than minus
signs; of as many, a coordinate has the plus, k (r − l), then what comes first in the alphabet.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping
from fractions import Fraction
from itertools import combinations
from math import floor

import sympy as sp

from lagrange.algebra.fourier.division import as_fraction, by_denominator, over_one_denominator
from lagrange.algebra.fourier.elements import Basis, Element, Terms, WaveKey
from lagrange.algebra.fourier.limits import LONGEST_FACTORED, MOST_JOINING_ROUNDS, MOST_SHARED_GENERATORS
from lagrange.algebra.fourier.polynomials import (
    Polynomial,
    common,
    common_number,
    divides,
    factorization,
    multiplications,
    negated,
    shared,
    square_of_two,
    unpack,
)
from lagrange.algebra.fourier.product_to_sum import Atom, TrigProduct
from lagrange.algebra.fourier.ring import FourierRing
from lagrange.algebra.fourier.terms import (
    CommonFactor,
    Exponent,
    Factors,
    PowerProduct,
    are_summands,
    common_factor,
    common_factor_of,
    common_powers,
    factored_sum,
    is_acceleration,
    is_displacement,
    multiplied,
    multiply,
    normalised,
    number_apart,
    quotient_of_powers,
    sum_of,
)
from lagrange.core.effort import remembered
from lagrange.core.records import record
from lagrange.core.symbols import base

__all__ = ["CommonFactor", "Textbook", "common_factor", "common_factor_of", "normalised", "textbook_form"]

AtomPowers = tuple[tuple[Atom, int], ...]


class ParameterPolynomials:
    """Writes the polynomials of one ring; `write` is how the base of a root is written."""

    def __init__(self, basis: Basis, write: Callable[[Element], sp.Expr]) -> None:
        self._basis = basis
        self._write = write
        self._terms: dict[frozenset[tuple[int, Fraction]], PowerProduct] = {}
        self._primitives: dict[tuple[int, frozenset[tuple[int, Fraction]]], PowerProduct] = {}
        self._monomials: dict[int, PowerProduct] = {}
        self._written: dict[int, Factors] = {}
        self._names: dict[int, tuple[tuple[str, int], ...]] = {}

    def factored(self, polynomial: Polynomial) -> PowerProduct:
        """The polynomial as one product."""
        key = frozenset(polynomial.items())
        term = self._terms.get(key)
        if term is None:
            term = self._terms[key] = self._factored(polynomial)
        return term

    def terms(self, polynomial: Polynomial) -> list[PowerProduct]:
        """The polynomial as one product if it has factors, and as a short sum of products if not."""
        product = self.factored(polynomial)
        if len(polynomial) == 1 or len(product.factors) > 1 or any(e != 1 for e in product.factors.values()):
            return [product]
        return self._grouped(polynomial)

    def monomial(self, packed: int) -> PowerProduct:
        """The powers of generators as SymPy writes them."""
        term = self._monomials.get(packed)
        if term is None:
            term = self._monomials[packed] = self._monomial(packed)
        return term

    def _monomial(self, packed: int) -> PowerProduct:
        factors: Factors = {}
        for index, exponent in unpack(packed):
            for expression, unit in self._generator(index).items():
                multiply(factors, expression, unit * exponent)
        number = Fraction(1)
        for root in [f for f in factors if f.is_Integer]:  # 2^(-1/2) is √2/2
            power = floor(factors[root])
            multiply(factors, root, -power)
            number *= Fraction(int(root)) ** power
        return PowerProduct(number, factors)

    def _generator(self, index: int) -> Factors:
        """A symbol, or a root such as (1/2 · (2 M + 2 m sin²θ)) ** (1/2) with the number apart."""
        powers = self._written.get(index)
        if powers is None:
            generator = self._basis.generators[index]
            if generator.radical and generator.base is not None:
                number, rest = number_apart(self._write(generator.base))
                unit = Fraction(1, generator.order)
                powers = {e: unit for e in (number, rest) if e != 1}
            else:
                powers = {generator.expression: 1}
            self._written[index] = powers
        return powers

    def _factored(self, polynomial: Polynomial) -> PowerProduct:
        number, monomial, primitive = self._split(polynomial)
        term = self.monomial(monomial).scaled(number)
        if len(primitive) == 1:
            return PowerProduct(term.number * primitive[0], term.factors)
        # One sum of masses occurs with many products of lengths. What is under roots decides what is factored.
        key = len(self._basis.related), frozenset(primitive.items())
        factors = self._primitives.get(key)
        if factors is None:
            factors = self._primitives[key] = self._factors(primitive)
        return term * factors

    def _factors(self, primitive: Polynomial) -> PowerProduct:
        # l² − y² stays whole where it occurs under a root too: root and factor then cancel visibly.
        known = self._known()
        sign, factors = (1, [(primitive, 1)]) if len(primitive) > LONGEST_FACTORED else factorization(primitive, known)
        product = PowerProduct(Fraction(sign), {})
        for factor, exponent in factors:
            turned, oriented = (1, factor) if factor in known else self._oriented(factor)
            power: Factors = {sum_of(self._grouped(oriented)): exponent}
            product = product * PowerProduct(Fraction(turned**exponent), power)
        return product

    def _split(self, polynomial: Polynomial) -> tuple[Fraction, int, Polynomial]:
        number = common_number(polynomial.values())
        monomial = common(polynomial)
        return number, monomial, {m - monomial: c if number == 1 else c / number for m, c in polynomial.items()}

    def _oriented(self, polynomial: Polynomial) -> tuple[int, Polynomial]:
        """Minus one if most signs are minus; the polynomial without that sign."""
        if negated(polynomial) in self._known():
            return -1, negated(polynomial)
        balance = sum(1 if c > 0 else -1 for c in polynomial.values())
        # The order of generators depends on the order of reading, names do not: the same sign in every run.
        if balance == 0:
            first = min(polynomial, key=lambda m: (not self._is_coordinate(m), self._name(m)))
            balance = 1 if polynomial[first] > 0 else -1
        return (1, polynomial) if balance > 0 else (-1, negated(polynomial))

    def _name(self, monomial: int) -> tuple[tuple[str, int], ...]:
        """The sort key of a monomial: the same in every ring."""
        name = self._names.get(monomial)
        if name is None:
            places = [(str(self._basis.generators[i].expression), -e) for i, e in unpack(monomial)]
            name = self._names[monomial] = tuple(sorted(places))
        return name

    def _grouped(self, polynomial: Polynomial) -> list[PowerProduct]:
        """The sum with squares of two terms split off, then the common factor that saves most, repeatedly."""
        root = square_of_two(polynomial) if 2 < len(polynomial) <= LONGEST_FACTORED else None
        if root is not None:
            base = self.factored(root)
            square = PowerProduct(base.number**2, {f: 2 * e for f, e in base.factors.items()})
            within = {u + v for u in root for v in root}
            return [square, *self._grouped({m: c for m, c in polynomial.items() if m not in within})]
        best = self._best_group(polynomial)
        if best is None:
            return [self.monomial(m).scaled(c) for m, c in polynomial.items()]
        group = {m: c for m, c in polynomial.items() if divides(best, m)}
        rest = {m: c for m, c in polynomial.items() if m not in group}
        return [self.factored(group), *self._grouped(rest)]

    def _best_group(self, polynomial: Polynomial) -> int | None:
        if not 2 < len(polynomial) <= LONGEST_FACTORED:
            return None
        often = Counter(i for m in polynomial for i, e in unpack(m) if e > 0)
        several = [m for m in polynomial if any(often[i] > 1 for i, _ in unpack(m))]
        # A factor worth taking out divides at least two terms, so that only common factors of pairs need be tried.
        candidates = {shared(a, b) for a, b in combinations(several, 2)} - {0}
        if not candidates:
            return None
        return min(candidates, key=lambda f: (-self._saving(f, polynomial), not self.is_positive(f), self._name(f)))

    def _saving(self, factor: int, polynomial: Polynomial) -> int:
        numbers = [c for m, c in polynomial.items() if divides(factor, m)]
        return (len(numbers) - 1) * (multiplications(factor) + (common_number(numbers) != 1))

    def _is_coordinate(self, monomial: int) -> bool:
        """Whether it is one symbol that may have either sign."""
        places = unpack(monomial)
        return len(places) == 1 and places[0][1] == 1 and not self.is_positive(monomial)

    def is_positive(self, monomial: int) -> bool:
        """Whether it is a product of positive parameters."""
        return all(self._basis.generators[i].expression.is_positive for i, _ in unpack(monomial))

    def _known(self) -> list[Polynomial]:
        """The polynomials under roots and in denominators, the way they are written there."""
        generators = (self._basis.generators[i] for i in self._basis.related)
        bases = [g.base for g in generators if g.radical and g.base is not None and not g.base.is_monomial]
        return [{m: a for m, _, a, _ in b.items()} for b in bases if not any(w for _, w in b.terms)]


@record
class SplitProduct:
    """One product: a number; parameters and coordinates (`scale`); sines and what moves (`shape`)."""

    number: Fraction
    scale: Factors
    shape: Factors

    def to_sympy(self) -> sp.Expr:
        """The product; sin w/cos w is written tan w."""
        return PowerProduct(self.number, multiplied(self.scale, self.shape)).to_sympy()


class _GeneratorsOfKind:
    """The generators of one kind in a ring that grows; each is examined once."""

    def __init__(self, ring: FourierRing, wanted: Callable[[sp.Expr], bool]) -> None:
        self._ring = ring
        self._wanted = wanted
        self._seen = 0
        self._places: set[int] = set()

    @property
    def places(self) -> set[int]:
        """Their numbers."""
        generators = self._ring.generators
        for i in range(self._seen, len(generators)):
            if self._wanted(generators[i].expression):
                self._places.add(i)
        self._seen = len(generators)
        return self._places


class Textbook:
    """Writes the elements of one ring, and remembers what it has written for the next equation.

    unknowns   symbols that are kept apart from parameters as velocities are: multipliers, reactions
    merge      join the terms of equal parameters: m l (θ'' cos φ + θ'² sin φ)
    """

    def __init__(self, ring: FourierRing, unknowns: Iterable[sp.Symbol] = (), merge: bool = False) -> None:
        self.ring = ring
        self._unknowns = frozenset(unknowns)
        self._merge = merge
        self._parameters = ParameterPolynomials(ring, self.form)
        self._atoms: dict[Atom, tuple[int, sp.Expr]] = {}
        self._displacements = _GeneratorsOfKind(ring, is_displacement)
        self._dynamic = _GeneratorsOfKind(ring, self._is_dynamic)
        self._sums: dict[object, list[SplitProduct]] = {}
        self._rows: dict[object, list[SplitProduct]] = {}

    def form(self, expression: sp.Expr | Element) -> sp.Expr:
        """The textbook form."""
        element = self.ring.from_sympy(expression)
        return self._sum(element.by_exponents(self._displacements.places))

    def work(self, coefficients: Mapping[sp.Symbol, Element]) -> sp.Expr:
        """Σ D δq of coefficients D without displacements: the form of the sum, which need not be split again."""
        by_place: dict[int, Element] = {}
        for displacement, coefficient in coefficients.items():
            [(monomial, _)] = self.ring.from_sympy(displacement).terms
            by_place[monomial] = coefficient
        return self._sum(by_place)

    def summands(self, element: Element) -> list[PowerProduct] | None:
        """The products that the textbook form is the sum of; None where SymPy would write that sum as another one."""
        if element.by_exponents(self._displacements.places).keys() != {0}:
            return None
        terms = [PowerProduct(p.number, multiplied(p.scale, p.shape)) for p in self._parts(element)]
        return terms if are_summands(terms) else None

    def _sum(self, by_displacements: Mapping[int, Element]) -> sp.Expr:
        summands = []
        for displacement, coefficient in by_displacements.items():
            parts = self._parts(coefficient)
            factors = self._parameters.monomial(displacement).factors
            if displacement and parts:
                parts = [bracket(parts, leading=self._accelerations(displacement))]
            summands += [SplitProduct(p.number, p.scale, multiplied(p.shape, factors)).to_sympy() for p in parts]
        return sp.Add(*summands)

    def coefficients(self, element: Element) -> Collection[Element]:
        """The coefficient of each product of accelerations, velocities and unknowns."""
        return element.by_exponents(self._dynamic.places).values()

    def product(self, element: Element) -> PowerProduct:
        """An element that is not zero as one product, such as a denominator: 2m l² (M + m sin²θ)."""
        [part] = self._row(element)
        return PowerProduct(part.number, multiplied(part.scale, part.shape))

    def _parts(self, element: Element) -> list[SplitProduct]:
        """The products of what contains no displacement: D_k is written in the principle, and again as an equation."""
        key = element.key
        parts = self._sums.get(key)
        if parts is None:
            parts = self._sums[key] = self._split(element)
        return parts

    def _split(self, element: Element) -> list[SplitProduct]:
        places = self._dynamic.places
        # By dynamic monomial first: accelerations are what a reader looks for. Fractions are joined while a coefficient
        # is still one element; then come sums of cosines, and parameters last. Factoring first would hide θ'' in
        # several brackets. Terms of equal parameters are merged when all are written.
        parts = []
        for monomial, coefficient in element.by_exponents(places).items():
            if self.ring.is_zero(coefficient):  # denominators may hide that: a/(a + b) + b/(a + b) − 1
                continue
            coefficient = over_one_denominator(coefficient)
            factors = self._parameters.monomial(monomial).factors
            row = self._row(coefficient) if monomial else self._forces(coefficient)
            parts += [SplitProduct(p.number, p.scale, multiplied(p.shape, factors)) for p in row]
        return merged_products(parts) if self._merge else parts

    def _accelerations(self, displacement: int) -> tuple[sp.Symbol, ...]:
        """q'' of each δq in a product of displacements."""
        moved = (self.ring.generators[index].expression.name for index, _ in unpack(displacement))
        return tuple(sp.Symbol(name.partition("(")[2].removesuffix(")") + "''", real=True) for name in moved)

    def _is_dynamic(self, expression: sp.Expr) -> bool:
        if not isinstance(expression, sp.Symbol):
            return False
        return expression in self._unknowns or base(expression) != expression

    def _row(self, coefficient: Element) -> list[SplitProduct]:
        """The coefficient of one dynamic monomial, as one product; θ1'' and θ2'' often have the same."""
        # Remembered by the ring element: a mass matrix is symmetric, so that most coefficients occur twice.
        key = coefficient.key
        row = self._rows.get(key)
        if row is None:
            numerator, denominator = as_fraction(coefficient)
            waves = self._waves(numerator).items()
            parts = [self._part(self._parameters.factored(p), powers) for powers, p in waves]
            row = [self._over(bracket(parts, factored=True) if len(parts) > 1 else parts[0], denominator)]
            self._rows[key] = row
        return row

    def _forces(self, coefficient: Element) -> list[SplitProduct]:
        """The terms without velocities and accelerations, as a sum."""
        parts = []
        for piece in by_denominator(coefficient):
            numerator, denominator = as_fraction(piece) if len(piece) < len(coefficient) else (piece, 0)
            waves = self._waves(numerator)
            for powers, p in waves.items():
                is_coefficient = powers and len(waves) == 1 and all(map(self._parameters.is_positive, p))
                terms = [self._parameters.factored(p)] if is_coefficient else self._parameters.terms(p)
                parts += [self._over(self._part(t, powers), denominator) for t in terms]
        return merged_products(parts)

    def _over(self, part: SplitProduct, denominator: int) -> SplitProduct:
        below = self._parameters.monomial(-denominator)
        return SplitProduct(part.number * below.number, multiplied(part.scale, below.factors), part.shape)

    def _waves(self, element: Element) -> dict[AtomPowers, Polynomial]:
        """The parameter polynomial of each product of sines and cosines."""
        spectra: dict[int, Terms] = {}
        for (monomial, frequency), value in element.terms.items():
            spectra.setdefault(monomial, {})[0, frequency] = value
        waves: dict[AtomPowers, Polynomial] = {}
        alike: dict[tuple[tuple[WaveKey, tuple[int, int]], ...], tuple[TrigProduct, ...]] = {}
        for monomial, terms in spectra.items():
            spectrum = tuple(terms.items())  # one for all the masses that a link carries
            products = alike.get(spectrum)
            if products is None:
                products = alike[spectrum] = self.ring.factoring.products(
                    Element(self.ring, terms, element.denominator)
                )
            for p in products:
                waves.setdefault(p.powers, {})[monomial] = p.number
        return waves

    def _part(self, term: PowerProduct, powers: AtomPowers) -> SplitProduct:
        number = term.number
        shape: Factors = {}
        for atom, exponent in powers:
            sign, expression = self._atom(atom)
            number *= sign**exponent
            shape[expression] = exponent
        return SplitProduct(number, term.factors, shape)

    def _atom(self, atom: Atom) -> tuple[int, sp.Expr]:
        """cos or sin as SymPy writes it, which may turn sin(b - a) into -sin(a - b)."""
        signed = self._atoms.get(atom)
        if signed is None:
            signed = self._atoms[atom] = self._function(atom)
        return signed

    def _function(self, atom: Atom) -> tuple[int, sp.Expr]:
        sign, angle = self.ring.factoring.angle(atom.frequency)
        function = sp.sin if atom.sine else sp.cos
        if all(self.ring.angles[i].is_Symbol for i, _ in unpack(atom.frequency)):
            expression = function(angle, evaluate=False)  # the sign is all that SymPy would look for
            return sign if atom.sine else 1, expression
        expression = function(sign * angle)
        return (1, expression) if expression.is_Function else (-1, -expression)


def bracket(parts: list[SplitProduct], factored: bool = False, leading: Collection[sp.Symbol] = ()) -> SplitProduct:
    """The sum of products as one: their common factors times the sum of the quotients.

    That sum is factored, if `factored` and if it saves operations: a² + 2 a b cos θ + b² cos² θ.
    """
    if len(parts) == 1:
        return parts[0]
    number = common_number(p.number for p in parts)
    scale, shape = common_powers([p.scale for p in parts]), common_powers([p.shape for p in parts])
    rest = [
        SplitProduct(p.number / number, quotient_of_powers(p.scale, scale), quotient_of_powers(p.shape, shape))
        for p in parts
    ]
    sign = bracket_sign(rest, leading)
    terms = [PowerProduct(p.number * sign, multiplied(p.scale, p.shape)) for p in rest]
    total = factored_sum(terms) if factored else None
    if total is None:
        total = PowerProduct(Fraction(1), {sum_of(terms): 1})
    return SplitProduct(number * sign * total.number, scale, multiplied(shape, total.factors))


def bracket_sign(parts: list[SplitProduct], leading: Collection[sp.Symbol] = ()) -> int:
    """The sign that makes the `leading` accelerations positive; without them, most accelerations; without any,
    most terms; if as many, the shortest.
    """
    accelerated = [p for p in parts if any(is_acceleration(f) for f in p.shape)]
    first_of_all = [p for p in accelerated if any(f in leading for f in p.shape)]
    chosen = first_of_all or accelerated or parts
    balance = sum(1 if p.number > 0 else -1 for p in chosen)
    if balance == 0:
        first = min(chosen, key=lambda p: (len(p.shape), str(SplitProduct(Fraction(1), p.scale, p.shape).to_sympy())))
        balance = 1 if first.number > 0 else -1
    return 1 if balance > 0 else -1


def merged_products(parts: list[SplitProduct]) -> list[SplitProduct]:
    """The products that differ in number and shape only, as one each."""
    classes: dict[frozenset[tuple[sp.Expr, Exponent]], list[SplitProduct]] = {}
    for part in parts:
        classes.setdefault(frozenset(part.scale.items()), []).append(part)
    joined = []
    for scale, members in classes.items():
        joined += [bracket(members)] if scale else members
    return joined


def textbook_form(expression: sp.Expr | Element, unknowns: Iterable[sp.Symbol] = (), merge: bool = False) -> sp.Expr:
    """The textbook form of one expression; for several, keep a `Textbook`."""
    if isinstance(expression, Element):
        assert isinstance(expression.basis, FourierRing)
        return Textbook(expression.basis, unknowns, merge).form(expression)
    if isinstance(expression, sp.Symbol | sp.Rational):
        return expression
    textbook = Textbook(FourierRing(), unknowns, merge) if unknowns or merge else _shared()
    form = textbook.form(expression)
    # What is over sin θ cos θ may be split in several ways, and which is found depends on how it was read.
    for _ in range(MOST_JOINING_ROUNDS):
        if len(_waves_below(form)) < 2 or (again := textbook.form(form)) == form:
            break
        form = again
    return form


def _waves_below(form: sp.Expr) -> set[sp.Expr]:
    """The sines and cosines by which a form divides."""
    return {p.base for p in form.atoms(sp.Pow) if p.exp.is_negative and isinstance(p.base, sp.sin | sp.cos)}


def _shared() -> Textbook:
    """One for many expressions: most of the time goes into reading their parts, which are often the same."""
    kept = remembered()
    textbook: Textbook | None = kept.get(__name__)
    if textbook is None or not textbook.ring.is_plain or len(textbook.ring.generators) > MOST_SHARED_GENERATORS:
        textbook = kept[__name__] = Textbook(FourierRing())
    return textbook
