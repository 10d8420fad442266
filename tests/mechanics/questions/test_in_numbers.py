"""Branches that the values of a problem exclude."""

from __future__ import annotations

from dataclasses import replace

import lagrange
from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.mechanics.questions.in_numbers import branches_with
from lagrange.mechanics.solution import solve
from lagrange.mechanics.solution_values import values_in

STONE = """
title: Stone
parameters: {m: 2 kg, g: 9.81 m/s^2, v: 3 m/s, h: {unit: m}}
coordinates: {y: {unit: m}}
particles: {P: {mass: m, position: y*j}}
gravity: -g*j
initial: {y: 0, y': v}
ask: {top: {quantity: y, when: y' = 0}}
"""


def test_a_condition_that_the_values_violate_excludes_its_branch_and_an_open_one_does_not() -> None:
    solution = solve(lagrange.loads(STONE), complete=False)
    [asked], values = solution.asked, values_in(solution)
    assert values is not None
    [branch] = asked.branches
    m, g, v, h = (p.symbol for p in solution.problem.parameters)
    conditions = [SignCondition(v, ">", 2 * v), SignCondition(g, ">", m), SignCondition(h, ">", m)]
    branches = tuple(replace(branch, conditions=(c,)) for c in conditions)
    assert branches_with(replace(asked, branches=branches), values) == branches[1:]
