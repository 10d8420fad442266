"""Signs of minors by intervals: against those found in closed form, and at equilibria that are not solved."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Source
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.numerical_definiteness import is_definite
from lagrange.mechanics.equilibrium.stability import SecondVariation, StabilityVerdict, second_variation
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

PLANE = """
title: A particle in the plane
coordinates: [x, y]
particles: {{P: {{mass: 1, position: "[x, y]"}}}}
forces: {{field: {{potential: "{}"}}}}
find: equilibrium
"""
BAR = """
title: A bar with a torsion spring and a spring at its top
parameters: [k, l, P, c]
coordinates: [theta]
particles: {Q: {position: "l*sin(theta)*i + l*cos(theta)*j"}}
forces:
  side: {potential: k*(l*sin(theta))^2/2}
  torsion: {potential: c*theta^2/2}
  load: {on: Q, vector: -P*j}
find: equilibrium
"""


def solved(text: str) -> tuple[Equilibrium, SecondVariation]:
    [view] = solve(read_problem(Source("problem.yaml", text))).views
    assert view.equilibrium is not None
    variation = second_variation(view.equilibrium)
    assert variation is not None
    return view.equilibrium, variation


@pytest.mark.parametrize(
    "potential", ["x^4/4 - 2*x^2 + x*y + y^2", "(x^3/3 - 3*x)*(y^2 + 1)", "x^3/3 - 5*x + x*y + y^2 - y/3"]
)
def test_intervals_agree_with_closed_forms(potential: str) -> None:
    e, variation = solved(PLANE.format(potential))
    for b, s in zip(e.branches, variation.verdicts, strict=True):
        assert {is_definite(variation.matrix, e, p) for p in b.points} == {s.verdict is StabilityVerdict.STABLE}


def test_a_zero_is_not_decided() -> None:
    e, variation = solved(PLANE.format("x^2*y^2 + x^2"))
    [p] = e.branches[0].points
    assert is_definite(variation.matrix, e, p) is None


def test_at_an_equation_that_is_not_solved_the_sign_of_the_second_derivative_decides() -> None:
    e, variation = solved(BAR)
    at_zero, beside = variation.verdicts
    theta = e.configuration.slots.coordinates[0]
    assert [(str(c.lhs), c.relation) for c in at_zero.conditions] == [("P", "<")]
    assert e.branches[1].left
    assert [c.relation for c in e.branches[1].conditions] == ["≠"]
    assert (beside.verdict, beside.minors) == (StabilityVerdict.CONDITIONAL, (variation.matrix[0][0],))
    assert theta in beside.conditions[0].lhs.free_symbols
