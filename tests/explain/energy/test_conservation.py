"""Why a quantity is conserved."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "ex11-ideal-pendulum",
            Rule.CONSERVED,
            "Every force that does work derives from a time-independent potential. Therefore ",
        ),
        ("ex14-two-particles", Rule.CONSERVED, " change neither energy, and the forces do no net work in them"),
        ("bead-in-a-turning-tube", Rule.CONSERVED, "Time appears in the positions but in neither energy, and "),
    ],
)
def test_the_reason_is_given(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)
