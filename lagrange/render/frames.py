"""A derivation as frames of a talk: LaTeX for the class `beamer`.

One step is one frame, and continues on the next where it is long (`allowframebreaks`); pictures are made smaller where
they would leave no room for their text. Slides 160 mm wide with letters of 10 pt break equations where a page does.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from lagrange.document.derivation import Derivation, Detail, Picture, Step
from lagrange.document.names import Notation
from lagrange.render.escape import escape, prefixes_of
from lagrange.render.latex import PACKAGES, Article
from lagrange.render.selection import block_lines
from lagrange.render.tex_layout import Vectors
from lagrange.render.tikz import picture

PREAMBLE = r"""\documentclass[10pt,aspectratio=169]{beamer}
PACKAGES
\usefonttheme[onlymath]{serif}
\setbeamertemplate{navigation symbols}{}
\setbeamertemplate{footline}[frame number]
\setbeamertemplate{frametitle continuation}{%
  \ifnum\insertcontinuationcount>1 (\insertcontinuationcount)\fi}
\setbeamersize{text margin left=8mm, text margin right=8mm}
\setlength{\parskip}{0.4\baselineskip}
\setlength{\emergencystretch}{3em}
\allowdisplaybreaks
""".replace("PACKAGES\n", PACKAGES)
FRAGMENT = r"""% lagsolve: frames for \documentclass[10pt,aspectratio=169]{beamer}; they need
% \usepackage{amsmath,amssymb,tikz}, \usetikzlibrary{arrows.meta}, \usefonttheme[onlymath]{serif} and
% \setbeamersize{text margin left=8mm, text margin right=8mm}
"""
TALLEST, WIDEST = 3.7, 14.0
"""Centimetres of a picture on a slide of 9 cm by 16 cm, beside a few lines of text."""


def render(
    derivations: Sequence[tuple[Derivation, Notation]], fragment: bool = False, vectors: Vectors = Vectors.BOLD
) -> str:
    """A talk with these derivations, or the frames that go into one."""
    prefixes = prefixes_of([derivation.title for derivation, _ in derivations])
    pages = ("\n".join(_Talk(*both, prefix).all()) for both, prefix in zip(derivations, prefixes, strict=True))
    bodies = vectors.written("\n\n".join(pages) + "\n")
    return FRAGMENT + bodies if fragment else f"{PREAMBLE}\n\\begin{{document}}\n\n{bodies}\n\\end{{document}}\n"


class _Talk(Article):
    """The frames of one derivation."""

    def __init__(self, derivation: Derivation, notation: Notation, prefix: str) -> None:
        super().__init__(derivation, notation, Detail.STEPS, prefix)

    def all(self) -> Iterator[str]:
        """The first frame has the title, and the result where the page begins with it."""
        title = escape(self.derivation.title)
        first, *others = self.content.steps or (None,)
        result = first if first is not None and not first.title else None
        yield from _frame(title, self._opening(result))
        for step in others if result is not None else self.content.steps:
            yield from _frame(escape(step.title), block_lines(step.body, self))

    def _opening(self, result: Step | None) -> Iterator[str]:
        if self.derivation.source:
            yield rf"\emph{{{escape(self.derivation.source)}}}" + "\n"
        yield from block_lines(result.body if result is not None else (), self)

    def picture(self, block: Picture) -> Iterator[str]:
        scene = block.draw()
        if scene is not None:
            factor = min(1.0, TALLEST / scene.box.height, WIDEST / scene.box.width)
            yield r"\begin{center}"
            yield rf"\scalebox{{{factor:.2f}}}{{%" if factor < 1 else "{%"
            yield from picture(scene, self.typesetter.writer.plain)
            yield "}"
            yield rf"\par {self.prose(block.caption)}"
            yield r"\end{center}"


def _frame(title: str, lines: Iterable[str]) -> Iterator[str]:
    yield rf"\begin{{frame}}[allowframebreaks]{{{title}}}"
    yield from lines
    yield r"\end{frame}"
    yield ""
