"""Limits of rest that an answer states by equations."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.friction.stated_limits import _as_conditions
from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment
from tests.support.shared import loaded, solved

UPPER = "W*(sin(alpha) + mu_s*cos(alpha))/(cos(alpha) - mu_s*sin(alpha))"
LOWER = "W*(sin(alpha) - mu_s*cos(alpha))/(cos(alpha) + mu_s*sin(alpha))"


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ((f"P_min = {LOWER}", f"P_max = {UPPER}"), "equivalent"),
        ((f"P_min = {UPPER}", f"P_max = {LOWER}"), "wrong"),
        ((f"P_max = {UPPER}",), "incomplete"),
        ((f"P_min = {UPPER}",), "wrong"),
        (
            (
                r"P_{\min} = W\frac{\tan\alpha - \mu_s}{1 + \mu_s\tan\alpha}",
                r"P_{\max} = W\frac{\tan\alpha + \mu_s}{1 - \mu_s\tan\alpha}",
            ),
            "equivalent",
        ),
        ((r"P_{\max} = 2W",), "wrong"),
        ((r"F_{\max} = 2W",), "unreadable"),
    ],
)
def test_which_limit_is_which(answer: tuple[str, ...], verdict: str) -> None:
    """`P_{\\max} = 2W` was right: the program added what it took for missing, the force itself."""
    examiner = Examiner(loaded("rough-incline"), solved("rough-incline"))
    assert examiner.check(tuple(map(Fragment.of, answer))).verdict.value == verdict


def test_an_equation_without_sides_states_no_limit() -> None:
    """It ended with an IndexError (the fuzzers' seed 65910076)."""
    assert not [*_as_conditions([Fragment.of("=")], Reference.__new__(Reference))]


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        (("S = P*exp(mu*beta)", "mu = log(50)/(4*pi)"), "equivalent"),
        (("S = P*exp(mu*beta)", "mu = log(50)/(2*pi)"), "wrong"),
    ],
)
def test_each_limit_may_be_of_another_kind(answer: tuple[str, ...], verdict: str) -> None:
    examiner = Examiner(loaded("hawser-on-a-bollard"), solved("hawser-on-a-bollard"))
    assert examiner.check(tuple(map(Fragment.of, answer))).verdict.value == verdict
