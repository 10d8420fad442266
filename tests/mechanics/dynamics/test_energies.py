"""Kinetic and potential energy as they are written by hand."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import pytest

from lagrange.document.math_writer import text
from lagrange.explain.report import report
from lagrange.mechanics.dynamics.motion import Method
from lagrange.problem.model import Problem
from tests.support.lagrange_motions import TAKEN, by_lagrange, motions

Read = Callable[[str], Problem]


BY_HAND: Mapping[tuple[str, int], tuple[str, str]] = {
    ("ex11-ideal-pendulum", 0): ("m*(x'^2 + y'^2)/2", "-m*g*y"),
    ("ex11-ideal-pendulum", 1): ("m*l^2*theta'^2/2", "-m*g*l*cos(theta)"),
    ("ex18-double-pendulum", 1): (
        "(m1 + m2)*l1^2*phi1'^2/2 + m2*l1*l2*phi1'*phi2'*cos(phi1 - phi2) + m2*l2^2*phi2'^2/2",
        "-(m1 + m2)*g*l1*cos(phi1) - m2*g*l2*cos(phi2)",
    ),
    ("heavy-top", 0): (
        "(m*l^2 + A)*(phi'^2*sin(theta)^2 + theta'^2)/2 + C*(phi'*cos(theta) + psi')^2/2",
        "m*g*l*cos(theta)",
    ),
    ("spring-pendulum", 0): ("m*(r'^2 + r^2*phi'^2)/2", "c*(r - l)^2/2 - m*g*r*cos(phi)"),
    ("sliding-ladder", 0): ("m*(x'^2 + y'^2)/2 + m*l^2*theta'^2/6", "m*g*y"),
}


@pytest.mark.parametrize(("name", "which"), BY_HAND)
def test_energies_look_as_by_hand(name: str, which: int) -> None:
    found = by_lagrange(name)
    principle = motions(found)[which].principle
    written = tuple(text(e, found.notation) for e in (principle.kinetic, principle.potential))
    assert written == BY_HAND[name, which]


def test_constant_forces_are_no_part_of_the_potential_energy(problem: Read) -> None:
    found = report(problem(TAKEN), method=Method.LAGRANGE)
    [motion] = motions(found)
    assert [text(q) for q in motion.principle.applied] == ["p_x", "Q_y*v_P"]
    assert {s.name for s in motion.principle.potential.free_symbols} == {"T", "V", "g", "m", "x", "y"}
