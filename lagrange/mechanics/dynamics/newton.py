"""Newton's law with reactions, before any principle is called in: free bodies, equations, unknowns.

    m r'' = F + R ,     R = Σ_j λ_j ∂f_j/∂r     (for a constraint on velocities λ_j ∂φ_j/∂r') ,

and for a rigid body dH/dt = M + Γ beside it, Γ the moment of the reactions about the mass centre. The direction of a
reaction is what its form stands for (`placing`). Where coordinates keep a particle on a surface or curve by themselves,
the reaction of that is perpendicular to the directions in which it can move, and Newton's law is written along these
only. Where coordinates place one particle with another by themselves, there is no list of free bodies. A coordinate
that moves nothing has λ_j a_k as its generalized force.

Before directions are used, each particle on which reactions act has an unknown for each component, each body one for
each component of R and Γ; after, each constraint has one: its multiplier.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace

import sympy as sp

from lagrange.algebra.fourier.linear_systems import tidy_quotient
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint, Row
from lagrange.mechanics.dynamics.placing import Forces, Freedom, Placed, form_as_forces, left_out, placed_freely
from lagrange.mechanics.dynamics.rods import Rod, recognised_rod
from lagrange.problem.model import Constraint


@record
class Reaction:
    """What keeps one constraint.

    multiplier  λ
    directions  of the force on each particle that it acts on: R_P = λ · direction; None where they are not determined
    moments     the same of its moment on each body, about the mass centre: Γ = λ · moment
    others      a_k of the coordinates that move no particle: the generalized force on them is λ a_k
    rod         the distance that is kept, where it is one
    rough       the same where something slides there with friction: a surface, in which there is no tension
    tension     what the tension of the rod is called; `named` if the file calls it so
    """

    constraint: Constraint
    row: Row
    multiplier: sp.Symbol
    directions: Mapping[str, Vector] | None
    others: Mapping[sp.Symbol, sp.Expr]
    rod: Rod | None = None
    tension: sp.Symbol | None = None
    named: bool = False
    moments: Mapping[str, Vector] = field(default_factory=dict)
    rough: Rod | None = None

    @property
    def name(self) -> str:
        """The constraint's name."""
        return self.row.name

    @property
    def force(self) -> sp.Symbol:
        """The unknown that it is written with: the tension of a rod that the file names, otherwise λ."""
        return self.tension if self.named and self.tension is not None else self.multiplier

    @property
    def per_force(self) -> sp.Expr:
        """λ for `force` = 1."""
        return 1 / self.rod.factor if self.named and self.rod is not None else sp.S.One

    def per_unit(self, particle: str) -> Vector | None:
        """The force on a particle for `force` = 1; None where it does not act on it."""
        return self._for_unit(self.on(particle))

    def moment_per_unit(self, body: str) -> Vector | None:
        """The moment on a body for `force` = 1; None where it has none."""
        return self._for_unit(self.moments.get(body))

    def _for_unit(self, direction: Vector | None) -> Vector | None:
        if direction is None or self.per_force == 1:
            return direction
        return direction.map(lambda c: tidy_quotient(c * self.per_force))

    @property
    def acts_on(self) -> tuple[str, ...]:
        """The particles and bodies that it acts on."""
        return tuple(dict.fromkeys((*(self.directions or ()), *self.moments)))

    @property
    def is_normal(self) -> bool:
        """Whether it is the force of a surface on one particle."""
        alone = self.directions is not None and len(self.directions) == 1 and not self.others and not self.moments
        return alone and self.row.finite is not None and self.rod is None

    def on(self, particle: str) -> Vector | None:
        """The direction of the force on a particle; None where it does not act on it."""
        return None if self.directions is None else self.directions.get(particle)


@record
class Component:
    """One component of Newton's law: inertia = applied + reaction. `along` is the unit vector that it is along."""

    along: Vector
    inertia: sp.Expr
    applied: sp.Expr
    reaction: sp.Expr

    @property
    def right(self) -> sp.Expr:
        """What acts."""
        return self.applied + self.reaction


@record
class FreeBody:
    """A particle or rigid body with all that acts on it.

    loads       names of the applied forces
    applied     their sum
    reactions   those that act on it, each with its force for `force` = 1
    components  of Newton's law, in the directions in which the particle or mass centre can be placed
    moments     the reactions that have a moment about the mass centre, each with that for `force` = 1
    turning     components of the law of angular momentum, about the axes about which the body can be turned
    """

    particle: MassPoint
    loads: tuple[str, ...]
    applied: Vector
    reactions: tuple[tuple[Reaction, Vector], ...]
    components: tuple[Component, ...]
    moments: tuple[tuple[Reaction, Vector], ...] = ()
    turning: tuple[Component, ...] = ()

    @property
    def name(self) -> str:
        """The particle's or body's name."""
        return self.particle.name

    @property
    def laws(self) -> tuple[Component, ...]:
        """The components of both laws."""
        return (*self.components, *self.turning)

    @property
    def bound(self) -> tuple[Reaction, ...]:
        """The reactions that act on it."""
        pushing = [r for r, _ in self.reactions]
        return (*pushing, *(r for r, _ in self.moments if r not in pushing))


@record
class Count:
    """Unknowns against equations."""

    unknowns: int
    equations: int

    @property
    def missing(self) -> int:
        """How many equations are missing."""
        return self.unknowns - self.equations


@record
class Newton:
    """Newton's law for every particle.

    bodies           the free bodies; None where the coordinates do not place the particles one by one
    idle             0 = Σ λ_j a_k, for each coordinate that moves no particle: the right sides
    before           components of reactions as unknowns
    after            multipliers as unknowns
    """

    reactions: tuple[Reaction, ...]
    bodies: tuple[FreeBody, ...] | None
    idle: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    before: Count | None = None
    after: Count | None = None

    @property
    def tensions(self) -> dict[sp.Symbol, sp.Expr]:
        """Each tension as a multiple of its multiplier."""
        return {r.tension: r.rod.factor * r.multiplier for r in self.reactions if r.rod and r.tension is not None}

    @property
    def multipliers_by_name(self) -> dict[str, sp.Symbol]:
        """The multipliers of the constraints, by their names."""
        return {r.name: r.multiplier for r in self.reactions}

    @property
    def equations(self) -> tuple[tuple[sp.Expr, sp.Expr], ...] | None:
        """Left and right sides; None where there are no free bodies."""
        if self.bodies is None:
            return None
        forms = ((c.inertia, c.right) for b in self.bodies for c in b.laws)
        return (*forms, *((sp.S.Zero, right) for right in self.idle.values()))


def newton_equations(
    configuration: Configuration,
    constraints: Sequence[Constraint],
    rank: int,
    taken: frozenset[str] = frozenset(),
    at_rest: bool = False,
    rough: frozenset[str] = frozenset(),
) -> Newton:
    """Newton's law for the particles of a configuration.

    constraints  those that `configuration.rows` are the forms of, in the same order
    rank         the number of independent constraints
    taken        names that have a meaning, and cannot be that of a tension
    at_rest      nothing is accelerated; then massless points count as particles on which reactions may act
    rough        names of constraints on which something slides with friction
    """
    placed = placed_freely(configuration)
    if at_rest and placed is not None:
        moving = {p.name for p in configuration.points if any(not e.is_zero for e in p.partials)}
        placed = placed if moving <= {f.name for f in placed if not f.turning} else None
    reactions = tuple(
        _without_tension(reaction) if reaction.name in rough else reaction
        for row, c in zip(configuration.rows, constraints, strict=True)
        for reaction in [_reaction(row, c, placed, configuration, taken)]
    )
    idle = {
        q: sp.Add(*(r.force * r.others[q] for r in reactions if q in r.others))
        for q in configuration.slots.coordinates
        if any(q in r.others for r in reactions)
    }
    of_field = None if placed is None else _field(placed, configuration)
    if placed is None or of_field is None or any(r.directions is None for r in reactions):
        return Newton(reactions, None, idle)
    acting = _Acting(configuration, reactions, of_field, at_rest)
    points = {p.name: p for p in configuration.points}
    names = dict.fromkeys(f.name for f in placed)
    bodies = tuple(_free_body(points[name], {f.turning: f for f in placed if f.name == name}, acting) for name in names)
    return Newton(reactions, bodies, idle, *_counts(configuration, bodies, idle, rank))


@record
class Normal:
    """A geometric constraint on one particle: its gradient ∇f there, so that ∇f·dr + f_t dt = 0."""

    row: Row
    particle: str
    gradient: Vector


def normals(configuration: Configuration) -> tuple[Normal, ...]:
    """The gradients of the geometric constraints that bind one particle and nothing else."""
    placed = placed_freely(configuration)
    found = []
    for row in configuration.rows if placed else ():
        acts = None if row.finite is None or placed is None else form_as_forces(row, placed, configuration.states)
        if acts is None or len(acts.forces) != 1 or acts.moments or left_out(row, configuration):
            continue
        [(particle, gradient)] = acts.forces.items()
        found.append(Normal(row, particle, gradient))
    return tuple(found)


@record
class _Acting:
    """What acts on particles and bodies: reactions, and `field`, the forces of potentials and dampers."""

    configuration: Configuration
    reactions: tuple[Reaction, ...]
    field: Forces
    at_rest: bool


def _counts(
    configuration: Configuration, bodies: Sequence[FreeBody], idle: Mapping[sp.Symbol, sp.Expr], rank: int
) -> tuple[Count, Count]:
    """Unknowns and equations before the directions of reactions are used, and after."""
    coordinates = len(configuration.slots.coordinates)
    components = sum(len(b.laws) for b in bodies)
    of_reactions = sum(len(b.laws) for b in bodies if b.bound) + len(idle)
    equations = components + len(idle) + rank
    return (
        Count(coordinates + of_reactions, equations),
        Count(coordinates + len(configuration.rows), equations),
    )


def _reaction(
    row: Row, constraint: Constraint, placed: Placed | None, configuration: Configuration, taken: frozenset[str]
) -> Reaction:
    others = left_out(row, configuration)
    acts = None if placed is None else form_as_forces(row, placed, configuration.states)
    given = constraint.reaction
    if acts is None:
        return Reaction(constraint, row, given, None, others)
    directions, rod = acts.forces, None
    if directions and not others and not acts.moments:
        rod = recognised_rod(row, configuration.points, dict(directions), configuration.slots, configuration.states)
    if rod is None:
        return Reaction(constraint, row, given, directions, others, moments=acts.moments)
    directions = _along(rod, directions)
    own = row.multiplier
    if given != own and own.name not in taken:
        return Reaction(constraint, row, own, directions, others, rod, given, named=True)
    tension = sp.Symbol(f"T_{row.name}", real=True)
    free = tension.name not in taken
    return Reaction(constraint, row, given, directions, others, rod, tension if free else None)


def _without_tension(reaction: Reaction) -> Reaction:
    """The reaction of a surface, whatever distance that keeps: its name is that of the multiplier."""
    multiplier = reaction.constraint.reaction
    return replace(reaction, multiplier=multiplier, rod=None, tension=None, named=False, rough=reaction.rod)


def _along(rod: Rod, directions: Mapping[str, Vector]) -> dict[str, Vector]:
    """The whole force of a rod, also where the coordinates by themselves bear a part of it."""
    first, second = rod.ends
    found = dict(directions)
    for name, sign in ((first, 1), (second, -1)):
        whole = (rod.span * (sign * rod.ratio)).map(textbook_form)
        if name and not (whole - directions.get(name, Vector.zero())).map(textbook_form).is_zero:
            found[name] = whole
    return found


def _field(placed: Placed, configuration: Configuration) -> Forces | None:
    """−∂V/∂r_P for each particle, with the pull of the dampers, and the moments of both; None: not found."""
    potential, slots = configuration.potential, configuration.slots
    if potential == 0 and not configuration.dampers:
        return Forces({}, {})
    resistance = [sp.Add(*(d.pull * d.distance.diff(q) for d in configuration.dampers)) for q in slots.coordinates]
    slopes = tuple(-potential.diff(q) - r for q, r in zip(slots.coordinates, resistance, strict=True))
    return form_as_forces(Row("", slopes, sp.S.Zero), placed, configuration.states)


def _free_body(point: MassPoint, freedoms: Mapping[bool, Freedom], newton: _Acting) -> FreeBody:
    """Newton's law along the directions in which a particle can be placed, and that of angular momentum."""
    configuration, name = newton.configuration, point.name
    loads = [f for f in configuration.loads if f.on == name]
    names = [f.name for f in loads]
    applied = sum((f.vector for f in loads), Vector.zero(point.position.triad))
    applied = applied + newton.field.forces.get(name, Vector.zero(point.position.triad))
    if name in newton.field.forces or name in newton.field.moments:
        names.append("")
    acting = tuple((r, g) for r in newton.reactions if (g := r.per_unit(name)) is not None)
    moments = tuple((r, g) for r in newton.reactions if (g := r.moment_per_unit(name)) is not None)
    placing = freedoms.get(False)
    mass = sp.S.Zero if newton.at_rest else point.mass
    components = _components(placing, mass, point.acceleration, applied, acting)
    turning = freedoms.get(True)
    if turning is None:
        return FreeBody(point, tuple(names), applied, acting, components)
    [rotation] = (r for r in configuration.rotations if r.name == name)
    moment = configuration.moment_on(name) + newton.field.moments.get(name, Vector.zero(turning.triad))
    names += [f.name for f in configuration.torques if f.on == name]
    laws = _components(turning, sp.Integer(not newton.at_rest), rotation.momentum_rate, moment, moments)
    return FreeBody(point, tuple(names), applied, acting, components, moments, laws)


def _components(
    freedom: Freedom | None,
    factor: sp.Expr,
    rate: Vector,
    applied: Vector,
    acting: Sequence[tuple[Reaction, Vector]],
) -> tuple[Component, ...]:
    """factor · rate = applied + reactions, along the unit vectors of a freedom."""
    if freedom is None:
        return ()
    return tuple(
        Component(
            unit,
            factor * textbook_form(rate.dot(unit)) if factor != 0 else factor,
            textbook_form(applied.dot(unit)),
            sp.Add(*(r.force * textbook_form(g.dot(unit)) for r, g in acting)),
        )
        for unit in freedom.units
    )
