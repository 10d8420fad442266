"""`Result.simulate`: arrays in Python."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp

import lagrange
from lagrange.core.diagnostics import ProblemError
from tests.support.shared import loaded


@cache
def solved() -> lagrange.Result:
    return lagrange.solve(loaded("ex11-ideal-pendulum"))


def test_simulate_in_python_gives_arrays() -> None:
    values = {"m": 0.5, "l": 2, "g": 10}
    motion = solved().simulate(3.0, values=values, initial={"theta": 0.5}, samples=31)
    assert motion.holds
    assert motion.t.shape == (31,)
    assert motion.y.shape == (2, 31)
    assert motion["theta"][0] == 0.5
    tension = 0.5 * (10 * np.cos(motion["theta"]) + 2 * motion["theta'"] ** 2)
    assert np.allclose(motion["T_rod"], tension)
    assert np.allclose(motion["theta''"], -5 * np.sin(motion["theta"]))
    assert np.ptp(motion.energy) < 1e-8
    assert np.allclose(motion[sp.Symbol("l") * sp.sin(sp.Symbol("theta"))], motion["x"])
    f = motion.function(sp.Symbol("theta'") ** 2)
    assert np.allclose(f(0.0, motion.y), motion["theta'"] ** 2)
    assert isinstance(f(0.0, [0.1, 3.0]), float)
    with pytest.raises(KeyError, match="theta"):
        motion["thta"]


@pytest.mark.parametrize(
    "given", [{"until": -1}, {"until": math.inf}, {"initial": {"theta": math.nan}}, {"values": {"l": math.inf}}]
)
def test_a_number_that_is_none_is_refused(given: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"and not a (positive|finite) number"):
        solved().simulate(**given)


def test_a_function_that_is_missing_is_asked_for_as_python_gives_it() -> None:
    with pytest.raises(ProblemError, match=r"functions=\{'l': \.\.\.\}"):
        lagrange.solve(loaded("shortening-pendulum")).simulate(1.0)
