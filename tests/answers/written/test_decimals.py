"""A decimal in an answer stands for all numbers that round to it: equations, equilibria, frequencies, forces, values."""

from __future__ import annotations

from random import Random

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Grader, Submission
from lagrange.core.diagnostics import Source
from lagrange.problem.loader import read_problem
from tests.support.shared import loaded, solved

PENDULUM = """
title: Pendulum
coordinates: [theta]
parameters: {m: {value: 2}, g: {value: 9.81}, l: {value: 0.7}}
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
"""
PUSHED = """
title: Pendulum with a steady push
coordinates: [theta]
parameters: {m: {value: 2}, g: {value: 9.81}, l: {value: 1.5}}
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
forces: {push: {on: P, vector: 15*i}}
find: [motion, equilibrium, linearization]
"""
WEIGHT = """
title: Weight on a spring
coordinates: [x]
parameters: {m: {assume: positive}, k: {assume: positive}, g: {assume: positive}}
particles: {P: {mass: m, position: x*j}}
gravity: -g*j
forces: {spring: {potential: 3/2*k*x^2}}
find: [motion, equilibrium, linearization]
"""
OWN = {"pendulum": PENDULUM, "pushed": PUSHED, "weight": WEIGHT}

ANSWERS = [
    ("pendulum", "theta'' + 14.01*sin(theta) = 0", "equivalent"),  # 14.0143
    ("pendulum", "theta'' + 14.0*sin(theta) = 0", "equivalent"),
    ("pendulum", "theta'' + 14.02*sin(theta) = 0", "wrong"),
    ("pendulum", "theta'' + 13.9*sin(theta) = 0", "wrong"),
    ("pendulum", "theta'' + 14*sin(theta) = 0", "wrong"),  # a whole number is no decimal
    ("pendulum", "0.98*theta'' + 13.73*sin(theta) = 0", "equivalent"),
    ("pendulum", "0.98*theta'' + 13.9*sin(theta) = 0", "wrong"),
    ("pendulum", "1.0*theta'' + 13.5*sin(theta) = 0", "wrong"),  # 1.0 is 1, and not 0.96
    ("pendulum", "l*theta'' = -9.81*sin(theta)", "equivalent"),
    ("pendulum", "m*l^2*theta'' + 13.7*sin(theta) = 0", "equivalent"),
    ("pendulum", "0.49*m*theta'' + 13.7*sin(theta) = 0", "equivalent"),
    ("pendulum", "14.01*m*sin(theta) + m*theta'' = 0", "equivalent"),
    ("pendulum", "k = 14.01\ntheta'' + k*sin(theta) = 0", "equivalent"),
    ("pendulum", "omega_0^2 = 14.01\ntheta'' + omega_0^2*sin(theta) = 0", "equivalent"),
    ("pendulum", "omega_0 = 3.75\ntheta'' + omega_0^2*sin(theta) = 0", "wrong"),  # 3.7436
    ("pendulum", "theta'' + 3.74^2*sin(theta) = 0", "equivalent"),
    ("pendulum", "theta'' + 14.01*sin(0.98*theta) = 0", "wrong"),
    ("pendulum", r"\ddot\theta + 14{,}01 \sin\theta = 0", "equivalent"),
    ("pendulum", r"$\ddot{\theta} = -1.40 \cdot 10 \sin\theta$", "equivalent"),
    ("pendulum", "theta'' = -14.01*sin(theta)\ntheta'' = -14.02*sin(theta)", "wrong"),
    ("weight", "x'' + g + 3.00*k/m*x = 0", "equivalent"),
    ("weight", "0.333*m*x'' + 0.333*m*g + k*x = 0", "equivalent"),
    ("weight", "0.33*m*x'' + 0.34*m*g + k*x = 0", "wrong"),
    ("weight", "0.3*m*x'' + 0.3*m*g + k*x = 0", "wrong"),  # one digit is not rounded
    ("weight", "x'' + 9.81 + 3*k/m*x = 0", "wrong"),  # g is a letter here
    ("pushed", "theta'' = -6.54*sin(theta) + 5.00*cos(theta)", "equivalent"),
    ("pushed", "m*l*theta'' + 19.6*sin(theta) = 15*cos(theta)", "equivalent"),
    ("pushed", "m*l*theta'' + 19.5*sin(theta) = 15*cos(theta)", "wrong"),
]
PARTS = [
    ("pushed", "equilibrium: [['theta = 0.653'], ['theta = 3.794']]", "equivalent"),
    ("pushed", "equilibrium: [['theta = 0.653'], ['theta = 0.653 + 3.142']]", "equivalent"),
    ("pushed", "equilibrium: ['theta = 0.65']", "equivalent"),  # with a remark, as atan(u)
    ("pushed", "equilibrium: ['theta = 0.66']", "wrong"),
    ("pushed", "equilibrium: ['tan(theta) = 0.765']", "equivalent"),
    ("pushed", "equilibrium: ['tan(theta) = 0.755']", "wrong"),
    ("pushed", "frequencies: ['2.87']", "equivalent"),
    ("pushed", "frequencies: ['2.88']", "wrong"),
    ("weight", "equilibrium: ['x = -0.333*m*g/k']", "equivalent"),
    ("weight", "equilibrium: ['x = -0.334*m*g/k']", "wrong"),
    ("weight", "frequencies: ['1.73*sqrt(k/m)']", "equivalent"),
    ("weight", "frequencies: ['1.75*sqrt(k/m)']", "wrong"),
    ("weight", r"frequencies: ['1.73\sqrt{\frac{k}{m}}']", "equivalent"),
    ("double-pendulum-small-oscillations", "frequencies: ['0.765*sqrt(g/l)', '1.85*sqrt(g/l)']", "equivalent"),
    ("double-pendulum-small-oscillations", "frequencies: ['0.75*sqrt(g/l)', '1.85*sqrt(g/l)']", "wrong"),
    ("leaving-a-sphere", "ask: {leaves: cos(theta) = 0.667, speed: 0.816*sqrt(g*R)}", "equivalent"),
    ("leaving-a-sphere", "ask: {leaves: theta = 0.841}", "equivalent"),
    ("leaving-a-sphere", "ask: {leaves: '0.8411'}", "equivalent"),
    ("leaving-a-sphere", "ask: {leaves: '0.842'}", "wrong"),
    ("leaving-a-sphere", "ask: {leaves: cos(theta) = 0.66}", "wrong"),
    ("leaving-a-sphere", "ask: {leaves: cos(theta) = 0.7}", "wrong"),
    ("leaving-a-sphere", "ask: {speed: 0.83*sqrt(g*R)}", "wrong"),
    ("leaving-a-sphere", "ask: {pressure: 3.00*m*g*(cos(theta) - 0.667)}", "equivalent"),
    ("released-pendulum", "ask: {speed: 1.41*sqrt(g*l*(1 - cos(alpha)))}", "equivalent"),
]
_GRADERS: dict[str, Grader] = {}


def graded(problem: str, text: str, ending: str) -> str:
    if problem not in _GRADERS:
        own = problem in OWN
        examiner = Examiner.of(read_problem(Source(problem, OWN[problem]))) if own else None
        _GRADERS[problem] = Grader.of(examiner or Examiner(loaded(problem), solved(problem)))
    return _GRADERS[problem].grade(Submission("a", ((f"a{ending}", text.encode()),))).verdict.value


@pytest.mark.parametrize(("problem", "text", "expected"), ANSWERS)
def test_equations(problem: str, text: str, expected: str) -> None:
    assert graded(problem, text, ".txt") == expected


@pytest.mark.parametrize(("problem", "text", "expected"), PARTS)
def test_answers_to_other_questions(problem: str, text: str, expected: str) -> None:
    assert graded(problem, text, ".yaml") == expected


def test_rounding_a_right_coefficient_is_right_and_the_next_decimal_is_wrong() -> None:
    random = Random(5)
    for _ in range(25):
        factor = random.uniform(0.2, 60)
        digits = random.choice((3, 4, 6))
        first, second = (f"{factor * x:.{digits}g}" for x in (1, 981 / 70))
        if "." not in first or "." not in second or "e" in first + second:
            continue
        assert graded("pendulum", f"{first}*theta'' + {second}*sin(theta) = 0", ".txt") == "equivalent"
        places = len(second.partition(".")[2])
        shifted = f"{float(second) * 1.1:.{places}f}"
        assert graded("pendulum", f"{first}*theta'' + {shifted}*sin(theta) = 0", ".txt") == "wrong"


def test_a_remark_says_what_a_decimal_is_taken_for() -> None:
    examiner = Examiner.of(read_problem(Source("pendulum", PENDULUM)))
    grade = Grader.of(examiner).grade(Submission("a", (("a.txt", b"theta'' = -14.01*sin(theta)"),)))
    assert grade.equations[0].remarks == ("14.01 is taken as 14.0143, rounded",)
