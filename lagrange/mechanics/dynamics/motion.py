"""The motion in one set of coordinates, with its reactions.

Without friction the equations of motion come first, and the reactions may be omitted. Coulomb friction reverses the
order: its force −μ |R| v/|v| is one of the applied forces of d'Alembert's principle, so that |R| must be known before
the principle can be written down. Everything is the same in the file's coordinates and in those of a choice: the
multipliers are always those of the file's constraints, because a choice makes a constraint disappear but not the force
that maintains it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from enum import StrEnum
from functools import cached_property
from typing import TYPE_CHECKING, TypeVar

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration, Load
from lagrange.mechanics.dynamics.comparison import follow
from lagrange.mechanics.dynamics.equations import (
    EquationsOfMotion,
    LagrangeMotion,
    WithMultipliers,
    closed,
    equations_of_motion,
    equations_with_multipliers,
    lagrange_motion,
)
from lagrange.mechanics.dynamics.friction import (
    FrictionForce,
    friction_forces,
    rolling_contacts,
    solved_loads,
    symbolic_loads,
)
from lagrange.mechanics.dynamics.limits import LONGEST_SUBSTITUTED, MOST_FREE
from lagrange.mechanics.dynamics.newton import Newton, Reaction, newton_equations
from lagrange.mechanics.dynamics.principle import Balance, dalembert
from lagrange.mechanics.dynamics.reactions import (
    Dragging,
    Reactions,
    ReactionSystem,
    motion_system,
    solved_reactions,
    written_out,
)
from lagrange.problem.model import Friction, Problem

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.matrix_form import MatrixForm

T = TypeVar("T")


class Method(StrEnum):
    """The method by which the equations of motion are derived; the other one checks them."""

    DALEMBERT = "dalembert"
    LAGRANGE = "lagrange"


@record
class NewtonLaw:
    """Newton's law in the file's coordinates, and its consequences for reactions.

    problem        with λ for the multipliers of reactions whose name is that of a force
    configuration  without friction
    newton         with friction, if there is any
    used           the reactions of independent constraints
    method         by which the equations of motion are derived
    rolling        the friction in contacts that do not slip; it is part of the reactions
    """

    problem: Problem
    configuration: Configuration
    newton: Newton
    used: tuple[Reaction, ...]
    method: Method = Method.DALEMBERT
    rolling: tuple[Friction, ...] = ()

    @property
    def all_frictions(self) -> tuple[Friction, ...]:
        """The friction that the file gives, in whatever slips or rolls."""
        return tuple(f for f in self.problem.forces if isinstance(f, Friction))

    @property
    def frictions(self) -> tuple[Friction, ...]:
        """The friction forces on what slips."""
        return tuple(f for f in self.all_frictions if f not in self.rolling)

    @cached_property
    def system(self) -> ReactionSystem:
        """The equations for accelerations and multipliers, without friction."""
        return motion_system(self.balance(self.configuration), self.used)

    def balance(self, configuration: Configuration) -> Balance:
        """The coefficients of the virtual displacements of a configuration, from the principle or from T and V."""
        if self.method is not Method.LAGRANGE:
            return dalembert(configuration)
        from lagrange.mechanics.dynamics.energies import energies

        return energies(configuration)

    def equations(self, configuration: Configuration, elimination: Elimination) -> EquationsOfMotion:
        """The equations of motion of a configuration."""
        if self.method is Method.LAGRANGE:
            from lagrange.mechanics.dynamics.energies import energies

            unknown = self.newton.multipliers_by_name.values()
            return self._named(lagrange_motion(energies(configuration), elimination, tuple(unknown)))
        return equations_of_motion(dalembert(configuration), elimination)

    def _named(self, motion: LagrangeMotion) -> LagrangeMotion:
        """Lagrange's equations with the forces that the file names instead of their multipliers."""
        rows = [motion.configuration.rows[n] for n in motion.used]
        by_name = {r.name: r for r in self.newton.reactions}
        reactions = [by_name[row.name] for row in rows]
        right = []
        for k, (q, s) in enumerate(zip(motion.principle.applied, motion.principle.of_masses, strict=True)):
            factors = (_tidy(row.coefficients[k], r.per_force) for row, r in zip(rows, reactions, strict=True))
            right.append(sp.Add(q, s, *(f * r.force for f, r in zip(factors, reactions, strict=True))))
        forces = None
        if motion.multipliers is not None:
            forces = tuple(_tidy(v, 1 / r.per_force) for v, r in zip(motion.multipliers, reactions, strict=True))
        return replace(motion, right=tuple(right), forces=forces)


def _tidy(expression: sp.Expr, factor: sp.Expr) -> sp.Expr:
    """The product in textbook form; the expression as it is where the factor is 1."""
    return expression if factor == 1 else textbook_form(expression * factor)


@record
class Motion:
    """The motion in one set of coordinates.

    equations  with friction as a function of position and velocity
    reactions  None if there are none and nothing was solved for
    friction_forces  the friction forces
    shown      the configuration with |λ| in its friction
    signs      the signs of multipliers that friction leaves open, each with its λ
    symbolic   the equations with |λ| in them, if λ is long
    multipliers  of the constraints, by name
    solved     the accelerations of independent coordinates, if they are requested and short
    """

    equations: EquationsOfMotion
    reactions: Reactions | None
    friction_forces: tuple[FrictionForce, ...]
    shown: Configuration
    signs: Mapping[Sign, sp.Expr] = field(default_factory=dict)
    symbolic: EquationsOfMotion | None = None
    multipliers: Mapping[str, sp.Symbol] = field(default_factory=dict)
    solved: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @property
    def slips(self) -> tuple[sp.Expr, ...]:
        """The speeds of slips, each in the sense that the file gives, in which they are positive."""
        known = (f for f in self.friction_forces if f.sense_is_stated and f.speed is not None)
        return tuple(f.sense * f.speed for f in known if f.speed is not None)

    @property
    def sliding(self) -> tuple[sp.Expr, ...]:
        """The squared slip speeds whose direction the file leaves open; the friction law requires them nonzero."""
        open_ = (f for f in self.friction_forces if not f.sense_is_stated and f.speed is not None)
        return tuple(f.speed**2 for f in open_ if f.speed is not None)

    @property
    def contacts(self) -> tuple[sp.Expr, ...]:
        """The multipliers of constraints with friction, each with the sign that the file or the derivation gives it."""
        values = {} if self.reactions is None else self.reactions.multipliers
        known = ((f.contact, values.get(f.reaction.name)) for f in self.friction_forces)
        stated = tuple(sign * value for sign, value in known if value is not None and not isinstance(sign, Sign))
        return (*stated, *self.signs.values())

    @cached_property
    def matrices(self) -> MatrixForm:
        """The equations in matrix form."""
        from lagrange.mechanics.dynamics.matrix_form import matrix_form

        return matrix_form(self.equations)

    def with_accelerations(self) -> Motion:
        """With the equations solved for the accelerations, unless they are known or too large."""
        from lagrange.mechanics.dynamics.matrix_form import may_be_solved, solved_accelerations

        if self.accelerations or not may_be_solved(self.equations.configuration):
            return self
        solved = solved_accelerations(self.matrices)
        return replace(self, solved=solved) if solved else self

    @property
    def accelerations(self) -> Mapping[sp.Symbol, sp.Expr]:
        """q'' as functions of position, velocity and time; empty if they were not found."""
        if self.solved or self.reactions is None or self.reactions.configuration.expressed:
            return self.solved
        return {s: e for s, e in self.reactions.accelerations.items() if e is not None}

    @property
    def written(self) -> EquationsOfMotion:
        """The equations as they are written down."""
        return self.symbolic or self.equations

    def closed(self, through_rates: Sequence[sp.Symbol]) -> Motion:
        """The motion after substituting the velocities of coordinates known only through them."""
        if not through_rates:
            return self
        symbolic = None if self.symbolic is None else closed(self.symbolic, through_rates)
        return replace(self, equations=closed(self.equations, through_rates), symbolic=symbolic)

    @cached_property
    def with_multipliers(self) -> WithMultipliers | None:
        """The equations with multipliers; None if no constraint remains."""
        principle = self.written.principle
        return equations_with_multipliers(principle, self.multipliers) if principle.configuration.rows else None


def law_of_motion(
    problem: Problem,
    configuration: Configuration,
    elimination: Elimination,
    rank: int,
    at_rest: bool = False,
    method: Method = Method.DALEMBERT,
) -> NewtonLaw:
    """Newton's law for the particles of a problem, in the file's coordinates."""
    taken = frozenset(problem.scope.names())
    rough = frozenset(c for f in problem.forces if isinstance(f, Friction) for c in f.constraints)
    newton = newton_equations(configuration, problem.constraints, rank, taken, at_rest, rough)
    renamed = tuple(
        replace(c, reaction=r.multiplier) for c, r in zip(problem.constraints, newton.reactions, strict=True)
    )
    law = NewtonLaw(
        problem=replace(problem, constraints=renamed),
        configuration=configuration,
        newton=newton,
        used=tuple(r for n, r in enumerate(newton.reactions) if n not in elimination.unused),
        method=method,
    )
    if not law.frictions:
        return law
    law = replace(law, rolling=rolling_contacts(law.frictions, newton, configuration))
    if at_rest or not law.frictions:
        return law
    # Friction needs the directions of the reactions, and Newton's law is to show friction: so it is set up twice.
    friction = symbolic_loads(friction_forces(law.frictions, newton, configuration, configuration))
    loaded = replace(configuration, loads=(*configuration.loads, *friction))
    return replace(law, newton=newton_equations(loaded, problem.constraints, rank, taken, rough=rough))


def motion(
    law: NewtonLaw, configuration: Configuration, elimination: Elimination, with_reactions: bool = True
) -> Motion:
    """The motion in the coordinates of a configuration without friction: the file's own, or those of a choice."""
    multipliers = law.newton.multipliers_by_name
    if not with_reactions or _is_left_out(law, configuration):
        equations = law.equations(configuration, elimination)
        return Motion(equations, None, (), configuration, multipliers=multipliers)
    resting = () if law.frictions else _resting(configuration, elimination)
    reactions = solved_reactions(law.system, law.newton, law.used, configuration, resting=resting)
    frictions = friction_forces(law.frictions, law.newton, law.configuration, configuration)
    if not frictions:
        equations = law.equations(configuration, elimination)
        return Motion(equations, reactions, (), configuration, multipliers=multipliers)
    # |R| enters the applied forces, so the multipliers come first: as they are without friction, if friction does not
    # change them, otherwise from equations in which friction is proportional to λ.
    # Whether a resultant is changed is tried with any force along the slip.
    dragging = [(f.reaction.multiplier, f.generalized(f.slip if f.also else f.share)) for f in frictions]
    if not _is_unaffected(law, configuration, reactions, dragging, [r.multiplier for f in frictions for r in f.also]):
        resultant = next((f.friction for f in frictions if f.also), None)
        if resultant is not None and {*resultant.constraints} <= {*reactions.multipliers}:
            what = f"the friction `{resultant.name}` on the resultant of reactions that friction changes"
            raise NotCoveredError(what, resultant.span)
        reactions = solved_reactions(law.system, law.newton, law.used, configuration, dragging)
    loads, signs = solved_loads(frictions, reactions)
    final = replace(configuration, loads=(*configuration.loads, *loads))
    shown = replace(configuration, loads=(*configuration.loads, *symbolic_loads(frictions)))
    long = any(count_operations(reactions.multipliers[f.reaction.name]) > LONGEST_SUBSTITUTED for f in frictions)
    equations = law.equations(final, elimination)
    return Motion(
        equations=equations,
        reactions=_with_friction(law, configuration, reactions, frictions, loads),
        friction_forces=frictions,
        shown=shown,
        signs=signs,
        symbolic=law.equations(shown, elimination) if long else None,
        multipliers=multipliers,
    )


def _resting(configuration: Configuration, elimination: Elimination) -> tuple[sp.Symbol, ...]:
    """The velocities that the constraints keep zero: they are omitted from reactions."""
    if not configuration.constrained.is_pfaffian:
        return ()
    rates = zip(elimination.dependent, elimination.solution, elimination.drift, strict=True)
    return tuple(
        configuration.slots.velocities[d]
        for d, row, drift in rates
        if all(e == 0 or configuration.states.is_zero(e) for e in (*row, drift))
    )


def _is_left_out(law: NewtonLaw, configuration: Configuration) -> bool:
    """Whether nothing is solved for: many free accelerations, or several reactions with square roots."""
    if law.frictions:
        return False
    if not law.used:
        return len(law.configuration.slots.coordinates) > MOST_FREE or bool(configuration.expressed)
    roots = any(isinstance(s, Sign) for e in configuration.expressed.values() for s in e.free_symbols)
    return roots and len(law.used) > 1


def _is_unaffected(
    law: NewtonLaw,
    configuration: Configuration,
    reactions: Reactions,
    dragging: Sequence[Dragging],
    others: Sequence[sp.Symbol] = (),
) -> bool:
    """Whether the multipliers that friction needs are the same without it, as they are if it is tangential.

    Their values without friction must follow from the equations with friction at random states.
    """
    multipliers = [*(symbol for symbol, _ in dragging), *others]
    if any(reactions.values.get(s) is None for s in multipliers):
        return False
    equations = written_out(law.system, configuration, dragging)
    claims = [s - reactions.values[s] for s in multipliers]
    return follow(configuration, claims, equations, law.system.unknowns) is True


def _with_friction(
    law: NewtonLaw,
    configuration: Configuration,
    reactions: Reactions,
    frictions: Sequence[FrictionForce],
    loads: Sequence[Load],
) -> Reactions:
    """All reactions and accelerations with friction as a known force; the reactions that it needs are known already."""
    total = [sp.S.Zero] * len(law.configuration.slots.coordinates)
    for f in frictions:
        [force] = (load.vector for load in loads if (load.name, load.on) == (f.friction.name, f.friction.on))
        total = [a + b for a, b in zip(total, f.generalized(force), strict=True)]
    solved = solved_reactions(law.system, law.newton, law.used, configuration, applied=total)
    needed = {r.name: r.multiplier for r in law.used if r.name in {c for f in law.frictions for c in f.constraints}}

    def merged(now: Mapping[str, T], before: Mapping[str, T]) -> dict[str, T]:
        return {name: before[name] if name in needed else now[name] for name in now}

    return replace(
        solved,
        multipliers=merged(solved.multipliers, reactions.multipliers),
        sizes={**solved.sizes, **{n: v for n, v in reactions.sizes.items() if n in needed}},
        values={**solved.values, **{s: reactions.values[s] for s in needed.values()}},
    )
