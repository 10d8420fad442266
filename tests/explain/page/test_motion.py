"""The equations of motion as a page derives them."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("ex10-double-pendulum", Rule.EQUATIONS_OF_MOTION, "The accelerations and the virtual displacements are"),
        ("ex11-ideal-pendulum", Rule.EQUATIONS_OF_MOTION, "The acceleration and the virtual displacement are"),
        ("ex10-double-pendulum", Rule.EQUATIONS_OF_MOTION, "Written out, the principle reads"),
    ],
)
def test_kinematics_stand_before_the_equations(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)
