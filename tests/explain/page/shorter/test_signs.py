"""Fewer minus signs on pages."""

from __future__ import annotations

import pytest

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


def test_forms_and_their_derivatives_stay_as_computed() -> None:
    """A table repeats the coefficients, and the test of exactness differentiates them."""
    made = reported("ex06-two-particle-skate", complete=False)
    page = terminal.text(made.derivation, made.notation, 200)
    assert "∂(y₂ − y₁)/∂y₁ = −1 ≠ 1 = ∂(x₁ − x₂)/∂x₁" in page
    assert "(y₂ − y₁) (ẋ₁ + ẋ₂) − (x₂ − x₁) (ẏ₁ + ẏ₂) = 0" in page
