"""Friction at rest: conditions against a linear program written from the free bodies, at random numbers; by hand."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache

import pytest

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import NotCoveredError
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import json as in_json
from lagrange.render import terminal
from tests.support.trajectories import function_of

Read = Callable[[str], Problem]
Numbers = Mapping[str, float]

LADDER = """title: Ladder, its inclination measured from the wall
parameters: [m, g, l, mu_A, mu_B]
coordinates: [x, y, theta]
let: {{e: "sin(theta)*i - cos(theta)*j"}}
bodies: {{ladder: {{mass: m, inertia: m*l^2/3, position: x*i + y*j, angle: theta}}}}
constraints:
  wall: {{equation: "x - l*sin(theta) >= 0", reaction: N_B}}
  floor: {{equation: "y - l*cos(theta) >= 0", reaction: N_A}}
gravity: -g*j
forces:
  below: {{friction: mu_A, static: mu_A, constraint: floor, on: ladder, at: r_ladder + l*e{below}}}
{above}
find: {find}
"""
ABOVE = "  above: {friction: mu_B, static: mu_B, constraint: wall, on: ladder, at: r_ladder - l*e%s}"
ROUGH = LADDER.format(below="", above=ABOVE % "", find="equilibrium")
INCLINE = """title: Block on an incline, pushed horizontally
parameters: [m, g, P, alpha, mu, mu_s]
coordinates: [x, y]
particles: {{block: {{mass: m, position: x*i + y*j}}}}
constraints: {{plane: {{equation: y {relation} 0, reaction: N}}}}
gravity: g*sin(alpha)*i - g*cos(alpha)*j
forces:
  push: {{on: block, vector: P*(-cos(alpha)*i - sin(alpha)*j)}}
  rub: {{friction: mu, static: mu_s, constraint: plane, on: block{more}}}
find: {find}
"""
PUSHED = INCLINE.format(relation=">=", more="", find="equilibrium")


compiled = cache(function_of)


def said(rest: AtRest, values: Numbers) -> bool | None:
    """Whether the conditions hold; None too near to a limit."""
    verdicts = []
    for case in rest.cases:
        gaps = [compiled(c.right - c.left)(values) for c in case]
        if any(abs(gap) < 1e-6 for gap in gaps):
            return None
        verdicts.append(all(gap > 0 for gap in gaps))
    return any(verdicts)


def solved(problem: Read, text: str) -> Solution:
    solution = solve(problem(text))
    assert [(c.name, c.choice) for c in solution.checks if c.passed is not True] == []
    return solution


def rest_of(solution: Solution) -> AtRest:
    return next(v.at_rest for v in reversed(solution.views) if v.at_rest is not None)


def test_what_is_written(problem: Read) -> None:
    explained = report(problem(ROUGH))
    page = " ".join(terminal.text(explained.derivation, explained.notation, 110).split())
    assert "N_B is not determined: the system is statically indeterminate" in page
    assert "(1 − μ_A μ_B) tan θ ≤ 2μ_A" in page
    assert "cos θ > 0 and sin θ > 0 are assumed" in page


# -- impending motion --------------------------------------------------------------------------------------------------


# -- what is refused ---------------------------------------------------------------------------------------------------


def test_without_a_static_coefficient_it_is_not_covered(problem: Read) -> None:
    with pytest.raises(NotCoveredError, match="has no coefficient of friction at rest"):
        solve(problem(PUSHED.replace(", static: mu_s", "")))


def test_in_space_the_friction_has_two_components(problem: Read) -> None:
    text = (
        "title: Block on an incline, pushed across\nparameters: [m, g, alpha, P, mu]\ncoordinates: [x, y, z]\n"
        "particles: {B: {mass: m, position: '[x, y, z]'}}\nconstraints: {plane: {equation: z >= 0, reaction: N}}\n"
        "gravity: g*sin(alpha)*i - g*cos(alpha)*k\nforces: {push: {on: B, vector: P*j}, "
        "rub: {friction: mu, static: mu, constraint: plane, on: B}}\nfind: equilibrium\n"
        "answers: {rest: ['P^2 + (m*g*sin(alpha))^2 <= (mu*m*g*cos(alpha))^2']}\n"
    )
    [answer] = compared_answers(solved(problem, text))
    assert answer.verdict.value in ("equivalent", "undecided")
    rest = rest_of(solve(problem(text)))
    assert said(rest, {"m": 1, "g": 10, "alpha": 0.3, "P": 3, "mu": 0.45}) is True  # 4.21 <= 4.30
    assert said(rest, {"m": 1, "g": 10, "alpha": 0.3, "P": 3.2, "mu": 0.45}) is False


def test_rest_is_not_about_the_friction_of_the_motion(problem: Read) -> None:
    """If both are asked, kinetic friction is no applied force at rest."""
    text = INCLINE.format(relation=">=", more=", slip: i", find="[motion, equilibrium, impending]").replace("P, ", "")
    text = text.replace("  push: {on: block, vector: P*(-cos(alpha)*i - sin(alpha)*j)}\n", "")
    answers = "answers: {rest: ['tan(alpha) <= mu_s'], equations: [\"x'' = g*sin(alpha) - mu*g*cos(alpha)\"]}\n"
    verdicts = {a.name: a.verdict.value for a in compared_answers(solved(problem, text + answers))}
    assert verdicts == {"equations": "equivalent", "rest": "equivalent"}


def test_where_rest_is_impossible(problem: Read) -> None:
    """The string leaves the cylinder where it touches the incline: nothing balances the moment of the weight."""
    explained = report(
        problem(
            "title: Cylinder held where it touches\nparameters: [m, g, R, alpha, mu]\ncoordinates: [x, y, theta]\n"
            "bodies: {c: {mass: m, inertia: m*R^2/2, position: x*i + y*j, angle: theta}}\n"
            "constraints: {plane: {equation: y >= R, reaction: N}, s: {equation: x + R*theta <= 0, by: string}}\n"
            "gravity: g*sin(alpha)*i - g*cos(alpha)*j\nforces: {rub: {friction: mu, static: mu, constraint: plane, "
            "on: c, at: r_c - R*j}}\nfind: [equilibrium, impending]\n"
        )
    )
    written = in_json.as_object(explained)
    assert written["rest"]["possible"] is False
    assert written["equilibrium"] == []
    page = " ".join(terminal.text(explained.derivation, explained.notation, 100).split())
    assert "the system cannot be at rest" in page
    assert "the forces balance for none of the directions of slip" in page


JAMMED = """title: A drawer pulled beside its middle
axes: {i: outward, j: across}
parameters: {P: positive, a: positive, b: positive, c: positive, mu: positive}
coordinates: [x, y, theta]
bodies: {drawer: {inertia: 0, position: x*i + y*j, angle: theta}}
constraints:
  left: {equation: "y - a/2*sin(theta) + b/2*(1 - cos(theta)) >= 0", reaction: N_1}
  right: {equation: "y + a/2*sin(theta) - b/2*(1 - cos(theta)) <= 0", reaction: N_2}
forces:
  pull: {on: drawer, vector: P*i, at: r_drawer + a/2*i - c*j}
  rub1: {friction: mu, static: mu, constraint: left, on: drawer, at: "r_drawer - a/2*e1_drawer - b/2*e2_drawer", slip: i}
  rub2: {friction: mu, static: mu, constraint: right, on: drawer, at: "r_drawer + a/2*e1_drawer + b/2*e2_drawer", slip: i}
generalized_coordinates: {along: {coordinates: [x], substitute: {y: 0, theta: 0}}}
find: [equilibrium, impending]
answers: {equilibrium: [mu = a/(2*c)]}
"""


def test_a_drawer_jams(problem: Read) -> None:
    """By hand: a N = c P + (F_2 - F_1) b/2 and F_1 + F_2 = P, |F| <= mu N; mu >= a/b locks without any load."""
    rest = rest_of(solved(problem, JAMMED))
    assert sorted(f"{c.left} <= {c.right}" for case in rest.cases for c in case) == ["a/(2*c) <= mu", "a/b <= mu"]


PILE = """title: Two blocks tied by a cable over a pulley
axes: {i: right, j: up}
parameters: {m_A: positive, m_B: positive, g: positive, mu: positive}
unknowns: [P]
coordinates: [x_A, y_A, x_B, y_B]
particles: {A: {mass: m_A, position: x_A*i + y_A*j}, B: {mass: m_B, position: x_B*i + y_B*j}}
constraints:
  cable: {equation: x_A + x_B = 0, reaction: T, by: string}
  between: {equation: y_A - y_B >= 0, reaction: N_1}
  floor: {equation: y_B >= 0, reaction: N_2}
gravity: -g*j
forces:
  push: {on: B, vector: -P*i}
  above: {friction: mu, static: mu, constraint: between, on: A, slip: positive}
  opposite: {friction: mu, static: mu, constraint: between, on: B, slip: negative}
  below: {friction: mu, static: mu, constraint: floor, on: B, slip: negative}
find: [impending, equilibrium]
answers: {equilibrium: [P = mu*g*(3*m_A + m_B)], rest: ["P <= mu*g*(3*m_A + m_B)", "P >= -mu*g*(3*m_A + m_B)"]}
"""


def test_each_of_two_blocks_with_an_entry_of_its_own(problem: Read) -> None:
    """By hand: T = mu m_A g on A, and P = T + mu m_A g + mu (m_A + m_B) g on B."""
    written = in_json.as_object(report(problem(PILE)))
    assert [a["verdict"] for a in written["answers"]] == ["equivalent", "equivalent"]


MAN = """title: Man on a ladder whose ends have names
axes: {i: right, j: up}
parameters: {W: positive, L: positive, mu: positive, s: positive}
coordinates: [x, y, theta]
bodies: {ladder: {inertia: 0, position: x*i + y*j, angle: theta}}
particles: {foot: {position: "[x - L/2*cos(theta), y - L/2*sin(theta)]"}}
constraints:
  floor: {equation: "y - L/2*sin(theta) >= 0", reaction: A}
  wall: {equation: "x + L/2*cos(theta) <= 0", reaction: B}
forces:
  man: {on: ladder, vector: -W*j, at: "r_foot + s*e1_ladder"}
  rub: {friction: mu, static: mu, constraint: floor, on: ladder, at: r_foot, slip: -i}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: -L/2*cos(theta), y: L/2*sin(theta)}}}
find: equilibrium
answers: {rest: ["s <= mu*L*tan(theta)"]}
"""


def test_named_points_of_a_body_are_no_particles(problem: Read) -> None:
    written = in_json.as_object(report(problem(MAN)))
    assert [a["verdict"] for a in written["answers"]] == ["equivalent"]


BOWL = """title: Hemisphere with its curved side on an incline
parameters: {W: positive, R: positive, alpha: acute, mu: positive}
coordinates: [x, y, phi]
let:
  n: -sin(alpha)*i + cos(alpha)*j
  O: r_H + 3/8*R*e2_H
bodies: {H: {position: "x*i + y*j", angle: phi, inertia: 0}}
constraints: {plane: {equation: "dot(O, n) >= R", reaction: N}}
forces:
  weight: {on: H, vector: LOAD}
  rub: {friction: mu, static: mu, constraint: plane, on: H, at: O - R*n}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("load", "condition"),
    [
        ("-W*j", "sin(phi) = 8*sin(alpha)/3"),  # the weight passes through the contact, R sin α beside the centre
        ("-W*j - 2*W*i", None),  # sines and cosines of φ, and a constant: left as it is
    ],
)
def test_a_position_of_rest_is_solved_for_its_angle(problem: Read, load: str, condition: str | None) -> None:
    rest = in_json.as_object(report(problem(BOWL.replace("LOAD", load))))
    conditions = [c for c in rest["rest"]["conditions"] if " = " in c]
    if condition is None:
        assert [c.endswith("= 0") for c in conditions] == [True]
    else:
        assert [c.replace(" ", "") for c in conditions] == [condition.replace(" ", "")]


LOGS = """title: Two logs on a floor, and one on them
parameters: [m, R, g, mu]
coordinates: [x_1, y_1, phi_1, x_2, y_2, phi_2, x_3, y_3, phi_3]
bodies:
  A: {mass: m, position: x_1*i + y_1*j, angle: phi_1}
  B: {mass: m, position: x_2*i + y_2*j, angle: phi_2}
  C: {mass: m, position: x_3*i + y_3*j, angle: phi_3}
constraints:
  floor_1: {equation: y_1 >= R, reaction: N_1}
  floor_2: {equation: y_2 >= R, reaction: N_2}
  left: {equation: norm(r_C - r_A) >= 2*R, reaction: N_3}
  right: {equation: norm(r_C - r_B) >= 2*R, reaction: N_4}
  below: {equation: x_2 - x_1 >= 2*R, reaction: S}
gravity: -g*j
forces:
  rub_1: {friction: mu, static: mu, constraint: floor_1, on: A, at: r_A - R*j}
  rub_2: {friction: mu, static: mu, constraint: floor_2, on: B, at: r_B - R*j}
  rub_3: {friction: mu, static: mu, constraint: left, on: C, at: 1/2*(r_A + r_C)}
  rub_4: {friction: mu, static: mu, constraint: right, on: C, at: 1/2*(r_B + r_C)}
find: equilibrium
"""


def test_a_pile_of_logs_is_held_up_to_a_displacement_of_the_whole(problem: Read) -> None:
    """F R = F' R for each lower log, and F (1 + cos 30°) = N sin 30° + S: F/N >= tan 15° = 2 - sqrt(3), at S = 0."""
    result = report(problem(LOGS))
    rest = result.solution.own.at_rest
    assert rest is not None
    assert in_json.as_object(result)["rest"]["conditions"] == ["2 - sqrt(3) <= mu"]
    assert rest.verified
    assert {str(q): str(v) for q, v in rest.place.items()} == {
        "y_1": "R", "x_2": "2*R + x_1", "y_2": "R", "x_3": "R + x_1", "y_3": "R*(1 + sqrt(3))"
    }  # fmt: skip
    assert len(rest.elsewhere) == 1
    said = " ".join(terminal.text(result.derivation, result.notation, 100).split())
    assert "They also admit y₃ = R (1 − √3)" in said


TONGS = """title: One arm of tongs, whose cord ends at a ring
parameters: {W: positive, a: positive, h: positive, c: positive, d: positive, alpha: acute, mu: positive}
coordinates: [x, y, theta, X, Y]
bodies: {arm: {position: x*i + y*j, angle: theta}}
particles: {half: {position: X*i + Y*j}}
constraints:
  pin: {equation: x = 0}
  middle: {equation: X = 0}
  cord: {equation: norm(r_arm - a*e1_arm + h*e2_arm) = a/cos(alpha), reaction: T}
  tip: {equation: "dot(r_arm + c*e1_arm - d*e2_arm - r_half, i) >= c", reaction: N}
forces:
  weight: {on: half, vector: -W/2*j}
  grip: {friction: mu, static: mu, constraint: tip, on: arm, at: r_arm + c*e1_arm - d*e2_arm, slip: j}
find: [equilibrium, impending]
answers:
  rest: [mu >= d/(a + c + h*cot(alpha))]
  equilibrium: [mu = d/(a + c + h*cot(alpha))]
"""


def test_tongs_hold_in_the_position_in_which_the_cord_pulls(problem: Read) -> None:
    """By hand: 2 T sin α = W, and d N = c W/2 + a T sin α + h T cos α about the pin, with W/2 <= mu N at the tip."""
    result = report(problem(TONGS))
    rest = result.solution.own.at_rest
    assert rest is not None
    assert {q.name for q in rest.place} == {"x", "y", "theta", "X"}
    other = [str(v) for place in rest.elsewhere for q, v in place.items() if q.name == "y"]
    assert other == ["(a*sin(alpha) - h*cos(alpha))/cos(alpha)"]
    written = in_json.as_object(result)
    assert [a["verdict"] for a in written["answers"]] == ["equivalent", "equivalent"]
    head = terminal.text(result.derivation, result.notation, 100).split("The system")[0]
    assert "conditions of rest" in head
    assert "at the limit" not in head
