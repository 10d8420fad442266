"""Belts on rough drums, against the tension integrated along the arc, and a linear program."""

from __future__ import annotations

import random
from collections.abc import Callable
from math import cos, exp, isclose, log, pi, sin

import pytest
import sympy as sp

from lagrange.answers.questions.own_answers import compared_answers
from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.explain.report import report
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from lagrange.render import json as in_json
from lagrange.render import terminal
from tests.support.shared import solved

Read = Callable[[str], Problem]

CAPSTAN = """title: Weight held over a rough drum
parameters: [m, g, mu, beta]
unknowns: [T, P]
coordinates: [y]
particles: {load: {mass: m, position: -y*j}}
gravity: -g*j
forces:
  rope: {on: load, vector: T*j}
  drum: {belt: mu, angle: beta, tight: T, slack: P}
find: [equilibrium, impending]
"""
GIVEN = CAPSTAN.replace("[m, g, mu, beta]", "[m, g, P, mu, beta]").replace("[T, P]", "[T]")
STRING = """title: Weight on a string that passes over a rough drum
parameters: [W, P, L, mu, beta]
coordinates: [y]
particles: {load: {position: -y*j}}
constraints: {rope: {equation: y <= L, reaction: T}}
forces:
  weight: {on: load, vector: -W*j}
  drum: {belt: mu, angle: beta, tight: T, slack: P}
find: [equilibrium, impending]
"""


def along_the_arc(slack: float, mu: float, beta: float, steps: int = 2000) -> float:
    """The tension at the other end of a belt that is about to slip everywhere: each piece, of angle dφ, is pressed by
    N = (T + T') sin(dφ/2) and held by (T' − T) cos(dφ/2) = μ N."""
    half = beta / steps / 2
    tension = slack
    for _ in range(steps):
        tension *= (cos(half) + mu * sin(half)) / (cos(half) - mu * sin(half))
    return tension


def at(e: sp.Expr, values: dict[str, float]) -> float:
    return float(e.xreplace({s: sp.Float(values[s.name]) for s in e.free_symbols}))


def test_the_band_brake_at_its_limit() -> None:
    [motion] = solved("band-brake").own.impending or ()
    values = {"M": 30.0, "r": 0.2, "a": 0.05, "l": 0.5, "mu": 0.3, "beta": 4.0}
    found = {r.lhs.name: at(r.rhs, values) for r in motion.equilibrium.branches[0].relations}
    assert isclose(found["T_1"], along_the_arc(found["T_2"], 0.3, 4.0), rel_tol=1e-6)
    assert isclose((found["T_1"] - found["T_2"]) * 0.2, 30)
    assert isclose(found["P"] * 0.5, found["T_2"] * 0.05)
    [[condition]] = solved("band-brake").own.at_rest.cases  # type: ignore[union-attr]
    assert condition.right.name == "P"
    assert isclose(at(condition.left, values), found["P"])


def test_the_hawser() -> None:
    """Beer and Johnston: μ = 0.311; with three turns the longshoreman resists 52.7 kN."""
    [[condition]] = solved("hawser-on-a-bollard").own.at_rest.cases  # type: ignore[union-attr]
    for mu, turns, pull, holds in ((0.312, 2, 7500, True), (0.310, 2, 7500, False), (0.311, 3, 52800, False), (0.311, 3, 52700, True)):  # fmt: skip
        values = {"S": pull, "P": 150.0, "beta": 2 * pi * turns, "mu": mu}
        assert (at(condition.right - condition.left, values) >= 0) is holds
    assert isclose(along_the_arc(150, 0.311, 6 * pi), 52700, rel_tol=1e-3)
    assert isclose(log(7500 / 150) / (4 * pi), 0.311, abs_tol=5e-4)


def test_a_block_held_over_a_drum_is_a_linear_program() -> None:
    linprog = pytest.importorskip("scipy.optimize").linprog
    rest = solved("block-held-over-a-drum").own.at_rest
    assert rest is not None
    draw, seen = random.Random(3), set()
    for _ in range(150):
        v = {n: draw.lognormvariate(0, 0.7) for n in ("W", "Q", "mu", "nu", "beta")} | {
            "alpha": draw.uniform(0.05, 1.5)
        }
        grown = exp(v["nu"] * v["beta"])
        weight = v["W"] * sin(v["alpha"]), v["mu"] * v["W"] * cos(v["alpha"])
        # T + F = W sin α with |F| ≤ μ N and Q/e ≤ T ≤ Q e
        found = linprog([0, 0], A_eq=[[1, 1]], b_eq=[weight[0]],
                        bounds=[(v["Q"] / grown, v["Q"] * grown), (-weight[1], weight[1])])  # fmt: skip
        claim = any(all(at(c.right - c.left, v) >= 0 for c in case) for case in rest.cases)
        assert claim is (found.status == 0), v
        seen.add(claim)
    assert seen == {True, False}


@pytest.mark.parametrize(
    ("text", "answers", "verdicts"),
    [
        (
            CAPSTAN,
            "{rest: ['P >= m*g*exp(-mu*beta)'], equilibrium: ['P = m*g*exp(-mu*beta)', 'T = m*g']}",
            "equivalent",
        ),
        (GIVEN, "{rest: ['mu >= log(m*g/P)/beta'], equilibrium: ['mu = log(m*g/P)/beta']}", "equivalent"),
        (GIVEN, "{rest: ['mu >= log(P/(m*g))/beta'], equilibrium: ['mu = log(P/(m*g))/beta']}", "wrong"),
        (CAPSTAN, "{rest: ['P <= m*g*exp(mu*beta)'], equilibrium: ['P = m*g*exp(mu*beta)', 'T = m*g']}", "wrong"),
        (STRING, "{rest: ['W <= P*exp(mu*beta)'], equilibrium: ['W = P*exp(mu*beta)', 'y = L']}", "equivalent"),
        (STRING, "{rest: ['mu >= log(W/P)/beta'], equilibrium: ['mu = log(W/P)/beta', 'y = L']}", "equivalent"),
    ],
)
def test_answers(problem: Read, text: str, answers: str, verdicts: str) -> None:
    """The tension is an unknown force, or the reaction of a string."""
    solution = solve(problem(f"{text}answers: {answers}\n"))
    assert [c.name for c in solution.checks if c.passed is not True] == []
    assert {a.name: a.verdict.value for a in compared_answers(solution)} == {"rest": verdicts, "equilibrium": verdicts}


def test_a_coefficient_among_the_unknowns(problem: Read) -> None:
    text = GIVEN.replace("[m, g, P, mu, beta]", "[m, g, P, beta]").replace("[T]", "[T, mu]")
    written = in_json.as_object(report(problem(text)))
    assert written["rest"]["conditions"] == ["log(m*g/P)/beta <= mu"]
    [motion] = written["impending"]
    assert "mu = log(m*g/P)/beta" in motion["equilibrium"][0]


def test_what_is_written(problem: Read) -> None:
    explained = report(problem(CAPSTAN))
    assert in_json.as_object(explained)["rest"]["conditions"] == ["m*g*exp(-mu*beta) <= P"]
    page = " ".join(terminal.text(explained.derivation, explained.notation, 100).split())
    assert "It does not slip towards its tight side as long as T ≤ P e^(μ β)" in page
    assert "Then the tensions of the drum satisfy T = P e^(μ β)" in page


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        (", slack: P", "", "missing-key"),
        ("tight: T", "tight: Z", "unknown-symbol"),
        ("belt: mu", "belt: y", "coordinate-here"),
        ("belt: mu", "belt: t", "time-here"),
    ],
)
def test_what_is_refused(problem: Read, old: str, new: str, code: str) -> None:
    with pytest.raises(ProblemError) as caught:
        problem(CAPSTAN.replace(old, new))
    found = caught.value.diagnostics[0]
    assert found.span is not None
    assert found.code == code or code.endswith("here")


def test_a_belt_is_at_rest(problem: Read) -> None:
    with pytest.raises(NotCoveredError, match="a belt on a rough drum, `drum`, in motion"):
        solve(problem(CAPSTAN.replace("[equilibrium, impending]", "motion")))


BALANCED = """title: A block on a rough slope, held over a rough drum by a weight
parameters: {M: positive, m: positive, g: positive, alpha: acute, mu: positive, nu: positive, beta: positive}
unknowns: [T, S]
coordinates: [x, y, z]
particles: {block: {mass: M, position: x*i + y*j}, load: {mass: m, position: z*j}}
constraints: {slope: {equation: y >= x*tan(alpha), reaction: N}}
gravity: -g*j
forces:
  up: {on: block, vector: T*cos(alpha)*i + T*sin(alpha)*j}
  hang: {on: load, vector: S*j}
  rub: {friction: mu, static: mu, constraint: slope, on: block}
  down: {belt: nu, angle: beta, tight: T, slack: S}
  back: {belt: nu, angle: beta, tight: S, slack: T}
find: equilibrium
"""


def test_tensions_between_two_loads_are_eliminated(problem: Read) -> None:
    rest = solve(problem(BALANCED)).own.at_rest
    assert rest is not None
    [case] = rest.cases
    slope, held = (0.5, cos(pi / 6)), exp(0.2 * 2 * pi / 3)
    least, most = 50 * (slope[0] - 0.25 * slope[1]) / held, 50 * (slope[0] + 0.25 * slope[1]) * held
    for m, at_rest in ((least - 0.01, False), (least + 0.01, True), (most - 0.01, True), (most + 0.01, False)):
        values = {"M": 50.0, "m": m, "g": 9.81, "alpha": pi / 6, "mu": 0.25, "nu": 0.2, "beta": 2 * pi / 3}
        assert all(at(c.right - c.left, values) >= 0 for c in case) is at_rest
