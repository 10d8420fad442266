"""Equations that a Python program has made with SymPy, as an answer to be judged.

They are read without going through text: in the symbols of the problem, or in functions of time with `Derivative`
(`time_functions`). Texts may stand among them.
"""

from __future__ import annotations

from lagrange.answers.answer_readings import GivenEquation, Reading
from lagrange.api.time_functions import Reader, flattened
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation
from lagrange.expressions.scope import Scope


def answer_of(equations: object, scope: Scope, notation: Notation) -> tuple[Fragment, ...]:
    """An answer from texts and SymPy's equations, or lists and matrices of them; an expression is one that vanishes."""
    parts = enumerate(flattened(equations), start=1)
    return tuple(_fragment(e, f"equation {n}", scope, notation) for n, e in parts)


def _fragment(equation: object, name: str, scope: Scope, notation: Notation) -> Fragment:
    if isinstance(equation, str):
        return Fragment.of(equation, name)
    try:
        lhs, rhs = Reader(scope).equation(equation)
    except ProblemError as error:
        return GivenEquation.of_reading(Reading(str(equation), error=error), name)
    written = f"{text(lhs, notation)} = {text(rhs, notation)}"
    return GivenEquation.of_reading(Reading(written, (lhs - rhs,)), name)
