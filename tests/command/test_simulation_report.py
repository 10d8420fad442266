"""What `lagsolve simulate` prints."""

from __future__ import annotations

from lagrange.programs.simulation import simulated
from lagsolve.simulation_report import report_text
from tests.support.shared import in_numbers


def test_the_numbers_and_both_ends() -> None:
    made = in_numbers("ex11-ideal-pendulum", "angle")
    motion = simulated(made.states, made.start, 1.0)
    said = report_text(motion, 1.0, by_default=True)
    assert "theta" in said
    assert "energy" in said
    assert max(map(len, said.splitlines())) <= 100
