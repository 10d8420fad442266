"""The motion in one set of coordinates, with the reactions that it takes.

Where friction acts, the reactions come first: d'Alembert's principle needs |R| in the applied forces. Everything else
is the same in the coordinates of the file and in those of a choice: the multipliers are always those of the file's
constraints, because a choice makes constraints disappear and not the forces that keep them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from enum import StrEnum
from functools import cached_property
from typing import TypeVar

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Sign
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration, Load, is_pfaffian
from lagrange.mechanics.dynamics.balance import Balance
from lagrange.mechanics.dynamics.comparison import follow
from lagrange.mechanics.dynamics.eliminated_rates import closed
from lagrange.mechanics.dynamics.energies import energies
from lagrange.mechanics.dynamics.equations import (
    EquationsOfMotion,
    WithMultipliers,
    equations_of_motion,
    equations_with_multipliers,
)
from lagrange.mechanics.dynamics.friction import Rubbing, rubbings, solved_loads, symbolic_loads
from lagrange.mechanics.dynamics.matrix_form import MatrixForm, matrix_form
from lagrange.mechanics.dynamics.multipliers import lagrange_motion
from lagrange.mechanics.dynamics.newton import Newton, Reaction, newton_equations
from lagrange.mechanics.dynamics.principle import dalembert
from lagrange.mechanics.dynamics.reactions import (
    Dragging,
    LinearSystem,
    Reactions,
    motion_system,
    solved_reactions,
    written_out,
)
from lagrange.problem.model import Friction, Problem

T = TypeVar("T")

MOST_FREE = 3
"""Coordinates of a system without constraints whose accelerations are still solved for."""
LONGEST = 30
"""Operations of a multiplier that is put into the equations of motion where friction needs it."""


class Method(StrEnum):
    """By what the equations of motion are derived; the other one checks them."""

    DALEMBERT = "dalembert"
    LAGRANGE = "lagrange"


@record
class Law:
    """Newton's law in the file's coordinates, and what follows for reactions.

    problem        with the multipliers of named rods called λ; the name means their tension
    configuration  without friction
    newton         with friction, if there is any
    used           the reactions of independent constraints
    method         by what the equations of motion are derived
    """

    problem: Problem
    configuration: Configuration
    newton: Newton
    used: tuple[Reaction, ...]
    method: Method = Method.DALEMBERT

    @property
    def frictions(self) -> tuple[Friction, ...]:
        """The friction forces."""
        return tuple(f for f in self.problem.forces if isinstance(f, Friction))

    @cached_property
    def system(self) -> LinearSystem:
        """The equations for accelerations and multipliers, without friction."""
        return motion_system(self.balance(self.configuration), self.used)

    def balance(self, configuration: Configuration) -> Balance:
        """What the virtual displacements of a configuration are multiplied by, from the principle or from T and V."""
        return energies(configuration) if self.method is Method.LAGRANGE else dalembert(configuration)

    def equations(self, configuration: Configuration, elimination: Elimination) -> EquationsOfMotion:
        """The equations of motion of a configuration."""
        if self.method is Method.LAGRANGE:
            unknown = self.newton.multipliers_by_name.values()
            return lagrange_motion(energies(configuration), elimination, tuple(unknown))
        return equations_of_motion(dalembert(configuration), elimination)


@record
class Motion:
    """The motion in one set of coordinates.

    equations  friction put in as a function of position and velocity
    reactions  None where there are none, and nothing was solved for
    rubbed     the friction forces
    shown      the configuration with |λ| in its friction
    signs      the signs of multipliers that friction leaves open, each with its λ
    symbolic   the equations with |λ| in them, where λ is long
    multipliers  of the constraints, by name
    solved     the accelerations of independent coordinates, where they are asked for and short
    """

    equations: EquationsOfMotion
    reactions: Reactions | None
    rubbed: tuple[Rubbing, ...]
    shown: Configuration
    signs: Mapping[Sign, sp.Expr] = field(default_factory=dict)
    symbolic: EquationsOfMotion | None = None
    multipliers: Mapping[str, sp.Symbol] = field(default_factory=dict)
    solved: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @cached_property
    def matrices(self) -> MatrixForm:
        """The equations in matrix form."""
        return matrix_form(self.equations)

    @property
    def accelerations(self) -> Mapping[sp.Symbol, sp.Expr]:
        """q'' as functions of position, velocity and time; empty where they were not found."""
        if self.solved or self.reactions is None or self.reactions.configuration.expressed:
            return self.solved
        return {s: e for s, e in self.reactions.accelerations.items() if e is not None}

    @property
    def written(self) -> EquationsOfMotion:
        """The equations as they are written down."""
        return self.symbolic or self.equations

    def closed(self, through_rates: Sequence[sp.Symbol]) -> Motion:
        """The same with the velocities put in of the coordinates that are known through them only."""
        if not through_rates:
            return self
        symbolic = None if self.symbolic is None else closed(self.symbolic, through_rates)
        return replace(self, equations=closed(self.equations, through_rates), symbolic=symbolic)

    @cached_property
    def with_multipliers(self) -> WithMultipliers | None:
        """The same with multipliers; None where no constraint is left."""
        principle = self.written.principle
        return equations_with_multipliers(principle, self.multipliers) if principle.configuration.rows else None


def law_of_motion(
    problem: Problem,
    configuration: Configuration,
    elimination: Elimination,
    rank: int,
    at_rest: bool = False,
    method: Method = Method.DALEMBERT,
) -> Law:
    """Newton's law for the particles of a problem, in the file's coordinates."""
    taken = frozenset(problem.scope.names())
    rough = frozenset(f.constraint for f in problem.forces if isinstance(f, Friction))
    newton = newton_equations(configuration, problem.constraints, rank, taken, at_rest, rough)
    renamed = tuple(
        replace(c, reaction=r.multiplier) for c, r in zip(problem.constraints, newton.reactions, strict=True)
    )
    law = Law(
        problem=replace(problem, constraints=renamed),
        configuration=configuration,
        newton=newton,
        used=tuple(r for n, r in enumerate(newton.reactions) if n not in elimination.unused),
        method=method,
    )
    if not law.frictions:
        return law
    rubbed = symbolic_loads(rubbings(law.frictions, newton, configuration, configuration), configuration)
    loaded = replace(configuration, loads=(*configuration.loads, *rubbed))
    return replace(law, newton=newton_equations(loaded, problem.constraints, rank, taken, rough=rough))


def motion(law: Law, configuration: Configuration, elimination: Elimination, with_reactions: bool = True) -> Motion:
    """The motion in the coordinates of a configuration without friction: the file's own, or those of a choice."""
    multipliers = law.newton.multipliers_by_name
    if not with_reactions or _is_left_out(law, configuration):
        equations = law.equations(configuration, elimination)
        return Motion(equations, None, (), configuration, multipliers=multipliers)
    resting = () if law.frictions else _resting(configuration, elimination)
    reactions = solved_reactions(law.system, law.newton, law.used, configuration, resting=resting)
    rubbed = rubbings(law.frictions, law.newton, law.configuration, configuration)
    if not rubbed:
        equations = law.equations(configuration, elimination)
        return Motion(equations, reactions, (), configuration, multipliers=multipliers)
    dragging = [(r.reaction.multiplier, _generalized(law, configuration, r.share, r.friction.on)) for r in rubbed]
    if not _is_unaffected(law, configuration, reactions, dragging):
        reactions = solved_reactions(law.system, law.newton, law.used, configuration, dragging)
    loads, signs = solved_loads(rubbed, reactions, configuration)
    final = replace(configuration, loads=(*configuration.loads, *loads))
    shown = replace(configuration, loads=(*configuration.loads, *symbolic_loads(rubbed, configuration)))
    long = any(reactions.multipliers[r.reaction.name].count_ops() > LONGEST for r in rubbed)  # type: ignore[union-attr]
    equations = law.equations(final, elimination)
    return Motion(
        equations=equations,
        reactions=_with_friction(law, configuration, reactions, loads),
        rubbed=rubbed,
        shown=shown,
        signs=signs,
        symbolic=law.equations(shown, elimination) if long else None,
        multipliers=multipliers,
    )


def _resting(configuration: Configuration, elimination: Elimination) -> tuple[sp.Symbol, ...]:
    """The velocities that the constraints keep zero: a reaction is not written with them."""
    if not is_pfaffian(configuration.rows):
        return ()
    rates = zip(elimination.dependent, elimination.solution, elimination.drift, strict=True)
    return tuple(
        configuration.slots.velocities[d]
        for d, row, drift in rates
        if all(e == 0 or configuration.states.is_zero(e) for e in (*row, drift))
    )


def _is_left_out(law: Law, configuration: Configuration) -> bool:
    """Whether nothing is solved for: accelerations of many free coordinates, or several reactions with square roots."""
    if law.frictions:
        return False
    if not law.used:
        return len(law.configuration.slots.coordinates) > MOST_FREE or bool(configuration.expressed)
    roots = any(isinstance(s, Sign) for e in configuration.expressed.values() for s in e.free_symbols)
    return roots and len(law.used) > 1


def _generalized(law: Law, configuration: Configuration, force: Vector, on: str) -> list[sp.Expr]:
    """The generalized forces, for the file's coordinates, of a force on a particle, shape (n,)."""
    [point] = (p for p in law.configuration.points if p.name == on)
    rule = configuration.substitution
    return [force.dot(p.xreplace(rule)) for p in point.partials]


def _is_unaffected(law: Law, configuration: Configuration, reactions: Reactions, dragging: Sequence[Dragging]) -> bool:
    """Whether friction leaves the multipliers that it needs as they are without it, as it does where it is tangential.

    Their values must follow from the equations with friction at random states.
    """
    wanted = [symbol for symbol, _ in dragging]
    if any(reactions.values.get(s) is None for s in wanted):
        return False
    equations = written_out(law.system, configuration, dragging)
    claims = [s - reactions.values[s] for s in wanted]
    return follow(configuration, claims, equations, law.system.unknowns) is True


def _with_friction(law: Law, configuration: Configuration, reactions: Reactions, loads: Sequence[Load]) -> Reactions:
    """All reactions and accelerations, friction being a known force now; those it needs are known already."""
    total = [sp.S.Zero] * len(law.configuration.slots.coordinates)
    for load in loads:
        total = [a + b for a, b in zip(total, _generalized(law, configuration, load.vector, load.on), strict=True)]
    found = solved_reactions(law.system, law.newton, law.used, configuration, applied=total)
    needed = {r.name: r.multiplier for r in law.used if r.name in {f.constraint for f in law.frictions}}

    def kept(now: Mapping[str, T], before: Mapping[str, T]) -> dict[str, T]:
        return {name: before[name] if name in needed else now[name] for name in now}

    return replace(
        found,
        multipliers=kept(found.multipliers, reactions.multipliers),
        tensions={**found.tensions, **{n: v for n, v in reactions.tensions.items() if n in needed}},
        values={**found.values, **{s: reactions.values[s] for s in needed.values()}},
    )
