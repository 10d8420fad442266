"""Tubes and slots that turn about a fixed axis, and in which particles slide: with the axis, the disc, and the speed.

A bead at a u(ωt) + s v(ωt) slides along v in a slot at the distance a from O; with a = 0 the slot or tube goes through
the axis. When only s changes, the bead moves on a straight line, which at other times or angles is another one at the
same distance from O. The words say whether that is a slot in a disc or a tube.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, plus, unit
from lagrange.pictures.limits import SAME_ON_PAGE
from lagrange.pictures.linkages import parameter_of
from lagrange.pictures.poses import is_distance
from lagrange.pictures.sketch import Sketch, apart, beyond, left_of, toward
from lagrange.pictures.systems import SystemPicture

_SLOT = re.compile(r"\b(slot|groove|channel)s?\b", re.IGNORECASE)
_DISC = re.compile(r"\b(disc|disk|turntable|platform|plate|wheel)s?\b", re.IGNORECASE)
_TUBE = re.compile(r"\b(tube|pipe)s?\b", re.IGNORECASE)
HALF = 0.15
"""Half the width of a slot or tube, in centimetres: a bead fits in."""
_RIM = 1.3
"""Radius of a disc, in distances of what slides on it."""
_BEYOND = 0.5
"""How far a tube goes on beyond its bead, in centimetres."""


@record
class Guide:
    """The straight line on which one particle slides, and which turns about O.

    foot      the point of the line nearest to O
    along     its direction, to the particle
    place     of the particle
    speed     the constant angular velocity; None if the line turns otherwise
    """

    foot: FloatVector
    along: FloatVector
    place: FloatVector
    speed: sp.Expr | None


def turning_guides(system: SystemPicture) -> Iterator[Guide]:
    """The slots and tubes of a plane system."""
    if not (system.is_bare and system.view.planar and (_SLOT.search(system.text) or _TUBE.search(system.text))):
        return
    for p in system.configuration.points:
        with suppress(NoValueError):
            guide = _guide(system, p)
            if guide is not None:
                yield guide


def _guide(system: SystemPicture, p: MassPoint) -> Guide | None:
    pose = system.pose
    later = replace(pose, values={**pose.values, t: pose.values.get(t, 0.0) + 0.3})
    for q in pose.coordinates:
        if not is_distance(pose, q, p.position):
            continue
        lines = []
        for x in (pose, *pose.others, later):
            at, way = x.at(p.position), unit(minus(x.moved(q, 1.0).at(p.position), x.at(p.position)))
            lines.append((plus(at, way, -inner(at, way)), way))
        away = [math.hypot(*foot) for foot, _ in lines]
        turns = any(math.hypot(*outer(lines[0][1], way)) > 1e-3 for _, way in lines)
        if turns and max(away) - min(away) < SAME_ON_PAGE:
            foot, way = lines[0]
            place = pose.at(p.position)
            forward = 1.0 if inner(minus(place, foot), way) > 0 else -1.0
            along = (way[0] * forward, way[1] * forward, way[2] * forward)
            return Guide(foot, along, place, _speed(p, q))
    return None


def _speed(p: MassPoint, q: sp.Symbol) -> sp.Expr | None:
    """The rate at which the direction of a guide turns, if that is a constant: of u × u', with u = ∂r/∂q."""
    x, y, _ = p.position.fixed().partial(q).components
    rate = textbook_form(x * y.diff(t) - y * x.diff(t))
    return rate if rate != 0 and not rate.has(t) and rate.is_Symbol else None


def radius_of_disc(system: SystemPicture, guides: Sequence[Guide]) -> float:
    """How large a disc with slots is drawn; 0 where there is none."""
    if not (_SLOT.search(system.text) and _DISC.search(system.text)) or any(system.configuration.rotations):
        return 0.0
    return _RIM * max((math.hypot(*g.place) for g in guides), default=0.0)


def draw_guides(system: SystemPicture, sketch: Sketch, busy: list[tuple[PagePoint, PagePoint]]) -> list[PagePoint]:
    """Draw them; return the axes that something has to hold."""
    guides = [*turning_guides(system)]
    page, origin = system.page, system.page((0.0, 0.0, 0.0))
    rim = radius_of_disc(system, guides)
    if rim:
        sketch.circle(origin, rim * page.scale, 2)
    for guide in guides:
        foot, at = page(guide.foot), page(guide.place)
        way = toward((0.0, 0.0), page.way(guide.along))
        off = apart(origin, foot)
        if off > SAME_ON_PAGE:
            sketch.line([origin, foot], StrokeKind.REFERENCE if rim else StrokeKind.ROD)
            busy.append((origin, foot))
            length = parameter_of(system, math.hypot(*guide.foot))
            if length is not None:
                sketch.label_beside(length, origin, foot, optional=True)
        if rim:
            end = 0.93 * math.sqrt((rim * page.scale) ** 2 - off**2)
            start = -end if off > SAME_ON_PAGE else 3 * HALF
        else:
            start, end = -_BEYOND, apart(foot, at) + _BEYOND + 0.3
        first, last = beyond(foot, way, start), beyond(foot, way, end)
        side = left_of(way)
        corners = [beyond(beyond(foot, way, x), side, y * HALF) for x, y in
                   ((start, 1), (end, 1), (end, -1), (start, -1))]  # fmt: skip
        if rim:
            sketch.line(corners, StrokeKind.BODY, closed=True)
        else:
            sketch.face(corners, 1)
        busy.append((first, last))
        if guide.speed is not None:
            middle = sketch.turning(origin, 0.75, counterclockwise=True, kind=StrokeKind.AXIS, start=-2.6)
            sketch.label(guide.speed, middle, toward(origin, middle), optional=True)
    if guides:
        sketch.hinge(origin)
    return [origin] if guides and not rim and system.problem.gravity is not None else []
