"""Exported files, compiled and run, against the equations of the page evaluated by SymPy at random states."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.problem.model import Problem
from lagrange.programs.languages import Target
from lagrange.programs.prepared import prepared
from lagrange.programs.source import source_file
from tests.support.shared import in_numbers


def test_the_header_has_the_meaning_and_order_of_states_and_parameters() -> None:
    text = source_file(
        in_numbers("ex18-double-pendulum").states, in_numbers("ex18-double-pendulum").start, Target.PYTHON
    )
    assert "# y[2]  phi1', rate" not in text  # phi1 has no entry in the file, and nothing is made up for it
    assert "# p[2]  l1, length of the upper rod, in m (a number assumed)" in text
    assert "# Double pendulum in relative coordinates" in text
    assert "phi1_dot = y[2]" in text


def test_a_function_that_is_not_known_is_left_to_be_filled_in() -> None:
    made = in_numbers("pole-on-cart")
    text = source_file(made.states, made.start, Target.PYTHON)
    assert "def F(x1):" in text
    namespace: dict[str, object] = {}
    exec(text, namespace)
    f = namespace["f"]
    assert callable(f)
    assert any(map(math.isnan, f(0.0, [0.1, 0.2, 0.3, 0.4])))
    namespace["F"] = lambda time: 0.5 * time
    assert not any(map(math.isnan, f(0.3, [0.1, 0.2, 0.3, 0.4])))


def test_problem_has_motion() -> None:
    with pytest.raises(lagrange.ProblemError, match="no masses"):
        prepared(lagrange.loads("title: a\ncoordinates: [x, y]\nconstraints: {c: x = y}"))
    assert isinstance(in_numbers("ex18-double-pendulum").problem, Problem)
