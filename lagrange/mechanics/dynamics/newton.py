"""Newton's law with reactions: free bodies, equations, unknowns, and the work of the reactions.

Sign convention, with a plus sign throughout:

    m r'' = F + R ,     R = Σ_j λ_j ∂f_j/∂r     (for a constraint on velocities λ_j ∂φ_j/∂r') ,

and for a rigid body dH/dt = M + Γ as well, Γ being the moment of the reactions about the mass centre. λ_j is the
multiplier of the constraint as it is written. A name that the file gives to a reaction is that of a force, where it is
a single one: a tension, positive where it pulls, or the force along a unit vector (`reaction_signs`). A coordinate that
moves nothing has the generalized force λ_j a_k. Where coordinates by themselves keep a particle on a surface or curve,
that reaction is perpendicular to the directions in which the particle can move, and Newton's law is written along these
only. Where coordinates place one particle relative to another, there are no free bodies.

The work of a reaction R_P = Σ_j λ_j g_jP in a virtual displacement is

    δW = Σ_P R_P·δr_P + Σ_B Γ_B·δπ_B ,      δr_P = Σ_k (∂r_P/∂q_k) δq_k .

After substituting the dependent δq it is tested for zero on the constraint surface: that constraints are workless is a
result. The share of a single particle need not vanish. In a possible displacement the constraints give
Σ a_k dq_k = −a_t dt, so that the reaction of a moving constraint may do work: a lift does work on its passengers.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cache

import sympy as sp

from lagrange.algebra.fourier.linear_systems import shorter_product, tidy_quotient
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import differential, partial, t, variation
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.displacements import Elimination, virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.free_bodies import (
    Forces,
    Freedom,
    Placed,
    Rod,
    along_rod,
    form_as_forces,
    idle_forces,
    is_length,
    marks_on_bodies,
    placed_freely,
    recognised_rod,
    stated_length,
    without_root,
)
from lagrange.mechanics.dynamics.principle import given_forces
from lagrange.mechanics.dynamics.reaction_signs import (
    SURFACES,
    ForceKind,
    SingleForce,
    is_led,
    single_force,
    tension_of_rod,
)
from lagrange.problem.model import Constraint, Keeper


@record
class Reaction:
    """The reaction that maintains one constraint.

    multiplier  λ
    directions  of the force on each particle that it acts on: R_P = λ · direction; None if they are not determined
    moments     likewise of its moment on each body, about the mass centre: Γ = λ · moment
    others      a_k of the coordinates that move no particle: the generalized force on them is λ a_k
    rod         the distance that is kept, if the constraint keeps one
    on_body     whether it acts on mass centres of rigid bodies only: then a contact keeps a distance, and no rod
    rough       the same if it is a surface, on which something slides with friction or as the file says: no tension
    single      the single force that it is; None if it is none
    is_partial  whether only the part of it along the ways that coordinates leave is known
    symbol      of that force, if it is not λ; `named` if the file gives it
    """

    constraint: Constraint
    row: Row
    multiplier: sp.Symbol
    directions: Mapping[str, Vector] | None
    others: Mapping[sp.Symbol, sp.Expr]
    rod: Rod | None = None
    symbol: sp.Symbol | None = None
    named: bool = False
    moments: Mapping[str, Vector] = field(default_factory=dict)
    on_body: bool = False
    rough: Rod | None = None
    single: SingleForce | None = None
    is_partial: bool = False

    @property
    def name(self) -> str:
        """The constraint's name."""
        return self.row.name

    @property
    def force(self) -> sp.Symbol:
        """The unknown that expresses it: the force if the file names it, otherwise λ."""
        return self.symbol if self.named and self.symbol is not None else self.multiplier

    @property
    def per_force(self) -> sp.Expr:
        """λ for `force` = 1."""
        return 1 / self.single.factor if self.named and self.single is not None else sp.S.One

    @property
    def given(self) -> sp.Symbol | None:
        """The name that the file gives to the reaction; None if it gives none."""
        return self.force if self.named or self.force != self.row.multiplier else None

    @property
    def tension(self) -> sp.Symbol | None:
        """The symbol of the tension; None if it is no tension or has no symbol."""
        is_tension = self.single is not None and self.single.kind is ForceKind.TENSION
        return self.symbol_of_force if is_tension else None

    @property
    def symbol_of_force(self) -> sp.Symbol | None:
        """The symbol of the single force, which is λ if the factor is 1; None if it has none."""
        is_multiplier = self.single is not None and self.single.factor == 1
        return self.multiplier if is_multiplier else self.symbol

    @property
    def called(self) -> str:
        """What the unknown in which it is written is: a tension, a force, or a multiplier."""
        if self.given is None or self.single is None:
            return "multiplier"
        return "force" if self.tension is None else "tension"

    def per_unit(self, particle: str) -> Vector | None:
        """The force on a particle for `force` = 1; None if it does not act there."""
        single = self.single
        along = None if single is None else single.direction
        if self.given is not None and single is not None and along is not None:
            both = {single.opposite: -along, single.on: along}  # in full, also where one can be placed on a line only
            if particle in both:
                return both[particle]
        return self._for_unit(self.on(particle))

    def moment_per_unit(self, body: str) -> Vector | None:
        """The moment on a body for `force` = 1; None if it has none."""
        return self._for_unit(self.moments.get(body))

    def _for_unit(self, direction: Vector | None) -> Vector | None:
        if direction is None or self.per_force == 1:
            return direction
        return direction.map(lambda c: tidy_quotient(c * self.per_force))

    @property
    def acts_on(self) -> tuple[str, ...]:
        """The names of the particles and bodies that it acts on."""
        return tuple(dict.fromkeys((*(self.directions or ()), *self.moments)))

    @property
    def is_normal(self) -> bool:
        """Whether it is the force of a surface on one particle."""
        alone = self.directions is not None and len(self.directions) == 1 and not self.others and not self.moments
        return alone and self.row.finite is not None and self.rod is None and not self.is_partial

    def on(self, particle: str) -> Vector | None:
        """The direction of the force on a particle; None if it does not act there."""
        return None if self.directions is None else self.directions.get(particle)


@record
class LawComponent:
    """One component of Newton's law, along the unit vector `along`: inertia = applied + reaction."""

    along: Vector
    inertia: sp.Expr
    applied: sp.Expr
    reaction: sp.Expr

    @property
    def right(self) -> sp.Expr:
        """The right side, applied + reaction."""
        return self.applied + self.reaction


@record
class FreeBody:
    """A particle or rigid body with all forces that act on it.

    loads       names of the applied forces
    applied     their sum
    reactions   the reactions on it, each with its force for `force` = 1
    components  of Newton's law, in the directions in which the particle or mass centre can be placed
    moments     the reactions with a moment about the mass centre, each with its moment for `force` = 1
    turning     components of the law of angular momentum, about the axes about which the body can be turned
    """

    particle: MassPoint
    loads: tuple[str, ...]
    applied: Vector
    reactions: tuple[tuple[Reaction, Vector], ...]
    components: tuple[LawComponent, ...]
    moments: tuple[tuple[Reaction, Vector], ...] = ()
    turning: tuple[LawComponent, ...] = ()

    @property
    def name(self) -> str:
        """The particle's or body's name."""
        return self.particle.name

    @property
    def laws(self) -> tuple[LawComponent, ...]:
        """The components of both laws."""
        return (*self.components, *self.turning)

    @property
    def bound(self) -> tuple[Reaction, ...]:
        """The reactions that act on it."""
        with_force = [r for r, _ in self.reactions]
        return (*with_force, *(r for r, _ in self.moments if r not in with_force))


@record
class Count:
    """The numbers of unknowns and equations."""

    unknowns: int
    equations: int

    @property
    def missing(self) -> int:
        """How many equations are missing."""
        return self.unknowns - self.equations


@record
class Newton:
    """Newton's law for every particle.

    bodies           the free bodies; None if the coordinates do not place the particles one by one
    idle             the right sides of 0 = Q_k + Σ λ_j a_k, for each coordinate that moves no particle
    before           the count with unknown directions: one unknown for each component of a reaction
    after            the count with known directions: one unknown multiplier for each constraint
    """

    reactions: tuple[Reaction, ...]
    bodies: tuple[FreeBody, ...] | None
    idle: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    before: Count | None = None
    after: Count | None = None

    @property
    def single_forces(self) -> dict[sp.Symbol, sp.Expr]:
        """The forces with symbols of their own, each as a multiple of its multiplier."""
        return {r.symbol: r.single.factor * r.multiplier for r in self.reactions if r.single and r.symbol is not None}

    @property
    def multipliers_by_name(self) -> dict[str, sp.Symbol]:
        """The multipliers of the constraints, by their names."""
        return {r.name: r.multiplier for r in self.reactions}

    @property
    def in_tensions(self) -> Newton:
        """The same with the tensions of rods and strings as unknowns instead of their multipliers."""
        with_symbol = {r.multiplier: replace(r, named=True) for r in self.reactions if r.tension and r.symbol}
        if not with_symbol:
            return self
        reactions = {r.name: with_symbol.get(r.multiplier, r) for r in self.reactions}
        per_tension = {r.multiplier: r.symbol * r.per_force for r in with_symbol.values() if r.symbol is not None}

        def rewritten(c: LawComponent) -> LawComponent:
            terms = (shorter_product(e.xreplace(per_tension)) for e in sp.Add.make_args(c.reaction))
            return replace(c, reaction=sp.Add(*terms))

        def acting(pairs: tuple[tuple[Reaction, Vector], ...]) -> tuple[tuple[Reaction, Vector], ...]:
            shares = ((reactions[r.name], g * (reactions[r.name].per_force / r.per_force)) for r, g in pairs)
            return tuple((r, g.map(tidy_quotient)) for r, g in shares)

        bodies = (
            None
            if self.bodies is None
            else tuple(
                replace(
                    b,
                    reactions=acting(b.reactions),
                    moments=acting(b.moments),
                    components=tuple(map(rewritten, b.components)),
                    turning=tuple(map(rewritten, b.turning)),
                )
                for b in self.bodies
            )
        )
        idle = {q: e.xreplace(per_tension) for q, e in self.idle.items()}
        return replace(self, reactions=tuple(reactions.values()), bodies=bodies, idle=idle)

    @property
    def equations(self) -> tuple[tuple[sp.Expr, sp.Expr], ...] | None:
        """Left and right sides; None if there are no free bodies."""
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

    constraints  the constraints with the forms `configuration.rows`, in the same order
    rank         the number of independent constraints
    taken        names that already have a meaning, and cannot be that of a tension
    at_rest      without accelerations; then massless points count as particles on which reactions may act
    rough        names of constraints on which something slides with friction
    """
    placed = placed_freely(configuration)
    if at_rest and placed is not None:
        moving = {p.name for p in configuration.points if any(not e.is_zero for e in p.partials)}
        moving -= marks_on_bodies(configuration)
        placed = placed if moving <= {f.name for f in placed if not f.turning} else None
    reactions = tuple(
        _reaction(row, c, placed, configuration, taken, c.name in rough or c.by in SURFACES)
        for row, c in zip(configuration.rows, constraints, strict=True)
    )
    others = {q for r in reactions for q in r.others}
    idle = {
        q: sp.Add(*(r.force * r.others[q] * r.per_force for r in reactions if q in r.others), given)
        for q, given in zip(configuration.slots.coordinates, _given(configuration) if others else (), strict=False)
        if q in others
    }
    field_forces = None if placed is None else _field(placed, configuration)
    if placed is None or field_forces is None or any(r.directions is None for r in reactions):
        return Newton(reactions, None, idle)
    acting = _Acting(configuration, reactions, field_forces, at_rest)
    points = {p.name: p for p in configuration.points}
    names = dict.fromkeys(f.name for f in placed)
    bodies = tuple(_free_body(points[name], {f.turning: f for f in placed if f.name == name}, acting) for name in names)
    return Newton(reactions, bodies, idle, *_counts(configuration, bodies, idle, rank))


@record
class Normal:
    """A geometric constraint on one particle: its gradient ∇f there, and the rate −f_t, so that ∇f·dr = rate dt."""

    row: Row
    particle: str
    gradient: Vector
    rate: sp.Expr


def normals(configuration: Configuration) -> tuple[Normal, ...]:
    """The gradients of the geometric constraints on a single particle."""
    placed = placed_freely(configuration)
    gradients = []
    for row in configuration.rows if placed else ():
        acts = None if row.finite is None or placed is None else form_as_forces(row, placed, configuration.states)
        if acts is None or len(acts.forces) != 1 or acts.moments or idle_forces(row, configuration):
            continue
        [(particle, gradient)] = acts.forces.items()
        gradients.append(Normal(row, particle, gradient, textbook_form(-row.drift)))
    return tuple(gradients)


@record
class _Acting:
    """The forces on particles and bodies: reactions, and `field`, the forces of potentials and dampers."""

    configuration: Configuration
    reactions: tuple[Reaction, ...]
    field: Forces
    at_rest: bool


def _given(configuration: Configuration) -> tuple[sp.Expr, ...]:
    """The generalized forces that the file gives, and those of the potentials, shape (n,)."""
    coordinates, V = configuration.slots.coordinates, configuration.potential
    given = given_forces(configuration) or (sp.S.Zero,) * len(coordinates)
    return tuple(q - partial(V, c) for q, c in zip(given, coordinates, strict=True))


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
    row: Row,
    constraint: Constraint,
    placed: Placed | None,
    configuration: Configuration,
    taken: frozenset[str],
    is_surface: bool,
) -> Reaction:
    others = idle_forces(row, configuration)
    shown = without_root(row, configuration.slots)
    acts = None if placed is None else form_as_forces(shown, placed, configuration.states)
    rod, stated = None, stated_length(constraint, row, placed, configuration.slots)
    if acts is not None and acts.forces and not others and not acts.moments:
        rod = recognised_rod(shown, configuration, dict(acts.forces), stated)
    ends_elsewhere = rod is not None and not is_length(rod.length, stated)
    rod = None if ends_elsewhere else rod
    if rod is not None and constraint.side is not None:
        is_surface = is_surface or not (constraint.side * rod.factor).is_positive
    if acts is not None and rod is not None:
        acts = Forces(along_rod(rod, acts.forces), acts.moments)
    by = constraint.by or (Keeper.SURFACE if is_surface else Keeper.ROD if ends_elsewhere else None)
    leads = ends_elsewhere or (rod is None and is_led(shown, acts, placed, configuration))
    if acts is not None and rod is not None and not is_surface:
        single: SingleForce | None = tension_of_rod(rod, acts.forces)
    else:
        written = row if placed is None else shown  # where nothing is placed, only a root shows a distance
        single = single_force(
            written, by, acts, placed, configuration, constraint, row, leads=leads, is_whole=not others
        )
    unnamed = Reaction(
        constraint=constraint,
        row=row,
        multiplier=constraint.reaction,
        directions=None if acts is None else acts.forces,
        others=others,
        rod=None if is_surface else rod,
        moments={} if acts is None else acts.moments,
        rough=rod if is_surface else None,
        single=single,
        is_partial=leads,
        on_body=acts is not None and by is None and set(acts.forces) <= {r.name for r in configuration.rotations},
    )
    return _with_symbol(unnamed, taken)


def _with_symbol(reaction: Reaction, taken: frozenset[str]) -> Reaction:
    """The reaction with a symbol for the force, if that is not λ: the name that the file gives, or T for a rod."""
    given, own, single = reaction.constraint.reaction, reaction.row.multiplier, reaction.single
    if single is None or single.factor == 1:
        return reaction
    if given != own:
        while own.name in taken:
            own = sp.Symbol(f"{own.name}_", real=True)
        return replace(reaction, multiplier=own, symbol=given, named=True)
    tension = sp.Symbol(f"T_{reaction.row.name}", real=True)
    return reaction if reaction.rod is None or tension.name in taken else replace(reaction, symbol=tension)


def _field(placed: Placed, configuration: Configuration) -> Forces | None:
    """−∂V/∂r_P for each particle, with the forces of the dampers, and the moments of both; None: not found."""
    potential, slots = configuration.potential, configuration.slots
    others = given_forces(configuration)
    if potential == 0 and not configuration.dampers and not others:
        return Forces({}, {})
    resistance = [sp.Add(*(d.pull * d.distance.diff(q) for d in configuration.dampers)) for q in slots.coordinates]
    slopes = tuple(-partial(potential, q) - r for q, r in zip(slots.coordinates, resistance, strict=True))
    slopes = tuple(sp.Add(*pair) for pair in zip(slopes, others or (sp.S.Zero,) * len(slopes), strict=True))
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
) -> tuple[LawComponent, ...]:
    """factor · rate = applied + reactions, along the unit vectors of a freedom."""
    if freedom is None:
        return ()
    return tuple(
        LawComponent(
            unit,
            factor * textbook_form(rate.dot(unit)) if factor != 0 else factor,
            textbook_form(applied.dot(unit)),
            sp.Add(*(r.force * shorter_product(g.dot(unit)) for r, g in acting)),
        )
        for unit in freedom.units
    )


@record
class WorkOfReaction:
    """The work of one reaction.

    virtual    Σ_P R_P·δr_P for `Reaction.force` = 1, before the dependent δq are substituted
    shares     R_P·δr_P of each particle, likewise; empty if the directions are not known
    vanishes   whether the sum is zero in every virtual displacement; None: undecided
    working    names of the particles on which it does virtual work
    possible   its work in a possible displacement
    """

    reaction: Reaction
    virtual: sp.Expr
    shares: Mapping[str, sp.Expr]
    vanishes: bool | None
    working: tuple[str, ...]
    possible: sp.Expr


def works_of_reactions(newton: Newton, configuration: Configuration, elimination: Elimination) -> list[WorkOfReaction]:
    """The works of all reactions of a configuration."""
    return [_work(r, configuration, elimination) for r in newton.reactions]


def _work(reaction: Reaction, configuration: Configuration, elimination: Elimination) -> WorkOfReaction:
    slots, surface = configuration.slots, configuration.states
    shares: dict[str, sp.Expr] = {}
    drift = -reaction.row.drift * reaction.per_force
    for p in configuration.points:
        direction = reaction.per_unit(p.name)
        if direction is not None:
            partials = zip(slots.coordinates, p.partials, strict=True)
            shares[p.name] = sp.Add(
                *(shorter_product(direction.dot(along)) * variation(q) for q, along in partials if not along.is_zero)
            )
            drift = drift + direction.dot(p.position.frozen_derivative(slots))
    for r in configuration.rotations:
        moment = reaction.moment_per_unit(r.name)
        if moment is not None:
            turned = zip(slots.coordinates, r.partials, strict=True)
            work = (textbook_form(moment.dot(about)) * variation(q) for q, about in turned if not about.is_zero)
            shares[r.name] = sp.Add(shares.get(r.name, sp.S.Zero), *work)
            drift = drift + moment.dot(r.angular_velocity - r.virtual(slots.velocities))
    on_others = sp.Add(*(a * reaction.per_force * variation(q) for q, a in reaction.others.items()))
    is_known = reaction.directions is not None and (shares or on_others != 0)
    form = virtual_displacement(reaction.row, slots)
    per_force = form if reaction.per_force == 1 else textbook_form(form * reaction.per_force)
    virtual = sp.Add(*shares.values(), on_others) if is_known else per_force
    solved = dict(elimination.solved(slots))
    # The independent δq are random at every point.
    vanishes = cache(lambda work: surface.is_zero(work.xreplace(solved)))
    working = tuple(name for name, work in shares.items() if vanishes(work) is False)
    possible = textbook_form(drift) * reaction.force * differential(t)
    return WorkOfReaction(
        reaction=reaction,
        virtual=virtual,
        shares=shares,
        vanishes=vanishes(virtual),
        working=working,
        possible=sp.S.Zero if surface.is_zero(drift) else possible,
    )


def short_reactions(newton: Newton, used: Collection[str]) -> Iterator[tuple[sp.Symbol, str]]:
    """Reactions and multipliers with the shorter names of a page: T of the only rod, T_upper, λ_1 of rolling.1.

    Words that all names end in are dropped. `used` are letters that mean something else.
    """
    endings = _distinct([r.name for r in newton.reactions])
    for r, ending in zip(newton.reactions, endings, strict=True):
        for symbol in dict.fromkeys(s for s in (r.multiplier, r.symbol) if s is not None):
            letter, _, index = symbol.name.partition("_")
            short = f"{letter}_{ending.replace('.', '_')}" if ending else letter
            if index in (r.name, r.name.replace(".", "_")) and short != symbol.name and short not in used:
                yield symbol, short


def _distinct(names: list[str]) -> list[str]:
    """The names without what all of them end in: upper and lower for upper_rod and lower_rod; 1 and 2 of rolling."""
    if len(names) == 1:
        return [""]
    if len(wholes := {n.rpartition(".")[0] for n in names}) == 1 and wholes != {""}:
        return [n.rpartition(".")[2] for n in names]
    words = [n.split("_") for n in names]
    while all(w[1:] for w in words) and len({w[-1] for w in words}) == 1:
        words = [w[:-1] for w in words]
    return ["_".join(w) for w in words]
