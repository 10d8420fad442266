"""Vectors and directions that stay the same along every motion, and what that says of a path.

Vectors that stay the same in space, and what that says of a path.

*Angular momentum of a body.* Without a moment about its mass centre dH/dt = 0: H keeps its direction and its size in
space, so the squares of its components along the axes of the body have a constant sum.

*Angular momentum about the origin, with a part along the radius.* If the moment r × F is κ de/dt, where e = r/|r| and
κ is a constant, then J = m r × v − κ e does not change. As r × v is perpendicular to e, J·e = −κ: the radius makes a
constant angle with a constant vector. The path lies on a cone (Poincaré 1896); where κ = 0 it lies in a plane.

*Distance.* d²(r²)/dt² = 2 v² + 2 r·a. If r·a = 0 and the speed is constant, r² = v² t² + const, with the time from
where the particle is nearest.

Whether an expression vanishes along every motion: whether it follows from the equations of motion.

An expression that is affine in the accelerations is a linear combination of the equations of motion, and of the
constraints differentiated, if it does not raise their rank at random states of motion.

A direction that stays, and motions whose velocity changes in a way that the position does not enter.

*A ratio of velocities.* d/dt (y'/x') = (x' y'' − y' x'')/x'². If that vanishes, the velocity keeps its direction in the
plane of x and y, although neither velocity need be constant.

*The hodograph.* Where x'' and y'' depend on the velocities only, x' = v cos ψ and y' = v sin ψ give
v ψ' = y'' cos ψ − x'' sin ψ, and with u = x' an equation between u and ψ alone, du/dψ = x''/ψ'. For a drag D(v)
against the velocity and a constant gravity it is m g du = v D(v) dψ (Johann Bernoulli 1719).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, differential, prime, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.comparison import follow
from lagrange.mechanics.dynamics.equations import EquationsOfMotion
from lagrange.mechanics.limits import LONGEST_CONSEQUENCE, LONGEST_FOLLOWED
from lagrange.mechanics.results import InCoordinates

if TYPE_CHECKING:
    from lagrange.mechanics.constraints.rigid_bodies import Rotation


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


# Along every motion


def is_short(motion: EquationsOfMotion) -> bool:
    """Whether the equations of motion are short enough, and contain no function that is not specified."""
    equations = [e.expression for e in motion.final]
    return not any(e.has(Unspecified) for e in equations) and sum(map(count_operations, equations)) <= LONGEST_FOLLOWED


def vanish_along(motion: EquationsOfMotion, claims: Sequence[sp.Expr]) -> bool:
    """Whether all of these vanish along every motion; False, too, where that is undecided."""
    configuration = motion.configuration
    known = [*(e.expression for e in motion.final), *configuration.accelerated_constraints]
    try:
        return follow(configuration, claims, known, configuration.slots.accelerations) is True
    except DivisionByZeroError:
        return False


# Directions


def kept_directions(view: InCoordinates) -> Iterator[tuple[sp.Symbol, sp.Symbol]]:
    """Pairs of coordinates x, y of one point along fixed unit vectors, with y'/x' = const although x'' ≠ 0.

    None if the constraints are finite relations: a straight guide keeps the direction of what runs along it.
    """
    motion = view.motion
    if motion is None or not is_short(motion) or any(r.finite is not None for r in view.configuration.rows):
        return
    slots = view.configuration.slots
    rates = dict(zip(slots.coordinates, zip(slots.velocities, slots.accelerations, strict=True), strict=True))
    for point in view.configuration.points:
        own = [q for q in point.position.fixed().components if q in rates]
        for x, y in combinations(own, 2):
            (v, a), (w, b) = rates[x], rates[y]
            # Uniform motion is a straight line, and no result.
            if (
                vanish_along(motion, [v * b - w * a])
                and not vanish_along(motion, [a])
                and not vanish_along(motion, [b])
            ):
                yield x, y


@record
class Hodograph:
    """du/dψ for the velocity u = x' of a point that moves in the plane of x and y.

    speed, angle, ahead  v, ψ and u
    turning  v ψ'
    sides    the two sides of the equation between du and dψ, without denominators
    """

    first: sp.Symbol
    second: sp.Symbol
    speed: sp.Symbol
    angle: sp.Symbol
    ahead: sp.Symbol
    turning: sp.Expr
    sides: tuple[sp.Expr, sp.Expr]


def hodograph(view: InCoordinates, letters: tuple[str, str, str]) -> Hodograph | None:
    """The equation between u and ψ, where it is short and the equations of motion are not linear in the velocities.

    letters  the names for v, ψ and u
    """
    motion, slots = view.motion, view.configuration.slots
    if motion is None or view.configuration.rows or len(slots.coordinates) != 2 or len(view.configuration.points) != 1:
        return None
    pair = _in_a_plane(view.configuration.points[0], slots.coordinates)
    accelerations = None if pair is None else _accelerations(view)
    if pair is None or accelerations is None:
        return None
    rates = [slots.velocities[slots.coordinates.index(q)] for q in pair]
    if all(is_zero(a.diff(v, w)) is True for a in accelerations.values() for v in rates for w in rates):
        return None
    v, u = sp.Symbol(letters[0], positive=True), sp.Symbol(letters[2], real=True)
    psi = sp.Symbol(letters[1], real=True)
    size = sp.sqrt(rates[0] ** 2 + rates[1] ** 2)
    components = dict(zip(rates, (v * sp.cos(psi), v * sp.sin(psi)), strict=True))
    a, b = (accelerations[prime(q, 2)].xreplace({size: v, 1 / size: 1 / v}).xreplace(components) for q in pair)
    turning = textbook_form(sp.expand(b * sp.cos(psi) - a * sp.sin(psi)))
    if is_zero(a) is not False or is_zero(turning) is not False:
        return None
    numerator, denominator = sp.fraction(sp.cancel(sp.together(v * a / turning)))
    sides = (denominator * differential(u), numerator * differential(psi))
    if any(isinstance(s, sp.Add) or count_operations(s) > LONGEST_CONSEQUENCE for s in (numerator, denominator)):
        return None
    return Hodograph(*pair, v, psi, u, turning, sides)


def _in_a_plane(point: MassPoint, coordinates: tuple[sp.Symbol, ...]) -> tuple[sp.Symbol, sp.Symbol] | None:
    """The coordinates of a point along two fixed unit vectors, in the order of these."""
    components = [c for c in point.position.fixed().components if c != 0]
    if {*components} != {*coordinates} or len(components) != 2:
        return None
    first, second = components
    assert isinstance(first, sp.Symbol)
    assert isinstance(second, sp.Symbol)
    return first, second


def _accelerations(view: InCoordinates) -> dict[sp.Symbol, sp.Expr] | None:
    """The accelerations, if each is alone on one side of an equation and neither position nor time occurs."""
    assert view.motion is not None
    slots = view.configuration.slots
    solved = {}
    for e in view.motion.final:
        own = [a for a in slots.accelerations if e.expression.has(a)]
        if len(own) != 1 or e.expression.free_symbols & {*slots.coordinates, t}:
            return None
        factor = e.expression.diff(own[0])
        if factor.free_symbols & {*slots.velocities, *slots.accelerations}:
            return None
        solved[own[0]] = sp.expand(-e.expression.xreplace({own[0]: sp.S.Zero}) / factor)
    return solved if len(solved) == 2 else None
