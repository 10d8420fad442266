"""Notes on what may not be meant."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.explain.remarks import remarks
from lagrange.mechanics.dynamics.motion import Method
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

PUSHED = """
title: Pushed
parameters: {m: positive, g: positive, beta: VALUE}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {push: {on: P, vector: m*g*FACTOR*i}}
"""


@pytest.mark.parametrize(
    ("value", "factor", "codes"),
    [("30", "cos(beta)", ["angle-in-radians"]), ("30 deg", "cos(beta)", []), ("1", "cos(beta)", []),
     ("30", "beta*cos(beta)", [])],
)  # fmt: skip
def test_a_bare_angle_of_several_turns_is_noted(value: str, factor: str, codes: list[str]) -> None:
    text = PUSHED.replace("VALUE", value).replace("FACTOR", factor)
    found = remarks(solve(read_problem(Source("pushed.yaml", text))), Method.DALEMBERT)
    assert [d.code for d in found] == codes
