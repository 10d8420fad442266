"""Why constraints are not integrable is folded: the page refers to it in a clause."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("struck-sleigh", Rule.CLASSIFICATION, " (Frobenius' theorem)"),
        ("blade-from-a-lagrangian", Rule.DISPLACEMENTS, " with δ in place of d/dt:"),
    ],
)
def test_integrability_is_a_clause(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule, on_page=True)
