"""Friction at rest: bounds, indeterminate forces, belts."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "block-held-over-a-drum",
            Rule.FRICTION_AT_REST,
            " is not determined: the system is statically indeterminate. It can be at rest if ",
        ),
        ("band-brake", Rule.FRICTION_AT_REST, " runs over a rough drum and touches it over the angle "),
        (
            "cylinder-on-rough-incline",
            Rule.FRICTION_AT_REST,
            ", which acts at the point that touches, is at most the coefficient of static friction times the normal force of ",
        ),
    ],
)
def test_what_is_said_of_friction_at_rest(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
