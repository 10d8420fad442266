"""Geometric constraints in one section, and systems without any.

Geometric constraints beside kinematic ones.

Why constraints are not integrable is folded: the page refers to it in a clause.
"""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import sympy as sp

from lagrange.document.derivation import Rule
from lagrange.mechanics.rewriting.constraint_forms import common_number
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex05-ice-skate", Rule.CONSTRAINT, "the velocity has no component along "),
        (
            "pendulum-on-a-shaken-pivot",
            Rule.STATEMENT,
            "The coordinates satisfy the constraints by themselves",
        ),
        ("damped-oscillator", Rule.STATEMENT, "No constraint relates the coordinates"),
    ],
)
def test_what_is_said_of_constraints(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)


def test_the_number_of_a_form_is_not_looked_for_among_a_million_terms() -> None:
    x, y = sp.symbols("x y")
    assert common_number(SimpleNamespace(form=(2 * x, 4 * y * (x + 1)))) == 2
    assert common_number(SimpleNamespace(form=(2 * x, 2 * sp.Mul(*(sp.Symbol(f"x{k}") + y for k in range(20)))))) == 1


# Kinematic


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


# Folding


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("struck-sleigh", Rule.CLASSIFICATION, " (Frobenius' theorem)"),
        ("blade-from-a-lagrangian", Rule.DISPLACEMENTS, " with δ in place of d/dt:"),
    ],
)
def test_integrability_is_a_clause(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)
