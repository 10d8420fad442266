"""Answers to questions satisfy their equations, by another route."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem
from tests.support.shared import solved


@pytest.mark.parametrize("name", ["leaving-a-sphere", "thrown-stone", "released-pendulum"])
def test_there_is_a_check_and_it_holds(name: str) -> None:
    solution = solved(name)
    found = [c for c in solution.checks if any(a.question.name in c.name or "answer" in c.name for a in solution.asked)]
    assert found
    assert all(c.passed for c in found)


SLOWED = """title: Block on a rough table with a spring
parameters: {m: {value: 1 kg}, k: {value: 100 N/m}, mu: {value: 0.2}, g: {value: 9.81 m/s^2}, A: {value: 10 cm}}
gravity: -g*j
coordinates: [x, y]
particles: {block: {mass: m, position: x*i + y*j}}
constraints: {table: {equation: y >= 0, reaction: N}}
forces:
  spring: {on: block, vector: -k*x*i}
  rub: {friction: mu, constraint: table, on: block}
initial: {x: A, x': 0}
ask: {fastest: {quantity: "x'", when: "x'' = 0"}}
"""


def test_numbers_with_which_the_slip_has_the_other_sense_tell_nothing() -> None:
    """x' = −(k A − μ m g)/√(k m) holds while the block goes back: for k A < μ m g it is no state of this motion."""
    solution = solve(read_problem(Source("slowed", SLOWED)))
    [second] = [c for c in solution.checks if "from Lagrange's equations in numbers" in c.name]
    assert second.passed
    [branch] = solution.asked[0].branches
    values = {"m": 1, "k": 100, "mu": 0.2, "g": 9.81, "A": 0.1}
    assert float(branch.rhs.xreplace({s: values[s.name] for s in branch.rhs.free_symbols})) == pytest.approx(-0.8038)
