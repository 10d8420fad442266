"""Formulas in vectors are those of the components, and a wrong one is refused."""

from __future__ import annotations

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.conservation import EnergyRate
from lagrange.mechanics.rewriting.vector_laws import (
    curvature_term,
    is_power,
    is_surface_multiplier,
    is_tension_of_link,
)
from tests.support.shared import solved

g, m = sp.symbols("g m", positive=True)


def test_the_multiplier_of_a_particle_on_a_surface() -> None:
    """z = f(x, y) under its weight: λ |a|² = −m D − F·a, and no other multiple of it."""
    solution = solved("ex12-smooth-surface")
    own, law = solution.own, solution.law
    assert own.dynamics is not None
    assert own.dynamics.reactions is not None
    assert law is not None
    [row], [point] = own.configuration.rows, own.configuration.points
    [value] = own.dynamics.reactions.multipliers.values()
    force = sum((f.vector for f in law.configuration.loads), Vector.zero())
    assert value is not None
    assert is_surface_multiplier(value, own.configuration, point.mass, row.coefficients, force)
    assert not is_surface_multiplier(2 * value, own.configuration, point.mass, row.coefficients, force)
    assert not {*own.configuration.slots.accelerations} & curvature_term(own.configuration).free_symbols


def test_the_tension_of_a_link() -> None:
    own = solved("ex14-two-particles").own
    first, second = own.configuration.points
    assert own.dynamics is not None
    assert own.dynamics.reactions is not None
    [tension] = own.dynamics.reactions.sizes.values()
    loads = own.configuration.loads
    at_first, at_second = (
        sum((f.vector for f in loads if f.on == p.name), Vector.zero()).fixed() for p in (first, second)
    )
    length = next(s for s in own.configuration.rows[0].finite.free_symbols if s.name == "l")  # type: ignore[union-attr]
    assert tension is not None
    assert is_tension_of_link(tension, own.configuration, (at_first, at_second), length)
    assert not is_tension_of_link(-tension, own.configuration, (at_first, at_second), length)


def test_the_rate_of_the_energy_is_a_power() -> None:
    vx, vy = sp.symbols("x' y'", real=True)
    energy = EnergyRate(m * (vx**2 + vy**2) / 2, -m * g * vy)
    weight = Vector((sp.S.Zero, -m * g, sp.S.Zero))
    speeds = (vx, vy, sp.S.Zero)
    assert is_power(energy, m, weight, speeds, sp.S.Zero)
    assert not is_power(energy, m, weight, speeds, vx)
    assert not is_power(energy, 2 * m, weight, speeds, sp.S.Zero)
