"""What follows from equations of motion, and what does not."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import prime
from lagrange.mechanics.consequences.along import is_short, vanish_along
from tests.support.shared import solved


def test_a_pendulums_equation_follows_and_another_does_not() -> None:
    view = solved("ex11-ideal-pendulum").chosen
    assert view.motion is not None
    assert is_short(view.motion)
    [theta] = view.configuration.slots.coordinates
    l, g = (next(s for s in view.motion.expressions[0].free_symbols if s.name == n) for n in "lg")
    assert vanish_along(view.motion, [l * prime(theta, 2) + g * sp.sin(theta)])
    assert not vanish_along(view.motion, [l * prime(theta, 2) + g * theta])
