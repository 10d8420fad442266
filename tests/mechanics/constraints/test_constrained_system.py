"""Coordinates and constraints as one value."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import Slots
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem, Row, is_pfaffian

x, y, theta = sp.symbols("x y theta", real=True)
SLOTS = Slots((x, y, theta))
BLADE = Row("blade", (sp.sin(theta), -sp.cos(theta), sp.S.Zero), sp.S.Zero)
CIRCLE = Row("circle", (2 * x, 2 * y, sp.S.Zero), sp.S.Zero, finite=x**2 + y**2 - 1)


def test_rank_and_surface() -> None:
    system = ConstrainedSystem(SLOTS, (BLADE, CIRCLE))
    assert (system.size, system.rank) == (3, 2)
    assert system.finite_constraints == (x**2 + y**2 - 1,)
    assert system.is_pfaffian
    assert system.without(["circle"]).rows == (BLADE,)
    assert system.with_rows([CIRCLE]).rows == (CIRCLE,)


def test_a_constraint_that_is_not_linear_in_the_velocities() -> None:
    u, v, _ = SLOTS.velocities
    row = Row.by_chetaev("speed", u**2 + v**2 - 1, SLOTS)
    assert row.coefficients == (2 * u, 2 * v, 0)
    assert not is_pfaffian([BLADE, row])
    assert BLADE.velocity_form(SLOTS) == u * sp.sin(theta) - v * sp.cos(theta)
