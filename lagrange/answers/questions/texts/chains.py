"""Chains of values, `v = sqrt(2 a d) = sqrt(2*3*4) = 4.9 m/s`: whether their sides agree.

Sides that contain only parameters are numbers once these have values; without values they are expressions, which must
be equal. A decimal stands for all numbers that round to it.
"""

from __future__ import annotations

import re
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.answers.limits import MOST_IN_CHAIN
from lagrange.answers.readings import decimals_in
from lagrange.answers.references import Reference
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.answers.written.reading import tried
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import Decimal
from lagrange.core.vectors import Vector
from lagrange.expressions.edits import cut, cuts
from lagrange.expressions.reader import read_value

_SIGN = re.compile(r"(?<![<>!=:])==?(?![=>])|≈|\\approx(?![A-Za-z])")
NOT_EQUAL = "its sides are not equal to one another"


def sides_agree(fragment: Fragment, reference: Reference) -> bool | None:
    """Whether the sides of a chain that are values agree; None if there are not two of them, or it is not known."""
    places = cuts(fragment.text, _SIGN)
    if not 2 < len(places) <= MOST_IN_CHAIN:
        return None
    scope, parameters = replace(reference.scope, decimals=""), {*reference.parameters.values()}
    values: list[sp.Expr] = []
    for place in places:
        try:
            value = tried(cut(fragment, *place), scope, lambda f: read_value(f, scope, [], latex=True))
        except ProblemError:
            continue
        if not isinstance(value, Vector) and as_written(value).free_symbols <= parameters and not _is_name(value):
            values.append(value.xreplace(dict(reference.values)))
    agree = [_same(a, values[-1]) for a in values[:-1]]
    return None if not agree or None in agree else all(agree)


def _is_name(value: sp.Expr) -> bool:
    return isinstance(value, sp.Symbol) and not isinstance(value, Decimal)


def _same(a: sp.Expr, b: sp.Expr) -> bool | None:
    if decimals_in([a, b]) and numbers_rounding_to([a - b]) is not None:
        return True
    try:
        return is_zero(as_written(a - b))
    except DivisionByZeroError:
        return None
