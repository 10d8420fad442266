"""Positions in a text, and the period of a steady motion.

Virtual work as an answer about equilibrium.

The forces of two smooth supports.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.questions.equilibrium_in_text import period_as_rate, supports_of, with_rate_as_omega
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Fragment
from tests.answers.test_displacements_in_answers import PENDULUM, examiner
from tests.support.shared import reference_of, solved

NAME = "conical-pendulum"


def test_a_period_is_a_rate() -> None:
    reference = reference_of(NAME)
    phi = sp.Symbol("phi", real=True)
    assert period_as_rate(Fragment.of("T = 2*pi*sqrt(l/g)"), [phi], reference).text.split() == [
        "phi'*(",
        "2*pi*sqrt(l/g))",
        "=",
        "2*pi",
    ]
    assert period_as_rate(Fragment.of("T = 2*pi*sqrt(l/g)"), [], reference).text == "T = 2*pi*sqrt(l/g)"


def test_omega_is_the_rate_of_the_only_angle() -> None:
    reference = with_rate_as_omega(reference_of(NAME), [sp.Symbol("phi", real=True)])
    assert str(reference.scope.scalar("omega")) == "phi'"


# Virtual work


@pytest.mark.parametrize(
    ("equations", "verdict"),
    [
        (["x*delta(x) + y*delta(y) = 0"], "incomplete"),
        (["x*delta(x) + y*delta(y) = 0", "x = 0"], "equivalent"),
        (["m*g*delta(y) = 0"], "equivalent"),  # the virtual work of the weight
        (["m*g*delta(x) = 0"], "wrong"),
        (["delta(y) = l*sin(theta)*delta(theta)"], "incomplete"),
        (["m*g*l*sin(theta)*delta(theta) = 0"], "equivalent"),
        (["m*g*l*sin(2*theta)*delta(theta) = 0"], "wrong"),
        (["delta(x) = delta(x)"], "trivial"),
    ],
)
def test_virtual_work(equations: list[str], verdict: str) -> None:
    found = examiner(f"{PENDULUM}find: equilibrium\n").check(tuple(Fragment.of(e) for e in equations))
    assert found.verdict.value == verdict


# Supports


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("N_A = W/(2*cos(alpha))", Verdict.EQUIVALENT),  # both planes rise at alpha: N_A = N_B, 2 N_A cos(alpha) = W
        ("N_B*cos(alpha) + N_A*cos(alpha) = W", Verdict.EQUIVALENT),
        ("N_A = W/2", Verdict.WRONG),
        ("N_A = W/(2*sin(alpha))", Verdict.WRONG),
        ("N_B = k*W/cos(alpha)", Verdict.WRONG),
    ],
)
def test_a_force_of_a_support_of_ex_16_is_judged_and_the_other_line_left(line: str, verdict: Verdict) -> None:
    judged = supports_of([Fragment.of(line), Fragment.of("theta = 0")], solved("ex16-rod-on-two-planes"))
    assert judged is not None
    answer, rest = judged
    assert [(e.text, e.verdict) for e in answer.equations] == [(line, verdict)]
    assert answer.verdict is verdict
    assert [f.text for f in rest] == ["theta = 0"]


def test_an_answer_without_such_forces_and_a_system_without_supports_have_no_verdict() -> None:
    assert supports_of([Fragment.of("theta = 0")], solved("ex16-rod-on-two-planes")) is None
    assert supports_of([Fragment.of("N_A = W/2")], solved("roberval-balance")) is None
