"""Equations without the coordinates that constraints on velocities make dependent."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.momenta.reduced_form import only, reduced_form
from tests.support.shared import solved


def test_a_free_system_is_its_own_reduced_form() -> None:
    view = solved("ex11-ideal-pendulum").choices[0]
    assert view.motion is not None
    form = reduced_form(view.motion)
    [theta] = view.configuration.slots.coordinates
    g, length = sp.Symbol("g", positive=True), sp.Symbol("l", positive=True)
    [[mass]], [force] = form.mass, form.force
    assert sp.simplify(force / mass + g / length * sp.sin(theta)) == 0
    assert only(view.configuration, [theta]).slots.coordinates == (theta,)
