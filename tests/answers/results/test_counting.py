"""Wrong classes and numbers of degrees of freedom."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

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
