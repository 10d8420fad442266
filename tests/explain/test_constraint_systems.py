"""Constraints as a system: redundant ones, manoeuvres, Frobenius.

Constraints that are not linear in the velocities: Chetaev's rule, and why there is no finite relation.
"""

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


# Nonlinear


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "appell-hamel",
            Rule.PFAFFIAN_FORM,
            " is neither linear in the velocities nor equivalent to linear equations. It has no differential form and lies outside the ",
        ),
        ("appell-hamel", Rule.DISPLACEMENTS, " and follows from nothing above. Here it reads"),
        ("appell-hamel", Rule.INTEGRABILITY, "No plane contains them: the constraint is "),
    ],
)
def test_what_is_said_of_appell_and_hamel(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
