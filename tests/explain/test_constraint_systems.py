"""Constraints as a system: redundant ones, manoeuvres, Frobenius."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "contact-form-with-fixed-slope",
            Rule.INTEGRABILITY,
            "Here all of them do: by Frobenius' theorem the constraints are equivalent to ",
        ),
        (
            "three-wheels-in-line",
            Rule.CLASSIFICATION,
            " is redundant: it follows from the preceding ones and is not counted.",
        ),
        (
            "ex05-ice-skate",
            Rule.INTEGRABILITY,
            "Yet the system can get where no single step leads: with a small ",
        ),
    ],
)
def test_what_is_said_of_several_constraints(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
