"""The forces of two smooth supports."""

from __future__ import annotations

from lagrange.answers.questions.texts.supports import supports_of
from lagrange.core.diagnostics import Fragment
from tests.support.shared import solved


def test_a_right_and_a_wrong_force_of_ex_16() -> None:
    solution = solved("ex16-rod-on-two-planes")
    lines = [Fragment.of("N_A = W/(2*cos(alpha))"), Fragment.of("theta = 0")]
    found = supports_of(lines, solution)
    if found is not None:
        verdict, rest = found
        assert verdict.equations
        assert len(rest) <= 1
    assert supports_of([Fragment.of("theta = 0")], solution) is None
