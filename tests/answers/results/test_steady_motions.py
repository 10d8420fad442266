"""Wrong conditions of steady motion, each worked out from a wrong model, and the model that is named."""

from __future__ import annotations

import pytest

from lagrange.answers.readings import read_answer
from lagrange.answers.references import reference_of_solution
from lagrange.answers.results.steady_motions import explained_steady_motion
from lagrange.core.diagnostics import Fragment
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("conical-pendulum", "cos(theta) = -g/(l*phi'^2)", "for gravity that acts the other way"),
        ("conical-pendulum", "cos(theta) = g/(2*l*phi'^2)", "with twice the centrifugal terms"),
        ("marble-in-a-cone", "r = g*cos(alpha)/phi'^2", "without the factor sin(alpha) in the distance of `P`"),
        ("conical-pendulum", "cos(theta) = g/(l*phi'^2)", ""),  # it is right
        ("conical-pendulum", "theta = 0", ""),
    ],
)
def test_the_changed_problem_is_named(problem: str, stated: str, said: str) -> None:
    solution = solved(problem)
    reference = reference_of_solution(solution)
    [view] = [v for v in solution.views if v.steady is not None]
    [candidate] = [c for c in reference.candidates if c.choice == view.name]
    [condition] = read_answer(Fragment.of(stated), reference.scope).components
    assert view.steady is not None
    why = explained_steady_motion(condition, view.steady, candidate)
    assert said in why
    assert bool(said) == bool(why)
