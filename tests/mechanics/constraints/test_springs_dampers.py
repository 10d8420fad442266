"""Springs and dampers: lengths, pulls, potentials."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

import lagrange
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.references import reference_of_solution
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.reader import read_equation
from lagrange.mechanics.constraints.springs_dampers import stretched_springs
from lagrange.mechanics.dynamics.comparison import System, compare
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render.json import as_object
from tests.support import shared

Read = Callable[[str], Problem]
ON_A_LINE = """
title: A spring on a line
parameters: [m, c, l]
coordinates: [x]
particles: {{P: {{mass: m, position: x*i}}}}
forces: {{s: {{spring: c, between: [{ends}]{more}}}}}
"""


@pytest.mark.parametrize(
    ("ends", "more", "equation"),
    [
        ("0*i, P", "", "m*x'' + c*x = 0"),
        ("P, 0*i", "", "m*x'' + c*x = 0"),
        ("0*i, P", ", length: l, sense: positive", "m*x'' + c*(x - l) = 0"),
        ("P, 0*i", ", length: l, sense: negative", "m*x'' + c*(x - l) = 0"),
        ("P, 0*i", ", length: l, sense: positive", "m*x'' + c*(x + l) = 0"),
        ("0*i, P", ", length: l", "m*x'' + c*(abs(x) - l)*sign(x) = 0"),
        ("P, l*i", ", length: l, sense: positive", "m*x'' + c*x = 0"),
    ],
)
def test_a_spring_on_a_line(problem: Read, ends: str, more: str, equation: str) -> None:
    solution = solve(problem(ON_A_LINE.format(ends=ends, more=more)))
    assert solution.holds
    read = read_equation(Fragment.of(equation), reference_of_solution(solution).scope)
    result = compare([read.lhs - read.rhs], System(solution.own.configuration, solution.own.motion.expressions))
    assert result is not None
    assert result.agree


def test_a_spring_of_no_free_length_has_no_root(problem: Read) -> None:
    text = """
title: An isotropic oscillator
parameters: [m, c]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {s: {spring: c, between: [P, 0*i]}}
"""
    [first, second] = solve(problem(text)).own.motion.expressions
    assert not (first + second).atoms(sp.Pow)


def test_lengths_and_pulls_are_identities() -> None:
    found = shared.reported("braced_rods")
    scope = reference_of_solution(found.solution).scope
    shown = [e for s in as_object(found)["steps"] for b in s["body"] for e in b.get("equations", ())]
    said = [e["text"] for e in shown if e.get("label", "").startswith(("length-", "pull-"))]
    assert len(said) == 4
    for text in said:
        equation = read_equation(Fragment.of(text), scope)
        assert is_zero(equation.lhs - equation.rhs), text


def test_a_damper_along_a_line_has_no_sign_in_a_choice(problem: Read) -> None:
    """The distance 2 |s| has the rate 2 s' along the line; c (2 s')² came out with sign(s)²."""
    text = ON_A_LINE.format(ends="P, 0*i", more="").replace("spring: c", "damper: c")
    found = solve(problem(f"{text}generalized_coordinates: {{c: {{coordinates: [s], substitute: {{x: 2*s}}}}}}\n"))
    motion = found.choices[0].motion
    assert motion is not None
    assert not any(e.has(sp.sign) for e in motion.expressions)


@pytest.mark.parametrize(
    ("between", "low", "high", "distance"),
    [
        ("[O, P]", "0", "10", "x"),
        ("[P, O]", "0", "10", "x"),
        ("[O, P]", "-10", "0", "-x"),
        ("[O, P]", "-1", "1", "Abs(x)"),
    ],
)
def test_a_range_decides_in_which_sense_a_spring_lies(between: str, low: str, high: str, distance: str) -> None:
    text = ON_A_LINE.format(ends=between[1:-1], more=", length: l")
    problem = lagrange.loads(text.replace("coordinates: [x]", f"coordinates: {{x: {{range: [{low}, {high}]}}}}"))
    [spring] = stretched_springs(problem)
    assert str(spring.distance) == distance


@pytest.mark.parametrize(
    ("place", "low", "high", "distance"),
    [
        ("2*l*cos(x)", "0", "90 deg", "2*l*cos(x)"),
        ("2*l*cos(x)", "-90 deg", "90 deg", "2*l*cos(x)"),
        ("-l*sin(x)", "0", "180 deg", "l*sin(x)"),
        ("l*cos(x)", "0", "91 deg", "l*Abs(cos(x))"),
    ],
)
def test_a_range_of_an_angle_decides_it(place: str, low: str, high: str, distance: str) -> None:
    """Though the length is zero at an end of the range."""
    problem = lagrange.loads(
        f"title: T\nparameters: [l, c]\ncoordinates: {{x: {{range: [{low}, {high}]}}}}\n"
        f"particles: {{P: {{position: {place}*i}}}}\nforces: {{s: {{spring: c, between: [O, P], length: l}}}}\n"
    )
    [spring] = stretched_springs(problem)
    assert str(spring.distance) == distance


def test_a_range_decides_the_length_of_a_chord() -> None:
    """From the highest point of a hoop to a collar: 2R |cos x|, cos x > 0 for |x| < 80 deg."""
    problem = lagrange.loads(
        "title: T\nparameters: [R, c]\ncoordinates: {x: {range: [-80 deg, 80 deg]}}\n"
        "particles: {P: {position: 2*R*cos(x)*(sin(x)*i - cos(x)*j)}}\n"
        "forces: {s: {spring: c, between: [O, P], length: R}}\n"
    )
    [spring] = stretched_springs(problem)
    assert str(spring.distance) == "2*R*cos(x)"


def test_a_potential_has_the_extension_and_not_its_negative() -> None:
    problem = lagrange.loads(ON_A_LINE.format(ends="O, P", more=", length: l, sense: positive"))
    [spring] = stretched_springs(problem)
    assert spring.energy == spring.stiffness * (spring.distance - spring.length) ** 2 / 2
