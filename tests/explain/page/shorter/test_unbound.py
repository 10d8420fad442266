"""No sections on freedom and displacements that nothing uses."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Rule
from lagrange.render import terminal
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "joined"),
    [
        ("band-brake", False),
        ("ladder-on-rough-ground", False),
        ("relativistic-oscillator", False),
        ("heavy-top", True),
        ("two-body-problem", True),
        ("inverted-pendulum-springs", True),
    ],
)
def test_displacements_stand_where_they_are_used(name: str, joined: bool) -> None:
    page = reported(name, complete=False).derivation.page
    rules = [s.rule for s in page if not s.folded]
    assert Rule.DISPLACEMENTS not in rules
    assert Rule.DEGREES_OF_FREEDOM not in rules
    labels = [e.label or "" for s in page for b in s.body for e in getattr(b, "equations", ())]
    assert any(label.startswith(("delta-", "rotation-")) for label in labels) is joined


@pytest.mark.parametrize("name", ["ex05-ice-skate", "ex07-constant-coefficients", "ex17-spherical-pendulum"])
def test_they_stay_where_there_is_something_to_learn(name: str) -> None:
    assert Rule.DISPLACEMENTS in [s.rule for s in reported(name, complete=False).derivation.page]


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("coupled-oscillators", "ω₁² = c/m    undamped"),
        ("coupled-oscillators", "it goes on for ever"),
        ("bead-in-a-turning-tube", "At rest in the turning system: r = a k/(k − m Ω²), stable where k > m Ω²."),
        ("loop-the-loop", "when θ = π, where 2h ≥ 5R  │"),
        ("cylinder-on-rough-incline", "the condition for rolling"),
        ("band-brake", "T₁ = M e^(μ β)/(r [e^(μ β) − 1])    at the limit"),
        ("inverted-pendulum-springs", "All forces together have the potential U = "),
    ],
)
def test_what_a_page_says(name: str, said: str) -> None:
    made = reported(name, complete=False)
    page = " ".join(terminal.text(made.derivation, made.notation, 80).split())
    assert " ".join(said.split()) in page
    assert "The friction stays" not in page
