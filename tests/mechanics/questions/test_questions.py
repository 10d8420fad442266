"""Answers to questions, against values worked out by hand."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.explain.report import report
from lagrange.mechanics.questions.results import Asked, How, Route
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import terminal
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

SPHERE = """
title: Sphere
axes: {i: right, j: up}
parameters: [m, R, g, v]
coordinates: [r, theta]
particles: {P: {mass: m, position: r*sin(theta)*i + r*cos(theta)*j}}
constraints: {sphere: {equation: r = R, reaction: N, by: surface}}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [theta]}}
"""
PENDULUM = """
title: Pendulum
axes: {i: right, j: down}
parameters: [m, l, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
gravity: g*j
"""
ORBIT = """
title: Orbit
parameters: [m, k, a, v]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
forces: {f: {potential: -m*k/r}}
initial: {r: a, r': 0, phi: 0, phi': v/a}
"""
WIRE = """
title: Bead on a wire that turns
parameters: [m, w, b, L]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {P: {mass: m, position: r*e_r}}
constraints: {drive: {equation: phi = w*t, reaction: M}}
generalized_coordinates: {radius: {coordinates: [r], substitute: {phi: w*t}}}
initial: {r: b, r': 0}
"""
ATWOOD = """
title: Atwood's machine
axes: {j: down}
parameters: [m1, m2, g, h, L]
coordinates: [a, b]
particles: {A: {mass: m1, position: a*j}, B: {mass: m2, position: b*j}}
constraints: {string: {equation: a + b = L, reaction: T}}
gravity: g*j
initial: {a: 0, a': 0}
"""
BALL = """
title: Ball thrown up against drag
axes: {j: up}
parameters: [m, c, g, v]
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: -g*j
forces: {drag: {on: P, vector: "-c*abs(y')*y'*j"}}
initial: {y: 0, y': v}
"""
TOPPLING = """
title: Rod that topples
axes: {i: right, j: up}
parameters: [m, l, g]
coordinates: [x, y, theta]
bodies: {rod: {mass: m, inertia: m*l^2/12, position: x*i + y*j, angle: -theta}}
constraints:
  sideways: {equation: x = l/2*sin(theta), reaction: H}
  upright: {equation: y = l/2*cos(theta), reaction: V}
gravity: -g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l/2*sin(theta), y: l/2*cos(theta)}}}
initial: {theta: 0, theta': 0}
"""


def asked(read: Read, text: str) -> Asked:
    solution: Solution = solve(read(text), complete=False)
    [answer] = solution.asked
    assert all(c.passed for c in solution.checks), [c.name for c in solution.checks if not c.passed]
    return answer


def value(text: str) -> sp.Expr:
    """An expression of letters that are positive, apart from the moving ones."""
    moving = {n: sp.Symbol(n, real=True) for n in ("theta", "r", "x", "y", "phi")}
    names = sorted({*"mlgkavRwbLMhcz", "m1", "m2"})
    return sp.sympify(
        text, locals={**{n: sp.Symbol(n, positive=True) for n in names}, "t": sp.Symbol("t", real=True), **moving}
    )


CONICAL = """
title: Spherical pendulum struck while its thread is horizontal
axes: {k: down}
parameters: [m, l, g, v]
coordinates: [r, theta, phi]
frame: {type: spherical, coordinates: [r, theta, phi]}
particles: {P: {mass: m, position: r*e_r}}
constraints: {thread: {equation: r <= l, reaction: T}}
gravity: g*k
initial: {theta: pi/2, theta': 0, phi: 0, phi': v/l}
"""
ROCKET = """
title: Rocket
parameters: [m, k, c, g]
coordinates: [y]
particles: {P: {mass: m - k*t, position: y*j, leaves: {relative: -c*j}}}
gravity: -g*j
initial: {y: 0, y': 0}
"""
CYCLOID = """
title: Bead let go at the cusp of a cycloid
axes: {i: right, j: up}
parameters: [m, a, g]
coordinates: [phi]
particles: {P: {mass: m, position: a*(phi - sin(phi))*i - a*(1 - cos(phi))*j}}
gravity: -g*j
initial: {phi: 0, phi': 0}
"""
SKATE = """
title: Skate
parameters: [m, I, w]
coordinates: [x, y, theta]
bodies: {skate: {mass: m, inertia: I, position: x*i + y*j, angle: theta}}
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
initial: {x: 0, y: 0, theta: 0, x': 0, theta': w}
"""

CASES = [
    (SKATE, "", "{quantity: \"theta'\", when: t = 1}", "w", Route.SOLUTION),
    (SPHERE, "{theta: 0, theta': 0}", "{quantity: R*cos(theta), when: N = 0}", "2*R/3", Route.INTEGRALS),
    (SPHERE, "{theta: 0, theta': v/R}", "{quantity: R*cos(theta), when: N = 0}", "2*R/3 + v**2/(3*g)", Route.INTEGRALS),
    (SPHERE, "{theta: 0, theta': v/R}", "{quantity: v, when: [theta = 0, N = 0]}", "sqrt(g*R)", Route.INTEGRALS),
    (SPHERE, "", "{quantity: \"theta''\", when: theta = pi/2}", "g/R", Route.STATE),
    (SPHERE, "", "{quantity: N, when: [theta = 0, \"theta' = v/R\"]}", "m*g - m*v**2/R", Route.STATE),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: \"x'\", when: x = 0}", "-sqrt(2*g*l)", Route.INTEGRALS),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: T, when: x = 0}", "3*m*g", Route.INTEGRALS),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: energy}", "0", Route.INTEGRALS),
    (PENDULUM, "{x: l, y: 0, y': 0}", "{quantity: T_kinetic, by: y}", "m*g*y", Route.INTEGRALS),
    (ORBIT, "", "{quantity: r, when: \"r' = 0\"}", "a**2*v**2/(2*k - a*v**2)", Route.INTEGRALS),
    (ORBIT, "", "{quantity: v, when: [r = a, \"r'' = 0\"]}", "sqrt(k/a)", Route.INTEGRALS),
    (ORBIT, "", "{quantity: \"r*phi'\", by: r}", "a*v/r", Route.INTEGRALS),
    (ORBIT, "", "{quantity: r, by: phi}", "a**2*v**2/(k + (a*v**2 - k)*cos(phi))", Route.ORBIT),
    (ORBIT, "", "{quantity: \"r*phi'\", when: phi = pi}", "2*k/(a*v) - v", Route.ORBIT),
    (ORBIT, "", "{quantity: phi, when: r = v^2*a^2/k}", "pi/2", Route.ORBIT),
    (CONICAL, "", "{quantity: l*cos(theta), when: \"theta' = 0\"}", "(sqrt(16*g**2*l**2 + v**4) - v**2)/(4*g)",
     Route.INTEGRALS),
    (CYCLOID, "", "{quantity: t, when: phi = pi}", "pi*sqrt(a/g)", Route.QUADRATURE),
    (ROCKET, "", "{quantity: \"y''\", when: t = 0}", "c*k/m - g", Route.STATE),
    (WIRE, "", "{quantity: \"r'\", when: r = L}", "w*sqrt(L**2 - b**2)", Route.INTEGRALS),
    (WIRE, "", "{quantity: M, by: r}", "2*m*w**2*sqrt(r**2 - b**2)", Route.INTEGRALS),
    (WIRE, "", "{quantity: r, by: t}", "b*cosh(w*t)", Route.SOLUTION),
    (ATWOOD, "", "{quantity: \"a'\", when: a = h}", "sqrt(2*g*h*(m1 - m2)/(m1 + m2))", Route.INTEGRALS),
    (ATWOOD, "", "{quantity: T, when: a = h}", "2*m1*m2*g/(m1 + m2)", Route.STATE),
    (ATWOOD, "", "{quantity: t, when: a = h}", "sqrt(2*h*(m1 + m2)/(g*(m1 - m2)))", Route.SOLUTION),
    (BALL, "", "{quantity: y, when: \"y' = 0\"}", "m/(2*c)*log(1 + c*v**2/(m*g))", Route.INTEGRALS),
    (BALL, "", "{quantity: t, when: \"y' = 0\"}", "sqrt(m/(c*g))*atan(v*sqrt(c/(m*g)))", Route.SOLUTION),
    (TOPPLING, "", "{quantity: \"theta'\", when: theta = pi/2}", "sqrt(3*g/l)", Route.INTEGRALS),
    (TOPPLING, "", "{quantity: H, by: theta}", "3*m*g*sin(theta)*(3*cos(theta) - 2)/4", Route.INTEGRALS),
    (TOPPLING, "", "{quantity: V, when: theta = pi/2}", "m*g/4", Route.STATE),
]  # fmt: skip


@pytest.mark.parametrize(("text", "initial", "question", "expected", "route"), CASES)
def test_the_answer_is_that_of_the_hand(
    text: str, initial: str, question: str, expected: str, route: Route, problem: Read
) -> None:
    state = f"initial: {initial}\n" if initial else ""
    answer = asked(problem, f"{text}{state}ask: {{it: {question}}}\n")
    assert answer.how is How.EXACT
    assert answer.route is route
    values = [v for b in answer.branches for v in b.values]
    assert len(values) == 1
    assert is_zero(values[0] - value(expected)) is True


def test_a_particle_beside_the_top_leaves_to_its_side(problem: Read) -> None:
    """No turning point lies between: the other side comes later."""
    text = SPHERE + "initial: {theta: 1/10, theta': 0}\nask: {it: {quantity: theta, when: N = 0}}\n"
    answer = asked(problem, text)
    assert [b.states[0][sp.Symbol("theta'", real=True)].could_extract_minus_sign() for b in answer.branches] == [False]


UP_AND_DOWN = """
title: Block sent up a rough slope
axes: {i: up the slope, j: away from it}
parameters: {m: positive, g: positive, mu: positive, alpha: acute, v: positive}
coordinates: [x, y]
particles: {P: {mass: m, position: [x, y]}}
constraints: {slope: {equation: y >= 0, reaction: N}}
gravity: -g*sin(alpha)*i - g*cos(alpha)*j
initial: {x: 0, x': v}
"""
RUB = "forces: {rub: {friction: mu, constraint: slope, on: P}}\n"
RUB_UPWARDS = "forces: {rub: {friction: mu, constraint: slope, on: P, slip: i}}\n"
BACK = 'ask: {back: {quantity: "x\'", when: x = 0}}\n'


def test_friction_turns_with_the_slip_and_may_hold_the_block(problem: Read) -> None:
    answer = asked(problem, UP_AND_DOWN + RUB + BACK)
    [branch] = answer.branches
    m, g, mu, v = (sp.Symbol(n, positive=True) for n in ("m", "g", "mu", "v"))
    [alpha] = (s for s in branch.rhs.free_symbols if s.name == "alpha")
    steep = {g: 9.8, mu: 0.3, v: 6.0, alpha: 0.6}
    up, down = (math.sin(0.6) + s * 0.3 * math.cos(0.6) for s in (1, -1))
    assert float(branch.rhs.subs(steep)) == pytest.approx(-6 * math.sqrt(down / up))
    assert all(bool((c.lhs - c.rhs).subs(steep) > 0) for c in branch.conditions)
    flat = {**steep, alpha: 0.2}  # tan 0.2 < 0.3
    assert not all(bool((c.lhs - c.rhs).subs(flat) > 0) for c in branch.conditions)
    assert answer.turning is not None
    assert answer.turning.value.subs(steep) == pytest.approx(36 / (2 * 9.8 * up))
    assert m not in branch.rhs.free_symbols


def test_slip_in_a_stated_sense_is_not_followed_back(problem: Read) -> None:
    answer = solve(problem(UP_AND_DOWN + RUB_UPWARDS + BACK), complete=False).asked[0]
    assert not answer.answered


def test_a_coordinate_coupled_to_another_is_not_integrated_alone(problem: Read) -> None:
    """With a cubic spring between them nothing is elementary; without it both are cosines."""
    text = """
title: Two masses
parameters: [m, k, b, a]
coordinates: [x, y]
particles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}}
forces: {s: {potential: "k*x^2/2 + k*y^2/2 + b*(x - y)^4"}}
initial: {x: a, x': 0, y: 0, y': 0}
ask: {x_t: {quantity: x, by: t}}
"""
    assert not solve(problem(text), complete=False).asked[0].answered
    answer = asked(problem, text.replace("^4", "^2"))
    assert answer.route is Route.SOLUTION
    assert {q.name for q in answer.solutions} == {"x", "y"}


def test_the_size_of_a_force_that_rolling_needs_has_no_sense(problem: Read) -> None:
    """μ_s = 2/7 tan α for a ball, whichever way the equation of rolling is written."""
    text = """
title: Ball on an incline
axes: {i: down, j: away}
parameters: {m: positive, r: positive, alpha: acute, mu: positive, g: positive}
coordinates: [x, y, phi]
bodies: {ball: {mass: m, inertia: 2/5*m*r^2, position: x*i + y*j, angle: -phi}}
constraints: {contact: {equation: y >= r, reaction: N}, rolling: {equation: "SIDES", reaction: F}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
initial: {x: 0, x': 0}
ask: {least: {quantity: mu, when: F = mu*N}}
"""
    answers = [asked(problem, text.replace("SIDES", s)) for s in ("x' = r*phi'", "r*phi' = x'")]
    for a in answers:
        [value_found] = a.branches[0].values
        [alpha] = value_found.free_symbols
        assert is_zero(value_found - sp.Rational(2, 7) * sp.tan(alpha)) is True
    assert [a.opposite is None for a in answers] == [False, True]


def test_what_is_not_decided_is_said(problem: Read) -> None:
    """Two degrees of freedom coupled by a fourth power: nothing tells whether x gets to a."""
    text = """
title: Particle on a hill in the plane
parameters: [m, k, b, a, v]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {s: {potential: "-k*x^2/2 + b*x^2*y^2"}}
initial: {x: 0, x': v, y: 0, y': v}
ask: {motion: {quantity: b*(x*y)^2 + a*x*b, when: [x = a, y = a]}}
"""
    explained = report(problem(text), None)
    assert explained.solution.asked[0].branches[0].provided
    assert "provided that the motion gets there" in terminal.text(explained.derivation, explained.notation, 100)
    assert "provided that the motion gets there" in as_object(explained)["asked"][0]["conditions"]


THROWN = """
title: A weight thrown up, with drag that grows with the square of the speed
parameters: [m, g, c, u, L]
coordinates: [x]
particles: {P: {mass: m, position: x*j}}
gravity: -g*j
forces: {drag: {on: P, vector: "-c*abs(x')*x'*j"}}
initial: {x: 0, x': u}
ask:
  below: {quantity: "x'", when: "x = -L"}
"""


def test_a_place_behind_the_start_is_reached_after_the_turn(problem: Read) -> None:
    """Up to h with exp(2 c h/m) = 1 + c u²/(m g), then down by h + L: v² = (m g/c) (1 − exp(−2 c (h + L)/m))."""
    [asked] = solve(problem(THROWN)).asked
    [b] = asked.branches
    numbers = {"m": 1.5, "g": 9.8, "c": 0.4, "u": 3.0, "L": 2.0}
    m, g, c, u, length = numbers.values()
    h = m / (2 * c) * math.log(1 + c * u**2 / (m * g))
    down = -math.sqrt(m * g / c * (1 - math.exp(-2 * c * (h + length) / m)))
    [value] = b.values
    assert float(value.subs({s: numbers[s.name] for s in value.free_symbols})) == pytest.approx(down)


@pytest.mark.parametrize(("where", "answered"), [("a", True), ("-a", False)])
def test_a_time_by_quadrature_is_for_a_way_without_a_turn(problem: Read, where: str, answered: bool) -> None:
    """Started towards a, the mass turns before it comes to −a: the integral from 0 to −a would be the time without that."""
    text = f"""
title: A mass on a spring that hardens
parameters: [m, k, a, u]
coordinates: [x]
particles: {{P: {{mass: m, position: x*i}}}}
forces: {{spring: {{potential: k*x^4/4}}}}
initial: {{x: 0, x': u}}
ask: {{time: {{quantity: t, when: x = {where}}}}}
"""
    [asked] = solve(problem(text)).asked
    assert (asked.integrand is not None) is answered


def test_friction_holds_for_one_sense_in_a_time_too(problem: Read) -> None:
    text = """
title: A block sent up a rough incline, and how long until it is below its start
parameters: {m: positive, g: positive, alpha: acute, mu: positive, u: positive, L: positive}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {floor: {equation: y >= 0, reaction: N}}
gravity: -g*sin(alpha)*i - g*cos(alpha)*j
forces: {rub: {friction: mu, constraint: floor, on: P}}
initial: {x: 0, x': u}
ask: {time: {quantity: t, when: x = -L}}
"""
    [asked] = solve(problem(text)).asked
    assert not asked.branches


CRATE = """
title: Crate pushed over a rough floor
parameters: {m: 50 kg, g: 10 m/s^2, mu: 0.2, w: 0.8 m, h: 1.2 m, c: 1 m, P: N}
coordinates: [x, y, theta]
let: {a: -w/2*e1_crate - h/2*e2_crate, b: w/2*e1_crate - h/2*e2_crate}
bodies: {crate: {mass: m, inertia: m*(w^2 + h^2)/12, position: x*i + y*j, angle: theta}}
constraints:
  A: {equation: "dot(r_crate + a, j) >= 0", reaction: N_A}
  B: {equation: "dot(r_crate + b, j) >= 0", reaction: N_B}
gravity: -g*j
forces:
  push: {on: crate, vector: P*i, at: r_crate + (c - h/2)*j}
  rub_A: {friction: mu, constraint: A, on: crate, at: r_crate + a, slip: i}
  rub_B: {friction: mu, constraint: B, on: crate, at: r_crate + b, slip: i}
ask:
  force: {quantity: P, when: N_A = 0}
  acceleration: {quantity: "x''", when: N_A = 0}
"""


def test_a_crate_stands_upright_and_tips_at_one_value_of_the_force(problem: Read) -> None:
    """The floor holds θ = 0 or π, and 0 is meant; of what is asked for at N = 0 the force without a value is found."""
    force, acceleration = solve(problem(CRATE)).asked
    m, g, mu, w, h, c = sp.symbols("m g mu w h c", positive=True)
    tips = m * g * (w - mu * h) / (2 * c - h)
    for asked, expected in ((force, tips), (acceleration, tips / m - mu * g)):
        [b] = asked.branches
        assert is_zero(b.values[0] - expected)
        assert not b.provided
