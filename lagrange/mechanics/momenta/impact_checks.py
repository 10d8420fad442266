"""An impact checked by second routes, exactly.

The velocities and impulses were found from virtual displacements, with the masses in the form of a matrix. Here the
momenta are ∂T/∂q' of the kinetic energy from positions and axes (`lagrangian.kinetic_energy`), the constraints are
differentiated in time, and the change of T is compared with the energy that is lost place by place. Where there are
free bodies, m Δv and ΔH of each are compared with the impulses on it, as vectors: momentum and moment of momentum.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.core.symbols import partial
from lagrange.core.vectors import Vector
from lagrange.core.verdicts import all_hold
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy, share_of_load, share_of_torque
from lagrange.mechanics.momenta.impact import ImpulsiveMotion, reactions_of
from lagrange.problem.model import Impact, Problem

_HOW = "exact, at random points"


def check_impact(found: ImpulsiveMotion, problem: Problem) -> list[Check]:
    """The checks of an impact."""
    assert problem.impact is not None
    name, surface = found.configuration.name, found.surface
    checks = [
        Check("the velocities after the impact satisfy the constraints", _constraints_hold(found), _HOW, name),
        Check("the impulses change the momenta ∂T/∂q' by the right amount", _momenta_change(found), _HOW, name),
        Check("the kinetic energy changes by the work of the impulses", _energy_agrees(found), _HOW, name),
    ]
    balance = [*_balance_of_bodies(found, problem, problem.impact)]
    if balance:
        holds = all_hold(surface.is_zero(e) for e in balance)
        checks.append(Check("momentum and moment of momentum of each body agree with its impulses", holds, _HOW, name))
    if _is_carnot(found):
        lost = _energy_of_lost_velocities(found)
        holds = surface.is_zero(lost - found.energy_lost)
        checks.append(Check("the energy lost is that of the lost velocities (Carnot)", holds, _HOW, name))
    return checks


def _constraints_hold(found: ImpulsiveMotion) -> bool | None:
    """df/dt before and after, for the constraints of the file as they are written."""
    slots = found.full.slots
    residuals = []
    for row, impulse in zip(found.full.rows, found.impulses, strict=True):
        rate = slots.time_derivative(row.finite) if row.finite is not None else row.velocity_form(slots)
        before, after = found.just_before(rate), found.after(rate)
        residuals += [after + impulse.restitution * before] if impulse.is_new else [after, before]
    return all_hold(found.surface.is_zero(e) for e in residuals)


def _momenta_change(found: ImpulsiveMotion) -> bool | None:
    """∂T/∂q' after less that before, less the blows, in all coordinates: Aᵀ Λ, or in the span of the rows."""
    full = found.full
    energy = kinetic_energy(full)
    changes = []
    for v in full.slots.velocities:
        momentum = partial(energy, v)
        blow = sp.Add(*(share_of_load(f, v, full) for f in full.loads))
        blow += sp.Add(*(share_of_torque(m, v, full) for m in full.torques))
        changes.append(found.after(momentum) - found.just_before(momentum) - found.at(blow))
    forms = [[found.at(a) for a in row.coefficients] for row in full.rows]
    if found.open_impulses:
        ranks = [found.surface.rank(rows) for rows in (forms, [*forms, changes])]
        return None if None in ranks else ranks[0] == ranks[1]
    values = [i.multiplier for i in found.impulses]
    for k, change in enumerate(changes):
        reactions = sp.Add(*(form[k] * v for form, v in zip(forms, values, strict=True) if v is not None))
        changes[k] = change - reactions
    return all_hold(found.surface.is_zero(e) for e in changes)


def _energy_agrees(found: ImpulsiveMotion) -> bool | None:
    energy = kinetic_energy(found.full)
    before, after = found.just_before(energy), found.after(energy)
    stated = found.kinetic[0] - before, found.kinetic[1] - after
    work = sp.S.Zero if found.is_driven else found.work
    lost = before - after + work - found.energy_lost
    return all_hold(found.surface.is_zero(e) for e in (*stated, lost))


def _balance_of_bodies(found: ImpulsiveMotion, problem: Problem, impact: Impact) -> Iterator[sp.Expr]:
    """The components of m Δv − R̂ − Ĵ and of ΔH − Γ̂ − Ĝ, in i, j, k, for each free body, if there are any."""
    newton = reactions_of(found.full, problem, impact)
    if newton.bodies is None or found.open_impulses or newton.idle:
        return
    full = found.full
    value = {i.name: i.multiplier for i in found.impulses}
    turning = {r.name: r for r in full.rotations}
    placed = {b.name for b in newton.bodies}
    for p in full.points:
        if p.name not in placed:
            continue
        change = _change(p.velocity.fixed() * p.mass, found)
        acting = [_at(f.vector.fixed(), found) for f in full.loads if f.on == p.name]
        pulls = [(r.on(p.name), value[r.name]) for r in newton.reactions]
        acting += [_at(d.fixed(), found) * v for d, v in pulls if d is not None and v is not None]
        yield from _less(change, acting).components
        if p.name in turning:
            spin = _change(turning[p.name].momentum.fixed(), found)
            moments = [_at(m.fixed(), found) for m in full.moments_on(p.name)]
            about = [(r.moments.get(p.name), value[r.name]) for r in newton.reactions]
            moments += [_at(d.fixed(), found) * v for d, v in about if d is not None and v is not None]
            yield from _turning(spin, moments, full, p.name)


def _at(vector: Vector, found: ImpulsiveMotion) -> Vector:
    return vector.map(found.at)


def _change(vector: Vector, found: ImpulsiveMotion) -> Vector:
    return vector.map(lambda c: found.after(c) - found.just_before(c))


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


def _is_carnot(found: ImpulsiveMotion) -> bool:
    return (
        bool(found.new)
        and not found.is_driven
        and not found.full.loads
        and not found.full.torques
        and all(i.restitution == 0 for i in found.impulses)
    )


def _energy_of_lost_velocities(found: ImpulsiveMotion) -> sp.Expr:
    """T of q'_0 − q'."""
    velocities = found.slots.velocities
    lost = {v: b - a for v, a, b in zip(velocities, found.velocities, found.before, strict=True)}
    energy = kinetic_energy(found.configuration)
    return energy.xreplace(found.position).xreplace(lost)
