"""Plots and animations of a simulation."""

from __future__ import annotations

import math

import sympy as sp

from tests.api.test_motion import solved


def test_plots_and_an_animation() -> None:
    motion = solved().simulate(2.0, initial={"theta": 1.0}, samples=41)
    assert len(motion.plot().axes) == 3
    portrait = motion.phase_portrait("theta").axes[0]
    assert "theta" in portrait.get_xlabel()
    animation = motion.animate(frames=5)
    artists = animation._func(2)
    assert artists[-1].get_text().startswith("t = ")
    rod = artists[0].get_data()
    assert math.isclose(math.hypot(rod[0][1] - rod[0][0], rod[1][1] - rod[1][0]), motion.simulation.start.values[
        sp.Symbol("l", positive=True)])  # fmt: skip
    assert min(rod[1]) < 0  # it hangs down on the page
    page = animation._repr_html_()
    assert page.count("data:image/png") >= 5  # a notebook shows it by itself
