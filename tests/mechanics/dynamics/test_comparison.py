"""Do two systems of equations have the same solutions?"""

from __future__ import annotations

from lagrange.mechanics.dynamics.comparison import System, compare
from tests.mechanics.constraints.test_rigid_bodies import solution_of


def test_a_triad_that_does_not_spin_gives_the_same_equations() -> None:
    one, other = solution_of("heavy_top"), solution_of("heavy_top_without_spin")
    result = compare(other.own.motion.expressions, System(one.own.configuration, one.own.motion.expressions))
    assert result is not None
    assert result.agree
