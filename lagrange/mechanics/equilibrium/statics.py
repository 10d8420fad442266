"""What a problem of statics must be, and the checks of its solution by a second route.

Equilibrium is asked of a system at rest whose constraints stand still: forces that depend on the velocity or on time
have no place in it, and are refused by name.

    Lagrange's generalized forces    −(d/dt ∂T/∂q' − ∂T/∂q − Q) at rest, from T, V and F, against the virtual work
    substitution                     every equilibrium put back into the equations it was found from, exactly
    reactions                        put back into Lagrange's equations at rest, in the file's coordinates
    coordinates                      at every equilibrium of a choice, Q = −Aᵀ λ in the file's coordinates, by ranks
"""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.exact import DivisionByZeroError
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.symbols import base, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.verification import Check, certainty
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, is_balanced
from lagrange.mechanics.equilibrium.static_reactions import StaticReactions
from lagrange.problem.model import AppliedForce, AppliedMoment, Damper, Potential, Problem, Spring


def check_statics(problem: Problem, configuration: Configuration) -> None:
    """Refuses what is no problem of statics. Raises ProblemError, with all that is wrong."""
    found = [*_forces(problem), *_moving(problem, configuration)]
    if not found and not configuration.loads and not configuration.torques and configuration.potential == 0:
        help_ = "give forces, a potential, or gravity and masses"
        message = "no force acts, so that every position is one of equilibrium"
        found.append(Diagnostic("no-forces", message, help=help_))
    if found:
        raise ProblemError(found)


def _forces(problem: Problem) -> Iterable[Diagnostic]:
    """The forces that depend on the motion."""
    for f in problem.forces:
        match f:
            case AppliedForce():
                parts = (*f.vector.components, *(f.at.components if f.at is not None else ()))
            case AppliedMoment():
                parts = f.moment.components
            case Potential():
                parts = (f.energy,)
            case Spring():
                parts = (f.stiffness, f.length, *f.ends[0].components, *f.ends[1].components)
            case Damper():
                message = f"the damper `{f.name}` exerts no force at rest"
                yield Diagnostic("force-of-motion", message, f.span, help="leave it out where equilibrium is asked")
                continue
            case _:
                continue
        symbols = sorted({s for p in parts for s in p.free_symbols}, key=str)
        rates = [s for s in symbols if base(s) != s and base(s) not in problem.slots.prescribed]
        times = [s for s in symbols if s == t or base(s) in problem.slots.prescribed]
        if rates:
            message = f"the force `{f.name}` depends on the velocity `{rates[0]}`"
            help_ = "at rest velocities are zero: write what the force is at rest, or leave it out"
            yield Diagnostic("force-of-motion", message, f.span, help=help_)
        elif times:
            message = f"the force `{f.name}` depends on time, through `{times[0]}`"
            help_ = "a system is in equilibrium under forces that stay as they are: make it a parameter"
            yield Diagnostic("force-of-motion", message, f.span, help=help_)


def _moving(problem: Problem, configuration: Configuration) -> Iterable[Diagnostic]:
    """Constraints and positions that move by themselves."""
    spans = {c.name: c.span for c in problem.constraints}
    for row in configuration.rows:
        parts = (*row.coefficients, row.drift, row.finite or sp.S.Zero)
        if row.drift != 0 or any(_has_time(p, problem) for p in parts):
            message = f"the constraint `{row.name}` moves"
            help_ = "what moves by itself has no equilibrium: keep its time fixed as a parameter"
            yield Diagnostic("moving-constraint", message, spans.get(row.name), help=help_)
    for p in problem.masses:
        if any(_has_time(c, problem) for c in p.position.fixed().components):
            message = f"the position of `{p.name}` contains time"
            yield Diagnostic("moving-constraint", message, p.span, help="keep its time fixed as a parameter")


def _has_time(e: sp.Expr, problem: Problem) -> bool:
    return any(s == t or base(s) in problem.slots.prescribed for s in e.free_symbols)


def check_equilibrium(found: Equilibrium, original: Equilibrium) -> list[Check]:
    """The checks of the equilibria of one configuration; `original` is in the file's coordinates."""
    name = found.configuration.name
    how = f"{certainty(found.configuration.surface)}, at random points"
    checks = [Check("Lagrange's generalized forces at rest are the same", _same_forces(found), how, name)]
    if any(not b.left for b in found.branches):
        checks.append(
            Check("every equilibrium satisfies the conditions", found.solution.verified, "exact, put back", name)
        )
    if found is not original and found.solution.solved and found.branches:
        how = "exact, by ranks"
        checks.append(
            Check("the forces are balanced in the file's coordinates as well", _holds_there(found, original), how, name)
        )
    return checks


def check_reactions_at_rest(found: StaticReactions | None) -> list[Check]:
    """The check of the reactions at the equilibria of one configuration, where there are some."""
    verdicts = [r.verified for r in (found.at if found is not None else ()) if r is not None]
    if found is None or not verdicts:
        return []
    passed = False if False in verdicts else None if None in verdicts else True
    name = "with the reactions Lagrange's equations hold at every equilibrium"
    return [Check(name, passed, "exact, put back", found.configuration.name)]


def _same_forces(found: Equilibrium) -> bool | None:
    """Whether the virtual work has the generalized forces that Lagrange's equations have."""
    configuration = found.configuration
    slots = configuration.slots
    at_rest = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    verdicts = [
        configuration.surface.is_zero(left.xreplace(at_rest) + force)
        for left, force in zip(lagrange_equations(configuration).left, found.work.forces, strict=True)
    ]
    return False if False in verdicts else None if None in verdicts else True


def _holds_there(found: Equilibrium, original: Equilibrium) -> bool | None:
    """Whether the forces in the file's coordinates are balanced at every point of a choice."""
    rewritten = found.configuration.rewritten
    verdicts: list[bool | None] = []
    for point in (p for b in found.branches if not b.special for p in b.points):
        try:
            verdicts.append(is_balanced(original, lambda e, p=point: found.solution.at(p, rewritten(e))))  # type: ignore[misc]
        except (NotAlgebraicError, DivisionByZeroError):
            verdicts.append(None)
    return False if False in verdicts else None if None in verdicts else True
