"""The shape of a plane body, as far as its reactions reveal it.

A force R with the moment Γ about the mass centre acts along the line through r = R × Γ/R² from there. In several
positions of the system, that line may always pass through the same point of the body: then the body is held there, as
a ladder at its foot. Or it may have a constant distance from the mass centre while the body turns: then the body is a
wheel of that radius. Otherwise the shape is unknown, and the body is drawn as an ellipse.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, plus, solved
from lagrange.pictures.limits import SAME_ON_PAGE, SAME_SHAPE
from lagrange.pictures.poses import Pose


@record
class Shape:
    """The known features of a plane body.

    held    points at which it is held, along its axes e1, e2 from the mass centre
    radius  of a wheel; 0 for any other body
    at      by reaction: the point of the body on which it acts, if there is one
    """

    held: tuple[tuple[float, float], ...]
    radius: float
    at: dict[str, tuple[float, float]]

    def together_with(self, reaction: str) -> list[str]:
        """The reactions that act on the same point of the body as one of them, itself included."""
        here = self.at.get(reaction)
        return [] if here is None else [r for r, at in self.at.items() if math.dist(at, here) < SAME_ON_PAGE]


@record
class LineOfAction:
    """The line of action of a force on a body: its direction and its point nearest to the mass centre."""

    direction: FloatVector
    nearest: FloatVector


def line_of_action(force: FloatVector, moment: FloatVector) -> LineOfAction | None:
    """The line along which a force alone is equivalent to force and moment; None if there is no force."""
    size = inner(force, force)
    if size < 1e-12:
        return None
    r = outer(force, moment)
    return LineOfAction(force, (r[0] / size, r[1] / size, r[2] / size))


def force_and_moment(pose: Pose, reaction: Reaction, body: str) -> tuple[FloatVector, FloatVector]:
    """The force and moment on a body for one unit of the multiplier. Raises NoValueError."""
    force, moment = reaction.per_unit(body), reaction.moment_per_unit(body)
    zero = Vector.zero()
    return pose.at(force or zero), pose.at(moment or zero)


def push_sense(reaction: Reaction) -> int:
    """1 if a force of 1 pushes to the side that a one-sided constraint permits, else −1; 0 if both are permitted.

    A reaction with a name of its own is positive in contact; a multiplier goes with the gradient of left minus right.
    """
    side = reaction.constraint.side
    return 0 if side is None else 1 if reaction.given is not None else side


def shape(pose: Pose, rotation: Rotation, reactions: Sequence[Reaction]) -> Shape:
    """The shape of a body as revealed by the reactions on it."""
    held, at, radius = [], {}, 0.0
    for reaction in reactions:
        try:
            lines = [*_lines((pose, *pose.others), rotation, reaction)]
            if len(lines) < 3:
                continue
            point = common_point([*lines, *_turned(pose, rotation, reaction)] if not turns(lines) else lines)
        except NoValueError:
            continue
        if point is not None:
            at[reaction.name] = point
            held.append(point)
        elif turns(lines):
            distances = [math.hypot(*p) for _, p in lines]
            if min(distances) > 0.05 and max(distances) - min(distances) < SAME_SHAPE:
                radius = max(radius, distances[0])
    return Shape(tuple(held), radius, at)


def _turned(
    pose: Pose, rotation: Rotation, reaction: Reaction
) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """The lines of action with the body turned off its constraints, where these do not let it turn: a beam at rest.

    A constraint on one point of the body has its gradient there in every position.
    """
    angles = rotation.axes[0].fixed().as_sum().free_symbols & {*pose.coordinates}
    return [*_lines([pose.moved(q, by) for q in angles for by in (0.4, -0.3, 0.7)], rotation, reaction)]


def _lines(
    poses: Sequence[Pose], rotation: Rotation, reaction: Reaction
) -> Iterator[tuple[tuple[float, float], tuple[float, float]]]:
    """Direction and nearest point of the line of action in several positions, along e1 and e2."""
    for p in poses:
        line = line_of_action(*force_and_moment(p, reaction, rotation.name))
        if line is None:
            return
        e1, e2 = p.at(rotation.axes[0]), p.at(rotation.axes[1])
        direction = inner(line.direction, e1), inner(line.direction, e2)
        if (
            math.hypot(*direction) < SAME_SHAPE
        ):  # perpendicular to the plane of the body, as the support of a sliding disc
            return
        yield direction, (inner(line.nearest, e1), inner(line.nearest, e2))


def common_point(
    lines: Sequence[tuple[tuple[float, float], tuple[float, float]]],
) -> tuple[float, float] | None:
    """The point through which all lines pass."""
    rows = []
    for (dx, dy), (px, py) in lines:
        size = math.hypot(dx, dy)
        rows.append((-dy / size, dx / size, (-dy * px + dx * py) / size))
    first = rows[0]
    second = max(rows[1:], key=lambda r: abs(first[0] * r[1] - first[1] * r[0]))
    if abs(first[0] * second[1] - first[1] * second[0]) < 0.02:
        same = all(math.dist(lines[0][1], p) < SAME_SHAPE for _, p in lines)
        return lines[0][1] if same and not turns(lines) else None
    x, y = solved([first[:2], second[:2]], [first[2], second[2]])
    if all(abs(a * x + b * y - c) < SAME_SHAPE for a, b, c in rows):
        return x, y
    return None


def turns(lines: Sequence[tuple[tuple[float, float], tuple[float, float]]]) -> bool:
    """Whether the direction of a line of action changes in the body."""
    (x, y), _ = lines[0]
    return any(abs(x * b - y * a) > 0.02 * math.hypot(x, y) * math.hypot(a, b) for (a, b), _ in lines)


def has_one_direction(pose: Pose, reaction: Reaction, body: str) -> bool:
    """Whether the force of a reaction on a body has the same direction in all positions."""
    try:
        forces = [force_and_moment(p, reaction, body)[0] for p in (pose, *pose.others)]
    except NoValueError:
        return False
    return len(forces) > 2 and all(math.hypot(*outer(forces[0], f)) < SAME_SHAPE for f in forces)


def reaction_point(pose: Pose, rotation: Rotation, reaction: Reaction, known: Shape) -> FloatVector | None:
    """The point from the mass centre at which a reaction is drawn; None if it is only a moment."""
    line = line_of_action(*force_and_moment(pose, reaction, rotation.name))
    if line is None:
        return None
    if reaction.name in known.at:
        return in_space(pose, rotation, known.at[reaction.name])
    return line.nearest


def in_space(pose: Pose, rotation: Rotation, point: tuple[float, float]) -> FloatVector:
    """A point of the body from its mass centre, in i, j, k."""
    x, y = point
    return plus(plus((0.0, 0.0, 0.0), pose.at(rotation.axes[0]), x), pose.at(rotation.axes[1]), y)


def coordinates_in_body(pose: Pose, rotation: Rotation, centre: Vector, point: FloatVector) -> tuple[float, float]:
    """A point of space along the axes of the body, from its mass centre."""
    way = minus(point, pose.at(centre))
    return inner(way, pose.at(rotation.axes[0])), inner(way, pose.at(rotation.axes[1]))


def plane_rotation(configuration: Configuration, name: str) -> Rotation | None:
    """The rotation of a body that turns about its third axis, if that axis is fixed; otherwise None."""
    rotation = next((r for r in configuration.rotations if r.name == name), None)
    if rotation is None or rotation.given:
        return None
    third = rotation.axes[2].fixed()
    return rotation if all(c.is_number for c in third.components) else None
