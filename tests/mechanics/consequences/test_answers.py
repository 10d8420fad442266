"""What answers and equations say beside what was asked for; each number by another route."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from lagrange.mechanics.consequences.answers import (
    closing_ratio,
    driven_momenta,
    fallen_way,
    steady_reactions,
    velocity_before,
)
from lagrange.mechanics.questions.results import Asked
from lagrange.mechanics.results import Solution
from tests.support.shared import reported

M, R, g, l, m, v = sp.symbols("M R g l m v", positive=True)


def solved(name: str) -> Solution:
    return reported(name, complete=False).solution


def asked(name: str, question: str) -> tuple[Solution, Asked]:
    solution = solved(name)
    return solution, next(a for a in solution.asked if a.question.name == question)


def test_a_particle_leaves_a_sphere_a_third_of_the_radius_below_the_top() -> None:
    """By hand: m v²/R = m g cos θ with v² = 2 g R (1 − cos θ), so cos θ = 2/3, and R (1 − cos θ) is R/3."""
    for question in ("leaves", "speed"):
        found = fallen_way(*asked("leaving-a-sphere", question))
        assert found is not None
        assert found.name == "P"
        assert sp.simplify(found.way.subs(sp.Symbol(str(R), positive=True), 3) - 1) == 0
    assert fallen_way(*asked("leaving-a-sphere", "pressure")) is None  # about no place


def test_the_bullet_has_the_velocity_that_the_angle_shows() -> None:
    found = velocity_before(*asked("ballistic-pendulum", "swing"))
    assert found is not None
    assert found.velocity == v
    values = {M: 2.0, m: 0.1, g: 9.81, l: 1.5, v: 30.0}
    # in numbers: (M + m) V = m v, and (M + m) g l (1 − cos θ) = (M + m) V²/2
    V = 0.1 * 30 / 2.1
    angle = np.arccos(1 - V**2 / (2 * 9.81 * 1.5))
    theta = next(s for s in found.value.free_symbols if s.name == "theta")
    assert float(found.value.subs({**values, theta: angle})) == pytest.approx(30)


def test_a_governor_that_runs_steadily_carries_its_sleeve() -> None:
    """The arms hold the sleeve up with M g; S is counted downwards."""
    [(force, value)] = steady_reactions(*asked("governor", "turning"))
    assert (force.name, sp.expand(value + M * g)) == ("S", 0)


def test_the_angular_momentum_of_a_governor_grows_at_the_moment() -> None:
    solution = solved("governor")
    [(q, momentum, moment)] = driven_momenta(solution.chosen)
    assert (q.name, moment.name) == ("phi", "L")
    slots = solution.chosen.configuration.slots
    rate = slots.time_derivative(momentum) - moment
    first = next(e.expression for e in solution.chosen.motion.final if e.coordinate == q)  # type: ignore[union-attr]
    assert sp.simplify(rate - first) == 0
    assert [*driven_momenta(solved("ex11-ideal-pendulum").chosen)] == []


def test_orbits_in_a_cone_close_where_a_number_is_rational() -> None:
    """V_eff = p²/(2 m r² sin²α) + m g r cos α: V_eff''/m = 3 Ω² sin²α at its minimum."""
    found = closing_ratio(solved("marble-in-a-cone").chosen)
    assert found is not None
    phi, ratio = found
    [alpha] = ratio.free_symbols
    assert phi.name == "phi"
    assert sp.simplify(ratio**2 - 3 * sp.sin(alpha) ** 2) == 0
    assert closing_ratio(solved("leaving-a-sphere").chosen) is None
