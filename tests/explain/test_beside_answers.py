"""What answers and equations say beside what was asked for, in words."""

from __future__ import annotations

import pytest

from lagrange.render import terminal
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("leaving-a-sphere", "P has then fallen by R/3."),
        ("ballistic-pendulum", "v = 2 (M + m) √(g l) |sin(θ/2)|/m"),
        ("governor", "In such a state S = −M g, whatever θ is."),
        ("governor", "d/dt [(J + 2m l² sin²θ) φ̇] = L"),
        ("marble-in-a-cone", "Closed orbits: ω/|φ̇| = √3 sin α."),
    ],
)
def test_a_page_says(name: str, said: str) -> None:
    r = reported(name, complete=False)
    words = " ".join(terminal.text(r.derivation, r.notation, 100).split())
    assert words.count(said) == 1
