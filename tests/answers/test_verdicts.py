"""Verdicts as JSON, and as exit statuses."""

from __future__ import annotations

from tests.answers.test_equations import (
    INCOMPLETE,
    TABLE,
    solved_reference,
    verdict_on,
)


def test_the_shape_of_json() -> None:
    found = verdict_on(TABLE["16"][1], solved_reference("spherical")).as_json()
    assert found["verdict"] == INCOMPLETE
    assert found["missing"] == 1
    equation = found["equations"][0]  # type: ignore[index]
    assert set(equation) == {"text", "verdict", "diagnosis", "remarks"}
    assert equation["text"] == TABLE["16"][1]
