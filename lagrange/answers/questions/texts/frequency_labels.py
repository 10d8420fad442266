"""Lines of a text that state frequencies: `omega_1 = ...`, `omega^2 = 0, c/m`, `T = ...`, `f = ...`."""

from __future__ import annotations

import re
from collections.abc import Sequence

from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.answers.written.names import has_word
from lagrange.core.diagnostics import Fragment
from lagrange.document.math_writer import text
from lagrange.expressions.edits import Draft, cut, cuts
from lagrange.expressions.latex_layout import is_latex

FREQUENCY_WORDS = ("frequency", "frequencies", "eigenfrequencies", "Frequency", "Frequencies", "Eigenfrequenzen")
"""What may stand before a colon and the frequencies themselves."""
LABELLED = re.compile(
    r"\s*\$?\s*\\?(?:omega|Omega|[ωΩ]|w|f|T|nu|ν|(?:[Ee]igen)?[Ff]requen(?:cy|cies|zen|z))(?:_?\{?\s*(?:\w{1,6}|1\s*,\s*2)\s*\}?)?\s*(?:\^\s*\{?2\}?|²)?\s*&?\s*=(?!=)"
)
_BETWEEN = re.compile(
    r"[,;]|\b(?:and|und|or|oder|et|ou)\b|\\(?:text|textrm|mathrm|mbox)\{[^{}]{0,20}\}|\\q?quad(?![A-Za-z])"
)


def stated_frequencies(answer: Sequence[Fragment]) -> list[Fragment]:
    """The lines of a text that state frequencies or periods, and do not define what other lines contain."""
    frequencies = []
    for f in answer:
        match = LABELLED.match(f.text)
        name = _label(f)
        others = [LABELLED.sub("", g.text, count=1) for g in answer if g is not f and not is_characteristic(g)]
        is_natural = re.search(r"_?\{?0\}?$|₀$", name.split("^")[0].rstrip("² "))
        if is_natural and any(ACCELERATION.search(text) for text in others):
            continue  # omega_0^2 = g/l is an abbreviation beside an equation of motion
        if match and not any(has_word(name.split("^")[0].rstrip("²& "), text) for text in others):
            frequencies.append(f)
    return frequencies


def stated_position(b: Branch) -> str:
    """Where an equilibrium is: `theta1 = 0, theta2 = 0`."""
    return ", ".join(f"{text(r.lhs)} = {text(r.rhs)}" for r in b.relations) or "the equilibrium"


def name_of_frequency(fragment: Fragment) -> str:
    """The name before the first sign of equality of a line that states a frequency, without its square."""
    return _label(fragment).split("^")[0].rstrip("²& ").removeprefix("\\")


def _label(fragment: Fragment) -> str:
    match = LABELLED.match(fragment.text)
    return match[0].strip(" $=") if match else ""


_WORD_LABEL = re.compile(rf"\s*(?:{'|'.join(FREQUENCY_WORDS)})\s*=(?!=)")
ACCELERATION = re.compile(r"''|\u0308|¨|\\ddot|ddot|d\s*(?:\^\{?2|²)")


def is_characteristic(fragment: Fragment) -> bool:
    """Whether an equation is one for the squares of frequencies: `ω^4 - 4 (g/l) ω^2 + 2 (g/l)^2 = 0`."""
    return (
        not LABELLED.match(fragment.text)
        and not ACCELERATION.search(fragment.text)
        and bool(_SQUARED.search(fragment.text))
    )


_SQUARED = re.compile(r"(?:\\omega|[ωλ]|omega|\\lambda)(?:_\{?\w\}?)?\s*(?:\^\s*\{?\s*[24]|²|⁴|\*\*\s*[24])")


def listed_frequencies(fragment: Fragment) -> list[Fragment]:
    """`omega_1 = ..., omega_2 = ...` in one text, each by itself; after a value there may be definitions, too.

    A value without a sign of equality has the label before it: of `omega^2 = 0, c/m` both are squares.
    """
    if word := _WORD_LABEL.match(fragment.text):
        draft = Draft(fragment)
        draft.apply([(0, word.end(), "omega = ")])
        fragment = draft.finished()
    pieces = [cut(fragment, *p) for p in cuts(fragment.text, _BETWEEN) if fragment.text[slice(*p)].strip(" $.~")]
    if not all("=" not in p.text or LABELLED.match(p.text) for p in pieces):
        return [fragment]
    label = ""
    for n, piece in enumerate(pieces):
        if match := LABELLED.match(piece.text):
            label = match[0]
        elif label and "=" not in piece.text:
            draft = Draft(piece)
            draft.apply([(0, 0, label.lstrip(" $"))])
            pieces[n] = draft.finished(latex=is_latex(fragment))
    return pieces
