"""Values without a sign of equality.

Lines beside the answers to questions.

Answers to questions among the lines of a text.
"""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.values_in_text import (
    as_asked,
    is_expressions,
    not_judged,
    with_sign_after_names,
    working_beside,
)
from lagrange.core.diagnostics import Fragment
from tests.answers.test_equations import given_reference
from tests.support.shared import loaded, solved


@pytest.mark.parametrize(
    ("line", "read"),
    [
        ("range: v^2/g", "range= v^2/g"),
        ("  - range: v^2/g", "  - range= v^2/g"),
        ("range: v^2 = g", "range: v^2 = g"),
        ("The range is v^2/g.", "    range  = v^2/g "),
        ("The range is not known", "The range is not known"),
        (r"\text{range} &= v^2/g", r"       range &= v^2/g"),
        (r"\text{Range:}\quad x = v", r"\text{Range:}\quad x = v"),
        (r"t_\text{range} = v", r"         range = v"),
        (r"\text{width} = v", r"\text{width} = v"),
        ("range: v < g", "range: v < g"),
        ("width: v^2/g", "width: v^2/g"),
    ],
)
def test_the_colon_after_the_name_of_a_question_is_a_sign_of_equality(line: str, read: str) -> None:
    assert with_sign_after_names(line, {"range"}) == read
    assert len(read) == len(line)  # every place stays where it is


@pytest.mark.parametrize(
    ("text", "whether"), [(r"0, \sqrt{c/m}", True), ("F/sqrt(c)", True), ("the mass is large", False)]
)
def test_words_are_no_expressions(text: str, whether: bool) -> None:
    assert is_expressions(text) is whether


def test_expressions_alone_are_no_answer_where_only_equations_are_asked_for() -> None:
    assert as_asked([Fragment.of("m*g")], solved("ex11-ideal-pendulum")) is None


# Values beside


def test_a_line_that_another_one_defines_is_working() -> None:
    answer = [Fragment.of("m*l*theta'' = -F_t"), Fragment.of("F_t = m*g*sin(theta)")]
    found = working_beside(answer[:1], answer, given_reference("pendulum"))
    assert [f.text for f in found] == ["m*l*theta'' = -F_t"]
    assert working_beside([Fragment.of("theta'' = zz")], answer, given_reference("pendulum")) == []


def test_a_note_for_each_line() -> None:
    [note] = not_judged([Fragment.of(" x = 1 ")], "is a definition")
    assert (note.code, note.message) == ("not-judged", "`x = 1` is a definition")


# Asked in text


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("leaving-a-sphere", ["cos(theta) = 2/3"], "incomplete"),
        ("leaving-a-sphere", ["cos(theta) = 1/3"], "wrong"),
        (
            "over-the-top",
            ["sin(theta/4)^2 = 1/2 - sqrt(4*g*l - v^2)/(4*sqrt(g*l))"],
            "undecided",
        ),  # no equation of motion
        ("thrown-stone", ["range = v^2*sin(2*alpha)/g"], "incomplete"),
        ("thrown-stone", ["height = v^2*sin(alpha)^2/2 g"], "incomplete"),
        ("thrown-stone", ["height = v^2*sin(alpha)^2/3 g"], "wrong"),
        ("governor", ["omega = phi'", "omega^2 = (M + m)*g/(m*l*cos(theta))"], "equivalent"),
        ("governor", ["omega = phi'", "omega^2 = M*g/(m*l*cos(theta))"], "wrong"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict
