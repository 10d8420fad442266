"""Which lines of a solution are equations, conditions, or words."""

from __future__ import annotations

import pytest

from lagrange.answers.written.lines import condition_alone, equations_of_line
from lagrange.core.diagnostics import Fragment


@pytest.mark.parametrize(
    ("line", "beside"),
    [
        ("theta = 0, stable for W < c h, theta = pi is unstable", ["stable for W < c h", "is unstable"]),
        ("theta = 0 (stable), theta = pi (unstable)", ["stable", "unstable"]),
    ],
)
def test_words_on_stability_stay_beside_their_equation(line: str, beside: list[str]) -> None:
    found = [*equations_of_line(Fragment.of(line))]
    assert [f.text.strip() for f in found] == ["theta = 0", "theta = pi"]
    assert [getattr(f, "beside", "").strip(" ,") for f in found] == beside


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        ("It stays at rest if P < mu W.", "P < mu W"),
        (r"The ladder stands as long as $\tan\theta \le 2\mu$", r"\tan\theta \le 2\mu"),
    ],
)
def test_conditions_without_words(text: str, condition: str) -> None:
    assert condition_alone(Fragment.of(text)).text.strip() == condition


@pytest.mark.parametrize(
    ("line", "equation"),
    [("s = 12 in", "s = 12 in"), ("v = 50 in/s", "v = 50 in/s"), ("s = W/k in the lowest position", "s = W/k")],
)
def test_an_inch_is_no_preposition(line: str, equation: str) -> None:
    assert [f.text.strip() for f in equations_of_line(Fragment.of(line))] == [equation]


def test_a_long_gap_is_read_in_linear_time() -> None:
    [line] = equations_of_line(Fragment.of("x'' = " + " " * 1900 + "x"))
    assert line.text.split() == ["x''", "=", "x"]
