"""The coefficient of a belt between two tensions that are known, against the law T = S exp(mu beta)."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.examiner import Examiner
from lagrange.answers.friction.logarithms import in_sums
from lagrange.core.diagnostics import Fragment
from tests.support.problem_texts import read

ALONE = """title: Hawser
parameters: {A: {assume: positive}, B: {assume: positive}, n: {assume: positive}}
unknowns: [mu]
coordinates: [x]
particles: {ship: {position: x*i}}
forces: {bollard: {belt: mu, angle: 2*pi*n, tight: A, slack: B}}
find: impending
"""


@pytest.fixture(scope="module")
def alone() -> Examiner:
    return Examiner.of(read(ALONE))


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("mu = ln(A/B)/(2 pi n)", "equivalent"),
        ("2 pi n mu = ln A - ln B", "equivalent"),
        ("A = B*exp(2*pi*n*mu)", "equivalent"),
        ("mu = ln(B/A)/(2 pi n)", "wrong"),
        ("mu = ln(A/B)/(2 n)", "wrong"),
    ],
)
def test_a_belt_alone_determines_its_coefficient(alone: Examiner, answer: str, verdict: str) -> None:
    assert alone.check((Fragment.of(answer),)).verdict.value == verdict


def test_logarithms_of_ratios_are_differences() -> None:
    a, b = sp.symbols("a b", positive=True)
    assert in_sums(sp.log(a / b)) == sp.log(a) - sp.log(b)
    assert in_sums(a / b) == a / b
