"""Why a question has no answer."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.solution import solve

STONE = """
title: Stone
parameters: [m, g, v, h]
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: -g*j
initial: {y: 0, y': v}
ask: {QUESTION}
"""


@pytest.mark.parametrize(
    ("question", "code"),
    [
        ("speed: {quantity: y'}", "not-determined"),
        ("speed: {quantity: y', when: y'' = 0}", "never-holds"),
    ],
)
def test_the_reason_has_a_code(question: str, code: str) -> None:
    with pytest.raises(ProblemError) as caught:
        solve(lagrange.loads(STONE.replace("QUESTION", question)), complete=False)
    assert [d.code for d in caught.value.diagnostics] == [code]
