"""Texts that answer other questions than for equations of motion."""

from __future__ import annotations

import pytest

from lagrange.answers.examiner import Examiner
from lagrange.core.diagnostics import Fragment, Source
from lagrange.problem.loader import read_problem
from tests.support.shared import loaded, solved

WITH_A_TORSION_SPRING = """
title: Pendulum with a torsion spring
parameters: [m, l, g, c]
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
forces: {spring: {potential: c*theta^2/2}}
gravity: -g*j
find: [motion, equilibrium, linearization]
"""
"""It may be at rest elsewhere than at θ = 0, where no closed form is known."""


@pytest.mark.parametrize(
    ("name", "lines", "verdict"),
    [
        ("damped-oscillator", ["x_max = F/sqrt((c - m*w^2)^2 + b^2*w^2)"], "equivalent"),
        ("disc-against-a-step", ["theta' = omega*(1 - 2*h/(3*R))"], "equivalent"),
        ("ex11-ideal-pendulum", ["theta'' = -g/l*sin(theta)"], "equivalent"),
    ],
)
def test_verdicts_on_a_text(name: str, lines: list[str], verdict: str) -> None:
    examiner = Examiner(loaded(name), solved(name))
    assert examiner.check(tuple(map(Fragment.of, lines))).verdict.value == verdict


@pytest.mark.parametrize(
    ("lines", "verdict"),
    [
        (["omega = sqrt(g/l + c/(m*l^2))"], "equivalent"),
        (["omega = sqrt(g/l)"], "undecided"),
        (["sin(theta) = -c*theta/(m*g*l)", "omega = sqrt(g/l*cos(theta) + c/(m*l^2))"], "equivalent"),
        (["theta = 0: omega = sqrt(g/l)"], "wrong"),
        (["theta = 2*pi: omega = sqrt(g/l)"], "wrong"),  # not a position of equilibrium
    ],
)
def test_a_frequency_at_a_position_that_is_not_known_is_undecided(lines: list[str], verdict: str) -> None:
    examiner = Examiner.of(read_problem(Source("problem.yaml", WITH_A_TORSION_SPRING)))
    judged = examiner.check(tuple(map(Fragment.of, lines)))
    assert judged.verdict.value == verdict
    assert "the conditions of equilibrium do not require it" not in str(judged)


def test_a_conserved_quantity_is_no_condition_of_steady_motion() -> None:
    central = """
title: Central force
parameters: [m, k]
frame: {type: polar, coordinates: [r, phi]}
coordinates: [r, phi]
particles: {P: {mass: m, position: r*e_r}}
forces: {spring: {potential: k*r^2/2}}
find: [motion, steady]
"""
    judged = Examiner.of(read_problem(Source("problem.yaml", central))).check((Fragment.of("m*r^2*phi' = const"),))
    assert judged.verdict.value == "incomplete"  # it holds in every motion, and does not replace the equations


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("theta' = m*v/((M + m)*l)", "incomplete"),
        ("theta' = m*v/((M + m)*l); cos(theta) = 1 - m^2*v^2/(2*(M + m)^2*g*l)", "equivalent"),
        ("v_G' = m*v/(M + m)", "incomplete"),
    ],
)
def test_an_impact_leaves_the_question_after_it_open(text: str, verdict: str) -> None:
    examiner = Examiner(loaded("ballistic-pendulum"), solved("ballistic-pendulum"))
    assert examiner.check((Fragment.of(text),)).verdict.value == verdict


@pytest.mark.parametrize(("term", "verdict"), [("2*g/l", "equivalent"), ("g/l", "wrong")])
def test_linearized_equations_beside_frequencies_are_judged(term: str, verdict: str) -> None:
    name = "double-pendulum-small-oscillations"
    text = f"Linearised: 2 θ1'' + θ2'' + {term} θ1 = 0, θ1'' + θ2'' + g/l θ2 = 0\nω² = (2 ± √2) g/l\nmodes: θ2/θ1 = ±±2"
    judged = Examiner(loaded(name), solved(name)).check((Fragment.of(text),))
    assert judged.verdict.value == verdict
    assert len(judged.messages) > 0  # the last line cannot be read


@pytest.mark.parametrize(
    ("text", "verdict"),
    [
        ("steady: theta' = 0, theta'' = 0, phi' = sqrt(g/(l*cos(theta)))", "equivalent"),
        ("steady: theta' = 0, phi' = sqrt(g*cos(theta)/l)", "wrong"),
        ("phi'' = 0, cos(theta) = g/(l*phi'^2)", "equivalent"),
    ],
)
def test_what_only_says_that_a_motion_is_steady(text: str, verdict: str) -> None:
    examiner = Examiner(loaded("conical-pendulum"), solved("conical-pendulum"))
    assert examiner.check((Fragment.of(text),)).verdict.value == verdict
