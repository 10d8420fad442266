"""Equations without the coordinates that constraints on velocities make dependent."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.momenta.reduced_form import independent_first, only, reduced_form
from lagrange.mechanics.solution import solve
from tests.support.problem_texts import read
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


COIN = """title: T
coordinates: [x, y, phi, theta, psi]
parameters: [m, R]
bodies:
  coin: {mass: m, inertia: [m*R^2/4, m*R^2/4, m*R^2/2], position: x*i + y*j + R*sin(theta)*k,
         orientation: {axes: 313, angles: [phi, theta, psi]}}
constraints:
  along: "x'*cos(phi) + y'*sin(phi) + R*(psi' + phi'*cos(theta)) = 0"
  across: "-x'*sin(phi) + y'*cos(phi) + R*theta'*sin(theta) = 0"
"""


def test_the_place_of_a_coin_depends_on_its_heading_and_spin() -> None:
    """With x' and the heading independent, rolling in a circle would be no steady motion."""
    motion = solve(read(COIN)).own.motion
    assert motion is not None
    names = [q.name for q in motion.configuration.slots.coordinates]
    assert {names[k] for k in independent_first(motion).dependent} == {"x", "y"}
