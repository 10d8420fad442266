"""Labels of values: the names on the left of `h_min = ...`, as they are written."""

from __future__ import annotations

import re
from collections.abc import Sequence

from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK, SUBSCRIPTS

_LABEL = re.compile(
    r"[\s$&]*(?P<written>\\?(?P<name>[^\W\d_]+)(?:_\{?\s*(?:\\(?:text|mathrm|rm)\s*\{)?\\?(?P<index>\w{1,12})[\s}]*|(?P<digits>\d{1,2}))?)\s*(?:\([^()=]{0,20}\))?\s*&?="
)


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
