"""The table of a simulation.

Units of the numbers of a motion.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.programs.state_equations import StateEquations, state_equations
from lagrange.programs.tables import Units, csv_text, with_unit
from tests.programs.test_simulation import moved
from tests.support.shared import asking, in_numbers, solved


def test_the_table_has_units_in_its_header() -> None:
    lines = csv_text(moved("ex11-ideal-pendulum", 1.0, samples=11)).splitlines()
    assert lines[0] == "t (s),theta (rad),theta' (rad/s),T_rod (N),energy (J)"
    assert len(lines) == 12
    assert all(len(line.split(",")) == 5 for line in lines)


# Units


def header(states: StateEquations) -> dict[str, str]:
    """The names and units of the columns of a table."""
    units = Units(states)
    energy = {} if states.energy is None else {"energy": states.energy}
    more = {**states.reactions, **energy, **states.conserved}
    return {s.name: units.of(s) for s in states.state} | {n: units.of_column(n, e) for n, e in more.items()}


def test_an_angle_is_in_radians() -> None:
    states = in_numbers("ex11-ideal-pendulum", "angle").states
    theta, rate = states.state
    units = Units(states)
    assert (units.of(theta), units.of(rate)) == ("rad", "rad/s")
    assert with_unit("theta", "rad") == "theta (rad)"
    assert with_unit("n", "") == "n"


@pytest.mark.parametrize("name", asking("motion"))
def test_every_column_of_a_shipped_problem_that_states_units_has_one(name: str) -> None:
    solution = solved(name)
    problem = solution.problem
    if not any(p.unit for p in (*problem.parameters, *problem.coordinates)) or solution.law is None:
        return
    found = header(state_equations(solution))
    assert [n for n, unit in found.items() if not unit] == []
    assert all(unit == "J" for n, unit in found.items() if n.startswith(("energy", "jacobi")))


def test_functions_of_which_nothing_is_known_and_samples_of_them() -> None:
    states = in_numbers("shortening-pendulum").states
    named = states.with_functions({"l": 2 - sp.Symbol("t", real=True) / 10})
    assert header(named) == header(states)
    assert header(named)["T"] == "N"


def test_an_angle_needs_no_unit_of_the_file() -> None:
    found = header(in_numbers("beads-on-hoop").states)
    assert (found["theta"], found["theta'"], found["energy"]) == ("rad", "rad/s", "")
