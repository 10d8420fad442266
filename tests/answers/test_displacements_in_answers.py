"""Equations between displacements in answers, and d'Alembert's principle as an answer."""

from __future__ import annotations

from functools import cache

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.answers.readings import NOT_FOR_ALL
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem

SCREW = """
title: A screw in its nut
parameters: [m, g, lambda, J]
coordinates: [z, phi]
bodies: {screw: {mass: m, inertia: J, position: z*k, angle: phi}}
constraints: {thread: z = lambda*phi}
gravity: -g*k
"""
PENDULUM = """
title: A pendulum
parameters: [m, g, l]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: -g*j
generalized_coordinates:
  angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: -l*cos(theta)}}
"""
MOVED = """
title: A ring on a rod that is moved sideways
parameters: [m, g, u]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x = u*t}
gravity: -g*j
"""
RESTATES = "it restates a constraint"


@cache
def examiner(text: str) -> Examiner:
    return Examiner.of(read_problem(Source("problem.yaml", text)))


@pytest.mark.parametrize(
    ("text", "equations", "verdict", "said"),
    [
        (SCREW, ["delta(z) = lambda*delta(phi)"], "incomplete", [RESTATES]),
        (SCREW, ["d(z) = lambda*d(phi)"], "incomplete", [RESTATES]),
        (SCREW, ["delta(z) = lambda*delta(phi)", "(m + J/lambda^2)*z'' = -m*g"], "equivalent", [RESTATES, ""]),
        (SCREW, ["delta(z) = 2*lambda*delta(phi)"], "wrong", [NOT_FOR_ALL]),
        (SCREW, ["delta(z) = 0"], "wrong", [NOT_FOR_ALL]),
        (SCREW, ["delta(phi)*delta(z) = 0"], "wrong", [NOT_FOR_ALL]),
        (SCREW, ["m*(z'' + g)*delta(z) + J*phi''*delta(phi) = 0"], "equivalent", [""]),
        (SCREW, ["m*(z'' - g)*delta(z) + J*phi''*delta(phi) = 0"], "wrong", [NOT_FOR_ALL]),
        (PENDULUM, ["x*delta(x) + y*delta(y) = 0"], "incomplete", [RESTATES]),
        (PENDULUM, ["x*delta(y) + y*delta(x) = 0"], "wrong", [NOT_FOR_ALL]),
        (PENDULUM, ["delta(x) = l*cos(theta)*delta(theta)"], "incomplete", [RESTATES]),
        (PENDULUM, ["delta(x) = l*sin(theta)*delta(theta)"], "wrong", [NOT_FOR_ALL]),
        (PENDULUM, ["m*x''*delta(x) + m*(y'' + g)*delta(y) = 0"], "equivalent", [""]),
        (PENDULUM, ["m*l*(l*theta'' + g*sin(theta))*delta(theta) = 0"], "equivalent", [""]),
        (MOVED, ["delta(x) = 0", "y'' = -g"], "equivalent", [RESTATES, ""]),  # time is frozen
        (MOVED, ["d(x) = u*d(t)", "y'' = -g"], "equivalent", [RESTATES, ""]),
        (MOVED, ["d(x) = 0", "y'' = -g"], "wrong", [NOT_FOR_ALL, ""]),
    ],
)
def test_displacements(text: str, equations: list[str], verdict: str, said: list[str]) -> None:
    found = examiner(text).check(tuple(Fragment.of(e) for e in equations))
    assert found.verdict.value == verdict
    assert [" ".join([e.diagnosis, *e.remarks]).strip() for e in found.each] == said
