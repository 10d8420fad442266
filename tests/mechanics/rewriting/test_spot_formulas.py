"""Numbers for a calculator: what matters, angles within a turn, a formula where it is short."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.rewriting.spot_formulas import acceleration_formula, values_that_matter
from tests.support.shared import solved

theta = sp.Symbol("theta", real=True)


def test_the_acceleration_of_a_pendulum() -> None:
    view = solved("ex11-ideal-pendulum").choices[0]
    [acceleration] = view.configuration.slots.accelerations
    formula = acceleration_formula(view, acceleration)
    assert formula is not None
    assert view.motion is not None
    assert sp.expand(view.motion.expressions[0].subs(acceleration, formula)) == 0
    assert acceleration_formula(solved("ex11-ideal-pendulum").own, acceleration) is None  # it keeps a constraint


def test_an_angle_is_within_a_turn_and_what_occurs_nowhere_is_left_out() -> None:
    view = solved("ex11-ideal-pendulum").choices[0]
    [q] = view.configuration.slots.coordinates
    shown = values_that_matter(view, {q: sp.Integer(7), sp.Symbol("g", positive=True): sp.Integer(10)})
    assert abs(shown[q] - (7 - 2 * sp.pi)) < 1e-5
    assert shown[sp.Symbol("g", positive=True)] == 10
    free = solved("ex11-ideal-pendulum").own
    kept = values_that_matter(free, dict.fromkeys(free.configuration.slots.coordinates, sp.Integer(7)))
    assert all(v == 7 for v in kept.values())  # lengths are no angles
