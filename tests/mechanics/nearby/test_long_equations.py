"""Equations in abbreviations.

Reactions that are too long in letters: in terms of accelerations, and in numbers, against Newton's law by hand.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.explain.reactions import explain_reactions
from lagrange.mechanics.large_systems import with_long_reactions
from lagrange.mechanics.nearby.long_equations import LongReactions, check_long_equations, long_equations
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.render.json_momenta import beside_motion
from tests.mechanics.nearby.test_linear_motion import bicycle
from tests.support.problem_texts import read


def test_the_equations_of_the_bicycle_in_abbreviations() -> None:
    problem, configuration, _ = bicycle()
    found = long_equations(problem, configuration)
    [check] = check_long_equations(found, configuration)
    assert check.passed
    wrong = replace(found, whole=(*found.whole[:-1], found.whole[-1] + problem.slots.accelerations[0]))
    assert not check_long_equations(wrong, configuration)[0].passed
    z = next(iter(found.definitions))
    # Written out again, an equation is what it was before, whatever the abbreviations are.
    whole = found.left[-2]
    for name, e in reversed(found.definitions.items()):
        whole = whole.xreplace({name: e})
    assert z.name == "Z_1"
    assert is_zero(whole - found.whole[-2]) is True


# Long reactions


ARM = """title: Three rods hinged one to the next
parameters: {m: {value: 1}, l: {value: 1}, g: {value: 9.81}}
coordinates: [x1, y1, a1, x2, y2, a2, x3, y3, a3]
bodies:
  one: {mass: m, inertia: m*l^2/12, position: x1*i + y1*j, angle: a1}
  two: {mass: m, inertia: m*l^2/12, position: x2*i + y2*j, angle: a2}
  three: {mass: m, inertia: m*l^2/12, position: x3*i + y3*j, angle: a3}
constraints:
  A: {equation: "r_one - l/2*e1_one = 0*i", by: hinge}
  B: {equation: "r_one + l/2*e1_one = r_two - l/2*e1_two", by: hinge}
  C: {equation: "r_two + l/2*e1_two = r_three - l/2*e1_three", by: hinge}
gravity: -g*j
generalized_coordinates: {angles: {coordinates: [a1, a2, a3]}}
"""
START = "initial: {a1: 0.5, a2: 0.2, a3: -1, a1': 3, a2': 1, a3': 0}\n"


@cache
def arm() -> Solution:
    """Solved without its initial state, from which the motion would be sought; then with it."""
    solution = solve(read(ARM), complete=False)
    started = replace(solution.law.problem, initial=read(ARM + START).initial)
    return with_long_reactions(replace(solution, law=replace(solution.law, problem=started)))


def test_the_reactions_of_an_arm_by_accelerations() -> None:
    """From the free end inwards: each hinge carries m (r'' − g) of the rods beyond it."""
    found = arm().long_reactions
    assert isinstance(found, LongReactions)
    m, g = (sp.Symbol(s, positive=True) for s in "mg")
    x, y = ([sp.Symbol(f"{s}{n}''", real=True) for n in (1, 2, 3)] for s in "xy")
    beyond = {"A": 0, "B": 1, "C": 2}
    for name, first in beyond.items():
        sign = 1 if name == "A" else -1
        for part, forces in ((1, x), (2, [a + g for a in y])):
            expected = sign * m * sum(forces[first:])
            assert sp.expand(found.by_accelerations[f"{name}.{part}"] - expected) == 0


def test_the_numbers_at_the_start_are_those_of_newtons_law() -> None:
    """M(a) a'' = f by hand for the angles, then the force in the last hinge is m (r_3'' − g)."""
    a, w = np.array([0.5, 0.2, -1.0]), np.array([3.0, 1.0, 0.0])
    share = np.array([[0.5, 0, 0], [1, 0.5, 0], [1, 1, 0.5]])  # r_n = Σ share_nk e(a_k)
    along, across = np.array([np.cos(a), np.sin(a)]), np.array([-np.sin(a), np.cos(a)])
    jacobian = np.array([share[n] * across for n in range(3)])  # (3, 2, 3)
    drift = np.array([-(along * w**2) @ share[n] for n in range(3)])
    mass = sum(j.T @ j for j in jacobian) + np.eye(3) / 12
    weight = np.array([0, -9.81])
    angular = np.linalg.solve(mass, sum(j.T @ (weight - d) for j, d in zip(jacobian, drift, strict=True)))
    force = jacobian[2] @ angular + drift[2] - weight
    found = arm().long_reactions
    assert found.from_initial
    assert [float(found.numbers[f"C.{n}"]) for n in (1, 2)] == pytest.approx(-force)
    assert arm().holds


def test_they_are_on_the_page_and_in_json() -> None:
    own, chosen = (v.dynamics for v in arm().views)
    step = explain_reactions(chosen, arm().law.newton, "angles", lost_ones=arm().long_reactions)
    assert own.reactions is None
    assert "At the start" in str(step.body)
    found = beside_motion(arm(), str)["long_reactions"]
    assert found["by_accelerations"]["C.1"] == "-m*x3''"
    assert found["numbers"]["C.1"] == pytest.approx(1.493403, rel=1e-6)


def test_short_reactions_are_not_given_twice() -> None:
    text = """title: t
parameters: [m, g, l]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = l^2}
gravity: -g*j
"""
    assert solve(read(text)).long_reactions is None


def test_a_chain_of_tensions_with_names() -> None:
    """Coefficients that are no constants: m x_4'' = T_4 (x_3 − x_4)/l, and so on."""
    coordinates = ", ".join(f"{s}{n}" for n in range(1, 5) for s in "xy")
    particles = ", ".join(f"P{n}: {{mass: m, position: x{n}*i + y{n}*j}}" for n in range(1, 5))
    rods = "".join(
        f'  r{n}: {{equation: "(x{n}-x{n - 1})^2 + (y{n}-y{n - 1})^2 = l^2", reaction: T{n}}}\n' for n in (2, 3, 4)
    )
    solution = solve(
        read(
            f"title: t\nparameters: [m, l, g]\ncoordinates: [{coordinates}]\nparticles: {{{particles}}}\n"
            f'constraints:\n  r1: {{equation: "x1^2 + y1^2 = l^2", reaction: T1}}\n{rods}gravity: -g*j\n'
        ),
        complete=False,
    )
    assert solution.holds
    found = solution.long_reactions
    assert found.hold is True
    assert {str(r.force) for r in found.lost} == {"T1", "T2", "T3", "T4"}
    assert all(e != 0 for e in found.by_accelerations.values())
