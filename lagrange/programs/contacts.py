"""Where a contact ends during a motion, and where a reaction changes its sign without ending anything.

An equation between coordinates acts on both sides: a bead on a wire is pushed and pulled. It acts on one side only
where the file says so:

    r >= R, or `contact:` of a friction    as long as ±λ, the sign being that of the push, is not negative
    `by: string`                           as long as the tension is not negative
    `by: surface`                          as long as the force has the sign that it has at first

Figures on pages and simulations end a motion by these rules. A change of sign of any other force that the file names is
reported, and the motion goes on.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from enum import IntEnum

import sympy as sp

from lagrange.core.records import record
from lagrange.mechanics.dynamics.friction import FrictionForce
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.problem.model import Friction, Keeper, Problem


class Guard(IntEnum):
    """What must hold for a reaction while the equations do; pages have these numbers."""

    PUSHES_BACK = -1  # λ is not positive
    NONE = 0
    PUSHES = 1  # λ is not negative
    PULLS = 2  # the tension is not negative
    KEEPS_SIGN = 3  # the force has the sign that it has at first
    TWO_SIDED = 4  # nothing, but a change of its sign is reported


_EITHER_WAY = (Keeper.ROD, Keeper.WIRE, Keeper.HINGE, Keeper.ROLLING, Keeper.GEAR)


def guards(dynamics: Motion | None, reactions: Collection[Reaction]) -> Mapping[str, Guard]:
    """The guard of each reaction, by the name of its constraint."""
    frictions: tuple[FrictionForce, ...] = () if dynamics is None else dynamics.friction_forces
    pressed = {f.reaction.name: int(f.contact) for f in frictions if f.contact.is_Integer}
    return {r.name: _guard(r, pressed.get(r.name, 0)) for r in reactions}


def _guard(r: Reaction, pressed: int) -> Guard:
    by, side = r.constraint.by, r.constraint.side or pressed
    if side:
        return Guard(side)
    if by is Keeper.STRING and r.tension is not None:
        return Guard.PULLS
    if by is Keeper.SURFACE:
        return Guard.KEEPS_SIGN
    reported = r.given is not None and r.single is not None and r.row.finite is not None and by not in _EITHER_WAY
    return Guard.TWO_SIDED if reported else Guard.NONE


def coefficients_at_rest(problem: Problem) -> dict[sp.Symbol, sp.Expr]:
    """By coefficient of kinetic friction the static one, for those that are parameters by themselves."""
    frictions = [f for f in problem.forces if isinstance(f, Friction)]
    return {f.coefficient: f.static for f in frictions if f.static is not None and f.coefficient.is_Symbol}


@record
class Contact:
    """A reaction that is watched: the names of its constraint and of its force, its guard, what must have a sign."""

    name: str
    force: str
    guard: Guard
    value: sp.Expr


def contacts(
    dynamics: Motion, reactions: Collection[Reaction], multipliers: Collection[sp.Symbol]
) -> Iterator[Contact]:
    """The reactions monitored along a motion; unknown ones are solved for if they are unknowns of the equations."""
    known, guarded = dynamics.reactions, guards(dynamics, reactions)
    for r in reactions:
        guard = guarded[r.name]
        if guard is Guard.NONE:
            continue
        multiplier = None if known is None else known.multipliers.get(r.name)
        if multiplier is None and r.multiplier in multipliers:
            multiplier = r.multiplier
        size = None if known is None else known.sizes.get(r.name)
        if size is None and multiplier is not None and r.single is not None:
            size = r.single.factor * multiplier
        value = size if guard > Guard.PUSHES else None if multiplier is None else int(guard) * multiplier
        if value is not None:
            yield Contact(r.name, str(r.force.name), guard, value)
