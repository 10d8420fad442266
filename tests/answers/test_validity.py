"""Remarks beside a verdict: where an answer is valid, and what a wrong equation is.

A factor that is named must really matter: where it is zero the equations no longer determine the accelerations, or cannot
be evaluated (`second_route` in numbers), and at other states they do.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

import pytest
import sympy as sp
from mpmath import mp, mpf

from lagrange.answers.equations import EquationVerdict, Verdict
from tests.answers.test_equations import DEPENDENT, TABLE, fragments, solved_reference, verdict_on
from tests.support.answer_truth import read
from tests.support.second_route import affine
from tests.truth.test_answers import derived
from tests.truth.test_random_answers import system

VALID = [
    ("pendulum", "theta'*(l*theta'' + g*sin(theta)) = 0", "theta'", "multiplied"),
    ("pendulum", "theta*l*theta'' = -theta*g*sin(theta)", "theta", "multiplied"),
    ("pendulum", "theta''/sin(theta) + g/l = 0", "sin(theta)", "divided"),
    ("pendulum", "l*theta''*(1 + cos(theta)) = -g*sin(theta)*(1 + cos(theta))", "cos(theta) + 1", "multiplied"),
    ("pendulum", "(l*theta'' + g*sin(theta))*(m - l) = 0", "l - m", "multiplied"),
    ("pendulum", "(l*theta'' + g*sin(theta))/(theta - theta'^2) = 0", "theta - theta'^2", "divided"),
    ("pendulum", "(l*theta'' + g*sin(theta))/(theta'^2 - l) = 0", "l - theta'^2", "divided"),
    ("pendulum", "(l*theta'' + g*sin(theta))*(theta'^3 - theta'*l) = 0", "l - theta'^2", "multiplied"),
    ("pendulum", "l*theta''*cot(theta) = -g*cos(theta)", "sin(theta)", "divided"),
    ("pendulum", "l*theta''*cot(theta) = -g*cos(theta)", "cos(theta)", "multiplied"),
    ("pendulum", "l*theta''*sin(2*theta) = -g*sin(theta)*sin(2*theta)", "cos(theta)", "multiplied"),
    ("spherical", TABLE["14"][1], "sin(theta)", "divided"),
    ("spherical", TABLE["15"][1], "sin(theta)", "divided"),
    ("spherical", TABLE["energy rate and momentum"][1], "theta'", "only there"),
    ("kepler", TABLE["as Binet"][1], "phi'", "divided"),
    ("kepler", "r'*(r'' - r*phi'^2 + k/(m*r^2)) = 0 ; r*phi'' + 2*r'*phi' = 0", "r'", "multiplied"),
    (
        "kepler",
        "cos(phi)*(r'' - r*phi'^2 + k/(m*r^2)) = sin(phi)*(r*phi'' + 2*r'*phi')"
        " ; cos(phi)*(r*phi'' + 2*r'*phi') = sin(phi)*(r'' - r*phi'^2 + k/(m*r^2))",
        "cos(2*phi)",
        "only there",
    ),
    ("cart", "x*(l*theta'' + x''*cos(theta) + g*sin(theta)) = 0", "x", "multiplied"),
]

EVERYWHERE = [
    ("pendulum", "l*theta'' + g*sin(theta) = 0"),
    ("pendulum", "m*theta'' = -m*g/l*sin(theta)"),
    ("pendulum", "(2 + cos(theta))*(l*theta'' + g*sin(theta)) = 0"),
    ("pendulum", "exp(theta)*(l*theta'' + g*sin(theta)) = 0"),
    ("pendulum", "(m^2 + l^2)*(l*theta'' + g*sin(theta)) = 0"),
    ("pendulum", "(1 + theta'^2)*theta'' = -g/l*sin(theta)*(1 + theta'^2)"),
    ("spherical", TABLE["momentum of the spherical pendulum"][1]),
    ("cart", TABLE["38"][1]),
    ("kepler", TABLE["42"][1]),  # its force is not defined for r = 0 either
    (
        "kepler",
        "cos(phi)*(r'' - r*phi'^2 + k/(m*r^2)) = sin(phi)*(r*phi'' + 2*r'*phi')"
        " ; cos(phi)*(r*phi'' + 2*r'*phi') = -sin(phi)*(r'' - r*phi'^2 + k/(m*r^2))",
    ),
]


def remarks(system_name: str, answer: str) -> list[str]:
    return [r for e in verdict_on(answer, solved_reference(system_name)).equations.equations for r in e.remarks]


@pytest.mark.parametrize(("name", "answer", "factor", "how"), VALID)
def test_what_must_not_vanish_is_named(name: str, answer: str, factor: str, how: str) -> None:
    said = [r for r in remarks(name, answer) if r.startswith(f"valid where {factor} != 0")]
    assert said, remarks(name, answer)
    assert how in said[0]
    assert verdict_on(answer, solved_reference(name)).verdict in (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


CARRIED_OUT = {
    "diff(theta'^2/2 + sin(theta)^2*phi'^2/2 - g/l*cos(theta), t)": "theta'*theta'' + sin(theta)*cos(theta)*theta'*phi'^2"
    " + sin(theta)^2*phi'*phi'' + g/l*sin(theta)*theta'",
    "diff(sin(theta)^2*phi', t)": "sin(theta)^2*phi'' + 2*sin(theta)*cos(theta)*theta'*phi'",
    "sin(2 theta)": "sin(2*theta)",
}


@pytest.mark.parametrize(("name", "answer", "factor", "how"), VALID)
def test_what_is_named_matters(name: str, answer: str, factor: str, how: str) -> None:
    """Where the factor is zero the rank falls, or a denominator vanishes, or the system itself is singular there."""
    route, _ = system(name)
    for short, long in CARRIED_OUT.items():
        answer = answer.replace(short, long)
    equations = [read(e) for e in answer.split(";")]
    zero = read(factor)
    symbols = {s for e in (*equations, *route.system, zero) for s in e.free_symbols}
    names = sorted({s.name for s in symbols} - {*route.unknowns})
    there = {n: sp.Rational(3 + 2 * k, 7) for k, n in enumerate(names)}
    s = min(zero.free_symbols, key=str)
    roots = sp.solve(zero.xreplace({x: there[x.name] for x in zero.free_symbols - {s}}), s)
    on = {**there, s.name: next(r for r in roots if r.is_real)}
    assert _rank(route.unknowns, equations, there) == len(equations)
    at_zero = _rank(route.unknowns, equations, on)
    singular = _rank(route.unknowns, list(route.system), on) != len(route.system)
    assert at_zero is None or at_zero < len(equations) or singular, how


def _rank(unknowns: tuple[str, ...], equations: list[sp.Expr], state: Mapping[str, sp.Expr]) -> int | None:
    """How many independent equations there are for the accelerations; None where they are not defined."""
    with mp.workdps(60):
        numbers = {n: mpf(str(sp.N(v, 65))) for n, v in state.items()}
        try:
            rows = affine(equations, unknowns, numbers)
        except (ZeroDivisionError, ValueError, AssertionError):
            return None
        if any(abs(x) > mpf(10) ** 30 for row in rows for x in row):
            return None
        return sum(v > mpf(10) ** -30 for v in mp.svd_r(mp.matrix([row[:-1] for row in rows]), compute_uv=False))


@pytest.mark.parametrize(("name", "answer"), EVERYWHERE)
def test_nothing_is_said_where_nothing_can_vanish(name: str, answer: str) -> None:
    assert remarks(name, answer) == []
    assert verdict_on(answer, solved_reference(name)).verdict is Verdict.EQUIVALENT


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ("x*(y'' - g) - y*x'' = 0", []),  # x² + y² = l² is not zero
        ("l^2*x'' = -x*(x'^2 + y'^2) - g*x*y", ["valid where y != 0: the accelerations are determined only there"]),
        ("(x^2 + y^2)*x'' = -x*(x'^2 + y'^2) - g*x*y", ["valid where y != 0: the accelerations are determined only there"]),
        ("x'' = -g*sin(theta)*cos(theta) - l*sin(theta)*theta'^2", ["valid where cos(theta) != 0 (multiplied by it)"]),
        ("m*x'' = 2*x*lambda_rod ; m*y'' = m*g + 2*y*lambda_rod", []),
    ],
)  # fmt: skip
def test_on_the_constraint_surface(answer: str, said: list[str]) -> None:
    assert answer in [a for a, _ in DEPENDENT]
    assert remarks("pendulum", answer) == said


def test_several_equations_may_make_up_for_one_another() -> None:
    """Two of the three pairs of components of m r'' − F ∥ ∇f fail where f_X = 0, all three nowhere."""
    found = check("ex12", _pair("x", "y"), _pair("x", "z"))
    assert any("diff(f(x, y, z), X) != 0" in r for e in found for r in e.remarks)
    found = check("ex12", _pair("x", "y"), _pair("x", "z"), _pair("y", "z"))
    assert [list(e.remarks) for e in found] == [[], [], ["redundant: it follows from those before it"]]


def _pair(a: str, b: str) -> str:
    return f"(m*{a}'' - F_{a})*diff(f(x, y, z), {b}) = (m*{b}'' - F_{b})*diff(f(x, y, z), {a})"


def check(name: str, *equations: str) -> tuple[EquationVerdict, ...]:
    return verdict_on(" ; ".join(equations), derived(name)).each


def test_right_and_wrong_together() -> None:
    found = verdict_on(
        "l*theta'' + g*sin(theta) = 0 ; theta'' = 0 ; l*theta'' = -g*sin(theta)", solved_reference("pendulum")
    )
    assert [e.verdict.value for e in found.equations.equations] == ["equivalent", "wrong", "equivalent"]
    assert found.equations.missing == 0
    assert found.verdict is Verdict.WRONG


def test_nothing_of_the_solution_is_given_away() -> None:
    for system_name, answer, verdict in TABLE.values():
        if verdict == "wrong":
            found = verdict_on(answer, solved_reference(system_name)).equations
            assert not any(re.search(r"''|\^|\*", e.at_hint_level(2).diagnosis) for e in found.equations)


def test_the_arrangement_of_several_equations_does_not_matter() -> None:
    first, second = (e.strip() for e in TABLE["14"][1].split(";"))
    for answer in ((first, second), (second, first)):
        found = verdict_on(" ; ".join(answer), solved_reference("spherical")).equations
        said = {e.text: e.remarks for e in found.equations}
        assert said == {first: (), second: ("valid where sin(theta) != 0 (divided by it)",)}


def test_fragments_are_separate_equations() -> None:
    assert [f.text for f in fragments("a = 0 ; b = 0")] == ["a = 0", "b = 0"]
