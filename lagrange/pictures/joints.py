"""The points about which plane bodies turn: fixed in space, in another body, or swinging on a string or rod."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.pictures.floats import FloatVector, NoValueError, solved
from lagrange.pictures.poses import AngleMark, Pose, angle_mark, circle_of
from lagrange.pictures.shapes import coordinates_in_body, plane_rotation


@record
class SwingingJoint:
    """A joint that one coordinate moves on a circle about a fixed place or about the joint before it.

    name  of the body or particle that the joint leads to
    """

    name: str
    coordinate: sp.Symbol
    mark: AngleMark
    is_fixed: bool


def turning_point(place: Vector, q: sp.Symbol) -> Vector:
    """The point about which a point turns with q: r = c + A cos q + B sin q has r″ = c − r."""
    components = place.fixed().components
    return Vector(tuple(c + c.diff(q, 2) for c in components)).map(textbook_form)


def swinging_joints(configuration: Configuration, pose: Pose) -> tuple[SwingingJoint, ...]:
    """The joints of chains: from a fixed place by one coordinate to a joint, from there by another one, and so on.

    A mass centre at b u(φ) + l/2 u(θ) hangs from the joint b u(φ); a point at a u(α) + a u(β) stands on the joint
    a u(α), where the coordinates are in the order of the file.
    """
    found: list[SwingingJoint] = []
    for p in configuration.points:
        rotation = plane_rotation(configuration, p.name)
        turning = set() if rotation is None else rotation.axes[0].fixed().as_sum().free_symbols & {*pose.coordinates}
        with suppress(NoValueError):
            found += _chain(p, pose, turning)
    return tuple(found)


def _chain(p: MassPoint, pose: Pose, turning: set[sp.Basic]) -> list[SwingingJoint]:
    """The joints that lead to one point, from the fixed place on; none if there is only one, or no fixed place."""
    place, joints = p.position.fixed(), list[SwingingJoint]()
    used = [q for q in pose.coordinates if not place.partial(q).is_zero]
    order = sorted(used, key=lambda q: (q in turning, used.index(q)))
    if len(order) < 2 or (turning and order[-1] not in turning):
        return []
    for q in reversed(order):
        centre = turning_point(place, q)
        if not centre.partial(q).is_zero:
            return []
        marks = [angle_mark(x, q, place) for x in (pose, *pose.others)]
        if len(marks) < 3 or marks[0] is None:
            return []
        fixed = not centre.as_sum().free_symbols & {*pose.coordinates}
        if not (q in turning and q == order[-1]):
            joints.append(SwingingJoint(p.name, q, marks[0], fixed))
        place = centre
    return joints[::-1] if not place.as_sum().free_symbols & {*pose.coordinates} else []


def on_circle(places: Sequence[FloatVector]) -> bool:
    """Whether points in the plane lie on one circle, that through three of them."""
    (x, y, _), *others = places[:: max(len(places) // 7, 1)]
    rows = [(2 * (u - x), 2 * (v - y)) for u, v, _ in others]
    sums = [u * u + v * v - x * x - y * y for u, v, _ in others]
    try:
        a, b = solved(rows[:2], sums[:2])
    except NoValueError:
        return False
    sizes = [math.dist((a, b), place[:2]) for place in places]
    return max(sizes) - min(sizes) < 1e-7


def circle_centres(pose: Pose, p: MassPoint, rotation: Rotation) -> list[Callable[[Pose], FloatVector | None]]:
    """For each coordinate that turns a body, the centre of the circle on which its mass centre then moves."""
    turning = set().union(*(c.free_symbols for c in rotation.axes[0].fixed().components)) & set(pose.coordinates)

    def centre(pose: Pose, q: sp.Symbol) -> FloatVector | None:
        mark = circle_of(pose, q, p.position)
        return None if mark is None else mark.centre

    return [lambda pose, q=q: centre(pose, q) for q in sorted(turning, key=str)]  # type: ignore[misc]


def same_everywhere(pose: Pose, place: Callable[[Pose], FloatVector | None]) -> bool:
    """Whether a place is the same in all positions."""
    places = [place(p) for p in (pose, *pose.others)]
    known = [p for p in places if p is not None]
    return len(known) > 2 and all(math.dist(known[0], p) < 1e-7 for p in known)


def holds(pose: Pose, body: MassPoint, point: Callable[[Pose], FloatVector | None]) -> bool:
    """Whether a point is fixed in a body."""
    rotation = plane_rotation(pose.configuration, body.name)
    if rotation is None:
        return False

    def inside(x: Pose) -> FloatVector | None:
        place = point(x)
        if place is None:
            return None
        return (*coordinates_in_body(x, rotation, body.position, place), 0.0)

    return same_everywhere(pose, inside)
