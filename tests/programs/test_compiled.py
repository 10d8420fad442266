"""Expressions as Python functions."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import t
from lagrange.programs.compiled import compiled, compiled_text
from lagrange.programs.straight_line import straight_line

x, y = sp.symbols("x y", real=True)
k = sp.Symbol("k", positive=True)


def test_a_function_of_time_and_state() -> None:
    outputs = [k * sp.sin(x) + t, (x + y) ** 2 * (x + y)]
    for program in (outputs, straight_line(outputs)):
        found = compiled([x, y], program, {k: 3.0})(0.5, 1.2, 0.3)
        expected = [float(e.subs({k: 3, x: 1.2, y: 0.3, t: 0.5})) for e in outputs]
        assert list(found) == pytest.approx(expected)


def test_a_text_that_the_program_has_written() -> None:
    assert compiled_text("def double(x):\n    return 2*x\n", "double")(4) == 8
