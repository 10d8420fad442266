"""Verdicts on values that are stated by name.

Values with units in answers.

Labels of values.

Chains of values.
"""

from __future__ import annotations

import pytest

from lagrange.answers.questions.named_values import check_each, is_used_beside, label_of, sides_agree, stated_in_numbers
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from tests.answers.test_equations import given_reference
from tests.support.shared import reference_of


def judged(name: str, fragment: Fragment) -> tuple[Verdict, str]:
    if name == "bad":
        raise ProblemError(Diagnostic("unknown-symbol", "no such name", fragment.span(0, 1)))
    return (Verdict.EQUIVALENT, "") if fragment.text == "1" else (Verdict.WRONG, "it is 1")


def test_the_worst_verdict_counts() -> None:
    stated = {"a": Fragment.of("1"), "b": Fragment.of("2")}
    found = check_each("ask", stated, judged)
    assert found.verdict is Verdict.WRONG
    assert [e.verdict for e in found.equations] == [Verdict.EQUIVALENT, Verdict.WRONG]
    unreadable = check_each("ask", {**stated, "bad": Fragment.of("?")}, judged)
    assert unreadable.verdict is Verdict.UNREADABLE
    assert [d.code for d in unreadable.unreadable] == ["unknown-symbol"]


# Numbers with units


@pytest.mark.parametrize(
    ("text", "number", "formula"),
    [
        ("v = sqrt(2*a*d) = 5.78 m/s", "v = 5.78 m/s", "v = sqrt(2*a*d)"),
        ("v = sqrt(2*a*d)", None, None),
    ],
)
def test_the_last_side_is_a_number(text: str, number: str | None, formula: str | None) -> None:
    found = stated_in_numbers(Fragment.of(text))
    if number is None:
        assert found is None
        return
    assert found is not None
    assert " ".join(found[0].text.split()) == number
    assert found[1] is not None
    assert " ".join(found[1].text.split()) == formula


# Labels


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


# Chains


@pytest.mark.parametrize(
    ("text", "agree"),
    [
        ("v = sqrt(2*g*l) = sqrt(g*l*2)", True),
        ("v = 2*g*l = 3*g*l", False),
        ("v = sqrt(2*4.5) = 3.00", True),
        ("v = sqrt(2*4.5) = 3.10", False),
        ("v = g*l", None),
    ],
)
def test_sides_that_are_values(text: str, agree: bool | None) -> None:
    assert sides_agree(Fragment.of(text), reference_of("ex11-ideal-pendulum")) is agree
