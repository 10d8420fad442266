"""What a wrong equation is: a first integral, the square of a right one."""

from __future__ import annotations

import pytest
import sympy as sp
from mpmath import mp, mpf

from lagrange.answers.equations import Verdict
from lagrange.answers.recognition import integrals_apart
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Recognised
from tests.answers.test_equations import solved_reference, verdict_on
from tests.support.answer_truth import read
from tests.support.second_route import affine, number, solved
from tests.truth.test_random_answers import system

ENERGY, MOMENTUM = "first integral, that of energy", "first integral, that of a momentum"
ONE, MORE = "its time derivative is the equation asked for", "its time derivative follows from the equations asked for"
WHAT = [
    ("pendulum", "(theta'' + g/l*sin(theta))^2 = 0", "the square of a correct equation"),
    ("pendulum", "(l*theta'' + g*sin(theta))^3 = 0", "a power, or a product"),
    ("pendulum", "theta''^2 = (g/l*sin(theta))^2", "though it holds for the motion"),
    ("pendulum", "theta''*(theta'' + g/l*sin(theta)) = 0", "though it holds for the motion"),
    ("pendulum", "theta''^2 + g/l*sin(theta) = 0", "not linear in the accelerations, as an equation of motion must be"),
    ("kepler", "(r'' - r*phi'^2 + k/(m*r^2))^2 + (r*phi'' + 2*r'*phi')^2 = 0", "composed of squares"),
    ("kepler", "(r'' - r*phi'^2 + k/(m*r^2))*(r*phi'' + 2*r'*phi') = 0", "composed of squares"),
    ("pendulum", "theta'^2/2 - g/l*cos(theta) = m", f"{ENERGY}; {ONE}"),
    ("pendulum", "theta'^2/2 - g/l*cos(theta) = const", f"{ENERGY}; {ONE}"),
    ("pendulum", "m*l^2*theta'^2/2 - m*g*l*cos(theta) = const", f"{ENERGY}; {ONE}"),
    ("pendulum", "theta' = sqrt(2*g/l*cos(theta) + const)", f"{ENERGY}; {ONE}"),
    ("pendulum", "theta' = -sqrt(2*g/l*cos(theta) + const)", f"{ENERGY}; {ONE}"),
    ("kepler", "m*r^2*phi' = L", f"{MOMENTUM}; {MORE}"),
    ("kepler", "phi' = L/(m*r^2)", f"{MOMENTUM}; {MORE}"),
    ("kepler", "m*(r'^2 + r^2*phi'^2)/2 - k/r = const", f"{ENERGY}; {MORE}"),
    ("kepler", "m*r^3*phi'^2*cos(phi) + m*r^2*r'*phi'*sin(phi) - k*cos(phi) = const", f"it is a first integral; {MORE}"),
    ("cart", "(M + m)*x' + m*l*theta'*cos(theta) = const", f"{MOMENTUM}; {MORE}"),
    ("beadwire", "r'^2 - omega^2*r^2 = const", f"{ENERGY}; {ONE}"),
    ("pendulum", "theta'^2/2 + g/l*cos(theta) = const", "it contains no acceleration"),
    ("kepler", "m*r*phi' = L", "it contains no acceleration"),
    ("pendulum", "theta' = 0", "it contains no acceleration"),
    ("pendulum", "theta = 0", "it contains no acceleration"),
    ("pendulum", "m = l", "it says nothing about the motion"),
    ("pendulum", "1 = 0", "it can never hold"),
    ("pendulum", "2*theta'' + theta'^3 = 3*cos(theta)^3", "it does not follow from the equations of motion"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "answer", "said"), WHAT)
def test_what_a_wrong_equation_is(name: str, answer: str, said: str) -> None:
    (found,) = verdict_on(answer, solved_reference(name)).equations.equations
    assert found.verdict is Verdict.WRONG
    assert said in found.diagnosis


@pytest.mark.parametrize(("name", "answer", "said"), [r for r in WHAT if "first" in r[2] and "-sqrt" not in r[1]])
def test_a_first_integral_is_constant_by_numbers(name: str, answer: str, said: str) -> None:
    """Solved for its constant, its derivative vanishes with the accelerations of the second route."""
    route, _ = system(name)
    e = read(answer)
    (c,) = [s for s in e.free_symbols if s.name in ("const", "L")] or [sp.Symbol("m")]
    function = sp.solve(e, c)[0]
    rates = {sp.Symbol(q): sp.Symbol(f"{q}'") for q in route.coordinates}
    rates |= {sp.Symbol(f"{q}'"): sp.Symbol(f"{q}''") for q in route.coordinates}
    rate = sp.Add(*(function.diff(s) * r for s, r in rates.items()))
    names = {s.name for x in (*route.system, rate) for s in x.free_symbols} - {*route.unknowns}
    with mp.workdps(60):
        state = {n: mpf(5 + 3 * k) / 11 for k, n in enumerate(sorted(names))}
        values = solved(affine(list(route.system), route.unknowns, state), route.unknowns).values
        assert abs(number(rate, {**state, **values})) < 1e-40, said


def test_a_first_integral_beside_a_wrong_equation_is_not_wrong() -> None:
    wrong = EquationVerdict("a", Verdict.WRONG, kind=Recognised.OTHER)
    integral = EquationVerdict("b", Verdict.WRONG, kind=Recognised.MOMENTUM)
    together = integrals_apart(AnswerVerdict(Verdict.WRONG, (wrong, integral)))
    assert together.verdict is Verdict.WRONG
    assert [e.verdict for e in together.equations] == [Verdict.WRONG, Verdict.TRIVIAL]
    alone = AnswerVerdict(Verdict.WRONG, (integral,))
    assert integrals_apart(alone) == alone
