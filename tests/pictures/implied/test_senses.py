"""On which side of O things are drawn."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.systems import system_in_file

HOIST = """
title: Hoist
description: A drum lifts a load {words}.
parameters: [J, r, m, M, g]
coordinates: [phi, y]
bodies: {{drum: {{inertia: J, position: 0*i, angle: phi}}}}
particles: {{load: {{mass: m, position: r*i + y*j}}}}
constraints: {{rope: "y' = r*phi'"}}
gravity: -g*j
forces: {{motor: {{moment: M*k, on: drum}}}}
"""
TABLE = """
title: Two masses and a hole in a table
description: A mass m slides on a table, joined by a string to a mass M that {words}.
parameters: [m, M, g, L]
coordinates: [r, phi, z]
particles: {{slider: {{mass: m, position: r*cos(phi)*i + r*sin(phi)*j}}, other: {{mass: M, position: z*k}}}}
constraints: {{string: r - z = L}}
gravity: -g*k
"""


@pytest.mark.parametrize(
    ("text", "words", "name", "below"),
    [
        (HOIST, "that hangs on a rope", "load", True),
        (HOIST, "that stands above", "load", False),
        (TABLE, "hangs below it", "other", True),
    ],
)
def test_what_hangs_is_below_o(text: str, words: str, name: str, below: bool) -> None:
    system = system_in_file(kinematics_and_law(lagrange.loads(text.format(words=words))))
    assert system is not None
    place = next(system.pose.at(p.position) for p in system.configuration.points if p.name == name)
    assert (sum(place[1:]) < 0) is below
