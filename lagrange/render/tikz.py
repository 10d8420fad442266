r"""A picture in TikZ: `\draw` for each line, `\path` for each dot, `\node` for each label.

Coordinates are plain centimetres, one command a line, and each kind of line is a style defined at the beginning: so
that a picture can be changed by hand.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator
from itertools import groupby

import sympy as sp

from lagrange.document.scene import Dot, PagePoint, Polyline, Scene, StrokeKind
from lagrange.render.escape import escape

STYLES = {
    StrokeKind.ROD: "line width=1.1pt",
    StrokeKind.STRING: "line width=0.8pt",
    StrokeKind.LINK: "line width=0.6pt",
    StrokeKind.BODY: "line width=0.8pt",
    StrokeKind.FACE: "draw=none",
    StrokeKind.GRID: "line width=0.3pt, black!45",
    StrokeKind.CURVE: "line width=0.8pt, black!60",
    StrokeKind.SPRING: "line width=0.6pt",
    StrokeKind.DAMPER: "line width=0.6pt",
    StrokeKind.GROUND: "line width=0.9pt",
    StrokeKind.HATCH: "line width=0.35pt, black!60",
    StrokeKind.GUIDE: "line width=0.4pt, dashed, black!60",
    StrokeKind.REFERENCE: "line width=0.4pt, dashed, black!60",
    StrokeKind.DIMENSION: "line width=0.4pt",
    StrokeKind.ANGLE: "line width=0.5pt",
    StrokeKind.AXIS: "line width=0.5pt, black!60",
    StrokeKind.FORCE: "line width=1.1pt",
    StrokeKind.REACTION: "line width=1.1pt, blue!60!black",
}
SHADES = ("", "white", "black!6", "black!13", "black!22")


def picture(scene: Scene, write: Callable[[sp.Expr], str]) -> Iterator[str]:
    """The lines of a `tikzpicture`; `write` spells mathematics in LaTeX."""
    styles = [f"{k.value}/.style={{{STYLES[k]}}}" for k in StrokeKind if any(line.kind is k for line in scene.lines)]
    yield r"\begin{tikzpicture}[line join=round, line cap=round, >={Stealth[length=5pt]},"
    yield "  " + ", ".join(styles) + "]"
    for hatched, group in groupby(scene.lines, lambda line: line.kind is StrokeKind.HATCH):
        if hatched:
            yield "  " + _strokes([*group])
        else:
            yield from ("  " + _draw(line) for line in group)
    for dot in scene.dots:
        yield "  " + _dot(dot)
    for label in scene.labels:
        content = _words(label.content) if isinstance(label.content, str) else f"${write(label.content)}$"
        yield rf"  \node[inner sep=0pt] at {_point(label.at)} {{\small {content}}};"
    yield r"\end{tikzpicture}"


def _words(text: str) -> str:
    """A word, or a point with a number; the force −∇V is a formula."""
    index = re.search("[₀-₉]+$", text)
    if index:
        return f"{escape(text[: index.start()])}$_{{{unicodedata.normalize('NFKC', index[0])}}}$"
    return r"$-\nabla V$" if text == "−∇V" else escape(text)


def _draw(line: Polyline) -> str:
    tip = ", ->>" if line.double else ", ->" if line.tip else ""
    path = " -- ".join(map(_point, line.points)) + (" -- cycle" if line.closed else "")
    shade = f", fill={SHADES[line.shade]}" if line.shade else ""
    return rf"\draw[{line.kind.value}{tip}{shade}] {path};"


def _strokes(lines: list[Polyline]) -> str:
    paths = " ".join(" -- ".join(map(_point, line.points)) for line in lines)
    return rf"\draw[{lines[0].kind.value}] {paths};"


def _dot(dot: Dot) -> str:
    style = "fill=white, draw=black, line width=0.7pt" if dot.open else "fill=black"
    return rf"\path[{style}] {_point(dot.at)} circle[radius={dot.radius:.3g}];"


def _point(p: PagePoint) -> str:
    return f"({_number(p[0])},{_number(p[1])})"


def _number(x: float) -> str:
    text = f"{x:.3f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
