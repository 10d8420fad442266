"""Reactions as functions of the state: textbook formulas, SymPy's KanesMethod, and answers that state them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
import sympy as sp
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols

from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.explain.report import report
from lagrange.expressions.reader import read_value
from lagrange.mechanics.dynamics.checks import check_reactions
from lagrange.mechanics.dynamics.limits import MOST_FREE
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

PENDULUM = """parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: '[x, y]'}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
gravity: '[0, g]'
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""


def solution(problem: Read, text: str) -> Solution:
    return solve(problem(f"title: Example\n{text}"))


def value(text: str, found: Solution) -> sp.Expr:
    expression = read_value(Fragment.of(text), reference_of_solution(found).scope)
    assert isinstance(expression, sp.Expr)
    return expression


SCREW = """parameters: [m]
coordinates: [x, y, z]
particles: {P: {mass: m, position: '[x, y, z]'}}
constraints: {cylinder: "x*x' + y*y' = 0", pitch: "x*y' - y*x' = (x^2 + y^2)*z'"}
"""


def test_a_reaction_that_the_velocities_make_zero_is_zero(problem: Read) -> None:
    """2 m (x x' + y y') z'/(...) is 0 where x x' + y y' = 0: along a helix without weight only the cylinder presses."""
    found = solution(problem, SCREW).own.dynamics
    assert found is not None
    assert found.reactions is not None
    assert found.reactions.multipliers["pitch"] == 0
    assert found.reactions.multipliers["cylinder"] != 0


# -- formulas of textbooks ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "choice", "name", "tension", "formula"),
    [
        (PENDULUM, "angle", "rod", True, "m*g*cos(theta) + m*l*theta'^2"),
        (PENDULUM, "", "rod", True, "m*(x'^2 + y'^2 + g*y)/l"),
        (
            "parameters: [m, l, g]\ncoordinates: [r, theta, phi]\nframe: {type: spherical, coordinates: [r, theta, phi]}\n"
            "particles: {P: {mass: m, position: r*e_r}}\nconstraints: {rod: r = l}\ngravity: g*k\n",
            "",
            "rod",
            True,
            "m*g*cos(theta) + m*r*theta'^2 + m*r*phi'^2*sin(theta)^2",
        ),
        (  # conical: theta fixed, r = l sin(theta), T cos(theta) = m g
            "parameters: [m, h, g, Omega]\ncoordinates: [rho, phi, z]\n"
            "frame: {type: cylindrical, coordinates: [rho, phi, z]}\n"
            "particles: {P: {mass: m, position: rho*e_rho + z*k}}\nconstraints: {level: z = h, turn: phi = Omega*t}\n"
            "gravity: g*k\n",
            "",
            "level",
            False,
            "-m*g",
        ),
        (
            "parameters: [m1, m2, g, L]\ncoordinates: [y1, y2]\n"
            "particles: {A: {mass: m1, position: y1*j}, B: {mass: m2, position: y2*j}}\n"
            "constraints: {string: {equation: L - y1 - y2 = 0}}\ngravity: g*j\n",
            "",
            "string",
            False,
            "2*m1*m2*g/(m1 + m2)",
        ),
        (  # sliding off a sphere, the angle from the upward vertical
            "parameters: [m, R, g]\ncoordinates: [r, theta]\nlet: {n: 'sin(theta)*i + cos(theta)*j'}\n"
            "particles: {P: {mass: m, position: r*n}}\nconstraints: {ball: r = R}\ngravity: -g*j\n",
            "",
            "ball",
            False,
            "m*g*cos(theta) - m*r*theta'^2",
        ),
        (  # a rod in free flight: m1 m2/(m1 + m2) l omega^2
            "parameters: [m1, m2, l, g]\ncoordinates: [x, y, u, v]\n"
            "particles: {A: {mass: m1, position: '[x, y]'}, B: {mass: m2, position: '[u, v]'}}\n"
            "constraints: {rod: (x - u)^2 + (y - v)^2 = l^2}\ngravity: '[0, g]'\ngeneralized_coordinates:\n"
            "  turn: {coordinates: [x, y, phi], substitute: {u: x + l*cos(phi), v: y + l*sin(phi)}}\n",
            "turn",
            "rod",
            True,
            "m1*m2/(m1 + m2)*l*phi'^2",
        ),
        (  # bead on a hoop that turns: the force of the turning plane, 2 m Omega times the radial velocity
            "parameters: [m, R, g, Omega]\ncoordinates: [rho, phi, z]\n"
            "frame: {type: cylindrical, coordinates: [rho, phi, z]}\n"
            "particles: {P: {mass: m, position: rho*e_rho + z*k}}\n"
            "constraints: {hoop: rho^2 + z^2 = R^2, turn: phi = Omega*t}\ngravity: -g*k\n",
            "",
            "turn",
            False,
            "2*m*phi'*rho*rho'",
        ),
    ],
    ids=["pendulum", "pendulum in x, y", "spherical", "level", "Atwood", "off a sphere", "free rod", "turning hoop"],
)
def test_known_reactions(problem: Read, text: str, choice: str, name: str, tension: bool, formula: str) -> None:
    found = solution(problem, text)
    dynamics = next((c.dynamics for c in found.choices if c.name == choice), found.own.dynamics)
    given = dynamics.reactions.tensions if tension else dynamics.reactions.multipliers
    difference = given[name] - value(formula, found)
    assert dynamics.equations.configuration.surface.is_zero(difference) is True


def test_reaction_as_a_vector(problem: Read) -> None:
    """The force of the rod on the bob is −T along the rod."""
    found = solution(problem, PENDULUM)
    dynamics = found.choices[0].dynamics
    force = dynamics.reactions.forces["rod"]["P"]
    wanted = (
        value("-(m*g*cos(theta) + m*l*theta'^2)*sin(theta)", found),
        value("-(m*g*cos(theta) + m*l*theta'^2)*cos(theta)", found),
    )
    assert [is_zero(a - b) for a, b in zip(force.components, wanted, strict=False)] == [True, True]


def test_tension_against_kanes_method_with_an_auxiliary_speed() -> None:
    """KanesMethod: a fictitious speed along the rod brings the tension to light."""
    m, g, l, tension = sp.symbols("m g l T")
    theta, rate, extra = dynamicsymbols("theta omega u_a")
    t = dynamicsymbols._t
    fixed, turning = ReferenceFrame("N"), ReferenceFrame("A")
    turning.orient_axis(fixed, theta, fixed.z)
    turning.set_ang_vel(fixed, rate * fixed.z)
    origin, bob = Point("O"), Point("P")
    origin.set_vel(fixed, 0)
    bob.set_pos(origin, l * turning.x)
    bob.set_vel(fixed, l * rate * turning.y + extra * turning.x)
    method = KanesMethod(fixed, [theta], [rate], [theta.diff(t) - rate], u_auxiliary=[extra])
    loads = [(bob, m * g * fixed.x - tension * turning.x)]
    method.kanes_equations([Particle("P", bob, m)], loads)
    [auxiliary] = method.auxiliary_eqs
    [theirs] = sp.solve(auxiliary.subs(extra.diff(t), 0).subs(extra, 0), tension)
    plain = theirs.subs(rate, sp.Symbol("w")).subs(theta, sp.Symbol("q"))
    w, q = sp.symbols("w q")
    assert sp.expand(plain - (m * g * sp.cos(q) + m * l * w**2)) == 0  # the formula of `test_known_reactions`


# -- what is not determined, what is too large -------------------------------------------------------------------------


REDUNDANT = """parameters: [m, g]
coordinates: [x, y, z]
particles: {P: {mass: m, position: '[x, y, z]'}}
constraints: {floor: z = 0, again: 2*z = 0, wall: x = 0}
gravity: -g*k
"""


def test_redundant_constraints_determine_a_combination(problem: Read) -> None:
    """λ_floor + 2 λ_again = m g, neither of them; the wall's is determined."""
    found = solution(problem, REDUNDANT)
    reactions = found.own.dynamics.reactions
    assert reactions.multipliers == {"wall": 0}
    [combination] = reactions.combinations
    assert [(c, s.name) for c, s in combination.terms] == [(1, "lambda_floor"), (2, "lambda_again")]
    assert is_zero(combination.value - value("m*g", found)) is True
    said = as_object(report(problem(f"title: Example\n{REDUNDANT}")))["reactions"]
    assert "multiplier" not in said["floor"]
    assert said["wall"]["multiplier"] == "0"


def test_a_wrong_reaction_is_found_out(problem: Read) -> None:
    """The check by Lagrange's equations can fail."""
    found = solution(problem, PENDULUM)
    [reaction] = found.law.newton.reactions
    right = found.own.dynamics.reactions
    wrong = replace(right, values={reaction.multiplier: 2 * right.multipliers["rod"]})
    assert [c.passed for c in check_reactions(found.own.configuration, (reaction.multiplier,), right)] == [True]
    assert [c.passed for c in check_reactions(found.own.configuration, (reaction.multiplier,), wrong)] == [False]


def test_what_is_too_large_is_left_unsolved() -> None:
    names = sp.symbols("a:8(:8)", real=True)
    rows = [list(names[8 * n : 8 * n + 8]) for n in range(8)]
    assert solved_linear(rows, [sp.S.One] * 8, Surface()) is None


def test_accelerations_of_free_systems_come_for_free_only_while_small(problem: Read) -> None:
    coordinates = [f"q{n}" for n in range(MOST_FREE + 1)]
    for count, known in ((MOST_FREE, True), (MOST_FREE + 1, False)):
        particles = ", ".join(f"P{n}: {{mass: m, position: {q}*i}}" for n, q in enumerate(coordinates[:count]))
        found = solution(
            problem, f"parameters: [m]\ncoordinates: [{', '.join(coordinates[:count])}]\nparticles: {{{particles}}}\n"
        )
        assert (found.own.dynamics.reactions is not None) is known


# -- answers -----------------------------------------------------------------------------------------------------------


def test_what_json_says_can_be_read_back(problem: Read) -> None:
    text = f"title: Example\n{PENDULUM}"
    result = report(problem(text))
    found, scope = as_object(result), reference_of_solution(result.solution).scope
    reaction = found["reactions"]["rod"]
    said = [reaction["multiplier"], reaction["tension"], reaction["on"]["P"], reaction["possible_work"]]
    for expression in (*said, *found["accelerations"].values(), found["choices"][0]["reactions"]["rod"]["tension"]):
        read_value(Fragment.of(expression), scope)
    assert set(found["accelerations"]) == {"x", "y"}
    assert (reaction["virtual_work"], reaction["possible_work"]) == ("0", "0")


BLADES = """
title: A skate that is held by several constraints
parameters: [m, J, F]
coordinates: [x, y, theta]
bodies: {P: {mass: m, inertia: J, position: x*i + y*j, angle: theta}}
constraints:
  blade: x'*sin(theta) = y'*cos(theta)
  line: y' = 0
  stop: x'*sin(theta) - y'*cos(theta) + y' = 0
  also: 2*y' = 0
"""


@pytest.mark.parametrize(
    ("forces", "values"),
    [("", ["0", "0"]), ("forces: {push: {on: P, vector: F*i}}\n", ["-F/sin(theta)", "-F*cos(theta)/sin(theta)"])],
)
def test_dependent_constraints_that_leave_no_velocity(problem: Read, forces: str, values: list[str]) -> None:
    """x' = y' = 0: there is no m x' theta' cos(theta) in what the four multipliers do together."""
    solution = solve(problem(BLADES + forces))
    assert solution.holds
    assert solution.own.dynamics is not None
    assert solution.own.dynamics.reactions is not None
    found = solution.own.dynamics.reactions.combinations
    assert [[s.name for _, s in c.terms] for c in found] == [
        ["lambda_blade", "lambda_stop"],
        ["lambda_line", "lambda_stop", "lambda_also"],
    ]
    assert [str(c.value) for c in found] == values


def test_reactions_in_a_choice_contain_no_coordinate_that_it_eliminates(problem: Read) -> None:
    """A bead on a hoop that turns with Ω: across it, N = 2 m R Ω θ' cos θ e_φ with φ = Ω t."""
    found = solution(
        problem,
        "parameters: [m, g, R, Omega]\ncoordinates: [r, theta, phi]\n"
        "frame: {type: spherical, coordinates: [r, theta, phi]}\nparticles: {P: {mass: m, position: r*e_r}}\n"
        "constraints: {sphere: r = R, turning: phi = Omega*t}\ngravity: -g*k\n"
        "generalized_coordinates: {angle: {coordinates: [theta], substitute: {r: R, phi: Omega*t}}}\n",
    )
    dynamics = found.choices[0].dynamics
    assert dynamics is not None
    assert dynamics.reactions is not None
    across = dynamics.reactions.forces["turning"]["P"]
    assert across.triad.directions is None
    size = "2*m*R*Omega*theta'*cos(theta)"
    expected = (value(f"-{size}*sin(Omega*t)", found), value(f"{size}*cos(Omega*t)", found), sp.S.Zero)
    assert all(is_zero(a - b) is True for a, b in zip(across.components, expected, strict=True))
