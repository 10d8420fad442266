"""What coordinates measure: angles of lines between points, from which axis and in which sense; the mass centre."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.mechanics.constraints.measures import angles, of_mass_centre
from lagrange.problem.loader import read_problem
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "choice", "found"),
    [
        ("ex11-ideal-pendulum", 0, [("theta", "", "P", (0, 1, 0), (1, 0, 0), None)]),
        (
            "ex18-double-pendulum",
            0,
            [("phi1", "", "P1", (0, 1, 0), (1, 0, 0), None), ("phi2", "P1", "P2", (0, 1, 0), (1, 0, 0), None)],
        ),
        (
            "ex04-dumbbell",
            0,
            [("phi", "P1", "P2", (1, 0, 0), (0, 1, 0), (0, 0, 1)), ("theta", "P1", "P2", (0, 0, 1), None, None)],
        ),
        ("ball-on-a-string", 0, [("phi", "", "ball", (0, -1, 0), (1, 0, 0), None)]),
    ],
)
def test_angles(name: str, choice: int, found: list[tuple[object, ...]]) -> None:
    configuration = reported(name, complete=False).solution.choices[choice].configuration
    measured = [
        (
            a.symbol.name,
            a.start,
            a.end,
            a.zero.components,
            a.towards.components if a.towards is not None else None,
            a.projected.components if a.projected is not None else None,
        )
        for a in angles(configuration, configuration.slots.coordinates)
    ]
    assert measured == found


def test_the_mass_centre_is_found_with_different_masses_and_not_for_one_particle() -> None:
    dumbbell = reported("ex04-dumbbell", complete=False).solution.choices[0].configuration
    assert [q.name for q in of_mass_centre(dumbbell, dumbbell.slots.coordinates)] == ["x_C", "y_C", "z_C"]
    pendulum = reported("ex11-ideal-pendulum", complete=False).solution.choices[0].configuration
    assert of_mass_centre(pendulum, pendulum.slots.coordinates) == ()


def test_lengths_are_no_angles() -> None:
    skate = reported("ex06-two-particle-skate", complete=False).solution.own.configuration
    assert angles(skate, skate.slots.coordinates) == ()


def test_a_position_with_a_pole_measures_no_angle() -> None:
    """tan θ has no value at π/2, where cos θ and sin θ are read off."""
    text = """
title: The centre of a rod over a peg
parameters: [b, c]
coordinates: [theta]
particles: {G: {mass: 1, position: "b*cos(theta)*i + (b*sin(theta) - c*tan(theta))*j"}}
"""
    problem = read_problem(Source("peg.yaml", text))
    configuration = file_configuration(problem, classify(problem).constrained)
    assert list(angles(configuration, configuration.slots.coordinates)) == []
