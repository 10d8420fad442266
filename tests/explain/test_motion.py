"""D'Alembert's principle and the equations of motion, in words."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex11-ideal-pendulum", Rule.EQUATIONS_OF_MOTION, " is arbitrary, so its coefficient must vanish"),
        (
            "cylinder-on-rough-incline",
            Rule.EQUATIONS_OF_MOTION,
            "With multipliers instead, nothing is eliminated. The ",
        ),
        ("disc-that-rolls-steadily", Rule.EQUATIONS_OF_MOTION, "constraints on the displacements, times multipliers "),
    ],
)
def test_how_the_equations_follow(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)


def test_what_the_potential_does_is_said_where_it_joins_the_principle() -> None:
    said = said_in("spring-pendulum", Rule.PRINCIPLE)
    assert "The forces with the potential V do the virtual work −δV, where δV. Newton's law" in said


def test_the_variation_of_the_potential() -> None:
    """V = c (r − l)²/2 changes by c (r − l) δr."""
    change = solved("spring-pendulum").own.configuration.potential_variation
    values = {"c": 3, "l": 2, "r": 5, "delta(r)": 7}
    assert change.xreplace({s: sp.Integer(values[s.name]) for s in change.free_symbols}) == 63
