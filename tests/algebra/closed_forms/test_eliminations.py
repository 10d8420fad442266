"""Eliminations, each on the system for which it is there; the solutions are tried in numbers."""

from __future__ import annotations

from math import isclose

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.eliminations import State, linear, on_circle, parallel, turned, wave
from lagrange.algebra.closed_forms.unit_circle import TrigLetters

a, b = sp.symbols("a b", positive=True)
x, y, alpha, beta = sp.symbols("x y alpha beta", real=True)


def lettered(*equations: sp.Expr) -> tuple[State, TrigLetters]:
    letters = TrigLetters(equations, (x, y, alpha, beta))
    return State(tuple(letters.read(e) for e in equations)), letters


def test_a_coefficient_that_may_vanish_is_a_state_of_its_own() -> None:
    state, letters = lettered(y * x - a)
    divided, vanishing = linear(state, letters, (x,), with_unknowns=True)
    assert divided.values == {x: a / y}
    assert divided.nonzero == (y,)
    assert vanishing.equations == (y, -a)


def test_an_angle_that_another_one_gives() -> None:
    [state] = turned(*lettered(alpha - beta - a, sp.sin(alpha) - b * sp.sin(beta)))
    assert state.values[alpha] == beta + a


def test_parallel_rods() -> None:
    states = parallel(*lettered(sp.sin(alpha) * sp.cos(beta) - sp.cos(alpha) * sp.sin(beta)))
    assert [s.values[alpha] for s in states] == [beta, beta + sp.pi]


def test_two_equations_linear_in_one_sine_leave_one_without_it() -> None:
    """The ends of a rod on a circle of radius 1, its mass centre under or over the centre: y² = 1 − a b."""
    state, letters = lettered(y**2 - 2 * a * y * sp.sin(alpha) + a**2 - 1, y**2 + 2 * b * y * sp.sin(alpha) + b**2 - 1)
    [fewer] = wave(state, letters)
    assert sp.factor(fewer.equations[0]) in (k * 2 * y * (a + b) * (y**2 + a * b - 1) for k in (1, -1))
    assert fewer.equations[1:] == state.equations
    assert not wave(*lettered(x * sp.sin(alpha) - y, y * sp.sin(alpha) - x))  # two unknowns would be left


def test_two_rods_with_letters_stay_a_triangle() -> None:
    assert not on_circle(*lettered(a * sp.cos(alpha) - b * sp.cos(beta) - 1, a * sp.sin(alpha) - b * sp.sin(beta)))


def test_two_equal_rods_with_letters() -> None:
    """A roof over a span of 2a: both rods at the angle whose cosine is a/l."""
    [branch] = solutions(
        [sp.sin(alpha) - sp.sin(beta), b * sp.cos(alpha) + b * sp.cos(beta) - 2 * a], [alpha, beta]
    ).branches
    assert [(r.lhs, r.rhs) for r in branch.relations] == [(sp.cos(alpha), a / b), (beta, alpha)]
    assert branch.points
    assert not branch.left
    for p in branch.points:
        letters = {str(s): v for s, v in p.items()}
        assert letters["cos(alpha)"] == letters["cos(beta)"] == a / b
        assert letters["sin(alpha)"] == letters["sin(beta)"]


@pytest.mark.parametrize(("long", "short", "base", "number"), [(3, 2, 2, 2), (2, 1, 1, 1), (3, 1, 1, 0), (4, 3, 2, 2)])
def test_two_rods_between_hinges(long: int, short: int, base: int, number: int) -> None:
    """Two positions, one where the rods are in line, none where they are too short."""
    equations = [
        long * sp.cos(alpha) - short * sp.cos(beta) - base,
        long * sp.sin(alpha) - short * sp.sin(beta),
    ]
    found = solutions(equations, [alpha, beta])
    assert found.solved
    points = [p for branch in found.branches for p in branch.points]
    assert len(points) == number
    for p in points:
        (c, s), (cosine, sine) = ([float(p[x]) for x in found.letters.angles[u].letters] for u in (alpha, beta))
        assert isclose(c**2 + s**2, 1)
        assert isclose(cosine**2 + sine**2, 1)
        assert isclose(long * c - short * cosine, base, abs_tol=1e-9)
        assert isclose(long * s, short * sine, abs_tol=1e-9)
