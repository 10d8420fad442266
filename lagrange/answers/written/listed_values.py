r"""Several values after one sign of equality, as positions of equilibrium are listed.

    theta = 0, pi        θ = 0 or π, or cos θ = W l/(c b²)        \theta = 0 \text{ or } \pi        theta = {0, pi}
    {{x -> 0}, {x -> a}}

Each value without a sign of equality belongs to the left side before it; all together are alternatives.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from lagrange.answers.limits import MOST_LISTED
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, cuts
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.syntax_tree import FUNCTIONS

_SEPARATOR = re.compile(
    r",|;|(?<![\w\\])(?:or|and|oder|und)(?![\w'])|\\(?:text|textrm|mbox|mathrm)\s*\{\s*,?\s*(?:or|and|oder|und)\s*\}|\\q?quad(?![A-Za-z])|\\lor(?![A-Za-z])|∨"
)
_EQUALS = re.compile(r"(?<![<>!=:])=(?![=>])")
_WORDS = re.compile(r"(?<!\\)[^\W\d_]{3,}")
_KNOWN = frozenset({*FUNCTIONS, *GREEK.values(), "arcsin", "arccos", "arctan", "left", "right", "frac", "sqrt"})
_SET = re.compile(r"(?:=|∈|\\in(?![A-Za-z]))\s*(?:\\left\s*)?\\?\{(?P<inside>[^{}=]*)\\?\}\s*\Z")
_SEVERAL = re.compile(
    rf"(\\?[A-Za-z]+|[{''.join(GREEK)}])_?(?:\{{\s*|(?=[0-9]\s?,\s?[0-9]\s*=))([0-9])\s*[,/]\s*[0-9](?:\s*,\s*[0-9]){{0,4}}\s*\}}?(?=\s*=)"
)
"""A coordinate with the numbers of several of its values, `\\theta_{3,4}`."""
_PLUS_MINUS = re.compile(r"±|\\pm(?![A-Za-z])|\+/-")


def with_listed_values(fragment: Fragment, declared: Collection[str] = ()) -> Fragment:
    """The text as alternatives `q = a or q = b`; the text itself where it lists none."""
    draft = Draft(fragment)
    if listed := _SET.search(draft.text):
        draft.apply([(listed.start(), listed.start("inside"), "= "), (listed.end("inside"), listed.end(), "")])
    draft.replace(_SEVERAL, lambda m: None if f"{_plain(m[1])}_{m[2]}" in declared else m[1])
    text = draft.text
    if not _EQUALS.search(text):
        return fragment
    latex = is_latex(fragment)
    pieces = [(a, b) for a, b in cuts(text, _SEPARATOR) if text[a:b].strip(" $.~,")]
    sides: list[str] = []
    left = ""
    for a, b in pieces:
        signs = cuts(text[a:b], _EQUALS)
        if len(signs) == 2:
            left = text[a : a + signs[0][1]].strip(" $")
            value = text[a:b].strip(" $")
        elif len(signs) == 1 and left and _is_value(text[a:b]):
            value = f"{left} = {text[a:b].strip(' $.')}"
        else:
            return fragment
        sides.append(value)
    signed = any(_PLUS_MINUS.search(side) for side in sides)
    if signed:
        sides = [_PLUS_MINUS.sub(lambda _, s=sign: s, side) for side in sides for sign in _signs(side)]  # type: ignore[misc]
    stated = all(_EQUALS.search(text[a:b]) for a, b in pieces)
    if not 1 < len(sides) <= MOST_LISTED or (stated and not signed):
        return draft.finished(latex=latex)
    draft.apply([(0, len(text), (r" \text{ or } " if latex else " or ").join(sides))])
    return draft.finished(latex=latex)


def _signs(side: str) -> tuple[str, ...]:
    """What a ± stands for, where all that is on its side is of one sign: + and −."""
    return ("+", "-") if len(_PLUS_MINUS.findall(side)) == 1 else ("",)


def _plain(name: str) -> str:
    return "".join(GREEK.get(c, c) for c in name).strip("\\ ")


def _is_value(text: str) -> bool:
    """Whether a text may be a value, and has no words."""
    return all(w.lower() in _KNOWN for w in _WORDS.findall(text)) and not re.search(
        r"[<>≤≥]|\\[gl]eq?(?![A-Za-z])", text
    )


def with_all_values(answer: Sequence[Fragment], declared: Collection[str] = ()) -> list[Fragment]:
    """The same for each of several texts."""
    return [with_listed_values(f, declared) for f in answer]
