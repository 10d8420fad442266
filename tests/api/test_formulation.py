"""The equations of a result as matrices."""

from __future__ import annotations

import pytest
import sympy as sp

import lagrange


@pytest.fixture(scope="module")
def pendulum() -> lagrange.Result:
    return lagrange.solve(lagrange.load("ex11"))


def test_matrices_make_the_equations(pendulum: lagrange.Result) -> None:
    own = pendulum.own
    a, lam = sp.Matrix(own.accelerations), sp.Matrix(own.multipliers)
    left = own.mass_matrix * a - own.force_vector - own.constraint_matrix.T * lam
    assert all(sp.expand(e.lhs - e.rhs - r) == 0 for e, r in zip(own.equations_with_multipliers, left, strict=True))
