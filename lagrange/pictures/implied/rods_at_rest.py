"""A rod at rest that its file gives by its centre and by lettered points, and what it lies on.

In problems of equilibrium a uniform rod is the particle at its centre, on which its weight acts; a lettered vector A
of the file that keeps its distance from there while it turns about it is an end. Nothing else says where the rod lies:
but its ends, taken through several positions, move along a wall or plane or on the circle of a bowl, or stay at a
hinge, and where all these positions of its line meet in one point there is a peg or the rim of a bowl. Of each of
these the words have to speak.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from enum import Enum, auto

from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, plus, solved, unit
from lagrange.pictures.limits import SAME_PLACE
from lagrange.pictures.poses import Pose
from lagrange.pictures.sketch import Sketch, beyond, left_of, toward
from lagrange.problem.model import Problem

_ROD = re.compile(r"\b(rod|beam|bar|ladder|pole|stick|needle|plank|spoon)s?\b", re.IGNORECASE)
_UNIFORM = re.compile(r"\buniform|\bhomogeneous", re.IGNORECASE)
_LETTER = re.compile(r"[A-Z]\d?")
_PEG = re.compile(r"\b(peg|pin|nail|rim|edge|corner|step|kerb|rail)s?\b", re.IGNORECASE)
_STEP = re.compile(r"\b(edge|step|kerb|corner)s?\b", re.IGNORECASE)
_PLANE = re.compile(r"\b(wall|floor|ground|plane|trough|incline|table|groove)s?\b", re.IGNORECASE)
_ROUND = re.compile(r"\bbowl|hemispher|\bcup\b|spher|\bcylind|\bcircular|\bhoop|\bring\b", re.IGNORECASE)
_OPEN = re.compile(r"\bbowl|hemispher|\bcup\b", re.IGNORECASE)
_HINGE = re.compile(r"\b(hinge|pin|pivot)\w*|\bturns about\b", re.IGNORECASE)
INSIDE = (0.06, 0.97)
"""Where a peg may be on a rod, in parts of its length."""
HALF = 0.07
"""Half the thickness of a rod, in centimetres."""
PEG = 0.09
"""Radius of a peg, in centimetres."""
_BEYOND = 0.9
"""How far a wall goes on beyond the end of a rod, in centimetres."""


class Kind(Enum):
    """What a rod lies on."""

    PEG = auto()
    PLANE = auto()
    ROUND = auto()
    HINGE = auto()


@record
class Contact:
    """A place at which a rod is held.

    way     of a plane: along it; of a peg: along the rod
    inward  from a plane or peg to the rod
    centre  of what is round
    """

    kind: Kind
    at: FloatVector
    way: FloatVector = (0.0, 0.0, 0.0)
    inward: FloatVector = (0.0, 0.0, 0.0)
    centre: FloatVector = (0.0, 0.0, 0.0)


@record
class RodAtRest:
    """A rod: its middle, its ends, and their letters in the file ("" for one that has none)."""

    middle: Vector
    ends: tuple[Vector, Vector]
    letters: tuple[str, str]


def rods_at_rest(problem: Problem, pose: Pose) -> tuple[RodAtRest, ...]:
    """The rods whose ends are lettered points of the file."""
    configuration, text = pose.configuration, f"{problem.title} {problem.description}"
    points = [p for p in configuration.points if p.mass == 0]
    if configuration.rotations or len(points) < len(configuration.points) or not _ROD.search(text):
        return ()
    lettered = {
        n: v.fixed() for n, v in problem.abbreviations.items() if isinstance(v, Vector) and _LETTER.fullmatch(n)
    }
    if any(c != 0 for v in (*lettered.values(), *(p.position.fixed() for p in points)) for c in v.components[2:]):
        return ()
    uniform = bool(_UNIFORM.search(text))
    found = (_rod(p.position.fixed(), lettered, pose, uniform) for p in points)
    return tuple(rod for rod in found if rod is not None)


def _rod(middle: Vector, lettered: dict[str, Vector], pose: Pose, is_uniform: bool) -> RodAtRest | None:
    poses = (pose, *pose.others)
    try:
        ways = {n: [minus(x.at(v), x.at(middle)) for x in poses] for n, v in lettered.items()}
    except NoValueError:
        return None
    is_joint = any(max(math.hypot(*x) for x in w) < SAME_PLACE for w in ways.values())
    ends = [n for n, w in ways.items() if len(w) > 2 and _turns(w)]
    for n in ends:
        opposite = next((m for m in ends if all(math.hypot(*plus(a, b)) < SAME_PLACE for a, b in
                                                zip(ways[n], ways[m], strict=True))), "")  # fmt: skip
        if opposite or (len(ends) == 1 and is_uniform and not is_joint):
            end = lettered[opposite] if opposite else middle * 2 - lettered[n]
            return RodAtRest(middle, (lettered[n], end), (n, opposite))
    return None


def _turns(ways: Sequence[FloatVector]) -> bool:
    sizes = [math.hypot(*w) for w in ways]
    return max(sizes) - min(sizes) < SAME_PLACE < 1e-3 < min(sizes) and any(math.dist(ways[0], w) > 1e-3 for w in ways)


def contacts(problem: Problem, pose: Pose, rods: Sequence[RodAtRest]) -> list[Contact]:
    """What the rods lie on, in a position. Raises NoValueError."""
    poses, text = (pose, *pose.others), f"{problem.title} {problem.description}"
    found: list[Contact] = []
    places = [[x.at(end) for x in poses] for rod in rods for end in rod.ends]
    for rod in rods:
        middle = pose.at(rod.middle)
        for end in rod.ends:
            path = [x.at(end) for x in poses]
            if sum(math.dist(path[0], other[0]) < SAME_PLACE for other in places) > 1:
                continue  # a joint of two rods
            contact = _at_end(path, middle, text)
            found += [contact] if contact is not None else []
        found += _pegs([(x.at(rod.ends[0]), x.at(rod.ends[1])) for x in poses], found) if _PEG.search(text) else []
    return found


def _at_end(path: Sequence[FloatVector], middle: FloatVector, text: str) -> Contact | None:
    at = path[0]
    ways = [minus(p, at) for p in path[1:]]
    way = max(ways, key=lambda w: math.hypot(*w))
    if math.hypot(*way) < SAME_PLACE:
        return Contact(Kind.HINGE, at) if _HINGE.search(text) else None
    if all(math.hypot(*outer(way, w)) < SAME_PLACE for w in ways):
        along = unit(way)
        normal = (-along[1], along[0], 0.0)
        inward = normal if inner(minus(middle, at), normal) > 0 else minus((0.0, 0.0, 0.0), normal)
        return Contact(Kind.PLANE, at, along, inward) if _PLANE.search(text) else None
    if not _ROUND.search(text) or len(path) < 4:
        return None
    rows = [(2 * w[0], 2 * w[1]) for w in ways]
    sums = [inner(p, p) - inner(at, at) for p in path[1:]]
    first = max(range(1, len(rows)), key=lambda n: abs(rows[0][0] * rows[n][1] - rows[0][1] * rows[n][0]))
    x, y = solved([rows[0], rows[first]], [sums[0], sums[first]])
    sizes = [math.dist((x, y, 0.0), p) for p in path]
    return Contact(Kind.ROUND, at, centre=(x, y, 0.0)) if max(sizes) - min(sizes) < SAME_PLACE else None


def _pegs(lines: Sequence[tuple[FloatVector, FloatVector]], known: Sequence[Contact]) -> Iterator[Contact]:
    """The point through which all lines pass, inside the first piece; the rim of a bowl is none."""
    rows, sums = [], []
    for a, b in lines:
        way = unit(minus(b, a))
        rows.append((-way[1], way[0]))
        sums.append(-way[1] * a[0] + way[0] * a[1])
    first = max(range(1, len(rows)), key=lambda n: abs(rows[0][0] * rows[n][1] - rows[0][1] * rows[n][0]))
    if abs(rows[0][0] * rows[first][1] - rows[0][1] * rows[first][0]) < 1e-3:
        return
    x, y = solved([rows[0], rows[first]], [sums[0], sums[first]])
    if any(abs(r[0] * x + r[1] * y - s) > SAME_PLACE for r, s in zip(rows, sums, strict=True)):
        return
    at, way = (x, y, 0.0), unit(minus(lines[0][1], lines[0][0]))
    on_rim = any(
        c.kind is Kind.ROUND and abs(math.dist(c.centre, at) - math.dist(c.centre, c.at)) < SAME_PLACE for c in known
    )
    if not on_rim:
        up = (-way[1], way[0], 0.0) if way[0] > 0 else (way[1], -way[0], 0.0)
        yield Contact(Kind.PEG, at, way, up)


def is_possible(problem: Problem, pose: Pose) -> bool:
    """Whether all pegs and rims touch their rods, and no rod passes through the plane that carries it."""
    rods = rods_at_rest(problem, pose)
    try:
        held = contacts(problem, pose, rods) if rods else []
        for rod in rods:
            first, second = (pose.at(end) for end in rod.ends)
            length, way = math.dist(first, second), unit(minus(second, first))
            on = [inner(minus(c.at, first), way) / length for c in held if c.kind is Kind.PEG]
            on += [
                inner(minus(rim, first), way) / length
                for c in held
                if c.kind is Kind.ROUND and _OPEN.search(problem.title + problem.description)
                for rim in _rim(c)
                if math.hypot(*outer(minus(rim, first), way)) < SAME_PLACE
            ]
            if not all(INSIDE[0] < min(x, 1 - x) or INSIDE[0] < x < INSIDE[1] for x in on):
                return False
    except NoValueError:
        return False
    level = problem.gravity is None or problem.gravity.components[1] != 0
    return not level or all(c.inward[1] > -SAME_PLACE for c in held if c.kind is Kind.PLANE)


def _rim(contact: Contact) -> list[FloatVector]:
    radius = math.dist(contact.centre, contact.at)
    return [plus(contact.centre, (sign, 0.0, 0.0), radius) for sign in (1.0, -1.0)]


def with_letters(problem: Problem, pose: Pose) -> tuple[Problem, tuple[RodAtRest, ...]]:
    """The rods, and the problem with their lettered ends as points of its figure."""
    figure = problem.figure
    if figure.points or figure.lines or figure.circles or figure.curves:
        return problem, ()
    rods = rods_at_rest(problem, pose)
    points = {n: v for rod in rods for n, v in zip(rod.letters, rod.ends, strict=True) if n}
    return (replace(problem, figure=replace(figure, points=points)), rods) if rods else (problem, ())


def draw_rods(
    problem: Problem,
    pose: Pose,
    rods: Sequence[RodAtRest],
    page: Callable[[FloatVector], PagePoint],
    sketch: Sketch,
    busy: list[tuple[PagePoint, PagePoint]],
) -> list[PagePoint]:
    """Draw the rods and what they lie on; return the hinges that something has to hold. Raises NoValueError."""
    mounts = []
    text = f"{problem.title} {problem.description}"
    for rod in rods:
        a, b = (page(pose.at(end)) for end in rod.ends)
        sketch.capsule(a, b, HALF)
        busy.append((a, b))
    held = contacts(problem, pose, rods)
    planes = [c for c in held if c.kind is Kind.PLANE]
    for contact in held:
        at, inward = page(contact.at), toward(page((0.0, 0.0, 0.0)), page(contact.inward))
        match contact.kind:
            case Kind.HINGE:
                sketch.hinge(at)
                mounts.append(at)
            case Kind.PEG:
                if _STEP.search(text):
                    floor = max((_height_above(c, contact) for c in planes), default=0.0)
                    out = math.copysign(1.0, inward[0])
                    low = page(plus(contact.at, (0.0, -1.0, 0.0), floor)) if floor else beyond(at, (0.0, -1.0), 1.2)
                    step = [low, at, beyond(at, (-out, 0.0), 1.4)]
                    sketch.ground(step if out < 0 else step[::-1])
                else:
                    sketch.circle(beyond(at, inward, -PEG - HALF), PEG, 3)
            case Kind.PLANE:
                side, foot, middle = left_of(inward), at, page(pose.at(rods[0].middle))
                far = inner((middle[0] - at[0], middle[1] - at[1]), side)
                near, end = min(0.0, far) - _BEYOND, max(0.0, far) + _BEYOND
                corner = [c for c in (_crossing(foot, side, page, other) for other in planes) if c is not None]
                if len(planes) == len(corner) + 1 == 2:
                    near, end = (corner[0], _BEYOND) if corner[0] < 0 else (-_BEYOND, corner[0])
                sketch.ground([beyond(foot, side, end), beyond(foot, side, near)])
            case Kind.ROUND:
                centre = page(contact.centre)
                radius, half = math.dist(centre, at), math.pi / 2 if _OPEN.search(text) else math.pi
                turns = (half * n / 48 for n in range(-48, 49))
                arc = [beyond(beyond(centre, (0.0, -1.0), radius * math.cos(a)), (1.0, 0.0), radius * math.sin(a))
                       for a in turns]  # fmt: skip
                sketch.ground(arc[::-1]) if half < math.pi else sketch.line(arc, StrokeKind.CURVE)
    return mounts


def _height_above(plane: Contact, other: Contact) -> float:
    """How high a place is above a level plane; 0 above any other."""
    return inner(minus(other.at, plane.at), plane.inward) if plane.inward[1] > 1 - SAME_PLACE else 0.0


def _crossing(
    foot: PagePoint, side: PagePoint, page: Callable[[FloatVector], PagePoint], other: Contact
) -> float | None:
    """How far along a plane another one crosses it; None if they are parallel."""
    inward = toward(page((0.0, 0.0, 0.0)), page(other.inward))
    there = page(other.at)
    turned = inner(side, inward)
    if abs(turned) < SAME_PLACE:
        return None
    return inner((there[0] - foot[0], there[1] - foot[1]), inward) / turned


def around(problem: Problem, pose: Pose, rods: Sequence[RodAtRest]) -> list[FloatVector]:
    """Places that a picture of the rods needs. Raises NoValueError."""
    places = [pose.at(end) for rod in rods for end in rod.ends]
    for contact in contacts(problem, pose, rods) if rods else ():
        if contact.kind is Kind.ROUND:
            radius = math.dist(contact.centre, contact.at)
            places += [*_rim(contact), plus(contact.centre, (0.0, -1.0, 0.0), radius)]
    return places
