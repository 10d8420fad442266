"""Worksheets in Markdown as the blocks for exercises that MyST and Quarto have: `{exercise}`, `{solution}`, `#exr-`.

Inside such a block there are no headings: the titles of the parts are paragraphs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from lagrange.core.records import record
from lagrange.document.derivation import Derivation, Detail
from lagrange.document.math_writer import Notation
from lagrange.render.escape import prefixes_of
from lagrange.render.markdown import Page, escape
from lagrange.render.notes.flavours import Flavour
from lagrange.render.notes.svg_file import Figures
from lagrange.render.tex_layout import Vectors


@record
class Sheet:
    """An exercise, its solution, or both."""

    exercise: Derivation | None
    solution: Derivation | None
    notation: Notation


def render(sheets: Sequence[Sheet], vectors: Vectors, flavour: Flavour, figures: Figures | None = None) -> str:
    """The exercises and solutions, each as a block."""
    either = [s.exercise or s.solution for s in sheets]
    labels = prefixes_of([d.title.removesuffix(": solution") for d in either if d is not None])
    blocks = (b for sheet, label in zip(sheets, labels, strict=True) for b in _blocks(sheet, label, flavour, figures))
    return vectors.written("\n\n".join(blocks) + "\n")


def _blocks(sheet: Sheet, label: str, flavour: Flavour, figures: Figures | None) -> Iterator[str]:
    if sheet.exercise is not None:
        body = _body(sheet.exercise, sheet.notation, flavour, figures, label)
        yield "\n\n".join(flavour.exercise(escape(sheet.exercise.title), label, body))
    if sheet.solution is not None:
        body = _body(sheet.solution, sheet.notation, flavour, figures, f"{label}-solution")
        yield "\n\n".join(flavour.solution(escape(sheet.solution.title), label, body))


def _body(
    derivation: Derivation, notation: Notation, flavour: Flavour, figures: Figures | None, prefix: str
) -> Iterator[str]:
    page = Page(derivation, notation, Detail.STEPS, flavour, figures, prefix)
    if derivation.source:
        yield f"*{escape(derivation.source).strip()}*"
    yield from page.steps(page.content.steps, inside=flavour.labels)
