"""Where labels go: beside what they belong to, and on nothing else.

Places around an anchor are tried from near to far, those in the preferred direction first, until one is free of lines,
dots and other labels. Where none is, a label that is needed makes the picture impossible, another is left out.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.document.math_writer import UNICODE, Notation, Writer
from lagrange.document.scene import Box, Dot, Label, Line, Point

HEIGHT = 0.34
LETTER = 0.2
SMALL_LETTER = 0.15
SPACE = 0.1
CLEAR = 0.03
_REACHES = (0.1, 0.15, 0.22, 0.32, 0.45, 0.6, 0.8, 1.0)
_TURNS = tuple(sign * k * math.pi / 10 for k in range(11) for sign in ((1, -1) if 0 < k < 10 else (1,)))
_INDEX = re.compile(r"_[^\W_]+(?:[._][^\W_]+)*")
_COMBINING = re.compile("[\u0300-\u036f]")
_RAISED = "₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ"


@record
class Wanted:
    """A label that is to be placed.

    anchors   points beside which it may stand, each with the direction that is preferred there
    clear     distance that it keeps from the anchor
    optional  whether the picture can do without it
    """

    content: sp.Expr | str
    anchors: tuple[tuple[Point, Point], ...]
    clear: float = 0.0
    optional: bool = False


def size(content: sp.Expr | str, notation: Notation) -> tuple[float, float]:
    """Estimated width and height in centimetres."""
    text = content if isinstance(content, str) else Writer(UNICODE, notation).plain(content)
    text = _COMBINING.sub("", text)
    small = sum(len(found[0]) - 1 for found in _INDEX.finditer(text))
    body = _INDEX.sub("", text)
    width = small * SMALL_LETTER
    for c in body:
        width += SMALL_LETTER if c in _RAISED else SPACE if c in " .,'′()" else LETTER * (1.3 if c in "mwMW" else 1)
    low = small or any(c in _RAISED for c in body)
    return width + 0.06, HEIGHT + (0.08 if low else 0.0) + (0.22 if "/" in body else 0.0)


def placed(
    wanted: Iterable[Wanted], lines: Sequence[Line], dots: Sequence[Dot], notation: Notation
) -> tuple[Label, ...] | None:
    """The labels in their places; None where one that is needed has none."""
    pieces = [piece for line in lines for piece in line.pieces]
    taken = [_around(d) for d in dots]
    found: list[Label] = []
    for w in wanted:
        label = _first_free(w, size(w.content, notation), pieces, taken)
        if label is not None:
            found.append(label)
            taken.append(label.box)
        elif not w.optional:
            return None
    return tuple(found)


def _around(dot: Dot) -> Box:
    (x, y), r = dot.at, dot.radius
    return Box(x - r, y - r, x + r, y + r)


def _first_free(
    wanted: Wanted, extent: tuple[float, float], pieces: Sequence[tuple[Point, Point]], taken: Sequence[Box]
) -> Label | None:
    width, height = extent
    for reach in _REACHES:
        for turn in _TURNS:
            for (x, y), (dx, dy) in wanted.anchors:
                angle = math.atan2(dy, dx) + turn
                c, s = math.cos(angle), math.sin(angle)
                away = wanted.clear + reach + _support(c, s, width, height)
                label = Label(wanted.content, (x + away * c, y + away * s), width, height)
                box = label.box.grown(CLEAR)
                if not any(box.overlaps(b) for b in taken) and not any(box.is_crossed(a, b) for a, b in pieces):
                    return label
    return None


def _support(c: float, s: float, width: float, height: float) -> float:
    """From the middle of a box to its edge, in the direction (c, s)."""
    across = width / 2 / abs(c) if c else math.inf
    upward = height / 2 / abs(s) if s else math.inf
    return min(across, upward)
