"""A picture as a file of its own, which any page can show: SVG with its colours in it, on white paper.

A page decides the colours of pictures that are part of it, but not of those in files: on a dark page black lines would
vanish, hence the paper. Programs that convert SVG for print (rsvg-convert, Inkscape) know no custom properties and no
`color-mix`: the style sheet does without.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from itertools import count

import sympy as sp

from lagrange.core.printable import printable
from lagrange.document.scene import Scene
from lagrange.render.svg import figure

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
