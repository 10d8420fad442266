"""The value of a quantity with its unit, `x = 4.9 cm`, in a problem whose parameters have values.

The dimension of a coordinate, a parameter or a force says what a letter means that may be a unit or a name:
`x = 0.049 m` is a length, although m is a mass, and `N = 85 N` is a force. A unit of another dimension is an error.
"""

from __future__ import annotations

import re

import sympy as sp

from lagrange.answers.references import Reference
from lagrange.answers.written.notation.units import in_one_number, plain_unit
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.units import split_number, unit_of
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.values.dimensions import dimension_of_unit

_STATED = re.compile(r"[\s$]*\\?(?P<name>[^\W\d_]\w{0,12})\s*&?=\s*(?P<value>[-+−]?[0-9][^=]{0,50}?)[\s.,;$]*\Z")
_NUMBER = re.compile(r"[\s$]*[-+−]?[0-9]")


def with_value_in_si(fragment: Fragment, reference: Reference) -> Fragment:
    """`x = 4.9 cm` as x = (4.9)*(1/100); other texts as they are.

    Raises ProblemError at a unit of another dimension.
    """
    match = _STATED.match(fragment.text) if reference.values else None
    if match is None:
        return fragment
    name = "".join(GREEK.get(c, c) for c in match["name"])
    symbol = reference.scope.scalar(reference.scope.spelling(name))
    unit = "N" if is_force(symbol, reference) else reference.units.get(symbol, "")
    return _in_si(fragment, match["name"], (match.start("value"), match.end("value")), unit, reference)


def force_in_si(fragment: Fragment, reaction: Reaction, reference: Reference) -> Fragment:
    """`85 N`, stated for a reaction that is a force, as (85); other texts as they are.

    Raises ProblemError at a unit of another dimension.
    """
    if not reference.values or reaction.single is None or not _NUMBER.match(fragment.text):
        return fragment
    return _in_si(fragment, reaction.name, (0, len(fragment.text)), "N", reference)


def is_force(symbol: object, reference: Reference) -> bool:
    """Whether a symbol is that of a reaction that is a single force."""
    reactions = reference.newton.reactions if reference.newton is not None else ()
    return any(
        r.single is not None and ((r.named and symbol == r.force) or symbol == r.symbol_of_force) for r in reactions
    )


def _in_si(fragment: Fragment, name: str, place: tuple[int, int], unit: str, reference: Reference) -> Fragment:
    """The text with the number and its unit that stand at a place in SI; `unit` is one of the dimension expected."""
    written = fragment.text[slice(*place)]
    expected = dimension_of_unit(unit) if unit else None
    parts = split_number(plain_unit(written))
    meant = unit_of(parts[1]) if parts else None
    if expected is None or parts is None or meant is None or meant.is_angle:
        return fragment
    if tuple(map(sp.Integer, meant.dimension)) != tuple(expected):
        if {*re.findall(r"[A-Za-z]+", parts[1])} <= {*reference.scope.scalars} and "\\" not in written:
            return fragment
        message = f"`{parts[1]}` is no unit of `{name}`"
        raise ProblemError(Diagnostic("unit-mismatch", message, fragment.span(*place), help=f"it is in {unit}"))
    latex = is_latex(fragment)
    draft = Draft(fragment)
    draft.apply([(*place, in_one_number(parts[0], meant.factor, latex))])
    return draft.finished(latex=latex)
