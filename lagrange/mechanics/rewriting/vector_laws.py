"""Results in components compared with their formulas in vectors, before a page is written in vectors.

A particle on a surface f = 0 with ∇f = a: the constraint differentiated twice is a·r'' + D = 0, and

    λ |a|² = −m D − F·a .

Two particles joined by a massless rod of length l, otherwise free, with u = r_2 − r_1:

    T = (m_1 m_2/((m_1 + m_2) l)) (u'² + u·(F_2/m_2 − F_1/m_1)) .
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.conservation import EnergyRate


def curvature_term(configuration: Configuration) -> sp.Expr:
    """D: the terms without accelerations of the only constraint, differentiated twice."""
    [differentiated] = configuration.constrained.accelerated_constraints
    return differentiated.xreplace(dict.fromkeys(configuration.slots.accelerations, sp.S.Zero))


def is_surface_multiplier(
    multiplier: sp.Expr, configuration: Configuration, mass: sp.Expr, gradient: Sequence[sp.Expr], force: Vector
) -> bool:
    """Whether λ |a|² = −m D − F·a for the only particle."""
    squares = sp.Add(*(c**2 for c in gradient))
    along = _dot(force.components, gradient)
    return is_zero(multiplier * squares + mass * curvature_term(configuration) + along) is True


def is_tension_of_link(
    tension: sp.Expr, configuration: Configuration, forces: tuple[Vector, Vector], length: sp.Expr
) -> bool:
    """Whether this is the tension of the massless rod between the only two particles."""
    first, second = configuration.points
    apart = (second.position + first.position * -1).fixed().components
    speed = (second.velocity + first.velocity * -1).fixed().components
    (m, n), (f, g) = (first.mass, second.mass), forces
    field = (g * (1 / n) + f * (-1 / m)).components
    bracket = sp.Add(*(v**2 for v in speed)) + _dot(apart, field)
    return configuration.states.is_zero(tension * (m + n) * length - m * n * bracket) is True


def is_power(energy: EnergyRate, mass: sp.Expr, force: Vector, velocities: Sequence[sp.Expr], added: sp.Expr) -> bool:
    """Whether the energy is ½ m r'², and its rate F·r' and what is added, for a particle with r' = these velocities."""
    kinetic = mass * sp.Add(*(v**2 for v in velocities)) / 2
    if energy.rate is None or sp.expand(energy.expression - kinetic) != 0:
        return False
    return bool(sp.expand(energy.rate - _dot(force.components, velocities) - added) == 0)


def _dot(a: Sequence[sp.Expr], b: Sequence[sp.Expr]) -> sp.Expr:
    return sp.Add(*(x * y for x, y in zip(a, b, strict=True)))
