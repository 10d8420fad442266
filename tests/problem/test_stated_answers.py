"""The answers that a file states."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Fragment
from lagrange.problem.stated_answers import without_units
from tests.support.problem_texts import ALL, places, read


def test_answers() -> None:
    answers = read(
        ALL
        + """answers:
  degrees_of_freedom: 1
  classification: [holonomic, scleronomic]
  integrable: {rod: true}
  equations: ["theta'' + g/l*sin(theta) = 0", "x'' = 0"]
  equilibrium: [["theta = 0"], ["theta = pi", "x = 0"]]
  reactions: {rod: m*g}
"""
    ).answers
    assert answers is not None
    assert (answers.degrees_of_freedom, answers.classification) == (1, ("holonomic", "scleronomic"))
    assert answers.integrable == {"rod": True}
    assert [e.text for e in answers.equations] == ["theta'' + g/l*sin(theta) = 0", "x'' = 0"]
    assert [[e.text for e in way] for way in answers.equilibrium] == [["theta = 0"], ["theta = pi", "x = 0"]]
    assert answers.reactions["rod"].text == "m*g"


def test_a_flat_list_of_equilibrium_is_one_system() -> None:
    answers = read(ALL + "answers: {equilibrium: [theta = 0, x = 0]}\n").answers
    assert answers is not None
    assert [[e.text for e in way] for way in answers.equilibrium] == [["theta = 0", "x = 0"]]
    assert places(ALL + "answers: {equilibrium: [theta = 0, [x = 0]]}\n") == [("wrong-kind", 7, 24)]


# -- Numbers with units among stated answers are read as numbers when the file is loaded -------------------------------


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("P <= 117.7 N", "P <= 117.7"),
        ("s = 12 in", "s = 12"),
        ("-2.5 kN <= P <= 117.7 N", " -2.5 <= P <= 117.7"),
        ("theta = 24.75 deg", "theta = 24.75"),
        ("P <= 3 x", "P <= 3 x"),
    ],
)
def test_a_side_that_is_a_number_with_a_unit_is_the_number(text: str, plain: str) -> None:
    assert " ".join(without_units(Fragment.of(text)).text.split()) == " ".join(plain.split())
