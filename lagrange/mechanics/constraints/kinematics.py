"""A configuration, and how it moves: r(q, t), v = dr/dt, a = dv/dt, and the virtual displacements δr.

With the coordinates q of a configuration,

    v = Σ (∂r/∂q_k) q_k' + ∂r/∂t ,     δr = Σ (∂r/∂q_k) δq_k   (time frozen) .

A rigid body is its mass centre, a point with the mass, and a rotation (`rigid_bodies.py`). A force at another of its
points r_A acts at the mass centre too, and has the moment (r_A − r_G) × F.

The same functions serve the file's own coordinates and every choice of generalized coordinates: a choice is another
configuration, with the positions, forces and remaining constraints written in its coordinates.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property

import sympy as sp

from lagrange.algebra.exact.exact import Surface
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Slots, multiplier, prime
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.rigid_bodies import Rotation, rotation_in, rotation_of
from lagrange.mechanics.constraints.springs_dampers import (
    Damped,
    Stretched,
    damper_in,
    dampers_in,
    spring_in,
    stretched_springs,
)
from lagrange.problem.model import AppliedForce, AppliedMoment, Potential, Problem


@record
class Row:
    """One constraint in the coordinates of a configuration: what it asks of displacements.

    A Pfaffian form Σ a_i dq_i + a_t dt = 0 has a_i and a_t that depend on q and t. Where a constraint φ(q, q', t) = 0
    is not linear in the velocities, a_i = ∂φ/∂q_i' depend on them too, Σ a_i δq_i = 0 is Chetaev's rule, and

        a_t = φ − Σ a_i q_i'        so that Σ a_i q_i' + a_t = φ, as in a Pfaffian form.

    coefficients  shape (n,)
    drift         a_t
    finite        f(q, t), where the constraint is the finite relation f = 0; None for a constraint on velocities
    nonlinear     φ, where it is not linear in the velocities
    """

    name: str
    coefficients: tuple[sp.Expr, ...]
    drift: sp.Expr
    finite: sp.Expr | None = None
    nonlinear: sp.Expr | None = None

    @classmethod
    def by_chetaev(cls, name: str, function: sp.Expr, slots: Slots) -> Row:
        """The row of a constraint φ(q, q', t) = 0 that is not linear in the velocities."""
        coefficients = tuple(function.diff(v) for v in slots.velocities)
        powers = (a * v for a, v in zip(coefficients, slots.velocities, strict=True))
        return cls(name, coefficients, sp.Add(function, *(-p for p in powers)), nonlinear=function)

    @property
    def form(self) -> tuple[sp.Expr, ...]:
        """The coefficients of all differentials, dt among them, shape (n + 1,)."""
        return (*self.coefficients, self.drift)

    @property
    def multiplier(self) -> sp.Symbol:
        """λ with the constraint's name, that of the component C.x without its point."""
        return multiplier(self.name.replace(".", "_"))

    @property
    def is_identity(self) -> bool:
        """Whether it is written 0 = 0."""
        return self.drift == 0 and all(a == 0 for a in self.coefficients)

    def velocity_form(self, slots: Slots) -> sp.Expr:
        """Σ a_i q_i' + a_t, or φ."""
        if self.nonlinear is not None:
            return self.nonlinear
        terms = (a * v for a, v in zip(self.coefficients, slots.velocities, strict=True))
        return sp.Add(*terms, self.drift)


def is_pfaffian(rows: Iterable[Row]) -> bool:
    """Whether all constraints are linear in the velocities."""
    return all(r.nonlinear is None for r in rows)


def admitted_states(rows: Sequence[Row], slots: Slots) -> Surface:
    """The generic points (q, q', t) where the finite relations hold and the velocities satisfy all rows.

    Forms that depend on velocities have their ranks there.
    """
    finite = [r.finite for r in rows if r.finite is not None]
    return Surface([*finite, *(r.velocity_form(slots) for r in rows)], (*slots.coordinates, *slots.velocities))


@record
class Load:
    """An applied force and the point that it acts at; `elsewhere`: that is not where the particle is that it acts on.

    On a body it acts anywhere: the arm from the mass centre gives it a moment.
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
    slots       the coordinates and the prescribed motions
    points      the particles, and the mass centres of the bodies
    loads       the applied forces, weights included
    potential   the potential energy of what is given by a potential, and of the springs
    rows        the constraints that these coordinates still have to satisfy
    expressed   each old coordinate that is replaced, in the present coordinates
    springs     the springs
    dampers     the dampers
    rotations   of the bodies
    torques     the applied moments
    """

    name: str
    slots: Slots
    points: tuple[MassPoint, ...]
    loads: tuple[Load, ...]
    potential: sp.Expr
    rows: tuple[Row, ...]
    expressed: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    springs: tuple[Stretched, ...] = ()
    dampers: tuple[Damped, ...] = ()
    rotations: tuple[Rotation, ...] = ()
    torques: tuple[Torque, ...] = ()

    @property
    def links(self) -> tuple[Stretched | Damped, ...]:
        """The springs and the dampers."""
        return (*self.springs, *self.dampers)

    @property
    def particles(self) -> tuple[MassPoint, ...]:
        """The points that are not mass centres of bodies."""
        turning = {r.name for r in self.rotations}
        return tuple(p for p in self.points if p.name not in turning)

    def loads_beside(self, body: str) -> tuple[Load, ...]:
        """The applied forces on a body that do not act at its mass centre."""
        [centre] = (p.position for p in self.points if p.name == body)
        return tuple(f for f in self.loads if f.on == body and not (f.point - centre).is_zero)

    def moments_on(self, body: str) -> tuple[Vector, ...]:
        """The applied moments on a body, and those of the forces that do not act at its mass centre, about that."""
        [centre] = (p.position for p in self.points if p.name == body)
        found = [(f.point - centre).cross(f.vector) for f in self.loads_beside(body)]
        return tuple(m for m in (*found, *(m.vector for m in self.torques if m.on == body)) if not m.is_zero)

    def moment_on(self, body: str) -> Vector:
        """Their sum, along the axes that the angular momentum is along."""
        [rotation] = (r for r in self.rotations if r.name == body)
        triad = rotation.angular_velocity.triad
        return sum(self.moments_on(body), Vector.zero(triad)).along(triad).map(textbook_form)

    def is_pinned(self, point: MassPoint) -> bool:
        """Whether a point is the mass centre of a body, and stays where it is."""
        fixed = all(v.is_zero for v in (*point.partials, point.velocity))
        return fixed and any(r.name == point.name for r in self.rotations)

    @property
    def finite_constraints(self) -> tuple[sp.Expr, ...]:
        """The finite relations f(q, t) = 0 among the rows."""
        return tuple(r.finite for r in self.rows if r.finite is not None)

    @cached_property
    def surface(self) -> Surface:
        """The generic points where the finite relations hold."""
        return Surface(self.finite_constraints, self.slots.coordinates)

    @cached_property
    def states(self) -> Surface:
        """Where forms have their ranks: the surface, with `admitted_states` where forms depend on velocities."""
        return self.surface if is_pfaffian(self.rows) else admitted_states(self.rows, self.slots)

    @cached_property
    def accelerated_constraints(self) -> tuple[sp.Expr, ...]:
        """d/dt of the velocity form of each row."""
        slots = self.slots
        return tuple(slots.time_derivative(r.velocity_form(slots)) for r in self.rows)

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
    """The weights, then the forces in the order of the file."""
    loads = []
    for p in problem.masses:
        if problem.gravity is not None and p.mass != 0:
            loads.append(Load("weight", p.name, problem.gravity * p.mass, p.position))
    positions = {p.name: p.position for p in problem.masses}
    bodies = {b.name for b in problem.bodies}
    for f in problem.forces:
        if isinstance(f, AppliedForce):
            loads.append(Load(f.name, f.on, f.vector, f.at or positions[f.on], f.at is not None and f.on not in bodies))
    return tuple(loads)


def file_configuration(problem: Problem, rows: tuple[Row, ...]) -> Configuration:
    """The system in the coordinates of the file."""
    springs = stretched_springs(problem)
    energies = (f.energy for f in problem.forces if isinstance(f, Potential))
    return Configuration(
        name="",
        slots=problem.slots,
        points=tuple(_moving(p.name, p.mass, p.position, problem.slots) for p in problem.masses),
        loads=applied_loads(problem),
        potential=sp.Add(*energies, *(s.energy for s in springs)),
        rows=rows,
        springs=springs,
        dampers=dampers_in(problem),
        rotations=tuple(rotation_of(b, problem.slots) for b in problem.bodies),
        torques=tuple(Torque(f.name, f.on, f.moment) for f in problem.forces if isinstance(f, AppliedMoment)),
    )


def substituted_configuration(
    original: Configuration,
    name: str,
    coordinates: tuple[sp.Symbol, ...],
    expressed: Mapping[sp.Symbol, sp.Expr],
    rows: tuple[Row, ...],
) -> Configuration:
    """The same system in other coordinates; `expressed` gives each coordinate that is replaced."""
    slots = Slots(coordinates, original.slots.prescribed)
    blank = Configuration(name, slots, (), (), sp.S.Zero, rows, expressed)
    rule = blank.substitution
    points = tuple(_moving(p.name, p.mass, p.position.xreplace(rule), slots) for p in original.points)
    loads = tuple(replace(f, vector=f.vector.xreplace(rule), point=f.point.xreplace(rule)) for f in original.loads)
    springs = tuple(spring_in(s, rule) for s in original.springs)
    others = original.potential - sp.Add(*(s.energy for s in original.springs))
    return Configuration(
        name,
        slots,
        points,
        loads,
        sp.Add(others.xreplace(rule), *(s.energy for s in springs)),
        rows,
        expressed,
        springs,
        dampers=tuple(damper_in(d, rule, slots) for d in original.dampers),
        rotations=tuple(rotation_in(r, dict(expressed), rule, slots) for r in original.rotations),
        torques=tuple(Torque(m.name, m.on, m.vector.xreplace(rule)) for m in original.torques),
    )


def _moving(name: str, mass: sp.Expr, position: Vector, slots: Slots) -> MassPoint:
    velocity = position.time_derivative(slots)
    acceleration = velocity.time_derivative(slots)
    partials = tuple(position.partial(q) for q in slots.coordinates)
    return MassPoint(name, mass, position, velocity, acceleration, partials)
