"""Stated steady motions, and the frequencies about them."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest
import sympy as sp

from lagrange.answers.friction.logarithms import parted_logarithms
from lagrange.answers.questions.own_answers import compared_answers
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from tests.support.problem_texts import read

HOLE = """title: Two particles on a string through a hole
coordinates: [r, phi]
parameters: [m, M, g]
particles: {P: {mass: m, position: "r*cos(phi)*i + r*sin(phi)*j"}, Q: {mass: M, position: r*k}}
gravity: -g*k
find: steady
"""
SPRING = """title: A dumbbell with a spring
coordinates: [r, phi]
parameters: [m, c, a]
particles: {P: {mass: m, position: "r*cos(phi)*i + r*sin(phi)*j"}}
forces: {spring: {spring: c, between: [0*i, P], length: a}}
find: steady
"""


@cache
def solved(text: str) -> Solution:
    return solve(read(text))


def verdicts(text: str, answers: str) -> list[str]:
    stated = read(f"{text}answers: {answers}\n")
    return [v.verdict.value for v in compared_answers(replace(solved(text), problem=stated))]


@pytest.mark.parametrize(
    ("frequency", "verdict"),
    [
        ("phi'*sqrt(3*m/(M + m))", "equivalent"),
        ("sqrt(3*M*g/((M + m)*r))", "equivalent"),
        ("omega^2 = 3*M*g/((M + m)*r)", "equivalent"),
        ("sqrt(3*m/M)*phi'", "wrong"),
        ("sqrt(M*g/((M + m)*r))", "wrong"),
    ],
)
def test_frequencies_about_a_steady_motion(frequency: str, verdict: str) -> None:
    """(M + m) ξ'' + 3 m φ'² ξ = 0 about m r φ'² = M g, the angular momentum being kept."""
    assert verdicts(HOLE, f'{{frequencies: ["{frequency}"]}}') == [verdict]


def test_a_radius_is_positive() -> None:
    """r φ'² m = c (r − a) at r > 0; the coordinates have the same circles once more with r < 0."""
    assert verdicts(SPRING, "{steady: [m*r*phi'^2 = c*(r - a)]}") == ["equivalent"]
    assert verdicts(SPRING, "{steady: [m*r*phi'^2 = c*r]}") == ["wrong"]


def test_logarithms_of_a_factor_of_unknown_sign() -> None:
    m, q, t = sp.symbols("m q t", positive=True)
    same = (m / q - t) * sp.log(1 - q * t / m) + (m / q - t) * sp.log(m / (m - q * t))
    assert parted_logarithms(same) == 0
    assert parted_logarithms(sp.log(q * t / m - 1) - sp.log(m - q * t) + sp.log(m)) != 0


AXLE = """title: A conical pendulum that a spring holds to the axis
coordinates: [theta, phi]
parameters: [m, l, g, c, b]
particles:
  P: {mass: m, position: "l*sin(theta)*cos(phi)*i + l*sin(theta)*sin(phi)*j - l*cos(theta)*k"}
gravity: -g*k
forces: {spring: {spring: c, between: [P, -l*cos(theta)*k], length: b}}
find: steady
"""


@pytest.mark.parametrize(
    ("stated", "verdict"),
    [
        ("m*l*phi'^2*sin(theta)*cos(theta) = m*g*sin(theta) + c*cos(theta)*(l*sin(theta) - b)", "equivalent"),
        ("m*l*phi'^2*sin(theta)*cos(theta) = m*g*sin(theta) + c*cos(theta)*(l*sin(theta) + b)", "equivalent"),
        ("m*l*phi'^2*sin(theta)*cos(theta) = m*g*sin(theta) + c*cos(theta)*l*sin(theta)", "wrong"),
    ],
)
def test_books_state_one_side_of_a_condition_with_a_sign(stated: str, verdict: str) -> None:
    """|sin θ| is sin θ on one side of the axis and −sin θ on the other, where the same circles are counted again."""
    assert verdicts(AXLE, f'{{steady: ["{stated}"]}}') == [verdict]


def test_a_length_at_which_the_coordinates_fail_is_not_missed() -> None:
    """An elastic conical pendulum; with r = 0 the conditions hold for some angle, and there is no direction."""
    text = AXLE.replace("[theta, phi]", "[r, theta, phi]").replace("l*", "r*").split("forces")[0]
    text += "forces: {spring: {potential: c*(r - l)^2/2}}\nfind: steady\n"
    answers = "{steady: [c*(r - l)*cos(theta) = m*g, r*cos(theta)*phi'^2 = g]}"
    assert verdicts(text, answers) == ["equivalent"]


def test_a_root_may_be_written_over_another_denominator() -> None:
    """A fast charge on a circle, γ m r φ'² = K/r², which has no closed solution for r."""
    text = """title: A fast charge about a fixed one
parameters: [m, c, K]
coordinates: [r, phi]
lagrangian: "-m*c^2*sqrt(1 - (r'^2 + r^2*phi'^2)/c^2) + K/r"
find: steady
"""
    assert verdicts(text, "{steady: [m*r^3*phi'^2 = K*sqrt(1 - r^2*phi'^2/c^2)]}") == ["equivalent"]
    assert verdicts(text, "{steady: [m*r^3*phi'^2 = K*(1 - r^2*phi'^2/c^2)]}") == ["wrong"]
