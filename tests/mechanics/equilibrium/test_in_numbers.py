"""Conditions in numbers.

Critical values of the one parameter without a value.
"""

from __future__ import annotations

import pytest
import sympy as sp

import lagrange
from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.diagnostics import Source
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.in_numbers import REVERSED, condition_holds
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from lagrange.render.json import as_object

a, b = sp.symbols("a b", positive=True)


@pytest.mark.parametrize(
    ("left", "relation", "right", "expected"),
    [(a, ">", 2 * a, False), (a, "<", 2 * a, True), (a, "≥", b, None), (2 * a, "≠", a, True)],
)
def test_a_condition_with_values(left: sp.Expr, relation: str, right: sp.Expr, expected: bool | None) -> None:
    assert (
        condition_holds(SignCondition(left, relation, right), lambda e: e.xreplace({a: sp.Float("1.5", 80)}))
        is expected
    )


def test_a_frequency_of_zero_leaves_the_verdict_to_the_energy() -> None:
    """θ²/2 + cos θ is of the fourth order: stable by V, and the linear equations decide nothing."""
    text = """title: Critical
parameters: [m, g, l]
coordinates: [theta]
particles: {P: {mass: m, position: "l*sin(theta)*i + l*cos(theta)*j"}}
gravity: -g*j
forces: {s: {potential: "m*g*l*theta^2/2"}}
find: [equilibrium, linearization]
"""
    view = solve(read_problem(Source("p", text))).own
    assert view.linearization is not None
    assert view.linearization.at[0] is not None
    assert view.linearization.at[0].judgement.stability.verdict is StabilityVerdict.UNDECIDED
    assert view.in_numbers is not None
    assert view.in_numbers.positions[0].stability is StabilityVerdict.STABLE


# Critical values


COLUMN = """
title: Bar on a spring
parameters: {l: 2 m, c: 30 N m, P: {unit: N}}
coordinates: {theta: {unit: rad}}
particles: {top: {position: l*sin(theta)*i + l*cos(theta)*j}}
forces: {load: {on: top, vector: -P*j}, spring: {potential: c*theta^2/2}}
find: equilibrium
"""


def test_the_critical_load() -> None:
    said = str(as_object(report(lagrange.loads(COLUMN))))
    assert "'critical'" in said
    assert "15" in said  # P = c/l
    assert solve(lagrange.loads(COLUMN), complete=False).holds


def test_reversing_twice_changes_nothing() -> None:
    assert all(REVERSED[REVERSED[r]] == r for r in REVERSED)


@pytest.mark.parametrize(("load", "absent"), [("50", (1,)), ("120", ())])
def test_a_search_without_roots_excludes_what_is_not_solved(load: str, absent: tuple[int, ...]) -> None:
    """W sin θ = k R θ with k R = 80 N has a root between 0 and π only for W > k R."""
    text = """title: Wound spring
parameters: {W: {value: LOAD, unit: N}, R: {value: 0.2, unit: m}, k: {value: 400, unit: N/m}}
coordinates: {theta: {range: [0, pi]}}
particles: {A: {position: "R*sin(theta)*i + R*cos(theta)*j"}}
forces: {load: {on: A, vector: -W*j}, spring: {potential: "k*(R*theta)^2/2"}}
find: equilibrium
""".replace("LOAD", load)
    numbers = solve(read_problem(Source("p", text))).own.in_numbers
    assert numbers is not None
    assert numbers.absent == absent
    assert len(numbers.positions) == 2 - len(absent)
