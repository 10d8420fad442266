"""Lines beside the answers to questions."""

from __future__ import annotations

from lagrange.answers.questions.texts.values_beside import not_judged, working_beside
from lagrange.core.diagnostics import Fragment
from tests.answers.test_equations import given_reference


def test_a_line_that_another_one_defines_is_working() -> None:
    answer = [Fragment.of("m*l*theta'' = -F_t"), Fragment.of("F_t = m*g*sin(theta)")]
    found = working_beside(answer[:1], answer, given_reference("pendulum"))
    assert [f.text for f in found] == ["m*l*theta'' = -F_t"]
    assert working_beside([Fragment.of("theta'' = zz")], answer, given_reference("pendulum")) == []


def test_a_note_for_each_line() -> None:
    [note] = not_judged([Fragment.of(" x = 1 ")], "is a definition")
    assert (note.code, note.message) == ("not-judged", "`x = 1` is a definition")
