"""Geometric constraints in one section, and systems without any."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex05-ice-skate", Rule.CONSTRAINT, "a component of the velocity vanishes"),
        (
            "pendulum-on-a-shaken-pivot",
            Rule.DEGREES_OF_FREEDOM,
            "The positions, written in these coordinates, satisfy the constraints already; none is left",
        ),
        ("damped-oscillator", Rule.DEGREES_OF_FREEDOM, "No constraint relates the coordinates"),
    ],
)
def test_what_is_said_of_constraints(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)
