"""Checks of linear equations by Lagrange's."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.mechanics.nearby.checks import check_linear_motion
from tests.mechanics.nearby.test_linear_motion import bicycle


def test_lagranges_equations_agree_and_a_slip_is_found() -> None:
    problem, configuration, found = bicycle()
    [check] = check_linear_motion(problem, configuration, found)
    assert check.passed
    [alone, block] = found.blocks
    for name in ("mass", "damping", "stiffness"):
        table = [list(row) for row in getattr(block, name)]
        table[1][1] *= sp.Rational(1000001, 1000000)
        wrong = replace(found, blocks=(alone, replace(block, **{name: tuple(map(tuple, table))})))
        assert not check_linear_motion(problem, configuration, wrong)[0].passed
