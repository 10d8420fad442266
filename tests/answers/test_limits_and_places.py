"""Text around values in an answer: names before a colon, brackets, units, decimals at a limit."""

from __future__ import annotations

import re

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.questions.values_in_text import is_expressions, with_sign_after_names
from lagrange.answers.submissions import answer_to
from lagrange.answers.written.lines import condition_alone
from lagrange.answers.written.notation.matrices import with_bracketed_arrays
from lagrange.answers.written.notation.numbers import in_one_number
from lagrange.core.diagnostics import Fragment, Source
from lagrange.core.symbols import Decimal
from lagrange.core.units import unit_of
from lagrange.problem.loader import read_problem
from lagrange.problem.sources import read_source
from tests.support.shared import file_of, loaded, solved


def test_a_colon_after_the_name_of_a_question_is_a_sign_of_equality() -> None:
    text = "height: v^2/(2*g)\nnote: see above\nrange: x = 2\n"
    assert with_sign_after_names(text, {"height", "range"}) == "height= v^2/(2*g)\nnote: see above\nrange: x = 2\n"


@pytest.mark.parametrize(
    ("text", "alone"),
    [
        ("0.765*sqrt(g/l) and 1.848*sqrt(g/l)", True),
        (r"0, \sqrt{c/m}", True),
        ("it swings", False),
        ("no idea", False),
        ("P <= mu*W", False),
    ],
)
def test_expressions_are_told_from_sentences(text: str, alone: bool) -> None:
    assert is_expressions(text) is alone


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("W (sinα − μ cosα) <= Q", "W (sinα − μ cosα) <= Q"),
        ("P <= mu*W (to the right)", "P <= mu*W"),
        (r"it stands if \tan\alpha \le \mu", r"\tan\alpha \le \mu"),
    ],
)
def test_a_bracket_with_a_difference_is_no_remark(text: str, kept: str) -> None:
    assert " ".join(condition_alone(Fragment.of(text)).text.split()) == kept


def test_arrays_in_brackets_keep_their_length() -> None:
    text = r"\left[\begin{array}{cc} a & b \\ c & d \end{array}\right] \left(\begin{array}{c} x \\ y \end{array}\right)"
    made = with_bracketed_arrays(text)
    assert len(made) == len(text)
    assert made.count(r"\begin{bmatrix}") == made.count(r"\end{bmatrix}") == 2


@pytest.mark.parametrize("unit", ["kN", "cm", "deg", "km/h"])
def test_no_factor_of_a_unit_counts_as_rounded(unit: str) -> None:
    found = unit_of(unit)
    assert found is not None
    written = in_one_number("30.96", found.factor, latex=False).replace("30.96", "")
    numbers = re.findall(r"[0-9]+", written)
    assert not any(map(Decimal.is_rounded, numbers))


def _with_values(problem: str, *values: str) -> Examiner:
    settings = tuple(Fragment.of(v, "--set") for v in values)
    return Examiner.of(read_problem(read_source(file_of(problem)), settings))


def test_limits_in_numbers() -> None:
    examiner = _with_values("cylinder-on-rough-incline", "mu_s=0.2")
    for text, verdict in [
        ("alpha <= 30.96 deg", "equivalent"),
        ("alpha <= 30.96°", "equivalent"),
        ("tan(alpha) <= 0.600", "equivalent"),
        ("alpha <= 0.540", "equivalent"),
        ("alpha <= 21.8°", "wrong"),
        ("alpha >= 30.96°", "wrong"),
        ("tan(alpha) <= 0.65", "wrong"),
    ]:
        assert (text, examiner.check((Fragment.of(text),)).verdict.value) == (text, verdict)


def test_a_text_file_is_read_for_what_the_problem_asks() -> None:
    examiner = Examiner(loaded("crate-tips-or-slides"), solved("crate-tips-or-slides"))
    source = Source("answer.txt", "no slip: P ≤ μ W\nno tipping: P h ≤ W b\n")
    assert examiner.check(answer_to(examiner, source, ".txt")).verdict.value == "equivalent"
