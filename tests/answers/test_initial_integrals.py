"""Statements that hold for the motion from the initial state alone."""

from __future__ import annotations

from lagrange.answers.recognition import relation_from_start
from tests.support.shared import solved


def test_the_energy_from_the_start() -> None:
    solution = solved("leaving-a-sphere")
    relations = [relation_from_start(solution, v) for v in solution.views]
    known = [r for r in relations if r is not None]
    assert known
    for relation, view in zip(relations, solution.views, strict=True):
        assert relation is None or relation.free_symbols & {*view.configuration.slots.velocities}


def test_without_an_initial_state_there_is_none() -> None:
    solution = solved("ex11-ideal-pendulum")
    assert relation_from_start(solution, solution.own) is None
