"""What a set of solutions states: signs that a root decides, equations that are left."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from tests.support.found_solutions import ALPHA, POSITIVE

ANGLES = {n: sp.Symbol(n, real=True) for n in ["theta", "phi", "psi"]}
PLAIN = {n: sp.Symbol(n, real=True) for n in ["x", "y", "z", "u", "v", "P", "Q"]}
NAMES = {**POSITIVE, **ANGLES, **PLAIN, **ALPHA}


def read(text: str) -> sp.Expr:
    return sp.sympify(text.replace("^", "**"), locals=NAMES)


def test_a_sign_that_a_root_decides_is_stated() -> None:
    """a cos θ = √(b + c + b sin θ): of the two angles with that sine, the one with cos θ > 0, by its cosine."""
    found = solutions([read("a*cos(theta) - sqrt(b + c + b*sin(theta))")], [ANGLES["theta"]])
    for b in found.branches:
        assert {r.lhs for r in b.relations} == {sp.sin(ANGLES["theta"]), sp.cos(ANGLES["theta"])}


@pytest.mark.parametrize("text", ["W*a + M*b", "a*cos(theta) + a + b", "a*sin(theta) - a*2", "k*x^2 + m*g", "a"])
def test_no_solution(text: str) -> None:
    found = solutions([read(text)], [ANGLES["theta"], PLAIN["x"]])
    assert found.solved
    assert found.branches == ()


@pytest.mark.parametrize("text", ["a*sin(theta) - b*cos(theta)^2 - c*sin(theta)*cos(theta)", "x^5 - a*x - b"])
def test_what_is_not_solved_stays_an_equation(text: str) -> None:
    e = read(text)
    [u] = e.free_symbols - {*POSITIVE.values()}
    found = solutions([e], [u])
    assert not found.solved
    [b] = found.branches
    assert b.relations == ()
    [left] = b.left
    assert sp.simplify(left / e).is_number
