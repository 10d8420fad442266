"""Verdicts on positions of equilibrium."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import pytest

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import Examiner, check_answer, check_own_answers
from lagrange.answers.verdicts import Judgement
from lagrange.core.diagnostics import Fragment, Source
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.problem.model import Problem
from tests.support.shared import loaded
from tests.support.statics_texts import (
    ATWOOD,
    BEAD,
    CHAIN,
    INCLINES,
    LEVER,
    PENDULUM,
    PULLED_SPRING,
    SCALES,
    WIND,
    WINDING,
)

TOGGLE = """
title: Two rods as a toggle against a spring
parameters: [a, k, W]
coordinates: [theta]
particles: {Q: {position: a*cos(theta)*i + a*sin(theta)*j}}
forces:
  load: {on: Q, vector: -W*j}
  spring: {potential: "k*(2*a*cos(theta) - 2*a)^2/2"}
"""


def read(text: str) -> Problem:
    return read_problem(Source("problem.yaml", text))


def verdict(problem: Problem, *equations: str) -> Judgement:
    return check_answer(problem, tuple(Fragment.of(e) for e in equations))


TORSION = """
title: A pendulum with a torsion spring
parameters: [k, W, l]
coordinates: [theta]
forces: {spring: {potential: k*theta^2/2}, weight: {potential: W*l*cos(theta)}}
"""


THREE_PLACES = """
title: Three places of rest
parameters: [k, a, b]
coordinates: [x]
forces: {f: {potential: k*(x^4/4 - (a + b)*x^3/3 + a*b*x^2/2)}}
"""


EQUIVALENT, WRONG, INCOMPLETE, TRIVIAL = Verdict.EQUIVALENT, Verdict.WRONG, Verdict.INCOMPLETE, Verdict.TRIVIAL
ANSWERS = [
    ("ex16-rod-on-two-planes", ["tan(theta) = (2*k - 1)/tan(alpha)"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["sin(alpha)*cos(alpha - theta)/sin(2*alpha) = k*cos(theta)"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["k = (1 + tan(theta)*tan(alpha))/2"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["tan(alpha) = (2*k - 1)/tan(theta)"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["theta = atan((2*k - 1)/tan(alpha))"], EQUIVALENT),
    ("ex16-rod-on-two-planes", ["tan(theta) = (2*k - 1)*tan(alpha)"], WRONG),
    ("ex16-rod-on-two-planes", ["tan(theta) = (1 - 2*k)/tan(alpha)"], WRONG),
    ("ex16-rod-on-two-planes", ["theta = 0"], WRONG),
    ("ex16-rod-on-two-planes", ["sin(theta)*(tan(theta)*tan(alpha) - 2*k + 1) = 0"], WRONG),
    ("ex16-rod-on-two-planes", ["l*sin(theta) = (z_B - z_A)*sin(alpha)"], INCOMPLETE),
    ("ex16-rod-on-two-planes", ["k = 1/2"], WRONG),  # there is equilibrium for other k, and not everywhere for this
    ("ex16-rod-on-two-planes", ["k = 1/2", "theta = 0"], INCOMPLETE),
    ("ex16-rod-on-two-planes", ["sin(theta)^2 + cos(theta)^2 = 1"], TRIVIAL),
    # within the range of the coordinate a tangent has one angle
    ("inverted-pendulum-springs", ["theta = 0 or tan(theta) = ± sqrt(b^4*c^2 - W^2*l^2)/(W*l)"], EQUIVALENT),
    ("inverted-pendulum-springs", ["theta = 0 or tan(theta) = ± sqrt(b^4*c^2 + W^2*l^2)/(W*l)"], WRONG),
    ("inverted-pendulum-springs", ["theta = 0 or cos(theta) = -W*l/(b^2*c)"], WRONG),
    (THREE_PLACES, ["x = 0 or 2*x = a + b ± sqrt((a + b)^2 - 4*a*b)"], EQUIVALENT),
    (THREE_PLACES, ["x = 0 or 2*x = a + b + sqrt((a + b)^2 - 4*a*b)"], INCOMPLETE),
    (THREE_PLACES, ["x = 0 or 2*x = a + b ± sqrt((a + b)^2 + 4*a*b)"], WRONG),
    (BEAD, ["sin(theta)*(a*cos(theta) - b) = 0"], EQUIVALENT),
    (BEAD, ["a*sin(2*theta) = 2*b*sin(theta)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or cos(theta) = b/a"], EQUIVALENT),
    (BEAD, ["sin(theta) = 0 or cos(theta) = b/a"], EQUIVALENT),
    (BEAD, ["theta = 2*pi or theta = -pi or theta = acos(b/a) or theta = -acos(b/a)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or theta = acos(b/a)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or a = b/cos(theta)"], EQUIVALENT),
    (BEAD, ["theta = 0 or theta = pi or sin(theta)^2 = 1 - b^2/a^2"], WRONG),
    (BEAD, ["theta = 0 or theta = pi"], INCOMPLETE),
    (BEAD, ["cos(theta) = b/a"], INCOMPLETE),
    (BEAD, ["theta = 0"], INCOMPLETE),
    (BEAD, ["theta = 0", "theta = pi"], INCOMPLETE),
    (BEAD, ["theta = 0 or cos(theta) = a/b"], WRONG),
    (BEAD, ["tan(theta/2) = 0 or theta = pi or cos(theta) = b/a"], EQUIVALENT),
    # W cos θ = 4 k a (cos θ − 1) sin θ is of the fourth degree, and has no solution in closed form
    (TOGGLE, ["W = 4*k*a*(sin(theta) - tan(theta))"], EQUIVALENT),
    (TOGGLE, ["W = 4*k*a*(tan(theta) - sin(theta))"], WRONG),
    (TOGGLE, ["theta = 0"], WRONG),
    (CHAIN, ["tan(theta) = P/(2*W)", "tan(phi) = P/W"], EQUIVALENT),
    (CHAIN, ["P*cos(phi) = W*sin(phi)", "2*tan(theta) = tan(phi)"], EQUIVALENT),
    (CHAIN, ["P = 2*W*tan(theta)", "P = W*tan(phi)"], EQUIVALENT),
    (CHAIN, ["tan(theta) = P/(2*W)"], INCOMPLETE),
    (CHAIN, ["2*tan(theta) = tan(phi)"], INCOMPLETE),
    (CHAIN, ["tan(theta) = P/W", "tan(phi) = P/W"], WRONG),
    ("ladder", ["P = W/2*tan(phi)"], EQUIVALENT),
    ("ladder", ["W = 2*P/tan(phi)"], EQUIVALENT),
    ("ladder", ["tan(phi) = 2*P/W"], EQUIVALENT),
    ("ladder", ["2*P*l*cos(phi) = W*l*sin(phi)"], EQUIVALENT),
    ("ladder", ["P = W*tan(phi)"], WRONG),
    ("ladder", ["P = W/2*cos(phi)/sin(phi)"], WRONG),
    (PENDULUM, ["x = 0"], EQUIVALENT),
    (PENDULUM, ["theta = 0 or theta = pi"], EQUIVALENT),
    (PENDULUM, ["x = 0", "y = l"], INCOMPLETE),
    (PENDULUM, ["x = 0", "y = l or y = -l"], EQUIVALENT),
    (PENDULUM, ["y = 0"], WRONG),
    (PENDULUM, ["x^2 + y^2 = l^2"], INCOMPLETE),
    ("three-weights", ["y^2*(4*P^2 - W^2) = b^2*W^2"], WRONG),  # y < 0 as well
    ("three-weights", ["y = b*W/sqrt(4*P^2 - W^2)"], EQUIVALENT),
    ("three-weights", ["2*P*y = W*sqrt(b^2 + y^2)"], EQUIVALENT),
    ("rod-over-peg", ["cos(theta) = (c/b)^(1/3)"], EQUIVALENT),
    ("rod-over-peg", ["b*cos(theta)^3 = c"], EQUIVALENT),
    ("rod-over-peg", ["b*cos(theta)^2 = c"], WRONG),
    ("rocking-plank", ["theta = 0 or R*theta = h*tan(theta)"], EQUIVALENT),
    ("rocking-plank", ["h*sin(theta) = R*theta*cos(theta)"], EQUIVALENT),
    ("rocking-plank", ["theta = 0"], INCOMPLETE),
    ("balanced-lamp", ["theta = 0 or theta = pi"], EQUIVALENT),
    (ATWOOD, ["W = M"], EQUIVALENT),
    (ATWOOD, ["W = 2*M"], WRONG),
    (LEVER, ["b*P + c*R = a*W"], EQUIVALENT),
    (LEVER, ["P = a*W/b"], WRONG),
    # an angle that also occurs outside sines: where it is 0 or π, or any multiple of π, the string hangs down or up
    (WINDING, ["theta = 0 or theta = pi or theta = -l/R"], EQUIVALENT),
    (WINDING, ["sin(theta) = 0 or theta = -l/R"], EQUIVALENT),
    (WINDING, ["theta = 0 or theta = pi"], INCOMPLETE),
    (WINDING, ["theta = 2*pi"], INCOMPLETE),
    (WINDING, ["theta = 0 or theta = pi/2"], WRONG),
    (WINDING, ["theta = 0 or theta = l/R"], WRONG),
    (TORSION, ["theta = 0"], INCOMPLETE),
    (TORSION, ["theta = 2*pi"], WRONG),  # the spring is wound up there
    # which of the two is above and which below depends on the sign of m g − H
    (WIND, ["theta = atan(F/(m*g - H)) or theta = atan(F/(m*g - H)) + pi"], EQUIVALENT),
    (WIND, ["theta = atan(F/(m*g - H)) or theta = pi - atan(F/(m*g - H))"], WRONG),
    (WIND, ["theta = -atan(F/(m*g - H)) or theta = pi - atan(F/(m*g - H))"], WRONG),
    (INCLINES, ["P*sin(alpha) = Q*sin(beta)"], EQUIVALENT),
    (INCLINES, ["P = Q*sin(beta)/sin(alpha)", "x + y = L"], EQUIVALENT),
    (INCLINES, ["P*cos(alpha) = Q*cos(beta)"], WRONG),
    (SCALES, ["theta = pi/2 or theta = -pi/2 or P*a = Q*b"], EQUIVALENT),
    (SCALES, ["P*a = Q*b"], INCOMPLETE),
    (SCALES, ["P = Q"], WRONG),
    # equations between parameters: no condition of equilibrium, or the case that the others are about
    (PULLED_SPRING, ["P = 7*k*l"], WRONG),
    (PULLED_SPRING, ["W = 7*l"], WRONG),
    (PULLED_SPRING, ["x = P/k", "W = 7*l"], WRONG),
    (PULLED_SPRING, ["x = 7*l", "P = 7*k*l"], INCOMPLETE),
    (PULLED_SPRING, ["x = 7*l", "W = 7*l"], WRONG),
    (LEVER, ["a = 7*b"], WRONG),
    (LEVER, ["theta = 0"], WRONG),  # P and R are asked for, at every position
]


@cache
def examiner(problem: str) -> Examiner:
    """What judges answers to a problem, which is solved once for all of them."""
    return Examiner.of(read(problem) if "\n" in problem else loaded(problem))


@pytest.mark.parametrize(
    ("problem", "equations", "expected"),
    ANSWERS,
    ids=[f"{p.split(chr(10))[1] if chr(10) in p else p}: {'; '.join(e)}" for p, e, _ in ANSWERS],
)
def test_answers(problem: str, equations: list[str], expected: Verdict) -> None:
    found = examiner(problem).check(tuple(Fragment.of(e) for e in equations))
    assert found.verdict is expected, found.equations
    assert found.statics


HELD = """
title: A bead held on a ring, P for every position
coordinates: [x, y]
parameters: [W, l]
particles: {A: {position: "[x, y]"}}
constraints: {ring: x^2 + y^2 = l^2}
forces: {weight: {on: A, vector: -W*j}, pull: {on: A, vector: P*i}}
unknowns: [P]
find: equilibrium
"""


@pytest.mark.parametrize(
    ("equation", "expected"),
    [
        ("P = -W*x/y", EQUIVALENT),  # moments about the centre: P y + W x = 0
        ("P*y = -W*x", EQUIVALENT),
        ("P*y*(x^2 + y^2) = -W*x*l^2", EQUIVALENT),  # with the ring put in
        ("P = W*x/y", WRONG),
        ("P = -2*W*x/y", WRONG),
        ("P^2 = W^2*x^2/y^2", WRONG),  # has the other sign too
        ("x^2 + y^2 = l^2", INCOMPLETE),
    ],
)
def test_a_force_for_every_position_of_a_constraint(equation: str, expected: Verdict) -> None:
    assert verdict(read(HELD), equation).verdict is expected


def test_unreadable_answers() -> None:
    assert verdict(read(BEAD), "theta = 1 or zeta = 3").verdict is Verdict.UNREADABLE
    assert verdict(read(BEAD), "cos(theta) = b/(a - a)").verdict is Verdict.UNREADABLE


def test_what_is_said_of_an_answer() -> None:
    found = verdict(read(WIND), "theta = atan(F/(m*g - H))")
    assert found.equations.equations[0].remarks
    found = verdict(read(BEAD), "theta = 0 or theta = pi or sin(theta)^2 = 1 - b^2/a^2")
    assert any("not an equilibrium" in e.diagnosis for e in found.equations.equations)
    assert "positions of equilibrium" in verdict(read(BEAD), "sin(theta)*(a*cos(theta) - b) = 0").headline
    assert verdict(read(BEAD), "theta = 0").equations.missing == 2


def test_answers_of_the_file() -> None:
    good = BEAD + 'answers: {equilibrium: [["theta = 0"], ["theta = pi"], ["cos(theta) = b/a"]]}\n'
    assert check_own_answers(read(good)).verdict is EQUIVALENT
    assert report(read(good)).holds
    bad = good.replace('["theta = pi"], ', "")
    assert check_own_answers(read(bad)).verdict is INCOMPLETE
    assert not report(read(bad)).holds


def test_numbers_of_the_file_count() -> None:
    text = BEAD.replace("[a, b]", "{a: {assume: positive, value: 2}, b: {assume: positive, value: 1}}")
    assert verdict(read(text), "theta = 0 or theta = pi or cos(theta) = 1/2").verdict is EQUIVALENT
    assert verdict(read(text), "theta = 0 or theta = pi or theta = pi/3 or theta = -pi/3").verdict is EQUIVALENT
    assert verdict(read(text), "theta = 0 or theta = pi or cos(theta) = 1/3").verdict is WRONG


SKATE = """
title: A skate on a spring
parameters: [k]
coordinates: [x, y, theta]
particles: {P: {position: "[x, y]"}}
constraints: {blade: "cos(theta)*y' = sin(theta)*x'"}
forces: {spring: {potential: k*x^2/2}}
find: equilibrium
"""


def test_an_angle_that_occurs_in_a_kinematic_constraint_alone() -> None:
    """The blade, pointing along y, balances the spring at any x."""
    problem = read(SKATE)
    assert verdict(problem, "theta = pi/2 or theta = -pi/2 or x = 0").verdict is EQUIVALENT
    assert verdict(problem, "theta = pi/2 or x = 0").verdict is INCOMPLETE


@pytest.mark.parametrize(
    ("answer", "expected"),
    [("theta = 31.45 deg", EQUIVALENT), ("theta = 31.45° or theta = 211.45°", EQUIVALENT), ("theta = 32.45°", WRONG)],
)
def test_equilibria_in_degrees(answer: str, expected: Verdict) -> None:
    pulled = """title: Bead with a horizontal pull
parameters: {m: 2 kg, g: 9.81 m/s^2, l: {unit: m}, F: 12 N}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
forces: {pull: {on: P, vector: F*i}}
find: equilibrium
"""
    assert verdict(read(pulled), answer).verdict is expected


ROD_AT_WALL = """title: Rod at a wall, hung by a string
axes: {j: down}
parameters: {l: 1 m, s: 3 m, W: N}
coordinates: [y, theta]
bodies: {rod: {position: l*sin(theta)*i + (y + l*cos(theta))*j, angle: -theta}}
constraints: {string: {equation: "(2*l*sin(theta))^2 + (y + 2*l*cos(theta))^2 = s^2", reaction: T}}
forces: {weight: {on: rod, vector: W*j}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("theta = 0 or theta = pi or theta = 49.80 deg or theta = -49.80 deg", Verdict.EQUIVALENT),
        ("theta = 0 or theta = pi or theta = 50.80 deg or theta = -50.80 deg", Verdict.WRONG),
    ],
)
def test_strings_that_would_push_are_not_asked_for(
    problem: Callable[[str], Problem], answer: str, verdict: Verdict
) -> None:
    """Nor is the place of the end on the wall, which the string determines but for its sign."""
    assert check_answer(problem(ROD_AT_WALL), (Fragment.of(answer),)).verdict is verdict


BALLS = """title: Two balls joined by a rod in a bowl
parameters: {P: 30 N, Q: 40 N, R: m}
coordinates: [phi]
particles: {A: {position: "-R*sin(phi)*i - R*cos(phi)*j"}, B: {position: "R*cos(phi)*i - R*sin(phi)*j"}}
forces: {wa: {on: A, vector: -P*j}, wb: {on: B, vector: -Q*j}}
find: equilibrium
"""


@pytest.mark.parametrize(
    ("answer", "verdict"),
    [
        ("phi = 53.1 deg", Verdict.EQUIVALENT),
        ("phi = -126.9 deg", Verdict.INCOMPLETE),
        ("phi = 54.1 deg", Verdict.WRONG),
    ],
)
def test_an_angle_in_numbers_stands_for_its_tangent(
    problem: Callable[[str], Problem], answer: str, verdict: Verdict
) -> None:
    assert check_answer(problem(BALLS), (Fragment.of(answer),)).verdict is verdict
