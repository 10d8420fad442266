"""What guides a system of which the coordinates alone keep it: hoops, surfaces, fixed cylinders, links between bodies.

A file that counts angles on a hoop, or distances on a cone, has no constraint from which to draw either. The words say
that there is one; where it is follows from the positions that the coordinates allow. Nothing is drawn of which the
text does not speak.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, solved
from lagrange.pictures.joints import holds, turning_point
from lagrange.pictures.limits import BEYOND_PARTICLE, PIECES_OF_PROFILE, PIECES_OF_TURN, SAME_ON_PAGE, SAME_PLACE
from lagrange.pictures.poses import Pose
from lagrange.pictures.shapes import plane_rotation
from lagrange.pictures.systems import ROD, ROPE, SystemPicture
from lagrange.problem.keys import Keeper, Outline

_HOOP = re.compile(r"\b(hoops?|ring|circular wire|circular track|circle)\b", re.IGNORECASE)
_SURFACE = re.compile(
    r"\b(cone|conical|bowl|surface|cylinder|cylindrical|paraboloid|sphere|spherical|dome|funnel|torus|hemisphere)\b",
    re.IGNORECASE,
)
_ROUND = re.compile(r"\b(cylinder|drum|circle|circular|sphere|log|barrel|roller|pipe|peg)s?\b", re.IGNORECASE)


def hoops(system: SystemPicture) -> list[tuple[FloatVector, float]]:
    """Centres and radii of fixed circles on which several particles move that rods alone would not keep there."""
    if not (system.is_bare and system.view.planar and _HOOP.search(system.text)) or system.configuration.rows:
        return []
    found: dict[tuple[float, ...], list[float]] = {}
    for p in system.configuration.points:
        if plane_rotation(system.configuration, p.name) is not None:
            continue
        for q in system.pose.coordinates:
            with suppress(NoValueError):
                middle = turning_point(p.position, q)
                poses = (system.pose, *system.pose.others)
                circles = [(x.at(middle), math.dist(x.at(middle), x.at(p.position))) for x in poses]
                centre, radius = circles[0]
                same = all(math.dist(c, centre) + abs(r - radius) < SAME_PLACE for c, r in circles)
                if radius > SAME_ON_PAGE and same and len(circles) > 2:
                    found.setdefault(tuple(round(c, 6) for c in (*centre, radius)), []).append(radius)
    return [((x, y, z), radius) for (x, y, z, radius), on in found.items() if len(on) > 1]


def surface_of_coordinates(system: SystemPicture, p: MassPoint) -> list[list[FloatVector]]:
    """The places that the two coordinates of a particle in space reach on the surface of which the text speaks.

    One of them is an angle that comes back after a turn. Empty if there is no such surface. Raises NoValueError.
    """
    components = p.position.fixed().components
    own = [q for q in system.pose.coordinates if any(c.has(q) for c in components)]
    if len(own) != 2 or system.configuration.rows or not _SURFACE.search(system.text):
        return []
    if ROD.search(system.text) or ROPE.search(system.text):
        return []
    turning = [q for q in own if _comes_back(system.pose, q, p.position)]
    if len(turning) != 1:
        return []
    [angle] = turning
    [distance] = [q for q in own if q != angle]
    here = system.pose.values[distance]
    sizes = (here * BEYOND_PARTICLE * n / PIECES_OF_PROFILE for n in range(PIECES_OF_PROFILE + 1))
    rows = [replace(system.pose, values={**system.pose.values, distance: size}) for size in sizes]
    turns = [2 * math.pi * k / PIECES_OF_TURN for k in range(PIECES_OF_TURN + 1)]
    return [[x.moved(angle, turn).at(p.position) for turn in turns] for x in rows]


def _comes_back(pose: Pose, q: sp.Symbol, place: Vector) -> bool:
    turned = [pose.moved(q, a).at(place) for a in (0.0, 2 * math.pi, math.pi)]
    return math.dist(turned[0], turned[1]) < SAME_PLACE < math.dist(turned[0], turned[2])


def cylinders_touched(system: SystemPicture) -> Iterator[tuple[FloatVector, float]]:
    """Centre and radius of the fixed circle to which a rod is a tangent in every position: n·(p − c) = R for all."""
    if not (system.is_bare and system.view.planar and _ROUND.search(system.text)):
        return
    for p in system.configuration.points:
        rotation, shape = plane_rotation(system.configuration, p.name), system.problem.figure.shapes.get(p.name)
        if rotation is None or shape is None or shape.kind is not Outline.ROD:
            continue
        with suppress(NoValueError):
            tangents = []
            for x in (system.pose, *system.pose.others):
                first, second = (x.at(end) for end in shape.ends)
                way = minus(second, first)
                size = math.hypot(*way)
                normal = (-way[1] / size, way[0] / size, 0.0)
                tangents.append((normal, inner(normal, first)))
            rows = [(n[0], n[1], 1.0) for n, _ in tangents]
            x0, y0, radius = solved(rows[:3], [c for _, c in tangents[:3]])
            fits = all(abs(n[0] * x0 + n[1] * y0 + radius - c) < SAME_ON_PAGE for n, c in tangents)
            if len(tangents) > 3 and fits and abs(radius) > 0.05:
                yield (x0, y0, 0.0), abs(radius)


def couplers(system: SystemPicture) -> Iterator[tuple[FloatVector, FloatVector]]:
    """The rods from the end of one rod to a particle that the coordinates keep at a constant distance from it."""
    if not (system.is_bare and system.view.planar and ROD.search(system.text)):
        return
    turning = [p for p in system.configuration.points if plane_rotation(system.configuration, p.name) is not None]
    free = [p for p in system.configuration.points if p not in turning]
    poses = (system.pose, *system.pose.others)
    for body in turning:
        shape = system.problem.figure.shapes.get(body.name)
        for end in shape.ends if shape is not None else ():
            for p in free:
                with suppress(NoValueError):
                    ways = [minus(x.at(p.position), x.at(end)) for x in poses]
                    sizes = [math.hypot(*w) for w in ways]
                    constant = len(sizes) > 3 and max(sizes) - min(sizes) < SAME_PLACE and sizes[0] > 1e-3
                    turns = any(math.dist(ways[0], w) > 1e-3 for w in ways)
                    if constant and turns and not holds(system.pose, body, lambda x, p=p: x.at(p.position)):  # type: ignore[misc]
                        yield system.pose.at(end), system.pose.at(p.position)


def struts(system: SystemPicture) -> Iterator[tuple[FloatVector, FloatVector, bool]]:
    """Two particles whose distance a rod or string keeps, by a constraint in other words; whether it is a string.

    Off the constraint, its left side less its right side changes as the distance does, or as the square of that.
    """
    points = system.configuration.points
    for reaction in system.newton.reactions:
        by, finite = reaction.constraint.by, reaction.row.finite
        if reaction.rod is not None or by not in (Keeper.ROD, Keeper.STRING) or finite is None:
            continue
        for n, b in enumerate(points):
            for a in points[:n]:
                with suppress(NoValueError):
                    poses = [
                        system.pose,
                        *(system.pose.moved(q, s) for q in system.pose.coordinates for s in (0.2, -0.1)),
                    ]
                    kept = [x.number(sp.sympify(finite, strict=True)) for x in poses]
                    apart = [math.dist(x.at(a.position), x.at(b.position)) for x in poses]
                    changes = max(apart) - min(apart) > 1e-3
                    if changes and any(_same_change(kept, [d**power for d in apart]) for power in (1, 2)):
                        yield system.pose.at(a.position), system.pose.at(b.position), by is Keeper.STRING


def ropes_to_supports(system: SystemPicture) -> Iterator[tuple[FloatVector, FloatVector]]:
    """From each fixed place to the ring on a rope of which a constraint has the parts: |r − a| + |r − b| ≤ L."""
    for reaction in system.newton.reactions if system.view.planar else ():
        finite, by = reaction.row.finite, reaction.constraint.by
        if finite is None or reaction.rod is not None or len({*reaction.acts_on}) != 1:
            continue
        if by is not Keeper.STRING and not ROPE.search(reaction.name):
            continue
        p = next(p for p in system.configuration.points if p.name in reaction.acts_on)
        own = p.position.fixed().components
        moving = [c for c in own if c in system.pose.coordinates]
        roots = [e.base for e in sp.sympify(finite, strict=True).atoms(sp.Pow) if e.exp == sp.S.Half]
        for base in roots if len(moving) == 2 else ():
            slopes = [sp.expand(base.diff(q)) for q in moving]  # 2 (q - a)
            if any(
                f != sp.expand(2 * q + f.subs(q, 0)) or f.subs(q, 0).has(*moving)
                for f, q in zip(slopes, moving, strict=True)
            ):
                continue
            ends = {q: -f.subs(q, 0) / 2 for f, q in zip(slopes, moving, strict=True)}
            with suppress(NoValueError):
                yield system.pose.at(p.position.fixed().map(lambda c, e=ends: c.subs(e))), system.pose.at(p.position)  # type: ignore[misc]


def _same_change(first: list[float], second: list[float]) -> bool:
    return all(abs((f - first[0]) - (s - second[0])) < SAME_PLACE for f, s in zip(first, second, strict=True))
