"""Which constraints are rods, and when there are free bodies."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.dynamics.free_bodies import share_of_polygon
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem

Read = Callable[[str], Problem]
l, m, g = sp.symbols("l m g", positive=True)


def solution(problem: Read, text: str) -> Solution:
    return solve(problem(f"title: Example\n{text}"))


def one_particle(problem: Read, constraint: str, more: str = "") -> Solution:
    text = "parameters: [m, l, g, a, b]\ncoordinates: [x, y, z]\nparticles: {P: {mass: m, position: '[x, y, z]'}}\n"
    return solution(problem, f"{text}functions: {{w: [t]}}\nconstraints: {{c: {{equation: '{constraint}'{more}}}}}\n")


@pytest.mark.parametrize(
    "text",
    [
        # B hangs from A, both placed by angles: A's angle moves B
        "coordinates: [a, b]\nparticles: {A: {mass: m, position: '[l*sin(a), l*cos(a)]'}, "
        "B: {mass: m, position: 'r_A + l*sin(b)*i + l*cos(b)*j'}}\nconstraints: {c: a = b}\n",
        # the force acts beside the particle
        "coordinates: [x, y]\nparticles: {A: {mass: m, position: '[x, y]'}}\nconstraints: {c: x = y}\n"
        "forces: {push: {on: A, vector: g*i, at: '[2*x, y]'}}\n",
    ],
    ids=["placed together", "a force elsewhere"],
)
def test_no_free_bodies_where_coordinates_do_not_give_them(problem: Read, text: str) -> None:
    newton = solution(problem, f"parameters: [m, l, g]\n{text}").law.newton
    assert newton.bodies is None
    assert newton.equations is None
    assert [r.directions for r in newton.reactions] == [None]


@pytest.mark.parametrize(
    ("constraint", "length", "factor"),
    [
        ("x^2 + y^2 + z^2 = l^2", l, -2 * l),
        ("l^2 = x^2 + y^2 + z^2", l, 2 * l),
        ("sqrt(x^2 + y^2 + z^2) = l", l, -1),
        ("(x^2 + y^2 + z^2)/(2*l) = l/2", l, -1),
        ("x^2 + y^2 + z^2 = 2*a*x", sp.Symbol("a", positive=True), -2 * sp.Symbol("a", positive=True)),
        ("(x - w)^2 + y^2 + (z - l)^2 = l^2", l, -2 * l),
    ],
)
def test_distance_constraints_are_recognised(problem: Read, constraint: str, length: sp.Expr, factor: sp.Expr) -> None:
    [reaction] = one_particle(problem, constraint).law.newton.reactions
    assert reaction.rod is not None
    assert is_zero(reaction.rod.length - length) is True
    assert is_zero(reaction.rod.factor - factor) is True


@pytest.mark.parametrize(
    "constraint",
    [
        "x^2 + 2*y^2 + z^2 = l^2",
        "x^2 + y^2 = l^2",
        "z = x^2/l",
        "x + y + z = l",
        "x^2 + y^2 - z^2 = l^2",
        "x*y*z = l^3",
    ],
)
def test_other_constraints_are_not(problem: Read, constraint: str) -> None:
    [reaction] = one_particle(problem, constraint).law.newton.reactions
    assert reaction.rod is None
    assert reaction.is_normal


def test_a_string_over_a_pulley_is_no_rod(problem: Read) -> None:
    found = solution(
        problem,
        "parameters: [m, L]\ncoordinates: [x, y]\nparticles: {A: {mass: m, position: x*i}, B: {mass: m, position: y*i}}\n"
        "constraints: {rod: x + y = L}\n",
    )
    [reaction] = found.law.newton.reactions
    assert reaction.rod is None
    assert not reaction.is_normal


def test_a_length_that_closes_a_polygon() -> None:
    a, b, l, p, q, u = sp.symbols("a b l p q u", positive=True)
    chain = a**2 + b**2 + 2 * a * b * sp.cos(p - q)
    turning = SimpleNamespace(coordinates=(p, q))

    def share(f: sp.Expr, constant: sp.Expr) -> sp.Expr | None:
        return share_of_polygon(Row("", (), sp.S.Zero, f), constant, turning)  # type: ignore[arg-type]

    assert share(chain - l**2, -(l**2)) == -2 * l
    assert share(5 * l**2 - 5 * chain, 5 * l**2) == 10 * l
    assert share(chain + a * b * sp.cos(p) - l**2, -(l**2)) is None
    assert share(a**2 + 2 * b**2 - 2 * a * b * sp.cos(p) - l**2, -(l**2)) is None
    assert share(sp.cos(p) ** 2 + u**2 - l**2, -(l**2)) is None


@pytest.mark.parametrize("inertia", ["", ", inertia: m*l^2/12"])
def test_a_bar_may_be_placed_by_its_foot_and_its_angle(problem: Read, inertia: str) -> None:
    """At rest it needs no inertia: its angle moves its centre, and turns it all the same. N_A + N_B cos θ = m g."""
    text = (
        "parameters: {m: positive, g: positive, l: positive, h: positive}\ncoordinates: [x, y, theta]\n"
        f"bodies: {{bar: {{mass: m{inertia}, position: '[x + l/2*cos(theta), y + l/2*sin(theta)]', angle: theta}}}}\n"
        "constraints: {floor: {equation: y >= 0, reaction: N_A}, edge: {equation: x*sin(theta) + (h - y)*cos(theta) <= 0}}\n"
        "gravity: -g*j\nfind: [equilibrium]\n"
    )
    law = solution(problem, text).law
    assert law is not None
    [floor, _] = law.newton.reactions
    direction = floor.on("bar")
    assert direction is not None
    assert [sp.simplify(c) for c in direction.components] == [0, 1, 0]
