"""Reading the initial state and the questions."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.diagnostics import ProblemError
from lagrange.problem.model import Problem

START = """
title: Example
parameters: [m, l, g, x_0]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: {equation: x^2 + y^2 = l^2, reaction: T}}
generalized_coordinates: {angle: {coordinates: [theta], substitute: {x: l*sin(theta), y: l*cos(theta)}}}
"""


def test_the_state_and_the_questions_are_read(problem: Callable[[str], Problem]) -> None:
    text = """
initial: {x: x_0, θ': 2*g/l}
ask:
  one: {quantity: T, when: theta = pi/2}
  two: {quantity: "T_kinetic + energy", when: ["x'' = 0", "t = 1"], by: theta}
answers: {ask: {one: T = 3*m*g}}
"""
    read = problem(START + text)
    assert [(v.symbol.name, str(v.value)) for v in read.initial] == [("x", "x_0"), ("theta'", "2*g/l")]
    one, two = read.questions
    assert (one.name, str(one.quantity), [str(c.function) for c in one.when], one.by) == (
        "one",
        "T",
        ["theta - pi/2"],
        None,
    )
    assert (len(two.when), two.by) == (2, sp.Symbol("theta", real=True))
    assert read.answers is not None
    assert read.answers.ask["one"].text == "T = 3*m*g"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("initial: {x: y}", "not-constant"),
        ("initial: {x'': 0}", "no-state"),
        ("initial: {2*x: 0}", "no-state"),
        ("initial: {x: 0, x : 1}", "duplicate-key"),
        ("initial: {z: 0}", "unknown-symbol"),
        ("ask: {a: {when: x = 0}}", "missing-key"),
        ("ask: {a: x}", "wrong-kind"),
        ("ask: {a: {quantity: x, wenn: y = 0}}", "unknown-key"),
        ("ask: {a: {quantity: N}}", "unknown-symbol"),
        ("ask: {a: {quantity: d(x)}}", "not-allowed-here"),
        ("ask: {a: {quantity: x, when: x}}", "no-equals-sign"),
        ("ask: {a: {quantity: x, when: [x' = 0, 't > 0']}}", "inequality"),
        ("ask: {a: {quantity: x, when: r_P = 0}}", None),
        ("ask: {a: {quantity: x, by: m}}", "no-variable"),
        ("ask: {a: {quantity: x}}\nanswers: {ask: {b: 1}}", "unknown-name"),
        ("ask: {a: {quantity: x}}\nanswers: {ask: {a: 2*q}}", "unknown-symbol"),
        ("ask: {" + ", ".join(f"a{n}: {{quantity: x}}" for n in range(21)) + "}", "too-many-questions"),
    ],
)
def test_a_mistake_is_an_error_with_its_place(text: str, code: str | None, problem: Callable[[str], Problem]) -> None:
    with pytest.raises(ProblemError) as error:
        problem(f"{START}{text}\n")
    assert all(d.span is not None for d in error.value.diagnostics)
    assert code is None or code in [d.code for d in error.value.diagnostics]
