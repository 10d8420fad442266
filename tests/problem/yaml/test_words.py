"""Words and numbers that YAML reads as something else."""

from __future__ import annotations

import pytest

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
