"""What a result says: rest and small motion, limits, the part of a reaction that rest explains, the units of a term.

*Limits.* An equation of motion E(q, q', q'', p) = 0 is polynomial in its parameters once denominators are cleared. At
p = 0 it stays the equation of the system if its accelerations are still determined, that is, if the matrix ∂E/∂q'' is
regular there. For p -> oo the same is asked of the leading coefficients in p, and equal parameters are substituted.
Only limits that leave less to read are kept. Of a reaction the limit at p = 0 is its value there, where it has one.

*At rest and in motion.* A reaction R(q, q') that does not vanish at q' = 0 is R(q, 0) + (R(q, q') - R(q, 0)): the value
that statics gives, and what the motion adds. To take the first for the whole is the commonest slip.

*Units.* The dimension of each term of an equation, where the file gives all units; they must be the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, kept_surface
from lagrange.algebra.fourier.textbook_form import common_factor, textbook_form
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, partial, t
from lagrange.core.units import NO_DIMENSION, unit_of_dimension
from lagrange.mechanics.circular_motion import Turning, turning
from lagrange.mechanics.consequences.gathered import Consequences, consequences
from lagrange.mechanics.dynamics.equations import WithEliminatedRates
from lagrange.mechanics.limits import (
    LONGEST_LIMIT,
    LONGEST_PART,
    LONGEST_WITH_LIMITS,
    LONGEST_WITH_UNITS,
    MOST_LIMITS,
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
class LimitingCase:
    """The equations of motion where a parameter vanishes, grows, or equals another; `to` is 0, oo or the other.

    reactions  the values of the reactions there that have the parameter, by symbol; none for a growing parameter
    """

    parameter: sp.Symbol
    to: sp.Expr
    equations: tuple[sp.Expr, ...]
    reactions: Mapping[sp.Symbol, sp.Expr]


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

    small  rest and small motion of one degree of freedom
    terms  two terms of the first equation of motion, and the unit that all of its terms have
    constant  the accelerations, where all of them are constant; those that are, under a nonlinear constraint
    turning   two coordinates that run on a circle, or whose oscillation turns
    freed     the equations of motion without the coordinates whose velocities constraints give
    consequences  constant vectors, limits in time, beats, resonances
    ends      up to which velocity contact lasts
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


def meaning(solution: Solution) -> ResultMeaning | None:
    """What the result says in the first choice of coordinates, or the file's own; None without equations of motion."""
    view = solution.chosen
    if view.motion is None or view.dynamics is None or not view.motion.final:
        return None
    reactions = _reactions(solution, view)
    return ResultMeaning(
        view,
        _small(solution, view),
        tuple(_limits(solution, view, reactions)),
        tuple(_parts(view, reactions)),
        _units(solution, view),
        constant_accelerations(view),
        turning(view),
        without_given_rates(view),
        consequences(solution, view),
        tuple(_ends(solution, view, reactions)),
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
    if stated or motion is None or view.signs or motion.configuration.rows or len(motion.equations) != 1:
        return None
    if any(m.has_one_sense and not m.velocity.is_zero for m in motion.configuration.variable_masses):
        return None
    [equation] = motion.expressions
    if equation.has(Unspecified) or count_operations(equation) > LONGEST_WITH_LIMITS:
        return None
    from lagrange.mechanics.equilibrium.linearization import linearization

    problem = solution.problem
    taken = frozenset({*problem.scope.names(), *(q.name for c in problem.choices for q in c.coordinates)})
    try:
        small = linearization(motion, taken)
    except NotCoveredError:
        return None
    if not small.complete:
        return None
    here = [k for k, b in enumerate(small.branches) if not _is_let_go(solution, view, b)]
    small = replace(small, branches=tuple(small.branches[k] for k in here), at=tuple(small.at[k] for k in here))
    return small if small.branches else None


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


# -- limits ------------------------------------------------------------------------------------------------------------


def _limits(solution: Solution, view: InCoordinates, reactions: Mapping[sp.Symbol, sp.Expr]) -> Iterator[LimitingCase]:
    motion = view.motion
    assert motion is not None
    equations = tuple(e.expression for e in motion.final)
    if (
        motion.completing
        or sum(count_operations(e) for e in equations) > LONGEST_WITH_LIMITS
        or _has_functions(equations)
    ):
        return
    free = {p.symbol for p in solution.problem.parameters if p.value is None and p.symbol.is_positive}
    free -= {s for m in view.configuration.variable_masses for s in m.mass.free_symbols}
    symbols = sorted(free & {s for e in equations for s in e.free_symbols}, key=str)
    limits: list[tuple[sp.Expr, ...]] = []
    by_unit = {u: [p.symbol for p in solution.problem.parameters if p.unit == u] for u in ("m", "kg", "m/s")}
    # A pendulum of no length is none, and nothing moves without mass; a velocity as of light is large, not small.
    kept = {*by_unit["m"], *by_unit["m/s"], *(by_unit["kg"] if len(by_unit["kg"]) == 1 else ())}
    fast = [s for s in symbols if s in by_unit["m/s"]]
    pushing, constants = _pushing(solution), {p.symbol for p in solution.problem.parameters}
    for parameter, to in (*((s, sp.oo) for s in fast), *_candidates(symbols, len(equations) > 1)):
        if to == 0 and parameter in kept:
            continue
        limit = _limit(equations, parameter, to, view)
        if limit is None or limit in limits:
            continue
        if to == sp.oo and not any(e.free_symbols & constants for e in limit):
            continue  # of what the problem is about nothing is left
        if to == sp.oo and _only_stops(limit, equations, view):
            continue  # what is very heavy is not accelerated: trivial
        values = (
            {}
            if to == sp.oo
            else {s: _at(e, parameter, to) for s, e in reactions.items() if parameter in e.free_symbols}
        )
        if any(s in pushing and e is not None and e.is_nonpositive for s, e in values.items()):
            continue  # contact is lost
        shown = {s: e for s, e in values.items() if e is not None and count_operations(e) <= LONGEST_LIMIT}
        still = all(e in view.configuration.slots.accelerations for e in limit)
        if to == 0 and still and shown and not any(shown.values()):
            continue  # nor that nothing happens without a cause
        whole = len(shown) == len(values) and sum(count_operations(e) for e in shown.values()) <= LONGEST_LIMIT
        if to == 0 and len(limit) > 1 and not (shown and whole) and _only_stops(limit, equations, view):
            continue  # nor that without forces there is no acceleration
        yield LimitingCase(parameter, to, limit, shown if whole else {})
        limits.append(limit)
        if len(limits) == MOST_LIMITS:
            return


def _pushing(solution: Solution) -> set[sp.Symbol]:
    """The forces that are positive as long as there is contact."""
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


def _has_functions(equations: Sequence[sp.Expr]) -> bool:
    return any(e.has(Unspecified) for e in equations)


def _candidates(symbols: Sequence[sp.Symbol], coupled: bool) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """Each parameter to zero; those of one letter equal; each to infinity."""
    yield from ((s, sp.S.Zero) for s in symbols)
    for n, a in enumerate(symbols):
        for b in symbols[n + 1 :]:
            if a.name.rstrip("0123456789_") == b.name.rstrip("0123456789_"):
                yield b, a
    if coupled:  # of a single equation it would leave no more than its leading term
        yield from ((s, sp.oo) for s in symbols)


def _limit(
    equations: Sequence[sp.Expr], parameter: sp.Symbol, to: sp.Expr, view: InCoordinates
) -> tuple[sp.Expr, ...] | None:
    """The equations in the limit; None if they do not become much simpler, or do not determine the motion."""
    accelerations = view.configuration.slots.accelerations
    try:
        there = [_leading(e, parameter) if to == sp.oo else e.xreplace({parameter: to}) for e in equations]
    except TypeError:  # SymPy compares what is undefined, as in sinh(x/a) for a → 0
        return None
    if any(e is None or e == 0 or e.has(sp.zoo, sp.nan, sp.oo) for e in there) or not _occur(accelerations, there):
        return None  # one that occurs nowhere is not determined
    shorter = [_without_common_factor(textbook_form(e)) for e in there if e is not None]
    shorter = _with_zeros(shorter, accelerations)
    before, after = (sum(count_operations(e) for e in es) for es in (equations, shorter))
    if 3 * after > 2 * before or any(count_operations(e) > LONGEST_LIMIT for e in shorter):
        return None
    try:
        regular = kept_surface().rank([[partial(e, a) for a in accelerations] for e in shorter]) == len(accelerations)
    except DivisionByZeroError:
        return None
    return tuple(shorter) if regular else None


def _only_stops(limit: Sequence[sp.Expr], equations: Sequence[sp.Expr], view: InCoordinates) -> bool:
    """Whether every equation affected by the limit now says only that an acceleration is zero."""
    changed = [e for e in limit if not any(sp.expand(e - f) == 0 for f in equations)]
    return all(e in view.configuration.slots.accelerations for e in changed)


def _with_zeros(equations: Sequence[sp.Expr], accelerations: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """The equations with the accelerations substituted that one of them says are zero."""
    zero = {e: sp.S.Zero for e in equations if e in accelerations}
    return [e if e in zero else textbook_form(e.xreplace(zero)) for e in equations] if zero else [*equations]


def _occur(symbols: Sequence[sp.Symbol], expressions: Sequence[sp.Expr]) -> bool:
    return set(symbols) <= {s for e in expressions for s in e.free_symbols}


def _without_common_factor(e: sp.Expr) -> sp.Expr:
    factor = common_factor(e)
    return e if factor.expression == 1 else textbook_form(factor.divide(e))


def _leading(e: sp.Expr, parameter: sp.Symbol) -> sp.Expr | None:
    """The coefficient of the highest power of a parameter; None if the expression is no polynomial in it."""
    by_power: dict[int, list[sp.Expr]] = {}
    for term in sp.Add.make_args(_expanded(e)):
        coefficient, power = term.as_independent(parameter, as_Add=False)
        base, exponent = power.as_base_exp() if power != 1 else (parameter, sp.S.Zero)
        if base != parameter or not exponent.is_Integer or exponent < 0:
            return None
        by_power.setdefault(int(exponent), []).append(coefficient)
    highest = max(by_power)
    return sp.Add(*by_power[highest]) if highest else e


@lru_cache(maxsize=16)
def _expanded(e: sp.Expr) -> sp.Expr:
    return sp.expand(e)


def _at(e: sp.Expr, parameter: sp.Symbol, to: sp.Expr) -> sp.Expr | None:
    value = e.xreplace({parameter: to})
    return None if value.has(sp.nan, sp.zoo, sp.oo) else textbook_form(value)


# -- parts and units -----------------------------------------------------------------------------------------------


def _parts(view: InCoordinates, reactions: Mapping[sp.Symbol, sp.Expr]) -> Iterator[Parts]:
    configuration = view.configuration
    at_rest = dict.fromkeys(configuration.slots.velocities, sp.S.Zero)
    driven = any(not p.position.frozen_derivative(configuration.slots).is_zero for p in configuration.points)
    if driven or any(r.drift != 0 for r in configuration.rows):
        return  # at rest is nothing there
    for force, value in reactions.items():
        if (
            t in value.free_symbols
            or _has_functions([value])
            or any(a in value.free_symbols for a in view.configuration.slots.accelerations)
        ):
            continue
        static = textbook_form(value.xreplace(at_rest))
        if static == 0 or count_operations(static) > LONGEST_PART:
            continue
        added = textbook_form(value - static)
        if added != 0 and count_operations(added) <= LONGEST_PART:
            yield Parts(force, static, added)


def _units(solution: Solution, view: InCoordinates) -> tuple[sp.Expr, sp.Expr, str] | None:
    problem, motion = solution.problem, view.motion
    assert motion is not None
    units = {q.symbol: q.unit for q in problem.coordinates} | {p.symbol: p.unit for p in problem.parameters}
    known = dimensions_of_units(units)
    equation = motion.final[0].expression
    if not known or count_operations(equation) > LONGEST_WITH_UNITS:
        return None
    terms = sp.Add.make_args(_expanded(equation))
    angles = {q for q in view.configuration.slots.coordinates if q not in known and _is_angle(q, terms)}
    known |= dict.fromkeys(angles, NO_DIMENSION)
    dimensions = {dimension(term, known) for term in terms}
    if len(terms) < 2 or len(dimensions) != 1 or None in dimensions:
        return None
    [one] = dimensions
    first, *others = sorted(
        terms, key=lambda e: (not e.free_symbols & {*view.configuration.slots.accelerations}, str(e))
    )
    first, other = (-e if e.could_extract_minus_sign() else e for e in (first, others[-1]))
    return (first, other, unit_of_dimension(one)) if one is not None and one != NO_DIMENSION else None


def _is_angle(q: sp.Symbol, terms: Sequence[sp.Expr]) -> bool:
    return any(q in w.free_symbols for term in terms for w in term.atoms(sp.sin, sp.cos, sp.tan))
