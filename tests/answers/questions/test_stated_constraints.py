"""Answers about constraints.

Degrees of freedom and classes of constraints in words.
"""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.stated_constraints import about_constraints, stated_in_words
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved

NAME = "rolling-coin"


def test_a_problem_that_asks_for_constraints_alone() -> None:
    assert not about_constraints(solved("ex11-ideal-pendulum"))
    assert not about_constraints(None)


@pytest.mark.parametrize(("text", "verdict"), [("x*dx + y*dy = 0", "incomplete"), ("x*dy + y*dx = 0", "wrong")])
def test_forms_of_a_pendulum(text: str, verdict: str) -> None:
    examiner = Examiner(loaded("ex11-ideal-pendulum"), solved("ex11-ideal-pendulum"))
    assert examiner.check((Fragment.of(text),)).verdict.value == verdict


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("x - x0 = R*(phi - phi0)", "equivalent"),
        ("x = R*phi + x_0 - R*phi_0", "equivalent"),
        ("x - x0 = 2*R*(phi - phi0)", "wrong"),
        ("x + x0 = R*(phi + phi0)", "unreadable"),  # it does not hold at the start
        ("x - x0 = R*phi*phi0 - R*phi0^2", "unreadable"),
    ],
)
def test_constants_of_integration_are_initial_values(text: str, verdict: str) -> None:
    examiner = Examiner(loaded("wheel-on-a-line"), solved("wheel-on-a-line"))
    assert examiner.check((Fragment.of(text),)).verdict.value == verdict


# In words


@pytest.mark.parametrize(
    ("text", "freedom", "classes"),
    [
        ("Degrees of freedom: 6 - 1 = 5", 5, ()),
        ("x^2 + y^2 = l^2\nDOF = 1, holonomic", 1, ("holonomic",)),
        ("It has two degrees of freedom and is not holonomic", 2, ("nonholonomic",)),
        (r"\( f=6-1=5 \), scleronomic", 5, ("scleronomic",)),
        ("Zahl der Freiheitsgrade: 5, anholonom, rheonom", 5, ("nonholonomic", "rheonomic")),
        ("m x'' + k x = 0", None, ()),
    ],
)
def test_freedom_and_classes_in_words(text: str, freedom: int | None, classes: tuple[str, ...]) -> None:
    stated = stated_in_words(text)
    assert (stated.degrees_of_freedom, stated.classification) == (freedom, classes)
