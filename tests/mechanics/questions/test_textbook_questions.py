"""Problems as textbooks state them: values with units, slip that ends, friction from rest, answers worked out by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import terminal
from lagrange.render.json import as_object

Read = Callable[[str], Problem]

BALL = """
title: A ball thrown along a lane
axes: {i: right, j: up}
parameters: {m: positive, g: {value: 9.81 m/s^2}, R: {value: 0.1 m}, mu: {value: 0.1}, v: {value: 7 m/s}, L: {unit: m}}
coordinates: [x, y, theta]
bodies: {ball: {mass: m, inertia: 2/5*m*R^2, position: x*i + y*j, angle: theta}}
constraints: {lane: {equation: y >= R, reaction: N}}
gravity: -g*j
forces: {rub: {friction: mu, constraint: lane, on: ball, at: r_ball - R*j, slip: i}}
initial: {x: 0, x': v, theta: 0, theta': 0}
"""
BLOCK = """
title: Block on a spring on a rough table
axes: {i: right, j: up}
parameters: {m: {value: 2 kg}, k: {value: 200 N/m}, mu: {value: 0.1}, g: {value: 9.81 m/s^2}}
coordinates: [x, y]
particles: {B: {mass: m, position: x*i + y*j}}
constraints: {table: {equation: y >= 0, reaction: N}}
gravity: -g*j
forces:
  spring: {potential: k*x^2/2}
  rub: {friction: mu, constraint: table, on: B}
ask: {left: {quantity: x, when: "x' = 0"}}
"""


def asked(problem: Problem) -> dict[str, Any]:
    return {a["name"]: a for a in as_object(report(problem))["asked"]}


def test_a_ball_that_has_begun_to_roll_slips_no_more(problem: Read) -> None:
    rolls = 2 * 7 / (7 * 0.1 * 9.81)
    early = asked(problem(BALL + 'ask: {later: {quantity: "x\'", when: t = 2}}'))["later"]
    assert early["number"] == pytest.approx(7 - 0.1 * 9.81 * 2)
    assert rolls < 3
    with pytest.raises(ProblemError, match="slip has ended"):
        solve(problem(BALL + 'ask: {later: {quantity: "x\'", when: t = 3}}'))


def test_how_far_it_slips_is_a_condition(problem: Read) -> None:
    letters = BALL.replace("{value: 9.81 m/s^2}", "positive").replace("{value: 0.1}", "positive")
    letters = letters.replace("{value: 7 m/s}", "positive")
    found = asked(problem(letters + 'ask: {v: {quantity: "x\'", when: x = L}, by: {quantity: "x\'", by: t}}'))
    assert "12*v^2 >= 49*mu*g*L" in [c.replace("g*L*mu", "mu*g*L") for c in found["v"]["conditions"]]
    assert any(c.startswith("t <=") for c in found["by"]["conditions"])


def test_a_number_in_a_question_hides_its_unit(problem: Read) -> None:
    found = asked(
        problem(BALL + 'ask: {far: {quantity: x, when: t = 1}, late: {quantity: "x\'", when: "t = 1000 ms"}}')
    )
    assert (found["far"]["number"], found["far"]["unit"]) == (pytest.approx(7 - 0.4905), "m")
    assert (found["late"]["number"], found["late"]["unit"]) == (pytest.approx(7 - 0.981), "m/s")


def test_friction_from_rest(problem: Read) -> None:
    moving = problem(BLOCK + "initial: {x: 10 cm, x': 0}")
    assert asked(moving)["left"]["number"] == pytest.approx(-0.1 + 2 * 0.1 * 2 * 9.81 / 200)
    with pytest.raises(ProblemError, match="friction holds it at rest"):
        solve(problem(BLOCK + "initial: {x: 5 mm, x': 0}"))
    stuck = BLOCK.replace("friction: mu,", "friction: mu, static: 2,")
    with pytest.raises(ProblemError, match="friction holds it at rest"):
        solve(problem(stuck.replace("static: 2", "static: mu_s").replace("mu: {", "mu_s: {value: 2}, mu: {")
                      + "initial: {x: 10 cm, x': 0}"))  # fmt: skip


def test_angles_in_degrees_and_numbers_beside_expressions(problem: Read) -> None:
    text = """
title: Pendulum from the horizontal
axes: {i: right, j: down}
parameters: {m: {value: 2 kg}, l: {value: 800 mm}, g: {value: 9.81 m/s^2}}
coordinates: [theta]
particles: {P: {mass: m, position: l*cos(theta)*i + l*sin(theta)*j}}
gravity: g*j
initial: {theta: 0 deg, theta': 0 rpm}
ask: {speed: {quantity: "l*theta'", when: theta = 30 deg}}
"""
    page = terminal.text(*(lambda r: (r.derivation, r.notation))(report(problem(text))), 100)
    assert f"l θ̇ ≈ {math.sqrt(9.81 * 0.8):.3f} m/s" in page


def test_the_turning_point_is_not_the_start(problem: Read) -> None:
    text = """
title: Particle in a paraboloid
parameters: [m, g, a, h, v]
coordinates: [rho, phi]
particles: {P: {mass: m, position: "rho*cos(phi)*i + rho*sin(phi)*j + rho^2/a*k"}}
gravity: -g*k
initial: {rho: "sqrt(a*h)", rho': 0, phi: 0, phi': "v/sqrt(a*h)"}
ask: {other: {quantity: "rho^2/a", when: "rho' = 0"}}
"""
    assert asked(problem(text))["other"]["value"] == "v^2/(2*g)"


def test_a_relation_between_parameters_that_the_values_violate(problem: Read) -> None:
    text = """
title: Damped block
parameters: {m: {value: 5 kg}, c: {value: 20 N s/m}, k: {value: 500 N/m}, x_0: {value: 50 mm}}
coordinates: [x]
particles: {B: {mass: m, position: x*i}}
forces: {s: {potential: k*x^2/2}, d: {damper: c, between: [B, 0*i]}}
initial: {x: x_0, x': 0}
ask: {x_t: {quantity: x, when: t = 0.5 s}}
answers: {ask: {x_t: -0.0002772}}
"""
    w = math.sqrt(96)
    found = report(problem(text))
    [answer] = as_object(found)["asked"]
    assert answer["number"] == pytest.approx(0.05 * math.exp(-1) * (math.cos(w / 2) + 2 / w * math.sin(w / 2)))
    assert [a["verdict"] for a in as_object(found)["answers"]] == ["equivalent"]
