"""A problem as data."""

from __future__ import annotations

from tests.support.shared import loaded


def test_the_pendulum() -> None:
    problem = loaded("ex11-ideal-pendulum")
    x, y = problem.slots.coordinates
    [rod] = problem.constraints
    length = next(p.symbol for p in problem.parameters if p.symbol.name == "l")
    assert rod.function == x**2 + y**2 - length**2
    assert (problem.geometric, problem.kinematic) == ((rod,), ())
    assert [m.name for m in problem.masses] == ["P"]


def test_a_skate_has_a_kinematic_constraint() -> None:
    problem = loaded("ex05-ice-skate")
    assert len(problem.kinematic) == 1
    assert problem.geometric == ()
