"""The tensor of inertia."""

from __future__ import annotations

import random

import sympy as sp

from lagrange.core.inertia import InertiaTensor, moments_of_mass, principal_minors
from lagrange.core.vectors import turned_axes

A, B, C = sp.symbols("A B C", positive=True)
D, E, F = sp.symbols("D E F", real=True)
J = InertiaTensor((A, B, C), (D, E, F))


def of_masses(seed: int) -> tuple[InertiaTensor, sp.Matrix]:
    """J and ∫ x_a x_b dm of four random point masses, summed up mass by mass."""
    drawn = random.Random(seed)
    tensor, second = sp.zeros(3), sp.zeros(3)
    for _ in range(4):
        m, r = drawn.randint(1, 9), sp.Matrix([drawn.randint(-9, 9) for _ in range(3)])
        tensor += m * (r.dot(r) * sp.eye(3) - r * r.T)
        second += m * r * r.T
    diagonal = (tensor[0, 0], tensor[1, 1], tensor[2, 2])
    return InertiaTensor(diagonal, (tensor[1, 2], tensor[2, 0], tensor[0, 1])), second


def test_energy_and_momentum_are_those_of_masses() -> None:
    for seed in range(5):
        drawn = random.Random(seed)
        tensor, second = of_masses(seed)
        w = sp.Matrix([drawn.randint(-9, 9) for _ in range(3)])
        assert moments_of_mass(tensor) == second
        assert sp.Matrix(tensor.times(list(w))) == sp.Matrix(tensor.rows) * w
        assert 2 * tensor.energy(list(w)) == (w.T * sp.Matrix(tensor.rows) * w)[0] == tensor.form(list(w), list(w))
        assert all(minor >= 0 for m in (sp.Matrix(tensor.rows), second) for minor in principal_minors(m))


def test_a_tensor_as_a_sum_of_squares() -> None:
    found = J.completed()
    assert found is not None
    weights, rows = found
    lower = sp.Matrix(rows)
    assert (lower.T * sp.diag(*weights) * lower - sp.Matrix(J.rows)).applyfunc(sp.simplify) == sp.zeros(3)
    assert InertiaTensor((sp.S.Zero, B, C), (D, E, F)).completed() is None


def test_how_a_tensor_changes_in_other_axes() -> None:
    """d/dφ of R J Rᵀ at φ = 0 for a rotation about each axis."""
    phi = sp.Symbol("phi", real=True)
    for n in range(3):
        w = [sp.Integer(int(k == n)) for k in range(3)]
        turned = sp.Matrix([list(v.components) for v in turned_axes(((n + 1, phi),))]).T
        rate = (turned * sp.Matrix(J.rows) * turned.T).diff(phi).subs(phi, 0)
        upper = tuple(rate[a, b] for a in range(3) for b in range(a, 3))
        assert all(sp.expand(x - y) == 0 for x, y in zip(J.turned_with(w), upper, strict=True))


def test_the_axis_of_a_wheel() -> None:
    A, C = sp.symbols("A C", positive=True)
    assert [InertiaTensor(m).symmetry_axis for m in ((A, C, A), (C, A, A), (A, A, C), (A, A, A))] == [1, 0, 2, 2]
