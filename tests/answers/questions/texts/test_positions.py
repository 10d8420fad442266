"""Positions in a text, and the period of a steady motion."""

from __future__ import annotations

import sympy as sp

from lagrange.answers.questions.texts.positions import period_as_rate, with_rate_as_omega
from lagrange.core.diagnostics import Fragment
from tests.support.shared import reference_of

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
