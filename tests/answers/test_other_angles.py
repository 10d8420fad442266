"""Angles that stand for all with the same tangent, sine or cosine."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.other_angles import widened

theta, u = sp.symbols("theta u", real=True)


@pytest.mark.parametrize(
    ("e", "wave", "wider"),
    [
        (theta - sp.atan(u), None, sp.tan(theta) - u),
        (theta - sp.acos(sp.Rational(3, 5)), None, sp.cos(theta) - sp.Rational(3, 5)),
        (theta - sp.atan(2), sp.tan, sp.tan(theta) - 2),
        (theta - sp.atan(2) - sp.pi, sp.tan, None),  # no principal value: just this one is meant
        (theta - sp.pi, sp.cos, None),
        (theta + u, sp.tan, None),
        (theta - sp.pi / 2, sp.tan, None),  # where there is no tangent
    ],
)
def test_an_angle_is_read_by_its_tangent(e: sp.Expr, wave: sp.FunctionClass | None, wider: sp.Expr | None) -> None:
    assert sp.expand(widened(e, wave) - (e if wider is None else wider)) == 0
