"""Mistakes in the meaning of letters are named.

Quasi-velocities taken for velocities of coordinates: the mistake is named.

Mistakes in how fast a body turns are named.
"""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.answers.models.slips import WrongAnswer, answers_by, assert_named, feedback_on, name_of


@pytest.mark.parametrize("answer", answers_by("kinematics"), ids=name_of)
def test_the_cause_is_named(answer: WrongAnswer) -> None:
    assert_named(answer)


TACKLE = """
title: Block and a movable pulley
axes: {i: right, j: down}
parameters: [m, M, mu, g]
coordinates: {x: way of the block, z: height of the block, y: depth of the load}
particles:
  block: {mass: m, position: x*i - z*j}
  load: {mass: M, position: y*j}
constraints: {table: {equation: z = 0, reaction: N}, rope: {equation: x = 2*y, reaction: S}}
gravity: g*j
forces: {rub: {friction: mu, constraint: table, on: block, slip: positive, contact: positive}}
generalized_coordinates: {depth: {coordinates: [y]}}
"""
SPOOL = """
title: Spool pulled over a floor
axes: {i: right, j: up}
parameters: [m, J, R, r, P, g]
coordinates: {x: place of the axis, y: height of the axis, theta: angle turned clockwise}
bodies: {spool: {mass: m, inertia: J, position: x*i + y*j, angle: -theta}}
constraints: {floor: y = R, rolling: {equation: "x' = R*theta'", reaction: F}}
gravity: -g*j
forces: {pull: {on: spool, vector: P*i, at: r_spool - r*j}}
generalized_coordinates: {way: {coordinates: [x]}}
"""
RAMPS = """
title: Two blocks on two ramps, in the wind
axes: {i: right, j: up}
parameters: {m: positive, M: positive, alpha: acute, beta: acute, P: positive, g: positive}
coordinates: {s: way along both ramps}
particles:
  first: {mass: m, position: -s*cos(alpha)*i - s*sin(alpha)*j}
  second: {mass: M, position: -s*cos(beta)*i + s*sin(beta)*j}
gravity: -g*j
forces: {wind: {on: first, vector: P*i}}
"""


@pytest.mark.parametrize(
    ("problem", "answer", "said"),
    [
        (TACKLE, "(M + m)*y'' = (M - mu*m)*g", "for `block` moving half as fast (a factor in a constraint)"),
        (TACKLE, "(M + m/4)*y'' = (M - mu*m/2)*g", "for `block` moving a quarter as fast"),
        (SPOOL, "(m + J/(4*R^2))*x'' = P*(1 - r/(2*R))", "for x' = 2*R*theta' as the constraint `rolling`"),
        (
            RAMPS,
            "(m + M)*s'' = m*g*cos(alpha) - M*g*cos(beta) - P*sin(alpha)",
            "with sine and cosine of alpha and beta exchanged",
        ),
    ],
)
def test_a_constraint_with_another_factor_and_two_angles(problem: str, answer: str, said: str) -> None:
    examiner = Examiner.of(read_problem(Source("problem.yaml", problem)))
    [verdict] = examiner.check((Fragment.of(answer),)).each
    assert said in verdict.diagnosis


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        (
            "two-wheeled-carriage",
            "(M + 2*m + 2*K/R^2)*v' = M*a*omega^2 + (tau_1 + tau_2)/R; (I + M*a^2 + 2*J + 8*m*b^2 + 8*K*b^2/R^2)*omega' = -M*a*v*omega + 2*b*(tau_2 - tau_1)/R",
            "with 2*b in place of b throughout",
        ),
    ],
)
def test_a_length_twice_as_large_throughout(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
