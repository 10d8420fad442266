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
    assert "ẋ = 1 m/s" in page
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


WHEEL = """
title: Wheel that is pulled by a cord round its hub
axes: {i: right, j: up}
parameters:
  m: 50 kg
  R: 100 mm
  r: 60 mm
  k_O: 70 mm
  P: 200 N
  mu: 0.15
  mu_s: 0.2
  g: 9.81 m/s^2
coordinates: [x, y, theta]
bodies: {wheel: {mass: m, inertia: m*k_O^2, position: x*i + y*j, angle: -theta}}
constraints: {floor: {equation: y >= R, reaction: N}}
forces:
  pull: {on: wheel, vector: P*i, at: r_wheel - r*j}
  rub: {friction: mu, static: mu_s, constraint: floor, on: wheel, at: r_wheel - R*j}
gravity: -g*j
initial: {x: 0, x': 0, theta: 0, theta': 0}
ask: {a: {quantity: "x''", when: t = 0}, turning: {quantity: "theta''", when: t = 0}}
"""


def test_a_wheel_that_is_pulled_hard_begins_to_slip(problem: Read) -> None:
    """Rolling would need 200 N - 40.27 N > 98.1 N of friction; so a = P/m - mu g, and it turns backwards."""
    solved = report(problem(WHEEL))
    found = as_object(solved)["asked"]
    friction = 0.15 * 50 * 9.81
    turning = (friction * 0.1 - 200 * 0.06) / (50 * 0.07**2)
    assert [a["number"] for a in found] == pytest.approx([(200 - friction) / 50, turning])
    assert all(c.passed for c in solved.solution.checks)


def test_a_wheel_that_is_pulled_gently_rolls(problem: Read) -> None:
    with pytest.raises(ProblemError, match="slip that does not begin"):
        solve(problem(WHEEL.replace("P: 200 N", "P: 20 N")))


def test_a_force_between_two_bodies_is_compared_with_the_normal_force_in_either_sense(problem: Read) -> None:
    """The plank draws the bar with F = m_2 a t/(m_1 + m_2), which is mu m_2 g at t = mu g (m_1 + m_2)/a."""
    text = """
title: A bar on a plank that is pulled harder and harder
axes: {i: right, j: up}
parameters: [m_1, m_2, g, mu, a]
coordinates: [x_1, x_2, y]
particles:
  plank: {mass: m_1, position: x_1*i}
  bar: {mass: m_2, position: x_2*i + y*j}
constraints:
  top: {equation: y >= 0, reaction: N}
  together: {equation: x_1 = x_2, reaction: F}
forces: {pull: {on: plank, vector: a*t*i}}
gravity: -g*j
ask: {start: {quantity: t, when: F = mu*N}}
"""
    for written in (text, text.replace("x_1 = x_2", "x_2 = x_1")):
        assert asked(problem(written))["start"]["value"] == "mu*(m_1 + m_2)*g/a"


def test_friction_in_a_tube_that_turns_is_that_of_the_force_across_it(problem: Read) -> None:
    """N = 2 m w r' in the tube, so that r'' + 2 mu w r' - w^2 r = 0 with the roots w (-mu +- sqrt(mu^2 + 1))."""
    solved = report(
        problem("""
title: A bead in a rough tube that turns
parameters: [m, w, mu, b]
coordinates: [r, phi]
frame: {type: polar, coordinates: [r, phi]}
particles: {bead: {mass: m, position: r*e_r}}
constraints: {tube: {equation: phi = w*t, reaction: N}}
forces: {rub: {friction: mu, constraint: tube, on: bead, slip: e_r, surface_velocity: r*w*e_phi}}
initial: {r: b, r': 0}
ask: {motion: {quantity: r, by: t}}
answers: {equations: ["r'' + 2*mu*w*r' - w^2*r = 0"]}
""")
    )
    [branch] = solved.solution.asked[0].branches
    values = {"mu": 0.75, "w": 1.0, "b": 1.0, "t": 2.0}
    here = branch.rhs.xreplace({s: sp.Float(values[s.name]) for s in branch.rhs.free_symbols})
    assert float(here) == pytest.approx(0.8 * math.exp(1) + 0.2 * math.exp(-4))
    assert as_object(solved)["answers"][0]["verdict"] == "equivalent"


def test_a_blade_on_an_incline_describes_a_cycloid(problem: Read) -> None:
    """With theta = w t its speed along itself is (g sin(alpha)/w) sin(w t)."""
    found = asked(
        problem("""
title: Knife edge on an inclined plane
axes: {i: down the plane, j: across}
parameters: {m: positive, I: positive, g: positive, alpha: acute, w: positive}
coordinates: [x, y, theta]
bodies: {blade: {mass: m, inertia: I, position: x*i + y*j, angle: theta}}
constraints: {edge: "x'*sin(theta) = y'*cos(theta)"}
gravity: g*sin(alpha)*i
initial: {x: 0, y: 0, theta: 0, x': 0, y': 0, theta': w}
ask:
  down: {quantity: x, by: t}
  across: {quantity: y, by: t}
  lowest: {quantity: x, when: theta = pi/2}
""")
    )
    assert found["down"]["value"] == "g*sin(w*t)^2*sin(alpha)/(2*w^2)"
    assert found["across"]["value"] == "g*(2*w*t - sin(2*w*t))*sin(alpha)/(4*w^2)"
    assert found["lowest"]["value"] == "g*sin(alpha)/(2*w^2)"


def test_the_distance_to_a_speed(problem: Read) -> None:
    """I w' = -a sqrt(w): w dw/w' from w_0 to 0 is 2 I w_0^(3/2)/(3 a); after a third of the speed, 26/27 less."""
    solved = report(
        problem("""
title: Flywheel braked by a moment that grows with the root of the speed
parameters: [I, a, w]
coordinates: [phi]
bodies: {flywheel: {mass: 1, inertia: I, position: 0*i, angle: phi}}
forces: {brake: {on: flywheel, moment: -a*sqrt(phi')*k}}
initial: {phi: 0, phi': w}
ask: {angle: {quantity: phi, when: phi' = 0}, part: {quantity: phi, when: phi' = w/4}}
""")
    )
    angle, part = (a.branches[0].rhs for a in solved.solution.asked)
    values = {"I": 2, "a": 3, "w": 4}
    whole, some = (e.xreplace({s: sp.Integer(values[s.name]) for s in e.free_symbols}) for e in (angle, part))
    assert (whole, some) == (sp.Rational(32, 9), sp.Rational(28, 9))
    assert "integral of φ̇/φ̈" in " ".join(terminal.text(solved.derivation, solved.notation, 100).split())


def test_values_decide_which_damping_it_is(problem: Read) -> None:
    """m = 2, c = 8, k = 58: e^(-2t) cos 5t and so on; the aperiodic cases are not printed."""
    text = """
title: A damped oscillator
parameters: {m: 2 kg, c: 8 Ns/m, k: 58 N/m, b: 10 cm}
coordinates: [x]
particles: {P: {mass: m, position: x*i}}
forces: {spring: {potential: k*x^2/2}, damper: {on: P, vector: "-c*x'*i"}}
initial: {x: b, x': 0}
ask: {motion: {quantity: x, by: t}}
"""
    [answer] = solve(problem(text)).asked
    assert [[c.relation for c in b.conditions] for b in answer.branches] == [[">"]]


def test_a_speed_with_an_acute_angle_is_written_without_modulus_and_condition(problem: Read) -> None:
    """Launched level at the angle beta of a bowl, it reaches the rim: v^2 cos(beta) = 2 g R."""
    found = asked(
        problem("""
title: Horizontal speed that carries a particle to the rim of a bowl
axes: {k: up}
parameters: {m: positive, g: positive, R: positive, beta: acute, v: positive}
coordinates: [theta, phi]
particles: {P: {mass: m, position: "R*sin(theta)*cos(phi)*i + R*sin(theta)*sin(phi)*j - R*cos(theta)*k"}}
gravity: -g*k
initial: {theta: beta, theta': 0, phi: 0, phi': v/(R*sin(beta))}
ask: {least: {quantity: v, when: [theta = pi/2, theta' = 0]}}
""")
    )
    assert (found["least"]["value"], found["least"]["conditions"]) == ("sqrt(2*g*R/cos(beta))", [])


def test_the_force_on_a_chain_as_a_function_of_its_height(problem: Read) -> None:
    """Lifted at the speed v from a heap: the weight rho g y and the momentum rho v^2 in a second."""
    found = solve(
        problem("""
title: Chain lifted from a heap at constant speed
axes: {j: up}
parameters: [rho, v, g]
coordinates: [y]
particles: {chain: {mass: rho*y, position: y*j, gains: {velocity: 0}}}
forces: {weight: {on: chain, vector: -rho*y*g*j}}
constraints: {hand: {equation: y = v*t, reaction: P}}
ask: {force: {quantity: P, by: y}}
""")
    )
    [branch] = found.asked[0].branches
    values = {"rho": 2, "v": 3, "g": 10, "y": 5}
    here = branch.rhs.xreplace({s: sp.Integer(values[s.name]) for s in branch.rhs.free_symbols})
    assert abs(here) == 2 * (10 * 5 + 9)


def test_a_crank_at_an_angle_of_its_uniform_rotation(problem: Read) -> None:
    """x = b cos(w t) + sqrt(l^2 - b^2 sin(w t)^2), differentiated numerically; the rod pulls the piston."""
    found = asked(
        problem("""
title: Force in a connecting rod
axes: {i: right, j: up}
parameters: {m: 1.5 kg, b: 75 mm, l: 250 mm, w: 2000 rpm}
coordinates: {x: {range: [l - b, l + b]}}
particles: {piston: {mass: m, position: x*i}}
constraints: {rod: {equation: "(x - b*cos(w*t))^2 + b^2*sin(w*t)^2 = l^2", reaction: T, by: rod}}
ask:
  velocity: {quantity: "x'", when: "w*t = 60 deg"}
  acceleration: {quantity: "x''", when: "w*t = 60 deg"}
  force: {quantity: T, when: "w*t = 60 deg"}
""")
    )
    b, l, w, h = 0.075, 0.25, 2000 * math.pi / 30, 1e-6

    def x(angle: float) -> float:
        return b * math.cos(angle) + math.sqrt(l**2 - (b * math.sin(angle)) ** 2)

    at = math.pi / 3
    velocity, acceleration = (
        w * (x(at + h) - x(at - h)) / (2 * h),
        w**2 * (x(at + 1e-4) - 2 * x(at) + x(at - 1e-4)) / 1e-8,
    )
    assert found["velocity"]["number"] == pytest.approx(velocity, rel=1e-5)
    assert found["acceleration"]["number"] == pytest.approx(acceleration, rel=1e-5)
    cosine = math.sqrt(1 - (b * math.sin(at) / l) ** 2)
    assert found["force"]["number"] == pytest.approx(-1.5 * acceleration / cosine, rel=1e-5)


def test_the_side_to_which_a_ball_rebounds_follows_from_the_values(problem: Read) -> None:
    """(m_A - e m_B) v/(m_A + m_B) = -0.08 v: it goes back to the side from which it came."""
    found = asked(
        problem("""
title: Pendulum ball that hits a block
axes: {i: right, j: up}
parameters: {m_A: 2 kg, m_B: 3 kg, l: 1.2 m, g: 9.81 m/s^2, e: 0.8}
coordinates: [theta, x]
particles: {A: {mass: m_A, position: l*sin(theta)*i - l*cos(theta)*j}, B: {mass: m_B, position: x*i - l*j}}
gravity: -g*j
impact:
  before: {theta: 0, theta': sqrt(g/l), x: 0, x': 0}
  constraints: {touch: {equation: x >= l*sin(theta), reaction: P}}
  restitution: {touch: e}
find: impact
ask: {rebound: {quantity: theta, when: "theta' = 0"}}
""")
    )
    assert found["rebound"]["number"] == pytest.approx(-math.acos(1 - 0.08**2 / 2))


def test_the_force_at_which_a_spool_slips_has_the_sense_of_the_file(problem: Read) -> None:
    """Drawn by a cord from under its hub it rolls towards the hand: F (R - r) R = m (k^2 + R^2) a."""
    found = asked(
        problem("""
title: Spool
axes: {i: right, j: up}
parameters: {m: 6 kg, R: 200 mm, r: 100 mm, k: 150 mm, F: {unit: N}, mu_s: 0.3, g: 9.81 m/s^2}
coordinates: [x, y, theta]
bodies: {spool: {mass: m, inertia: m*k^2, position: x*i + y*j, angle: -theta}}
constraints: {floor: {equation: y >= R, reaction: N}, rolling: {equation: "x' = R*theta'", reaction: H}}
gravity: -g*j
forces: {pull: {on: spool, vector: F*i, at: r_spool - r*j}}
ask:
  force: {quantity: F, when: H = mu_s*N}
  acceleration: {quantity: "x''", when: H = mu_s*N}
""")
    )
    force = 0.3 * 6 * 9.81 * (0.15**2 + 0.2**2) / (0.15**2 + 0.2 * 0.1)
    assert found["force"]["number"] == pytest.approx(force)
    assert found["acceleration"]["number"] == pytest.approx(force * 0.2 * 0.1 / (6 * (0.15**2 + 0.2**2)))


def test_a_steady_rate_has_no_sense(problem: Read) -> None:
    text = """
title: Merry-go-round
axes: {k: up}
parameters: {m: positive, b: 3 m, l: 4 m, g: 9.81 m/s^2}
coordinates: {phi: angle, theta: {range: [0, 90 deg]}}
particles: {chair: {mass: m, position: (b + l*sin(theta))*(cos(phi)*i + sin(phi)*j) - l*cos(theta)*k}}
gravity: -g*k
ask: {rate: {quantity: "phi'", when: ["theta = 30 deg", "theta' = 0", "theta'' = 0"]}}
"""
    found = asked(problem(text))["rate"]
    rate = math.sqrt(9.81 * math.tan(math.pi / 6) / 5)
    assert (found["number"], found["unit"]) == (pytest.approx(rate), "rad/s")
    explained = report(problem(text))
    page = terminal.text(explained.derivation, explained.notation, 100)
    assert "|φ̇| ≈ 1.064 rad/s" in page
    assert "either sense" in page


def test_slip_goes_on_to_a_place_that_is_reached_in_the_first_direction(problem: Read) -> None:
    """A block that slides against a spring is fastest where c x = m g (sin - mu cos)."""
    text = """
title: Block on a rough slope against a spring
axes: {i: down the slope, j: up}
parameters: {m: 2 kg, g: 9.81 m/s^2, alpha: 30 deg, mu: %s, c: 800 N/m, v: 2 m/s}
coordinates: [x, y]
particles: {block: {mass: m, position: x*i + y*j}}
constraints: {slope: {equation: y >= 0, reaction: N}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces: {spring: {potential: c*x^2/2}, rub: {friction: mu, constraint: slope, on: block, slip: positive}}
initial: {x: 0, x': v}
ask: {fastest: {quantity: x, when: "x'' = 0"}}
"""
    found = asked(problem(text % 0.25))["fastest"]
    assert found["conditions"] == []
    assert found["number"] == pytest.approx(2 * 9.81 * (0.5 - 0.25 * math.sqrt(3) / 2) / 800)
    behind = asked(problem(text % 0.7))["fastest"]  # it would have to slip back to get there
    assert behind["value"] is None


def test_a_drop_that_gathers_mist(problem: Read) -> None:
    found = asked(
        problem("""
title: Raindrop
axes: {j: down}
parameters: [k, g, m_0]
coordinates: [y, m]
particles: {drop: {mass: m, position: y*j, gains: {velocity: 0}}}
constraints: {mist: "m' = k*m*y'"}
gravity: g*j
initial: {y: 0, y': 0, m: m_0}
ask:
  speed: {quantity: "y'", by: y}
  final: {quantity: "y'", when: "y'' = 0"}
""")
    )
    assert found["speed"]["value"] == "sqrt(g*(1 - exp(-2*k*y))/k)"
    assert found["speed"]["conditions"] == ["y >= 0"]
    assert (found["final"]["value"], found["final"]["conditions"]) == ("sqrt(g/k)", ["in the limit t → ∞"])


def test_a_condition_with_a_length_in_a_sum_hides_its_unit(problem: Read) -> None:
    text = """
title: Fall
axes: {j: down}
parameters: {m: 2 kg, g: 9.81 m/s^2, L: {unit: m}}
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: g*j
initial: {y: L, y': 0}
ask: {speed: {quantity: "y'", when: y = L + 1.5 km}}
answers: {ask: {speed: 171.6 m/s}}
"""
    read = problem(text)
    assert asked(read)["speed"]["unit"] == "m/s"
    assert [a.verdict.value for a in report(read).answers] == ["equivalent"]


def test_a_fall_that_a_parachute_slows(problem: Read) -> None:
    """v' = g - c v^2/m from v to u: t = (w/2g) ln[(u + w)(v - w)/((u - w)(v + w))] with the final speed w."""
    found = asked(
        problem("""
title: Parachutist
axes: {j: down}
parameters: {m: 80 kg, g: 9.81 m/s^2, c: 30 kg/m, v: 50 m/s}
coordinates: [y]
particles: {P: {mass: m, position: y*j}}
gravity: g*j
forces: {drag: {on: P, vector: "-c*y'*abs(y')*j"}}
initial: {y: 0, y': v}
ask: {time: {quantity: t, when: "y' = 10 m/s"}}
""")
    )
    w = math.sqrt(80 * 9.81 / 30)
    time = w / (2 * 9.81) * math.log((10 + w) * (50 - w) / ((10 - w) * (50 + w)))
    assert (found["time"]["how"], found["time"]["number"]) == ("exact", pytest.approx(time))


def test_conditions_have_no_roots_of_squares(problem: Read) -> None:
    """A collar that a counterweight holds falls to 2 m M d/(M^2 - m^2), where the cord has the length of a square."""
    found = asked(
        problem("""
title: Collar and counterweight
axes: {i: right, j: down}
parameters: [m, M, d, L, g]
coordinates: [y, z]
particles: {collar: {mass: m, position: y*j}, weight: {mass: M, position: d*i + z*j}}
constraints: {cord: {equation: sqrt(d^2 + y^2) + z = L, reaction: T, by: string}}
gravity: g*j
generalized_coordinates: {fall: {coordinates: [y]}}
initial: {y: 0, y': 0}
ask: {lowest: {quantity: y, when: "y' = 0"}}
""")
    )
    assert found["lowest"]["conditions"] == ["M > m"]
