"""The value of a quantity with its unit, `x = 4.9 cm`, in a problem whose parameters have values.

The dimension of a coordinate or a parameter says what a letter means that may be a unit or a name: `x = 0.049 m` is a
length, although m is a mass. A unit of another dimension is an error.
"""

from __future__ import annotations

import re

import sympy as sp

from lagrange.answers.references import Reference
from lagrange.answers.written.notation.units import plain_unit
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.units import split_number, unit_of
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.values.dimensions import dimension_of_unit

_STATED = re.compile(r"[\s$]*\\?(?P<name>[^\W\d_]\w{0,12})\s*&?=\s*(?P<value>[-+−]?[0-9][^=]{0,50}?)[\s.,;$]*\Z")


def with_value_in_si(fragment: Fragment, reference: Reference) -> Fragment:
    """`x = 4.9 cm` as x = (4.9)*(1/100); other texts as they are.

    Raises ProblemError at a unit of another dimension.
    """
    match = _STATED.match(fragment.text) if reference.values else None
    if match is None:
        return fragment
    symbol = reference.scope.scalar(reference.scope.spelling("".join(GREEK.get(c, c) for c in match["name"])))
    expected = dimension_of_unit(unit) if (unit := reference.units.get(symbol, "")) else None
    parts = split_number(plain_unit(match["value"]))
    found = unit_of(parts[1]) if parts else None
    if expected is None or parts is None or found is None or found.is_angle:
        return fragment
    if tuple(map(sp.Integer, found.dimension)) != tuple(expected):
        if {*re.findall(r"[A-Za-z]+", parts[1])} <= {*reference.scope.scalars} and "\\" not in match["value"]:
            return fragment
        message = f"`{parts[1]}` is no unit of `{match['name']}`"
        span = fragment.span(match.start("value"), match.end("value"))
        raise ProblemError(Diagnostic("unit-mismatch", message, span, help=f"it is in {unit}"))
    latex = is_latex(fragment)
    number = f"({parts[0]})" if found.factor == 1 else f"({parts[0]})*({found.factor})"
    draft = Draft(fragment)
    draft.apply([(match.start("value"), match.end("value"), number.replace("*", r" \cdot ") if latex else number)])
    return draft.finished(latex=latex)
