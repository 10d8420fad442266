"""Numbers with units among stated answers: `P <= 117.7 N`, `s = 12 in`, `theta = 24.75 deg`.

An answer is read when the file is loaded, so that its mistakes are reported with the others; what the unit means is
known only when the answer is judged, by the dimension of what it is compared with. So the number stands for it here.
"""

from __future__ import annotations

import re

from lagrange.core.diagnostics import Fragment
from lagrange.core.units import split_number, unit_of
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import OneEquation, is_latex

_SIDE = re.compile(r"[^=<>≤≥⩽⩾]+")


def without_units(fragment: Fragment) -> Fragment:
    """The text with each side that is a number with a known unit as the number alone."""
    if is_latex(fragment) or isinstance(fragment, OneEquation):
        return fragment
    draft = Draft(fragment)
    for side in [*_SIDE.finditer(fragment.text)][::-1]:
        text = side[0].rstrip()
        parts = split_number(text)
        if parts is not None and unit_of(parts[1]) is not None:
            draft.apply([(side.start(), side.start() + len(text), f" {parts[0]}")])
    return draft.finished(latex=False) if draft.text != fragment.text else fragment
