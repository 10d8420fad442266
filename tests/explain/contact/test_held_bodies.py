"""What a page says of the forces that coordinates hold bodies with, and of supports that only push."""

from __future__ import annotations

import pytest

from lagrange.render import terminal
from tests.support import shared

SAID = {
    "cylinder-on-wedge": "The force that prevents it is M g − F sin α + N cos α in this direction; it does no virtual",
    "ball-on-a-ball": "m (g cos θ − a θ̇² − a φ̇² sin²θ) It does no virtual work and is in none of the equations above.",
    "ex01-horizontal-surface": "A support that can only push requires λ > 0 where P is on the side to which 𝐤 points",
    "ex02-fixed-surface": "requires λ > 0 where P is on the side to which ∇f points, λ < 0 where it is on the other.",
    "bead-on-rotating-hoop": "The sphere and plane constraints together keep P on a wire",
    "bifilar-suspension": "On the bar act its weight, the moment twist and",
}


def page(name: str) -> str:
    found = shared.reported(name, complete=False)
    return " ".join(terminal.text(found.derivation, found.notation, 80).split())


@pytest.mark.parametrize("name", SAID)
def test_words(name: str) -> None:
    assert SAID[name] in page(name)


@pytest.mark.parametrize("name", ["slide-off-a-dome", "turning-parabola"])
def test_what_presses_or_holds_from_both_sides_is_no_support_that_only_pushes(name: str) -> None:
    assert "can only push" not in page(name)


def test_what_a_surface_needs_is_said_once() -> None:
    found = shared.reported("slider-crank", complete=False)
    words = " ".join(terminal.text(found.derivation, found.notation, 200).split())
    assert words.count("contact lasts as long as the surface pushes") == 1
