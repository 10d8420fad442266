"""The projection from space to the page: the images of i, j and k.

A plane problem is seen perpendicular to its plane, and its axes point as the file says ("right", "down", "east");
without such words, the first points to the right and the second up. Space is seen from a little to the right and
above, in parallel rays, so that a sphere is a circle and a disc an ellipse: i towards the reader, j to the right, k up,
or turned so that the words of the file hold. With the azimuth a = 25° and the elevation e = 20°

    i  (−sin a, −cos a sin e) ,     j  (cos a, −sin a sin e) ,     k  (0, cos e) .
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import replace

from lagrange.core.records import record
from lagrange.document.scene import PagePoint
from lagrange.pictures.floats import FloatVector, outer, unit

_A, _E = math.radians(25), math.radians(20)
_RIGHT, _UP = (1.0, 0.0), (0.0, 1.0)
_LEFT, _DOWN = (-1.0, 0.0), (0.0, -1.0)
_NEAR = -math.sin(_A), -math.cos(_A) * math.sin(_E)
_FAR = -_NEAR[0], -_NEAR[1]
_RIGHTWARD, _UPWARD = (math.cos(_A), -math.sin(_A) * math.sin(_E)), (0.0, math.cos(_E))
_DOWNWARD = (0.0, -math.cos(_E))
_WORDS = {
    "right": _RIGHT,
    "left": _LEFT,
    "up": _UP,
    "down": _DOWN,
    "upward": _UP,
    "upwards": _UP,
    "downward": _DOWN,
    "downwards": _DOWN,
    "vertically up": _UP,
    "vertically down": _DOWN,
    "horizontal": _RIGHT,
    "east": _RIGHT,
    "west": _LEFT,
    "north": _UP,
    "south": _DOWN,
    "away from the wall": _RIGHT,
}
_DOWN_ALONG = {
    (0, 1): (_DOWNWARD, _RIGHTWARD, _NEAR),
    (0, -1): (_UPWARD, _RIGHTWARD, _FAR),
    (1, 1): (_RIGHTWARD, _DOWNWARD, _FAR),
    (1, -1): (_RIGHTWARD, _UPWARD, _NEAR),
    (2, 1): (_RIGHTWARD, _NEAR, _DOWNWARD),
    (2, -1): (_NEAR, _RIGHTWARD, _UPWARD),
}
"""The images of i, j, k in space where one of them, or its opposite, is the direction of gravity: number, sign."""
_COMPASS = (
    ({"i": "east", "j": "north"}, (_RIGHTWARD, _FAR, _UPWARD)),
    ({"i": "north", "j": "east"}, (_FAR, _RIGHTWARD, _DOWNWARD)),
)


@record
class View:
    """The images of the unit vectors on the page, and which of them are drawn."""

    units: tuple[PagePoint, PagePoint, PagePoint]
    shown: tuple[int, ...]
    planar: bool

    def flat(self, v: FloatVector) -> PagePoint:
        """A vector on the page, in the units of the problem."""
        x = sum(c * u[0] for c, u in zip(v, self.units, strict=True))
        y = sum(c * u[1] for c, u in zip(v, self.units, strict=True))
        return x, y

    @property
    def toward_reader(self) -> FloatVector:
        """The unit vector that points at the reader."""
        across, upward = ((u[0] for u in self.units), (u[1] for u in self.units))
        return unit(outer(tuple(across), tuple(upward)))  # type: ignore[arg-type]

    def upright(self, gravity: FloatVector, axes: Mapping[str, str]) -> View:
        """The same with gravity down the page: a plane is turned, unless the words for its axes say how it lies or that
        it falls; in space the reader stands on the ground, wherever k points.
        """
        x, y = self.flat(gravity)
        if math.hypot(*gravity) < 1e-9:
            return self
        if not self.planar:
            return self if abs(x) < 1e-9 and y < 0 else self._in_space_upright(gravity)
        named = any(_word(axes, n) in _WORDS for n in self.shown) and y < 1e-9
        if len(self.shown) != 2 or named or math.hypot(x, y) < 1e-9:
            return self
        turn = -math.pi / 2 - math.atan2(y, x)
        c, s = math.cos(turn), math.sin(turn)
        turned = [(c * a - s * b, s * a + c * b) for a, b in self.units]
        return replace(self, units=(turned[0], turned[1], turned[2]))

    def _in_space_upright(self, gravity: FloatVector) -> View:
        size = math.hypot(*gravity)
        along = next((n for n in range(3) if abs(abs(gravity[n]) / size - 1) < 1e-9), None)
        if along is None:
            return seen_from(self.toward_reader, gravity)
        return replace(self, units=_DOWN_ALONG[along, 1 if gravity[along] > 0 else -1])


@record
class PaperMap:
    """The map from space to centimetres; the origin is at (0, 0)."""

    view: View
    scale: float

    def __call__(self, place: FloatVector) -> PagePoint:
        """The image of a point of space."""
        x, y = self.view.flat(place)
        return x * self.scale, y * self.scale

    def way(self, vector: FloatVector) -> PagePoint:
        """The image of a vector, in the units of the problem."""
        return self.view.flat(vector)


def seen_from(direction: FloatVector, down: FloatVector) -> View:
    """The view of space along a direction that points at the reader; `down` points down, or if it cannot, nearly.

    Axes that nearly point at the reader are not drawn.
    """
    facing = unit((-direction[0], -direction[1], -direction[2]))
    right = unit(outer(down, facing))
    up = outer(right, facing)
    units = tuple(zip(right, up, strict=True))
    shown = tuple(n for n, u in enumerate(units) if math.hypot(*u) > 0.3)
    return View(units, shown, planar=False)  # type: ignore[arg-type]


def view(axes: Mapping[str, str], used: frozenset[int]) -> View:
    """The view of a problem. `used`: the numbers of the unit vectors along which its points have components."""
    if len(used) == 3:
        return View(_in_space(axes), (0, 1, 2), planar=False)
    first, second = sorted(used) if len(used) == 2 else (0, 2 if 2 in used else 1)
    a, b = (_WORDS.get(_word(axes, n)) for n in (first, second))
    if a is None and b is None:
        a, b = _RIGHT, _UP
    elif a is None and b is not None:
        a = _RIGHT if b[0] == 0 else _UP
    elif b is None and a is not None:
        b = _UP if a[1] == 0 else _RIGHT
    assert a is not None
    assert b is not None
    if a[0] * b[0] + a[1] * b[1] != 0:
        a, b = _RIGHT, _UP
    units = [(0.0, 0.0)] * 3
    units[first], units[second] = a, b
    shown = (first, second) if len(used) == 2 or not used else tuple(sorted(used))
    return View((units[0], units[1], units[2]), shown, planar=True)


def _word(axes: Mapping[str, str], number: int) -> str:
    return axes.get("ijk"[number], "").lower().removeprefix("to the ").strip()


def _in_space(axes: Mapping[str, str]) -> tuple[PagePoint, PagePoint, PagePoint]:
    words = {name: word.lower().strip() for name, word in axes.items()}
    for compass, units in _COMPASS:
        if compass.items() <= words.items():
            return units
    if words.get("k") == "down":
        return _RIGHTWARD, _NEAR, _DOWNWARD
    along_slope = re.search(r"\b(slope|incline|plane)\b", words.get("i", "")) and "i" in words
    if (words.get("i") == "right" and words.get("j") != "up") or along_slope:
        return _RIGHTWARD, _FAR, _UPWARD
    if words.get("j") == "up":
        return _RIGHTWARD, _UPWARD, _NEAR
    return _NEAR, _RIGHTWARD, _UPWARD
