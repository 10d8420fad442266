"""Springs and dampers in a picture: a zigzag, a piston in a cylinder, and what holds their fixed ends."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.springs_dampers import DamperForce, StretchedSpring
from lagrange.pictures.floats import NoValueError
from lagrange.pictures.implied.turning_guides import turning_guides
from lagrange.pictures.sketch import Sketch, apart, beyond, left_of, same_ends, toward
from lagrange.pictures.systems import SystemPicture, ends_of

COIL = 0.16
"""Length of one stroke of a spring, along it, in centimetres."""


def draw_spring(sketch: Sketch, a: PagePoint, b: PagePoint) -> None:
    """A zigzag between two straight ends, as steep in a long spring as in a short one."""
    way, length = toward(a, b), apart(a, b)
    side = left_of(way)
    lead = max(min(0.25, length / 5), 0.18 * length)
    turns = max(4, round((length - 2 * lead) / COIL))
    step = (length - 2 * lead) / turns
    points = [a, beyond(a, way, lead)]
    for n in range(turns):
        middle = beyond(a, way, lead + (n + 0.5) * step)
        points.append(beyond(middle, side, 0.12 if n % 2 else -0.12))
    sketch.line([*points, beyond(a, way, length - lead), b], StrokeKind.SPRING)


def draw_damper(sketch: Sketch, a: PagePoint, b: PagePoint) -> None:
    """A piston in a cylinder."""
    way, length = toward(a, b), apart(a, b)
    side = left_of(way)
    cup, piston, end = (beyond(a, way, length * part) for part in (0.42, 0.52, 0.62))
    sketch.line([a, cup], StrokeKind.DAMPER)
    sketch.line(
        [beyond(end, side, 0.14), beyond(cup, side, 0.14), beyond(cup, side, -0.14), beyond(end, side, -0.14)],
        StrokeKind.DAMPER,
    )
    sketch.line([beyond(piston, side, 0.09), beyond(piston, side, -0.09)], StrokeKind.DAMPER)
    sketch.line([piston, b], StrokeKind.DAMPER)


class SpringsDampers:
    """The springs and dampers of a system, drawn into a sketch.

    busy       the straight lines drawn so far, with which theirs are counted
    mounted    the fixed ends that have a hinge, which something must hold, each with the other end
    """

    def __init__(self, system: SystemPicture, sketch: Sketch, busy: list[tuple[PagePoint, PagePoint]]) -> None:
        self.system = system
        self.sketch = sketch
        self.busy = busy
        self.mounted: list[tuple[PagePoint, PagePoint]] = []

    def draw(self, half: Mapping[str, float]) -> None:
        """Springs and dampers, by half the widths of the blocks at whose sides they end; of two between the same points
        each is on its side.
        """
        ends = [self.ends(link, half) for link in self.system.links]
        rods = [piece for line in self.sketch.lines if line.kind is StrokeKind.ROD for piece in line.pieces]
        for n, link in enumerate(self.system.links):
            a, b = ends[n]
            self.busy.append((a, b))
            if sum(same_ends((a, b), other) for other in ends) > 1:
                before = sum(same_ends((a, b), other) for other in ends[:n])
                a, b = self.bypass(a, b, 0.24 - 0.48 * before)
            if apart(a, b) < 0.5:
                raise NoValueError("too short for a spring")
            if isinstance(link, StretchedSpring):
                draw_spring(self.sketch, a, b)
                self.sketch.label_beside(link.stiffness, a, b, optional=True, clear=0.1)
            else:
                draw_damper(self.sketch, a, b)
                self.sketch.label_beside(link.coefficient, a, b, optional=True, clear=0.1)
            for named, at, other in zip(link.ends, ends[n], ends[n][::-1], strict=True):
                if any(apart(at, place) <= 1e-3 for place, _ in self.mounted):
                    self.mounted.append((at, other))
                if isinstance(named, str) or any(apart(at, h) <= 1e-3 for h in self.sketch.hinges):
                    continue
                if self.is_held(named, at, rods):
                    self.fixed_end(at, other)
                else:
                    self.sketch.dot(at, 0.05)

    def is_held(self, place: Vector, at: PagePoint, rods: Sequence[tuple[PagePoint, PagePoint]]) -> bool:
        """Whether a spring's end is fixed or driven, or slides on a fixed support: on nothing that moves."""
        moving = {*self.system.configuration.slots.coordinates}
        used = place.fixed().as_sum().free_symbols
        if t in used and any(turning_guides(self.system)):
            return False
        if not used & moving:
            return True
        carried = any(
            p.mass != 0 and not (place.fixed() - p.position.fixed()).as_sum().free_symbols & moving
            for p in self.system.configuration.points
        )
        on_rod = any(apart(a, at) + apart(at, b) - apart(a, b) < 1e-3 for a, b in rods)
        return not (carried or on_rod or self.system.is_on_body(place))

    def ends(self, link: StretchedSpring | DamperForce, half: Mapping[str, float]) -> tuple[PagePoint, PagePoint]:
        """The two ends on the page, at the sides of the blocks that they hold. Raises NoValueError."""
        system = self.system
        first, second = map(system.page, ends_of(link, system.configuration, system.pose))
        inset = [half.get(e, 0.0) if isinstance(e, str) else 0.0 for e in link.ends]
        if apart(first, second) < sum(inset) + 0.6:
            return first, second
        return beyond(first, toward(first, second), inset[0]), beyond(second, toward(second, first), inset[1])

    def bypass(self, a: PagePoint, b: PagePoint, shift: float) -> tuple[PagePoint, PagePoint]:
        """Two ends shifted to one side of the given ones, and joined to them."""
        way = toward(a, b)
        side = left_of(way)
        corners = []
        for foot, sense in ((a, 0.16), (b, -0.16)):
            post = beyond(foot, way, sense)
            corner = beyond(post, side, shift)
            self.sketch.line([foot, post, corner], StrokeKind.SPRING)
            corners.append(corner)
        return corners[0], corners[1]

    def fixed_end(self, at: PagePoint, other: PagePoint) -> None:
        """A wall if the system is on one line, a hinge if the spring can turn."""
        if len(self.system.view.shown) == 1:  # the whole system is on one line
            self.sketch.hinges.append(at)
            self.sketch.wall(at, toward(at, other))
        else:
            self.sketch.hinge(at)
            self.mounted.append((at, other))
