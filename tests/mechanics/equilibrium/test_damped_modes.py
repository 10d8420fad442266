"""Damped normal modes: decay rates and frequencies against the roots of the characteristic polynomial in numbers."""

from __future__ import annotations

from dataclasses import replace

import mpmath
import pytest
import sympy as sp

from lagrange.algebra.closed_forms.eigenmodes import Matrix, determinant
from lagrange.core.diagnostics import Source
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.damped_modes import (
    DampedModes,
    all_exponents_hold,
    damped_modes,
    exponents_in_numbers,
)
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from lagrange.render.json import as_object

m, c, k = sp.symbols("m c k", positive=True)
p = sp.Symbol("p", real=True)
NUMBERS = {m: sp.Rational(3, 2), c: sp.Rational(2, 5), k: sp.Integer(7)}
Matrices = tuple[Matrix, Matrix, Matrix]


def matrices(*rows: str) -> Matrices:
    """M, D, K from `2*c -c / -c 2*c`."""
    names = {"m": m, "c": c, "k": k}
    read = [
        tuple(tuple(sp.sympify(e, locals=names) for e in row.split()) for row in text.split(" / ")) for text in rows
    ]
    return read[0], read[1], read[2]


def polynomial(system: Matrices) -> sp.Expr:
    mass, damping, stiffness = (sp.Matrix(x) for x in system)
    found = determinant((stiffness + p * damping + p**2 * mass).tolist())
    assert found is not None
    return found


def modes_of(system: Matrices) -> DampedModes:
    return damped_modes(system, polynomial(system), p)


SYSTEMS = {
    "one": (matrices("m", "c", "k"), True),
    "two equal carts": (matrices("m 0 / 0 m", "2*c -c / -c 2*c", "2*k -k / -k 2*k"), True),
    "Rayleigh's damping of a double pendulum": (matrices("2*m m / m m", "2*c 0 / 0 c", "2*k 0 / 0 k"), True),
    "one root zero": (matrices("m 0 / 0 m", "c -c / -c c", "k -k / -k k"), True),
    "not proportional": (matrices("m 0 / 0 m", "c 0 / 0 0", "2*k -k / -k 2*k"), False),
    "apart": (matrices("m 0 / 0 m", "c 0 / 0 20*c", "k 0 / 0 k"), True),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_all_exponents_are_those_of_the_polynomial_in_numbers(name: str) -> None:
    """Both routes in numbers, too: eigenvalues of the matrix of first order."""
    system, closed = SYSTEMS[name]
    found = modes_of(system)
    assert found.complete is closed
    assert all_exponents_hold(found, system) is True
    with mpmath.workdps(40):
        coefficients = sp.Poly(polynomial(system).subs(NUMBERS), p).all_coeffs()
        roots = mpmath.polyroots([mpmath.mpf(str(sp.Float(a, 40))) for a in coefficients], maxsteps=500, extraprec=400)
        tables = [mpmath.matrix(sp.Matrix(x).subs(NUMBERS).evalf(40).tolist()) for x in system]
        stated = []
        for mode in found.modes if closed else ():
            rate = mpmath.mpf(str(mode.rate.subs(NUMBERS).evalf(40)))
            square = 0 if mode.square is None else mpmath.mpf(str(mode.square.subs(NUMBERS).evalf(40)))
            pair = [0] if mode.square is None else [mpmath.sqrt(-square), -mpmath.sqrt(-square)]
            stated += [-rate + x for x in pair] * mode.multiplicity
        in_numbers = [
            -e.rate + sign * mpmath.mpc(0, e.frequency)
            for e in exponents_in_numbers(*tables)
            for sign in ((1, -1) if e.frequency else (1,))
        ]
        for values in (stated, in_numbers) if closed else (in_numbers,):
            assert len(values) == len(roots)
            left = list(roots)
            for value in values:
                distance, n = min((abs(r - value), n) for n, r in enumerate(left))
                assert distance < mpmath.mpf(10) ** -12
                del left[n]


def test_shapes_with_phases_satisfy_the_equations() -> None:
    system, _ = SYSTEMS["not proportional"]
    with mpmath.workdps(40):
        mass, damping, stiffness = (mpmath.matrix(sp.Matrix(x).subs(NUMBERS).evalf(40).tolist()) for x in system)
        for e in exponents_in_numbers(mass, damping, stiffness):
            value = mpmath.mpc(-e.rate, e.frequency)
            shape = mpmath.matrix([a * mpmath.expj(f) for a, f in zip(e.amplitudes, e.phases, strict=True)])
            assert mpmath.norm((stiffness + value * damping + value**2 * mass) * shape) < mpmath.mpf(10) ** -15
            assert max(e.amplitudes) == 1
            assert any(f != 0 for f in e.phases)


def test_where_one_coordinate_oscillates() -> None:
    [mode] = modes_of(SYSTEMS["one"][0]).modes
    assert mode.condition is not None
    assert (mode.condition.lhs, mode.condition.relation) == (c, "<")
    assert sp.expand(mode.condition.rhs**2 - 4 * k * m) == 0


@pytest.mark.parametrize(
    ("system", "decays"),
    [(matrices("1", "3", "2"), (1, 2)), (matrices("1", "4", "4"), (2,)), (matrices("1", "2", "5"), (1,))],
)
def test_overdamped_critical_and_oscillating(system: Matrices, decays: tuple[int, ...]) -> None:
    rates = [r for mode in modes_of(system).modes for r in mode.decays]
    assert sorted(rates) == list(decays)


def test_a_wrong_decay_rate_is_noticed() -> None:
    system, _ = SYSTEMS["two equal carts"]
    found = modes_of(system)
    first, second = found.modes
    wrong = replace(found, modes=(replace(first, rate=2 * first.rate), second))
    assert all_exponents_hold(wrong, system) is False


CARTS = """
title: Two carts, one of them damped
parameters: {m: {value: 1 kg}, k: {value: 4 N/m}, c: {value: 0.5 N s/m}}
coordinates: [x, y]
particles: {P: {mass: m, position: x*i}, Q: {mass: m, position: y*i}}
forces:
  springs: {potential: k*x^2/2 + k*(y - x)^2/2 + k*y^2/2}
  air: {on: P, vector: -c*r_P'}
find: linearization
answers: {decay: [0.1240, 0.1260], frequencies: [2.004, 3.448]}
"""


def test_a_damped_system_in_numbers_on_the_page_and_in_json() -> None:
    """p⁴ + p³/2 + 16 p² + 4 p + 48 = 0."""
    found = report(read_problem(Source("carts", CARTS)))
    assert found.holds
    page = " ".join(terminal.text(found.derivation, found.notation, 100).split())
    assert "decay rate" in page
    [entry] = as_object(found)["linearization"]
    [position] = entry["in_numbers"]
    for mode in position["damped_modes"]:
        value = complex(-mode["decay"]["number"], mode["frequency"]["number"])
        assert abs(value**4 + value**3 / 2 + 16 * value**2 + 4 * value + 48) < 1e-9
        assert mode["decay"]["unit"] == "1/s"
