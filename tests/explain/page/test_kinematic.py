"""Geometric constraints beside kinematic ones."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex06-two-particle-skate", Rule.PFAFFIAN_FORM, ", without common factors"),
        ("ex06-two-particle-skate", Rule.INTEGRABILITY, "; by Frobenius' theorem a factor exists if and only if "),
        ("ex05-ice-skate", Rule.DISPLACEMENTS, ", and by no others."),
    ],
)
def test_forms_are_short_and_tested_in_chosen_coordinates(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)
