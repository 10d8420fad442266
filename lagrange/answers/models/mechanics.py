"""A system as Lagrange's equations see it, in parts that a model can change.

    E_k = d/dt ∂T/∂q_k' − ∂T/∂q_k − Q_k − Σ_j λ_j a_jk ,      T = Σ ½ Σ_a μ_a (Σ_i J_ai q_i')²

The sum runs over particles, for which μ = (m, m, m) and J_i = ∂r/∂q_i, and over rotations, for which μ are the
principal moments and J_i the coefficients of q_i' in the components of ω along the axes. The last i is time: its rate
is 1, and J = ∂r/∂t. So T is a sum of products g_ij q_i' q_j', and each of them enters the equations in three ways,

    g_kj q_j''  (inertia) ,    ġ_kj q_j'  (the rest of d/dt ∂T/∂q_k') ,    −½ ∂g_ij/∂q_k q_i' q_j'  (−∂T/∂q_k) .

Any of these may be lost: a velocity (all products with one i), a product, one of the three ways. `Inertia` has a factor
for each. The forces are Q_k, one `ForceShare` for each weight, force, spring, damper, potential, moment and friction
force.

A variation: one way in which a problem may have been changed, with its words.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from enum import Enum, auto

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Slots, partial, prime
from lagrange.core.vectors import Components, Vector
from lagrange.document.math_writer import text
from lagrange.document.names import Notation
from lagrange.mechanics.constraints.kinematics import Configuration, Load, with_velocities_apart
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.constraints.variable_mass import REACTIVE
from lagrange.mechanics.dynamics.friction import FrictionForce
from lagrange.mechanics.dynamics.lagrangian import (
    is_constant,
    quasi_term,
    share_of_damper,
    share_of_load,
    share_of_spring,
    share_of_torque,
    spin_along_axes,
)
from lagrange.mechanics.dynamics.principle import given_forces
from lagrange.problem.model import GeneralizedForce, Potential, Problem, Speed

Pair = tuple[int, int]
"""i ≤ j of a product q_i' q_j' in T; the number of coordinates stands for time."""


@record
class Inertia:
    """The kinetic energy of a particle or mass centre, or of a rotation.

    name      of the particle or body
    turning   whether it is that of a rotation
    weights   μ_a, shape (3,)
    columns   J_i, shape (n + 1, 3), the last for time
    factor    of all of it
    pairs     factors of single products q_i' q_j'
    product, gradient   factors of the second and third way into the equations
    still     the coordinates that are taken as constant
    explicit  factor of ∂g_ij/∂t, which a prescribed motion causes
    mixed, squared      factors of velocity terms with q_i' q_j' (i ≠ j) and with q_i'² in the equations
    """

    name: str
    turning: bool
    weights: Components
    columns: tuple[Components, ...]
    factor: sp.Expr = sp.S.One
    pairs: tuple[tuple[Pair, sp.Expr], ...] = ()
    product: sp.Expr = sp.S.One
    gradient: sp.Expr = sp.S.One
    explicit: sp.Expr = sp.S.One
    mixed: sp.Expr = sp.S.One
    squared: sp.Expr = sp.S.One
    still: tuple[int, ...] = ()

    @property
    def geometry(self) -> tuple[object, ...]:
        """What its numbers at a state depend on, without the factors."""
        return self.weights, self.columns

    @property
    def moving(self) -> tuple[int, ...]:
        """The i with J_i ≠ 0."""
        return tuple(i for i, column in enumerate(self.columns) if any(c != 0 for c in column))

    def without(self, index: int) -> Inertia:
        """The same without the velocity J_i q_i'."""
        return self.times({p: sp.S.Zero for p in self.products if index in p})

    def times(self, factors: dict[Pair, sp.Expr]) -> Inertia:
        """The same with factors of some products."""
        return replace(self, pairs=tuple(sorted({**dict(self.pairs), **factors}.items())))

    @property
    def products(self) -> Iterator[Pair]:
        """The pairs i ≤ j that can occur in T."""
        return ((i, j) for i in self.moving for j in self.moving if i <= j)


class AppliedForceKind(Enum):
    """The kind of an applied force."""

    WEIGHT = auto()
    FORCE = auto()
    MOMENT = auto()
    POTENTIAL = auto()
    SPRING = auto()
    DAMPER = auto()
    FRICTION = auto()
    REACTIVE = auto()
    QUASI = auto()  # the term that quasi-coordinates add to Lagrange's expression
    VELOCITY_POTENTIAL = auto()  # of a potential that depends on velocities and on positions alone, the former part
    LAGRANGIAN = auto()  # what a term of a given Lagrangian contributes, accelerations included


_KINDS = {"weight": AppliedForceKind.WEIGHT, REACTIVE: AppliedForceKind.REACTIVE}


@record
class ForceShare:
    """An applied force: its share of each Q_k.

    shares        shape (n,)
    conservative  whether it enters by a potential
    on            the particle or body it acts on; for a spring or damper its ends
    """

    kind: AppliedForceKind
    name: str
    shares: tuple[sp.Expr, ...]
    conservative: bool
    on: tuple[str, ...] = ()
    factor: sp.Expr = sp.S.One


@record
class Mechanics:
    """A system in one set of coordinates, as Lagrange's equations see it.

    frictions  the friction forces, which are among the forces
    kept       the coordinates whose equations are set up; all of them, unless constraints were put into T
    units      of the parameters, as far as the file gives them
    speeds     the quasi-velocities of the file
    multipliers  of the constraints that remain, as far as they are unknowns of the equations
    places     of the particles and mass centres, in the coordinates of the file
    ends       of the rods, by the names of their bodies
    is_steady  whether constraints are differentiated as if their coefficients were constant
    """

    configuration: Configuration
    inertias: tuple[Inertia, ...]
    forces: tuple[ForceShare, ...]
    frictions: tuple[FrictionForce, ...] = ()
    kept: tuple[int, ...] = ()
    units: tuple[tuple[sp.Symbol, str], ...] = ()
    speeds: tuple[Speed, ...] = ()
    multipliers: tuple[sp.Symbol, ...] = ()
    places: tuple[tuple[str, Vector], ...] = ()
    ends: tuple[tuple[str, tuple[Vector, ...]], ...] = ()
    is_steady: bool = False

    def may_be_exchanged(self, a: sp.Symbol, b: sp.Symbol) -> bool:
        """Whether two parameters are of the same kind, judging by their units."""
        unit_of: dict[sp.Symbol, str] = dict(self.units)
        return unit_of.get(a, "") == unit_of.get(b, "")

    @property
    def slots(self) -> Slots:
        """The coordinates and the prescribed motions."""
        return self.configuration.slots

    @property
    def particles(self) -> tuple[Inertia, ...]:
        """The kinetic energies of particles and mass centres."""
        return tuple(i for i in self.inertias if not i.turning)

    @property
    def rotations(self) -> tuple[Inertia, ...]:
        """The kinetic energies of rotations."""
        return tuple(i for i in self.inertias if i.turning)

    def of_kind(self, *kinds: AppliedForceKind) -> tuple[ForceShare, ...]:
        """The forces of some kinds."""
        return tuple(f for f in self.forces if f.kind in kinds)

    def inertia(self, change: Callable[[Inertia], Inertia | None]) -> Mechanics:
        """The system with `change` applied to every kinetic energy; None omits one."""
        changed = (change(i) for i in self.inertias)
        return replace(self, inertias=tuple(i for i in changed if i is not None))

    def force(self, change: Callable[[ForceShare], ForceShare | None]) -> Mechanics:
        """The system with `change` applied to every applied force; None omits one."""
        changed = (change(f) for f in self.forces)
        return replace(self, forces=tuple(f for f in changed if f is not None))

    def scaled(self, wanted: Sequence[ForceShare], factor: sp.Expr) -> Mechanics:
        """The system with some forces multiplied by a number."""
        names = {(f.kind, f.name, f.on) for f in wanted}
        return self.force(lambda f: replace(f, factor=f.factor * factor) if (f.kind, f.name, f.on) in names else f)


def mechanics_of(configuration: Configuration, problem: Problem, frictions: Sequence[FrictionForce] = ()) -> Mechanics:
    """The parts of Lagrange's equations of a configuration; `frictions` are among its loads."""
    slots = configuration.slots
    particles = [particle(p.name, p.mass, p.position, slots) for p in configuration.points if p.mass != 0]
    rotations = []
    quasi = []
    for r in configuration.rotations:
        spins = spin_along_axes(r, slots)
        rates = (*slots.velocities, None)
        columns = tuple(_three(_slope(w, v, slots) for w in spins) for v in rates)
        rotations.append(_turning(r, columns))
        if r.given:
            terms = tuple(quasi_term(r, q, prime(q), slots) for q in slots.coordinates)
            quasi.append(ForceShare(AppliedForceKind.QUASI, r.name, terms, False))
    forces = (*_forces(configuration, problem, frictions), *quasi)
    inertias = tuple(i for i in (*particles, *rotations) if i.moving and any(w != 0 for w in i.weights))
    everything = tuple(range(len(slots.coordinates)))
    units = tuple((p.symbol, p.unit) for p in problem.parameters)
    places = (*((p.name, p.position) for p in problem.particles), *((b.name, b.position) for b in problem.bodies))
    ends = tuple(
        (name, tuple(e.fixed().map(configuration.rewritten) for e in shape.ends))
        for name, shape in sorted(problem.figure.shapes.items())
        if shape.ends
    )
    return Mechanics(
        configuration, inertias, forces, tuple(frictions), everything, units, problem.speeds, places=places, ends=ends
    )


def _turning(r: Rotation, columns: tuple[Components, ...]) -> Inertia:
    """The kinetic energy of a rotation; with products of inertia ω·J ω as a sum of squares."""
    squares = None if r.inertia.is_principal else r.inertia.completed()
    if squares is None:
        return Inertia(r.name, True, r.inertia.moments, columns)
    weights, rows = squares
    combined = tuple(_three(sp.Add(*map(sp.Mul, row, column)) for row in rows) for column in columns)
    return Inertia(r.name, True, weights, combined)


def particle(name: str, mass: sp.Expr, position: Vector, slots: Slots) -> Inertia:
    """The kinetic energy of a mass at a position."""
    fixed = position.fixed()
    of_coordinates = (fixed.map(lambda c, q=q: partial(c, q)).components for q in slots.coordinates)  # type: ignore[misc]
    columns = (*of_coordinates, fixed.frozen_derivative(slots).components)
    return Inertia(name, False, (mass, mass, mass), columns)


def weight_shares(load: Load, position: Vector, slots: Slots) -> tuple[sp.Expr, ...]:
    """The shares of a constant force that acts at a position."""
    fixed, vector = position.fixed(), load.vector.fixed()
    return tuple(vector.dot(fixed.map(lambda c, q=q: partial(c, q))) for q in slots.coordinates)  # type: ignore[misc]


def _forces(configuration: Configuration, problem: Problem, frictions: Sequence[FrictionForce]) -> Iterator[ForceShare]:
    slots = configuration.slots
    rough = {f.friction.name for f in frictions}

    pairs = [*zip(slots.coordinates, slots.velocities, strict=True)]
    for load in configuration.loads:
        kind = AppliedForceKind.FRICTION if load.name in rough else _KINDS.get(load.name, AppliedForceKind.FORCE)
        shares = tuple(share_of_load(load, v, configuration) for _, v in pairs)
        conservative = kind is not AppliedForceKind.REACTIVE and is_constant(load, configuration)
        yield ForceShare(kind, load.name, shares, conservative, (load.on,))
    for f in problem.forces:
        if isinstance(f, Potential):
            static, _ = with_velocities_apart([f.energy], problem.slots)
            energy = configuration.rewritten(static)
            yield ForceShare(AppliedForceKind.POTENTIAL, f.name, tuple(-partial(energy, q) for q, _ in pairs), True)
    if configuration.is_outright:
        yield from _terms_of_lagrangian(configuration)
    if others := configuration.generalized if configuration.is_outright else given_forces(configuration):
        named = [f.name for f in problem.forces if isinstance(f, GeneralizedForce)]
        energies = [f for f in problem.forces if isinstance(f, Potential)]
        moving = [f for f in energies if not f.energy.free_symbols.isdisjoint(problem.slots.velocities)]
        mixed = not named and any(with_velocities_apart([f.energy], problem.slots)[0] != 0 for f in moving)
        named += [f.name for f in moving]
        kind = AppliedForceKind.VELOCITY_POTENTIAL if mixed else AppliedForceKind.FORCE
        yield ForceShare(kind, named[0] if len(named) == 1 else "generalized", others, False)
    for s in configuration.springs:
        yield ForceShare(
            AppliedForceKind.SPRING, s.name, tuple(share_of_spring(s, q) for q, _ in pairs), True, _names(s.ends)
        )
    for d in configuration.dampers:
        yield ForceShare(
            AppliedForceKind.DAMPER,
            d.name,
            tuple(share_of_damper(d, v, slots) for _, v in pairs),
            False,
            _names(d.ends),
        )
    for m in configuration.torques:
        shares = tuple(share_of_torque(m, v, configuration) for _, v in pairs)
        yield ForceShare(AppliedForceKind.MOMENT, m.name, shares, False, (m.on,))


def _terms_of_lagrangian(configuration: Configuration) -> Iterator[ForceShare]:
    """∂L_a/∂q_k − d/dt ∂L_a/∂q_k' of each term L_a of a given Lagrangian."""
    slots = configuration.slots
    for term in sp.Add.make_args(sp.expand(configuration.velocity_part) - sp.expand(configuration.potential)):
        alone = replace(configuration, generalized=(), velocity_part=term)
        if term != 0:
            conservative = term.free_symbols.isdisjoint({*slots.velocities})
            yield ForceShare(AppliedForceKind.LAGRANGIAN, written(term, slots), given_forces(alone), conservative)


def _names(ends: Sequence[str | Vector]) -> tuple[str, ...]:
    return tuple(e for e in ends if isinstance(e, str))


def _slope(rate: sp.Expr, velocity: sp.Symbol | None, slots: Slots) -> sp.Expr:
    """The coefficient of a velocity in an expression that is affine in the velocities; None: the rest."""
    if velocity is not None:
        return partial(rate, velocity)
    return rate.xreplace(dict.fromkeys(slots.velocities, sp.S.Zero))


def _three(parts: Iterator[sp.Expr]) -> Components:
    a, b, c = parts
    return a, b, c


# Variation


@record
class VariedQuasiEquations:
    """Equations in quasi-velocities, with a factor of the terms with products of these.

    parts     the kinetic energies whose terms have the factor
    kinetic   d/dt ∂T*/∂u_s − Σ_k B_ks ∂T*/∂q_k: what these give without such terms, shape (p,)
    partials  B_ks, shape (n, p)
    """

    parts: tuple[Inertia, ...]
    kinetic: tuple[sp.Expr, ...]
    partials: tuple[tuple[sp.Expr, ...], ...]
    factor: sp.Expr


@record
class Variation:
    """A changed problem.

    clause     continues "these are the equations"
    place      continues "look at"
    mechanics  the changed system; None if it is the meaning of letters that changes
    rule       what the answer's symbols would have to mean for it to be right
    values     the special case in which the answer, which does not contain these symbols, is right
    quasi      the equations in quasi-velocities, if these are what changes; `mechanics` is unchanged then
    component  whether it leaves out one component of a velocity
    """

    clause: str
    place: str
    mechanics: Mechanics | None = None
    rule: Mapping[sp.Basic, sp.Basic] = field(default_factory=dict)
    values: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    quasi: VariedQuasiEquations | None = None
    component: bool = False

    @property
    def is_exchange(self) -> bool:
        """Whether symbols have to exchange their meanings."""
        return bool(self.rule) and all(self.rule.get(new) == old for old, new in self.rule.items())

    @property
    def is_steady(self) -> bool:
        """Whether its constraints are differentiated as if their coefficients were constant."""
        return self.mechanics is not None and self.mechanics.is_steady

    @property
    def is_reduced(self) -> bool:
        """Whether it has fewer equations than coordinates: then one of them alone tells little."""
        m = self.mechanics
        return self.quasi is None and m is not None and len(m.kept) < len(m.slots.coordinates)


def called(name: str) -> str:
    """The name of a particle, body or force in a sentence."""
    return f"`{name}`"


def written(expression: sp.Expr, slots: Slots) -> str:
    """An expression as it may be typed."""
    return text(expression, Notation(coordinates=slots.coordinates, prescribed=slots.prescribed))
