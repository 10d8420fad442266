"""Values with units in answers."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.numbers_with_units import stated_in_numbers
from lagrange.core.diagnostics import Fragment


@pytest.mark.parametrize(
    ("text", "number", "formula"),
    [
        ("v = sqrt(2*a*d) = 5.78 m/s", "v = 5.78 m/s", "v = sqrt(2*a*d)"),
        ("v = sqrt(2*a*d)", None, None),
    ],
)
def test_the_last_side_is_a_number(text: str, number: str | None, formula: str | None) -> None:
    found = stated_in_numbers(Fragment.of(text))
    if number is None:
        assert found is None
        return
    assert found is not None
    assert " ".join(found[0].text.split()) == number
    assert found[1] is not None
    assert " ".join(found[1].text.split()) == formula
