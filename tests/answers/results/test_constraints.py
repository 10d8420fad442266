"""Wrong equations for constraints: the change that makes them right.

Wrong classes and numbers of degrees of freedom.
"""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained
from tests.answers.test_student_answers import verdict_on


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ("x' cosθ - y' sinθ = 0", "sine and cosine of theta exchanged"),
        ("x' sinθ + y' cosθ = 0", "the sign of the term"),
        ("y' sinθ - x' cosθ = 0", "exchanged"),
        ("2 x' sinθ - y' cosθ = 0", "in place of"),
        ("x' = y'", "the constraints do not require it"),
    ],
)
def test_one_change_is_named(stated: str, said: str) -> None:
    verdict, details = verdict_on("ex05-ice-skate", ".txt", stated)
    assert verdict == "wrong"
    assert any(said in line for line in details), details


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("two-wheels-on-an-axle", "x'*cos(theta) + y'*sin(theta) = R*phi1'", "the term b*theta' is missing"),
        ("two-wheels-on-an-axle", "dx*cos(theta) + dy*sin(theta) = R*dphi1", "the term b*d(theta) is missing"),
        ("two-wheels-on-an-axle", "b*theta = R*(phi1 - phi2)", "2*b*theta in place of b*theta"),
        ("differential-hoist", "y' = R*phi'", "the term a*psi' is missing"),
    ],
)
def test_a_missing_term_or_a_factor_of_an_integral_is_named(problem: str, stated: str, said: str) -> None:
    verdict, details = verdict_on(problem, ".txt", stated)
    assert verdict == "wrong"
    assert any(said in line for line in details), details


# Counting


WRONG: list[Row] = [
    ("rolling-coin", "classification", ["holonomic"], "`no_slip.1` and `no_slip.2` cannot be integrated"),
    ("sphere-in-disguise", "classification", ["nonholonomic"], "`law` can be integrated"),
    ("skate-on-a-turntable", "classification", ["rheonomic"], "neither in a constraint nor in a position"),
    ("two-wheels-on-an-axle", "integrable", {"right_wheel": True}, "`right_wheel` fails Frobenius' test"),
    ("two-wheels-on-an-axle", "degrees_of_freedom", 1, "is not subtracted once more"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_classes_and_degrees_of_freedom(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
