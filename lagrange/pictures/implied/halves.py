"""Half discs, half cylinders and hemispheres, from where their mass centre is.

The mass centre of a half is at a distance d from the centre of its circle that is a known part of the radius:
4/(3π) of a half disc or cylinder, 3/8 of a hemisphere, 2/π of half a ring, 1/2 of half a shell. When the half turns by
its angle φ, a mass centre at c + d (sin φ, −cos φ) turns about c.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress

from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.pictures.floats import FloatVector, NoValueError, inner, minus, outer, unit
from lagrange.pictures.joints import turning_point
from lagrange.pictures.limits import SAME_PLACE
from lagrange.pictures.shapes import plane_rotation
from lagrange.pictures.systems import SystemPicture

HALF = re.compile(r"hemispher|semi-?circ|half[- ](a )?(cylinder|disc|disk|sphere|ball|ring|hoop|shell)", re.IGNORECASE)
_PARTS = (4 / (3 * math.pi), 3 / 8, 2 / math.pi, 1 / 2)


def half_disc(system: SystemPicture, p: MassPoint) -> tuple[list[FloatVector], float] | None:
    """The centre of the circle of a half body in several positions, and its radius, a parameter of the file."""
    rotation = plane_rotation(system.configuration, p.name)
    if rotation is None or not HALF.search(system.text):
        return None
    poses = (system.pose, *system.pose.others)
    for q in rotation.axes[0].fixed().as_sum().free_symbols & {*system.pose.coordinates}:
        with suppress(NoValueError):
            centre = turning_point(p.position, q)
            away = [minus(x.at(p.position), x.at(centre)) for x in poses]
            size = math.hypot(*away[0])
            axes = [[x.at(a) for a in rotation.axes[:2]] for x in poses]
            carried = [[inner(w, a) for a in pair] for w, pair in zip(away, axes, strict=True)]
            if size < SAME_PLACE or any(math.dist(carried[0], other) > SAME_PLACE for other in carried):
                continue
            lengths = [system.pose.values.get(s.symbol, 0.0) for s in system.problem.parameters]
            fitting = [x for x in lengths if any(abs(part * x - size) < SAME_PLACE for part in _PARTS)]
            if fitting:
                return [x.at(centre) for x in poses], fitting[0]
    return None


def halves(system: SystemPicture) -> Iterator[tuple[FloatVector, float]]:
    """Centres and radii of the circles of half bodies in the position drawn."""
    for p in system.configuration.points if system.is_bare and system.view.planar else ():
        found = half_disc(system, p)
        if found is not None:
            yield found[0][0], found[1]


def level_of(centres: Sequence[FloatVector]) -> FloatVector | None:
    """The direction in which the centre of what rolls moves, if that is one; None if it moves otherwise, or not."""
    ways = [minus(c, centres[0]) for c in centres[1:]]
    far = max(ways, key=lambda w: math.hypot(*w), default=(0.0, 0.0, 0.0))
    if math.hypot(*far) < SAME_PLACE or any(math.hypot(*outer(far, w)) > SAME_PLACE for w in ways):
        return None
    return unit(far)
