"""Bodies introduced together."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("three-struck-rods", Rule.STATEMENT, "The bodies are rigid: "),
        ("furuta-pendulum", Rule.STATEMENT, "The applied moments are"),
    ],
)
def test_bodies_are_introduced_together(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)
