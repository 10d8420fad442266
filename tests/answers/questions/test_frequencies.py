"""Frequencies that an answer states."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.answers.verdicts import AnswerVerdict
from lagrange.core.diagnostics import ProblemError, Source
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.linearized_systems import COUPLED, DAMPED, DOUBLE, HOOP, MOLECULE, PENDULUM, solved

PASS = """
parameters: [m, c, f]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces: {saddle: {potential: c*x^2/2 - f*y^2/2}}
"""
ACCELERATED = """
parameters: [m, g, l, a]
coordinates: [theta]
particles: {P: {mass: m, position: (a*t^2/2 + l*sin(theta))*i - l*cos(theta)*j}}
gravity: -g*j
"""
WINDING = """
parameters: [m, g, l, R]
coordinates: [theta]
let: {out: cos(theta)*i + sin(theta)*j, along: sin(theta)*i - cos(theta)*j}
particles: {P: {mass: m, position: R*out + (l + R*theta)*along}}
gravity: -g*j
"""
TWO_SPRINGS = """
parameters: [m, k, l]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
forces:
  left: {spring: k, between: [P, -l*i], length: l}
  right: {spring: k, between: [P, l*i], length: l}
"""


@cache
def linearized(text: str) -> Solution:
    return solved(text)


def verdict_on(text: str, stated: str) -> AnswerVerdict:
    """On frequencies that a file states: what they are compared with does not depend on them."""
    file = f"title: T\n{text}\nfind: linearization\nanswers: {{frequencies: {stated}}}\n"
    problem = read_problem(Source("problem.yaml", file))
    [answer] = compared_answers(replace(linearized(text), problem=problem))
    return answer


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (PENDULUM, "[sqrt(g/l)]", "equivalent"),
        (PENDULUM, "[-sqrt(g/l)]", "equivalent"),
        (PENDULUM, "[sqrt(l/g)]", "wrong"),
        (DOUBLE, "[sqrt(g/l1)]", "wrong"),
        (COUPLED, '[sqrt(g/l), "sqrt(g/l + 2*c/m)"]', "equivalent"),
        (COUPLED, '["sqrt(g/l + 2*c/m)"]', "incomplete"),
        (COUPLED, '["sqrt(g/l + 2*c/m)", "-sqrt(g/l + 2*c/m)"]', "incomplete"),
        (COUPLED, '[sqrt(g/l), "sqrt(g/l + c/m)"]', "undecided"),  # there are equilibria without a closed form
        (MOLECULE, '[0, sqrt(c/m), "sqrt(c/m*(1 + 2*m/M))"]', "equivalent"),
        (MOLECULE, '[sqrt(c/m), "sqrt(c/m*(1 + 2*m/M))"]', "equivalent"),
        (HOOP, '[["sqrt(g/R - Omega^2)"], ["sqrt(Omega^2 - g^2/(Omega^2*R^2))"]]', "equivalent"),
        (HOOP, '[["sqrt(g/R - Omega^2)"], ["sqrt(g/R + Omega^2)"]]', "wrong"),
        (DAMPED, '["sqrt(c/m - b^2/(4*m^2))"]', "equivalent"),
        (DAMPED, "[sqrt(c/m)]", "wrong"),
        (PASS, "[sqrt(c/m)]", "equivalent"),  # ω² = −f/m grows, and is no frequency
        (PASS, "[sqrt(f/m)]", "wrong"),
        (ACCELERATED, '["(g^2 + a^2)^(1/4)/sqrt(l)"]', "equivalent"),
        (ACCELERATED, '["sqrt(g/(l*cos(theta)))"]', "equivalent"),  # cos θ at the equilibrium
        (ACCELERATED, '["sqrt(sqrt(g^2 + a^2)/(2*l))"]', "wrong"),
        (ACCELERATED, '["sqrt(g/l)"]', "wrong"),
        (WINDING, '["sqrt(g/l)"]', "equivalent"),
        (WINDING, '["sqrt(g/(l + R*theta))"]', "equivalent"),
        (WINDING, '["sqrt(g/(l + R))"]', "undecided"),  # at θ = −l/R there are no linear equations
        (TWO_SPRINGS, '["2*sqrt(k/m)"]', "undecided"),
        (TWO_SPRINGS, '["sqrt(2*k/m)"]', "equivalent"),
    ],
)
def test_stated_frequencies(text: str, stated: str, verdict: str) -> None:
    answer = verdict_on(text, stated)
    assert answer.name == "frequencies"
    assert answer.verdict.value == verdict


@pytest.mark.parametrize(
    ("text", "stated", "said"),
    [
        (PENDULUM, "[sqrt(l/g)]", "these are the inverses of the frequencies"),
        (PENDULUM, '[sqrt(g/l), "2*sqrt(g/l)"]', "not right: 2*sqrt(g/l); these are twice the frequencies"),
        (
            PASS,
            '[sqrt(c/m), "sqrt(f/m)"]',
            "not right: sqrt(f/m); these are the frequencies for f with the opposite sign",
        ),
        (
            TWO_SPRINGS,
            '["2*sqrt(k/m)"]',
            "not right at any equilibrium with known linear equations, but not all equilibria have these; "
            "these are the frequencies for the spring `left` and the spring `right` twice as large, as from an energy "
            "without its 1/2",
        ),
        (
            DAMPED,
            "[sqrt(c/m)]",
            "not right: sqrt(c/m); these are the frequencies without damping",
        ),
    ],
)
def test_the_reason_is_given(text: str, stated: str, said: str) -> None:
    assert verdict_on(text, stated).diagnosis == said


def test_what_grows_explains_no_frequency() -> None:
    turning = """
parameters: [m, p, g, Omega]
coordinates: [r]
particles: {P: {mass: m, position: r*cos(Omega*t)*i + r*sin(Omega*t)*j + (r^4/p^3)*k}}
gravity: -g*k
"""  # ω² = −Ω² at r = 0, and 2 Ω²/(1 + p³ Ω⁶/(4 g³)) beside it
    assert verdict_on(turning, "[sqrt(2)*Omega]").diagnosis == ("in omega^2, this is the answer without p, as if p = 0")


def test_an_imaginary_frequency_cannot_be_stated() -> None:
    with pytest.raises(ProblemError, match="state the real frequencies only") as caught:
        solved(PASS, 'find: linearization\nanswers: {frequencies: [sqrt(c/m), "sqrt(-f/m)"]}')
    assert [d.code for d in caught.value.diagnostics] == ["not-real"]


CARTS = """
parameters: [m, k, b]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i}, Q: {mass: m, position: y*i}}
forces:
  springs: {potential: k*x^2/2 + k*(y - x)^2/2 + k*y^2/2}
  oil: {generalized: {x: "-b*(2*x' - y')", y: "-b*(2*y' - x')"}}
"""
BETWEEN = """
parameters: [m, k, b]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i}, Q: {mass: m, position: y*i}}
forces: {springs: {potential: k*x^2/2 + k*(y - x)^2/2 + k*y^2/2}, oil: {damper: b, between: [P, Q]}}
"""


@pytest.mark.parametrize(
    ("text", "stated", "verdict"),
    [
        (CARTS, "[b/(2*m), 3*b/(2*m)]", "equivalent"),
        (CARTS, "[b/(2*m)]", "incomplete"),
        (CARTS, "[b/m, 3*b/(2*m)]", "wrong"),
        (CARTS, "[b/(2*m), b/(2*m)]", "incomplete"),
        (DAMPED, "[b/(2*m)]", "equivalent"),
        (PENDULUM, "[g/l]", "undecided"),
        (BETWEEN, "[0, b/m]", "equivalent"),
        (BETWEEN, "[b/m]", "equivalent"),
        (BETWEEN, "[0]", "incomplete"),
        (CARTS, "[0, b/(2*m), 3*b/(2*m)]", "wrong"),
    ],
)
def test_decay_rates(text: str, stated: str, verdict: str) -> None:
    file = f"title: T\n{text}\nfind: linearization\nanswers: {{decay: {stated}}}\n"
    [answer] = compared_answers(replace(linearized(text), problem=read_problem(Source("problem.yaml", file))))
    assert answer.verdict.value == verdict


@pytest.mark.parametrize(
    ("stated", "verdict"), [("[0.124, 0.126]", "equivalent"), ("[0.124]", "incomplete"), ("[0.125, 0.126]", "wrong")]
)
def test_decay_rates_in_numbers(stated: str, verdict: str) -> None:
    """One damper, no proportional damping: p⁴ + p³/2 + 16 p² + 4 p + 48 = 0 (numpy: 0.12401 and 0.12599)."""
    text = CARTS.replace("[m, k, b]", "{m: {value: 1}, k: {value: 4}, b: {value: 0.5}}")
    file = f"title: T\n{text[: text.index('  oil')]}  oil: {{generalized: {{x: -b*x'}}}}\nfind: linearization\n"
    problem = read_problem(Source("problem.yaml", f"{file}answers: {{decay: {stated}}}\n"))
    [answer] = compared_answers(replace(solution_in_numbers(file), problem=problem))
    assert answer.verdict.value == verdict


@cache
def solution_in_numbers(file: str) -> Solution:
    return solve(read_problem(Source("problem.yaml", file)))
