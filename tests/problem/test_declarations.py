"""Parameters, coordinates, functions and abbreviations as a file declares them."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import Sign, Unspecified, t
from lagrange.core.vectors import Vector
from lagrange.problem.model import (
    AppliedForce,
    Assumption,
)
from tests.support.problem_texts import HEAD, read

x, y, theta = (sp.Symbol(n, real=True) for n in ("x", "y", "theta"))
v, w, om = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'"))
m, l, g, k, c, F, R, mu, A, C, I_G = sp.symbols("m l g k c F R mu A C I_G", positive=True)


def vector(*components: sp.Expr | int) -> Vector:
    p, q, r = (sp.sympify(e) for e in components)
    return Vector((p, q, r))


def test_parameters_in_a_list_are_positive() -> None:
    problem = read("title: T\nparameters: [m, θ_0]\ncoordinates: [x]\n")
    assert [p.symbol for p in problem.parameters] == [m, sp.Symbol("theta_0", positive=True)]


def test_parameters_in_a_mapping() -> None:
    problem = read("""title: T
coordinates: [x]
parameters:
  m: positive
  a: real
  b: nonnegative
  s: sign
  n:
  q: {assume: real, unit: m/s^2, meaning: acceleration of gravity, value: 9.81}
  r: {value: 2/3}
  z: {unit: kg}
  w: {assume: real, value: -1e-3}
""")
    found = {str(p.symbol): p for p in problem.parameters}
    assert [str(p.symbol) for p in problem.parameters] == ["m", "a", "b", "s", "n", "q", "r", "z", "w"]
    assert found["m"].symbol.is_positive
    assert found["n"].symbol.is_positive
    assert found["a"].symbol.is_real
    assert found["a"].symbol.is_positive is None
    assert found["b"].symbol.is_nonnegative
    assert found["b"].symbol.is_positive is None
    assert isinstance(found["s"].symbol, Sign)
    assert found["s"].symbol ** 2 == 1
    assert (found["q"].unit, found["q"].meaning) == ("m/s^2", "acceleration of gravity")
    assert found["q"].assume is Assumption.REAL
    assert found["q"].value == sp.Rational(981, 100)
    assert found["r"].value == sp.Rational(2, 3)
    assert found["z"].value is None
    assert found["w"].value == sp.Rational(-1, 1000)


@pytest.mark.parametrize(
    ("written", "value"),
    [("1e-3", "1/1000"), ("012", "12"), (".5", "1/2"), ("2", "2"), ("'2'", "2"), ("1.50", "3/2"), ("2e3", "2000")],
)
def test_numbers_are_exact(written: str, value: str) -> None:
    problem = read(f"title: T\nparameters: {{m: {{value: {written}}}}}\ncoordinates: [x]\n")
    assert problem.parameters[0].value == sp.Rational(value)


def test_coordinates_in_a_mapping() -> None:
    problem = read("title: T\ncoordinates: {x: distance right of O, y: {meaning: height, unit: m}, z: }\n")
    assert [(str(q.symbol), q.meaning, q.unit) for q in problem.coordinates] == [
        ("x", "distance right of O", ""),
        ("y", "height", "m"),
        ("z", "", ""),
    ]


def test_functions() -> None:
    problem = read(
        "title: T\ncoordinates: [x, y]\nfunctions: {f: [X, Y], u: [t], F_x: [x, x', t]}\n"
        'constraints: {a: "f(x - u, y) = 0", b: "x\' = u\'"}\n'
        "particles: {P: {mass: 1, position: x*i}}\nforces: {p: {on: P, vector: F_x*i}}\n"
    )
    u = sp.Symbol("u", real=True)
    assert problem.slots.prescribed == (u,)
    assert [str(f) for f in problem.functions] == ["f(X, Y)", "F_x(x, x', t)"]
    assert problem.constraints[0].function == Unspecified.of("f", ("X", "Y"), x - u, y)
    assert problem.constraints[1].function == v - sp.Symbol("u'", real=True)
    push = problem.forces[0]
    assert isinstance(push, AppliedForce)
    assert push.vector == vector(Unspecified.of("F_x", ("x", "x'", "t"), x, v, t), 0, 0)


@pytest.mark.parametrize("section", ["a: l*x\n  b: a^2\n  n: a*i\n  w: n'", "w: n'\n  n: a*i\n  b: a^2\n  a: l*x"])
def test_abbreviations_whatever_their_order(section: str) -> None:
    problem = read(f"{HEAD}let:\n  {section}\n")
    assert problem.scope.scalars["b"] == l**2 * x**2
    assert problem.scope.vectors["w"] == vector(l * v, 0, 0)
