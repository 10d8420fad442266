"""Poles of a chart: the azimuth at the pole of a sphere moves nothing."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.document.derivation import Prose
from lagrange.explain.report import report
from lagrange.explain.rest.equilibrium import explain_virtual_work
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.support.statics_texts import CHAIN, CROSS_WIND, POLES_OF_A_CHOICE

CYLINDRICAL = """
title: A force in cylindrical coordinates
parameters: [F, k]
coordinates: [rho, phi]
particles: {P: {mass: 1, position: rho*cos(phi)*i + rho*sin(phi)*j}}
forces:
  centre: {potential: k*rho^2/2}
  push: {on: P, vector: F*i}
find: equilibrium
"""
SPHERICAL = """
title: Spherical pendulum
parameters: [m, g, l]
coordinates: [theta, phi]
particles: {P: {mass: m, position: l*sin(theta)*cos(phi)*i + l*sin(theta)*sin(phi)*j - l*cos(theta)*k}}
gravity: -g*k
find: equilibrium
"""
TORSION = "forces: {spring: {potential: m*g*l*(phi - 1)^2}}"
CRANK = """
title: Crank and slider pushed towards the axis
parameters: [F, l, r]
coordinates: [phi, psi]
particles:
  A: {position: l*cos(phi)*i}
  B: {position: r*cos(psi)*i}
forces: {push: {on: A, vector: -F*i}, pull: {on: B, vector: F*i}}
"""


def idle(text: str) -> list[str]:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    return [" ".join(map(str, names)) for names in e.idle]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        (CYLINDRICAL, ["", ""]),  # ρ = ±F/k; and ρ = 0 with φ = ±π/2 is no equilibrium
        (SPHERICAL, ["phi", "phi"]),
        (SPHERICAL + TORSION, ["phi", "phi"]),
        (CROSS_WIND, ["", ""]),
        (CHAIN, [""]),
        (CRANK, ["", "", "", ""]),  # dead centres: δφ moves nothing at φ = 0, but φ has a position of its own
    ],
)
def test_coordinates_that_move_nothing(text: str, names: list[str]) -> None:
    assert idle(text) == names


def words(text: str) -> str:
    e = solve(read_problem(Source("problem.yaml", text))).own.equilibrium
    assert e is not None
    blocks = explain_virtual_work(e, None).body
    return " ".join(p for b in blocks if isinstance(b, Prose) for p in b.parts if isinstance(p, str))


def test_it_is_said() -> None:
    """Without a horizontal force every φ serves at the pole; with one the pole is no equilibrium of a free particle."""
    assert "the coordinates are singular there" in words(SPHERICAL)
    assert "fixed by other means" not in words(SPHERICAL)
    assert "no equilibri" in words(CYLINDRICAL)
    assert "fixed by other means" in words(SPHERICAL + TORSION)
    assert "singular" not in words(CHAIN)


BOWL = """
title: A bowl
parameters: [k, c]
coordinates: [{coordinates}]
let: {{X: {X}, Y: {Y}}}
particles: {{P: {{mass: 1, position: X*i + Y*j{more}}}}}
forces: {{field: {{potential: {potential}}}}}
find: equilibrium
"""
POLAR = {"coordinates": "rho, phi", "X": "rho*cos(phi)", "Y": "rho*sin(phi)", "more": ""}
CARTESIAN = {"coordinates": "x, y", "X": "x", "Y": "y", "more": ""}
ON_A_CART = {"coordinates": "z, rho, phi", "X": "rho*cos(phi)", "Y": "rho*sin(phi)", "more": " + z*k"}
CARTESIAN_ON_A_CART = {"coordinates": "z, x, y", "X": "x", "Y": "y", "more": " + z*k"}


def verdict_at_rest(chart: dict[str, str], potential: str) -> tuple[str, set[str]]:
    """The verdict on the place where all but an azimuth vanishes, and the conditions, without their sides."""
    solution = solve(read_problem(Source("problem.yaml", BOWL.format(potential=potential, **chart))))
    e, second = solution.own.equilibrium, solution.own.stability
    assert e is not None
    assert second is not None
    [found] = [s for b, s in zip(e.branches, second.verdicts, strict=True) if all(r.rhs == 0 for r in b.relations)]
    assert solution.holds
    return found.verdict.value, {str(abs(sp.factor(c.lhs - c.rhs).subs({"k": 1, "c": 3}))) for c in found.conditions}


@pytest.mark.parametrize(
    "potential",
    [
        "k*X^2/2 + k*Y^2/2",
        "-k*X^2/2 - c*Y^2/2",
        "k*X^2/2 - c*Y^2/2",
        "k*X^2 + k*Y^2 + c*X*Y",
        "k*X^2 + c*Y^2 + (k + c)*X*Y",
    ],
)
def test_stability_at_a_pole_is_that_in_cartesian_coordinates(potential: str) -> None:
    assert verdict_at_rest(POLAR, potential) == verdict_at_rest(CARTESIAN, potential)


@pytest.mark.parametrize("potential", ["k*X^2 + k*Y^2 + k*z^2 - k*z*X", "k*X^2 + k*Y^2 + k*z^2 - 3*k*z*X"])
def test_stability_at_a_pole_beside_another_coordinate(potential: str) -> None:
    assert verdict_at_rest(ON_A_CART, potential) == verdict_at_rest(CARTESIAN_ON_A_CART, potential)


def test_without_all_directions_nothing_is_decided() -> None:
    """With Y = X φ no displacement along j is among the δX, and V = k X² would seem to have a strict minimum."""
    fan = {"coordinates": "x, phi", "X": "x", "Y": "x*phi", "more": ""}
    assert verdict_at_rest(fan, "k*X^2")[0] == "undecided"


def test_the_poles_of_a_choice_are_no_equilibria_where_the_forces_do_not_balance() -> None:
    """At θ = 0, φ = ±π/2 Q_θ and Q_φ vanish, but nothing balances the force along i."""
    solution = solve(read_problem(Source("problem.yaml", POLES_OF_A_CHOICE)))
    [choice] = solution.choices
    e = choice.equilibrium
    assert e is not None
    assert [len(e.branches), len(e.poles)] == [2, 4]
    assert all(r.lhs.has(sp.tan) or r.lhs.name == "phi" for b in e.branches for r in b.relations)
    assert solution.holds
    said = " ".join(
        p for b in explain_virtual_work(e, None).body if isinstance(b, Prose) for p in b.parts if isinstance(p, str)
    )
    assert "no equilibri" in said


def test_without_a_horizontal_force_the_poles_of_a_choice_are_equilibria() -> None:
    text = POLES_OF_A_CHOICE.replace("vector: F*i", "vector: -F*k")
    [choice] = solve(read_problem(Source("problem.yaml", text))).choices
    assert choice.equilibrium is not None
    assert [len(choice.equilibrium.branches), len(choice.equilibrium.poles)] == [2, 0]


SLIDER = """
title: A slider, with an angle for its place
parameters: [a, k, F]
coordinates: [x]
particles: {P: {position: x*i}}
forces: {push: {on: P, vector: F*i}, spring: {potential: k*x^2/2}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: a*cos(theta)}}}
find: equilibrium
"""


def test_the_edge_of_a_choice_is_no_equilibrium() -> None:
    """x = a cos θ has no displacement at θ = 0 and π, where F = k x does not hold."""
    solution = solve(read_problem(Source("problem.yaml", SLIDER)))
    assert all(c.passed for c in solution.checks)
    [view] = solution.choices
    assert view.equilibrium is not None
    assert [str(r.lhs) for b in view.equilibrium.branches for r in b.relations] == ["cos(theta)"]
    assert [str(r.rhs) for b in view.equilibrium.poles for r in b.relations] == ["0", "pi"]


def test_a_dead_centre_is_named() -> None:
    """In the file's own coordinate θ may be the angle of a crank: then any force balances at θ = 0."""
    crank = SLIDER[: SLIDER.index("generalized")].replace("coordinates: [x]", "coordinates: [theta]")
    crank = crank.replace("x*i", "a*cos(theta)*i").replace("k*x^2/2", "k*a^2*cos(theta)^2/2")
    told = report(read_problem(Source("problem.yaml", crank + "find: equilibrium\n")))
    assert told.solution.own.equilibrium is not None
    assert told.solution.own.equilibrium.dead_centres == (0, 1)
    page = " ".join(terminal.text(told.derivation, told.notation, 100).split())
    assert "moves nothing to first order, so any forces balance there: a dead centre" in page
