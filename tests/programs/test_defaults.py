"""Numbers that nobody has given.

Functions that nobody has given.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.programs.defaults import angles_in
from lagrange.programs.prepared import prepared, require_functions
from lagrange.programs.simulation import simulated
from tests.support.shared import loaded


def test_angles_are_what_is_turned():
    a, b, c = sp.symbols("a b c", real=True)
    assert angles_in([sp.sin(2 * a + b) * c]) == {a, b}


# Samples


def test_functions_that_nobody_has_given_are_taken_from_samples() -> None:
    made = prepared(loaded("pole-on-cart"), complete=True)
    assert set(made.sampled) == {"F"}
    assert simulated(made.states, made.start, 1.0).is_accurate
    bowl = prepared(loaded("ex12-smooth-surface"), complete=True)
    assert bowl.sampled["f"] == sp.sympify("Z - (X**2 + Y**2)/4", {n: sp.Symbol(n, real=True) for n in "XYZ"})
    left = prepared(loaded("pole-on-cart")).states
    assert left.functions == ("F",)  # an exported file leaves it open, and Python has to give it
    with pytest.raises(ProblemError, match="the motion depends on F"):
        require_functions(left, {})
