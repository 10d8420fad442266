"""Conditions on a problem of statics, and the checks of equilibria and small oscillations by a second route.

Equilibrium requires a system at rest with fixed constraints: forces that depend on velocity or time are refused by
name.

    Lagrange's generalized forces    −(d/dt ∂T/∂q' − ∂T/∂q − Q) at rest, from T, V and F, against the virtual work
    substitution                     every equilibrium substituted back into the equations that it solves, exactly; and
                                     positions sampled from what is stated into the forces before any step
                                     (`stated_equilibria`)
    reactions                        substituted into Lagrange's equations at rest, in the file's coordinates
    coordinates                      at every equilibrium of a choice, Q = −Aᵀ λ in the file's coordinates, by ranks
    linear equations                 M, D, K from Lagrange's equations, differentiated and taken at each equilibrium
    modes                            substituted: (K − ω² M) a = 0
    orthogonality                    aᵀ M b = 0 for modes of different frequencies, where K is symmetric
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import assert_never

import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import Matrix
from lagrange.algebra.closed_forms.single_equation import Relation, Values
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.records import all_hold
from lagrange.core.symbols import base, partial, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check, certainty
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, balance_in
from lagrange.mechanics.equilibrium.friction.impending_motion import ImpendingMotion
from lagrange.mechanics.equilibrium.limits import MOST_COMPARED_POINTS
from lagrange.mechanics.equilibrium.linearization import Linearization, SmallOscillations
from lagrange.mechanics.equilibrium.stated_equilibria import rests_on_decimals, stated_equilibria
from lagrange.mechanics.equilibrium.static_reactions import StaticReactions
from lagrange.problem.model import (
    AppliedForce,
    AppliedMoment,
    Belt,
    Damper,
    Find,
    Friction,
    GeneralizedForce,
    Potential,
    Problem,
    Spring,
)


def require_statics(problem: Problem, configuration: Configuration) -> None:
    """Refuse a problem that is not one of statics. Raises ProblemError with all reasons."""
    moves = not {*problem.find}.isdisjoint({Find.MOTION, Find.LINEARIZATION})
    mistakes = [*_forces(problem, moves), *_moving(problem, configuration)]
    if (
        not mistakes
        and not configuration.loads
        and not configuration.torques
        and configuration.potential == 0
        and (not configuration.generalized)
        and not any(isinstance(f, Belt) for f in problem.forces)
    ):
        help_ = "give forces, a potential, or gravity and masses"
        message = "no force acts, so every position is an equilibrium"
        mistakes.append(Diagnostic("no-forces", message, help=help_))
    if mistakes:
        raise ProblemError(mistakes)


def _forces(problem: Problem, moves: bool) -> Iterable[Diagnostic]:
    """The forces that depend on the motion."""
    for f in problem.forces:
        match f:
            case AppliedForce():
                parts = (*f.vector.components, *(f.at.components if f.at is not None else ()))
            case AppliedMoment():
                parts = f.moment.components
            case Potential():
                parts = (f.energy,)
            case GeneralizedForce():
                parts = tuple(f.components.values())
            case Spring():
                parts = (f.stiffness, f.length, *f.ends[0].components, *f.ends[1].components)
            case Damper() if moves:
                continue
            case Damper():
                message = f"the damper `{f.name}` exerts no force at rest"
                yield Diagnostic("force-of-motion", message, f.span, help="leave it out where equilibrium is asked")
                continue
            case Friction():
                continue  # refused before, by `solve`
            case Belt():
                parts = (f.angle, f.tight, f.slack)
            case unreachable:
                assert_never(unreachable)
        symbols = sorted({s for p in parts for s in p.free_symbols}, key=str)
        rates = [s for s in symbols if base(s) != s and base(s) not in problem.slots.prescribed]
        times = [s for s in symbols if s == t or base(s) in problem.slots.prescribed]
        if rates and not moves:
            message = f"the force `{f.name}` depends on the velocity `{rates[0]}`"
            help_ = "at rest velocities are zero: write what the force is at rest, or leave it out"
            yield Diagnostic("force-of-motion", message, f.span, help=help_)
        elif times:
            message = f"the force `{f.name}` depends on time, through `{times[0]}`"
            help_ = "a system is in equilibrium under forces that stay as they are: make it a parameter"
            yield Diagnostic("force-of-motion", message, f.span, help=help_)


_AT_REST_ON_IT = (
    "write `linearization` in place of `equilibrium`: it finds where the system rests relative to what moves; "
    "with a parameter in place of t nothing moves by itself"
)
_FORCE_OF_INERTIA = (
    "write positions without time, in axes that move along, and add the force of inertia under `forces`: "
    "`inertia: {on: P, vector: -m*a*i}`, or `m*Omega^2*r*e_r` where the axes turn"
)


def _moving(problem: Problem, configuration: Configuration) -> Iterable[Diagnostic]:
    """Constraints and positions that depend on time."""
    spans = {c.name: c.span for c in problem.constraints}
    rough = any(isinstance(f, Friction) for f in problem.forces)
    help_ = _FORCE_OF_INERTIA if rough else _AT_REST_ON_IT
    for row in configuration.rows:
        parts = (*row.coefficients, row.drift, row.finite or sp.S.Zero)
        if row.drift != 0 or any(_has_time(p, problem) for p in parts):
            message = f"the constraint `{row.name}` moves"
            yield Diagnostic("moving-constraint", message, spans.get(row.name), help=help_)
    for p in problem.masses:
        if any(_has_time(c, problem) for c in p.position.fixed().components):
            message = f"the position of `{p.name}` contains time"
            yield Diagnostic("moving-constraint", message, p.span, help=help_)


def _has_time(e: sp.Expr, problem: Problem) -> bool:
    return any(s == t or base(s) in problem.slots.prescribed for s in e.free_symbols)


def check_equilibrium(resting: Equilibrium, original: Equilibrium) -> list[Check]:
    """The checks of the equilibria of one configuration; `original` is in the file's coordinates."""
    name = resting.configuration.name
    how = f"{certainty(resting.configuration.surface)}, at random points"
    checks = [Check("Lagrange's equations have the same generalized forces at rest", _same_forces(resting), how, name)]
    tried = stated_equilibria(resting)
    solved = [resting.solution.verified] if any(not b.left for b in resting.branches) else []
    verdicts = [*solved, *(t.holds for t in tried)]
    if verdicts:
        words = "every equilibrium satisfies the conditions"
        how = "by substitution, exact or with 45 digits" if rests_on_decimals(tried) else "exact, by substitution"
        checks.append(Check(words, all_hold(verdicts), how, name))
    checks += check_search(resting)
    if resting is not original and resting.solution.solved and resting.branches:
        how = "exact, by ranks"
        checks.append(
            Check("the forces balance in the file's coordinates as well", _holds_there(resting, original), how, name)
        )
    return checks


def check_search(resting: Equilibrium) -> list[Check]:
    """The check of the list against a search in numbers, if there was one."""
    if resting.all_found is None:
        return []
    how = "Newton's method at drawn parameters"
    return [Check("no place of rest found in numbers is missing", resting.all_found, how, resting.configuration.name)]


def check_reactions_at_rest(reactions: StaticReactions | None) -> list[Check]:
    """The check of the reactions at the equilibria of one configuration, if there are any."""
    verdicts = [r.verified for r in (reactions.at if reactions is not None else ()) if r is not None]
    if reactions is None or not verdicts:
        return []
    passed = all_hold(verdicts)
    name = "the reactions satisfy Lagrange's equations at every equilibrium"
    return [Check(name, passed, "exact, by substitution", reactions.configuration.name)]


def _same_forces(resting: Equilibrium) -> bool | None:
    """Whether the virtual work has the same generalized forces as Lagrange's equations."""
    configuration = resting.configuration
    slots = configuration.slots
    at_rest = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    verdicts = [
        configuration.surface.is_zero(left.xreplace(at_rest) + force)
        for left, force in zip(lagrange_equations(configuration).left, resting.work.forces, strict=True)
    ]
    return all_hold(verdicts)


def _holds_there(resting: Equilibrium, original: Equilibrium) -> bool | None:
    """Whether the forces in the file's coordinates are balanced at every point of a choice."""
    return all_hold(balance_in(original, resting, p) for b in resting.branches if not b.special for p in b.points)


def check_impending(motions: Sequence[ImpendingMotion]) -> list[Check]:
    """The checks of the equilibria with friction at its limit, those of all directions of slip together.

    They are in the position that the constraints hold, which a branch need not state; there may be another one.
    """
    groups: dict[str, list[Check]] = {}
    for m in motions:
        place = tuple(Relation(q, v) for q, v in m.place.items())
        branches = tuple(replace(b, relations=(*b.relations, *(r for r in place if r not in b.relations)))
                         for b in m.equilibrium.branches)  # fmt: skip
        e = replace(m.equilibrium, branches=branches)
        for check in check_equilibrium(e, e):
            groups.setdefault(check.name, []).append(check)
    return [replace(group[0], passed=all_hold(c.passed for c in group)) for group in groups.values()]


def check_linearization(linear: Linearization) -> list[Check]:
    """The checks of one set of coordinates."""
    name = linear.configuration.name
    checks = check_search(linear.equilibrium)
    tried = stated_equilibria(replace(linear.equilibrium, branches=linear.branches))
    if tried:
        how = f"{'with 45 digits' if rests_on_decimals(tried) else 'exact'}, at positions sampled from what is stated"
        holds = all_hold(t.holds for t in tried)
        checks.append(Check("every position of rest satisfies the equations of motion", holds, how, name))
    if any(s is not None for s in linear.at):
        passed = all_hold(_same_equations(linear))
        how = "exact: differentiated at each equilibrium"
        checks.append(Check("Lagrange's equations give the same linear equations", passed, how, name))
    modes = [v for s in linear.at if s is not None for v in _modes_hold(s)]
    if modes:
        checks.append(Check("the modes satisfy the linear equations", all_hold(modes), "exact, by substitution", name))
    right = [v for s in linear.at if s is not None and s.system.symmetric for v in _orthogonal(s)]
    if right:
        how = "exact: aᵀ M b = 0"
        checks.append(Check("modes of different frequencies are orthogonal", all_hold(right), how, name))
    return checks


def _same_equations(linear: Linearization) -> Iterator[bool | None]:
    """Whether Nᵀ M N, Nᵀ D N, Nᵀ K N of Lagrange's equations are the matrices of `linear`, entry by entry."""
    configuration = linear.configuration
    slots = configuration.slots
    rows = [r for r in configuration.rows if not r.is_identity]
    multipliers = linear.equilibrium.multipliers
    left = [
        e - sp.Add(*(m * r.coefficients[k] for m, r in zip(multipliers, rows, strict=True)))
        for k, e in enumerate(lagrange_equations(configuration).left)
    ]
    at_rest = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    # Where no velocity or acceleration is differentiated by, it is put to zero before, which leaves few terms.
    still = [e.xreplace(at_rest) for e in left]
    slow = [e.xreplace(dict.fromkeys(slots.accelerations, sp.S.Zero)) for e in left]
    tables = [
        sp.Matrix([[partial(e, s).xreplace(at_rest) for s in symbols] for e in expressions])
        for symbols, expressions in ((slots.accelerations, left), (slots.velocities, slow), (slots.coordinates, still))
    ]
    for b, s in zip(linear.branches, linear.at, strict=True):
        if s is None:
            continue
        n = sp.Matrix(s.shape)
        stated = {q: b.common[q] for q in slots.coordinates if q in b.common}
        pairs = zip(tables, (s.system.mass, s.system.damping, s.system.stiffness), strict=True)
        differences = dict.fromkeys(e for table, matrix in pairs for e in n.T * table * n - sp.Matrix(matrix))
        for point in ({**stated, **p} for p in b.points[:MOST_COMPARED_POINTS]):
            yield from (_is_zero_at(linear, b, point, e) for e in differences)


def _is_zero_at(linear: Linearization, b: Branch, point: Values, e: sp.Expr) -> bool | None:
    """Whether an expression is zero at a point; by plain values if it has other angles than the conditions."""
    try:
        try:
            value = linear.equilibrium.solution.at(point, e)
        except NotAlgebraicError:
            plain = {r.lhs: r.rhs for r in b.relations if r.lhs in linear.configuration.slots.coordinates}
            value = e.xreplace({m: point[m] for m in linear.equilibrium.multipliers if m in point}).xreplace(plain)
            if value.free_symbols & set(linear.configuration.slots.coordinates):
                return None
        return is_zero(value)
    except DivisionByZeroError:
        return None


def _modes_hold(s: SmallOscillations) -> Iterator[bool | None]:
    mass, stiffness = sp.Matrix(s.system.mass), sp.Matrix(s.system.stiffness)
    for f in s.frequencies:
        for mode in f.modes:
            yield from (is_zero(e) for e in (stiffness - f.square * mass) * sp.Matrix(mode))


def _orthogonal(s: SmallOscillations) -> Iterator[bool | None]:
    for f, g in combinations(s.frequencies, 2):
        for a in f.modes:
            for b in g.modes:
                yield is_zero(_product(a, s.system.mass, b))


def _product(a: tuple[sp.Expr, ...], mass: Matrix, b: tuple[sp.Expr, ...]) -> sp.Expr:
    product: sp.Expr = (sp.Matrix(a).T * sp.Matrix(mass) * sp.Matrix(b))[0]
    return product
