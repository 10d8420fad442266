"""Constant vectors, against motions integrated in numbers from laws written by hand.

What follows from equations of motion, and what does not.

Directions that stay, and Bernoulli's equation of the hodograph against a shot integrated in numbers.
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import lagrange
from lagrange.core.symbols import prime
from lagrange.mechanics.consequences.vectors import (
    cone_vector,
    constant_spins,
    hodograph,
    is_short,
    kept_directions,
    vanish_along,
)
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


# Along


def test_a_pendulums_equation_follows_and_another_does_not() -> None:
    view = solved("ex11-ideal-pendulum").chosen
    assert view.motion is not None
    assert is_short(view.motion)
    [theta] = view.configuration.slots.coordinates
    l, g = (next(s for s in view.motion.expressions[0].free_symbols if s.name == n) for n in "lg")
    assert vanish_along(view.motion, [l * prime(theta, 2) + g * sp.sin(theta)])
    assert not vanish_along(view.motion, [l * prime(theta, 2) + g * theta])


# Directions


LETTERS = ("v", "psi", "u")


def test_the_machine_of_appell_and_hamel_keeps_its_direction() -> None:
    pairs = [(x.name, y.name) for x, y in kept_directions(solved("appell-hamel").chosen)]
    assert pairs == [("x", "y"), ("x", "z"), ("y", "z")]


@pytest.mark.parametrize("name", ["thrown-stone", "charge-in-crossed-fields", "constant-speed"])
def test_other_motions_turn(name: str) -> None:
    assert not [*kept_directions(solved(name).chosen)]
    assert hodograph(solved(name).chosen, LETTERS) is None


def test_a_shot_against_the_air() -> None:
    """m g du = v D(v) dψ, with D = c v²."""
    found = hodograph(solved("ballistic-curve").chosen, LETTERS)
    assert found is not None
    assert [str(s) for s in found.sides] == ["d(u)*g*m", "d(psi)*v*D(v)"]
    m, g, c = 2.0, 9.81, 0.3

    def rate(_: float, s: np.ndarray) -> list[float]:
        v = np.hypot(*s)
        return [-c * v * s[0] / m, -g - c * v * s[1] / m]

    run = solve_ivp(rate, (0, 2), [8, 6], rtol=1e-10, atol=1e-12, dense_output=True).sol(np.linspace(0, 2, 2001))
    u, psi, v = run[0], np.arctan2(run[1], run[0]), np.hypot(*run)
    slope = np.gradient(u, psi)[1:-1]
    assert np.allclose(m * g * slope, (v * c * v**2)[1:-1], rtol=1e-4)
