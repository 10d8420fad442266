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
    ("leaving-a-sphere", "ask", {"speed": "sqrt(2*g*R)"}, "this is the value where theta = pi/2"),
    ("ballistic-pendulum", "ask", {"swing": "cos(theta) = 1 - m*v^2/(2*(M + m)*g*l)"}, "to be conserved in the impact"),
    ("ballistic-pendulum", "impact", {"energy_lost": "0"}, "some kinetic energy is lost here"),
    ("centre-of-percussion", "impact", {"x'": "J/m"}, "without `hinge`, as if nothing were held there"),
    ("weight-let-go-on-a-spring", "ask", {"lowest": "m*g/k"}, "the middle of the oscillation"),
    ("weight-let-go-on-a-spring", "ask", {"time": "2*pi*sqrt(m/k)"}, "it is a whole period"),
    (
        "weight-let-go-on-a-spring",
        "ask",
        {"motion": "m*g/k*cos(sqrt(k/m)*t)"},
        "at t = 0 this gives x = m*g/k and not 0",
    ),
    ("thrown-stone", "ask", {"time": "v*sin(alpha)/g"}, "then y' = 0"),
    ("thrown-stone", "ask", {"range": "v^2*sin(2*alpha)/(2*g)"}, "there y' = 0"),
    ("damped-oscillator", "response", {"x": "F/sqrt((c - m*w^2)^2 + b^2)"}, "its terms have different dimensions"),
    ("damped-oscillator", "response", {"x": "F/(b*w)"}, "at resonance"),
    ("shaken-support", "response", {"x": "a*m*w^2/sqrt((c - m*w^2)^2 + b^2*w^2)"}, "relative to the support"),
    ("ladder", "equilibrium", ["P = W/2/tan(phi)"], "sine and cosine"),
    ("inverted-pendulum-springs", "equilibrium", [["cos(theta) = W/(c*l)"]], "with l in place of b"),
    ("inverted-pendulum-springs", "equilibrium", [["cos(theta) = W*l/(2*c*b^2)"]], "as from an energy without its 1/2"),
    ("roberval-balance", "equilibrium", ["P = W*(b + d)/(b + f)"], "do not depend on d, f"),
    ("beads-on-hoop", "equilibrium", ["tan(theta) = (m_1 + m_2)/(m_1 - m_2)*tan(beta)"], "the other way round"),
    ("three-weights", "equilibrium", ["y = b*sqrt(4*P^2 - W^2)/W"], "the other way round"),
    ("lazy-tongs", "equilibrium", ["P*tan(theta) = W"], "its right side has to be multiplied by 3"),
    ("masses-on-springs", "equilibrium", ["c_1*x_1 = m_1*g", "x_2 = m_2*g/c_2"], "without the weight of `B` in the"),
    (
        "hill-moon",
        "equilibrium",
        [["r^3 = K/(2*n^2)", "phi = 0"]],
        "for a frame, support or length that does not change",
    ),
    ("triatomic-molecule", "frequencies", ["0", "sqrt(2*c/M)"], "that is the frequency of x2 with the other"),
    ("bead-on-rotating-hoop", "frequencies", [["sqrt(g/R)"]], "for a frame or support that does not move"),
    ("swinging-atwood", "reactions", {"string": "F = 2*M*m*g/(M + m)"}, "the reaction at rest where theta = 0"),
    ("swinging-atwood", "reactions", {"string": "F = M*g"}, "balances the other forces in the equation of y"),
    ("shortening-pendulum", "reactions", {"rope": "T = m*g*cos(phi)"}, "at rest with constant l"),
    (
        "charge-in-a-magnetic-field",
        "hamiltonian",
        "((p_x - q*B*y/2)^2 + (p_y + q*B*x/2)^2)/(2*m) - q*E*y",
        "for B with the",
    ),
    ("pendulum-in-wind", "reactions", {"rod": "W"}, "without F, as if F = 0"),
    ("pendulum-in-wind", "reactions", {"rod": "F + W"}, "two parts at right angles are added"),
    ("rolling-coin", "classification", ["holonomic"], "`no_slip.1` and `no_slip.2` cannot be integrated"),
    ("sphere-in-disguise", "classification", ["nonholonomic"], "`law` can be integrated"),
    ("skate-on-a-turntable", "classification", ["rheonomic"], "neither in a constraint nor in a position"),
    ("two-wheels-on-an-axle", "integrable", {"right_wheel": True}, "`right_wheel` fails Frobenius' test"),
    ("two-wheels-on-an-axle", "degrees_of_freedom", 1, "is not subtracted once more"),
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


@pytest.mark.parametrize(
    ("problem", "constraint", "stated"),
    [
        ("ex14-two-particles", "rod", "m1*((x2' - x1')^2 + (y2' - y1')^2 + (z2' - z1')^2)/l"),
        ("cylinder-in-cylinder", "rolling", "m*g*sin(phi)*3/7"),
    ],
)
def test_a_wrong_reaction_is_not_called_one_at_rest_because_all_of_it_vanishes_there(
    problem: str, constraint: str, stated: str
) -> None:
    _, diagnosis = diagnoses(problem, {"reactions": {constraint: stated}})
    assert "at rest" not in diagnosis
    assert "balances" not in diagnosis


def test_right_frequencies_in_another_list_explain_nothing() -> None:
    stated = [["sqrt(g/R - Omega^2)"], ["sqrt(Omega^2 - g/R)"]]  # the first is right, with -Omega for Omega as well
    _, diagnosis = diagnoses("bead-on-rotating-hoop", {"frequencies": stated})
    assert "Omega with the opposite sign" not in diagnosis


@pytest.mark.parametrize(
    ("problem", "answers", "where", "why"),
    [
        ("leaving-a-sphere", {"ask": {"leaves": "cos(theta) = 1/2"}}, "", "1/2 of T"),
        ("sphere-in-disguise", {"classification": ["nonholonomic", "scleronomic"]}, "not right: nonholonomic", "law"),
        ("roberval-balance", {"equilibrium": ["P = 2*W"]}, "", "twice as large"),
        ("ex14-two-particles", {"degrees_of_freedom": 6}, "", "not subtracted"),
    ],
)
def test_hint_levels_of_results(problem: str, answers: object, where: str, why: str) -> None:
    read = read_answers(Source("answers", json.dumps(answers)), loaded(problem))
    judgement = Examiner(loaded(problem), solved(problem, complete=False)).check_answers(read)
    said = [" ".join(str(judgement.at_hint_level(level)).split()) for level in (1, 2, 3)]
    assert [why in text for text in said] == [False, False, True]
    assert where in said[1]
    assert not where or where not in said[0]
    [other] = judgement.others
    assert any(why in cause for cause in other.causes)
