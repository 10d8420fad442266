"""Answers to questions, with the reason for the branch that is taken."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.document.derivation import Rule
from lagrange.explain.report import report
from lagrange.mechanics.results import Solution
from lagrange.render import html, latex
from lagrange.render.json import as_object
from tests.support.derivation_text import said_in
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        (
            "hoop-off-a-cylinder",
            Rule.QUESTION,
            "The initial state is an equilibrium, from which the motion may start in either direction: one value belongs to each.",
        ),
        (
            "chain-off-a-table",
            Rule.QUESTION,
            "The sign is that of the first arrival.",
        ),
        ("ball-thrown-up", Rule.QUESTION, " has the opposite sense, for which this equation of motion does not hold."),
        (
            "boat-that-drifts",
            Rule.QUESTION,
            "There the velocity and the acceleration vanish: a motion that starts elsewhere only approaches this state, in the limit ",
        ),
    ],
)
def test_the_reason_for_a_branch(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)


SWING = """
title: Swing
parameters: {m: positive, l: positive, g: positive, theta_0: acute}
axes: {i: right, j: down}
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i + l*cos(theta)*j}}
gravity: g*j
initial: {theta: theta_0, theta': 0}
ask: {quarter: {quantity: t, when: theta = 0}}
"""


def test_a_large_swing_takes_an_integral(problem: Callable[[str], Solution]) -> None:
    """The quarter period in letters: one integral, in every format, and a finished derivation."""
    solved = report(problem(SWING))
    assert solved.holds
    page = [(solved.derivation, solved.notation)]
    assert r"\int_{0}^{\theta_{0}} \frac{1}" in latex.render(page)
    assert "<msubsup><mo>∫</mo>" in html.render(page)
    [asked] = as_object(solved)["asked"]
    assert (asked["integral"]["over"], asked["integral"]["from"], "value" in asked) == ("theta", "0", False)


GATE = """
title: Gate held by a spring
parameters: {m: positive, l: positive, k: positive, h: positive, g: positive}
coordinates: [theta]
bodies: {gate: {mass: m, inertia: m*l^2/12, position: l/2*cos(theta)*i - l/2*sin(theta)*j, angle: -theta}}
gravity: -g*j
forces: {spring: {spring: k, between: [l*cos(theta)*i - l*sin(theta)*j, l*i + h*j], length: h}}
initial: {theta: 0, theta': 0}
ask: {speed: {quantity: "theta'", when: "theta = pi/6"}}
"""


def test_a_long_value_is_not_repeated_with_the_other_sign(problem: Callable[[str], Solution]) -> None:
    found = report(problem(GATE))
    text = latex.render([(found.derivation, found.notation)])
    assert "The sign is that of the first arrival." in " ".join(text.split())


def test_a_factor_that_was_divided_away_is_stated() -> None:
    said = said_in("governor", Rule.QUESTION)
    assert "Where sin θ, the condition holds for every φ̇²." in said
    assert "Since cos θ, this needs φ̇²." in said
    [speed, *_] = solved("governor").asked
    assert speed.least is not None
    wave, relation, bound = speed.least
    assert (str(wave), relation, str(sp.factor(bound))) == ("cos(theta)", ">", "g*(M + m)/(l*m)")


def test_that_a_square_is_not_negative_is_said_by_its_factors() -> None:
    """(M + m) g/(m l cos θ) ≥ 0 is cos θ > 0."""
    [speed, *_] = solved("governor").asked
    [b] = speed.branches
    [c] = b.of_square
    assert (str(c.lhs), c.relation, c.rhs) == ("cos(theta)", ">", 0)
