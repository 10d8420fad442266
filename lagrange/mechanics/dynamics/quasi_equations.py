"""D'Alembert's principle in quasi-velocities, and its check.

With δr = Σ (∂v/∂u_s) δπ_s and δπ = Σ (∂ω/∂u_s) δπ_s, velocities expressed by the u_s, the principle is Σ E_s δπ_s = 0,

    E_s = Σ (m a − F)·∂v/∂u_s + Σ (dH/dt − M)·∂ω/∂u_s + Σ (∂V/∂q_k) B_ks = 0 ,     q_k' = Σ B_ks u_s + b_k :

one equation for each u_s. The δπ_s are free, so that no constraint is left to be eliminated (Gibbs 1879, Appell 1899,
Jourdain 1909, Kane 1961). If the u_s are the components of ω along the axes of a body, these are Euler's equations.

Velocities are expressed by the u_s first and differentiated afterwards, along q' = B u + b, and each vector is written
in the triad in which it is shortest: ω = p e_1 + q e_2 + r e_3 contains no angles, so none have to cancel.

The check substitutes q' = B u + b into the definitions of the u_s and into the constraints, and compares the equations
of motion, with the definitions substituted, with Lagrange's equations with multipliers: a route that has no
quasi-velocities and shares only the positions.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.ring import Element, FourierRing, RingDerivation
from lagrange.algebra.fourier.textbook_form import CommonFactor, Textbook, textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.inertia import InertiaTensor
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import base, partial, prime, t, variation
from lagrange.core.vectors import FIXED, Triad, Vector, axis_names, triad_along
from lagrange.mechanics.constraints.kinematics import Configuration, Load, MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.checks import Check, at_random_states, certainty, multiplier_system
from lagrange.mechanics.dynamics.comparison import compare
from lagrange.mechanics.dynamics.equations import EquationOfMotion, EquationsOfMotion, divided, excluded
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.limits import LONGEST_SOLVED_RATES, MOST_SOLVED_RATES
from lagrange.mechanics.dynamics.principle import given_forces
from lagrange.mechanics.dynamics.quasi_velocities import QuasiVelocities, quasi_velocities
from lagrange.problem.model import Problem, Speed


@record
class Moving:
    """A vector in terms of the u_s, and its time derivative, in one triad: v and a, or H and dH/dt.

    partials  of the velocity or angular velocity by each u_s
    """

    rate: Vector
    partials: tuple[Vector, ...]
    changed: Vector
    vector: Vector


@record
class QuasiEquations:
    """The equations of motion in quasi-velocities; the kinematic equations complete them.

    velocities, spins       v of the points and ω of the bodies that move, by name
    momenta                 H of the bodies
    accelerations           a of the points with mass
    momentum_rates          dH/dt of the bodies with inertia
    statement               Σ E_s δπ_s
    equations               one for each u_s; `coordinate` is u_s, or the coordinate whose velocity completes them
    slotted                 the same, with the slots of `quasi` for the u_s and u_s'
    rates                   u_s' solved for; None if nobody has, or if that is too large
    """

    quasi: QuasiVelocities
    velocities: Mapping[str, Vector]
    spins: Mapping[str, Vector]
    momenta: Mapping[str, Vector]
    accelerations: Mapping[str, Vector]
    momentum_rates: Mapping[str, Vector]
    statement: sp.Expr
    equations: tuple[EquationOfMotion, ...]
    slotted: tuple[EquationOfMotion, ...]
    rates: Mapping[sp.Symbol, sp.Expr] | None = None

    @property
    def expressions(self) -> tuple[sp.Expr, ...]:
        """Each of these is zero."""
        return tuple(e.expression for e in self.equations)

    @property
    def conditions(self) -> tuple[sp.Expr, ...]:
        """The factors divided by that may vanish."""
        return excluded(self.quasi.pivots, self.equations)


class _Motion:
    """Velocities in terms of the quasi-velocities, and their derivatives along q' = B u + b."""

    def __init__(self, quasi: QuasiVelocities) -> None:
        self.quasi = quasi
        self.configuration = quasi.configuration
        self.ring = FourierRing()
        self.textbook = Textbook(self.ring)
        self.rule: dict[sp.Basic, sp.Basic] = dict(quasi.rates)
        self._along = RingDerivation(self.ring, self._rate)
        rotations = self.configuration.rotations
        self._axes = {r.name: self._axes_of(r) for r in rotations}
        self._triads = [triad for r in rotations for triad in (r.angular_velocity.triad, self._axes[r.name])]

    def _rate(self, symbol: sp.Symbol) -> Element | None:
        slots = self.configuration.slots
        if symbol == t:
            return self.ring.one
        if symbol in slots.coordinates:
            return self.ring.from_sympy(self.quasi.rates[prime(symbol)])
        if symbol in self.quasi.slots.velocities or base(symbol) in slots.prescribed:
            return self.ring.from_sympy(prime(symbol))
        return None

    def form(self, expression: sp.Expr) -> sp.Expr:
        """An expression in q and q', rewritten in q and u, in textbook form."""
        return self.textbook.form(expression.xreplace(self.rule))

    def with_accelerations(self, e: sp.Expr) -> sp.Expr:
        """An expression with q'' = d/dt (B u + b), which a Lagrangian that is given, or a potential, may contain."""
        coordinates = {prime(q, 2): q for q in self.configuration.slots.coordinates}
        present = sorted(e.free_symbols & coordinates.keys(), key=str)
        read, form = self.ring.from_sympy, self.textbook.form
        return e.xreplace({a: form(self._along(read(self.quasi.rates[prime(coordinates[a])]))) for a in present})

    def moving(self, v: Vector, triads: Sequence[Triad], inertia: InertiaTensor | None = None) -> Moving:
        """A velocity in the first of the triads in which it is shortest; with a tensor of inertia, H and dH/dt."""
        written = (v.along(triad).map(self.form) for triad in dict.fromkeys(triads))
        rate = min(written, key=lambda w: sum(1 + count_operations(c) for c in w.components if c != 0))
        partials = tuple(rate.map(lambda c, u=u: c.diff(u)) for u in self.quasi.slots.velocities)  # type: ignore[misc]
        vector = rate
        if inertia is not None:
            vector = Vector(inertia.times(rate.components), rate.triad)
        return Moving(rate, partials, self._differentiated(vector), vector)

    def _differentiated(self, v: Vector) -> Vector:
        changed = v.map(lambda c: self.textbook.form(self._along(self.ring.from_sympy(c))))
        spin = Vector.zero(v.triad)
        for q, w in v.triad.turning:
            rate = sp.S.One if q == t else self.rule.get(prime(q), prime(q))
            spin = spin + Vector(w, v.triad) * rate
        return (changed + spin.map(self.textbook.form).cross(v)).map(self.textbook.form)

    def of_point(self, point: MassPoint) -> Moving:
        """v and a."""
        return self.moving(point.velocity, (point.velocity.triad, FIXED, *self._triads))

    def of_rotation(self, rotation: Rotation) -> Moving:
        """ω, H and dH/dt in the triad of the file's derivation or, if ω is shorter there, in the axes of the body.

        If all moments of inertia are equal, i, j, k are another triad in which they are constant.
        """
        own = rotation.angular_velocity.triad
        triads = [own]
        if own.directions is not None:
            triads += [] if rotation.given else [self._axes[rotation.name]]
            triads += [FIXED] if rotation.inertia.is_isotropic else []
        return self.moving(rotation.angular_velocity, triads, rotation.inertia)

    def _axes_of(self, rotation: Rotation) -> Triad:
        """The axes of the body; those in the file, if it gives ω."""
        first, second, third = axis_names(rotation.name)
        own = rotation.angular_velocity.triad
        names = (first, second, "k" if own.directions is None else third)
        if rotation.given or own.names == names:
            return own
        return triad_along(names, rotation.axes, self.configuration.slots, textbook_form)

    def dot(self, a: Vector, b: Vector) -> Element:
        """a·b, in the triad of b."""
        a, read = a.xreplace(self.rule).along(b.triad), self.ring.from_sympy
        return self.ring.dot([read(c) for c in a.components], [read(c) for c in b.components])

    def pulled(self, partials: Sequence[sp.Expr], column: int) -> Element:
        """Σ_k (∂/∂q_k) B_ks of something with the derivatives ∂/∂q_k."""
        read = self.ring.from_sympy
        pairs = zip(partials, self.quasi.partials, strict=True)
        return self.ring.total(read(p.xreplace(self.rule)) * read(row[column]) for p, row in pairs if p != 0)


def quasi_equations(quasi: QuasiVelocities, configuration: Configuration) -> QuasiEquations:
    """The equations of motion in quasi-velocities; `configuration` is theirs, with friction where that acts."""
    motion = _Motion(replace(quasi, configuration=configuration))
    ring, textbook = motion.ring, motion.textbook
    points = {p.name: motion.of_point(p) for p in configuration.points if not configuration.is_pinned(p)}
    turning = {r.name: motion.of_rotation(r) for r in configuration.rotations}
    elements = []
    for s in range(len(quasi.symbols)):
        inertia = [
            ring.from_sympy(p.mass) * motion.dot(points[p.name].changed, points[p.name].partials[s])
            for p in configuration.points
            if p.mass != 0 and p.name in points
        ]
        inertia += [motion.dot(m.changed, m.partials[s]) for m in turning.values()]
        elements.append(ring.total(inertia) - _force(motion, points, turning, s))
    moved = [variation(q) for q in quasi.slots.coordinates]
    statement = ring.total(e * ring.from_sympy(v) for e, v in zip(elements, moved, strict=True))
    pairs = zip(quasi.slots.coordinates, elements, strict=True)
    equations = tuple(divided(textbook, q, e) for q, e in pairs)
    names = {r.name for r in configuration.rotations if r.has_inertia}
    heavy = {p.name for p in configuration.points if p.mass != 0}
    return QuasiEquations(
        quasi=quasi,
        velocities={name: quasi.shown(m.rate) for name, m in points.items()},
        spins={name: quasi.shown(m.rate) for name, m in turning.items()},
        momenta={name: quasi.shown(m.vector) for name, m in turning.items() if name in names},
        accelerations={name: quasi.shown(m.changed) for name, m in points.items() if name in heavy},
        momentum_rates={name: quasi.shown(m.changed) for name, m in turning.items() if name in names},
        statement=quasi.shown(textbook.form(statement)),
        equations=tuple(_shown(e, quasi) for e in equations),
        slotted=equations,
    )


def _force(motion: _Motion, points: Mapping[str, Moving], turning: Mapping[str, Moving], s: int) -> Element:
    """Σ F·∂v/∂u_s + Σ M·∂ω/∂u_s − Σ (∂V/∂q_k + c d' ∂d/∂q_k) B_ks."""
    configuration, ring = motion.configuration, motion.ring
    coordinates = configuration.slots.coordinates
    work = [_work(motion, load, points, s) for load in configuration.loads]
    work += [motion.dot(configuration.moment_on(name), m.partials[s]) for name, m in turning.items()]
    others = given_forces(configuration) or (sp.S.Zero,) * len(coordinates)
    slopes = [sp.Add(-partial(configuration.potential, q), f) for q, f in zip(coordinates, others, strict=True)]
    slopes = [motion.with_accelerations(e) for e in slopes]
    work.append(motion.pulled(slopes, s))
    work += [motion.pulled([-d.pull * d.distance.diff(q) for q in coordinates], s) for d in configuration.dampers]
    return ring.total(work)


def _work(motion: _Motion, load: Load, points: Mapping[str, Moving], s: int) -> Element:
    """F·∂v/∂u_s, v being the velocity of the point of application."""
    if load.elsewhere:
        slots = motion.configuration.slots
        partials = (load.point.partial(q) for q in slots.coordinates)
        return motion.pulled([load.vector.dot(p) for p in partials], s)
    if load.on not in points:
        return motion.ring.zero
    return motion.dot(load.vector, points[load.on].partials[s])


def _shown(equation: EquationOfMotion, quasi: QuasiVelocities) -> EquationOfMotion:
    powers = tuple((quasi.shown(f), e) for f, e in equation.factor.powers)
    factor = CommonFactor(equation.factor.number, powers)
    return replace(equation, expression=quasi.shown(equation.expression), factor=factor)


def _solved(
    equations: Sequence[EquationOfMotion], quasi: QuasiVelocities, surface: Surface
) -> dict[sp.Symbol, sp.Expr] | None:
    """u' -> its value."""
    unknowns = quasi.slots.accelerations
    operations = sum(count_operations(e.expression) for e in equations)
    if len(unknowns) > MOST_SOLVED_RATES or operations > LONGEST_SOLVED_RATES:
        return None
    at_rest = dict.fromkeys(unknowns, sp.S.Zero)
    rows = [[e.expression.diff(a) for a in unknowns] for e in equations]
    solved = solved_linear(rows, [-e.expression.xreplace(at_rest) for e in equations], surface)
    if solved is None or None in solved:
        return None
    return {quasi.shown(a): quasi.shown(value) for a, value in zip(unknowns, solved, strict=True)}


@record
class QuasiVelocityForm:
    """The velocities in terms of the quasi-velocities, and the equations of motion in these if requested."""

    velocities: QuasiVelocities
    equations: QuasiEquations | None
    configuration: Configuration


def in_speeds(
    speeds: Sequence[Speed], configuration: Configuration, motion: EquationsOfMotion | None
) -> QuasiVelocityForm:
    """The quasi-velocities of a file in a configuration. Raises the same errors as `quasi_velocities`."""
    quasi = quasi_velocities(speeds, configuration)
    if motion is None:
        return QuasiVelocityForm(quasi, None, configuration)
    equations = quasi_equations(quasi, motion.configuration)
    equations = replace(equations, rates=_solved(equations.slotted, quasi, motion.configuration.surface))
    return QuasiVelocityForm(quasi, equations, motion.configuration)


def check_speeds(form: QuasiVelocityForm, problem: Problem) -> list[Check]:
    """The checks of the kinematic equations and of the equations of motion."""
    quasi = form.velocities
    name = quasi.configuration.name
    how = f"{certainty(quasi.configuration.surface)}: substituted into the definitions and the constraints"
    checks = [Check("the kinematic equations give the velocities", _give_velocities(quasi), how, name)]
    if form.equations is not None:
        configuration = form.configuration
        reactions = {c.name: c.reaction for c in problem.constraints}
        multipliers = tuple(reactions[row.name] for row in configuration.rows)
        system = multiplier_system(configuration, lagrange_equations(configuration).left, multipliers)
        result = compare([quasi.defined(e) for e in form.equations.expressions], system)
        passed = None if result is None else result.agree
        how = at_random_states(configuration)
        checks.append(Check("Lagrange's equations give the same motion in the quasi-velocities", passed, how, name))
    return checks


def _give_velocities(quasi: QuasiVelocities) -> bool | None:
    """u(q, B u + b) = u, and A (B u + b) + a_t = 0."""
    configuration = quasi.configuration
    rule = quasi.rates
    left = [e.xreplace(rule) - prime(u) for u, e in quasi.definitions.items()]
    left += [r.velocity_form(configuration.slots).xreplace(rule) for r in configuration.rows]
    verdicts = [configuration.surface.is_zero(e) for e in left]
    return all_hold(verdicts)
