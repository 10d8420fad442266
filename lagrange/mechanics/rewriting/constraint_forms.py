"""The differential form Σ a_k dq_k + a_t dt of a constraint, without the factors that all of its terms share.

2x dx + 2y dy = 0 is x dx + y dy = 0. Dividing a form by a number divides its partial derivatives by it, and Frobenius'
product ω ∧ dω ∧ ... by the numbers of all the forms in it.

A constraint on velocities that forbids the one along a unit vector n is v·n = 0, up to a factor.

The solutions of conditions on virtual displacements by a free parameter, where solving for one would divide by zero.

Of sin θ δx = cos θ δy every solution, whatever θ, is δx = cos θ δs, δy = sin θ δs. That takes in all of them if only
one free displacement has denominators, and if what it is multiplied by to clear them, and the others with it, never
vanish at once: the sum of their squares is a positive number.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import in_sines, shortest_form
from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import Sizes, count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, VectorSymbol, free_letter, t, variation
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.limits import LONGEST_CANCELLED, MOST_EXPANDED_TERMS
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Constraint, Problem

if TYPE_CHECKING:
    from lagrange.algebra.forms.frobenius import WedgeComponent


def common_number(row: Row) -> sp.Integer:
    """The whole number that all coefficients of a form contain: 2 in 2x dx + 2y dy."""
    total = sp.Add(*(a * sp.Dummy() for a in row.form))
    if Sizes().of(total).widest > MOST_EXPANDED_TERMS:
        return sp.S.One
    content, _ = sp.expand(total).primitive()
    return content if content.is_Integer and content > 1 else sp.S.One


def without_common_number(row: Row) -> Row:
    """The form without that number, and without the sign of its only term: dr = 0 for −dr = 0."""
    number = common_number(row)
    terms = [a for a in (*row.coefficients, row.drift) if a != 0]
    if len(terms) == 1 and terms[0].is_number and terms[0].is_negative:
        number = -number
    return replace(row, coefficients=tuple(a / number for a in row.coefficients), drift=row.drift / number)


def with_short_forms(classification: Classification) -> Classification | None:
    """The classification with the geometric forms without common factors.

    None if no geometric form has a common factor, or where other forms are written as combinations of them.
    """
    numbers = {c.row.name: common_number(c.row) for c in classification.constraints if c.row.finite is not None}
    if all(n == 1 for n in numbers.values()) or classification.hidden.found or classification.redundancies:
        return None
    product = sp.Mul(*numbers.values())
    constraints = tuple(_divided(c, numbers.get(c.row.name, sp.S.One), product) for c in classification.constraints)
    return replace(classification, constraints=constraints)


def _divided(c: ConstraintAnalysis, number: sp.Integer, product: sp.Expr) -> ConstraintAnalysis:
    if c.row.finite is None:
        parts = (replace(k, coefficient=textbook_form(k.coefficient / product)) for k in c.frobenius)
        return replace(c, frobenius=tuple(parts))
    pairs = (
        replace(
            p,
            coefficients=tuple(a / number for a in p.coefficients),
            derivatives=tuple(a / number for a in p.derivatives),
        )
        for p in c.exactness.comparisons
    )
    return replace(c, row=without_common_number(c.row), exactness=replace(c.exactness, comparisons=tuple(pairs)))


@record
class ReducedFrobenius:
    """ω ∧ dω of a form in coordinates that satisfy the geometric constraints, where it has a single component.

    form  the coefficients of ω, without constant factors
    """

    form: tuple[sp.Expr, ...]
    component: WedgeComponent


def integral_in_angle(c: ConstraintAnalysis) -> sp.Expr | None:
    """The finite relation in the one angle by which the geometric constraints were satisfied; None if it is no shorter.

    x + l cos ψ + l ln|tan(ψ/2)| of a tractrix, for a + l ln|(x − a + l)/y| with a = x + l cos ψ, y = l sin ψ.
    """
    restriction = None if c.finite_form is None else c.finite_form.restriction
    if restriction is None or c.integral is None or len(restriction.angles) != 1:
        return None
    psi = restriction.angles[0].symbol
    half = sp.tan(psi / 2)
    substituted = c.integral.xreplace(dict(restriction.rules))

    def reduced(logarithm: sp.Expr) -> sp.Expr:
        if not logarithm.has(sp.Abs):
            return logarithm
        square = logarithm.args[0].replace(sp.Abs, lambda x: x) ** 2
        for short, cosine in ((half, sp.cos(psi)), (1 / half, -sp.cos(psi))):
            if is_zero(square - (1 - cosine) ** 2 / sp.sin(psi) ** 2) is True:
                return sp.log(sp.Abs(short))
        return logarithm

    relation: sp.Expr = substituted.replace(lambda e: isinstance(e, sp.log), reduced)
    return relation if relation != substituted and psi in relation.free_symbols else None


def frobenius_on_surface(row: Row, slots: Slots) -> ReducedFrobenius | None:
    """Frobenius' product of the only form; None unless one component, which does not vanish, settles the question."""
    from lagrange.algebra.forms.frobenius import frobenius_form

    form = _without_constants(row, slots)
    components = frobenius_form(form, slots.coordinates, slots)
    if len(components) != 1 or not components[0].nonzero:
        return None
    return ReducedFrobenius(form, components[0])


def _without_constants(row: Row, slots: Slots) -> tuple[sp.Expr, ...]:
    """The coefficients without the constant factors that all of them share."""
    letters = {q: sp.Dummy() for q in slots.coordinates}
    total = sp.factor_terms(sp.Add(*(a * letters[q] for a, q in zip(row.coefficients, slots.coordinates, strict=True))))
    moving = {*slots.coordinates, *letters.values()}
    kept = sp.Mul(*(f for f in sp.Mul.make_args(total) if f.free_symbols & moving))
    return tuple(sp.expand(kept).coeff(letters[q]) for q in slots.coordinates)


# -- v·n = 0 ---------------------------------------------------------------------------------------------------------


def vanishing_components(problem: Problem) -> Iterator[tuple[sp.Expr, str]]:
    """For each constraint on velocities that is v·n = 0 on the geometric ones: the velocity, as written, and n."""
    surface = Surface([c.lhs - c.rhs for c in problem.constraints if not c.kinematic])
    for constraint in problem.constraints:
        component = _vanishing(problem, constraint, surface) if constraint.kinematic else None
        if component is not None:
            yield component


def _vanishing(problem: Problem, constraint: Constraint, surface: Surface) -> tuple[sp.Expr, str] | None:
    difference = constraint.lhs - constraint.rhs
    for name, direction in problem.abbreviations.items():
        if not isinstance(direction, Vector) or surface.is_zero(direction.dot(direction) - 1) is not True:
            continue
        for velocity, written in _velocities(problem):
            product = velocity.dot(direction.fixed())
            factor = _ratio(difference, product, problem.slots)
            if factor is not None and surface.is_zero(difference - factor * product) is True:
                return written, name
    return None


def _velocities(problem: Problem) -> Iterator[tuple[Vector, sp.Expr]]:
    """The velocities of a point, of particles and bodies, and of the middle between two particles, each as written."""
    slots = problem.slots
    places = {p.name: p.position for p in problem.particles} | {b.name: b.position for b in problem.bodies}
    plane = [q for q in slots.coordinates if q.name in ("x", "y")]
    if len(plane) == 2:
        places = {"": Vector((plane[0], plane[1], sp.S.Zero)), **places}
    rates = {name: place.fixed().map(slots.time_derivative) for name, place in places.items()}
    yield from ((rate, rate.as_sum()) for rate in rates.values())
    for a, b in combinations([p.name for p in problem.particles], 2):
        half = sp.Mul(sp.S.Half, VectorSymbol(f"r_{a}'") + VectorSymbol(f"r_{b}'"), evaluate=False)
        yield (rates[a] + rates[b]) * sp.S.Half, half


def _ratio(whole: sp.Expr, part: sp.Expr, slots: Slots) -> sp.Expr | None:
    """The constant by which two expressions in velocities differ, if it is one."""
    for v in slots.velocities:
        a, b = whole.diff(v), part.diff(v)
        if b != 0:
            if max(Sizes().of(a).size, Sizes().of(b).size) > LONGEST_CANCELLED:
                return None
            ratio = sp.cancel(a / b)
            return None if ratio == 0 or ratio.free_symbols & {*slots.coordinates, *slots.velocities, t} else ratio
    return None


# -- one coordinate, one constraint ----------------------------------------------------------------------------------


@record
class OnlyCoordinate:
    """The only coordinate as a function of time: x = v t − v/κ + C exp(−κ t), with a constant C."""

    coordinate: sp.Symbol
    constant: sp.Symbol
    value: sp.Expr


def only_coordinate(solution: Solution) -> OnlyCoordinate | None:
    """The only coordinate where one integrable constraint determines it, and is linear in it."""
    classification, coordinates = solution.classification, solution.problem.slots.coordinates
    if len(coordinates) != 1 or len(classification.integrals) != 1 or classification.degrees_of_freedom != 0:
        return None
    [q], [(_, function)] = coordinates, classification.integrals
    factor = function.diff(q)
    if factor == 0 or factor.has(q) or function.is_Symbol:
        return None
    constant = sp.Symbol(free_letter("C", "K", "c", taken={*solution.problem.scope.names()}), real=True)
    rest = sp.expand(-function.xreplace({q: sp.S.Zero}) / factor)
    size, moving = factor.as_independent(t, as_Add=False)
    value = rest + constant / moving if size.free_symbols else rest + constant / factor
    return OnlyCoordinate(q, constant, sp.powsimp(value))


def is_drive(reaction: Reaction) -> bool:
    """Whether a constraint gives one angle as a function of time, φ = Ω t: its reaction is the moment of a motor."""
    moving = [c for c in reaction.row.coefficients if c != 0]
    if len(moving) != 1 or reaction.row.drift == 0:
        return False
    directions = [d.fixed() for d in (reaction.directions or {}).values()]
    return any(textbook_form(d.dot(d)).free_symbols for d in directions)


# Free displacements


@record
class FreeDisplacements:
    """All displacements that satisfy the conditions, by the free ones.

    values  of the dependent displacements, and of the one for which the parameter stands, by coordinate
    free    the parameter δs, and the other free displacements
    pivots  what must differ from zero for these to be all solutions
    """

    values: Mapping[sp.Symbol, sp.Expr]
    free: tuple[sp.Symbol, ...]
    pivots: tuple[sp.Expr, ...]


def free_displacements(elimination: Elimination, slots: Slots, taken: Collection[str]) -> FreeDisplacements | None:
    """The displacements by a parameter, whose letter is not `taken`; None if not one of the free ones is divided."""
    sizes = Sizes()
    if any(
        sizes.of(e).size > LONGEST_CANCELLED or _is_fraction_of_many(e, sizes)
        for row in elimination.solution
        for e in row
    ):
        return None
    columns = [[*map(in_sines, column)] for column in zip(*elimination.solution, strict=True)]
    divided = [k for k, column in enumerate(columns) if any(_may_be_infinite(e, elimination) for e in column)]
    if len(divided) != 1:
        return None
    [k] = divided
    below = sp.lcm_list([sp.fraction(sp.together(e))[1] for e in columns[k]])
    factors = {
        slots.coordinates[d]: sp.cancel(e * below) for d, e in zip(elimination.dependent, columns[k], strict=True)
    }
    factors[slots.coordinates[elimination.independent[k]]] = below
    common = _common(list(factors.values()), slots)
    if common is None:
        return None
    factors = {q: _shorter(sp.cancel(e / common)) for q, e in factors.items()}
    moving = {*slots.coordinates, *slots.prescribed, t}
    pivots = [f for f in sp.Mul.make_args(sp.factor(common)) if f.free_symbols & moving]
    s = variation(sp.Symbol(free_letter("s", "u", "sigma", "w", taken=taken), real=True))
    rest = [n for n in range(len(columns)) if n != k]
    values = {}
    for n, q in enumerate(slots.coordinates):
        if q not in factors:
            continue
        values[q] = factors[q] * s
        if n in elimination.dependent:
            row = elimination.solution[elimination.dependent.index(n)]
            values[q] += sp.Add(*(row[m] * variation(slots.coordinates[elimination.independent[m]]) for m in rest))
    free = [slots.coordinates[elimination.independent[m]] for m in rest]
    values, free = _by_headings(values, free, slots)
    return FreeDisplacements(values, (s, *map(variation, free)), tuple(pivots))


def _by_headings(
    values: Mapping[sp.Symbol, sp.Expr], free: Sequence[sp.Symbol], slots: Slots
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Symbol]]:
    """The same with a coordinate that coefficients depend on as the free one: δθ of an axle, not δφ of a wheel."""
    chosen, left = dict(values), list(free)
    headings = {q for e in chosen.values() for q in e.free_symbols & set(slots.coordinates)}
    for n, old in enumerate(left):
        new = next((q for q, e in chosen.items() if q in headings and e.coeff(variation(old)).is_nonzero), None)
        if old in headings or new is None:
            continue
        share = chosen[new].coeff(variation(old))
        if share.free_symbols & {*slots.coordinates, *slots.prescribed, t}:
            continue
        solved = sp.expand((variation(new) - chosen[new]) / share + variation(old))
        rows = {q: e.xreplace({variation(old): solved}) for q, e in chosen.items() if q != new} | {old: solved}
        chosen = {q: textbook_form(sp.expand(rows[q])) for q in slots.coordinates if q in rows}
        left[n] = new
    return chosen, left


def _is_fraction_of_many(e: sp.Expr, sizes: Sizes) -> bool:
    """Whether its denominators have many terms when they are multiplied out: twenty sums of two have a million."""
    return sizes.of(sp.Mul(*(p.base for p in e.atoms(sp.Pow) if p.exp.is_negative))).widest > MOST_EXPANDED_TERMS


def _shorter(e: sp.Expr) -> sp.Expr:
    return min(e, shortest_form(e), key=lambda x: count_operations(x))


def _common(entries: Sequence[sp.Expr], slots: Slots) -> sp.Expr | None:
    """What the entries have to be divided by for those without parameters to have squares that add up to 1."""
    varying = {*slots.coordinates, *slots.prescribed, t}
    for common in (sp.S.One, *(sp.gcd(a, b) for a, b in combinations(entries, 2))):
        divided = [sp.cancel(e / common) for e in entries]
        lengths = [e for e in divided if all(s in varying or e.has(t) for s in e.free_symbols)]
        if len(lengths) > 1 and textbook_form(sp.Add(*(e**2 for e in lengths))) == 1:
            return common
    return None


def _may_be_infinite(e: sp.Expr, elimination: Elimination) -> bool:
    """Whether it has a denominator that one of the pivots makes vanish."""
    below = sp.fraction(sp.together(e))[1]
    return any(sp.fraction(sp.cancel(below / in_sines(p)))[1] == 1 for p in elimination.pivots)
