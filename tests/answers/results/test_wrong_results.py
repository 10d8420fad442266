"""Wrong conditions of rest, amplitudes, impacts, limits of friction, values: what is said they are.

The answers come from wrong models, worked out by a script that shares no code with the program.
"""

from __future__ import annotations

import json

import pytest
import sympy as sp

from lagrange.answers.examiner import Examiner
from lagrange.answers.results.approximate import approximate
from lagrange.answers.results.conditions import Stated, explained_conditions
from lagrange.answers.verdicts import Verdict
from lagrange.core.diagnostics import Source
from lagrange.problem.stated_answers import read_answers
from tests.support.shared import loaded, solved

CRATE, LADDER, BLOCKS = "crate-tips-or-slides", "ladder-on-rough-ground", "stacked-blocks"
INCLINE, DRUM, ROLLING = "rough-incline", "block-held-over-a-drum", "cylinder-on-rough-incline"
ABSORBER, STEP, CAUGHT = "dynamic-absorber", "disc-against-a-step", "rod-caught-at-an-end"
WHOLE = "((c_1 + c_2 - m_1*w^2)*(c_2 - m_2*w^2) - c_2^2)"
SWAPPED = "((c_1 + c_2 - m_2*w^2)*(c_2 - m_1*w^2) - c_2^2)"

REST: list[tuple[str, list[str], str]] = [
    (CRATE, ["P <= mu*W", "P*c <= W*b"], "with c in place of h"),
    (CRATE, ["P <= mu*W", "P*h >= W*b"], "the inequality has the wrong sense"),
    (CRATE, ["P <= mu*W/2", "P*h <= W*b"], "the limit of P is half of what it should be"),
    (CRATE, ["mu*P <= W", "P*h <= W*b"], "with 1/mu in place of mu"),
    (LADDER, ["(1 + mu*nu)*tan(theta) <= 2*mu"], "friction with the coefficient nu that acts the other way"),
    (LADDER, ["tan(theta) <= 2*mu"], "without the friction that has the coefficient nu"),
    (LADDER, ["(1 - mu*nu)/tan(theta) <= 2*mu"], "sine and cosine of theta exchanged"),
    (BLOCKS, ["F <= mu_2*W_1", "F <= mu_1*(W_1 + W_2)"], "these are the conditions with mu_1 and mu_2 exchanged"),
    (BLOCKS, ["F <= mu_1*W_1 + mu_2*(W_1 + W_2)"], "the limits of two contacts are added"),
    (BLOCKS, ["F <= mu_1*W_1", "F <= mu_2*W_2"], "without W_1"),
    (INCLINE, ["abs(P*cos(alpha) - W*sin(alpha)) <= mu_s*W*cos(alpha)"], "the term mu_s*P*sin(alpha) is missing"),
    (INCLINE, ["W*sin(alpha) - P*cos(alpha) <= mu_s*(W*cos(alpha) + P*sin(alpha))"], "may act the other way as well"),
    (DRUM, ["Q >= W*(sin(alpha) - mu*cos(alpha))", "Q <= W*(sin(alpha) + mu*cos(alpha))"], "the coefficient nu"),
    (ROLLING, ["tan(alpha) <= 2*mu_s"], "with the moment of inertia m*R^2 for `cylinder`, which a hoop has"),
]


def diagnoses(problem: str, answers: object) -> tuple[Verdict, str]:
    """The verdict on answers, with all that is said of them."""
    read = read_answers(Source("answers", json.dumps(answers)), loaded(problem))
    [other] = Examiner(loaded(problem), solved(problem, complete=False)).check_answers(read).others
    return other.verdict, "; ".join([other.diagnosis, *(e.diagnosis for e in other.equations)])


@pytest.mark.parametrize(("problem", "stated", "said"), REST)
def test_conditions_of_rest(problem: str, stated: list[str], said: str) -> None:
    verdict, diagnosis = diagnoses(problem, {"rest": stated})
    assert verdict in (Verdict.WRONG, Verdict.INCOMPLETE)
    assert said in diagnosis


RESULTS: list[tuple[str, str, object, str]] = [
    (LADDER, "equilibrium", [["tan(theta) = 2*mu"]], "without the friction that has the coefficient nu"),
    ("cylinder-in-a-corner", "equilibrium", [["M = mu*W*r"]], "this is the limit without the friction `rub_B`"),
    (ABSORBER, "response", {"x": f"F*c_2/{WHOLE}", "y": f"F*(c_2 - m_2*w^2)/{WHOLE}"}, "x and y are exchanged"),
    (ABSORBER, "response", {"x": f"F*(c_2 - m_1*w^2)/{SWAPPED}", "y": f"F*c_2/{SWAPPED}"}, "m_1 and m_2 exchanged"),
    (ABSORBER, "response", {"x": "F/(c_1 - m_1*w^2)"}, "without what couples x with y in the equation of x"),
    (ABSORBER, "response", {"y": f"F*(c_1 + c_2 - m_1*w^2)/{WHOLE}"}, "a drive that acts on y and not on x"),
    (STEP, "impact", {"theta'": "omega*(1 - h/(2*R))"}, "the moment of inertia m*R^2 for `disc`, which a hoop has"),
    (STEP, "impact", {"theta'": "2*omega*(R - h)/(3*R)"}, "without theta' just before the impact"),
    (STEP, "impact", {"theta'": "omega"}, "the velocity just before the impact"),
    (CAUGHT, "impact", {"theta'": "sqrt(3)*v/l"}, "the kinetic energy is taken to be conserved"),
    (CAUGHT, "impact", {"energy_lost": "m*v^2/2"}, "the whole kinetic energy just before the impact"),
    ("rear-wheel-drive", "ask", {"behind": "m*g*c/(b + c)"}, "without the force `drive`"),
    ("bowling-ball", "ask", {"speed": "2*v/3"}, "which a disc or solid cylinder has"),
    ("bead-in-a-turning-tube", "hamiltonian", "p_r^2/(2*m) + k*(r - a)^2/2 + m*r^2*Omega^2/2", "is wrong"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), RESULTS)
def test_other_results(problem: str, key: str, stated: object, said: str) -> None:
    verdict, diagnosis = diagnoses(problem, {key: stated})
    assert verdict is Verdict.WRONG
    assert said in diagnosis


def test_nothing_is_said_of_a_condition_that_no_change_explains() -> None:
    force, weight, mu = sp.symbols("P W mu", positive=True)
    stated = Stated("P <= W*exp(mu)", weight * sp.exp(mu) - force, equation=False)
    assert explained_conditions([stated], [mu * weight - force], [mu]) == ""


def test_values_in_floating_point() -> None:
    x = sp.Symbol("x")
    assert approximate(sp.sqrt(x) * sp.tan(x) / 2 + 1, {x: 1.0}) == pytest.approx(1.7787038623)
    assert str(approximate(sp.Function("f")(x), {x: 1.0})) == str(approximate(sp.sqrt(x), {x: -1.0})) == "nan"
