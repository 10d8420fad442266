"""The equations of an answer, as they are read: text, or what is no text and needs no reading."""

from __future__ import annotations

from dataclasses import field

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import MAX_ANSWER_CHARACTERS, Scope, read_equation


@record
class Reading:
    """One equation of an answer: its two sides and its components, each zero; or why it cannot be read."""

    text: str
    components: tuple[sp.Expr, ...] = ()
    error: ProblemError | None = None
    notes: list[Diagnostic] = field(default_factory=list)
    sides: tuple[sp.Expr | Vector, ...] = ()

    @property
    def surprising(self) -> tuple[sp.Expr | Vector, ...]:
        """The two sides, where the reader may have understood something else than was meant, or meant LaTeX."""
        return self.sides if self.notes or set(self.text) & {"\\", "$"} else ()


@record
class GivenEquation(Fragment):
    """An equation of an answer that needs no reading, because it is no text."""

    reading: Reading = field(default_factory=lambda: Reading(""))

    @classmethod
    def of_reading(cls, reading: Reading, name: str) -> GivenEquation:
        """The equation of this name."""
        plain = Fragment.of(reading.text, name)
        return cls(plain.text, plain.whole, plain.start, reading)


def read_answer(fragment: Fragment, scope: Scope) -> Reading:
    """One equation of an answer. What cannot be read is part of the result, because the others still count."""
    if isinstance(fragment, GivenEquation):
        return fragment.reading
    notes: list[Diagnostic] = []
    text = fragment.text.strip()
    try:
        equation = read_equation(fragment, scope, notes, MAX_ANSWER_CHARACTERS, latex=True)
    except ProblemError as error:
        return Reading(text, error=error)
    lhs, rhs = equation.lhs, equation.rhs
    if isinstance(lhs, Vector) and isinstance(rhs, Vector):
        parts = tuple(c for c in (lhs - rhs).components if c != 0) or (sp.S.Zero,)
        return Reading(text, parts, notes=notes, sides=(lhs, rhs))
    return Reading(text, (sp.Add(lhs, -rhs),), notes=notes, sides=(lhs, rhs))
