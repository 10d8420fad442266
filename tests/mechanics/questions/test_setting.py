"""What is asked must be determined: mistakes have their place."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.solution import solve
from tests.mechanics.questions.test_questions import PENDULUM, WIRE, Read


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (PENDULUM + "initial: {x: l, y: l, x': 0}\nask: {it: {quantity: T, when: x = 0}}\n", "initial-contradicts"),
        (PENDULUM + "initial: {x: 0, y: l, y': 1}\nask: {it: {quantity: T, when: x = 0}}\n", "initial-contradicts"),
        (PENDULUM + 'initial: {x: l}\nask: {it: {quantity: "x\'", when: y = l}}\n', "not-determined"),
        (PENDULUM + "initial: {x: l, y: 0, y': 0}\nask: {it: {quantity: \"x'\"}}\n", "not-determined"),
        (PENDULUM + "initial: {x: l, y: 0, y': 0}\nask: {it: {quantity: \"x'\", when: y = -l}}\n", "never-holds"),
        (WIRE + "ask: {it: {quantity: t, when: r = b/2}}\n", "never-holds"),
    ],
)
def test_what_contradicts_or_is_not_determined_is_an_error_with_its_place(text: str, code: str, problem: Read) -> None:
    with pytest.raises(ProblemError) as error:
        solve(problem(text), complete=False)
    [found] = error.value.diagnostics
    assert (found.code, found.span is not None) == (code, True)
