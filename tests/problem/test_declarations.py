"""Parameters, coordinates, functions and abbreviations as a file declares them."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import check_answer
from lagrange.core.diagnostics import Fragment, ProblemError
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


def test_an_assumption_is_no_meaning_of_a_coordinate() -> None:
    declared = "coordinates: {r: positive, s: the distance}"
    problem = read(f"title: T\n{declared}\nparticles: {{P: {{mass: 1, position: '[r, s]'}}}}\n")
    assert [n.code for n in problem.notes] == ["assumed-of-coordinate"]
    assert [q.meaning for q in problem.coordinates] == ["", "the distance"]


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


@pytest.mark.parametrize(
    ("declared", "value", "unit"),
    [
        ("value: 30 cm", "3/10", "m"),
        ("value: 30, unit: cm", "3/10", "m"),
        ("value: 30 cm, unit: m", "3/10", "m"),
        ("value: 9.81 m/s^2", "981/100", "m/s^2"),
        ("value: 9.81, unit: m/s²", "981/100", "m/s²"),
        ("value: 30 deg", "pi/6", "rad"),
        ("value: 30 °, unit: rad", "pi/6", "rad"),
        ("value: 1200 rpm", "40*pi", "rad/s"),
        ("value: 1e-3 kN", "1", "N"),
        ("value: 2/3 km", "2000/3", "m"),
        ("value: 50 1/s", "50", "1/s"),
        ("value: 1e3", "1000", ""),
        ("value: 2*3", "6", ""),
        ("unit: furlong", None, "furlong"),  # words for the reader, as long as there is no value
    ],
)
def test_values_are_in_units_of_si(declared: str, value: str | None, unit: str) -> None:
    [parameter] = read(f"title: T\ncoordinates: [x]\nparameters: {{l: {{{declared}}}}}\n").parameters
    assert parameter.value == (None if value is None else sp.sympify(value))
    assert parameter.unit == unit


@pytest.mark.parametrize(
    ("declared", "code", "column"),
    [
        ("value: 30 cm, unit: kg", "unit-mismatch", 25),
        ("value: 30 deg, unit: m", "unit-mismatch", 25),
        ("value: 3 furlong", "unknown-unit", 25),
        ("value: 3, unit: furlong", "unknown-unit", 34),
        ("value: 5 J/kg K", "unknown-unit", 25),
        ("value: -3 m", "value-against-assumption", 25),
        ("value: 3e400000000 m", "number-too-long", 25),
        ("value: 3 m^99999", "unknown-unit", 25),
    ],
)
def test_a_unit_that_does_not_fit_is_an_error_at_its_place(declared: str, code: str, column: int) -> None:
    with pytest.raises(ProblemError) as caught:
        read(f"title: T\nparameters: {{l: {{{declared}}}}}\ncoordinates: [x]\n")
    [finding] = caught.value.diagnostics
    assert finding.code == code
    assert finding.span is not None
    assert finding.span.source.position(finding.span.start) == (2, column)


def test_a_length_in_centimetres_beside_metres_per_second_squared() -> None:
    """θ'' = −(g/l) sin θ with g = 10 m/s² and l = 50 cm is −20 sin θ; it came out as −sin θ/5."""
    text = "title: T\nparameters: {m: positive, g: {value: 10 m/s^2}, l: {value: 50, unit: cm}}\ncoordinates: [theta]\n"
    text += "particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}\ngravity: -g*j\n"
    problem = read(text)
    judged = {
        answer: check_answer(problem, (Fragment.of(answer),)).equations.verdict
        for answer in ("theta'' = -20*sin(theta)", "theta'' = -sin(theta)/5")
    }
    assert [*judged.values()] == [Verdict.EQUIVALENT, Verdict.WRONG]


@pytest.mark.parametrize("end", ["2*l", "2 l", "2*l/3", "2*pi*l", "2*sqrt(l*m)"])
def test_an_end_of_a_range_may_be_a_multiple_of_a_parameter(end: str) -> None:
    text = f'title: T\nparameters: [l, m]\ncoordinates: {{x: {{range: [0, "{end}"]}}}}\n'
    [coordinate] = read(text).coordinates
    assert coordinate.range is not None
    assert {str(s) for s in coordinate.range.high.free_symbols} == {n for n in "lm" if n in end.replace("sqrt", "")}


@pytest.mark.parametrize(("end", "cure"), [("2*q", "declared under `parameters`"), ("2*l*q", "the declared names are")])
def test_an_end_of_a_range_with_a_name_nobody_declared_names_the_cure(end: str, cure: str) -> None:
    text = f'title: T\nparameters: [l, m]\ncoordinates: {{x: {{range: [0, "{end}"]}}}}\n'
    with pytest.raises(ProblemError) as refused:
        read(text)
    assert cure in str(refused.value.diagnostics[0].help)
