"""Problems as textbooks state them: values with units, slip that ends, friction from rest, answers worked out by hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest
import sympy as sp

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


def test_the_sense_of_the_slip_at_the_start(problem: Read) -> None:
    """A spinning cylinder put on a floor: x' = μ g t meets R θ' = R w − 2 μ g t, after R w/(3 μ g), at R w/3."""
    cylinder = BALL.replace("2/5*m*R^2", "m*R^2/2").replace("angle: theta", "angle: -theta").replace(", slip: i", "")
    cylinder = cylinder.replace("x': v", "x': 0").replace("theta': 0}", "theta': 30 rad/s}")
    read = problem(
        cylinder
        + """ask:
  time: {quantity: t, when: "x' = R*theta'"}
  speed: {quantity: "x'", when: "x' = R*theta'"}
  later: {quantity: x, by: t}
"""
    )
    found = asked(read)
    assert found["time"]["number"] == pytest.approx(0.1 * 30 / (3 * 0.1 * 9.81))
    assert (found["time"]["unit"], found["speed"]["unit"]) == ("s", "m/s")
    assert found["speed"]["number"] == pytest.approx(1)
    assert len(found["later"]["conditions"]) == 1
    explained = report(read)
    page = " ".join(terminal.text(explained.derivation, explained.notation, 100).split())
    assert "that is ẋ = 1 m/s" in page
    assert "The motion begins with R θ̇ − ẋ > 0" in page


PENDULUM = """
title: Pendulum
parameters: {m: {value: 2}, l: {value: 3}, g: {value: 9.81}, v: positive}
coordinates: [theta]
particles: {P: {mass: m, position: l*cos(theta)*i + l*sin(theta)*j}}
gravity: -g*j
"""


def test_an_angle_has_its_sign_in_numbers(problem: Read) -> None:
    """Let go horizontally it falls to negative angles: l θ'^2 = g at sin θ = −1/2, that is −30°, and θ'' = 0 at −90°."""
    read = problem(
        PENDULUM
        + """initial: {theta: 0, theta': 0}
ask: {low: {quantity: theta, when: "theta'' = 0"}, half: {quantity: theta, when: "l*theta'^2 = g"}}
"""
    )
    found = asked(read)
    assert {a["unit"] for a in found.values()} == {"rad"}
    assert [a["number"] for a in found.values()] == pytest.approx([-math.pi / 2, -math.pi / 6])
    explained = report(read)
    assert "θ = −30°" in " ".join(terminal.text(explained.derivation, explained.notation, 100).split())


def test_what_holds_at_the_start_needs_no_return(problem: Read) -> None:
    read = PENDULUM + "initial: {theta: -pi/2, theta': v/l}\nask: {a: {quantity: T_kinetic, when: theta = -pi/2}}\n"
    assert asked(problem(read))["a"]["conditions"] == []


@pytest.mark.parametrize(
    ("potential", "turn", "conditions"),
    [
        ("U*tan(a*x)^2", lambda u: math.atan(u), 0),
        ("U*(1 - exp(-a*x))^2", lambda u: -math.log(1 - u), 1),
        ("U*(exp(2*a*x) - 2*exp(a*x))", lambda u: math.log(1 + u), 0),
    ],
)
def test_turning_points_by_hand(potential: str, turn: Callable[[float], float], conditions: int, problem: Read) -> None:
    """With m v²/2 = U u² they are at tan a x = u, e^(−a x) = 1 − u, e^(a x) = 1 + u."""
    text = "title: Well\nparameters: [m, U, a, v]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"
    text += f"forces: {{f: {{potential: {potential}}}}}\ninitial: {{x: 0, x': v}}\n"
    solution = solve(problem(text + 'ask: {turn: {quantity: x, when: "x\' = 0"}}\n'))
    [branch] = solution.asked[0].branches
    values = {"m": 2, "U": 4, "a": 3, "v": 1}
    here = branch.rhs.xreplace({s: sp.Integer(values[s.name]) for s in branch.rhs.free_symbols})
    assert float(here) == pytest.approx(turn(0.5) / 3)
    assert len(branch.conditions) == conditions
