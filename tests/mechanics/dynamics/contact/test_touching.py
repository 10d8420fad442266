"""Where bodies touch.

The forces of tables and floors that coordinates keep bodies on, against formulas by hand.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.contact.touching import (
    HeldBody,
    centre_of,
    held_bodies,
    partials_at,
    point_on,
    velocity_at,
)
from tests.support.shared import solved


def test_a_particle_has_one_point() -> None:
    configuration = solved("ex11-ideal-pendulum").choices[0].configuration
    elsewhere = Vector.zero()
    centre = centre_of(configuration, "P")
    assert point_on(configuration, "P", elsewhere) == centre
    assert velocity_at(configuration, "P", elsewhere) == velocity_at(configuration, "P", centre)
    assert len(partials_at(configuration, "P", elsewhere)) == 1


def test_the_point_of_contact_of_a_rolling_cylinder_is_at_rest_up_to_the_constraint() -> None:
    configuration = solved("cylinder-on-rough-incline").own.configuration
    [body] = [r.name for r in configuration.rotations]
    centre = centre_of(configuration, body)
    assert velocity_at(configuration, body, centre) == next(p.velocity for p in configuration.points if p.name == body)
    assert point_on(configuration, body, Vector.zero()) == Vector.zero()


# Held bodies


g, m, M, a, R, r, alpha = sp.symbols("g m M a R r alpha", positive=True)
theta, phi, N, F = sp.symbols("theta phi N F", real=True)
turning, going = sp.symbols("theta' phi'", real=True)

HELD = {
    # a ball on a fixed one: m g cos θ less what turns the velocity of its centre, |v|²/a
    "ball-on-a-ball": ("ball", m * g * sp.cos(theta) - m * a * (turning**2 + going**2 * sp.sin(theta) ** 2)),
    # the floor under the wedge carries it and, by the third law, what the cylinder presses
    "cylinder-on-wedge": ("wedge", M * g + N * sp.cos(alpha) - F * sp.sin(alpha)),
    "coin-on-incline": ("coin", m * g * sp.cos(alpha)),
    "cylinder-in-cylinder": ("roller", m * g * sp.cos(phi) + m * (R - r) * going**2),
}


def held(name: str) -> tuple[HeldBody, ...]:
    law = solved(name).law
    assert law is not None
    return held_bodies(law.newton)


def plain(e: sp.Expr) -> sp.Expr:
    """The same with symbols that have no assumptions."""
    return e.xreplace({s: sp.Symbol(s.name) for s in e.free_symbols})


@pytest.mark.parametrize("name", HELD)
def test_the_force_of_what_coordinates_keep_a_body_on(name: str) -> None:
    body, value = HELD[name]
    [force] = held(name)
    assert force.body == body
    assert force.value is not None
    assert sp.simplify(plain(force.value) - plain(value)) == 0


def test_the_opposite_force_acts_on_the_other_body_in_full() -> None:
    law = solved("cylinder-on-wedge").law
    assert law is not None
    assert law.newton.bodies is not None
    wedge, cylinder = law.newton.bodies
    for reaction, direction in wedge.reactions:
        [opposite] = [d for r, d in cylinder.reactions if r.name == reaction.name]
        assert (direction + opposite).is_zero


@pytest.mark.parametrize("name", ["ex11-ideal-pendulum", "hoop-on-incline", "ex18-double-pendulum"])
def test_nothing_holds_what_can_be_placed_anywhere(name: str) -> None:
    assert held(name) == ()


def test_a_field_may_press_too() -> None:
    """Of a spring only the part along which P can be placed is known."""
    [force] = held("bead-in-a-turning-tube")
    assert force.value is None
