"""Constraints solved for coordinates: what is solved, and that it ends where roots of roots grow.

What coordinates measure: angles of lines between points, from which axis and in which sense; the mass centre.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.core.expression_size import Sizes
from lagrange.explain.report import report
from lagrange.mechanics.constraints.classification import classify
from lagrange.mechanics.constraints.constraints import constraint_row
from lagrange.mechanics.constraints.coordinates import angles, of_mass_centre, solved_constraints
from lagrange.mechanics.constraints.kinematics import file_configuration
from lagrange.mechanics.constraints.limits import LONGEST_SOLVED
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.render import terminal
from tests.support.shared import reported

Read = Callable[[str], Problem]

ROPES = """
title: Three ropes
parameters: [m, J, a, l, g]
coordinates: [x, y, phi]
bodies: {board: {mass: m, inertia: J, position: x*i + y*j, angle: phi}}
constraints:
  left: {equation: "norm(r_board - a*e1_board + a*i)^2 = l^2", reaction: T_1}
  middle: {equation: x^2 + y^2 = l^2, reaction: T_2}
  right: {equation: "norm(r_board + a*e1_board - a*i)^2 = l^2", reaction: T_3}
gravity: g*j
generalized_coordinates: {swing: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta), phi: 0}}}
"""


def solved(problem: Problem, names: str) -> dict[str, sp.Expr]:
    """What the constraints give for the coordinates of these names."""
    rows = [constraint_row(c, problem.slots) for c in problem.constraints]
    unknown = [q for name in names.split() for q in problem.slots.coordinates if q.name == name]
    return {q.name: e for q, e in solved_constraints(rows, unknown).expressed.items()}


def chain(links: int) -> str:
    """A chain in a plane, by the distances of its joints."""
    places = [f"x{n}, y{n}" for n in range(1, links + 1)]
    before = ["0", *(f"x{n}" for n in range(1, links))], ["0", *(f"y{n}" for n in range(1, links))]
    distances = [
        f"r{n}: (x{n} - {p})^2 + (y{n} - {q})^2 = l^2" for n, (p, q) in enumerate(zip(*before, strict=True), start=1)
    ]
    return (
        f"title: Chain\nparameters: [l]\ncoordinates: [{', '.join(places)}]\nconstraints: {{{', '.join(distances)}}}\n"
    )


@pytest.mark.parametrize(
    ("constraints", "unknown", "expressed"),
    [
        ("a: x = l*sin(z), b: y = x^2", "x y", {"x": "l*sin(z)", "y": "l**2*sin(z)**2"}),
        ("a: x^2 + y^2 = l^2", "x", {"x": "sigma_1*sqrt(l**2 - y**2)"}),
        ("a: x^2 + z^2 = l^2, b: (x - l)^2 + z^2 = 2*l^2", "x", {"x": "0"}),
        ("a: x*sin(x) = z", "x", {}),
    ],
)
def test_coordinates_that_constraints_give(
    problem: Read, constraints: str, unknown: str, expressed: dict[str, str]
) -> None:
    text = f"title: Example\nparameters: [l]\ncoordinates: [x, y, z]\nconstraints: {{{constraints}}}\n"
    found = solved(problem(text), unknown)
    assert {n: str(e) for n, e in found.items()} == expressed


def test_roots_of_roots_are_left_unsolved(problem: Read) -> None:
    """Three ropes for all three coordinates: the third equation would have thousands of terms."""
    found = solved(problem(ROPES), "x y phi")
    assert "phi" not in found
    assert all(Sizes().of(e).size < LONGEST_SOLVED for e in found.values())


def test_a_long_chain_is_solved_as_far_as_that_goes(problem: Read) -> None:
    found = solved(problem(chain(30)), " ".join(f"y{n}" for n in range(1, 31)))
    assert "y1" in found
    assert all(Sizes().of(e).widest <= 4000 for e in found.values())


def test_redundant_ropes_share_what_they_carry(problem: Read) -> None:
    """How they share it is not determined; what is, is written with the names that the file has for the forces."""
    shown = report(problem(ROPES))
    page = " ".join(terminal.text(shown.derivation, shown.notation, 120).split())
    assert "T₁, T₂ and T₃ are not determined individually" in page
    assert "T₁ − T₃ = 0" in page
    assert "T₂ + 2T₃ = m l θ̇² + m g cos θ" in page  # the ropes pull with these forces, however they are written
    assert "λ" not in page


def test_the_tensions_of_a_doubled_rod_are_added(problem: Read) -> None:
    text = """
title: A rod that is there twice
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {one: {equation: x^2 + y^2 = l^2, reaction: T}, two: {equation: 3*x^2 + 3*y^2 = 3*l^2, reaction: S}}
gravity: g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""
    shown = report(problem(text))
    page = " ".join(terminal.text(shown.derivation, shown.notation, 120).split())
    assert "S + T = m l θ̇² + m g cos θ" in page or "T + S = m l θ̇² + m g cos θ" in page


CRANK = """
title: Crank and slider
parameters: [m, M, a, b]
coordinates: [x, y, s]
particles: {A: {mass: m, position: x*i + y*j}, B: {mass: M, position: s*i}}
constraints: {crank: x^2 + y^2 = a^2, rod: (s - x)^2 + y^2 = b^2}
generalized_coordinates: {height: {coordinates: [y]}, slider: {coordinates: [s]}}
"""


def test_a_crank_is_solved_by_its_height_and_by_its_slider(problem: Read) -> None:
    """The difference of the two constraints gives x by s. By y it leads to a root of degree four, each alone does not."""
    read = problem(CRANK)
    assert {n: str(e) for n, e in solved(read, "x s").items()} == {
        "x": "sigma_1*sqrt(a**2 - y**2)",
        "s": "sigma_1*sqrt(a**2 - y**2) + sigma_2*sqrt(b**2 - y**2)",
    }
    assert set(solved(read, "x y")) == {"x", "y"}
    choices = {c.coordinates.choice.name: c.coordinates for c in solve(read).choices}
    assert {n: (c.branches, c.satisfied) for n, c in choices.items()} == {
        "height": (4, ("crank", "rod")),
        "slider": (2, ("crank", "rod")),
    }


# Measures


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
