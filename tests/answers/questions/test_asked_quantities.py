"""Verdicts on answers to questions."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Fragment, Source
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from lagrange.problem.stated_answers import read_answers
from tests.support.paths import PROBLEMS
from tests.support.shared import loaded, reported

Read = Callable[[str], Problem]

CASES = [
    ("leaving-a-sphere", "leaves", "acos(2/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "theta = acos(2/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "leaves = acos(2/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "3*cos(theta) = 2", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "leaves", "cos(theta) = 1/2", Verdict.WRONG),
    ("leaving-a-sphere", "leaves", "cos(theta)^2 = 4/9", Verdict.INCOMPLETE),
    ("leaving-a-sphere", "leaves", "g = g", Verdict.TRIVIAL),
    ("leaving-a-sphere", "leaves", "R*theta'^2 = 2/3*g", Verdict.WRONG),
    ("leaving-a-sphere", "leaves", "cos(theta = 2/3", Verdict.UNREADABLE),
    ("leaving-a-sphere", "speed", "-sqrt(2*g*R/3)", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "speed", "sqrt(g*R)", Verdict.WRONG),
    ("leaving-a-sphere", "pressure", "N = m*g*(2 - 3*cos(theta))", Verdict.EQUIVALENT),
    ("leaving-a-sphere", "pressure", "m*g*(3*cos(theta) - 1)", Verdict.WRONG),
    ("released-pendulum", "speed", "sqrt(2*g*l*(1 - cos(alpha)))", Verdict.EQUIVALENT),
    ("released-pendulum", "speed", "\\sqrt{2gl(1 - \\cos\\alpha)}", Verdict.EQUIVALENT),
    ("released-pendulum", "speed", "sqrt(g*l*(1 - cos(alpha)))", Verdict.WRONG),
    ("released-pendulum", "other_side", "alpha", Verdict.WRONG),
    ("over-the-top", "turns", "sin(theta/2) = v/(2*sqrt(g*l))", Verdict.EQUIVALENT),
    ("over-the-top", "turns", "tan(theta/2) = v/sqrt(4*g*l - v^2)", Verdict.EQUIVALENT),
    ("over-the-top", "turns", "cos(theta/2) = v/(2*sqrt(g*l))", Verdict.WRONG),
    ("loop-the-loop", "least_height", "h = 2*R", Verdict.WRONG),
    ("loop-the-loop", "least_height", "2*h = 5*R", Verdict.EQUIVALENT),
    ("shaken-into-resonance", "motion", "F*t/(2*m*w)*sin(w*t)", Verdict.INCOMPLETE),
]


@pytest.mark.parametrize(("name", "question", "answer", "verdict"), CASES)
def test_the_verdict_on_an_answer_to_a_question(name: str, question: str, answer: str, verdict: Verdict) -> None:
    path = PROBLEMS / "motion" / f"{name}.yaml"
    examiner = Examiner(loaded(path), reported(path).solution)
    stated = read_answers(Source("answers", f"ask: {{{question}: '{answer}'}}" if "'" not in answer else
                                 f'ask: {{{question}: "{answer}"}}'), loaded(path))  # fmt: skip
    [judged] = examiner.check_answers(stated).others
    assert (judged.name, judged.verdict) == ("ask", verdict)


@pytest.mark.parametrize(
    ("name", "question", "answer", "said"),
    [
        ("weight-let-go-on-a-spring", "lowest", "x_max = m*g/k", "there x'' = 0: it is the middle of the oscillation"),
        (
            "weight-let-go-on-a-spring",
            "time",
            "2*pi*sqrt(m/k)",
            "then everything is as at the start again: it is a whole period, or several",
        ),
        ("over-the-top", "at_the_side", "sqrt(v^2 + 2*g*l)", "the potential energy has the wrong sign in the energy"),
        (
            "over-the-top",
            "at_the_side",
            "sqrt(v^2 - g*l)",
            "the kinetic energy is twice as large as it should be, or the change of the potential energy half as large",
        ),
        (
            "escape-from-a-planet",
            "escape_speed",
            "sqrt(K/R)",
            "a factor sqrt(2) is missing: its square is half as large, as from a kinetic energy without its 1/2",
        ),
        (
            "escape-from-a-planet",
            "escape_speed",
            "K*R",
            "its dimension is wrong: it is in m^4/s^2, and what is asked for is in m/s",
        ),
    ],
)
def test_what_is_said_of_a_wrong_value(name: str, question: str, answer: str, said: str) -> None:
    path = PROBLEMS / "motion" / f"{name}.yaml"
    stated = read_answers(Source("answers", f"ask: {{{question}: '{answer}'}}"), loaded(path))
    [judged] = Examiner(loaded(path), reported(path).solution).check_answers(stated).others
    [part] = judged.equations
    assert (part.verdict, part.diagnosis) == (Verdict.WRONG, said)


LADDER = """title: Ladder against a smooth wall
axes: {{i: right, j: up}}
parameters: {{m: positive, l: positive, g: positive, alpha: {alpha}}}
coordinates: {{x: middle, y: height, theta: {{range: {range}}}}}
bodies: {{ladder: {{mass: m, inertia: m*l^2/3, position: x*i + y*j, angle: -theta}}}}
constraints:
  floor: {{equation: "y = l*sin(theta)", reaction: N}}
  wall: {{equation: "x = l*cos(theta)", reaction: W}}
gravity: -g*j
generalized_coordinates: {{angle: {{coordinates: [theta], substitute: {{x: l*cos(theta), y: l*sin(theta)}}}}}}
initial: {{theta: alpha, theta': 0}}
ask: {{leaves: {{quantity: theta, when: W = 0}}}}
"""


def verdict(problem: Problem, solution: Solution, answers: str) -> AnswerVerdict:
    stated = read_answers(Source("answers", f"ask: {answers}"), problem)
    [judged] = Examiner(problem, solution).check_answers(stated).others
    return judged


@pytest.mark.parametrize(
    ("alpha", "within"),
    [("acute", "[0, 90 deg]"), ("acute", "[-180 deg, 180 deg]"), ("real", "[0.1, 1.5]")],
)
def test_an_angle_in_a_range_is_judged_by_its_sine(problem: Read, alpha: str, within: str) -> None:
    """The other angle with this sine is out of the range, or comes later: it is no value of the answer."""
    posed = problem(LADDER.format(alpha=alpha, range=within))
    solution = solve(posed, complete=False)
    assert verdict(posed, solution, "{leaves: sin(theta) = 2/3*sin(alpha)}").verdict is Verdict.EQUIVALENT
    assert verdict(posed, solution, "{leaves: sin(theta) = 3/4*sin(alpha)}").verdict is Verdict.WRONG


WIRE = """title: Bead on a parabola
axes: {i: right, j: up}
parameters: [m, a, g]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {wire: {equation: y = a*x^2, reaction: N}}
gravity: -g*j
initial: {x: 1/a, x': 0}
ask: {bottom: {quantity: N, when: x = 0}, anywhere: {quantity: N, by: x}}
"""


def test_the_name_of_a_reaction_may_be_the_multiplier_where_its_share_depends_on_the_position(problem: Read) -> None:
    """N = 5 m g/(1 + 4 a² x²)^(3/2), and λ = N/√(1 + 4 a² x²)."""
    posed = problem(WIRE)
    solution = solve(posed, complete=False)
    multiplier = "5*m*g/(1 + 4*a^2*x^2)^2"
    for right in ("N = 5*m*g/(1 + 4*a^2*x^2)^(3/2)", multiplier, f"lambda_wire = {multiplier}", f"-{multiplier}"):
        assert verdict(posed, solution, f'{{anywhere: "{right}"}}').verdict is Verdict.EQUIVALENT
    for wrong in ("5*m*g/(1 + 4*a^2*x^2)", f"lambda_wire = 2*{multiplier}"):
        assert verdict(posed, solution, f'{{anywhere: "{wrong}"}}').verdict is Verdict.WRONG
    both = verdict(posed, solution, f'{{bottom: 5*m*g, anywhere: "-{multiplier}"}}')
    assert [part.verdict for part in both.equations] == [Verdict.EQUIVALENT, Verdict.WRONG]  # one meaning in an answer


ROD = """title: Rod on a hinge
axes: {i: right, j: down}
parameters: {m: positive, l: positive, g: positive, omega_0: nonnegative}
coordinates: [theta]
bodies: {rod: {mass: m, inertia: m*l^2/12, position: l/2*sin(theta)*i + l/2*cos(theta)*j, angle: -theta}}
gravity: g*j
initial: {theta: 0, theta': omega_0}
ask: {least: {quantity: l*omega_0, when: [theta = pi/2, theta' = 0]}}
"""


def test_of_a_product_the_initial_speed_is_asked_for(problem: Read) -> None:
    posed = problem(ROD)
    assert verdict(posed, solve(posed), "{least: sqrt(3*g*l)}").verdict is Verdict.EQUIVALENT


SLOPE = """
title: Block on a slope
axes: {i: right, j: up}
parameters:
  m: {assume: positive, value: 40 kg}
  g: {assume: positive, value: 9.81 m/s^2}
  mu: {assume: positive, value: 0.25}
  alpha: {assume: acute, value: 30 deg}
  d: {assume: positive, value: 6 m}
coordinates: {x: {unit: m}, y: {unit: m}}
particles: {block: {mass: m, position: "[x*cos(alpha) + y*sin(alpha), y*cos(alpha) - x*sin(alpha)]"}}
constraints: {plane: {equation: y = 0, reaction: N}}
forces: {rub: {friction: mu, constraint: plane, on: block, slip: positive, contact: positive}}
gravity: -g*j
generalized_coordinates: {down: {coordinates: [x]}}
initial: {x: 0, x': 0}
ask:
  speed: {quantity: "x'", when: "x = d"}
  time: {quantity: t, when: "x = d"}
  push: {quantity: N, when: "x = d"}
"""


@pytest.mark.parametrize(
    ("name", "answer", "expected"),
    [  # a = g (1/2 − √3/8), v² = 12 a, t² = 12/a, N = m g √3/2
        ("speed", "5.777 m/s", Verdict.EQUIVALENT),
        ("speed", "20.80 km/h", Verdict.EQUIVALENT),
        ("speed", "x' = 5.78 m/s", Verdict.EQUIVALENT),
        ("speed", "v ≈ 5.78 m s^-1", Verdict.EQUIVALENT),
        ("speed", r"5.777\,\frac{\text{m}}{\text{s}}", Verdict.EQUIVALENT),
        ("speed", r"5.777~\mathrm{m\,s^{-1}}", Verdict.EQUIVALENT),
        ("speed", "sqrt(2*a*d) = 5.777 m/s", Verdict.UNREADABLE),  # a is not declared
        ("speed", "5.777 m", Verdict.WRONG),
        ("speed", "5.777 km/h", Verdict.WRONG),
        ("speed", "5.9 m/s", Verdict.WRONG),
        ("time", "2.077 s", Verdict.EQUIVALENT),
        ("time", "2077 ms", Verdict.EQUIVALENT),
        ("time", "2.077 min", Verdict.WRONG),
        ("push", "339.8 N", Verdict.EQUIVALENT),
        ("push", "0.3398 kN", Verdict.EQUIVALENT),
        ("push", "339.8 kg", Verdict.WRONG),
    ],
)
def test_values_with_units(name: str, answer: str, expected: Verdict) -> None:
    posed, solution = sloping()
    written = json.dumps(answer, ensure_ascii=False)
    assert verdict(posed, solution, f"{{{name}: {written}}}").verdict is expected


@cache
def sloping() -> tuple[Problem, Solution]:
    posed = read_problem(Source("slope.yaml", SLOPE))
    return posed, solve(posed, complete=False)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["v = 5.78 m/s", "t = 2.08 s", "N = 340 N"], Verdict.EQUIVALENT),
        (["v = 5.78 m/s", "t = 2.08 s"], Verdict.INCOMPLETE),
        ([r"$a = g(\sin\alpha-\mu\cos\alpha) = 2.78\,\text{m/s}^2$", r"$v=\sqrt{2ad}=5.78\,\text{m/s}$"],
         Verdict.EQUIVALENT),
        ([r"$v=\sqrt{2ad}=5.98\,\text{m/s}$"], Verdict.WRONG),
        (["x'' = g*(sin(alpha) - mu*cos(alpha))", "v = 5.98 m/s"], Verdict.WRONG),
        (["x'' = g*(sin(alpha) + mu*cos(alpha)) = 2.781 m/s^2", "v = 5.78 m/s"], Verdict.WRONG),
        (["a = 2.781 m/s^2", "v = sqrt(2 a d) = sqrt(2*2.781*6) = 5.78 m/s", "t = 2.08 s", "N = 340 N"],
         Verdict.EQUIVALENT),
        (["v = sqrt(2*3*4) = 4.898 = 5.78 m/s", "t = 2.08 s", "N = 340 N"], Verdict.WRONG),  # the middle
        ([r"$v=\sqrt{2\cdot 2.781\cdot 6}=5.777=5.78\,\text{km/s}$"], Verdict.WRONG),  # its unit is not dropped
    ],
)  # fmt: skip
def test_values_in_a_text(lines: list[str], expected: Verdict) -> None:
    """A number with its unit answers its question, and the equation before it is judged as ever."""
    posed, solution = sloping()
    answer = tuple(Fragment.of(line) for line in lines)
    assert Examiner(posed, solution).check(answer).verdict is expected


@cache
def _solution(text: str) -> Solution:
    return solve(read_problem(Source("problem.yaml", text)))


LOOP = """title: A bead shot into a loop
axes: {i: right, j: down}
parameters: {m: 0.2 kg, g: 9.81 m/s^2, R: 50 cm, v: 4 m/s}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {loop: {equation: x^2 + y^2 <= R^2, reaction: N}}
gravity: g*j
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: R*sin(theta), y: R*cos(theta)}}}
initial: {theta: 0, theta': v/R}
ask: {falls: {quantity: theta, when: N = 0}, speed: {quantity: "R*theta'", when: N = 0}}
"""
HILL = """title: Leaving a quartic hill
parameters: {m: 1 kg, g: 9.81 m/s^2, a: 0.5 m^-3, v: 1 m/s}
axes: {i: right, j: up}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {hill: {equation: y >= -a*x^4, reaction: N}}
gravity: -g*j
generalized_coordinates: {abscissa: {coordinates: [x]}}
initial: {x: 0, x': v}
ask: {leaving: {quantity: x, when: N = 0}}
"""


@pytest.mark.parametrize(
    ("text", "answer", "verdict"),
    [
        (LOOP, ["theta = 114.9 deg", "R*theta' = 1.436"], Verdict.EQUIVALENT),
        (LOOP, ["theta = 114.9 deg", "R*theta' = 1.536"], Verdict.WRONG),
        (LOOP, ["theta = -114.9 deg", "R*theta' = 1.436 m/s"], Verdict.WRONG),  # the motion begins to the other side
        (HILL, ["x = 0.8164 m"], Verdict.EQUIVALENT),  # m is a mass, too
        (HILL, ["x = 0.8264 m"], Verdict.WRONG),
        (HILL, ["x = 81.6 cm"], Verdict.EQUIVALENT),
        (HILL, ["x = 0.8164 kg"], Verdict.WRONG),
    ],
)
def test_values_with_and_without_units(text: str, answer: list[str], verdict: Verdict) -> None:
    problem = read_problem(Source("problem.yaml", text))
    examiner = Examiner(problem, _solution(text))
    assert examiner.check([Fragment.of(a, "an answer") for a in answer]).verdict is verdict
