"""Of several branches of a solution the one that comes first."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.core.symbols import Bounded
from lagrange.explain.report import report
from lagrange.mechanics.questions.branches import sign_of_value
from lagrange.mechanics.questions.results import Reason
from lagrange.render import terminal
from lagrange.render.json import as_object
from tests.mechanics.questions.test_arrivals import BOAT
from tests.mechanics.questions.test_questions import PENDULUM, Read, asked
from tests.mechanics.questions.test_results import SLOPE


def test_of_two_turning_points_that_of_the_start_is_left_out(problem: Read) -> None:
    text = PENDULUM + 'initial: {x: 3/5*l, y: 4/5*l, y\': 0}\nask: {it: {quantity: x, when: ["x\' = 0", "y\' = 0"]}}\n'
    answer = asked(problem, text)
    dropped = [why for _, why in answer.dropped]
    assert Reason.INITIAL in dropped or len(answer.branches) == 1


def test_a_branch_that_the_values_exclude_has_no_number(problem: Read) -> None:
    """Into a buffer: k x²/2 − m g x (sin 25° − cos 25°/5) = m v²/2 has one positive root, which is the answer."""
    text = SLOPE[: SLOPE.index("initial")].replace("forces:\n", 'forces:\n  buffer: {potential: "k*(x - d)^2/2"}\n')
    text = text.replace("parameters:\n", "parameters:\n  k: {assume: positive, value: 20 N/cm}\n")
    start = 'initial: {x: d, x\': "sqrt(2*d*g*(sin(alpha) - mu*cos(alpha)))"}\n'
    found = report(problem(text + start + 'ask: {furthest: {quantity: x, when: "x\' = 0"}}\n'))
    [furthest] = as_object(found)["asked"]
    pull = 40 * 9.81 * (0.5 - math.sqrt(3) / 8)
    compressed = (pull + math.sqrt(pull**2 + 2 * 2000 * pull * 6)) / 2000
    assert furthest["number"] == pytest.approx(6 + compressed)
    page = terminal.text(found.derivation, found.notation, 80)
    assert "does not exist with the given values" not in page
    assert page.count("x ≈") == 2  # at the head and with the answer, of the one branch that exists


def test_a_place_beyond_that_limit_is_under_a_condition(problem: Read) -> None:
    [branch] = asked(problem, BOAT + 'ask: {there: {quantity: "x\'", when: x = s}}\n').branches
    m, b, v, s = (sp.Symbol(n, positive=True) for n in "mbvs")
    [condition] = branch.conditions
    assert sp.cancel((condition.lhs - condition.rhs) / (m * v - b * s)).is_positive


def test_the_sign_of_a_sum_with_a_logarithm() -> None:
    """1 − 1/w < log w < w − 1."""
    k, v, g = sp.symbols("k v g", positive=True)
    assert sign_of_value(k * v - g * sp.log((g + k * v) / g)) == 1
    assert sign_of_value(k * v / (g + k * v) - sp.log((g + k * v) / g)) == -1
    assert sign_of_value(k - sp.log((g + v) / g)) is None


def test_the_magnitude_of_what_is_positive_is_no_other_value() -> None:
    """|sin α| − sin α is zero for an acute angle, and of no sign for any: a ladder was said to have left its wall."""
    acute = Bounded("alpha", low=sp.S.Zero, high=sp.pi / 2, strict=(True, True))
    s, g = sp.sin(acute), sp.Symbol("g", positive=True)
    assert sign_of_value(sp.expand(g * sp.sqrt(9 - 4 * s**2) * (sp.Abs(s) - s))) == 0
    free = sp.sin(sp.Symbol("beta", real=True))
    assert sign_of_value(g * (sp.Abs(free) - free)) in (None, 1)


def test_a_ladder_leaves_its_wall_whichever_angle_is_taken(problem: Read) -> None:
    text = """
title: Ladder
parameters: {m: positive, a: positive, g: positive, theta_0: acute}
coordinates: [x, y, theta]
bodies: {ladder: {mass: m, inertia: m*a^2/3, position: x*i + y*j, angle: -theta}}
constraints:
  wall: {equation: x >= a*cos(theta), reaction: N_B}
  floor: {equation: y >= a*sin(theta), reaction: N_A}
gravity: -g*j
generalized_coordinates: {tilt: {coordinates: [theta]}}
initial: {theta: theta_0, theta': 0}
ask: {leaves: {quantity: theta, when: N_B = 0}}
"""
    [branch] = asked(problem, text).branches
    [start] = [s for s in branch.rhs.free_symbols if s.name == "theta_0"]
    assert isinstance(branch.lhs, sp.sin)
    assert branch.rhs == 2 * sp.sin(start) / 3
