"""Radii: an answer that holds for r > 0 is right, with a remark. Other coordinates may have either sign."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import lagrange
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

POLAR = """
title: A planet
parameters: [m, G, k, l, J]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {sun: {potential: -m*G/sqrt(x^2 + y^2)}}
generalized_coordinates: {polar: {coordinates: [r, phi], substitute: {x: r*cos(phi), y: r*sin(phi)}}}
"""
SPHERICAL = """
title: A weight on a spring in space
parameters: [m, k, l]
coordinates: [r, theta, phi]
frame: {type: spherical, coordinates: [r, theta, phi]}
particles: {P: {mass: m, position: r*e_r}}
forces: {spring: {spring: k, between: [P, 0*i], length: l}}
"""
ARM = """
title: A slider on an arm
parameters: [m, k, l, J]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
bodies: {arm: {inertia: J, position: 0*i, angle: phi}}
forces: {spring: {spring: k, between: [P, 0*i], length: l}}
"""
LINE = """
title: A weight that is pulled to the middle
parameters: [m, k]
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {pull: {potential: k*abs(x)}}
"""
AREA = "r*phi'' + 2*r'*phi' = 0"
WHERE = "valid where r > 0"


def verdicts(problem: Problem, *equations: str) -> tuple[str, list[str], list[list[str]]]:
    """The verdict, those on the equations, and the remarks on each."""
    found = lagrange.check(lagrange.solve(problem), list(equations))
    return (
        found.verdict,
        [e.verdict for e in found.equations.equations],
        [list(e.remarks) for e in found.equations.equations],
    )


def test_the_textbooks_attraction(problem: Read) -> None:
    verdict, _, remarks = verdicts(problem(POLAR), "r'' - r*phi'^2 = -G/r^2", AREA)
    assert verdict == "equivalent"
    assert remarks == [[WHERE], []]


def test_what_is_right_for_both_signs_has_no_remark(problem: Read) -> None:
    verdict, _, remarks = verdicts(problem(POLAR), "r'' - r*phi'^2 = -G/(r*abs(r))", AREA)
    assert verdict == "equivalent"
    assert not any(WHERE in r for r in remarks)


def test_a_radius_beside_the_old_coordinates(problem: Read) -> None:
    verdict, _, remarks = verdicts(problem(POLAR), "x'' = -G*x/r^3", "y'' = -G*y/r^3")
    assert verdict == "equivalent"
    assert remarks == [[WHERE], [WHERE]]


def test_a_wrong_sign_is_wrong_and_found(problem: Read) -> None:
    found = lagrange.check(lagrange.solve(problem(POLAR)), ["r'' - r*phi'^2 = G/r^2", AREA])
    assert found.verdict == "wrong"
    assert "the sign of the term G/r^2" in found.equations.equations[0].diagnosis
    assert "measured" not in found.equations.equations[0].diagnosis  # r is not measured backwards


def test_spherical_coordinates(problem: Read) -> None:
    verdict, _, remarks = verdicts(
        problem(SPHERICAL),
        "m*(r'' - r*theta'^2 - r*sin(theta)^2*phi'^2) = -k*(r - l)",
        "r*theta'' + 2*r'*theta' - r*phi'^2*sin(theta)*cos(theta) = 0",
        "r*phi''*sin(theta) + 2*r'*phi'*sin(theta) + 2*r*theta'*phi'*cos(theta) = 0",
    )
    assert verdict == "equivalent"
    assert remarks[0] == [WHERE]


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        (LINE, ["m*x'' = -k"]),
        (ARM, ["m*r'' - m*r*phi'^2 = -k*(r - l)", "(m*r^2 + J)*phi'' + 2*m*r*r'*phi' = 0"]),
    ],
)
def test_other_coordinates_have_both_signs(problem: Read, text: str, equations: list[str]) -> None:
    """x = −1 is another place than x = 1; on the other side of an arm with inertia the slider is elsewhere too."""
    verdict, _, remarks = verdicts(problem(text), *equations)
    assert verdict in ("wrong", "undecided")
    assert not any(WHERE in r for several in remarks for r in several)
