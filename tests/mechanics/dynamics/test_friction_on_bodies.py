"""Kinetic friction on rigid bodies: Newton's law and the law of moments written by hand, solved at numbers."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]

LADDER = """title: Ladder
parameters: [m, g, l, mu, nu]
coordinates: [x, y, theta]
let: {e: "cos(theta)*i - sin(theta)*j"}
bodies: {ladder: {mass: m, inertia: m*l^2/3, position: x*i + y*j, angle: -theta}}
constraints:
  wall: {equation: "x - l*cos(theta) >= 0", reaction: N_A}
  floor: {equation: "y - l*sin(theta) >= 0", reaction: N_B}
gravity: -g*j
forces:
  below: {friction: mu, constraint: floor, on: ladder, at: r_ladder + l*e, slip: i}
  above: {friction: nu, constraint: wall, on: ladder, at: r_ladder - l*e, slip: -j}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*cos(theta), y: l*sin(theta)}}}
"""
DISC = """title: Disc between wall and floor
parameters: [m, g, R, mu, nu, M_0]
coordinates: [x, y, theta]
bodies: {disc: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: theta}}
constraints: {floor: {equation: y >= R, reaction: N_B}, wall: {equation: x >= R, reaction: N_A}}
gravity: -g*j
forces:
  motor: {on: disc, moment: M_0*k}
  below: {friction: mu, constraint: floor, on: disc, at: r_disc - R*j, slip: i}
  above: {friction: nu, constraint: wall, on: disc, at: r_disc - R*i, slip: -j}
"""
BALL = """title: Ball thrown with slip
parameters: [m, g, R, mu]
coordinates: [x, y, theta]
bodies: {{ball: {{mass: m, inertia: 2/5*m*R^2, position: x*i + y*j, angle: theta}}}}
constraints: {{floor: {{equation: y = R, reaction: N}}}}
gravity: -g*j
forces: {{rub: {{friction: mu, constraint: floor, on: ball, at: {at}{more}}}}}
"""
PLANK = """title: Block on a plank that slides on ice
parameters: [m, M, g, mu, a, b]
coordinates: [x, y, X, Y]
bodies:
  block: {mass: m, inertia: m*a^2, position: x*i + y*j, angle: 0}
  plank: {mass: M, inertia: M*b^2, position: X*i + Y*j, angle: 0}
constraints: {ice: Y = 0, top: {equation: y - Y >= a, reaction: N}}
gravity: -g*j
forces: {rub: {friction: mu, constraint: top, on: block, at: r_block - a*j, slip: positive}}
"""


def solved(problem: Read, text: str) -> Solution:
    solution = solve(problem(text))
    assert [(c.name, c.choice) for c in solution.checks if c.passed is not True] == []
    return solution


def accelerations(solution: Solution, values: dict[str, object]) -> dict[str, sp.Expr]:
    view = (solution.choices or (solution.own,))[0]
    found = view.dynamics.reactions.accelerations if view.is_own else view.dynamics.accelerations
    return {
        s.name: e.xreplace({v: sp.sympify(values[v.name]) for v in e.free_symbols}).evalf(25) for s, e in found.items()
    }


def test_a_ladder_slides_with_friction_at_both_ends(problem: Read) -> None:
    m, g, l, mu, nu, angle, rate = (
        2,
        10,
        3,
        sp.Rational(1, 5),
        sp.Rational(1, 4),
        sp.Rational(7, 10),
        -sp.Rational(1, 3),
    )
    ax, ay, turned, across, up = sp.symbols("ax ay turned across up")
    cos, sin = sp.cos(angle), sp.sin(angle)
    by_hand = sp.solve(
        [
            m * ax - (across - mu * up),
            m * ay - (up + nu * across - m * g),
            # moments about the mass centre, anticlockwise; the ladder turns by −theta
            -m * l**2 / sp.Integer(3) * turned
            - (l * cos * up + l * sin * (-mu * up) - l * cos * nu * across - l * sin * across),
            ax - (-l * sin * turned - l * cos * rate**2),
            ay - (l * cos * turned - l * sin * rate**2),
        ],
        [ax, ay, turned, across, up],
        dict=True,
    )[0]
    values = {"m": m, "g": g, "l": l, "mu": mu, "nu": nu, "theta": angle, "theta'": rate}
    solution = solved(problem, LADDER)
    assert abs(accelerations(solution, values)["theta''"] - by_hand[turned].evalf(25)) < 1e-20
    contacts = solution.choices[0].dynamics.reactions.contacts
    for name, wanted in (("wall", across), ("floor", up)):
        value = contacts[name].xreplace({s: sp.sympify(values[s.name]) for s in contacts[name].free_symbols})
        assert abs(value.evalf(25) - by_hand[wanted].evalf(25)) < 1e-20


def test_a_disc_turns_between_wall_and_floor(problem: Read) -> None:
    """N_A = mu N_B and N_B + nu N_A = m g, at rest except for the rotation."""
    values = {"m": 2, "g": 10, "R": 1, "mu": sp.Rational(1, 2), "nu": sp.Rational(1, 3), "M_0": 20}
    up = sp.Rational(20) / (1 + sp.Rational(1, 6))
    across = up / 2
    turned = (20 - up / 2 - across / 3) / 1
    found = accelerations(solved(problem, DISC), values)
    assert abs(found["theta''"] - turned) < 1e-20
    assert found["x''"] == found["y''"] == 0


@pytest.mark.parametrize(
    ("more", "values", "sign"),
    [
        (", slip: positive", {}, 1),
        (", slip: i", {}, 1),
        (", slip: -3*i", {}, -1),
        (", slip: negative", {}, -1),
        ("", {"x'": 1, "theta'": -3}, -1),
        ("", {"x'": 1, "theta'": 3}, 1),
    ],
)
def test_a_ball_is_thrown(problem: Read, more: str, values: dict[str, int], sign: int) -> None:
    found = accelerations(
        solved(problem, BALL.format(at="r_ball - R*j", more=more)),
        {"m": 3, "g": 10, "R": 2, "mu": sp.Rational(1, 5), **values},
    )
    assert abs(found["x''"] - -sign * 2) < 1e-20  # μ g
    assert abs(found["theta''"] - -sign * sp.Rational(5, 2)) < 1e-20  # 5 μ g/(2 R)


def test_what_it_slides_on_takes_the_opposite(problem: Read) -> None:
    """The momentum is kept: m x'' = −μ m g, M X'' = μ m g."""
    found = accelerations(solved(problem, PLANK), {"m": 2, "M": 5, "g": 10, "mu": sp.Rational(1, 4)})
    assert abs(found["x''"] + sp.Rational(5, 2)) + abs(found["X''"] - 1) < 1e-20


@pytest.mark.parametrize(
    ("text", "code", "says"),
    [
        (BALL.format(at="r_ball - R*j", more="").replace(", at: r_ball - R*j", ""), "friction-place", "add `at:`"),
        (BALL.format(at="r_ball - R*i", more=""), "friction-place", "does not act at the `at`"),
        (LADDER.replace("angle: -theta", "angle: theta"), "friction-place", "turned the other way"),
        (BALL.format(at="r_ball - R*j", more=", slip: j"), "friction-slip", "not along the surface"),
        (BALL.format(at="r_ball - R*j", more=", slip: i - i"), "friction-slip", "is zero"),
        (BALL.format(at="r_ball - R*j", more=", slip: sideways"), "unknown-sense", "sideways"),
        (LADDER.replace("contact", "x").replace("slip: i}", "slip: i, contact: negative}"), "friction-place", "one-sided"),
    ],
)  # fmt: skip
def test_what_is_refused(problem: Read, text: str, code: str, says: str) -> None:
    with pytest.raises(ProblemError) as caught:
        solve(problem(text))
    [diagnostic] = caught.value.diagnostics
    assert diagnostic.code == code
    assert says in f"{diagnostic} {diagnostic.help}"


def test_a_slip_in_another_direction_than_the_velocity(problem: Read) -> None:
    text = (
        "title: Puck\nparameters: [m, g, mu]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
        "constraints: {table: z = 0, groove: y = x}\ngravity: '[0, 0, -g]'\n"
        "forces: {rub: {friction: mu, constraint: table, on: P, slip: DIRECTION}}\n"
    )
    with pytest.raises(ProblemError, match="does not slip along"):
        solve(problem(text.replace("DIRECTION", "i")))
    assert solve(problem(text.replace("DIRECTION", "i + j")))


PULLED_PLANK = """title: Cylinder that rolls on a plank on ice
parameters: [m, M, R, P, g, mu, mu_s]
coordinates: [X, x, y, theta]
particles: {plank: {mass: M, position: X*i}}
bodies: {cylinder: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: theta}}
constraints:
  top: {equation: y >= R, reaction: N}
  rolling: {equation: "x' + R*theta' = X'", reaction: F, by: rolling}
gravity: -g*j
forces:
  pull: {on: plank, vector: P*i}
  rub: {friction: mu, static: mu_s, constraint: top, on: cylinder, at: r_cylinder - R*j, surface_velocity: "X'*i"}
"""


def test_what_rolls_on_a_surface_of_given_velocity_does_not_slip(problem: Read) -> None:
    """(M + m/3) X'' = P, as the cylinder follows with X''/3; F = m x'' and |F| <= mu_s m g."""
    read = problem(PULLED_PLANK)
    solution = solve(read)
    m, M, P, g, mu_s = (read.scope.scalars[n] for n in ("m", "M", "P", "g", "mu_s"))
    rolling = solution.own.rolling
    assert rolling is not None
    [[condition]] = rolling.cases
    numbers = {m: 3, M: 2, P: 18, g: 10}
    at_limit = sp.Rational(18, 10 * (3 * 2 + 3))
    assert (condition.left - condition.right).xreplace({**numbers, mu_s: at_limit}) == 0


BRAKE = """title: Lever that brakes a wheel on a fixed axle
parameters: [I, r, b, c, l, P, mu]
coordinates: [theta, x, y, phi]
bodies:
  wheel: {mass: 0, inertia: I, position: "b*i - (c + r)*j", angle: -theta}
  lever: {mass: 0, inertia: 0, position: x*i + y*j, angle: phi}
constraints:
  O: r_lever = 0
  contact: {equation: "dot(r_lever - r_wheel, e2_lever) - c >= r", reaction: N}
forces:
  press: {on: lever, vector: -P*j, at: r_lever + l*e1_lever}
  rub: {friction: mu, constraint: contact, on: lever, at: r_wheel + r*e2_lever, slip: -e1_lever}
"""


def test_friction_acts_on_a_wheel_that_only_turns(problem: Read) -> None:
    """About O: N b + mu N c = P l, and the wheel has I theta'' = -mu N r."""
    values: dict[str, object] = {"I": 12, "r": 3, "b": 4, "c": 5, "l": 7, "P": 100, "mu": sp.Rational(1, 2)}
    values |= dict.fromkeys(("x", "y", "phi", "theta", "x'", "y'", "phi'", "theta'"), 0)
    turned = accelerations(solved(problem, BRAKE), values)["theta''"]
    assert abs(turned + sp.Rational(1, 2) * 700 / sp.Rational(13, 2) * 3 / 12) < 1e-20
