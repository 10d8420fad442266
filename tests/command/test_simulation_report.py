"""What `lagsolve simulate` prints."""

from __future__ import annotations

from dataclasses import replace

from lagrange.core.printable import is_hidden
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


def test_a_unit_steers_no_terminal() -> None:
    made = in_numbers("ex11-ideal-pendulum", "angle")
    problem = made.states.problem
    parameters = tuple(replace(p, unit="m\x1b[2J\x9b31m\n\u202e") for p in problem.parameters)
    states = replace(made.states, problem=replace(problem, parameters=parameters))
    motion = simulated(states, made.start, 0.1)
    said = report_text(motion, 0.1, by_default=True)
    assert "m[2J31m" in said
    assert not any(map(is_hidden, said.replace("\n", "")))
