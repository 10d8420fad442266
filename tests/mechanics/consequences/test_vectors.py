"""Constant vectors, against motions integrated in numbers from laws written by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import lagrange
from lagrange.mechanics.consequences.vectors import cone_vector, constant_spins
from lagrange.mechanics.solution import solve
from tests.support.shared import solved


def test_a_charge_near_a_magnetic_pole_runs_on_a_cone() -> None:
    """J = m r × v − κ e and r² − v² t² stay the same."""
    found = cone_vector(solved("charge-and-monopole").chosen)
    assert found is not None
    assert (found.factor.name, found.mass.name, found.spread) == ("kappa", "m", True)
    m, kappa = 2.0, 3.0

    def rate(_: float, s: np.ndarray) -> np.ndarray:
        r, v = s[:3], s[3:]
        # in the file F = (κ/r) (φ' sin θ e_θ − θ' e_φ), which is κ/r³ (v × r)
        return np.concatenate([v, kappa * np.cross(v, r) / np.linalg.norm(r) ** 3 / m])

    run = solve_ivp(rate, (0, 3), [1, 0.2, 0.3, -0.3, 0.8, 0.5], rtol=1e-10, atol=1e-12).y.T
    vectors = [m * np.cross(s[:3], s[3:]) - kappa * s[:3] / np.linalg.norm(s[:3]) for s in run]
    assert np.allclose(vectors, vectors[0], atol=1e-7)
    wrong = [m * np.cross(s[:3], s[3:]) + kappa * s[:3] / np.linalg.norm(s[:3]) for s in run]
    assert not np.allclose(wrong, wrong[0], atol=1e-2)


@pytest.mark.parametrize("name", ["euler-rigid-body", "aircraft"])
def test_the_square_of_a_free_bodys_angular_momentum(name: str) -> None:
    [spin] = constant_spins(solved(name).chosen)
    assert str(spin.square) == "A**2*p**2 + B**2*q**2 + C**2*r**2"


@pytest.mark.parametrize("name", ["heavy-top", "suslov-body", "penning-trap"])
def test_no_vector_is_constant_under_a_moment(name: str) -> None:
    view = solved(name).chosen
    assert not [*constant_spins(view)]
    assert cone_vector(view) is None


def test_a_central_force_keeps_a_plane() -> None:
    text = (
        (
            "title: t\nparameters: [m, c]\ncoordinates: [x, y, z]\n"
            "particles: {P: {mass: m, position: x*i + y*j + z*k}}\nforces: {f: {on: P, vector: -c*(x*i + y*j + z*k)}}\n"
        )
        .replace("k]", "c]")
        .replace("-k*", "-c*")
    )
    found = cone_vector(solve(lagrange.loads(text)).chosen)
    assert found is not None
    assert found.factor == 0
    assert not found.spread
