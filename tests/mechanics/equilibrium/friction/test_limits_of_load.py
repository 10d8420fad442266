"""Limits of one force between several rough contacts, against the bounds themselves in numbers."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
import sympy as sp

from lagrange.mechanics.equilibrium.friction.limits_of_load import limits_of_load
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Inequality, Signs
from tests.mechanics.equilibrium.friction.test_friction_at_rest import Read, solved

WEDGE = """title: Block on a wedge
parameters: {PARAMETERS}
unknowns: [P]
coordinates: [x, y, u, v]
particles: {block: {position: x*i + y*j}, wedge: {position: u*i + v*j}}
constraints:
  wall: {equation: x <= 0, reaction: N_1}
  face: {equation: "(y - v)*cos(delta) >= (u - x)*sin(delta)", reaction: N_2}
  floor: {equation: v >= 0, reaction: N_3}
forces:
  weight: {on: block, vector: -W*j}
  push: {on: wedge, vector: P*i}
  f1: {friction: mu, static: mu, constraint: wall, on: block}
  f2: {friction: mu, static: mu, constraint: face, on: block}
  f3: {friction: mu, static: mu, constraint: floor, on: wedge}
find: equilibrium
"""


def extremes(w: float, delta: float, mu: float) -> tuple[float, float]:
    """The least and the greatest P, over all vertices of what is admissible: forces f_k and n_k as cones."""
    s, c = np.sin(delta), np.cos(delta)
    edges = [[(-1, mu), (-1, -mu)], [(s + mu * c, c - mu * s), (s - mu * c, c + mu * s)], [(mu, 1), (-mu, 1)]]
    found = []
    # wall and face hold the block; minus face, floor and P hold the wedge: weights >= 0 of six edges, and P
    columns = [[*e, 0, 0] for e in edges[0]] + [[*e, -e[0], -e[1]] for e in edges[1]] + [[0, 0, *e] for e in edges[2]]
    matrix = np.array([*columns, [0, 0, 1, 0]]).T
    for chosen in combinations(range(6), 3):
        part = matrix[:, [*chosen, 6]]
        if abs(np.linalg.det(part)) > 1e-12:
            *weights, p = np.linalg.solve(part, [0, w, 0, 0])
            if min(weights) > -1e-9:
                found.append(p)
    return min(found), max(found)


@pytest.mark.parametrize(("delta", "mu"), [("8 deg", 0.35)])
def test_a_wedge_with_three_rough_contacts(delta: str, mu: float, problem: Read) -> None:
    text = WEDGE.replace("PARAMETERS", f"W: 400 N, delta: {delta}, mu: {mu}")
    [rest] = [v.at_rest for v in solved(problem, text).views if v.at_rest is not None]
    numbers = {p.symbol: p.value for p in problem(text).parameters}
    least, greatest = extremes(400, float(sp.rad(int(delta.split()[0]))), mu)
    [case] = rest.cases
    p = sp.Symbol("P", real=True)
    limits = sorted(float(sp.solve((c.right - c.left).xreplace(numbers), p)[0]) for c in case)
    assert np.allclose(limits, [least, greatest])
    assert all((c.right - c.left).xreplace(numbers) > 0 for c in rest.where)


def test_each_case_has_the_sign_that_decides_which_bound_limits() -> None:
    """s >= 0, a - s >= 0, P + (a - b) s >= 0 and P <= 2: P >= 0 or P >= (b - a) a."""
    a, b, p = sp.Symbol("a", positive=True), sp.Symbol("b", positive=True), sp.Symbol("P", real=True)
    bounds = [
        Inequality((sp.S.One,), sp.S.Zero),
        Inequality((-sp.S.One,), a),
        Inequality((a - b,), p),
        Inequality((sp.S.Zero,), 2 - p),
    ]
    for case in limits_of_load(bounds, p, [], {}, Signs()):
        for x, y in ((1.0, 0.5), (0.5, 1.0)):
            at = {a: x, b: y}
            if all(e.xreplace(at) > 0 for e in case.where):
                least = max(float(-s.xreplace({**at, p: 0})) for s in case.slacks if s.diff(p).xreplace(at) > 0)
                # with s free to choose, P is only held by P + max (a - b) s >= 0
                assert abs(least - min(0.0, -(x - y) * x)) < 1e-9
