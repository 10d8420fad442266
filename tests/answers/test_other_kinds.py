"""Small parts of reading answers of other kinds: words in files of answers, lists of values, rare notations."""

from __future__ import annotations

import pytest

from lagrange.answers.written.lines import condition_alone, equations_of_line
from lagrange.answers.written.listed_values import with_listed_values
from lagrange.core.diagnostics import Fragment
from lagrange.problem.yaml.words import classes_in, truth_in, whole_number_in


@pytest.mark.parametrize(
    ("text", "number"),
    [("two", 2), ("f = 6 - 1 = 5", 5), ("2 degrees of freedom", 2), ("3·3 − 2", 7), ("many", None), ("2.5", None)],
)
def test_numbers_in_words(text: str, number: int | None) -> None:
    assert whole_number_in(text) == number


@pytest.mark.parametrize(
    ("text", "classes"),
    [
        ("holonomic, scleronomic", ("holonomic", "scleronomic")),
        ("non-holonomic and rheonomic", ("nonholonomic", "rheonomic")),
        ("anholonom", ("nonholonomic",)),
        ("rather holonomic", ()),
    ],
)
def test_classes_in_words(text: str, classes: tuple[str, ...]) -> None:
    assert classes_in(text) == classes


def test_yes_and_no() -> None:
    assert [truth_in(word) for word in ("yes", "No", "perhaps")] == [True, False, None]


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("theta = 0, pi", "theta = 0 or theta = pi"),
        ("θ = 0 or π, or cos θ = W/c", "θ = 0 or θ = π or cos θ = W/c"),
        ("theta = ±acos(W/c)", "theta = +acos(W/c) or theta = -acos(W/c)"),
        ("theta = {0, pi}", "theta = 0 or theta = pi"),
        ("x = 0, y = l", "x = 0, y = l"),
        ("theta = 0, as expected", "theta = 0, as expected"),
    ],
)
def test_listed_values(text: str, read: str) -> None:
    assert with_listed_values(Fragment.of(text)).text == read


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
