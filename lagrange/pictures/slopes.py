"""The angle of an incline, drawn at the foot of the plane where the file does not draw it.

A plane comes from a constraint, from the line on which a block moves, or from the turned direction of gravity: in none
of these is there an angle. A parameter whose value is the angle between a straight piece of ground and the horizontal,
and which the positions or the weight contain, is that angle.
"""

from __future__ import annotations

import math

import sympy as sp

from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.pictures.floats import NoValueError
from lagrange.pictures.limits import LEAST_SLOPE, SAME_SHAPE, SLOPE_ARC, STEEPEST_SLOPE
from lagrange.pictures.sketch import Sketch, apart, beyond, toward
from lagrange.pictures.systems import SystemPicture


def mark_slopes(system: SystemPicture, sketch: Sketch, down: PagePoint) -> None:
    """Draw the angle of each slope once: a dashed horizontal through the foot of the plane, an arc, the letter."""
    field = system.problem.gravity
    if field is None or not system.view.planar or len(system.view.shown) < 2:
        return
    drawn = {mark.label for mark in system.problem.figure.marks}
    placed = [c for p in system.configuration.points for c in p.position.fixed().components]
    used = {s for c in (*field.fixed().components, *placed) for s in c.free_symbols}
    angles = [p.symbol for p in system.problem.parameters if p.symbol in used and p.symbol not in drawn]
    grounds = [line for line in sketch.lines if line.kind is StrokeKind.GROUND and len(line.points) == 2]
    for line in grounds:
        low, high = sorted(line.points, key=lambda at: -(at[0] * down[0] + at[1] * down[1]))
        symbol = next((s for s in angles if _is_slope(system, s, low, high, down)), None)
        if symbol is not None:
            _mark(sketch, symbol, low, high, down)
            angles.remove(symbol)


def _slope(low: PagePoint, high: PagePoint, down: PagePoint) -> float:
    """The angle of a line with the horizontal."""
    way = toward(low, high)
    return math.asin(max(-1.0, min(1.0, -(way[0] * down[0] + way[1] * down[1]))))


def _is_slope(system: SystemPicture, symbol: sp.Symbol, low: PagePoint, high: PagePoint, down: PagePoint) -> bool:
    try:
        size = system.pose.number(symbol)
    except NoValueError:
        return False
    slope = _slope(low, high, down)
    return LEAST_SLOPE < slope < STEEPEST_SLOPE and abs(slope - size) < SAME_SHAPE and apart(low, high) > 2 * SLOPE_ARC


def _mark(sketch: Sketch, symbol: sp.Symbol, low: PagePoint, high: PagePoint, down: PagePoint) -> None:
    up_slope = toward(low, high)
    level = (-down[1], down[0])
    if level[0] * up_slope[0] + level[1] * up_slope[1] < 0:
        level = (-level[0], -level[1])
    slope = _slope(low, high, down)
    ways = [(level[0] * math.cos(a) - down[0] * math.sin(a), level[1] * math.cos(a) - down[1] * math.sin(a))
            for a in (slope * k / 12 for k in range(13))]  # fmt: skip
    sketch.line([low, beyond(low, level, SLOPE_ARC + 0.35)], StrokeKind.REFERENCE)
    arc = [beyond(low, way, SLOPE_ARC) for way in ways]
    sketch.arc(arc, StrokeKind.ANGLE)
    sketch.label(symbol, arc[6], toward(low, arc[6]), optional=True)
