"""The system in one set of coordinates: r(q, t), v = dr/dt, a = dv/dt, and the virtual displacements δr.

With the coordinates q of a configuration,

    v = Σ (∂r/∂q_k) q_k' + ∂r/∂t ,     δr = Σ (∂r/∂q_k) δq_k   (time frozen) .

A rigid body is its mass centre, a point with the mass, and a rotation (`rigid_bodies.py`). A force at another point r_A
of the body acts at the mass centre as well, with the moment (r_A − r_G) × F.

The same functions serve the file's own coordinates and every choice of generalized coordinates: a choice is another
configuration, with the positions, forces and remaining constraints rewritten in its coordinates.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Slots, free_letter, partial, prime, t, variation
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem, Row
from lagrange.mechanics.constraints.springs_dampers import (
    DamperForce,
    StretchedSpring,
    damper_forces,
    rewritten_damper,
    rewritten_spring,
    stretched_springs,
)
from lagrange.mechanics.constraints.variable_mass import (
    REACTIVE,
    VariableMass,
    mass_terms,
    reactive_force,
    rewritten_mass,
    variable_masses,
)
from lagrange.problem.model import AppliedForce, AppliedMoment, GeneralizedForce, Potential, Problem, Range

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation

POTENTIAL_LETTER = sp.Symbol("V", real=True)


@record
class Load:
    """An applied force and its point of application; `elsewhere`: not at the position of the particle it acts on.

    On a body any point is allowed: the arm from the mass centre gives the force a moment.
    """

    name: str
    on: str
    vector: Vector
    point: Vector
    elsewhere: bool = False


@record
class Torque:
    """An applied moment on a rigid body."""

    name: str
    on: str
    vector: Vector


@record
class MassPoint:
    """A particle or mass centre and its motion. `partials`, shape (n,): the vectors ∂r/∂q_k."""

    name: str
    mass: sp.Expr
    position: Vector
    velocity: Vector
    acceleration: Vector
    partials: tuple[Vector, ...]


@record
class Configuration:
    """The system in one set of coordinates.

    name        of the choice of generalized coordinates; empty for the file's own coordinates
    constrained  the coordinates, and the constraints that they still have to satisfy
    points      the particles, and the mass centres of the bodies
    loads       the applied forces, weights included
    potential   the potential energy of the given potentials and of the springs
    expressed   each old coordinate that is replaced, in the present coordinates
    springs     the springs
    dampers     the dampers
    rotations   of the bodies
    torques     the applied moments
    ranges      of the coordinates that have one
    bounded     the replaced coordinates with a range that are no angles, in the present ones
    velocity_part  what the Lagrangian has beside T − V: terms of a given Lagrangian, or of potentials, with velocities
    generalized  shape (n,), or none: the generalized forces that the file gives as such
    is_outright  whether the file gives the Lagrangian: then there are no masses, and −V is its part without velocities
    variable_masses  the particles whose mass varies; their reactive forces are among the loads
    potential_letter  V, or another letter where the file uses that otherwise
    """

    name: str
    constrained: ConstrainedSystem
    points: tuple[MassPoint, ...]
    loads: tuple[Load, ...]
    potential: sp.Expr
    expressed: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    springs: tuple[StretchedSpring, ...] = ()
    dampers: tuple[DamperForce, ...] = ()
    rotations: tuple[Rotation, ...] = ()
    torques: tuple[Torque, ...] = ()
    ranges: Mapping[sp.Symbol, Range] = field(default_factory=dict)
    velocity_part: sp.Expr = sp.S.Zero
    generalized: tuple[sp.Expr, ...] = ()
    is_outright: bool = False
    variable_masses: tuple[VariableMass, ...] = ()
    potential_letter: sp.Symbol = POTENTIAL_LETTER
    bounded: tuple[tuple[sp.Expr, Range], ...] = ()

    @property
    def potential_variation(self) -> sp.Expr:
        """δV = Σ ∂V/∂q δq: the forces with the potential V do the virtual work −δV."""
        slopes = ((q, textbook_form(partial(self.potential, q))) for q in self.slots.coordinates)
        return sp.Add(*(slope * variation(q) for q, slope in slopes))

    @property
    def velocity_potential(self) -> sp.Expr:
        """U = −X, where X is the `velocity_part`."""
        return sp.expand(-self.velocity_part)

    @property
    def slots(self) -> Slots:
        """The coordinates and the prescribed motions."""
        return self.constrained.slots

    @property
    def rows(self) -> tuple[Row, ...]:
        """The constraints that these coordinates still have to satisfy."""
        return self.constrained.rows

    @property
    def finite_constraints(self) -> tuple[sp.Expr, ...]:
        """The finite relations f(q, t) = 0 among the rows."""
        return self.constrained.finite_constraints

    @property
    def surface(self) -> Surface:
        """The generic points where the finite relations hold."""
        return self.constrained.surface

    @property
    def states(self) -> Surface:
        """Where forms have their ranks: `ConstrainedSystem.states`."""
        return self.constrained.states

    @property
    def accelerated_constraints(self) -> tuple[sp.Expr, ...]:
        """d/dt of the velocity form of each row."""
        return self.constrained.accelerated_constraints

    @property
    def satisfies_constraints_itself(self) -> bool:
        """Whether fewer coordinates place the points and bodies than would place them freely: a pivot, a rod or a
        surface is built into the positions.

        Points move freely along the directions i, j, k that occur in any position; a body also turns, about k or in
        space, and its mass centre is free in the plane at least.
        """
        return len(self.slots.coordinates) - len(self.rows) < self._free_directions

    @property
    def has_forces_built_in(self) -> bool:
        """Whether the coordinates that move something are too few for it to move freely: forces hold it on its path
        for which no constraint stands."""
        vectors = [*(p.position.fixed() for p in self.points), *(r.angular_velocity.fixed() for r in self.rotations)]
        parts = {s for v in vectors for c in v.components for s in c.free_symbols}
        slots = self.slots
        used = [q for q, v in zip(slots.coordinates, slots.velocities, strict=True) if {q, v} & parts]
        return len(used) < self._free_directions

    @property
    def _free_directions(self) -> int:
        """How many coordinates would place the points and bodies freely."""
        slots = self.slots
        moving = {*slots.coordinates, *slots.prescribed, t}
        fixed = [p.position.fixed().components for p in self.points]
        used = sum(any(not c[n].free_symbols.isdisjoint(moving) for c in fixed) for n in range(3))
        turned = [sum(c != 0 for c in r.angular_velocity.fixed().components) for r in self.rotations]
        directions = max(used, 2 if turned else 0, 3 if any(n > 1 for n in turned) else 0)
        return directions * len(self.points) + sum(3 if n > 1 else 1 for n in turned)

    @property
    def links(self) -> tuple[StretchedSpring | DamperForce, ...]:
        """The springs and the dampers."""
        return (*self.springs, *self.dampers)

    @property
    def has_field(self) -> bool:
        """Whether the potential energy is more than that of the springs."""
        return bool(self.potential - sp.Add(*(s.energy for s in self.springs)) != 0)

    @property
    def particles(self) -> tuple[MassPoint, ...]:
        """The points that are not mass centres of bodies."""
        turning = {r.name for r in self.rotations}
        return tuple(p for p in self.points if p.name not in turning)

    @property
    def positive(self) -> tuple[sp.Expr, ...]:
        """The quantities positive in every state, though not by themselves: spring lengths, variable masses."""
        lengths = tuple(s.distance for s in self.springs if not s.distance.is_nonnegative)
        return (*lengths, *(m.mass for m in self.variable_masses if not m.mass.is_positive))

    def loads_beside(self, body: str) -> tuple[Load, ...]:
        """The applied forces on a body that do not act at its mass centre."""
        [centre] = (p.position for p in self.points if p.name == body)
        return tuple(f for f in self.loads if f.on == body and not (f.point - centre).is_zero)

    def moments_on(self, body: str) -> tuple[Vector, ...]:
        """The applied moments on a body, and the moments about its mass centre of forces that act elsewhere on it."""
        [centre] = (p.position for p in self.points if p.name == body)
        of_forces = [(f.point - centre).cross(f.vector) for f in self.loads_beside(body)]
        moments = (*of_forces, *(m.vector for m in self.torques if m.on == body))
        return tuple(m for m in moments if not m.is_zero)

    def moment_on(self, body: str) -> Vector:
        """The sum of these moments, in the triad of the angular momentum."""
        [rotation] = (r for r in self.rotations if r.name == body)
        triad = rotation.angular_velocity.triad
        return sum(self.moments_on(body), Vector.zero(triad)).along(triad).map(textbook_form)

    def is_pinned(self, point: MassPoint) -> bool:
        """Whether a point is the fixed mass centre of a body."""
        fixed = all(v.is_zero for v in (*point.partials, point.velocity))
        return fixed and any(r.name == point.name for r in self.rotations)

    @cached_property
    def mass_terms(self) -> tuple[sp.Expr, ...]:
        """What Lagrange's expression with T contains of the rates of masses beyond m r''; none if no mass varies."""
        return mass_terms(self.variable_masses, {p.name: p.position for p in self.points}, self.slots)

    def rewritten(self, expression: sp.Expr) -> sp.Expr:
        """An expression of the file's coordinates, velocities and accelerations in the present ones."""
        return expression.xreplace(self.substitution) if self.expressed else expression

    @cached_property
    def substitution(self) -> dict[sp.Basic, sp.Basic]:
        """q, q', q'' of each replaced coordinate -> their expressions."""
        rule: dict[sp.Basic, sp.Basic] = {}
        for q, e in self.expressed.items():
            velocity = self.slots.time_derivative(e)
            rule |= {q: e, prime(q): velocity, prime(q, 2): self.slots.time_derivative(velocity)}
        return rule


def applied_loads(problem: Problem) -> tuple[Load, ...]:
    """The weights and reactive forces, then the forces in the order of the file."""
    loads = []
    for p in problem.masses:
        if problem.gravity is not None and p.mass != 0:
            loads.append(Load("weight", p.name, problem.gravity * p.mass, p.position))
    for particle in problem.particles:
        if particle.exchange is not None:
            force = reactive_force(particle, problem.slots)
            loads += [] if force.is_zero else [Load(REACTIVE, particle.name, force, particle.position)]
    positions = {p.name: p.position for p in problem.masses}
    bodies = {b.name for b in problem.bodies}
    for f in problem.forces:
        if isinstance(f, AppliedForce):
            loads.append(Load(f.name, f.on, f.vector, f.at or positions[f.on], f.at is not None and f.on not in bodies))
    return tuple(loads)


def _rotations(problem: Problem) -> tuple[Rotation, ...]:
    if not problem.bodies:
        return ()
    from lagrange.mechanics.constraints.rigid_bodies import rotation_of

    return tuple(rotation_of(b, problem.slots) for b in problem.bodies)


def file_configuration(problem: Problem, constrained: ConstrainedSystem) -> Configuration:
    """The system in the coordinates of the file."""
    springs = stretched_springs(problem)
    energies = [f.energy for f in problem.forces if isinstance(f, Potential)]
    if problem.lagrangian is not None:
        energies.append(-problem.lagrangian)
    static, moving = with_velocities_apart(energies, problem.slots)
    return Configuration(
        name="",
        constrained=constrained,
        points=tuple(_moving(p.name, p.mass, p.position, problem.slots) for p in problem.masses),
        loads=applied_loads(problem),
        potential=sp.Add(static, *(s.energy for s in springs)),
        springs=springs,
        dampers=damper_forces(problem),
        rotations=_rotations(problem),
        torques=tuple(Torque(f.name, f.on, f.moment) for f in problem.forces if isinstance(f, AppliedMoment)),
        ranges={q.symbol: q.range for q in problem.coordinates if q.range is not None},
        velocity_part=-moving,
        generalized=_given_forces(problem),
        is_outright=problem.lagrangian is not None,
        variable_masses=variable_masses(problem),
        potential_letter=sp.Symbol(free_letter("V", "U", "V_pot", taken=problem.scope.names()), real=True),
    )


def with_velocities_apart(energies: Sequence[sp.Expr], slots: Slots) -> tuple[sp.Expr, sp.Expr]:
    """The part of potentials that is left without velocities, and the rest; 0 and all where there is no such part."""
    static, moving = [], []
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    for energy in energies:
        if energy.free_symbols.isdisjoint(slots.velocities):
            static.append(energy)
            continue
        rest = energy.xreplace(at_rest)
        if rest.has(sp.nan, sp.zoo, sp.oo):
            moving.append(energy)
            continue
        static.append(rest)
        terms = sp.Add.make_args(sp.expand(energy))
        kept = [e for e in terms if not e.free_symbols.isdisjoint(slots.velocities)]
        free = all(e.xreplace(at_rest) == 0 for e in kept)
        moving.append(sp.Add(*kept) if free else energy - rest)
    return sp.Add(*static), sp.Add(*moving)


def _given_forces(problem: Problem) -> tuple[sp.Expr, ...]:
    """Q_k of the generalized forces that the file gives; none if there are none."""
    given = [f.components for f in problem.forces if isinstance(f, GeneralizedForce)]
    if not given:
        return ()
    return tuple(sp.Add(*(f.get(q, sp.S.Zero) for f in given)) for q in problem.slots.coordinates)


def substituted_configuration(
    original: Configuration,
    name: str,
    coordinates: tuple[sp.Symbol, ...],
    expressed: Mapping[sp.Symbol, sp.Expr],
    rows: tuple[Row, ...],
) -> Configuration:
    """The same system in other coordinates; `expressed` gives each coordinate that is replaced."""
    slots = Slots(coordinates, original.slots.prescribed)
    constrained = ConstrainedSystem(slots, rows)
    blank = Configuration(name, constrained, (), (), sp.S.Zero, expressed)
    rule = blank.substitution
    places = [*original.finite_constraints, *(c for p in original.points for c in p.position.fixed().components)]

    def turns(q: sp.Symbol) -> bool:
        return any(q in f.free_symbols for e in places for f in e.atoms(sp.sin, sp.cos, sp.tan))

    points = tuple(_moving(p.name, p.mass.xreplace(rule), p.position.xreplace(rule), slots) for p in original.points)
    loads = tuple(replace(f, vector=f.vector.xreplace(rule), point=f.point.xreplace(rule)) for f in original.loads)
    springs = tuple(rewritten_spring(s, rule) for s in original.springs)
    others = original.potential - sp.Add(*(s.energy for s in original.springs))
    rotations: tuple[Rotation, ...] = ()
    if original.rotations:
        from lagrange.mechanics.constraints.rigid_bodies import rotation_in

        rotations = tuple(rotation_in(r, dict(expressed), rule, slots) for r in original.rotations)
    return Configuration(
        name,
        constrained,
        points,
        loads,
        sp.Add(others.xreplace(rule), *(s.energy for s in springs)),
        expressed,
        springs,
        dampers=tuple(rewritten_damper(d, rule, slots) for d in original.dampers),
        rotations=rotations,
        torques=tuple(Torque(m.name, m.on, m.vector.xreplace(rule)) for m in original.torques),
        ranges={q: r for q, r in original.ranges.items() if q in coordinates},
        velocity_part=original.velocity_part.xreplace(rule),
        generalized=_pulled_back(original, expressed, rule, coordinates),
        is_outright=original.is_outright,
        variable_masses=tuple(rewritten_mass(m, rule, slots) for m in original.variable_masses),
        bounded=tuple((expressed[q], r) for q, r in original.ranges.items() if q in expressed and not turns(q)),
    )


def _pulled_back(
    original: Configuration,
    expressed: Mapping[sp.Symbol, sp.Expr],
    rule: Mapping[sp.Basic, sp.Basic],
    coordinates: Sequence[sp.Symbol],
) -> tuple[sp.Expr, ...]:
    """Q_s = Σ Q_k ∂q_k/∂s, of generalized forces that are given in the old coordinates q."""
    if not original.generalized:
        return ()
    old = [expressed.get(q, q) for q in original.slots.coordinates]
    forces = [f.xreplace(rule) for f in original.generalized]
    return tuple(sp.Add(*(f * partial(e, s) for f, e in zip(forces, old, strict=True))) for s in coordinates)


def _moving(name: str, mass: sp.Expr, position: Vector, slots: Slots) -> MassPoint:
    velocity = position.time_derivative(slots)
    acceleration = velocity.time_derivative(slots)
    partials = tuple(position.partial(q) for q in slots.coordinates)
    return MassPoint(name, mass, position, velocity, acceleration, partials)
