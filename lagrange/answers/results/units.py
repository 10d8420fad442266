"""Wrong values whose dimensions betray them: terms that cannot be added, or a length where a speed is asked for."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.core.units import unit_of_dimension
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation
from lagrange.values.dimensions import mismatch


def wrong_dimension(claim: sp.Expr, units: Mapping[sp.Symbol, str], right: sp.Expr | None = None) -> str:
    """What is wrong with the dimensions of a value, in a sentence; empty if nothing is, or that is not known.

    right  a value of the dimension that is expected
    """
    inside = mismatch([claim], units)
    if inside is not None:
        first, second = (text(e, Notation()) for e in (inside.term, inside.other))
        return (
            f"its terms have different dimensions: {first} is in {unit_of_dimension(inside.dimension)}, "
            f"{second} in {unit_of_dimension(inside.expected)}"
        )
    if right is None or claim == 0 or right == 0 or (apart := mismatch([right, claim], units)) is None:
        return ""
    if mismatch([right], units) is not None:
        return ""  # a logarithm that was parted, log(m g + c v) - log(m g), has no dimension that could be compared
    stated, expected = apart.dimension, apart.expected
    if apart.term == right:
        stated, expected = expected, stated
    given, asked = unit_of_dimension(stated), unit_of_dimension(expected)
    return f"its dimension is wrong: it is in {given}, and what is asked for is in {asked}"
