"""Reactions at equilibria found numerically, against forces by hand."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.mechanics.equilibrium.searched.reactions_found import reactions_found
from lagrange.mechanics.results import values_in
from lagrange.mechanics.solution import solve
from lagrange.problem.loader import read_problem

# Two weights of 100 N on three cords of 1 m between points 2 m apart: the outer cords at 60° have 100/sin 60° newtons,
# the middle one 100/tan 60°.
CORDS = """
title: Two weights on a cord
parameters: {W: 100 N, l: 1 m, d: 2 m}
coordinates: [x_1, y_1, x_2, y_2]
particles:
  A: {mass: 0, position: x_1*i + y_1*j}
  B: {mass: 0, position: x_2*i + y_2*j}
constraints:
  left: {equation: norm(r_A) = l, by: string, reaction: T_1}
  middle: {equation: norm(r_B - r_A) = l, by: string, reaction: T_2}
  right: {equation: norm(r_B - d*i) = l, by: string, reaction: T_3}
forces: {w1: {on: A, vector: -W*j}, w2: {on: B, vector: -W*j}}
find: equilibrium
"""


def test_tensions_of_three_cords() -> None:
    problem = read_problem(Source("cords.yaml", CORDS))
    solution = solve(problem)
    own, values = solution.own, values_in(solution)
    assert values is not None
    assert own.in_numbers is not None
    assert own.equilibrium is not None
    assert solution.law is not None
    [hanging] = [p for p in own.in_numbers.positions if p.coordinates[sp.Symbol("y_1", real=True)].formula < 0]
    forces = reactions_found(hanging.coordinates, own.configuration, own.equilibrium, solution.law.newton, values)
    outer, middle = 100 / (3**0.5 / 2), 100 / 3**0.5
    sizes = {str(name): (float(q.formula), q.unit) for name, q in forces.items()}
    assert {name: unit for name, (_, unit) in sizes.items()} == dict.fromkeys(("T_1", "T_2", "T_3"), "N")
    assert [sizes[n][0] for n in ("T_1", "T_2", "T_3")] == pytest.approx([outer, middle, outer])
    elsewhere = {q: x if str(q) != "x_1" else hanging.coordinates[sp.Symbol("x_2", real=True)]
                 for q, x in hanging.coordinates.items()}  # fmt: skip
    assert not reactions_found(elsewhere, own.configuration, own.equilibrium, solution.law.newton, values)


RING = """
title: Ring on a rope
parameters: {W: 600 N, L: 15 m, d: 12 m, h: 3 m}
coordinates: {x: {range: [0, 12]}, y: {range: [-10, 10]}}
particles: {ring: {position: x*i + y*j}}
constraints: {rope: {equation: norm(r_ring) + norm(r_ring - d*i - h*j) <= L, reaction: T}}
forces: {load: {on: ring, vector: W*j}}
find: equilibrium
"""


def test_a_rope_that_would_have_to_push_has_no_equilibrium() -> None:
    """2 T cos a = W with sin a = d/L; above the supports the same angles would need T = -500 N."""
    solution = solve(read_problem(Source("ring.yaml", RING)))
    numbers = solution.own.in_numbers
    assert numbers is not None
    [hanging], [above] = numbers.positions, numbers.slack
    places = [[float(x.formula) for x in p.coordinates.values()] for p in (hanging, above)]
    assert places == [pytest.approx([8, 6]), pytest.approx([4, -3])]
    [tension], [thrust] = ([float(x.formula) for x in p.forces.values()] for p in (hanging, above))
    assert (tension, thrust) == (pytest.approx(500), pytest.approx(-500))
