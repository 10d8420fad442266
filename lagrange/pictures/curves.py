"""The curve on which a constraint keeps a particle of a plane problem, traced from where it is.

In the two coordinates of the particle the curve f = 0 has the direction (−∂f/∂b, ∂f/∂a). Small steps along it, each
brought back onto the curve by Newton's iteration, go on until the edge of the picture, or until the curve closes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.document.scene import Box, Point
from lagrange.mechanics.constraints.kinematics import Row
from lagrange.pictures.floats import NoValueError, Space, projected, value
from lagrange.pictures.poses import Pose

STEP = 0.07
_MOST_STEPS = 900


def constraint_curve(
    pose: Pose, row: Row, position: Vector, on_page: Callable[[Space], Point], frame: Box
) -> tuple[list[Point], bool] | None:
    """The curve on the page and whether it is closed; None where it is not one of one particle in a plane."""
    if row.finite is None:
        return None
    moving = set(pose.coordinates)
    f = sp.sympify(row.finite, strict=True)
    own = [q for q in pose.coordinates if q in set().union(*(c.free_symbols for c in position.fixed().components))]
    if len(own) != 2 or not (f.free_symbols & moving) <= set(own):
        return None
    slopes = [f.diff(q) for q in own]
    try:
        forward, closed = _traced(pose, f, slopes, own, position, on_page, frame, 1)
        if closed:
            return forward, True
        backward, _ = _traced(pose, f, slopes, own, position, on_page, frame, -1)
    except NoValueError:
        return None
    return [*reversed(backward[1:]), *forward], False


def _traced(
    pose: Pose,
    f: sp.Expr,
    slopes: Sequence[sp.Expr],
    own: Sequence[sp.Symbol],
    position: Vector,
    on_page: Callable[[Space], Point],
    frame: Box,
    sense: int,
) -> tuple[list[Point], bool]:
    """The points of one half of the curve, the first being where the particle is."""
    fixed = position.fixed()
    partials = [fixed.map(lambda c, q=q: c.diff(q)) for q in own]  # type: ignore[misc]
    here = pose
    found = [on_page(pose.at(fixed))]
    origin = on_page((0.0, 0.0, 0.0))
    for number in range(_MOST_STEPS):
        a, b = (value(e, here.values) for e in slopes)
        way = (-b * sense, a * sense)
        moved = [on_page(here.at(p)) for p in partials]
        speed = math.hypot(*(sum(w * (m[n] - origin[n]) for w, m in zip(way, moved, strict=True)) for n in (0, 1)))
        if speed < 1e-9:
            raise NoValueError("the curve has no direction")
        start = dict(here.values) | {q: here.values[q] + STEP / speed * w for q, w in zip(own, way, strict=True)}
        here = Pose(pose.configuration, projected([f], [slopes], own, start))
        found.append(on_page(here.at(fixed)))
        x, y = found[-1]
        if not (frame.left <= x <= frame.right and frame.bottom <= y <= frame.top):
            return found[:-1], False
        if number > 5 and math.hypot(x - found[0][0], y - found[0][1]) < STEP * 0.9:
            return found, True
    raise NoValueError("the curve does not end")
