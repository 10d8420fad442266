"""Newton's law with reactions, before any principle is called in: free bodies, equations, unknowns.

    m r'' = F + R ,     R = Σ_j λ_j ∂f_j/∂r     (for a constraint on velocities λ_j ∂φ_j/∂r') .

A constraint is given by its form Σ a_k dq_k + a_t dt. Its direction at a particle P is the vector g_P with

    Σ_P g_P·∂r_P/∂q_k = a_k       for every coordinate q_k that moves a particle,

a combination of the vectors ∂r_P/∂q_k: it is ∂f/∂r_P where the coordinates place every particle freely in its space or
plane. Where they keep it on a surface or curve by themselves, the reaction of that is perpendicular to those vectors,
and Newton's law is written along them only. Where coordinates place one particle with another by themselves, there is
no such list: directions are None, as they are where there are rigid bodies. A coordinate that moves no particle has
λ_j a_k as its generalized force.

Before directions are used, each particle on which reactions act has an unknown for each component; after, each
constraint has one: its multiplier.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from lagrange.exact import Surface
from lagrange.kinematics import Configuration, MassPoint, Row
from lagrange.linear import solved_linear, tidy_quotient
from lagrange.notation import multiplier
from lagrange.problem import Constraint
from lagrange.rods import Rod, recognised_rod
from lagrange.textbook import textbook_form
from lagrange.vectors import Vector


@dataclass(frozen=True)
class Reaction:
    """What keeps one constraint.

    multiplier  λ
    directions  of the force on each particle that it acts on: R_P = λ · direction; None where they are not determined
    others      a_k of the coordinates that move no particle: the generalized force on them is λ a_k
    rod         the distance that is kept, where it is one
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
        direction = self.on(particle)
        if direction is None or self.per_force == 1:
            return direction
        return direction.map(lambda c: tidy_quotient(c * self.per_force))

    @property
    def is_normal(self) -> bool:
        """Whether it is the force of a surface on one particle."""
        alone = self.directions is not None and len(self.directions) == 1 and not self.others
        return alone and self.row.finite is not None and self.rod is None

    def on(self, particle: str) -> Vector | None:
        """The direction of the force on a particle; None where it does not act on it."""
        return None if self.directions is None else self.directions.get(particle)


@dataclass(frozen=True)
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


@dataclass(frozen=True)
class FreeBody:
    """A particle with all that acts on it.

    loads       names of the applied forces
    applied     their sum
    reactions   those that act on it, each with its force for `force` = 1
    components  of Newton's law, in the directions in which the particle can be placed
    """

    particle: MassPoint
    loads: tuple[str, ...]
    applied: Vector
    reactions: tuple[tuple[Reaction, Vector], ...]
    components: tuple[Component, ...]


@dataclass(frozen=True)
class Count:
    """Unknowns against equations."""

    unknowns: int
    equations: int

    @property
    def missing(self) -> int:
        """How many equations are missing."""
        return self.unknowns - self.equations


@dataclass(frozen=True)
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
        forms = ((c.inertia, c.right) for b in self.bodies for c in b.components)
        return (*forms, *((sp.S.Zero, right) for right in self.idle.values()))


def newton_equations(
    configuration: Configuration,
    constraints: Sequence[Constraint],
    rank: int,
    taken: frozenset[str] = frozenset(),
    at_rest: bool = False,
) -> Newton:
    """Newton's law for the particles of a configuration.

    constraints  those that `configuration.rows` are the forms of, in the same order
    rank         the number of independent constraints
    taken        names that have a meaning, and cannot be that of a tension
    at_rest      nothing is accelerated; then massless points count as particles on which reactions may act
    """
    if configuration.rotations:
        pairs = zip(configuration.rows, constraints, strict=True)
        return Newton(tuple(Reaction(c, row, c.reaction, None, {}) for row, c in pairs), None)
    placed = _placed(configuration)
    if at_rest and placed is not None:
        moving = {p.name for p in configuration.points if any(not e.is_zero for e in p.partials)}
        placed = placed if moving <= {p.name for p, _ in placed} else None
    reactions = tuple(
        _reaction(row, c, placed, configuration, taken) for row, c in zip(configuration.rows, constraints, strict=True)
    )
    idle = {
        q: sp.Add(*(r.force * r.others[q] for r in reactions if q in r.others))
        for q in configuration.slots.coordinates
        if any(q in r.others for r in reactions)
    }
    field_forces = None if placed is None else _field(placed, configuration)
    if placed is None or field_forces is None or any(r.directions is None for r in reactions):
        return Newton(reactions, None, idle)
    acting = _Acting(configuration, reactions, at_rest)
    bodies = tuple(_free_body(p, basis, field_forces.get(p.name), acting) for p, basis in placed)
    return Newton(reactions, bodies, idle, *_counts(configuration, bodies, idle, rank))


@dataclass(frozen=True)
class Normal:
    """A geometric constraint on one particle: its gradient ∇f there, so that ∇f·dr + f_t dt = 0."""

    row: Row
    particle: str
    gradient: Vector


def normals(configuration: Configuration) -> tuple[Normal, ...]:
    """The gradients of the geometric constraints that bind one particle and nothing else."""
    placed = _placed(configuration)
    found = []
    for row in configuration.rows if placed else ():
        directions = None if row.finite is None or placed is None else _directions(row, placed, configuration)
        alone = all(a == 0 or any(_moves(p, k) for p in configuration.points) for k, a in enumerate(row.coefficients))
        if directions is not None and len(directions) == 1 and alone:
            [(particle, gradient)] = directions.items()
            found.append(Normal(row, particle, gradient))
    return tuple(found)


@dataclass(frozen=True)
class _Acting:
    """What acts on particles."""

    configuration: Configuration
    reactions: tuple[Reaction, ...]
    at_rest: bool


def _counts(
    configuration: Configuration, bodies: Sequence[FreeBody], idle: Mapping[sp.Symbol, sp.Expr], rank: int
) -> tuple[Count, Count]:
    """Unknowns and equations before the directions of reactions are used, and after."""
    coordinates = len(configuration.slots.coordinates)
    components = sum(len(b.components) for b in bodies)
    of_reactions = sum(len(b.components) for b in bodies if b.reactions) + len(idle)
    equations = components + len(idle) + rank
    return (
        Count(coordinates + of_reactions, equations),
        Count(coordinates + len(configuration.rows), equations),
    )


Placed = tuple[tuple[MassPoint, tuple[int, ...]], ...]


def _placed(configuration: Configuration) -> Placed | None:
    """The particles that the coordinates place freely, each with the columns of its ∂r/∂q that are independent.

    None where the coordinates keep constraints by themselves.
    """
    anywhere = Surface((), configuration.slots.coordinates)
    moved = [
        k for k, _ in enumerate(configuration.slots.coordinates) if any(_moves(p, k) for p in configuration.points)
    ]
    chosen: list[tuple[MassPoint, tuple[int, ...]]] = []
    reached: set[int] = set()
    loaded = {load.on for load in configuration.loads}
    heavy_first = sorted(configuration.points, key=lambda p: (p.mass == 0, p.name not in loaded))
    for p in heavy_first:
        columns = [k for k in moved if _moves(p, k)]
        needed = p.mass != 0 or p.name in loaded or not reached.issuperset(columns)
        if not needed or not columns:
            continue
        reached.update(columns)
        basis: list[int] = []
        for k in columns:
            if anywhere.rank([p.partials[n].components for n in (*basis, k)]) == len(basis) + 1:
                basis.append(k)
        chosen.append((p, tuple(basis)))
    total = sum(len(basis) for _, basis in chosen)
    if total != len(moved) or not chosen or not _act_at_particles(configuration):
        return None
    stacked = [[c for p, _ in chosen for c in p.partials[k].fixed().components] for k in moved]
    if configuration.states.rank(stacked) != total:
        return None
    order = [p.name for p in configuration.points]
    return tuple(sorted(chosen, key=lambda pair: order.index(pair[0].name)))


def _act_at_particles(configuration: Configuration) -> bool:
    """Whether every applied force acts at the particle that it is said to act on, and not beside it."""
    positions = {p.name: p.position for p in configuration.points}
    return all(f.on in positions and (f.point - positions[f.on]).is_zero for f in configuration.loads)


def _moves(point: MassPoint, column: int) -> bool:
    return not point.partials[column].is_zero


def _reaction(
    row: Row, constraint: Constraint, placed: Placed | None, configuration: Configuration, taken: frozenset[str]
) -> Reaction:
    slots = configuration.slots
    others = {
        q: a
        for k, (q, a) in enumerate(zip(slots.coordinates, row.coefficients, strict=True))
        if a != 0 and not any(_moves(p, k) for p in configuration.points)
    }
    directions = None if placed is None else _directions(row, placed, configuration)
    rod = None
    if directions and not others:
        rod = recognised_rod(row, configuration.points, directions, slots, configuration.states)
    given = constraint.reaction
    if rod is None or directions is None:
        return Reaction(constraint, row, given, directions, others)
    directions = _along(rod, directions)
    own = multiplier(row.name.replace(".", "_"))
    if given != own and own.name not in taken:
        return Reaction(constraint, row, own, directions, others, rod, given, named=True)
    tension = sp.Symbol(f"T_{row.name}", real=True)
    free = tension.name not in taken
    return Reaction(constraint, row, given, directions, others, rod, tension if free else None)


def _along(rod: Rod, directions: Mapping[str, Vector]) -> dict[str, Vector]:
    """The whole force of a rod, also where the coordinates by themselves bear a part of it."""
    first, second = rod.ends
    found = dict(directions)
    for name, sign in ((first, 1), (second, -1)):
        whole = (rod.span * (sign * rod.ratio)).map(textbook_form)
        if name and not (whole - directions.get(name, Vector.zero())).map(textbook_form).is_zero:
            found[name] = whole
    return found


def _directions(row: Row, placed: Placed, configuration: Configuration) -> dict[str, Vector] | None:
    """g_P for each particle: Σ_P g_P·∂r_P/∂q_k = a_k, each g_P a combination of the ∂r_P/∂q; None: not found."""
    moved = [k for k, _ in enumerate(row.coefficients) if any(_moves(p, k) for p, _ in placed)]
    if all(row.coefficients[k] == 0 for k in moved):
        return {}
    slots = [(p, b) for p, basis in placed for b in basis]
    matrix = [
        [textbook_form(p.partials[b].dot(p.partials[k])) if _moves(p, k) else sp.S.Zero for p, b in slots]
        for k in moved
    ]
    found = solved_linear(matrix, [row.coefficients[k] for k in moved], configuration.states)
    if found is None or None in found:
        return None
    directions: dict[str, Vector] = {}
    for (p, b), c in zip(slots, found, strict=True):
        if c != 0 and c is not None:
            directions[p.name] = directions.get(p.name, Vector.zero(p.position.triad)) + p.partials[b] * c
    tidied = {name: g.map(lambda c: textbook_form(c) if c.count_ops() > 1 else c) for name, g in directions.items()}
    return {name: g for name, g in tidied.items() if not g.is_zero}


def _field(placed: Placed, configuration: Configuration) -> dict[str, Vector] | None:
    """−∂V/∂r_P for each particle, with the pull of the dampers; None: not found."""
    potential, slots = configuration.potential, configuration.slots
    if potential == 0 and not configuration.dampers:
        return {}
    resistance = [sp.Add(*(d.pull * d.distance.diff(q) for d in configuration.dampers)) for q in slots.coordinates]
    slopes = tuple(-potential.diff(q) - r for q, r in zip(slots.coordinates, resistance, strict=True))
    return _directions(Row("", slopes, sp.S.Zero), placed, configuration)


def _free_body(point: MassPoint, basis: Sequence[int], field_force: Vector | None, newton: _Acting) -> FreeBody:
    loads = [f for f in newton.configuration.loads if f.on == point.name]
    applied = sum((f.vector for f in loads), Vector.zero(point.position.triad))
    names = [f.name for f in loads]
    if field_force is not None:
        applied = applied + field_force
        names.append("")
    acting = tuple((r, g) for r in newton.reactions if (g := r.per_unit(point.name)) is not None)
    components = []
    for unit in _units(point, basis):
        inertia = sp.S.Zero if newton.at_rest else point.mass * textbook_form(point.acceleration.dot(unit))
        force = textbook_form(applied.dot(unit))
        components.append(
            Component(unit, inertia, force, sp.Add(*(r.force * textbook_form(g.dot(unit)) for r, g in acting)))
        )
    return FreeBody(point, tuple(names), applied, acting, tuple(components))


def _units(point: MassPoint, basis: Sequence[int]) -> list[Vector]:
    """The unit vectors along which Newton's law is written: those of the coordinates, or the particle's triad.

    They span the directions in which the particle can be placed.
    """
    partials = [p for p in point.partials if not p.is_zero]
    chosen = [point.partials[b] for b in basis]
    sizes = [textbook_form(p.dot(p)) for p in chosen]
    triad = point.position.triad
    used = [n for n in range(3) if any(p.along(triad).components[n] != 0 for p in partials)]
    aligned = len(used) == len(basis)
    orthonormal = all(size == 1 for size in sizes) and all(
        textbook_form(a.dot(b)) == 0 for n, a in enumerate(chosen) for b in chosen[:n]
    )
    if aligned and not (orthonormal and len(partials) == len(basis)):
        units = [tuple(sp.S.One if n == m else sp.S.Zero for m in range(3)) for n in used]
        return [Vector(u, triad) for u in units]
    return [(p / textbook_form(sp.sqrt(size))).map(textbook_form) for p, size in zip(chosen, sizes, strict=True)]
