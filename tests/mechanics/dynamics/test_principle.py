"""D'Alembert's principle, written out."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.dynamics.principle import dalembert, given_forces
from tests.support.shared import solved


def test_the_pendulum_in_its_angle() -> None:
    configuration = solved("ex11-ideal-pendulum").choices[0].configuration
    principle = dalembert(configuration)
    [q], [a] = configuration.slots.coordinates, configuration.slots.accelerations
    m, g, length = (sp.Symbol(n, positive=True) for n in "mgl")
    displacement = sp.Symbol(f"delta({q.name})", real=True)
    assert sp.expand(principle.statement - displacement * m * length * (length * a + g * sp.sin(q))) == 0
    assert sp.expand(principle.forces[0] + m * g * length * sp.sin(q)) == 0
    assert given_forces(configuration) == ()
