"""Vectors on a page by the unit vectors that the file names."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.builders import display, math, prose
from lagrange.document.derivation import Equation, Rule, Step
from lagrange.explain.page.vectors.directions import in_directions
from tests.support.shared import solved


def test_what_a_named_vector_is_stays_and_its_multiples_are_shorter() -> None:
    solution = solved("ex15-rough-incline")
    name, unit = next((n, v) for n, v in solution.problem.abbreviations.items() if isinstance(v, Vector))
    size = sp.Symbol("N", real=True)
    force, definition = Equation((VectorSymbol("R"), unit * size)), Equation((VectorSymbol(name), unit))
    step = Step(Rule.RESULT, "", (display(force, definition), prose("It is ", math(unit * size), ".")))
    [written] = in_directions(solution, [step])
    along = size * VectorSymbol(name)
    assert written == Step(
        Rule.RESULT, "", (display(Equation((VectorSymbol("R"), along)), definition), prose("It is ", math(along), "."))
    )
