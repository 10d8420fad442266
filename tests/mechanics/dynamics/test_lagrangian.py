"""Lagrange's equations in plain SymPy, by hand."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.dynamics.lagrangian import applied_power, kinetic_energy, lagrange_equations
from tests.support.shared import solved


def test_the_pendulum_in_its_angle() -> None:
    configuration = solved("ex11-ideal-pendulum").choices[0].configuration
    found = lagrange_equations(configuration)
    [q], [v], [a] = (configuration.slots.coordinates, configuration.slots.velocities, configuration.slots.accelerations)
    m, g, length = (sp.Symbol(n, positive=True) for n in "mgl")
    assert sp.simplify(kinetic_energy(configuration) - m * length**2 * v**2 / 2) == 0
    assert sp.simplify(found.potential + m * g * length * sp.cos(q)) in (0, m * g * length)
    assert sp.simplify(found.left[0] - m * length * (length * a + g * sp.sin(q))) == 0
    assert sp.expand(applied_power(configuration) + m * g * length * v * sp.sin(q)) == 0  # that of the weight
