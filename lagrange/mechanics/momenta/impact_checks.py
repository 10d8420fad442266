"""An impact checked by second routes, exactly.

The velocities and impulses were found from virtual displacements, with the masses in the form of a matrix. Here the
momenta are ∂T/∂q' of the kinetic energy from positions and axes (`lagrangian.kinetic_energy`), the constraints are
differentiated in time, and the change of T is compared with the energy that is lost place by place. Where there are
free bodies, m Δv and ΔH of each are compared with the impulses on it, as vectors: momentum and moment of momentum.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.core.records import all_hold
from lagrange.core.symbols import partial
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy, share_of_load, share_of_torque
from lagrange.mechanics.momenta.impact import ImpulsiveMotion, reactions_of
from lagrange.problem.model import Impact, Problem

_HOW = "exact, at random points"


def check_impact(motion: ImpulsiveMotion, problem: Problem) -> list[Check]:
    """The checks of an impact."""
    assert problem.impact is not None
    name, surface = motion.configuration.name, motion.surface
    checks = [
        Check("the velocities after the impact satisfy the constraints", _constraints_hold(motion), _HOW, name),
        Check("the impulses change the momenta ∂T/∂q' by the right amount", _momenta_change(motion), _HOW, name),
        Check("the kinetic energy changes by the work of the impulses", _energy_agrees(motion), _HOW, name),
    ]
    balance = [*_balance_of_bodies(motion, problem, problem.impact)]
    if balance:
        holds = all_hold(surface.is_zero(e) for e in balance)
        checks.append(Check("momentum and moment of momentum of each body agree with its impulses", holds, _HOW, name))
    if _is_carnot(motion):
        lost = _energy_of_lost_velocities(motion)
        holds = surface.is_zero(lost - motion.energy_lost)
        checks.append(Check("the energy lost is that of the lost velocities (Carnot)", holds, _HOW, name))
    return checks


def _constraints_hold(motion: ImpulsiveMotion) -> bool | None:
    """df/dt before and after, for the constraints of the file as they are written."""
    slots = motion.full.slots
    residuals = []
    for row, impulse in zip(motion.full.rows, motion.impulses, strict=True):
        rate = slots.time_derivative(row.finite) if row.finite is not None else row.velocity_form(slots)
        before, after = motion.just_before(rate), motion.after(rate)
        residuals += [after + impulse.restitution * before] if impulse.is_new else [after, before]
    return all_hold(motion.surface.is_zero(e) for e in residuals)


def _momenta_change(motion: ImpulsiveMotion) -> bool | None:
    """∂T/∂q' after less that before, less the blows, in all coordinates: Aᵀ Λ, or in the span of the rows."""
    full = motion.full
    energy = kinetic_energy(full)
    changes = []
    for v in full.slots.velocities:
        momentum = partial(energy, v)
        blow = sp.Add(*(share_of_load(f, v, full) for f in full.loads))
        blow += sp.Add(*(share_of_torque(m, v, full) for m in full.torques))
        changes.append(motion.after(momentum) - motion.just_before(momentum) - motion.at(blow))
    forms = [[motion.at(a) for a in row.coefficients] for row in full.rows]
    if motion.open_impulses:
        ranks = [motion.surface.rank(rows) for rows in (forms, [*forms, changes])]
        return None if None in ranks else ranks[0] == ranks[1]
    values = [i.multiplier for i in motion.impulses]
    for k, change in enumerate(changes):
        reactions = sp.Add(*(form[k] * v for form, v in zip(forms, values, strict=True) if v is not None))
        changes[k] = change - reactions
    return all_hold(motion.surface.is_zero(e) for e in changes)


def _energy_agrees(motion: ImpulsiveMotion) -> bool | None:
    energy = kinetic_energy(motion.full)
    before, after = motion.just_before(energy), motion.after(energy)
    stated = motion.kinetic[0] - before, motion.kinetic[1] - after
    work = sp.S.Zero if motion.is_driven else motion.work
    lost = before - after + work - motion.energy_lost
    return all_hold(motion.surface.is_zero(e) for e in (*stated, lost))


def _balance_of_bodies(motion: ImpulsiveMotion, problem: Problem, impact: Impact) -> Iterator[sp.Expr]:
    """The components of m Δv − R̂ − Ĵ and of ΔH − Γ̂ − Ĝ, in i, j, k, for each free body, if there are any."""
    newton = reactions_of(motion.full, problem, impact)
    if newton.bodies is None or motion.open_impulses or newton.idle:
        return
    full = motion.full
    value = {i.name: i.multiplier for i in motion.impulses}
    turning = {r.name: r for r in full.rotations}
    placed = {b.name for b in newton.bodies}
    for p in full.points:
        if p.name not in placed:
            continue
        change = _change(p.velocity.fixed() * p.mass, motion)
        acting = [_at(f.vector.fixed(), motion) for f in full.loads if f.on == p.name]
        pulls = [(r.on(p.name), value[r.name]) for r in newton.reactions]
        acting += [_at(d.fixed(), motion) * v for d, v in pulls if d is not None and v is not None]
        yield from _less(change, acting).components
        if p.name in turning:
            spin = _change(turning[p.name].momentum.fixed(), motion)
            moments = [_at(m.fixed(), motion) for m in full.moments_on(p.name)]
            about = [(r.moments.get(p.name), value[r.name]) for r in newton.reactions]
            moments += [_at(d.fixed(), motion) * v for d, v in about if d is not None and v is not None]
            yield from _turning(spin, moments, full, p.name)


def _at(vector: Vector, motion: ImpulsiveMotion) -> Vector:
    return vector.map(motion.at)


def _change(vector: Vector, motion: ImpulsiveMotion) -> Vector:
    return vector.map(lambda c: motion.after(c) - motion.just_before(c))


def _less(change: Vector, acting: Sequence[Vector]) -> Vector:
    for vector in acting:
        change = change - vector
    return change


def _turning(spin: Vector, moments: Sequence[Vector], full: Configuration, body: str) -> Iterator[sp.Expr]:
    """ΔH less the moments: about k alone for a body that turns in the plane only."""
    total = _less(spin, moments)
    [rotation] = (r for r in full.rotations if r.name == body)
    planar = all(c == 0 for c in rotation.angular_velocity.fixed().components[:2])
    yield from total.components[2:] if planar else total.components


def _is_carnot(motion: ImpulsiveMotion) -> bool:
    return (
        bool(motion.new)
        and not motion.is_driven
        and not motion.full.loads
        and not motion.full.torques
        and all(i.restitution == 0 for i in motion.impulses)
    )


def _energy_of_lost_velocities(motion: ImpulsiveMotion) -> sp.Expr:
    """T of q'_0 − q'."""
    velocities = motion.slots.velocities
    lost = {v: b - a for v, a, b in zip(velocities, motion.velocities, motion.before, strict=True)}
    energy = kinetic_energy(motion.configuration)
    return energy.xreplace(motion.position).xreplace(lost)
