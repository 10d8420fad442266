"""Conserved quantities with their proof, and the rate of the energy where it is not conserved.

    p_φ = m l² φ' sin² θ = const         φ is cyclic, and no reaction does work in its displacement
    h = T2 − T0 + V = const              time does not occur in L, although positions may contain it
    dE/dt = Σ Q'_k q_k' − ∂L/∂t + d(T1 + 2 T0)/dt − Σ λ_j a_jt

Candidates for symmetries (`noether`) include the virtual displacements admitted by kinematic constraints. An integral I
from a symmetry with the multipliers μ is proved by an identity: the equations of motion E_k = 0, multiplied by ν_k and
added, are its rate, Σ ν_k E_k = dI/dt, where ν_k is μ_k times the factor divided out of E_k. This is an identity in the
accelerations, verified at random states that satisfy the constraints. Independently, dI/dt must vanish with the
accelerations from d'Alembert's equations. That a quantity is not conserved is decided in the same way, and may remain
undecided.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field, replace
from enum import StrEnum
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, Point
from lagrange.algebra.fourier.ring import Element
from lagrange.algebra.fourier.terms import Exponent, as_term, normalised
from lagrange.algebra.fourier.textbook_form import Textbook, textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import partial, prime, t
from lagrange.mechanics.constraints.constrained_system import Row, is_pfaffian
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check, certainty, displacement_basis, with_accelerations
from lagrange.mechanics.dynamics.comparison import System, agreed_in_motion, follow
from lagrange.mechanics.dynamics.energy_functions import EnergyFunctions, energy_functions, in_one_term
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.dynamics.limits import LONGEST_DISPLACEMENT, MOST_DISPLACEMENTS
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.noether import (
    Symmetry,
    SymmetryCandidate,
    SymmetryKind,
    candidates,
    gauged,
    symmetries,
)
from lagrange.mechanics.dynamics.principle import dot

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation


def admitted_displacements(elimination: Elimination, configuration: Configuration) -> list[tuple[sp.Expr, ...]]:
    """Virtual displacements admitted by kinematic constraints, as candidates for symmetries, shape (., n).

    Each with and without its denominators: a symmetry has constant coefficients, and either may be one.
    """
    rows = configuration.rows
    if all(r.finite is not None for r in rows) or not is_pfaffian(rows):
        return []
    tried: dict[tuple[sp.Expr, ...], None] = {}
    for column in displacement_basis(elimination, len(configuration.slots.coordinates)):
        if sum(count_operations(e) for e in column) > LONGEST_DISPLACEMENT:
            continue
        denominator = sp.Mul(*_denominators(column))
        if denominator != 1:
            tried[tuple(textbook_form(e * denominator) for e in column)] = None
        tried[tuple(column)] = None
    return [c for c in tried if sum(e != 0 for e in c) > 1][:MOST_DISPLACEMENTS]


def _denominators(column: Sequence[sp.Expr]) -> list[sp.Expr]:
    """The denominators of the entries of a column: sin θ in cos θ/sin θ."""
    denominators: dict[sp.Expr, Exponent] = {}
    for e in column:
        for term in sp.Add.make_args(e):
            for factor, exponent in as_term(term).factors.items():
                if exponent < 0:
                    denominators[factor] = max(denominators.get(factor, 0), -exponent)
    return [f**e for f, e in denominators.items()]


class ConservedQuantity(StrEnum):
    """The kinds of conserved quantities."""

    MOMENTUM = "momentum"
    ANGULAR_MOMENTUM = "angular-momentum"
    ENERGY = "energy"
    JACOBI = "jacobi"


_ENERGIES = (ConservedQuantity.ENERGY, ConservedQuantity.JACOBI)


class Because(StrEnum):
    """The reasons for conservation. Stable: programs rely on these words."""

    CYCLIC = "cyclic"  # the coordinate occurs nowhere, and no reaction does work in its displacement
    TRANSLATION = "translation"  # a displacement of several coordinates changes nothing
    ROTATION = "rotation"  # a rotation of Cartesian coordinates changes nothing
    SCREW = "screw"  # a rotation with a translation along its axis changes nothing
    ADMITTED = "admitted"  # a virtual displacement, in which no reaction does work
    GAUGE = "gauge"  # the force along the coordinate is a total time derivative
    RATE = "rate"  # a displacement changes L, with the work of the forces, by a total time derivative
    NO_REACTION = "no-reaction"  # a cyclic coordinate whose reaction turns out to vanish
    CONSERVATIVE = "conservative"  # forces have a potential, and nothing depends on time
    TIME_FREE = "time-free"  # time does not occur in L, although it does in the positions
    DEPENDENT = "dependent"  # it follows from the other integrals
    TIME_RATE = "time-rate"  # ∂L/∂t, with the power of the forces, is a total time derivative
    CARRIED = "carried"  # a shift of time together with a displacement changes nothing


@record
class Integral:
    """expression = const along every motion.

    coordinate    the cyclic coordinate, if there is one
    displacement  each coordinate that a symmetry displaces, with its δq
    multipliers   ν_k of the equations of motion; empty if no identity was found
    constant      whether its rate vanishes with the accelerations of d'Alembert's equations; None: undecided
    """

    quantity: ConservedQuantity
    because: Because
    expression: sp.Expr
    coordinate: sp.Symbol | None = None
    displacement: Mapping[sp.Symbol, sp.Expr] | None = None
    multipliers: tuple[sp.Expr, ...] = ()
    constant: bool | None = None


@record
class EnergyRate:
    """d(expression)/dt = rate, which does not vanish. `rate` None: whether the energy is conserved is undecided.

    driven  the constraints whose motion contributes
    hidden  whether forces have a potential that was not found, and is not in the expression
    """

    expression: sp.Expr
    rate: sp.Expr | None
    driven: tuple[str, ...] = ()
    hidden: bool = False

    def vanishes_with(self, state: Collection[sp.Symbol]) -> sp.Symbol | None:
        """The parameter that may be zero and without which the rate vanishes: the moment L of L φ'."""
        rate = sp.S.Zero if self.rate is None else self.rate
        without = (s for s in sorted(rate.free_symbols - {*state, t}, key=str) if s.is_zero is None)
        return next((s for s in without if rate.xreplace({s: sp.S.Zero}) == 0), None)


@record
class Conserved:
    """The conserved quantities of one set of equations.

    energy     the rate of the energy, if it is not conserved
    bound      momenta of cyclic coordinates that are not conserved, because of constraints on their velocities
    undecided  cyclic coordinates for which this could not be decided
    potential  whether there is a potential energy
    """

    motion: EquationsOfMotion
    integrals: tuple[Integral, ...]
    energy: EnergyRate | None = None
    bound: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    undecided: tuple[sp.Symbol, ...] = ()
    potential: bool = True


def _vanish_along(motion: EquationsOfMotion, rates: Sequence[sp.Expr]) -> list[bool | None]:
    """Which of several rates are zero along every motion; the accelerations of a state are found once for all."""
    if not rates:
        return []
    system = System(motion.configuration, motion.expressions)
    expressions = (*rates, *system.equations, *system.accelerated_constraints)

    def hold(moving: Point) -> list[bool | None]:
        accelerated = with_accelerations(moving, system)
        return [None if accelerated is None else accelerated.is_zero(r) for r in rates]

    try:
        together = agreed_in_motion(motion.configuration, hold, expressions)
    except DivisionByZeroError:
        together = None
    if together is not None:
        return together
    return [_vanish_along(motion, [r])[0] for r in rates] if len(rates) > 1 else [None]


def conserved(motion: Motion, multipliers: Mapping[str, sp.Symbol], frictions: Collection[str] = ()) -> Conserved:
    """The integrals of a motion, and the rate of its energy.

    multipliers  λ of the constraints, by name
    frictions    the names of the friction forces
    """
    solved = motion.equations
    driven = tuple(r for r in solved.configuration.rows if not _is_still(r, solved.configuration))
    equations = solved if driven else motion.written
    return _Search(equations, multipliers, driven, frozenset(frictions)).all()


def _is_still(row: Row, configuration: Configuration) -> bool:
    """Whether a_t is zero where the constraint holds."""
    return row.drift == 0 or configuration.states.is_zero(row.drift) is True


class _Search:
    """The search for conserved quantities of one set of equations."""

    def __init__(
        self,
        motion: EquationsOfMotion,
        multipliers: Mapping[str, sp.Symbol],
        driven: tuple[Row, ...],
        frictions: frozenset[str],
    ) -> None:
        self.motion = motion
        self.configuration = motion.configuration
        self.slots = motion.configuration.slots
        self.multipliers = multipliers
        self.driven = driven
        self._rates: dict[sp.Expr, sp.Expr] = {}
        self.system = System(self.configuration, motion.expressions)
        textbook = Textbook(motion.principle.ring, multipliers.values())
        self.energies: EnergyFunctions = energy_functions(self.configuration, textbook, frictions)

    def all(self) -> Conserved:
        """The integrals, momenta first; the rate of the energy; cyclic coordinates without a conserved momentum."""
        tried = candidates(self.energies, admitted_displacements(self.motion.elimination, self.configuration))
        integrals = self._independent([self._integral(s) for s in self._symmetries(tried)])
        verdicts = self._are_constant([i.expression for i in integrals])
        integrals = [replace(i, constant=v) for i, v in zip(integrals, verdicts, strict=True)]
        reached = {i.coordinate for i in integrals}
        bound: dict[sp.Symbol, sp.Expr] = {}
        undecided: list[sp.Symbol] = []
        cyclic = {k: q for k in self._cyclic() if (q := self.slots.coordinates[k]) not in reached}
        momenta = [self.energies.form(self.energies.momenta[k]) for k in cyclic]
        verdicts = self._are_constant(momenta)
        for (k, coordinate), momentum, verdict in zip(cyclic.items(), momenta, verdicts, strict=True):
            if verdict is True:
                new = Integral(ConservedQuantity.MOMENTUM, Because.NO_REACTION, momentum, coordinate, constant=True)
                others = [i for i in integrals if i.quantity not in _ENERGIES]
                integrals += self._independent([new], others, linear=True)
            elif not self.energies.are_quasi and any(
                r.coefficients[k] != 0 for r in self.configuration.rows if r.finite is None
            ):
                if verdict is None:
                    undecided.append(coordinate)
                else:
                    bound[coordinate] = momentum
        energy, rate = self._energy(integrals)
        ordered = sorted([*integrals, *energy], key=lambda i: i.quantity in _ENERGIES)
        return Conserved(self.motion, tuple(ordered), rate, bound, tuple(undecided), self.energies.has_potential)

    def _cyclic(self) -> list[int]:
        """The coordinates on which nothing except perhaps a constraint depends."""
        return [k for k in range(len(self.slots.coordinates)) if self.energies.is_cyclic(k)]

    # -- symmetries ----------------------------------------------------------------------------------------------------

    def _symmetries(self, tried: Sequence[SymmetryCandidate]) -> list[Symmetry]:
        """The symmetries with R = 0, then those with R = dG/dt; δt in one way only, last."""
        plain = symmetries(tried, self.configuration)
        rates = gauged(tried, self.energies)
        timed = [s for s in plain if s.kind is SymmetryKind.TIME] or [s for s in rates if s.kind is SymmetryKind.TIME]
        return [s for s in (*plain, *rates) if s.kind is not SymmetryKind.TIME] + timed

    def _integral(self, symmetry: Symmetry) -> Integral:
        coordinates = self.slots.coordinates
        moved = {q: x for q, x in zip(coordinates, symmetry.displacement, strict=True) if x != 0} if (
            any(k.kind is not SymmetryKind.TIME for k, _ in symmetry.terms)
        ) else {}  # fmt: skip
        ring = self.energies.ring
        momentum = ring.total(
            ring.from_sympy(x) * p for x, p in zip(moved.values(), (self._momentum(q) for q in moved), strict=True)
        )
        multipliers = self._proof(symmetry.multipliers)
        gauge = sp.Add(*(c * k.gauge for k, c in symmetry.terms))
        if symmetry.kind is SymmetryKind.TIME:
            own = self.energies.has_motion_of_its_own
            quantity = ConservedQuantity.JACOBI if own or moved or gauge != 0 else ConservedQuantity.ENERGY
            because = Because.CARRIED if moved else Because.TIME_FREE if own else Because.CONSERVATIVE
            because = Because.TIME_RATE if gauge != 0 else because
            expression = self.energies.jacobi_less(gauge) if own or gauge != 0 else self.energies.energy
            expression = sp.Add(expression, self.energies.changing(momentum)) if moved else expression
            if own and expression == self.energies.energy:
                quantity = ConservedQuantity.ENERGY
            carried = {q: -x for q, x in moved.items()}
            return self._proved(Integral(quantity, because, expression, None, carried or None, multipliers))
        expression = self.energies.form(momentum - ring.from_sympy(gauge))
        turned = any(not x.free_symbols.isdisjoint(coordinates) for x in moved.values())
        if symmetry.kind is SymmetryKind.GAUGE and (len(moved) > 1 or not self._is_cyclic(next(iter(moved)))):
            quantity = ConservedQuantity.ANGULAR_MOMENTUM if turned else ConservedQuantity.MOMENTUM
            return self._proved(Integral(quantity, Because.RATE, expression, None, moved, multipliers))
        rotation = symmetry.kind is SymmetryKind.ROTATION
        screw = rotation and self._is_screw(moved)
        quantity = ConservedQuantity.ANGULAR_MOMENTUM if rotation and not screw else ConservedQuantity.MOMENTUM
        if symmetry.kind in (SymmetryKind.TRANSLATION, SymmetryKind.GAUGE) and len(moved) == 1:
            because = Because.GAUGE if symmetry.kind is SymmetryKind.GAUGE else Because.CYCLIC
            return self._proved(Integral(quantity, because, expression, next(iter(moved)), moved, multipliers))
        because = {
            SymmetryKind.ROTATION: Because.SCREW if screw else Because.ROTATION,
            SymmetryKind.ADMITTED: Because.ADMITTED,
        }.get(symmetry.kind, Because.TRANSLATION)
        if normalised(expression) != expression:
            expression = normalised(expression)
            moved = {q: -x for q, x in moved.items()}
            multipliers = tuple(-m for m in multipliers)
        return self._proved(Integral(quantity, because, expression, None, moved, multipliers))

    def _is_screw(self, moved: Mapping[sp.Symbol, sp.Expr]) -> bool:
        """Whether a rotation of Cartesian coordinates goes with a translation across their planes: along its axis."""
        places = {q: k for k, q in enumerate(self.slots.coordinates)}
        turned = {s for x in moved.values() for s in x.free_symbols & places.keys()}
        across = [places[q] for q in moved if q not in turned]
        plane = [places[q] for q in turned]

        def translates(k: int) -> bool:
            """Whether the coordinate moves some point at right angles to every plane."""
            along = [p.partials[k].fixed() for p in self.configuration.points if not p.partials[k].is_zero]
            inside = [p.partials[n].fixed() for p in self.configuration.points for n in plane]
            ring = self.energies.ring
            return bool(along) and all(ring.is_zero(dot(a, b, ring)) for a in along for b in inside)

        return any(map(translates, across))

    def _is_cyclic(self, coordinate: sp.Symbol) -> bool:
        """Whether a coordinate does not occur in the energies."""
        ring = self.energies.ring
        return bool(ring.is_zero(ring.partial(coordinate)(self.energies.lagrangian)))

    def _momentum(self, coordinate: sp.Symbol) -> Element:
        return self.energies.momenta[self.slots.coordinates.index(coordinate)]

    def _proof(self, multipliers: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
        """ν_k: the multipliers of the independent displacements, times the factors divided out of the equations."""
        pairs = zip(self.motion.elimination.independent, self.motion.equations, strict=True)
        return tuple(
            multipliers[k] * e.factor.expression * (-1 if e.reversed else 1) if multipliers[k] != 0 else sp.S.Zero
            for k, e in pairs
        )

    def _proved(self, integral: Integral) -> Integral:
        """The integral, without its multipliers if the identity does not hold."""
        sides = (m * e for m, e in zip(integral.multipliers, self.motion.expressions, strict=True) if m != 0)
        difference = sp.Add(self._rate(integral.expression), *(-s for s in sides))

        def holds(moving: Point) -> bool:
            return moving.is_zero(difference)

        try:
            proved = agreed_in_motion(self.configuration, holds, [difference]) is True
        except DivisionByZeroError:
            proved = False
        return integral if proved else replace(integral, multipliers=())

    def _independent(
        self, integrals: Sequence[Integral], before: Sequence[Integral] = (), *, linear: bool = False
    ) -> list[Integral]:
        """The integrals that are independent of the constraints and, except energies, of earlier integrals.

        linear  of constraints linear in the velocities only: x₁' y₂' = y₁' x₂' and three momenta give the fourth, which
                a reader misses all the same
        """
        rows = [r for r in self.configuration.rows if r.nonlinear is None or not linear]
        if not rows and all(i.because is not Because.RATE for i in integrals):
            return list(integrals)
        variables = [*self.slots.coordinates, *self.slots.velocities]
        relations = [r.velocity_form(self.slots) for r in rows] + [r.finite for r in rows if r.finite is not None]
        known = [[partial(f, v) for v in variables] for f in relations]
        kept: list[Integral] = []
        gradients = [[partial(i.expression, v) for v in variables] for i in before]
        for i in integrals:
            gradient = [partial(i.expression, v) for v in variables]
            others = [] if i.quantity in _ENERGIES else gradients
            if self._adds([*known, *others], gradient):
                kept.append(i)
                if others is gradients:
                    gradients.append(gradient)
        return kept

    def _adds(self, known: Sequence[Sequence[sp.Expr]], gradient: Sequence[sp.Expr]) -> bool:
        """Whether a gradient is independent of others, each of shape (2n,), at admissible states."""

        def adds(point: Point) -> bool:
            values = point.matrix(known)
            return bool(point.rank([*values, point.values(gradient)]) > point.rank(values))

        return agreed_in_motion(self.configuration, adds, [e for row in (*known, gradient) for e in row]) is True

    # -- along the motion ----------------------------------------------------------------------------------------------

    def _are_constant(self, expressions: Sequence[sp.Expr]) -> list[bool | None]:
        """Whether the rates of expressions vanish with the accelerations from the equations."""
        return _vanish_along(self.motion, [self._rate(e) for e in expressions])

    def _rate(self, expression: sp.Expr) -> sp.Expr:
        """The time derivative, computed once."""
        if expression not in self._rates:
            self._rates[expression] = self.slots.time_derivative(expression)
        return self._rates[expression]

    def _energy(self, integrals: Sequence[Integral]) -> tuple[list[Integral], EnergyRate | None]:
        """The energy if no symmetry gives it: conserved after all, or its rate."""
        if any(i.quantity is ConservedQuantity.ENERGY for i in integrals):
            return [], None
        energies = self.energies
        if energies.has_motion_of_its_own and energies.are_quasi:
            return [], EnergyRate(energies.energy, None)
        ring = energies.ring
        work = ring.total(
            ring.from_sympy(self.multipliers[row.name]) * ring.from_sympy(row.drift) for row in self.driven
        )
        rest = energies.energy_rate - work + ring.from_sympy(energies.damping)
        rate = in_one_term(sp.Add(energies.form(rest), -energies.damping))
        if rate == 0 or self._are_constant([energies.energy]) == [True]:
            return [Integral(ConservedQuantity.ENERGY, Because.DEPENDENT, energies.energy, constant=True)], None
        holds = self._rate_holds(energies.energy, rate)
        driven = tuple(r.name for r in self.driven)
        return [], EnergyRate(energies.energy, rate if holds else None, driven, energies.hidden)

    def _rate_holds(self, expression: sp.Expr, rate: sp.Expr) -> bool | None:
        """Whether an expression has a given rate, with the accelerations and multipliers of d'Alembert's principle."""
        difference = self._rate(expression) - rate
        if not self.driven:
            return _vanish_along(self.motion, [difference])[0]
        rows = self.configuration.rows
        multipliers = tuple(self.multipliers[r.name] for r in rows)
        equations = [
            d.to_sympy() - sp.Add(*(m * r.coefficients[k] for m, r in zip(multipliers, rows, strict=True)))
            for k, d in enumerate(self.motion.principle.coefficients)
        ]
        equations += self.system.accelerated_constraints
        unknowns = (*self.slots.accelerations, *multipliers)
        return follow(self.configuration, [difference], equations, unknowns)


def check_conserved(result: Conserved) -> list[Check]:
    """The printed integrals, differentiated, with the accelerations from d'Alembert's equations."""
    if not result.integrals:
        return []
    verdicts = [i.constant for i in result.integrals]
    passed = all_hold(verdicts)
    configuration = result.motion.configuration
    how = f"{certainty(configuration.states)}: the rate of each along the motion"
    return [Check("the conserved quantities are constant along the motion", passed, how, configuration.name)]


# -- momentum or angular momentum ------------------------------------------------------------------------------------


def quantity_of(integral: Integral, configuration: Configuration) -> ConservedQuantity:
    """What an integral is: the momentum of an angle, also with other coordinates, is an angular one; not of a screw."""
    displaced = (integral.displacement or {}) if integral.coordinate is None else (integral.coordinate,)
    if integral.quantity is not ConservedQuantity.MOMENTUM or not displaced:
        return integral.quantity
    turned = [q for q in displaced if _turns(q, configuration)]
    others = [q for q in displaced if q not in turned]
    is_angular = bool(turned) and not _advances(others, turned, configuration)
    if is_angular and len(displaced) == 1:
        is_angular = _turns_rigidly(turned[0], configuration)
    return ConservedQuantity.ANGULAR_MOMENTUM if is_angular else integral.quantity


def _advances(others: Sequence[sp.Symbol], turned: Sequence[sp.Symbol], configuration: Configuration) -> bool:
    """Whether coordinates move a point along the axis about which others turn, as a screw advances."""
    places = [sp.Matrix(p.position.fixed().components) for p in configuration.points]
    axes = [sp.Matrix([c.diff(prime(q)) for c in _turning(r)]) for r in configuration.rotations for q in turned]
    around = [r.diff(q) for r in places for q in turned]
    along = [b for r in places for q in others if not (b := r.diff(q)).is_zero_matrix]
    return (
        bool(along)
        and all(all(_is_zero(x) for x in b.cross(a)) for b in along for a in axes)
        and all(_is_zero(b.dot(a)) for b in along for a in around)
    )


def _turns_rigidly(q: sp.Symbol, configuration: Configuration) -> bool:
    """Whether what q moves is turned about axes of one direction, all bodies through the same angle.

    The coordinate of a screw, or of gears, has a momentum that is not that of a rotation. A point by itself is turned
    if the curve r(q) on which q leads it has no torsion: dr/dq, d²r/dq² and d³r/dq³ lie in a plane.
    """
    places = [sp.Matrix(p.position.fixed().components) for p in configuration.points if p.mass != 0]
    rates = [sp.Matrix([c.diff(prime(q)) for c in _turning(r)]) for r in configuration.rotations if r.has_inertia]
    axes = [a for a in rates if not a.is_zero_matrix]
    around = [r.diff(q) for r in places]
    zero = configuration.states.is_zero
    if any(zero(x) is not True for a in axes for x in a - axes[0]):
        return False
    if any(zero(b.dot(a)) is not True for b in around for a in axes[:1]):
        return False
    return all(zero(b.dot(b.diff(q).cross(b.diff(q, 2)))) is True for b in around)


def _is_zero(e: sp.Expr) -> bool:
    return bool(sp.expand(e) == 0)


def _turns(q: sp.Symbol, configuration: Configuration) -> bool:
    """Whether a coordinate is an angle: of a position, or of a body."""
    places = [c for p in configuration.points for c in p.position.fixed().components]
    if any(q in w.free_symbols for e in places for w in e.atoms(sp.sin, sp.cos)):
        return True
    return any(prime(q) in e.free_symbols for r in configuration.rotations for e in _turning(r))


def _turning(rotation: Rotation) -> tuple[sp.Expr, ...]:
    return rotation.angular_velocity.fixed().components
