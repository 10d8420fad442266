"""A picture as an SVG element of a web page.

Kinds of lines are classes, which the style sheet of the page colours; letters are text in the font of the page. SVG
counts y downwards, a `Scene` upwards; one centimetre of a scene is `CENTIMETRE` pixels.

A picture as a file of its own, which any page can show: SVG with its colours in it, on white paper.

A page decides the colours of pictures that are part of it, but not of those in files: on a dark page black lines would
vanish, hence the paper. Programs that convert SVG for print (rsvg-convert, Inkscape) know no custom properties and no
`color-mix`: the style sheet does without.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from html import escape
from itertools import count, groupby

import sympy as sp

from lagrange.core.printable import printable
from lagrange.core.symbols import UnitVector, VectorSymbol
from lagrange.document.names import SMALL
from lagrange.document.scene import Dot, PagePoint, Polyline, Scene, StrokeKind

CENTIMETRE = 42.0
TIP = 0.2
"""Length of the tip of an arrow, in centimetres."""
_LOWERED = {**{d: n for n, d in zip("0123456789", "₀₁₂₃₄₅₆₇₈₉", strict=True)}, **{low: c for c, low in SMALL.items()}}
_PIECE = re.compile(
    rf"(?P<index>_[^\W_]+(?:[._][^\W_]+)*|[{''.join(_LOWERED)}]+)"
    r"|(?P<word>[A-Za-z]{2,})|(?P<letter>[^\W\d_][\u0300-\u036f]*)|(?P<other>.)"
)
_INDEX = re.compile("[₀-₉]+$")
"""The number of a point P₁."""
_UPRIGHT = {"sin", "cos", "tan", "cot", "exp", "log"}


def figure(scene: Scene, alt: str, write: Callable[[sp.Expr], str]) -> Iterator[str]:
    """The lines of an `svg` element; `write` spells mathematics in Unicode."""
    box = scene.box
    width, height = box.width * CENTIMETRE, box.height * CENTIMETRE

    def place(p: PagePoint) -> tuple[float, float]:
        return (p[0] - box.left) * CENTIMETRE, (box.top - p[1]) * CENTIMETRE

    yield (
        f'<svg class="picture" role="img" viewBox="0 0 {width:.1f} {height:.1f}" '
        f'width="{width:.0f}" height="{height:.0f}"><title>{escape(printable(alt))}</title>'
    )
    for hatched, group in groupby(scene.lines, lambda line: line.kind is StrokeKind.HATCH):
        if hatched:
            yield f'<path class="hatch" d="{" ".join(_path(line.points, place) for line in group)}"/>'
        else:
            for line in group:
                yield from _line(line, place)
    for dot in scene.dots:
        yield _dot(dot, place)
    for label in scene.labels:
        x, y = place(label.at)
        content = content_of(label.content, write)
        yield f'<text x="{x:.1f}" y="{y + 5:.1f}">{content}</text>'
    yield "</svg>"


def spans(text: str) -> str:
    """Mathematics as text: letters in italics, indices lowered."""
    code, lowered = "", False
    for piece in _PIECE.finditer(text.replace(" (", "(")):
        if piece["index"]:
            inner = "".join(_LOWERED.get(c, c) for c in piece[0].removeprefix("_")).replace("_", " ")
            slanted = ' class="i"' if len(inner) == 1 and inner.isalpha() else ""
            # `dy` moves all text after it, so what follows an index has to be raised again.
            code += f'<tspan{slanted} dy="{0 if lowered else 4}" font-size="75%">{escape(inner)}</tspan>'
            lowered = True
            continue
        attributes = ' class="i"' if piece["letter"] or (piece["word"] and piece[0] not in _UPRIGHT) else ""
        attributes += ' dy="-4"' if lowered else ""
        lowered = False
        letters = escape(piece[0])
        code += f"<tspan{attributes}>{letters}</tspan>" if attributes else letters
    return code


def content_of(content: sp.Expr | str, write: Callable[[sp.Expr], str]) -> str:
    """A label as the content of a `text` element."""
    if isinstance(content, str):
        return _INDEX.sub(lambda m: f'<tspan dy="4" font-size="75%">{"".join(_LOWERED[c] for c in m[0])}</tspan>',
                          escape(printable(content)))  # fmt: skip
    if isinstance(content, UnitVector | VectorSymbol):
        text = write(content)
        lead = text[:1] if content.name.startswith(("d(", "delta(")) else ""
        return lead + re.sub(r'^<tspan class="i"', '<tspan class="b"', spans(text.removeprefix(lead)))
    return spans(write(content))


def _line(line: Polyline, place: Callable[[PagePoint], tuple[float, float]]) -> Iterator[str]:
    points = list(line.points)
    tips = []
    if line.tip:
        # An arc consists of short pieces: the tip points along the chord of their end, and covers the end of the line.
        end = points[-1]
        before = next((p for p in reversed(points[:-1]) if math.dist(p, end) >= TIP), points[0])
        tips.append(_tip(before, end, place))
        size = math.dist(before, end)
        back = (end[0] + (before[0] - end[0]) * TIP * 0.7 / size, end[1] + (before[1] - end[1]) * TIP * 0.7 / size)
        if line.double:
            tips.append(_tip(before, back, place))
        while len(points) > 2 and math.dist(points[-2], end) < TIP * 0.7:
            points.pop(-2)
        points[-1] = back
    shade = f" s{line.shade}" if line.shade else ""
    yield f'<path class="{line.kind.value}{shade}" d="{_path(points, place)}{" Z" if line.closed else ""}"/>'
    for tip in tips:
        yield f'<path class="{line.kind.value} tip" d="{tip}"/>'


def _path(points: Iterable[PagePoint], place: Callable[[PagePoint], tuple[float, float]]) -> str:
    return " ".join(f"{'L' if n else 'M'}{x:.1f} {y:.1f}" for n, (x, y) in enumerate(map(place, points)))


def _tip(before: PagePoint, end: PagePoint, place: Callable[[PagePoint], tuple[float, float]]) -> str:
    (x0, y0), (x, y) = place(before), place(end)
    size = math.hypot(x - x0, y - y0) or 1.0
    c, s = (x - x0) / size, (y - y0) / size
    long, wide = TIP * CENTIMETRE, TIP * CENTIMETRE * 0.34
    corners = (
        (x, y),
        (x - long * c + wide * s, y - long * s - wide * c),
        (x - long * c - wide * s, y - long * s + wide * c),
    )
    return "M" + " L".join(f"{a:.1f} {b:.1f}" for a, b in corners) + " Z"


def _dot(dot: Dot, place: Callable[[PagePoint], tuple[float, float]]) -> str:
    x, y = place(dot.at)
    kind = "hinge" if dot.open else "particle"
    return f'<circle class="{kind}" cx="{x:.1f}" cy="{y:.1f}" r="{dot.radius * CENTIMETRE:.1f}"/>'


# As a file of its own


MARK = "<!-- a figure by lagsolve -->"
"""What a file begins with; one that does not is not overwritten."""
STYLE = """
.paper { fill: #ffffff; }
path { fill: none; stroke: #1c1b1a; stroke-width: 1.3; stroke-linejoin: round; stroke-linecap: round; }
.rod { stroke-width: 2.2; }
.guide, .reference { stroke: #6b6862; stroke-width: 0.9; stroke-dasharray: 4 4; }
.axis, .curve { stroke: #6b6862; }
.ground { stroke-width: 1.6; }
.hatch, .grid { stroke: #6b6862; stroke-width: 0.7; }
.angle, .dimension { stroke-width: 1; }
.face { stroke: none; }
.s1 { fill: #ffffff; } .s2 { fill: #f1f1f1; } .s3 { fill: #e1e1e1; } .s4 { fill: #cdcdcd; }
.force { stroke-width: 2; }
.reaction { stroke: #7a2e1d; stroke-width: 2; }
path.tip { fill: #1c1b1a; stroke: none; }
path.axis.tip { fill: #6b6862; }
path.reaction.tip { fill: #7a2e1d; }
circle { fill: #1c1b1a; }
.hinge { fill: #ffffff; stroke: #1c1b1a; stroke-width: 1.3; }
text { font: 15px "STIX Two Text", "Latin Modern Roman", "TeX Gyre Pagella", Georgia, serif; fill: #1c1b1a;
  text-anchor: middle; }
.i { font-style: italic; } .b { font-weight: bold; }
""".strip()


def svg_file(scene: Scene, alt: str, write: Callable[[sp.Expr], str]) -> str:
    """The text of the file; `write` spells mathematics in Unicode."""
    opening, *lines = figure(scene, printable(alt), write)
    namespaced = opening.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)
    _, _, width, height = re.search(r'viewBox="([^"]*)"', opening)[1].split()  # type: ignore[index]
    paper = f'<rect class="paper" width="{width}" height="{height}"/>'
    return "\n".join([MARK, namespaced, f"<style>{STYLE}</style>", paper, *lines]) + "\n"


class Figures:
    """The pictures of a page, each in a file beside it: `page.svg`, `page-2.svg`, ...

    files  the text of each file by its name
    """

    def __init__(self, stem: str) -> None:
        self.files: dict[str, str] = {}
        self._names: Iterator[str] = (f"{stem}.svg" if n == 1 else f"{stem}-{n}.svg" for n in count(1))

    def add(self, text: str) -> str:
        """The name of the file of one more picture; of the same picture again, that of the first."""
        for name, known in self.files.items():
            if known == text:
                return name
        name = next(self._names)
        self.files[name] = text
        return name
