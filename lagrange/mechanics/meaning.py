"""What a result says: rest and small motion, the part of a reaction that rest explains, the units of a term.

*At rest and in motion.* A reaction R(q, q') that does not vanish at q' = 0 is R(q, 0) + (R(q, q') - R(q, 0)). To take
the first for the whole is the commonest slip, but only where the first is what the balance of forces gives on a
particle that this reaction alone holds in its direction: m g cos θ of a pendulum. The force of the wall on a ladder
that begins to slide is none that anybody would take from statics.

*Units.* The dimension of each term of the equations, where the file gives all units; all of them must be the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.effort import within
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, t
from lagrange.core.units import NO_DIMENSION, unit_of_dimension
from lagrange.mechanics.circular_motion import Turning, turning
from lagrange.mechanics.consequences.course import Released, Sense, released, sense
from lagrange.mechanics.consequences.gathered import Consequences, consequences
from lagrange.mechanics.consequences.limiting_cases import (
    LimitingCase,
    MasslessBodies,
    limiting_cases,
    massless_bodies,
)
from lagrange.mechanics.dynamics.equations import WithEliminatedRates
from lagrange.mechanics.limits import (
    HIGHEST_POWER_OF_UNIT,
    LONGEST_PART,
    LONGEST_WITH_LIMITS,
    LONGEST_WITH_UNITS,
    MOST_AT_REST,
    MOST_LETTERS_AT_REST,
    UNITS_AT_REST,
)
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations
from lagrange.mechanics.rewriting.held_coordinates import without_given_rates
from lagrange.problem.model import Friction, Keeper
from lagrange.values.dimensions import dimension, dimensions_of_units

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.solution_sets import Branch
    from lagrange.mechanics.equilibrium.linearization import Linearization


@record
class Parts:
    """A reaction as it is at rest in the same position, and what the motion adds."""

    force: sp.Symbol
    at_rest: sp.Expr
    added: sp.Expr


@record
class ContactEnds:
    """The force that keeps contact is positive while velocity² `relation` square; < or >."""

    force: sp.Symbol
    velocity: sp.Symbol
    relation: str
    square: sp.Expr


@record
class ResultMeaning:
    """What the result says in one set of coordinates.

    small  rest and small motion of one or two degrees of freedom; of one motion asked about, only where it begins
    terms  two terms of the first equation of motion, g/l like θ'', and the unit that all of its terms have
    constant  the accelerations, where all of them are constant; those that are, under a nonlinear constraint
    turning   two coordinates that run on a circle, or whose oscillation turns
    freed     the equations of motion without the coordinates whose velocities constraints give
    consequences  constant vectors, limits in time, beats, resonances
    ends      up to which velocity contact lasts
    massless  the constant accelerations if the bodies that turn have no inertia
    sense     whether what slides speeds up or stops
    released  where a system released from rest loses contact
    """

    view: InCoordinates
    small: Linearization | None
    limits: tuple[LimitingCase, ...]
    parts: tuple[Parts, ...]
    terms: tuple[sp.Expr, sp.Expr, str] | None
    constant: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    turning: Turning | None = None
    freed: WithEliminatedRates | None = None
    consequences: Consequences | None = None
    ends: tuple[ContactEnds, ...] = ()
    massless: MasslessBodies | None = None
    sense: Sense | None = None
    released: tuple[Released, ...] = ()


def meaning(solution: Solution) -> ResultMeaning | None:
    """What the result says in the first choice of coordinates, or the file's own; None without equations of motion."""
    view = solution.chosen
    if view.motion is None or view.dynamics is None or not view.motion.final:
        return None
    reactions, constant = _reactions(solution, view), constant_accelerations(view)
    pushing = _pushing(solution)
    return ResultMeaning(
        view,
        _small(solution, view),
        () if solution.problem.questions else tuple(limiting_cases(solution, view, reactions, pushing)),
        tuple(_parts(solution, view, reactions)),
        _units(solution, view),
        constant,
        turning(view),
        without_given_rates(view),
        consequences(solution, view),
        tuple(_ends(solution, view, reactions)),
        massless_bodies(solution, view, constant),
        sense(solution, view),
        tuple(released(solution, view, reactions, pushing)),
    )


def _reactions(solution: Solution, view: InCoordinates) -> dict[sp.Symbol, sp.Expr]:
    """The single forces and other multipliers, by symbol."""
    known = None if view.dynamics is None else view.dynamics.reactions
    if known is None or solution.law is None:
        return {}
    values = {r.symbol_of_force: known.sizes.get(r.name) for r in solution.law.newton.reactions if r.symbol_of_force}
    return {s: v for s, v in values.items() if s is not None and v is not None}


# -- rest and small motion -------------------------------------------------------------------------------------------


def _small(solution: Solution, view: InCoordinates) -> Linearization | None:
    motion = view.motion
    stated = view.linearization is not None or view.equilibrium is not None
    if stated or motion is None or view.signs or motion.configuration.rows or len(motion.equations) > MOST_AT_REST:
        return None
    start = {v.symbol: v.value for v in solution.problem.initial}
    about_one = bool(start and solution.problem.questions)
    if start and (
        len(motion.equations) > 1 or (about_one and any(start.get(v) != 0 for v in view.configuration.slots.velocities))
    ):
        return None  # it is about one motion, which does not begin at rest
    if any(m.has_one_sense and not m.velocity.is_zero for m in motion.configuration.variable_masses):
        return None
    equations = motion.expressions
    if any(e.has(Unspecified) for e in equations) or sum(map(count_operations, equations)) > LONGEST_WITH_LIMITS:
        return None
    if len(equations) > 1:
        letters = {s for e in equations for s in e.free_symbols} & {p.symbol for p in solution.problem.parameters}
        if len(letters) > MOST_LETTERS_AT_REST or any(e.has(t) for e in equations):
            return None
    from lagrange.mechanics.equilibrium.linearization import linearization

    problem = solution.problem
    taken = frozenset({*problem.scope.names(), *(q.name for c in problem.choices for q in c.coordinates)})
    try:
        small = within(UNITS_AT_REST, lambda: linearization(motion, taken))
    except NotCoveredError:
        return None
    if small is None or not small.complete:
        return None
    here = [k for k, b in enumerate(small.branches) if not (_is_let_go(solution, view, b) or _is_at_end(view, b))]
    if about_one:  # the equilibrium in which the motion begins, if it does
        here = [k for k in here if all(start.get(r.lhs) == r.rhs for r in small.branches[k].relations)]
    small = replace(small, branches=tuple(small.branches[k] for k in here), at=tuple(small.at[k] for k in here))
    return small if small.branches else None


def _is_at_end(view: InCoordinates, place: Branch) -> bool:
    """Whether the coordinate is at an end of its range, from which it can only move one way."""
    ranges = view.configuration.ranges
    ends = ((r.lhs, r.rhs, ranges[r.lhs]) for r in place.relations if r.lhs in ranges)
    return any(is_zero(value - end) is True for _, value, span in ends for end in (span.low, span.high))


def _is_let_go(solution: Solution, view: InCoordinates, place: Branch) -> bool:
    """Whether what can only push, or only pull, would have to do the opposite to keep the system at rest there.

    A surface without a permitted side pushes as it does in the initial state.
    """
    reactions = None if view.dynamics is None else view.dynamics.reactions
    slots = view.configuration.slots
    if reactions is None or len(place.relations) != 1 or place.relations[0].lhs not in slots.coordinates:
        return False
    still = dict.fromkeys(slots.velocities, sp.S.Zero)
    there = {**still, place.relations[0].lhs: place.relations[0].rhs}
    by = {c.name: c.by for c in solution.problem.constraints}
    known = {**reactions.contacts, **{n: e for n, e in reactions.tensions.items() if by.get(n) is Keeper.STRING}}
    start = {v.symbol: v.value for v in solution.problem.initial}
    for name, size in reactions.sizes.items():
        if by.get(name) is Keeper.SURFACE and name not in known and {*slots.coordinates} <= {*start}:
            known[name] = size * size.xreplace({**still, **{q: start[q] for q in slots.coordinates}})
    return any(e.xreplace(there).is_negative is True for e in known.values())


# -- contact -----------------------------------------------------------------------------------------------------------


def _pushing(solution: Solution) -> set[sp.Symbol]:
    """The forces that are positive as long as there is contact, or a string is taut."""
    if solution.law is None:
        return set()
    rough = {f.constraint for f in solution.problem.forces if isinstance(f, Friction) and f.contact is not None}
    return {
        r.symbol_of_force
        for r in solution.law.newton.reactions
        if r.symbol_of_force is not None and (r.name in rough or r.constraint.side is not None)
    }


def _ends(solution: Solution, view: InCoordinates, reactions: Mapping[sp.Symbol, sp.Expr]) -> Iterator[ContactEnds]:
    """For one coordinate, of forces a + b q'^2 with b of one sign that no question of the file is about."""
    slots = view.configuration.slots
    if len(slots.coordinates) != 1 or view.signs or slots.prescribed:
        return
    [v] = slots.velocities
    asked = {s for q in solution.problem.questions for c in q.when for s in (c.lhs - c.rhs).free_symbols}
    for force in sorted(_pushing(solution) & {*reactions} - asked, key=str):
        value = sp.expand(reactions[force])
        factor = value.coeff(v, 2)
        rest = sp.expand(value - factor * v**2)
        if rest.free_symbols & {v, t, *slots.accelerations} or not (factor.is_positive or factor.is_negative):
            continue
        square = textbook_form(sp.cancel(-rest / factor))
        if count_operations(square) <= LONGEST_PART and not square.is_nonpositive:
            yield ContactEnds(force, v, ">" if factor.is_positive else "<", square)


# -- parts and units -----------------------------------------------------------------------------------------------


def _parts(solution: Solution, view: InCoordinates, reactions: Mapping[sp.Symbol, sp.Expr]) -> Iterator[Parts]:
    configuration = view.configuration
    at_rest = dict.fromkeys(configuration.slots.velocities, sp.S.Zero)
    driven = any(not p.position.frozen_derivative(configuration.slots).is_zero for p in configuration.points)
    if driven or any(r.drift != 0 for r in configuration.rows):
        return  # at rest is nothing there
    for force, value in reactions.items():
        if (
            t in value.free_symbols
            or value.has(Unspecified)
            or any(a in value.free_symbols for a in view.configuration.slots.accelerations)
        ):
            continue
        static = textbook_form(value.xreplace(at_rest))
        if static == 0 or count_operations(static) > LONGEST_PART:
            continue
        added = textbook_form(value - static)
        if added != 0 and count_operations(added) <= LONGEST_PART and _balances(solution, view, force, static):
            yield Parts(force, static, added)


def _balances(solution: Solution, view: InCoordinates, force: sp.Symbol, static: sp.Expr) -> bool:
    """Whether this value is minus the applied force along the reaction, on one particle that nothing else holds so."""
    assert solution.law is not None
    newton = solution.law.newton
    for body in newton.bodies or ():
        directions = [(r, d) for r, d in body.reactions if r.symbol_of_force == force]
        if len(newton.bodies or ()) != 1 or len(directions) != 1 or body.turning:
            continue
        [(reaction, _)] = directions
        single = reaction.single
        along = None if single is None else single.direction
        others = [d for r, d in body.reactions if r is not reaction]
        if along is None or any(along.dot(d) != 0 for d in others):
            continue
        still = dict.fromkeys(view.configuration.slots.velocities, sp.S.Zero)
        share = (body.applied.dot(along) + static).xreplace(dict(view.configuration.expressed)).xreplace(still)
        if is_zero(share, view.configuration.surface) is True:
            return True
    return False


def _units(solution: Solution, view: InCoordinates) -> tuple[sp.Expr, sp.Expr, str] | None:
    """Two terms of the first equation as it is printed, and the unit of all terms of all equations."""
    problem, motion = solution.problem, view.motion
    assert motion is not None
    units = {q.symbol: q.unit for q in problem.coordinates} | {p.symbol: p.unit for p in problem.parameters}
    known = dimensions_of_units(units)
    equations = [e.expression for e in motion.final]
    in_speeds = view.in_speeds is not None and view.in_speeds.equations is not None  # others are on the page
    if not known or in_speeds or sum(map(count_operations, equations)) > LONGEST_WITH_UNITS:
        return None
    every = [term for e in equations for term in sp.Add.make_args(sp.expand(e))]
    angles = {q for q in view.configuration.slots.coordinates if q not in known and _is_angle(q, every)}
    known |= dict.fromkeys(angles, NO_DIMENSION)
    dimensions = {dimension(term, known) for term in every}
    terms = sp.Add.make_args(equations[0])
    if len(terms) < 2 or len(dimensions) != 1 or None in dimensions:
        return None
    [one] = dimensions
    if one is None or one == NO_DIMENSION or any(abs(power) > HIGHEST_POWER_OF_UNIT for power in one):
        return None  # kg m⁴/s⁵ is no unit in which anybody checks an equation
    accelerations = {*view.configuration.slots.accelerations}
    first, *others = sorted(terms, key=lambda e: (not e.free_symbols & accelerations, str(e)))
    if not first.free_symbols & accelerations or others[-1].free_symbols & accelerations:
        return None
    first, other = (-e if e.could_extract_minus_sign() else e for e in (first, others[-1]))
    [q] = first.free_symbols & accelerations if len(equations) == 1 else {first}
    factor = sp.cancel(first / q)
    of_factor = dimension(factor, known)
    if of_factor is not None and not factor.free_symbols & {*view.configuration.slots.coordinates, q}:
        first, other = q, other / factor  # θ'' + (g/l) sin θ = 0, as at the head of the page
        one = tuple(a - b for a, b in zip(one, of_factor, strict=True))
    if first not in accelerations or sp.fraction(other)[1] == 1:
        return None  # m s'' and m g sin θ, s'' and g sin θ: seen at a glance
    return first, other, unit_of_dimension(one)


def _is_angle(q: sp.Symbol, terms: Sequence[sp.Expr]) -> bool:
    return any(q in w.free_symbols for term in terms for w in term.atoms(sp.sin, sp.cos, sp.tan))
