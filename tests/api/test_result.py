"""Answers judged by a Python program."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

import lagrange

t = sp.Symbol("t")
l, m, g = sp.symbols("l m g")


@pytest.fixture(scope="module")
def pendulum() -> lagrange.Result:
    return lagrange.solve(lagrange.load("ex11"))


theta = dynamicsymbols("theta")
RIGHT = [
    "l theta'' + g sin theta = 0",
    r"\ddot\theta = -\frac gl \sin\theta",
    sp.Eq(l * theta.diff(t, 2), -g * sp.sin(theta)),
    m * l**2 * theta.diff(t, 2) + 1.0 * m * g * l * sp.sin(theta),
    sp.Derivative(l * theta.diff(t), t) + g * sp.sin(theta),
    l * sp.Symbol("theta''") + g * sp.sin(sp.Symbol("theta", real=True)),
    sp.Symbol("theta").diff(sp.Symbol("theta")) * (l * sp.Symbol("theta''") + g * sp.sin(sp.Symbol("theta"))),
]


@pytest.mark.parametrize("answer", RIGHT, ids=str)
def test_right_answers_in_every_form(pendulum: lagrange.Result, answer: object) -> None:
    found = lagrange.check(pendulum, answer)
    assert (found.verdict, found.choice, found.missing) == ("equivalent", "angle", 0)
    assert [str(e) for e in found.derived] == ["g*sin(theta) + l*theta''"]


def test_an_answer_of_several_equations(pendulum: lagrange.Result) -> None:
    x, y = dynamicsymbols("x y")
    lam = sp.Symbol("lambda_rod")
    answer = [sp.Eq(m * x.diff(t, 2), 2 * lam * x), m * y.diff(t, 2) - m * g - 2 * lam * y, "x^2 + y^2 = l^2"]
    assert lagrange.check(pendulum, answer).verdict == "equivalent"
    assert lagrange.check(pendulum, sp.Matrix(answer[1:2])).verdict in ("incomplete", "wrong")
    assert lagrange.check(pendulum, pendulum.own.equations_with_multipliers).verdict == "equivalent"
    assert lagrange.check(pendulum, pendulum.own.equations_in_time()).verdict == "equivalent"


def test_sympys_own_equations(pendulum: lagrange.Result) -> None:
    lagrangian = m * l**2 * theta.diff() ** 2 / 2 + m * g * l * sp.cos(theta)
    equations = LagrangesMethod(lagrangian, [theta]).form_lagranges_equations()
    assert lagrange.check(pendulum.problem, equations).verdict == "equivalent"


def test_a_wrong_sign_is_found(pendulum: lagrange.Result) -> None:
    found = lagrange.check(pendulum, sp.Eq(l * theta.diff(t, 2), g * sp.sin(theta)))
    assert found.verdict == lagrange.Verdict.WRONG
    assert "the sign of the term g*sin(theta)" in found.each[0].diagnosis
    assert "✗ l*theta'' = g*sin(theta)" in str(found)
    assert "sign" not in found.at_hint_level(1).each[0].diagnosis


BAD = {
    "`tha` is not declared": sp.Symbol("tha") + theta,
    "`besselj` has no meaning": sp.besselj(0, theta),
    "`Integral` has no meaning": sp.Integral(theta, t),
    "`ImaginaryUnit` has no meaning": sp.I * theta,
    "`f(x(t))` is not declared": sp.Function("f")(dynamicsymbols("x")),
    "`theta(2*t)` is not declared": sp.Function("theta")(2 * t),
    "this requires a time derivative of `theta''`": theta.diff(t, 3),
    "requires a time derivative of `theta''`": sp.Derivative(l * theta.diff(t, 2) + theta, t),
    "time derivative of `theta''`": sp.Symbol("theta'''"),
    "`NoneType` has no meaning": None,
    "`object` has no meaning": 3.5j,
    "`StrictLessThan` has no meaning": theta < 0,
}


@pytest.mark.parametrize(("said", "answer"), BAD.items(), ids=BAD)
def test_what_cannot_be_read_says_why(pendulum: lagrange.Result, said: str, answer: object) -> None:
    """An unreadable equation is named and does not affect the verdict on the others; alone it is the verdict."""
    said = said.replace("`object`", "`complex`")
    alone = lagrange.check(pendulum, [answer])
    assert alone.verdict == "unreadable"
    assert said in alone.each[0].diagnosis
    found = lagrange.check(pendulum, [answer, RIGHT[0]])
    assert found.verdict == "equivalent"
    assert [e.verdict for e in found.each] == ["unreadable", "equivalent"]
    assert said in found.each[0].diagnosis
    assert said in str(found)
    assert found.messages


@pytest.mark.parametrize(("answer", "verdict"), [(sp.Eq(theta, theta), "trivial"), (sp.Eq(1, 0), "wrong"), ([], None)])
def test_what_says_nothing(pendulum: lagrange.Result, answer: object, verdict: str | None) -> None:
    if verdict is None:
        with pytest.raises(lagrange.ProblemError, match="no equation to check"):
            lagrange.check(pendulum, answer)
    else:
        assert lagrange.check(pendulum, answer).verdict == verdict


def test_the_answers_of_the_file(pendulum: lagrange.Result) -> None:
    found = lagrange.check(pendulum)
    assert found.verdict == "equivalent"
    assert {a.name for a in found.others} >= {"degrees_of_freedom"}


def test_an_equilibrium_has_alternatives() -> None:
    problem = lagrange.loads(
        "title: p\ncoordinates: [theta]\nparameters: [m, l, g]\nfind: equilibrium\n"
        "forces: {weight: {potential: -m*g*l*cos(theta)}}\n"
    )
    angle = sp.Symbol("theta")
    result = lagrange.solve(problem)
    assert lagrange.check(result, [[sp.Eq(angle, 0)], [sp.Eq(angle, sp.pi)]]).verdict == "equivalent"
    assert lagrange.check(result, [["theta = 0"]]).verdict == "incomplete"
    assert lagrange.check(result, sp.Eq(sp.sin(angle), 0)).verdict == "equivalent"
