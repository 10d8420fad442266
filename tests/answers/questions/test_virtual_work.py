"""Virtual work as an answer about equilibrium."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Fragment
from tests.answers.test_displacements_in_answers import PENDULUM, examiner


@pytest.mark.parametrize(
    ("equations", "verdict"),
    [
        (["x*delta(x) + y*delta(y) = 0"], "incomplete"),
        (["x*delta(x) + y*delta(y) = 0", "x = 0"], "equivalent"),
        (["m*g*delta(y) = 0"], "equivalent"),  # the virtual work of the weight
        (["m*g*delta(x) = 0"], "wrong"),
        (["delta(y) = l*sin(theta)*delta(theta)"], "incomplete"),
        (["m*g*l*sin(theta)*delta(theta) = 0"], "equivalent"),
        (["m*g*l*sin(2*theta)*delta(theta) = 0"], "wrong"),
        (["delta(x) = delta(x)"], "trivial"),
    ],
)
def test_virtual_work(equations: list[str], verdict: str) -> None:
    found = examiner(f"{PENDULUM}find: equilibrium\n").check(tuple(Fragment.of(e) for e in equations))
    assert found.verdict.value == verdict
