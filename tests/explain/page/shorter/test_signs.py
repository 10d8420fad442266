"""Fewer minus signs on pages."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "shown", "before"),
    [
        ("rocking-plank", "it is W (R − h): stable where R > h", "−W (h − R)"),
        ("rod-on-unequal-planes", "tan θ = sin(β − α)/(2 sin α sin β)", "−sin(α − β)"),
        ("lorry-on-a-bridge", "(P + Q − B − W) δy", "−(B + W − P − Q)"),
    ],
)
def test_a_sum_takes_the_sign(name: str, shown: str, before: str) -> None:
    made = reported(name, complete=False)
    page = " ".join(terminal.text(made.derivation, made.notation, 200).split())
    assert shown in page
    assert before not in page


def test_the_root_of_a_frequency_is_last_and_the_weight_is_one_term() -> None:
    text = """
title: Pendulum on a cart
parameters: [M, m, l, c, g]
coordinates: [x, theta]
particles:
  cart: {mass: M, position: x*i}
  bob: {mass: m, position: x*i + l*sin(theta)*i + l*cos(theta)*j}
gravity: g*j
forces: {spring: {potential: c*x^2/2}}
find: [motion, linearization]
"""
    made = report(read_problem(Source("cart.yaml", text)), complete=False)
    page = " ".join(terminal.text(made.derivation, made.notation, 200).split())
    assert "ω₁² = {c l + (M + m) g − √([c l + (M + m) g]² − 4M c g l)}/(2M l)" in page


def test_forms_and_their_derivatives_stay_as_computed() -> None:
    """A table repeats the coefficients, and the test of exactness differentiates them."""
    made = reported("ex06-two-particle-skate", complete=False)
    page = terminal.text(made.derivation, made.notation, 200)
    assert "∂(y₂ − y₁)/∂y₁ = −1 ≠ 1 = ∂(x₁ − x₂)/∂x₁" in page
    assert "(y₂ − y₁) (ẋ₁ + ẋ₂) − (x₂ − x₁) (ẏ₁ + ẏ₂) = 0" in page
