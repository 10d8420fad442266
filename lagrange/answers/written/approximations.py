r"""Numbers beside exact results, and the letters of the parts of a question: what does not belong to an equation.

cos(theta) = 2/3, i.e. theta ≈ 48.2°            cos(theta) = 2/3
\cos\theta = \frac23 \Rightarrow \theta \approx 48{,}2^\circ
theta ≈ 48.2°                                   theta = 48.2°, where there is no other sign of equality
(a) v = ...                                     v = ..., where another line begins with (b)
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from lagrange.answers.written.notation.special import signs_as_indices
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import ABOUT
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import OneEquation, is_latex

_ABOUT = re.compile(rf"{ABOUT}|~=")
_EQUALS = re.compile(r"(?<![<>!:])==?(?![=>])")
_JOINT = re.compile(
    r"[,;]|⇒|⟹|→|==?>|-->?|\\(?:Rightarrow|Longrightarrow|implies|to|rightarrow|q?quad|therefore)(?![A-Za-z])"
    r"|(?<![\w\\])(?:i\.?\s?e\.|d\.\s?h\.|or|so|thus|hence|that is|also|somit|bzw\.|soit|donc)(?!\w)"
)
_ALONE = re.compile(
    rf"(?P<left>[^=<>≤≥≈+]{{0,60}}[\w)}}'])\s*(?P<about>{ABOUT}|~=)"
    r"\s*[-+−]?\s*[0-9]{1,9}\.[0-9]{1,9}[^=≈<>]{0,30}\Z"
)
_PART = re.compile(r"[\s$]*\(\s*(?:(?P<letter>[a-h])|(?P<roman>[ivx]{1,4}))\s*\)\s*(?=[^\s=)*/^+])")
_ROMAN = ("i", "ii", "iii", "iv", "v", "vi", "vii", "viii")


def is_about(line: str) -> bool:
    """Whether a line gives a number with decimals by `≈` alone."""
    return "=" not in _ABOUT.sub(" ", line) and _ALONE.search(line.strip(" $.,;\r")) is not None


def with_equality(fragment: Fragment) -> Fragment:
    """`theta ≈ 48.2°` as an equation; the fragment itself if it has another sign of equality."""
    if not is_about(fragment.text):
        return fragment
    draft = Draft(fragment)
    draft.replace(_ABOUT, "=")
    return draft.finished(latex=is_latex(fragment))


def exact_results(answer: Sequence[Fragment]) -> tuple[Fragment, ...]:
    """The equations without what stands beside them: letters of parts, and numbers after exact results."""
    numbered = _parts_numbered([f.text for f in answer])
    return tuple(_alone(f, parts=numbered) for f in answer)


def _alone(fragment: Fragment, *, parts: bool) -> Fragment:
    draft = Draft(fragment)
    signs_as_indices(draft)
    fragment = _finished(draft, fragment)
    text = fragment.text
    start = match.end() if parts and (match := _PART.match(text)) else 0
    return _kept(fragment, start, _end(text))


def _end(text: str) -> int:
    """Where the equation ends, after which another quantity is given approximately."""
    signs = [*_EQUALS.finditer(text)]
    about = _ABOUT.search(text, signs[-1].end()) if signs else None
    if about is None:
        return len(text)
    joints = [m.start() for m in _JOINT.finditer(text, signs[-1].end(), about.start())]
    return next((at for at in joints if text[signs[-1].end() : at].strip()), len(text))


def _parts_numbered(texts: Sequence[str]) -> bool:
    """Whether two lines begin with letters that follow one another."""
    numbered = [m for text in texts if (m := _PART.match(text))]
    letters = {ord(m["letter"]) for m in numbered if m["letter"]}
    romans = {_ROMAN.index(m["roman"]) for m in numbered if m["roman"] in _ROMAN}
    return any(n + 1 in numbers for numbers in (letters, romans) for n in numbers)


def _kept(fragment: Fragment, start: int, end: int) -> Fragment:
    if (start, end) == (0, len(fragment.text)):
        return fragment
    draft = Draft(fragment)
    draft.keep(start, end)
    return _finished(draft, fragment)


def _finished(draft: Draft, fragment: Fragment) -> Fragment:
    if draft.text == fragment.text:
        return fragment
    made = draft.finished(latex=is_latex(fragment))
    return replace(made, beside=getattr(fragment, "beside", "")) if isinstance(made, OneEquation) else made
