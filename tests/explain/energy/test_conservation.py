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


def test_the_energy_is_conserved_where_the_moment_vanishes() -> None:
    """The engine does no work where L = 0; resistance does in any case."""
    assert "is not conserved unless L." in said_in("governor", Rule.CONSERVED)
    assert "is not conserved. " in said_in("furuta-pendulum", Rule.CONSERVED)
    assert "unless" not in said_in("ex17-spherical-pendulum", Rule.CONSERVED)
