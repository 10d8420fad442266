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
