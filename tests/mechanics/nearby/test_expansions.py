"""Taylor series about a state."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import Slots
from lagrange.mechanics.nearby.expansions import Expansions

x, y = sp.symbols("x y", real=True)
SLOTS = Slots((x, y))


def test_values_at_a_state() -> None:
    values = {x: sp.Rational(1, 3), y: sp.Rational(2), **dict.fromkeys(SLOTS.velocities, sp.Integer(1))}
    about = Expansions(SLOTS, values)
    assert abs(float(about.number(about.value(x * y)) if False else about.value(x * y)) - 2 / 3) < 1e-15
