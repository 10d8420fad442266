"""Most systems have no consequence of these kinds."""

from __future__ import annotations

from lagrange.mechanics.consequences.gathered import consequences
from tests.support.shared import solved


def test_a_pendulum_has_none() -> None:
    solution = solved("ex11-ideal-pendulum")
    c = consequences(solution, solution.chosen)
    assert (c.spins, c.directions, c.limits) == ((), (), ())
    assert (c.cone, c.hodograph, c.beats, c.resonance, c.sleeping) == (None,) * 5
