"""Wrong conditions of rest and limits of friction: what they are the conditions of.

Several contacts with one coefficient of friction: which of them is wrong?

Wrong limits of a rope on a drum: the slips with the logarithm, worked out from T = S exp(mu beta) each.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.results.conditions import StatedCondition, belt_meanings, explained_conditions, in_logarithms
from tests.answers.results.diagnoses import LADDER, Row, assert_explained

BLOCKS = "stacked-blocks"
CRATE = "crate-tips-or-slides"
DRUM = "block-held-over-a-drum"
INCLINE = "rough-incline"

WRONG: list[Row] = [
    (INCLINE, "rest", ["P <= W*(sin(alpha) + mu_s*cos(alpha))"], "P is taken along the direction of slipping"),
    (CRATE, "rest", ["P <= mu*W", "P*c <= W*b"], "with c in place of h"),
    (CRATE, "rest", ["P <= mu*W", "P*h >= W*b"], "the inequality has the wrong sense"),
    (CRATE, "rest", ["P <= mu*W/2", "P*h <= W*b"], "the limit of P is half of what it should be"),
    (CRATE, "rest", ["mu*P <= W", "P*h <= W*b"], "with 1/mu in place of mu"),
    (LADDER, "rest", ["(1 + mu*nu)*tan(theta) <= 2*mu"], "friction with the coefficient nu that acts the other way"),
    (LADDER, "rest", ["tan(theta) <= 2*mu"], "without the friction that has the coefficient nu"),
    (LADDER, "rest", ["(1 - mu*nu)/tan(theta) <= 2*mu"], "sine and cosine of theta exchanged"),
    (
        BLOCKS,
        "rest",
        ["F <= mu_2*W_1", "F <= mu_1*(W_1 + W_2)"],
        "these are the conditions with mu_1 and mu_2 exchanged",
    ),
    (BLOCKS, "rest", ["F <= mu_1*W_1 + mu_2*(W_1 + W_2)"], "the limits of two contacts are added"),
    (BLOCKS, "rest", ["F <= mu_1*W_1", "F <= mu_2*W_2"], "without W_1"),
    (
        INCLINE,
        "rest",
        ["abs(P*cos(alpha) - W*sin(alpha)) <= mu_s*W*cos(alpha)"],
        "the term mu_s*P*sin(alpha) is missing",
    ),
    (
        INCLINE,
        "rest",
        ["W*sin(alpha) - P*cos(alpha) <= mu_s*(W*cos(alpha) + P*sin(alpha))"],
        "may act the other way as well",
    ),
    (
        DRUM,
        "rest",
        ["Q >= W*(sin(alpha) - mu*cos(alpha))", "Q <= W*(sin(alpha) + mu*cos(alpha))"],
        "the coefficient nu",
    ),
    (LADDER, "equilibrium", [["tan(theta) = 2*mu"]], "without the friction that has the coefficient nu"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_conditions(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


def test_nothing_is_said_of_a_condition_that_no_change_explains() -> None:
    force, weight, mu = sp.symbols("P W mu", positive=True)
    stated = StatedCondition("P <= W*exp(mu)", weight * sp.exp(mu) - force, equation=False)
    assert explained_conditions([stated], [mu * weight - force], [mu]) == ""


# Contacts


WRONG_CONTACTS: list[Row] = [
    (LADDER, "rest", ["tan(theta) <= mu"], "for `weight` acting at twice the distance from where the friction `below`"),
    ("cylinder-in-a-corner", "equilibrium", [["M = mu*W*r"]], "this is the limit without the friction `rub_B`"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG_CONTACTS)
def test_contacts(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# Belts


MU = sp.Symbol("mu", positive=True)
S, P, BETA = sp.symbols("S P beta", positive=True)
EXACT = P * sp.exp(MU * BETA) - S


@pytest.mark.parametrize(
    ("limit", "said"),
    [
        (sp.log(S / P) / (BETA * sp.log(10)), "base ten"),
        (sp.log(S / P) / (BETA * 180 / sp.pi), "in degrees"),
        (2 * sp.pi * sp.log(S / P) / BETA, "number of turns"),
        (sp.log(S / P) / (2 * BETA), "twice the angle"),
        (2 * sp.log(S / P) / BETA, "half of the angle"),
        ((S / P - 1) / BETA, "1 + mu*beta"),
    ],
)
def test_slips_with_the_logarithm_are_named(limit: sp.Expr, said: str) -> None:
    for right in (EXACT, MU - sp.log(S / P) / BETA):
        assert said in explained_conditions([StatedCondition("", MU - limit, False)], [right], [MU])


def test_the_exponential_is_solved_for_the_coefficient() -> None:
    assert in_logarithms(EXACT) == MU * BETA - sp.log(S / P)
    assert in_logarithms(S - P) == S - P
    assert not [*belt_meanings([S - MU * P], [MU])]


# Belts and angles of friction


WRONG_LIMITS: list[Row] = [
    (
        "band-brake",
        "equilibrium",
        [["P = M*a*exp(mu*beta)/(r*l*(exp(mu*beta) - 1))", "T_1 = M/(r*(exp(mu*beta) - 1))"]],
        "the tension of the tight side of the belt stands where that of the slack side belongs",
    ),
    ("band-brake", "equilibrium", ["P = M*a/(r*l*mu)"], "a friction mu times the tension, as of a block"),
    ("band-brake", "equilibrium", ["P = M*a/(r*l*exp(mu*beta))"], "without the tension of the slack side on the drum"),
    (
        "band-brake",
        "equilibrium",
        ["P = M*a*exp(mu*beta)/(r*l*(exp(mu*beta) - 1))"],
        "the tension of the tight side of the belt stands where that of the slack side belongs",
    ),
    ("square-threaded-screw", "equilibrium", ["M = W*r*tan(alpha + mu)"], "taken for the angle of friction"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG_LIMITS)
def test_belts_and_angles_of_friction(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
