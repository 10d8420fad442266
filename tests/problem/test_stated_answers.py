"""The answers that a file states."""

from __future__ import annotations

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
