"""Lines that state frequencies, and what has their label."""

from __future__ import annotations

import pytest

from lagrange.answers.questions.texts.frequency_labels import listed_frequencies, stated_frequencies
from lagrange.core.diagnostics import Fragment
from tests.answers.test_student_answers import verdict_on


def test_values_after_a_square_are_squares() -> None:
    texts = [f.text.strip() for f in listed_frequencies(Fragment.of("omega^2 = 0, c/m"))]
    assert texts == ["omega^2 = 0", "omega^2 = c/m"]


def test_what_other_lines_contain_is_no_frequency() -> None:
    lines = [Fragment.of(s) for s in ("omega_0^2 = g/l", "theta'' + omega_0^2*sin(theta) = 0")]
    assert not stated_frequencies(lines)


@pytest.mark.parametrize(
    ("problem", "text", "expected"),
    [
        ("triatomic-molecule", "omega^2 = 0, c/m, c/mu with mu = m M/(M + 2 m)", "equivalent"),
        ("triatomic-molecule", "omega^2 = 0, c/m, c/mu with mu = m M/(M + m)", "wrong"),
        ("bead-on-rotating-hoop", "theta = 0: omega = sqrt(g/R - Omega^2)", "incomplete"),
        ("bead-on-rotating-hoop", "theta = 0: omega = sqrt(Omega^2 - g^2/(Omega^2 R^2))", "wrong"),
    ],
)
def test_definitions_and_places_beside_frequencies(problem: str, text: str, expected: str) -> None:
    assert verdict_on(problem, ".txt", text)[0] == expected
