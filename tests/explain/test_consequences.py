"""The sentences about consequences of the equations of motion."""

from __future__ import annotations

import pytest

from lagrange.render import terminal
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("spring-pendulum", "If c l = 3m g, that is its own frequency"),
        ("ballistic-curve", "m g du = v D(v) dψ"),
        ("ball-on-a-ball", "if b² n² > 35a g"),
        ("charge-and-monopole", "lies on a cone about"),
        ("appell-hamel", "the path is a straight line"),
        ("kapitza-pendulum", "unstable without the drive, is stable on average if a² Ω² > 2g l"),
        ("shortening-pendulum", "have, to leading order, an amplitude proportional to 1/l^(3/4)"),
        ("penning-trap", "x and y stay bounded, if B² q² > 2m² w²; otherwise x and y in general grow"),
        ("drawbridge", "it is zero in every position if, by the constraint"),
    ],
)
def test_a_page_says_it(name: str, sentence: str) -> None:
    made = reported(name, complete=False)
    page = " ".join(terminal.text(made.derivation, made.notation, 100).split())
    assert sentence in page
