"""Belts and ropes on rough drums.

A belt in contact over the angle β is at rest on the drum as long as the friction along it suffices: with dT = μ dN and
dN = T dφ at the limit, the tensions satisfy

    T_1 ≤ T_2 e^(μ β) ,     T_1 ≥ 0 ,

T_1 being that of the side towards which it would slip. At the limit the two sides are equal. Other forces of the file,
or the constraints that they keep, say what the tensions act on.

Reference: Euler, 1769; Eytelwein, 1808.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.problem.model import Belt, Problem


@record
class BeltLaw:
    """The tensions of a belt in terms of parameters, unknown forces and reactions; `growth` is e^(μ β)."""

    belt: Belt
    tight: sp.Expr
    slack: sp.Expr
    growth: sp.Expr

    @property
    def name(self) -> str:
        """The name of the belt."""
        return self.belt.name

    @property
    def reserve(self) -> sp.Expr:
        """T_2 e^(μ β) − T_1: not negative at rest, zero at the limit."""
        return self.growth * self.slack - self.tight


def belt_laws(problem: Problem, newton: Newton, configuration: Configuration) -> tuple[BeltLaw, ...]:
    """The belts of a problem, in the coordinates of a configuration."""
    forces = {r.constraint.reaction: r.force for r in newton.reactions}

    def written(e: sp.Expr) -> sp.Expr:
        return configuration.rewritten(e).xreplace(forces)

    belts = (f for f in problem.forces if isinstance(f, Belt))
    return tuple(
        BeltLaw(b, written(b.tight), written(b.slack), sp.exp(configuration.rewritten(b.coefficient * b.angle)))
        for b in belts
    )


def sought_forces(problem: Problem, belts: Sequence[BeltLaw]) -> tuple[sp.Symbol, ...]:
    """The unknown forces that the conditions may be about, tensions of belts first, so that others remain open.

    A tension is eliminated like a reaction if that at the other side of its belt is given.
    """
    unknown = {*problem.unknowns}
    sides = [({*b.tight.free_symbols} & unknown, {*b.slack.free_symbols} & unknown) for b in belts]
    inner = {s for tight, slack in sides if not (tight and slack) for s in tight | slack}
    tensions = [s for side in (0, 1) for pair in sides for s in sorted(pair[side], key=str)]
    return tuple(dict.fromkeys(s for s in (*tensions, *problem.unknowns) if s not in inner))


def tensions_between(problem: Problem, loading: Collection[sp.Symbol]) -> set[sp.Symbol]:
    """The unknown tensions of belts both ends of which pull at something: these are inside of the system.

    They are eliminated like reactions, unless the system can be at rest whatever the rest is; then they are asked for.
    """
    unknown = {*problem.unknowns}
    ends = [{*b.tight.free_symbols, *b.slack.free_symbols} & unknown for b in problem.forces if isinstance(b, Belt)]
    return {s for pair in ends if len(pair) == 2 and pair <= {*loading} for s in pair}
