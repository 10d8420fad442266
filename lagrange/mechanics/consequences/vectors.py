"""Vectors that stay the same in space, and what that says of a path.

*Angular momentum of a body.* Without a moment about its mass centre dH/dt = 0: H keeps its direction and its size in
space, so the squares of its components along the axes of the body have a constant sum.

*Angular momentum about the origin, with a part along the radius.* If the moment r × F is κ de/dt, where e = r/|r| and
κ is a constant, then J = m r × v − κ e does not change. As r × v is perpendicular to e, J·e = −κ: the radius makes a
constant angle with a constant vector. The path lies on a cone (Poincaré 1896); where κ = 0 it lies in a plane.

*Distance.* d²(r²)/dt² = 2 v² + 2 r·a. If r·a = 0 and the speed is constant, r² = v² t² + const, with the time from
where the particle is nearest.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.mechanics.consequences.along import is_short, vanish_along
from lagrange.mechanics.consequences.limits import LONGEST_CONSEQUENCE
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.results import InCoordinates


@record
class ConstantSpin:
    """The angular momentum of a body about its mass centre is constant in space. `square`: H², if that is short."""

    body: str
    square: sp.Expr | None


@record
class ConeVector:
    """m r × v − factor · e is constant for a particle at r = |r| e; with factor 0 the path lies in a plane.

    direction  e, if it is one of the unit vectors of the file; None: r/|r| has to be written
    spread     whether r² = v² t² + const
    """

    particle: str
    mass: sp.Expr
    factor: sp.Expr
    direction: sp.Expr | None
    spread: bool


def constant_spins(view: InCoordinates) -> Iterator[ConstantSpin]:
    """The bodies on which no moment acts about their mass centres, and that do not turn about one direction only."""
    motion = view.motion
    if motion is None or view.configuration.is_outright or not is_short_enough(view):
        return
    for rotation in view.configuration.rotations:
        if not rotation.has_inertia or not _turns_in_space(rotation):
            continue
        if vanish_along(motion, rotation.momentum_rate.components):
            yield ConstantSpin(rotation.name, _square(view, rotation))


def is_short_enough(view: InCoordinates) -> bool:
    """Whether the equations of motion, or those in quasi-velocities, are short enough to ask what follows."""
    motion, form = view.motion, view.in_speeds
    if motion is None:
        return False
    return is_short(motion) or (form is not None and form.equations is not None)


def _turns_in_space(rotation: Rotation) -> bool:
    return sum(is_zero(c) is not True for c in rotation.angular_velocity.fixed().components) == 3


def _square(view: InCoordinates, rotation: Rotation) -> sp.Expr | None:
    form = view.in_speeds
    known = {} if form is None or form.equations is None else form.equations.momenta
    momentum = known.get(rotation.name, rotation.momentum)
    square = textbook_form(momentum.dot(momentum))
    return square if count_operations(square) <= LONGEST_CONSEQUENCE else None


def cone_vector(view: InCoordinates) -> ConeVector | None:
    """The constant vector of a particle in space that nothing constrains."""
    motion, configuration = view.motion, view.configuration
    if motion is None or not is_short(motion) or not _is_one_free_particle(configuration):
        return None
    [point] = configuration.points
    if sum(c != 0 for c in point.position.fixed().components) < 3:
        return None
    e = _direction(point)
    moment = point.position.cross(point.acceleration) * point.mass
    turned = e.time_derivative(configuration.slots)
    factor = _ratio(configuration, turned)
    if factor is None or not vanish_along(motion, (moment - turned * factor).fixed().components):
        return None
    named = e.as_sum()
    return ConeVector(
        point.name, point.mass, factor, named if len(named.free_symbols) == 1 else None, _spreads(motion, point)
    )


def _is_one_free_particle(c: Configuration) -> bool:
    alone = len(c.points) == 1 and not c.rotations and not c.rows and len(c.slots.coordinates) == 3
    plain = not c.is_outright and not c.variable_masses and not c.slots.prescribed
    return alone and plain


def _direction(point: MassPoint) -> Vector:
    first, *others = point.position.components
    if not any(others) and first.is_Symbol:
        return Vector((sp.S.One, sp.S.Zero, sp.S.Zero), point.position.triad)
    e: Vector = point.position / point.position.norm()
    return e


def _ratio(configuration: Configuration, turned: Vector) -> sp.Expr | None:
    """κ with r × F = κ de/dt, a constant; 0 where the force is central."""
    moment = Vector.zero()
    for load in configuration.loads:
        moment = moment + load.point.cross(load.vector)
    if moment.is_zero or all(is_zero(c) is True for c in moment.components):
        return sp.S.Zero
    for m, rate in zip(moment.along(turned.triad).components, turned.components, strict=True):
        if is_zero(rate) is not True:
            factor = textbook_form(sp.cancel(m / rate))
            moving = {*configuration.slots.coordinates, *configuration.slots.velocities, t}
            return None if factor.free_symbols & moving else factor
    return None


def _spreads(motion: EquationsOfMotion, point: MassPoint) -> bool:
    """Whether r·a = 0 and v·a = 0."""
    claims = [point.acceleration.dot(point.position), point.acceleration.dot(point.velocity)]
    return vanish_along(motion, claims)
