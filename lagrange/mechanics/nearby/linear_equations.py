"""The equations of motion and the constraints to first order about one state, from d'Alembert's principle.

With J_k = ∂r/∂q_k the principle has the coefficients

    E_k = Σ m r''·J_k + Σ (I ω' + ω × I ω)·ω_k − Q_k ,        E_k = Σ λ a_k ,

and about a state (q, q') without accelerations, with the changes ξ, η = ξ', ζ = ξ'',

    r'' = J_l ζ_l + 2 (∂_q' J_l) η_l + (∂_q'² J_l) ξ_l + ∂_q' ∂_q' r ,       ∂_q' = Σ q_m' ∂_m ,

so that E = E_0 + M ζ + D η + K ξ; in the same way the rows a·q' + a_t = 0 become a η + b ξ = 0. The reactions change
as well: K has −Σ λ ∂a_k/∂q_l besides.

Shapes: M, D, K (n, n), E_0 (n,), a and b (m, n), G (finite relations, n).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from lagrange.algebra.forms.jets import Jet
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.nearby.expansions import Expansions

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
