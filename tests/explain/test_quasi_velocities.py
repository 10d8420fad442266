"""Quasi-velocities, in words."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("snakeboard", Rule.QUASI_VELOCITIES, "There are more degrees of freedom than quasi-velocities: "),
        ("aircraft", Rule.QUASI_VELOCITIES, "arbitrary in every virtual displacement"),
        ("aircraft", Rule.QUASI_VELOCITIES, "With these, d'Alembert's principle "),
    ],
)
def test_what_is_said_of_quasi_velocities(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
