"""Where bodies touch."""

from __future__ import annotations

from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.contact.touching import centre_of, partials_at, point_on, velocity_at
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
