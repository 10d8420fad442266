"""A picture being drawn: lines, dots, and labels to be placed; walls, arcs and arrows are made of lines.

A label goes near its anchor and on top of nothing. Labels are placed last, one after another, when all lines and dots
are known: for each distance from near to far, directions are tried in turn, the preferred one first, until the label
overlaps no line, dot or label. If there is no such place, an optional label is omitted; without a required one there
is no picture, because a wrong picture is worse than none.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import combinations, pairwise

import sympy as sp

from lagrange.core.records import record
from lagrange.document.math_writer import UNICODE, Notation, Writer
from lagrange.document.scene import FAINT, Box, Dot, Label, PagePoint, Polyline, Scene, StrokeKind
from lagrange.pictures.limits import SAME_ON_PAGE

PARTICLE = 0.085
HINGE = 0.06
"""Radii of dots, in centimetres."""
BAR = 0.07
"""Half the width of a bar: a ladder of that width does not seem to pierce the wall on which it leans."""
HATCH = 0.14
"""Distance between the strokes behind a line that does not move."""
# Centimetres of type at 11 pt, rather too large: a label must not touch its neighbours in any font.
HEIGHT = 0.34
LETTER = 0.2
SMALL_LETTER = 0.15
SPACE = 0.1
CLEAR = 0.03
"""Height of a label, widths of its characters, and the space around it."""
APART = 0.12
"""How near to another arrow than its own a label may be, in centimetres: nearer it would seem to belong to that."""
REACHES = (0.1, 0.15, 0.22, 0.32, 0.45, 0.6, 0.8, 1.0, 1.3, 1.7)
NEAR = (0.06, 0.1, 0.15, 0.22, 0.3)
"""How far from its line a letter still belongs to it, in centimetres."""
# The preferred direction, then alternately to both sides of it in steps of 18°, at last the opposite one.
_TURNS = tuple(sign * k * math.pi / 10 for k in range(11) for sign in ((1, -1) if 0 < k < 10 else (1,)))
_ARROWS = (StrokeKind.AXIS, StrokeKind.FORCE, StrokeKind.REACTION)
_INDEX = re.compile(r"_[^\W_]+(?:[._][^\W_]+)*")
_COMBINING = re.compile("[\u0300-\u036f]")
_RAISED = "₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ"


@record
class LabelRequest:
    """A label to be placed.

    anchors   points next to which it may be placed, each with the preferred direction
    clear     least distance from the anchor
    optional  whether the picture makes sense without it
    lines     what is drawn with it, and not without it: a dimension line
    reaches   distances from the anchor that are tried
    instead   other requests, tried in turn where there is no place for this one
    """

    content: sp.Expr | str
    anchors: tuple[tuple[PagePoint, PagePoint], ...]
    clear: float = 0.0
    optional: bool = False
    lines: tuple[Polyline, ...] = ()
    reaches: tuple[float, ...] = REACHES
    instead: tuple[LabelRequest, ...] = ()


def size(content: sp.Expr | str, notation: Notation) -> tuple[float, float]:
    """Estimated width and height in centimetres."""
    text = content if isinstance(content, str) else Writer(UNICODE, notation, on_page=True).plain(content)
    text = _COMBINING.sub("", text)
    small = sum(len(index[0]) - 1 for index in _INDEX.finditer(text))
    body = _INDEX.sub("", text)
    width = small * SMALL_LETTER
    for c in body:
        width += SMALL_LETTER if c in _RAISED else SPACE if c in " .,'′()" else LETTER * (1.3 if c in "mwMW" else 1)
    low = small or any(c in _RAISED for c in body)
    return width + 0.06, HEIGHT + (0.08 if low else 0.0) + (0.22 if "/" in body else 0.0)


def placed(
    wanted: Iterable[LabelRequest], lines: Sequence[Polyline], dots: Sequence[Dot], notation: Notation
) -> tuple[tuple[Label, ...], tuple[Polyline, ...]] | None:
    """The labels in their places, and the lines drawn with them; None if there is no place for a required one."""
    pieces = [piece for line in lines for piece in line.pieces]
    arrows = [line.pieces[0] for line in lines if line.kind in _ARROWS and line.tip and len(line.points) == 2]
    taken = [_around(d) for d in dots]
    labels: list[Label] = []
    drawn: list[Polyline] = []
    for w in sorted(wanted, key=lambda w: w.optional and isinstance(w.content, str)):  # names of points find a place
        for tried in (w, *w.instead):
            own = [piece for line in tried.lines for piece in line.pieces]
            if any(label.box.grown(CLEAR).is_crossed(*piece) for label in labels for piece in own):
                continue
            extent, free = size(tried.content, notation), [*pieces, *own]
            label = _first_free(tried, extent, free, taken, arrows) or _first_free(tried, extent, free, taken)
            if label is not None:
                labels.append(label)
                taken.append(label.box)
                pieces += own
                drawn += tried.lines
                break
        else:
            if not w.optional:
                return None
    return tuple(labels), tuple(drawn)


def _around(dot: Dot) -> Box:
    (x, y), r = dot.at, dot.radius
    return Box(x - r, y - r, x + r, y + r)


def _first_free(
    wanted: LabelRequest,
    extent: tuple[float, float],
    pieces: Sequence[tuple[PagePoint, PagePoint]],
    taken: Sequence[Box],
    arrows: Sequence[tuple[PagePoint, PagePoint]] = (),
) -> Label | None:
    """The first place that is free and, of arrows, near those alone that begin, end or lead on at the anchor."""
    width, height = extent
    others = [a for a in arrows if not any(lies_on(at, *a) for at, _ in wanted.anchors)]
    for reach in wanted.reaches:
        for turn in _TURNS:
            for (x, y), (dx, dy) in wanted.anchors:
                angle = math.atan2(dy, dx) + turn
                c, s = math.cos(angle), math.sin(angle)
                away = wanted.clear + reach + _support(c, s, width, height)
                label = Label(wanted.content, (x + away * c, y + away * s), width, height)
                box = label.box.grown(CLEAR)
                if any(box.overlaps(b) for b in taken) or any(box.is_crossed(a, b) for a, b in pieces):
                    continue
                if not any(box.grown(APART).is_crossed(*a) for a in others):
                    return label
    return None


def _support(c: float, s: float, width: float, height: float) -> float:
    """The distance from the middle of a box to its edge in the direction (c, s)."""
    across = width / 2 / abs(c) if c else math.inf
    upward = height / 2 / abs(s) if s else math.inf
    return min(across, upward)


def toward(a: PagePoint, b: PagePoint) -> PagePoint:
    """The unit vector from a to b; to the right if they coincide."""
    x, y = b[0] - a[0], b[1] - a[1]
    size = math.hypot(x, y)
    return (x / size, y / size) if size > 1e-9 else (1.0, 0.0)


def beyond(a: PagePoint, direction: PagePoint, by: float) -> PagePoint:
    """a + by · direction."""
    return a[0] + by * direction[0], a[1] + by * direction[1]


def left_of(direction: PagePoint) -> PagePoint:
    """A direction turned by a right angle, counterclockwise."""
    return -direction[1], direction[0]


def along(a: PagePoint, b: PagePoint, part: float) -> PagePoint:
    """A point between a and b."""
    return a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])


def apart(a: PagePoint, b: PagePoint) -> float:
    """The distance between two points."""
    return math.hypot(a[0] - b[0], a[1] - b[1])


def scaled(way: PagePoint, by: float) -> PagePoint:
    """A multiple of a vector."""
    return way[0] * by, way[1] * by


def same_ends(a: tuple[PagePoint, ...], b: tuple[PagePoint, ...]) -> bool:
    """Whether two pieces have the same ends, in either order."""
    straight = apart(a[0], b[0]) + apart(a[1], b[1])
    turned = apart(a[0], b[1]) + apart(a[1], b[0])
    return min(straight, turned) < 1e-3


def overlapping(a: tuple[PagePoint, PagePoint], b: tuple[PagePoint, PagePoint]) -> bool:
    """Whether two pieces are on one line and overlap."""
    way = toward(*a)
    side = left_of(way)

    def off(p: PagePoint) -> float:
        return (p[0] - a[0][0]) * side[0] + (p[1] - a[0][1]) * side[1]

    def on(p: PagePoint) -> float:
        return (p[0] - a[0][0]) * way[0] + (p[1] - a[0][1]) * way[1]

    if max(abs(off(p)) for p in b) > 1e-3:
        return False
    low, high = sorted(on(p) for p in b)
    return low < apart(*a) - 1e-3 and high > 1e-3


def touches(at: PagePoint, a: PagePoint, b: PagePoint) -> bool:
    """Whether a point is an end of a piece."""
    return min(apart(at, a), apart(at, b)) < 0.02


def lies_on(at: PagePoint, a: PagePoint, b: PagePoint) -> bool:
    """Whether a point is on the piece between two others."""
    return apart(at, a) + apart(at, b) - apart(a, b) < 0.02


def inner_product(a: PagePoint, b: PagePoint) -> float:
    """a·b."""
    return a[0] * b[0] + a[1] * b[1]


def crossing(one: Sequence[PagePoint], other: Sequence[PagePoint]) -> PagePoint | None:
    """Where two pieces cross inside both; None if they do not."""
    (a, b), (c, d) = one, other
    u, v = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
    turned = u[0] * v[1] - u[1] * v[0]
    if abs(turned) < SAME_ON_PAGE:
        return None
    w = (c[0] - a[0], c[1] - a[1])
    s, r = (w[0] * v[1] - w[1] * v[0]) / turned, (w[0] * u[1] - w[1] * u[0]) / turned
    inside = all(SAME_ON_PAGE < x < 1 - SAME_ON_PAGE for x in (s, r))
    return (a[0] + s * u[0], a[1] + s * u[1]) if inside else None


def in_line(centre: PagePoint, others: list[PagePoint]) -> bool:
    """Whether all points are on one line with the first."""
    far = max(others, key=lambda p: apart(centre, p))
    if apart(centre, far) < 1e-6:
        return False
    side = left_of(toward(centre, far))
    return all(abs((p[0] - centre[0]) * side[0] + (p[1] - centre[1]) * side[1]) < 0.06 for p in others)


def farthest(points: list[PagePoint]) -> tuple[PagePoint, PagePoint]:
    """The two points that are farthest apart."""
    pairs = [(a, b) for a in points for b in points]
    return max(pairs, key=lambda p: apart(*p))


def dimension_lines(a: PagePoint, b: PagePoint) -> list[Polyline]:
    """The line of a length, with a stroke across each of its ends."""
    side = left_of(toward(a, b))
    strokes = ((beyond(end, side, 0.09), beyond(end, side, -0.09)) for end in (a, b))
    return [Polyline(points, StrokeKind.DIMENSION) for points in ((a, b), *strokes)]


def beside(
    a: PagePoint, b: PagePoint, parts: Sequence[float] = (0.5, 0.4, 0.6, 0.3, 0.7)
) -> tuple[tuple[PagePoint, PagePoint], ...]:
    """Anchors of a label next to the line from a to b, on either side, if possible at its middle."""
    side = left_of(toward(a, b))
    return tuple((along(a, b, part), s) for part in parts for s in (side, (-side[0], -side[1])))


@dataclass
class Sketch:
    """The lines and dots drawn so far, and the labels to be placed."""

    lines: list[Polyline] = field(default_factory=list)
    dots: list[Dot] = field(default_factory=list)
    wanted: list[LabelRequest] = field(default_factory=list)
    filled: list[tuple[float, Polyline]] = field(default_factory=list)
    hinges: list[PagePoint] = field(default_factory=list)

    def line(self, points: Sequence[PagePoint], kind: StrokeKind, closed: bool = False) -> None:
        """A chain of straight pieces."""
        self.lines.append(Polyline(tuple(points), kind, closed))

    def arrow(self, start: PagePoint, end: PagePoint, kind: StrokeKind, double: bool = False) -> None:
        """An arrow."""
        self.lines.append(Polyline((start, end), kind, tip=True, double=double))

    def arc(self, points: Sequence[PagePoint], kind: StrokeKind, tip: bool = True) -> None:
        """An arc through these points, with a tip."""
        self.lines.append(Polyline(tuple(points), kind, tip=tip))

    def dot(self, at: PagePoint, radius: float = PARTICLE, open_: bool = False) -> None:
        """A particle."""
        self.dots.append(Dot(at, radius, open_))

    def hinge(self, at: PagePoint) -> None:
        """A hinge, once at each place."""
        if all(apart(at, h) > 1e-3 for h in self.hinges):
            self.hinges.append(at)
            self.dot(at, HINGE, open_=True)

    def label(
        self, content: sp.Expr | str, at: PagePoint, prefer: PagePoint, clear: float = 0.0, optional: bool = False
    ) -> None:
        """A label near a point."""
        self.wanted.append(LabelRequest(content, ((at, prefer),), clear, optional))

    def label_beside(
        self, content: sp.Expr | str, a: PagePoint, b: PagePoint, optional: bool = False, clear: float = 0.0
    ) -> None:
        """A label next to the line from a to b, on either side, if possible at its middle."""
        self.wanted.append(LabelRequest(content, beside(a, b), clear, optional))

    def scene(self, notation: Notation) -> Scene | None:
        """The picture; None if there is no place for a required label."""
        faces = [face for _, face in sorted(self.filled, key=lambda f: f[0])]
        lines = (*faces, *self.lines)
        found = placed(self.wanted, [line for line in lines if line.kind not in FAINT], self.dots, notation)
        return None if found is None else Scene((*lines, *found[1]), tuple(self.dots), found[0])

    # Shapes made of lines

    def face(
        self, points: Sequence[PagePoint], shade: int, depth: float = 0.0, kind: StrokeKind = StrokeKind.BODY
    ) -> None:
        """A closed outline with its inside; of two, the one with less depth is behind the other, and all are behind
        the lines.
        """
        self.filled.append((depth, Polyline(tuple(points), kind, closed=True, shade=shade)))

    def wall(self, at: PagePoint, inward: PagePoint, half: float = 0.4) -> None:
        """A short wall through a point, hatched on the side opposite to `inward`."""
        side = left_of(inward)
        self.ground([beyond(at, side, half), beyond(at, side, -half)])

    def ground(self, points: Sequence[PagePoint]) -> None:
        """A chain that does not move, hatched on the right-hand side; one with what it overlaps on a line."""
        if len(points) == 2:
            points = self._with_grounds_on_its_line(points[0], points[1])
        self.line(points, StrokeKind.GROUND)
        start = HATCH / 2
        for a, b in pairwise(points):
            way, length = toward(a, b), apart(a, b)
            right = -left_of(way)[0], -left_of(way)[1]
            while start <= length:
                foot = beyond(a, way, start)
                self.line([foot, beyond(beyond(foot, right, 0.13), way, -0.11)], StrokeKind.HATCH)
                start += HATCH
            start -= length

    def _with_grounds_on_its_line(self, a: PagePoint, b: PagePoint) -> tuple[PagePoint, PagePoint]:
        """The ends of a straight ground and of those that it overlaps, which are taken out of the sketch."""
        way = toward(a, b)
        start, end = 0.0, apart(a, b)
        kept: list[Polyline] = []
        replaced = False
        for line in self.lines:
            if line.kind is StrokeKind.HATCH and replaced:
                continue  # the hatches of a ground follow it
            replaced = False
            if line.kind is StrokeKind.GROUND and len(line.points) == 2:
                offsets = [(p[0] - a[0], p[1] - a[1]) for p in line.points]
                across = max(abs(x * way[1] - y * way[0]) for x, y in offsets)
                low, high = (x * way[0] + y * way[1] for x, y in offsets)
                replaced = across < SAME_ON_PAGE and low < high and low < end and start < high
                if replaced:
                    start, end = min(start, low), max(end, high)
            if not replaced:
                kept.append(line)
        self.lines = kept
        return beyond(a, way, start), beyond(a, way, end)

    def cut_grounds(self, contacts: Sequence[PagePoint]) -> None:
        """Of two straight grounds that cross, leave the parts on which something is: two slopes end at their ridge."""
        grounds = [line for line in self.lines if line.kind is StrokeKind.GROUND and len(line.points) == 2]
        for one, other in combinations(grounds, 2):
            corner = crossing(one.points, other.points)
            if corner is None:
                continue
            for line in (one, other):
                a, b = line.points
                on = [at for at in contacts if lies_on(at, a, b) and apart(at, corner) > HATCH]
                before = [inner_product(toward(corner, at), toward(corner, a)) > 0 for at in on]
                if on and all(before) == any(before):
                    self._redraw(line, [a, corner] if before[0] else [corner, b])

    def _redraw(self, line: Polyline, points: Sequence[PagePoint]) -> None:
        """Another piece of ground in the place of one, with its own hatching."""
        if line not in self.lines:
            return
        start = self.lines.index(line)
        end = start + 1
        while end < len(self.lines) and self.lines[end].kind is StrokeKind.HATCH:
            end += 1
        del self.lines[start:end]
        self.ground(points)

    def join_corner(self) -> None:
        """Prolong a wall and a floor to where they meet, if they are the only grounds, at a right angle and apart."""
        grounds = [line.points for line in self.lines if line.kind is StrokeKind.GROUND]
        if len(grounds) != 2 or any(len(points) != 2 for points in grounds):
            return
        (a, b), (c, d) = grounds
        first, second = toward(a, b), toward(c, d)
        if abs(first[0] * second[0] + first[1] * second[1]) > SAME_ON_PAGE:
            return
        reach = (c[0] - a[0]) * first[0] + (c[1] - a[1]) * first[1]
        back = (a[0] - c[0]) * second[0] + (a[1] - c[1]) * second[1]
        corner = beyond(a, first, reach)
        for (start, end), at in (((a, b), reach), ((c, d), back)):
            if 0 < at < apart(start, end):
                return  # they cross
        for start, end in ((a, b), (c, d)):
            near, far = sorted((start, end), key=lambda p: apart(p, corner))
            self.ground([corner, far] if near == start else [far, corner])

    def dimension(self, a: PagePoint, b: PagePoint) -> None:
        """The line of a length, with a stroke across each of its ends."""
        self.lines += dimension_lines(a, b)

    def circle(self, centre: PagePoint, radius: float, shade: int, kind: StrokeKind = StrokeKind.BODY) -> None:
        """A circle with its inside."""
        angles = [2 * math.pi * k / 48 for k in range(48)]
        self.face([beyond(centre, (math.cos(a), math.sin(a)), radius) for a in angles], shade, kind=kind)

    def capsule(self, a: PagePoint, b: PagePoint, half: float) -> None:
        """A bar with round ends from a to b."""
        way = toward(a, b)
        turn = math.atan2(way[1], way[0])
        ends = [(b, turn - math.pi / 2), (a, turn + math.pi / 2)]
        points = [
            (x + half * math.cos(start + k * math.pi / 8), y + half * math.sin(start + k * math.pi / 8))
            for (x, y), start in ends
            for k in range(9)
        ]
        self.line(points, StrokeKind.BODY, closed=True)

    def ellipse(self, centre: PagePoint, first: PagePoint, second: PagePoint) -> None:
        """An ellipse with two conjugate semi-axes, given as vectors."""
        angles = [2 * math.pi * k / 48 for k in range(48)]
        points = [
            (
                centre[0] + math.cos(a) * first[0] + math.sin(a) * second[0],
                centre[1] + math.cos(a) * first[1] + math.sin(a) * second[1],
            )
            for a in angles
        ]
        self.line(points, StrokeKind.BODY, closed=True)

    def turning(
        self, centre: PagePoint, radius: float, counterclockwise: bool, kind: StrokeKind, start: float = -0.6
    ) -> PagePoint:
        """The curved arrow of a moment; return its middle."""
        sign = 1 if counterclockwise else -1
        begin = start if counterclockwise else math.pi - start
        angles = [begin + sign * k * 1.5 * math.pi / 24 for k in range(25)]
        points = [beyond(centre, (math.cos(a), math.sin(a)), radius) for a in angles]
        self.arc(points, kind)
        return points[12]
