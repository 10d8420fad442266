"""Labels of values."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.texts.labels import is_used_beside, label_of
from lagrange.core.diagnostics import Fragment
from tests.answers.test_equations import given_reference


@pytest.mark.parametrize(
    ("text", "label"),
    [
        ("h_min = 5/2*R", "h_min"),
        (r"\theta_{\max} = 1", "theta_max"),
        ("v1 = 2", "v_1"),
        ("2*x = 3", ""),
        ("N(h) = m*g", "N"),
    ],
)
def test_the_name_on_the_left(text: str, label: str) -> None:
    assert label_of(Fragment.of(text)) == label


def test_a_label_that_another_line_uses_is_a_definition() -> None:
    lines = [Fragment.of("w = sqrt(g/l)"), Fragment.of("T = 2*pi/w")]
    reference = given_reference("pendulum")
    assert is_used_beside(lines[0], lines, reference)
    assert not is_used_beside(lines[1], lines, reference)
