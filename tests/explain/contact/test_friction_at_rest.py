"""Friction at rest: bounds, indeterminate forces, belts."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Rule
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.support.derivation_text import said_in


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "block-held-over-a-drum",
            Rule.FRICTION_AT_REST,
            " is not determined: the system is statically indeterminate. It can be at rest if ",
        ),
        ("band-brake", Rule.FRICTION_AT_REST, "A rope or belt touches a rough drum over the angle "),
        (
            "cylinder-on-rough-incline",
            Rule.FRICTION_AT_REST,
            ", which acts at the point that touches, is at most the coefficient of static friction times the normal force of ",
        ),
    ],
)
def test_what_is_said_of_friction_at_rest(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)


IN_A_CORNER = """title: Cylinder in a corner turned by a couple
parameters: {W: positive, r: positive, mu: positive}
unknowns: [M]
coordinates: [x, y, theta]
bodies: {cylinder: {position: x*i + y*j, angle: theta}}
constraints: {floor: {equation: y >= r, reaction: N_A}, wall: {equation: x >= r, reaction: N_B}}
forces:
  weight: {on: cylinder, vector: -W*j}
  couple: {on: cylinder, moment: M*k}
  fA: {friction: mu, static: mu, constraint: floor, on: cylinder, at: r_cylinder - r*j, slip: i}
  fB: {friction: mu, static: mu, constraint: wall, on: cylinder, at: r_cylinder - r*i, slip: -j}
find: equilibrium
"""


def test_a_limit_that_no_forces_reach_is_not_admitted() -> None:
    """For μ > 1 the corner holds any couple; at μ = 1 no finite forces do for M < 0."""
    found = report(read_problem(Source("corner", IN_A_CORNER)))
    assert "μ > 1" in " ".join(terminal.text(found.derivation, found.notation, 200).split())
    cases = as_object(found)["rest"]["cases"]
    assert cases[0] == ["1 < mu"]
    assert all("<=" in condition for condition in cases[1])


CRATE = """title: Crate dragged by an inclined rope
parameters: {W: {value: 500 N}, mu: {value: 0.4}, theta: {value: 20 deg}}
unknowns: [P]
coordinates: [x, y]
particles: {crate: {position: x*i + y*j}}
constraints: {floor: {equation: y >= 0, reaction: N}}
forces:
  weight: {on: crate, vector: -W*j}
  rope: {on: crate, vector: P*cos(theta)*i + P*sin(theta)*j}
  rub: {friction: mu, static: mu, constraint: floor, on: crate, slip: i}
find: impending
"""


def test_the_reactions_at_the_limit_contain_the_force_that_was_found() -> None:
    """N = W − P sin θ with P = μ W/(cos θ + μ sin θ): 436.5 N, which presses."""
    found = report(read_problem(Source("crate", CRATE)))
    head, _, page = " ".join(terminal.text(found.derivation, found.notation, 200).split()).partition("1 The system")
    assert "P = μ W/(cos θ + μ sin θ)" in head
    assert "N = W cos θ/(cos θ + μ sin θ) that is N ≈ 436.5 N" in head
    assert "The reaction is then" in page
    assert "Contact requires" not in page


def test_the_head_has_the_unknown_force_of_rest() -> None:
    text = """title: Pipe held by a cord along the incline
parameters: {W: positive, R: positive, mu: positive, alpha: acute}
unknowns: [T]
coordinates: [x, y, theta]
bodies: {pipe: {position: x*i + y*j, angle: theta}}
constraints: {incline: {equation: y >= R, reaction: N}}
forces:
  weight: {on: pipe, vector: -W*sin(alpha)*i - W*cos(alpha)*j}
  cord: {on: pipe, vector: T*i, at: r_pipe + R*j}
  rub: {friction: mu, static: mu, constraint: incline, on: pipe, at: r_pipe - R*j}
find: equilibrium
"""
    found = report(read_problem(Source("pipe", text)))
    head = " ".join(terminal.text(found.derivation, found.notation, 200).split()).partition("1 The system")[0]
    assert "T = ½ W sin α" in head
