"""The textbook form of an equation of motion.

A ring element is written as

    Σ (parameter polynomial) · (sines and cosines) · (dynamic monomial) ,

one product for each of q_j'', q_j'², q_i' q_j', ...; forces, which contain no velocity, stay separate terms:

    (m1 + m2) l1 θ1'' + m2 l2 θ2'' cos(θ1 - θ2) + m2 l2 θ2'² sin(θ1 - θ2) + (m1 + m2) g sin θ1 .

Sums of cosines become products (`products.py`), parameter polynomials are split and factored
(`parameters.py`), virtual displacements are outermost: m x'' δx + m (y'' - g) δy.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from fractions import Fraction

import sympy as sp

from lagrange.algebra.fourier.common_factor import Factor, common_factor, is_acceleration, is_displacement, normalised
from lagrange.algebra.fourier.division import as_fraction, by_denominator, over_one_denominator
from lagrange.algebra.fourier.fourier import Element, Terms
from lagrange.algebra.fourier.packing import unpack
from lagrange.algebra.fourier.parameters import Parameters
from lagrange.algebra.fourier.polynomials import Polynomial, common_number
from lagrange.algebra.fourier.product_to_sum import Atom
from lagrange.algebra.fourier.terms import (
    Exponent,
    Factors,
    Term,
    common_powers,
    divided,
    factored_sum,
    multiplied,
    sum_of,
)
from lagrange.algebra.fourier.trigonometry import Ring
from lagrange.core.records import record
from lagrange.core.symbols import base

__all__ = ["Factor", "Textbook", "common_factor", "normalised", "textbook_form"]

Powers = tuple[tuple[Atom, int], ...]


@record
class Part:
    """One product: a number; parameters and coordinates (`scale`); sines and what moves (`shape`)."""

    number: Fraction
    scale: Factors
    shape: Factors

    def to_sympy(self) -> sp.Expr:
        """The product; sin w/cos w is written tan w."""
        return Term(self.number, multiplied(self.scale, self.shape)).to_sympy()


class _Sorted:
    """The generators of a ring that are of one kind; each is looked at once, as rings grow."""

    def __init__(self, ring: Ring, wanted: Callable[[sp.Expr], bool]) -> None:
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
    """Writes the elements of one ring; keeps what it has written for the next equation.

    unknowns   symbols that are kept apart from parameters as velocities are: multipliers, reactions
    merge      join the terms of equal parameters: m l (θ'' cos φ + θ'² sin φ)
    """

    def __init__(self, ring: Ring, unknowns: Iterable[sp.Symbol] = (), merge: bool = False) -> None:
        self.ring = ring
        self._unknowns = frozenset(unknowns)
        self._merge = merge
        self._parameters = Parameters(ring, self.form)
        self._atoms: dict[Atom, tuple[int, sp.Expr]] = {}
        self._displacements = _Sorted(ring, is_displacement)
        self._dynamic = _Sorted(ring, self._is_dynamic)
        self._sums: dict[object, list[Part]] = {}
        self._rows: dict[object, list[Part]] = {}

    def form(self, expression: sp.Expr | Element) -> sp.Expr:
        """The textbook form."""
        element = self.ring.from_sympy(expression)
        places = self._displacements.places
        summands = []
        for displacement, coefficient in element.by_exponents(places).items():
            parts = self._parts(coefficient)
            factors = self._parameters.monomial(displacement).factors
            if displacement and parts:
                parts = [bracket(parts, leading=self._accelerations(displacement))]
            summands += [Part(p.number, p.scale, multiplied(p.shape, factors)).to_sympy() for p in parts]
        return sp.Add(*summands)

    def product(self, element: Element) -> Term:
        """An element that is not zero as one product, such as a denominator: 2m l² (M + m sin²θ)."""
        [part] = self._row(element)
        return Term(part.number, multiplied(part.scale, part.shape))

    def _parts(self, element: Element) -> list[Part]:
        """The products of what contains no displacement: D_k is written in the principle, and again as an equation."""
        parts = self._sums.get(element.key)
        if parts is None:
            parts = self._sums[element.key] = self._split(element)
        return parts

    def _split(self, element: Element) -> list[Part]:
        places = self._dynamic.places
        parts = []
        for monomial, coefficient in element.by_exponents(places).items():
            if self.ring.is_zero(coefficient):  # denominators may hide that
                continue
            coefficient = over_one_denominator(coefficient)
            factors = self._parameters.monomial(monomial).factors
            row = self._row(coefficient) if monomial else self._forces(coefficient)
            parts += [Part(p.number, p.scale, multiplied(p.shape, factors)) for p in row]
        return merged(parts) if self._merge else parts

    def _accelerations(self, displacement: int) -> tuple[sp.Symbol, ...]:
        """q'' of each δq in a product of displacements."""
        moved = (self.ring.generators[index].expression.name for index, _ in unpack(displacement))
        return tuple(sp.Symbol(name.partition("(")[2].removesuffix(")") + "''", real=True) for name in moved)

    def _is_dynamic(self, expression: sp.Expr) -> bool:
        if not isinstance(expression, sp.Symbol):
            return False
        return expression in self._unknowns or base(expression) != expression

    def _row(self, coefficient: Element) -> list[Part]:
        """The coefficient of one dynamic monomial, as one product; θ1'' and θ2'' often have the same."""
        row = self._rows.get(coefficient.key)
        if row is None:
            numerator, denominator = as_fraction(coefficient)
            waves = self._waves(numerator).items()
            parts = [self._part(self._parameters.factored(p), powers) for powers, p in waves]
            row = [self._over(bracket(parts, factored=True) if len(parts) > 1 else parts[0], denominator)]
            self._rows[coefficient.key] = row
        return row

    def _forces(self, coefficient: Element) -> list[Part]:
        """What contains nothing dynamic, as a sum."""
        parts = []
        for piece in by_denominator(coefficient):
            numerator, denominator = as_fraction(piece) if len(piece) < len(coefficient) else (piece, 0)
            for powers, p in self._waves(numerator).items():
                parts += [self._over(self._part(t, powers), denominator) for t in self._parameters.terms(p)]
        return merged(parts)

    def _over(self, part: Part, denominator: int) -> Part:
        below = self._parameters.monomial(-denominator)
        return Part(part.number * below.number, multiplied(part.scale, below.factors), part.shape)

    def _waves(self, element: Element) -> dict[Powers, Polynomial]:
        """The parameter polynomial of each product of sines and cosines."""
        spectra: dict[int, Terms] = {}
        for (monomial, frequency), value in element.terms.items():
            spectra.setdefault(monomial, {})[0, frequency] = value
        waves: dict[Powers, Polynomial] = {}
        for monomial, terms in spectra.items():
            for p in self.ring.factoring.products(Element(self.ring, terms, element.denominator)):
                waves.setdefault(p.powers, {})[monomial] = p.number
        return waves

    def _part(self, term: Term, powers: Powers) -> Part:
        number = term.number
        shape: Factors = {}
        for atom, exponent in powers:
            sign, expression = self._atom(atom)
            number *= sign**exponent
            shape[expression] = exponent
        return Part(number, term.factors, shape)

    def _atom(self, atom: Atom) -> tuple[int, sp.Expr]:
        """cos or sin as SymPy writes it, which may turn sin(b - a) into -sin(a - b)."""
        found = self._atoms.get(atom)
        if found is None:
            found = self._atoms[atom] = self._function(atom)
        return found

    def _function(self, atom: Atom) -> tuple[int, sp.Expr]:
        sign, angle = self.ring.factoring.angle(atom.frequency)
        function = sp.sin if atom.sine else sp.cos
        if all(self.ring.angles[i].is_Symbol for i, _ in unpack(atom.frequency)):
            expression = function(angle, evaluate=False)  # the sign is all that SymPy would look for
            return sign if atom.sine else 1, expression
        expression = function(sign * angle)
        return (1, expression) if expression.is_Function else (-1, -expression)


def bracket(parts: list[Part], factored: bool = False, leading: Collection[sp.Symbol] = ()) -> Part:
    """The sum of products as one: what they have in common, times the sum of what is left.

    The latter is factored, if that is asked for and saves operations: a² + 2 a b cos θ + b² cos² θ.
    """
    if len(parts) == 1:
        return parts[0]
    number = common_number(p.number for p in parts)
    scale, shape = common_powers([p.scale for p in parts]), common_powers([p.shape for p in parts])
    rest = [Part(p.number / number, divided(p.scale, scale), divided(p.shape, shape)) for p in parts]
    sign = bracket_sign(rest, leading)
    terms = [Term(p.number * sign, multiplied(p.scale, p.shape)) for p in rest]
    total = factored_sum(terms) if factored else None
    if total is None:
        total = Term(Fraction(1), {sum_of(terms): 1})
    return Part(number * sign * total.number, scale, multiplied(shape, total.factors))


def bracket_sign(parts: list[Part], leading: Collection[sp.Symbol] = ()) -> int:
    """The sign that makes the `leading` accelerations positive; without them, most accelerations; without any,
    most terms; if as many, the shortest.
    """
    accelerated = [p for p in parts if any(is_acceleration(f) for f in p.shape)]
    first_of_all = [p for p in accelerated if any(f in leading for f in p.shape)]
    chosen = first_of_all or accelerated or parts
    balance = sum(1 if p.number > 0 else -1 for p in chosen)
    if balance == 0:
        first = min(chosen, key=lambda p: (len(p.shape), str(Part(Fraction(1), p.scale, p.shape).to_sympy())))
        balance = 1 if first.number > 0 else -1
    return 1 if balance > 0 else -1


def merged(parts: list[Part]) -> list[Part]:
    """The products that differ in number and shape only, as one each."""
    classes: dict[frozenset[tuple[sp.Expr, Exponent]], list[Part]] = {}
    for part in parts:
        classes.setdefault(frozenset(part.scale.items()), []).append(part)
    joined = []
    for scale, members in classes.items():
        joined += [bracket(members)] if scale else members
    return joined


def textbook_form(expression: sp.Expr | Element, unknowns: Iterable[sp.Symbol] = (), merge: bool = False) -> sp.Expr:
    """The textbook form of one expression; for several, keep a `Textbook`."""
    ring = expression.basis if isinstance(expression, Element) else Ring()
    assert isinstance(ring, Ring)
    return Textbook(ring, unknowns, merge).form(expression)
