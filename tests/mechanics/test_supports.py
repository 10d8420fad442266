"""The forces at two smooth supports of a rod: they balance its weight, in force and in moment, as statics by hand has it."""

from __future__ import annotations

import math
from functools import cache

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.mechanics.supports import supports
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.support.shared import file_of, solved

BY_ITS_ENDS = """
title: Rod on two planes of different inclination
axes: {i: right, j: up}
parameters:
  W: {assume: positive, meaning: weight of the rod}
  l: {assume: positive, meaning: length of the rod}
  alpha: {assume: acute, meaning: inclination on the left}
  beta: {assume: acute, meaning: inclination on the right}
coordinates:
  s: distance of A from the origin
  u: distance of B from the origin
  theta: {meaning: inclination of the rod, range: [-90 deg, 90 deg]}
particles:
  A: {position: -s*cos(alpha)*i + s*sin(alpha)*j}
  B: {position: u*cos(beta)*i + u*sin(beta)*j}
constraints:
  across: s*cos(alpha) + u*cos(beta) = l*cos(theta)
  upward: u*sin(beta) - s*sin(alpha) = l*sin(theta)
forces:
  half_at_A: {on: A, vector: -W/2*j}
  half_at_B: {on: B, vector: -W/2*j}
generalized_coordinates:
  inclination:
    coordinates: [theta]
    substitute: {s: l*sin(beta - theta)/sin(alpha + beta), u: l*sin(alpha + theta)/sin(alpha + beta)}
"""

NUMBERS = {"alpha": 0.7, "beta": 0.4, "l": 2.0, "W": 3.0, "k": 0.6}


@cache
def rod(name: str) -> Solution:
    """A shipped problem, or the rod with its ends as particles."""
    if name == "by-its-ends":
        return solve(read_problem(Source("rod.yaml", BY_ITS_ENDS)))
    return solved(name, complete=False)


def at_rest(name: str) -> dict[str, float]:
    """The numbers with the inclination, found by hand: the lines of both normals meet above the mass centre."""
    a = NUMBERS["alpha"]
    b, k = (a, NUMBERS["k"]) if name.startswith("ex16") else (NUMBERS["beta"], 0.5)
    # With A at the origin the normals meet at l (cos θ, sin θ) − s (sin b, cos b)... = r (sin a, cos a); x = k l cos θ.
    # r sin a = k l cos θ and r cos a − l sin θ = (l cos θ − r sin a)/tan b.
    theta = math.atan(k / math.tan(a) - (1 - k) / math.tan(b))
    return {**NUMBERS, "beta": b, "k": k, "theta": theta}


def values(name: str) -> dict[str, float]:
    found = supports(rod(name))
    assert found is not None
    numbers = {sp.Symbol(n): v for n, v in at_rest(name).items()}

    def number(e: sp.Expr) -> float:
        return float(e.subs({s: numbers[sp.Symbol(s.name)] for s in e.free_symbols}))

    return {s.point: number(s.size) for s in found.at}


@pytest.mark.parametrize("name", ["ex16-rod-on-two-planes", "by-its-ends"])
def test_forces_and_moments_balance(name: str) -> None:
    size, n = values(name), at_rest(name)
    a, b, theta = n["alpha"], n["beta"], n["theta"]
    right = size["A"] * math.sin(a) - size["B"] * math.sin(b)
    up = size["A"] * math.cos(a) + size["B"] * math.cos(b) - n["W"]
    along = n["l"] * math.cos(theta), n["l"] * math.sin(theta)
    turn = along[0] * size["B"] * math.cos(b) + along[1] * size["B"] * math.sin(b) - n["k"] * along[0] * n["W"]
    assert [right, up, turn] == pytest.approx([0, 0, 0], abs=1e-12)


def test_on_equal_planes_each_carries_the_same() -> None:
    assert values("ex16-rod-on-two-planes")["A"] == pytest.approx(NUMBERS["W"] / (2 * math.cos(NUMBERS["alpha"])))


@pytest.mark.parametrize("name", ["ladder", "rod-over-peg", "ex11-ideal-pendulum"])
def test_of_other_systems_nothing_is_said(name: str) -> None:
    assert supports(rod(name)) is None


@pytest.mark.parametrize("name", ["ex16-rod-on-two-planes", "by-its-ends"])
def test_the_rod_is_unstable_and_the_second_derivative_is_that_of_its_height(name: str) -> None:
    """V'' by finite differences of W times the height of the mass centre, against the closed form."""
    n = at_rest(name)
    a, b, l, k = n["alpha"], n["beta"], n["l"], n["k"]

    def energy(theta: float) -> float:
        return n["W"] * (l * math.sin(b - theta) / math.sin(a + b) * math.sin(a) + k * l * math.sin(theta))

    step = 1e-4
    second = (energy(n["theta"] + step) - 2 * energy(n["theta"]) + energy(n["theta"] - step)) / step**2
    stability = rod(name).choices[0].stability
    assert stability is not None
    [verdict] = stability.verdicts
    assert verdict.verdict is StabilityVerdict.UNSTABLE
    assert not verdict.presupposed
    [closed] = verdict.minors
    assert float(closed.subs({s: n[s.name] for s in closed.free_symbols})) == pytest.approx(second, rel=1e-5)


@pytest.mark.parametrize(("assumed", "stated"), [("acute", True), ("positive", False)])
def test_the_tangent_of_a_bound_grows_only_where_it_is_acute(assumed: str, stated: bool) -> None:
    """−tan² α ≤ 2k − 1 ≤ tan² α says −α ≤ θ ≤ α for α < π/2 alone."""
    text = file_of("ex16-rod-on-two-planes").read_text(encoding="utf-8").replace("assume: acute", f"assume: {assumed}")
    found = report(read_problem(Source("x.yaml", text)), complete=False)
    page = " ".join(terminal.text(found.derivation, found.notation, 200).split())
    assert ("such a position exists if |2k − 1| ≤ tan²α" in page) is stated
