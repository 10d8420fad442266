"""T, V and the generalized forces, where Lagrange's method begins."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("blade-from-a-lagrangian", Rule.ENERGIES, "The Lagrangian is given. The derivation begins with it: "),
        ("oscillating-circuit", Rule.ENERGIES, "so the generalized force is"),
    ],
)
def test_what_is_said_of_the_energies(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
