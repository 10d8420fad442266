r"""The equations of one line of an answer, stripped of number, label, box and colour.

a = b = c is a = b and b = c. A line with `or` is kept whole, since it states alternatives.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import dataclass, replace

from lagrange.answers.readings import GivenEquation, Reading
from lagrange.answers.written.lines import in_pairs
from lagrange.answers.written.notation.matrices import has_matrix, rows_of_matrices
from lagrange.answers.written.notation.plain import cleaned
from lagrange.answers.written.notation.programs import as_equation
from lagrange.answers.written.numbering import number_at_the_end
from lagrange.answers.written.reading import too_long, without_braces
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import ABOUT
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import OneEquation, is_latex
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS

_ALTERNATIVES = re.compile(r"(?<![\w\\])or(?![\w'])|\\(?:text|textrm|mbox|mathrm)\{\s*or\s*\}")
_ITEM = re.compile(r"\s*\(([a-h]|[ivx]{1,4})\)\s+")
_IN_BRACKETS = re.compile(
    r"\s*(?:\\left\s*)?(?:\[|\\\{)(?P<inside>[^\[\]]*=[^\[\]]*?)(?:\\right\s*)?(?:\]|\\\})\s*\Z|\s*\\(?:text)?color\s*\{[^{}\\]{0,40}\}\s*\{(?P<colour>.*=.*)\}\s*\Z"
)
_ABOUT = re.compile(rf"{ABOUT}|\\sim(?![A-Za-z])|~=|(?<=\s)~(?=\s)")
_LABEL = re.compile(
    r"(?:[\s&]*(?:\\(?:text(?:bf|it|rm|sf)?|mbox|mathrm|underline)\s*\{[^{}=]{1,60}:\s*\}"
    r"|\\(?:[ns][ew]arrow|(?:up|down|left|right|curve|circle)arrow(?:left|right)?|curvearrow(?:left|right))[^:=+\\]{0,8}:"
    r"|[↑↓→←↗↘↖↙↺↻⟲⟳]\s*:)\s*(?:&|~|\\q?quad|\\[,;: !])*)+"
)
"""What an equation is about, before it: `\\text{radial: }`, `\\searrow:`."""


@dataclass
class Line:
    """One equation of the answer, as far as it has been understood; a `whole` one states alternatives."""

    fragment: Fragment
    text: str
    number: str = ""
    reading: Reading | None = None
    definition: bool = False
    whole: bool = False


def lines_of(fragment: Fragment, declared: Collection[str]) -> list[Line]:
    """The equations of a fragment without its number: a = b = c is a = b and b = c."""
    if isinstance(fragment, GivenEquation):
        return [Line(fragment, fragment.text, reading=fragment.reading)]
    text = fragment.text.strip()
    if len(text) > MAX_ANSWER_CHARACTERS:  # its error, and nothing else of it
        return [Line(fragment, text, reading=Reading(text, error=too_long(fragment)))]
    if _ALTERNATIVES.search(fragment.text):
        return [Line(fragment, text, whole=True)]
    if has_matrix(text) and (in_rows := rows_of_matrices(fragment.text)):
        return [Line(in_place_of(fragment, row), row) for row in in_rows]
    draft = Draft(cleaned(fragment, declared))
    as_equation(draft, declared)
    if (item := _ITEM.match(draft.text)) and item[1] not in declared:
        draft.keep(item.end(), len(draft.text))
    if label := _LABEL.match(draft.text):
        draft.keep(label.end(), len(draft.text))
    if boxed := _IN_BRACKETS.match(draft.text):
        draft.keep(*boxed.span(boxed.lastgroup or 0))
    without_braces(draft)
    end, number = number_at_the_end(draft.text)
    about = next((m.start() for m in _ABOUT.finditer(draft.text) if "=" in draft.text[: m.start()]), end)
    latex = is_latex(fragment)
    draft.keep(0, min(end, about))
    whole = finished(draft, fragment, latex)
    pieces = in_pairs(whole) if draft.text.count("=") > 1 else []
    if not pieces:
        return [Line(whole, text, number)]
    made = [finished(piece, fragment, latex) for piece in pieces]
    return [Line(m, m.text.strip(" &$\n")) for m in made]


def in_place_of(fragment: Fragment, text: str) -> Fragment:
    """Another text at the place of a fragment."""
    draft = Draft(fragment)
    draft.apply([(0, len(fragment.text), text)])
    return draft.finished(latex=True)


def finished(draft: Draft, fragment: Fragment, latex: bool) -> Fragment:
    """A draft of a fragment, with the words that stand beside that."""
    made = draft.finished(latex=latex and draft.text != draft.outer.text)
    beside = getattr(fragment, "beside", "")
    return replace(made, beside=beside) if isinstance(made, OneEquation) else made
