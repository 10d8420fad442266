r"""A picture in TikZ: `\draw` for each line, `\node` for each label, the styles of the kinds at its beginning."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from lagrange.document.scene import Dot, Kind, Line, Point, Scene
from lagrange.render.escape import escape

STYLES = {
    Kind.ROD: "line width=1.1pt",
    Kind.LINK: "line width=0.6pt",
    Kind.BODY: "line width=0.8pt",
    Kind.CURVE: "line width=0.8pt, black!60",
    Kind.SPRING: "line width=0.6pt",
    Kind.DAMPER: "line width=0.6pt",
    Kind.GROUND: "line width=0.5pt",
    Kind.GUIDE: "line width=0.4pt, dashed, black!60",
    Kind.ANGLE: "line width=0.5pt",
    Kind.AXIS: "line width=0.5pt, black!60",
    Kind.FORCE: "line width=1.1pt",
    Kind.REACTION: "line width=1.1pt, blue!60!black",
}


def picture(scene: Scene, write: Callable[[sp.Expr], str]) -> Iterator[str]:
    """The lines of a `tikzpicture`. `write` is LaTeX of mathematics."""
    styles = [f"{k.value}/.style={{{STYLES[k]}}}" for k in Kind if any(line.kind is k for line in scene.lines)]
    yield r"\begin{tikzpicture}[line join=round, line cap=round, >={Stealth[length=5pt]},"
    yield "  " + ", ".join(styles) + "]"
    for line in scene.lines:
        yield "  " + _draw(line)
    for dot in scene.dots:
        yield "  " + _dot(dot)
    for label in scene.labels:
        content = escape(label.content) if isinstance(label.content, str) else f"${write(label.content)}$"
        yield rf"  \node[inner sep=0pt] at {_point(label.at)} {{\small {content}}};"
    yield r"\end{tikzpicture}"


def _draw(line: Line) -> str:
    tip = ", ->>" if line.double else ", ->" if line.tip else ""
    path = " -- ".join(map(_point, line.points)) + (" -- cycle" if line.closed else "")
    return rf"\draw[{line.kind.value}{tip}] {path};"


def _dot(dot: Dot) -> str:
    style = "fill=white, draw=black, line width=0.7pt" if dot.open else "fill=black"
    return rf"\path[{style}] {_point(dot.at)} circle[radius={dot.radius:.3g}];"


def _point(p: Point) -> str:
    return f"({_number(p[0])},{_number(p[1])})"


def _number(x: float) -> str:
    text = f"{x:.3f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
