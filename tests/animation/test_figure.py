"""The figure of a web page: what moves, and why something stays still."""

from __future__ import annotations

from lagrange.animation.figure import Still
from lagrange.animation.moving import moving_figure
from tests.support.shared import reported


def test_what_cannot_be_drawn_stays_still_and_says_why():
    still = moving_figure(reported("form-in-two-variables", complete=False).solution)
    assert isinstance(still, Still)
    assert still.reason
