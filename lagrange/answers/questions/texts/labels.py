"""Labels of values: the names on the left of `h_min = ...`, as they are written."""

from __future__ import annotations

import re
from collections.abc import Sequence

from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex

_LABEL = re.compile(
    r"[\s$&]*(?P<written>\\?(?P<name>[^\W\d_]+)(?:_\{?\s*(?:\\(?:text|mathrm|rm)\s*\{)?\\?(?P<index>\w{1,12})[\s}]*|(?P<digits>\d{1,2}))?)\s*(?:\([^()=]{0,20}\))?\s*&?="
)


_AT_A_PLACE = re.compile(
    r"\A(?P<name>[\s$&]*\\?[^\W\d_]\w{0,12})\s*(?:\\left\s*)?"
    r"(?:\(\s*\\?\w{1,12}\s*=\s*[^()=]{1,16}\)|\|?\s*_\s*\{\s*\\?\w{1,12}\s*=\s*[^{}=]{1,16}\})(?=\s*&?=(?!=))"
)


def without_place(fragment: Fragment) -> Fragment:
    """`N(θ=0) = ...` as N = ...: the place is that of a question."""
    draft = Draft(fragment)
    return draft.finished(latex=is_latex(fragment)) if draft.replace(_AT_A_PLACE, lambda m: m["name"]) else fragment


def label_of(fragment: Fragment) -> str:
    """The name on the left, spelled out: `theta_max` of `\\theta_{\\max} = ...`; empty if there is none."""
    match = _LABEL.match(fragment.text)
    if match is None:
        return ""
    name = "".join(GREEK.get(c, c) for c in match["name"])
    index = "".join(SUBSCRIPTS.get(c, c) for c in match["index"] or match["digits"] or "")
    return f"{name}_{index}" if index else name


def is_used_beside(fragment: Fragment, answer: Sequence[Fragment], reference: Reference) -> bool:
    """Whether the label of a line is no name of the problem and occurs in another line, which it then defines."""
    match = _LABEL.match(fragment.text)
    if match is None or label_of(fragment) in reference.declared or match["name"] in reference.declared:
        return False
    written = re.escape(match["written"].strip())
    used = re.compile(rf"(?<![A-Za-z0-9_\\]){written}(?![A-Za-z0-9_{{])")
    return any(used.search(re.sub(r"\A[^=]*=", "", f.text)) for f in answer if f is not fragment)
