"""The equations of motion and the constraints to first order about one state, from d'Alembert's principle.

With J_k = ∂r/∂q_k the principle has the coefficients

    E_k = Σ m r''·J_k + Σ (I ω' + ω × I ω)·ω_k − Q_k ,        E_k = Σ λ a_k ,

and about a state (q, q') without accelerations, with the changes ξ, η = ξ', ζ = ξ'',

    r'' = J_l ζ_l + 2 (∂_q' J_l) η_l + (∂_q'² J_l) ξ_l + ∂_q' ∂_q' r ,       ∂_q' = Σ q_m' ∂_m ,

so that E = E_0 + M ζ + D η + K ξ; in the same way the rows a·q' + a_t = 0 become a η + b ξ = 0. The reactions change
as well: K has −Σ λ ∂a_k/∂q_l besides.

Shapes: M, D, K (n, n), E_0 (n,), a and b (m, n), G (finite relations, n).

A system about one state, as Taylor series in small changes of q and q', with numbers of eighty digits.

With ξ and η the small changes of q and q', the positions of mass centres and the axes of bodies are expanded to third
order in ξ, forces and the forms of constraints to first or second order in ξ and η. Nothing is multiplied out or
differentiated in symbols, so that the effort grows with the length of the file, and not with that of the equations of
motion, which for a bicycle fill fifty pages.

The state about which a motion is linearized: what `initial` says, and what follows from it by the constraints.

Coordinates that `initial` omits are found from the finite relations by Newton's iteration, which starts at zero;
velocities from A q' + a_t = 0, which must determine them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random
from typing import Any

import sympy as sp

from lagrange.algebra.exact.limits import NEWTON_STEPS
from lagrange.algebra.exact.linear_algebra import row_reduced, solution
from lagrange.algebra.exact.points_needed import REAL_DIGITS, ZERO_DIGITS
from lagrange.algebra.exact.real_points import Reals, symmetric_eigensystem
from lagrange.algebra.forms.jets import BITS, Expansion, Jet, JetRing, constant_term
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import Slots, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.limits import ROUNDED_TO_ZERO

CoefficientTable = list[list[Any]]


@record
class FirstOrderTerms:
    """M, D, K and E_0 without the reactions, and the rows of the constraints with their changes.

    slope   (n, n) tables for each row: ∂a_k/∂q_l
    """

    mass: CoefficientTable
    damping: CoefficientTable
    stiffness: CoefficientTable
    balance: list[Any]
    rows: CoefficientTable
    changes: CoefficientTable
    slope: list[CoefficientTable]
    misfit: list[Any]


def first_order(configuration: Configuration, about: Expansions, velocities: Sequence[Any]) -> FirstOrderTerms:
    """The equations without reactions, and the constraints, to first order about a state. Raises NotCoveredError."""
    if configuration.is_outright or configuration.velocity_part != 0 or configuration.slots.prescribed:
        raise NotCoveredError(
            "linear equations in numbers where forces or motions depend on time or on potentials of velocities"
        )
    n, zero = about.size, about.reals.number(0)
    total = _Sum(
        [[zero] * n for _ in range(n)], [[zero] * n for _ in range(n)], [[zero] * n for _ in range(n)], [zero] * n
    )
    for p in configuration.points:
        if p.mass != 0:
            place = about.vector(p.position, 3)
            partials = [[about.ring.derivative(c, k) for c in place] for k in range(n)]
            _add_inertia(total, about, partials, [about.number(p.mass)] * 3, velocities)
    turnings = {r.name: _turning(r, about) for r in configuration.rotations}
    for r in configuration.rotations:
        if r.has_inertia:
            turning, moments = _principal(r, about, turnings[r.name])
            _add_inertia(total, about, turning, moments, velocities)
            _add_gyroscopic(total, about, turning, moments, velocities)
    for k, jet in enumerate(_forces(configuration, about, turnings)):
        total.balance[k] -= about.at_state(jet)
        for table, first in ((total.stiffness, 0), (total.damping, n)):
            table[k] = [a - b for a, b in zip(table[k], about.gradient(jet, first), strict=True)]
    rows = [[about.jet(a, 2) for a in row.coefficients] for row in configuration.rows]
    drifts = [about.jet(row.drift, 2) for row in configuration.rows]
    changes, misfit = [], []
    for row, drift in zip(rows, drifts, strict=True):
        rate = drift
        for a, v in zip(row, velocities, strict=True):
            rate = about.ring.add(rate, about.ring.scale(a, v))
        changes.append(about.gradient(rate))
        misfit.append(about.at_state(about.along(rate, velocities)))
    return FirstOrderTerms(
        total.mass,
        total.damping,
        total.stiffness,
        total.balance,
        [[about.at_state(a) for a in row] for row in rows],
        changes,
        [[about.gradient(a) for a in row] for row in rows],
        misfit,
    )


@record
class _Sum:
    """M, D, K, E_0 as they are added up."""

    mass: CoefficientTable
    damping: CoefficientTable
    stiffness: CoefficientTable
    balance: list[Any]


def _turning(rotation: Rotation, about: Expansions) -> list[list[Jet]]:
    """ω_k, shape (n, 3), along the axes of the body: ω_k·e_1 = ∂_k e_2·e_3, and so on."""
    e = [[about.jet(c, 3) for c in axis.fixed().components] for axis in rotation.axes]
    d = about.ring.derivative
    return [[about.dot([d(c, k) for c in e[i - 2]], e[i - 1]) for i in range(3)] for k in range(about.size)]


def _principal(rotation: Rotation, about: Expansions, turning: list[list[Jet]]) -> tuple[list[list[Jet]], list[Any]]:
    """ω_k along principal axes, and the principal moments: with products of inertia the axes are turned in numbers."""
    if rotation.inertia.is_principal:
        return turning, [about.number(moment) for moment in rotation.inertia.moments]
    moments, axes = about.reals.principal_axes([[about.number(e) for e in row] for row in rotation.inertia.rows])
    ring = about.ring

    def along(spin: Sequence[Jet], axis: Sequence[Any]) -> Jet:
        total = ring.scale(spin[0], axis[0])
        for component, x in zip(spin[1:], axis[1:], strict=True):
            total = ring.add(total, ring.scale(component, x))
        return total

    return [[along(spin, axis) for axis in axes] for spin in turning], moments


def _add_inertia(
    total: _Sum, about: Expansions, partials: Sequence[Sequence[Jet]], weights: Sequence[Any], rates: Sequence[Any]
) -> None:
    """Σ w s'·S_k to first order, with s = Σ S_l q_l' of shape (3,), S being `partials` of shape (n, 3)."""
    n = about.size
    values = [[about.at_state(c) for c in s] for s in partials]
    slopes = [[about.gradient(c) for c in s] for s in partials]  # ∂_l S_k, shape (n, 3, n)
    ahead = [[about.along(c, rates) for c in s] for s in partials]  # ∂_q' S_l
    for c, w in enumerate(weights):
        speed = about.ring.constant(about.reals.number(0), len(partials[0][c]) - 1)
        for s, v in zip(partials, rates, strict=True):
            if v:
                speed = about.ring.add(speed, about.ring.scale(s[c], v))
        growth = about.along(speed, rates)  # s' without accelerations, as a function of q
        steady, bent, drawn = about.at_state(growth), about.gradient(growth), about.gradient(speed)
        for k in range(n):
            if not values[k][c] and not any(slopes[k][c]):
                continue
            lever = w * values[k][c]
            total.balance[k] += lever * steady
            for i in range(n):
                total.mass[k][i] += lever * values[i][c]
                total.damping[k][i] += lever * (about.at_state(ahead[i][c]) + drawn[i])
                total.stiffness[k][i] += lever * bent[i] + w * steady * slopes[k][c][i]


def _add_gyroscopic(
    total: _Sum, about: Expansions, partials: Sequence[Sequence[Jet]], moments: Sequence[Any], rates: Sequence[Any]
) -> None:
    """(ω × I ω)·ω_k to first order."""
    n, ring = about.size, about.ring
    spin = []
    for c in range(3):
        w = ring.constant(about.reals.number(0), len(partials[0][c]) - 1)
        for s, v in zip(partials, rates, strict=True):
            if v:
                w = ring.add(w, ring.scale(s[c], v))
        spin.append(w)
    momentum = [ring.scale(w, moment) for w, moment in zip(spin, moments, strict=True)]
    moment = about.cross(spin, momentum)
    steady = [about.at_state(w) for w in spin]
    angular = [about.at_state(h) for h in momentum]
    values = [[about.at_state(c) for c in s] for s in partials]

    def crossed(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
        return [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]

    changes = []  # of ω × I ω with q_i'
    for i in range(n):
        turned = [moment * w for moment, w in zip(moments, values[i], strict=True)]
        changes.append([x + y for x, y in zip(crossed(values[i], angular), crossed(steady, turned), strict=True)])
    for k in range(n):
        share = about.dot(moment, partials[k])
        total.balance[k] += about.at_state(share)
        for i, slope in enumerate(about.gradient(share)):
            total.stiffness[k][i] += slope
            total.damping[k][i] += sum(x * y for x, y in zip(changes[i], values[k], strict=True))


def _forces(configuration: Configuration, about: Expansions, turnings: dict[str, list[list[Jet]]]) -> list[Jet]:
    """Q_k, shape (n,), to first order in the changes of coordinates and velocities."""
    n, ring = about.size, about.ring
    places = {p.name: about.vector(p.position, 2) for p in configuration.points}
    axes = {
        r.name: [[about.jet(c, 2) for c in axis.fixed().components] for axis in r.axes] for r in configuration.rotations
    }
    forces = [ring.constant(about.reals.number(0), 1) for _ in range(n)]

    def add(k: int, share: Jet) -> None:
        forces[k] = ring.add(forces[k], share[:2])

    def add_moment(body: str, moment: Sequence[Jet]) -> None:
        for k in range(n):
            along = [about.dot(moment, axis) for axis in axes[body]]
            add(k, about.dot(along, turnings[body][k]))

    for load in configuration.loads:
        vector = about.vector(load.vector, 1, moving=True)
        place = places[load.on] if load.on in axes else about.vector(load.point, 2)
        for k in range(n):
            add(k, about.dot(vector, [ring.derivative(c, k) for c in place]))
        if load.on in axes:
            arm = tuple(ring.subtract(a, b) for a, b in zip(about.vector(load.point, 2), place, strict=True))
            if any(any(level) for c in arm for level in c):
                add_moment(load.on, about.cross(arm, vector))
    for torque in configuration.torques:
        add_moment(torque.on, about.vector(torque.vector, 1, moving=True))
    if configuration.potential != 0:
        energy = about.jet(configuration.potential, 2)
        for k in range(n):
            add(k, ring.scale(ring.derivative(energy, k), about.reals.number(-1)))
    for k, e in enumerate(configuration.generalized):
        add(k, about.jet(e, 1, moving=True))
    for damper in configuration.dampers:
        rate, pull = (about.jet(e, 2, moving=True) for e in (damper.rate, damper.pull))
        for k in range(n):
            share = about.dot([pull], [ring.derivative(rate, n + k)])
            add(k, ring.scale(share, about.reals.number(-1)))
    return forces


# Expansions


Numbers = Mapping[sp.Symbol, sp.Expr]


class RoundedReals(Reals):
    """Real numbers of eighty digits, of which fifty-five are used: what is smaller counts as zero."""

    def vanishes(self, x: Any) -> bool:
        """Whether x is 0."""
        return bool(abs(x) < ROUNDED_TO_ZERO)

    def principal_axes(self, matrix: Sequence[Sequence[Any]]) -> tuple[list[Any], list[list[Any]]]:
        """The principal values of a symmetric matrix (3, 3), and their axes, right-handed, as rows."""
        values, columns = symmetric_eigensystem([list(row) for row in matrix])
        axes = [[columns[i, k] for i in range(3)] for k in range(3)]
        a, b, c = axes
        cross = [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]
        if sum(x * y for x, y in zip(cross, c, strict=True)) < 0:
            axes[2] = [-x for x in c]
        return [values[k] for k in range(3)], axes


class Expansions:
    """Expansions about the state `values`, which has numbers for parameters, coordinates and velocities.

    Variable k is the change of coordinate k, variable n + k that of its velocity.
    """

    def __init__(self, slots: Slots, values: Numbers) -> None:
        self.reals = RoundedReals(Random(0))
        self.ring = JetRing(self.reals)
        self.size = len(slots.coordinates)
        self._values = {**values, t: sp.S.Zero}
        self._symbols = (*slots.coordinates, *slots.velocities)
        self._known: dict[tuple[int, bool], Expansion] = {}
        self._numbers: dict[sp.Expr, Any] = {}

    def number(self, e: sp.Expr) -> Any:
        """The value of a short expression at the state."""
        known = self._numbers.get(e)
        if known is None:
            value = sp.N(e.xreplace(self._values), REAL_DIGITS + 5)
            known = self._numbers[e] = self.reals.float(sp.Float(value, REAL_DIGITS + 5))
        return known

    def value(self, e: sp.Expr) -> Any:
        """The value of a long expression at the state; each distinct part of it is worked out once."""
        return self.at_state(self.jet(e, 0, moving=True))

    def jet(self, e: sp.Expr, order: int, *, moving: bool = False) -> Jet:
        """The Taylor series of an expression of coordinates; of velocities too if `moving`."""
        key = order, moving
        if key not in self._known:
            symbols = self._symbols if moving else self._symbols[: self.size]
            variables = {s: self.ring.variable(k, self.number(s), order) for k, s in enumerate(symbols)}
            variables[t] = self.ring.variable(len(self._symbols), self.reals.number(0), order)
            self._known[key] = Expansion(self.ring, self.number, variables)
        return self._known[key](e)

    def vector(self, v: Vector, order: int, *, moving: bool = False) -> tuple[Jet, Jet, Jet]:
        """The Taylor series of the components of a vector in i, j, k."""
        a, b, c = (self.jet(e, order, moving=moving) for e in v.fixed().components)
        return a, b, c

    def dot(self, a: Sequence[Jet], b: Sequence[Jet]) -> Jet:
        """Σ a b, to the lowest order of all."""
        order = min(len(jet) for jet in (*a, *b)) - 1
        return self.ring.sum_of_products(zip(a, b, strict=True), order)

    def cross(self, a: Sequence[Jet], b: Sequence[Jet]) -> tuple[Jet, Jet, Jet]:
        """a × b."""
        times, less = self.ring.multiply, self.ring.subtract
        x, y, z = (less(times(a[k - 2], b[k - 1]), times(a[k - 1], b[k - 2])) for k in range(3))
        return x, y, z

    def along(self, jet: Jet, rates: Sequence[Any]) -> Jet:
        """Σ ∂_k jet · rates_k, over the coordinates; one order is lost."""
        total = self.ring.constant(self.reals.number(0), len(jet) - 2)
        for k, rate in enumerate(rates):
            if rate:
                total = self.ring.add(total, self.ring.scale(self.ring.derivative(jet, k), rate))
        return total

    def gradient(self, jet: Jet, first: int = 0) -> list[Any]:
        """The derivatives at the state by the coordinates, or by the variables from `first` on."""
        return [jet[1].get(1 << BITS * k, self.reals.number(0)) for k in range(first, first + self.size)]

    def at_state(self, jet: Jet) -> Any:
        """The value at the state."""
        return constant_term(jet) or self.reals.number(0)


# The state of reference


Rows = Sequence[Sequence[Any]]


@record
class ReferenceState:
    """A state in numbers, and which coordinates stand for the others in its neighbourhood.

    values       of parameters, coordinates and velocities
    independent  by index: the coordinates whose velocities are independent; those that `initial` gives come first
    placed       by index: the coordinates that the finite relations leave independent
    used         by index: the rows of constraints that are independent
    """

    values: Numbers
    independent: tuple[int, ...]
    placed: tuple[int, ...]
    used: tuple[int, ...]


def reference(
    configuration: Configuration,
    stated: Mapping[sp.Symbol, sp.Expr],
    parameters: Numbers,
    start: Mapping[sp.Symbol, sp.Expr] | None = None,
) -> ReferenceState:
    """The state that `initial` and the constraints determine. Raises ProblemError if they do not.

    start  where the iteration begins, for coordinates that are not stated; 0 by default
    """
    slots = configuration.slots
    size = len(slots.coordinates)
    values: dict[sp.Symbol, sp.Expr] = dict(parameters)
    for s in (*slots.coordinates, *slots.velocities):
        values[s] = stated.get(s, (start or {}).get(s, sp.S.Zero)).xreplace(parameters)
    loose = [k for k, q in enumerate(slots.coordinates) if q not in stated]
    gradients = _placed(configuration, values, loose)
    about = Expansions(slots, values)
    rows = [[about.value(a) for a in row.coefficients] for row in configuration.rows]
    drifts = [about.value(row.drift) for row in configuration.rows]
    # Columns to be solved for come first: velocities that nothing is said of, of coordinates that nothing is said of.
    order = sorted(range(size), key=lambda k: (slots.velocities[k] in stated, slots.coordinates[k] in stated, k))
    dependent = _columns(about, rows, order)
    used = _columns(about, [list(c) for c in zip(*rows, strict=True)], range(len(rows))) if rows else ()
    independent = tuple(k for k in range(size) if k not in dependent)
    missing = [k for k in independent if slots.velocities[k] not in stated]
    if missing and any(slots.velocities[k] in stated for k in range(size)):
        names = " and ".join(f"`{slots.velocities[k].name}`" for k in missing)
        raise ProblemError(
            Diagnostic(
                "undetermined-motion",
                f"`initial` and the constraints do not determine {names}",
                help=f"give as many velocities as there are degrees of freedom, {len(independent)}: `initial: "
                f"{{{slots.velocities[missing[0]].name}: 0, ...}}`",
            )
        )
    known = [about.number(values[v]) for v in slots.velocities]
    right = [
        -d - sum(a * v for k, (a, v) in enumerate(zip(row, known, strict=True)) if k not in dependent)
        for row, d in zip(rows, drifts, strict=True)
    ]
    solved = solution(about.reals, [[row[k] for k in dependent] for row in rows], right) if dependent else []
    if solved is None:
        raise _contradicted()
    for k, v in zip(dependent, solved, strict=True):
        if slots.velocities[k] in stated and abs(v - known[k]) > sp.Float(10) ** -ZERO_DIGITS:
            raise _contradicted()
        values[slots.velocities[k]] = sp.Float(v, REAL_DIGITS + 5)
    bound = _columns(about, gradients, [*loose, *(k for k in range(size) if k not in loose)]) if gradients else ()
    return ReferenceState(values, independent, tuple(k for k in range(size) if k not in bound), used)


def _columns(about: Expansions, rows: Rows, order: Sequence[int]) -> tuple[int, ...]:
    """Independent columns, the first ones in an order preferred."""
    return tuple(order[k] for k in row_reduced(about.reals, [[row[k] for k in order] for row in rows])[1])


def _placed(configuration: Configuration, values: dict[sp.Symbol, sp.Expr], loose: Sequence[int]) -> list[list[Any]]:
    """Moves the loose coordinates onto the finite relations; returns the gradients of these, shape (m, n)."""
    slots = configuration.slots
    finite = configuration.finite_constraints
    if not finite:
        return []
    for _ in range(NEWTON_STEPS):
        about = Expansions(slots, values)
        jets = [about.jet(f, 1) for f in finite]
        gradients = [about.gradient(jet) for jet in jets]
        off = [about.at_state(jet) for jet in jets]
        if max(map(abs, off)) < about.reals.number(1, 10 ** (REAL_DIGITS - 8)):
            return gradients
        moved = [[row[k] for k in loose] for row in gradients]
        normal = [[sum(a * b for a, b in zip(r, s, strict=True)) for s in moved] for r in moved]
        y = solution(about.reals, normal, off)
        if y is None or not loose:
            break
        for column, k in enumerate(loose):
            step = sum(row[column] * f for row, f in zip(moved, y, strict=True))
            place = about.number(values[slots.coordinates[k]]) - step
            values[slots.coordinates[k]] = sp.Float(place, REAL_DIGITS + 5)
    raise _contradicted()


def _contradicted() -> ProblemError:
    return ProblemError(
        Diagnostic(
            "initial-off-constraints",
            "no state near the one that `initial` gives satisfies the constraints",
            help="correct `initial`, or leave out the coordinates and velocities that follow from the others",
        )
    )
