"""Dimensions in the initial state and in questions."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.core.diagnostics import ProblemError
from lagrange.problem.model import Problem
from tests.support.problem_texts import readings

START = """
title: Example
parameters: {m: positive, l: positive, g: positive, s: positive, tau: {value: 20 s}, v: {unit: m/s}}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""


@pytest.mark.parametrize(
    ("text", "help_"),
    [
        ("initial: {x: 20 kg}", "`x` is in m, and `20 kg` is in kg"),
        ("initial: {theta: 20 cm}", "`theta` is a number or an angle, and `20 cm` is in m"),
        ("initial: {theta': v}", "`theta'` is in 1/s, and `v` is in m/s"),
        ("initial: {x: v*tau + l, y: v}", "`y` is in m, and `v` is in m/s"),
        ("ask: {a: {quantity: x, when: x = tau}}", "`x` is in m, and `tau` is in s"),
        ("ask: {a: {quantity: x, when: x = v}}", "`x` is in m, and `v` is in m/s"),
        ("ask: {a: {quantity: x, when: t = 3 m}}", ""),
        ("ask: {a: {quantity: x, when: T_kinetic = 3 N}}", "`T_kinetic` is in N m, and `3 N` is in N"),
        ("ask: {a: {quantity: x + tau, when: y = 0}}", "`x` is in m, and `tau` is in s"),
        ('ask: {a: {quantity: x, when: [y = 0, "x\' = 2 cm/s^2"]}}', "`x'` is in m/s, and `2 cm/s^2` is in m/s^2"),
    ],
)
def test_what_cannot_be_equal_is_refused(text: str, help_: str, problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as error:
        problem(f"{START}{text}\n")
    [found] = error.value.diagnostics
    assert found.code in ("unit-mismatch", "two-readings")
    assert found.span is not None
    assert help_ in found.help


@pytest.mark.parametrize(
    "text",
    [
        "initial: {x: 20 cm, theta': 30 rpm}",
        "initial: {x: 3, y: l + 2, theta: pi/3}",  # bare numbers may hide a unit
        "ask: {a: {quantity: T, when: T = 10*m}}",  # so may a factor
        "ask: {a: {quantity: x, when: T = 2*m*g}}",  # of a reaction it is not known
        "ask: {a: {quantity: T/m, when: [t = 2*tau, y = v*tau]}}",
    ],
)
def test_what_may_be_equal_is_not(text: str, problem: Callable[[str], Problem]) -> None:
    assert not readings(problem(f"{START}{text}\n"))


def test_the_dimension_says_whether_a_letter_is_a_unit(problem: Callable[[str], Problem]) -> None:
    """Beside a mass m, `x: 2 m` is 2 metres; beside an unknown s, `T = 2 m g` is a product."""
    read = problem(START + "initial: {x: 2 m}\nask: {one: {quantity: x, when: T = 2 m g}}\n")
    assert [str(v.value) for v in read.initial] == ["2"]
    assert [str(c.rhs) for q in read.questions for c in q.when] == ["2*g*m"]
    assert [(n.code, n.message.partition(" is read")[0]) for n in readings(read)] == [
        ("read-as", "`2 m`"),
        ("read-as", "`2 m g`"),
    ]
    assert not readings(problem(START + "initial: {x: 2*l, y: 20 cm}\n"))
    scaled = "title: Example\ncoordinates: [x]\nparameters: [m, c]\nparticles: {P: {mass: m, position: c*x*i}}\n"
    with pytest.raises(ProblemError) as error:
        problem(scaled + "initial: {x: 2 m}\n")
    assert [d.code for d in error.value.diagnostics] == ["two-readings"]
    assert "`2*m`" in error.value.diagnostics[0].help


def test_where_a_number_with_a_unit_belongs(problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as error:
        problem(START.replace("mass: m", "mass: 2 kg"))
    [found] = error.value.diagnostics
    assert (found.code, "parameters: {a: {value: 2 kg}}" in found.help) == ("unknown-symbol", True)
