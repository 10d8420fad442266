"""Wrong positions of equilibrium, and wrong forces that hold a system.

Wrong positions of rest, force by force: an arm, a force in one equation only, a force where it does not act.

Wrong reactions of a system at rest, as functions of the position.
"""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

WRONG: list[Row] = [
    ("ladder", "equilibrium", ["P = W/2/tan(phi)"], "sine and cosine"),
    ("inverted-pendulum-springs", "equilibrium", [["cos(theta) = W/(c*l)"]], "with l in place of b"),
    ("inverted-pendulum-springs", "equilibrium", [["cos(theta) = W*l/(2*c*b^2)"]], "as from an energy without its 1/2"),
    ("roberval-balance", "equilibrium", ["P = W*(b + d)/(b + f)"], "do not depend on d, f"),
    ("beads-on-hoop", "equilibrium", ["tan(theta) = (m_1 + m_2)/(m_1 - m_2)*tan(beta)"], "the other way round"),
    ("beads-on-hoop", "equilibrium", ["tan(theta/2) = (m_1 - m_2)/(m_1 + m_2)*tan(beta)"], "theta/2 in place of theta"),
    ("three-weights", "equilibrium", ["2*P*b/sqrt(b^2 + y^2) = W"], "y and b exchanged, the two legs"),
    ("three-weights", "equilibrium", ["y = b*sqrt(4*P^2 - W^2)/W"], "the other way round"),
    (
        "slider-crank",
        "equilibrium",
        ["P*l*sin(theta) = Q*(x - r*cos(theta))"],
        "with the contribution of the force `turning` multiplied by x/l",
    ),
    ("lazy-tongs", "equilibrium", ["P*tan(theta) = W"], "the displacement of `foot` 3 times as large as it is"),
    ("masses-on-springs", "equilibrium", ["c_1*x_1 = m_1*g", "x_2 = m_2*g/c_2"], "without the weight of `B` in the"),
    (
        "hill-moon",
        "equilibrium",
        [["r^3 = K/(2*n^2)", "phi = 0"]],
        "for a frame, support or length that does not change",
    ),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_positions_and_forces_at_rest(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# Contributions


WRONG_CONTRIBUTIONS: list[Row] = [
    (
        "lorry-on-a-bridge",
        "equilibrium",
        ["P = B/2 + W*b/l", "Q = B/2 + W*(l - b)/l"],
        "these are the equilibria with P and Q exchanged",
    ),
    ("lorry-on-a-bridge", "equilibrium", ["P = (B + W)/2", "Q = (B + W)/2"], "l*W*cos(theta)/2 in place of"),
    (
        "masses-on-springs",
        "equilibrium",
        ["x_1 = (m_1 + m_2)*g/c_1", "x_2 = (m_1 + m_2)*g/c_2"],
        "with the weight of `A`, which does not act there, in the equation of x_2",
    ),
    ("drawbridge", "equilibrium", ["P = W/2*sin(theta) - Q*cos(theta/2)"], "`load` divided by diff(f, u)"),
    (
        "three-weights",
        "equilibrium",
        ["y = b*W/(2*P)"],
        "b*W/sqrt(y^2 + b^2) in place of W as the contribution of the force `weight_in_the_middle`",
    ),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG_CONTRIBUTIONS)
def test_contributions_of_one_force(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# Displacements and factors


WRONG_ARMS: list[Row] = [
    # the connecting rod taken as level: dx = -r sin(theta) dtheta
    (
        "slider-crank",
        "equilibrium",
        ["P*sin(theta) = Q"],
        "the derivative of r^2*sin(theta)^2 with respect to theta is missing",
    ),
    ("bifilar-suspension", "equilibrium", ["M = W*a^2*sin(theta)/(2*z)"], "the weight of `bar` half as large"),
    ("lazy-tongs", "equilibrium", ["P = 3*W*tan(theta)"], "sine and cosine exchanged in the lever arm of the force"),
    ("lazy-tongs", "equilibrium", ["P*tan(theta) = 6*W"], "or for the force `draw` acting at half the distance"),
    ("roberval-balance", "equilibrium", ["P*f = W*d"], "the conditions of equilibrium do not depend on d, f"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG_ARMS)
def test_arms_and_displacements(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# Resting reactions


@pytest.mark.parametrize(
    ("stated", "said"), [("W*z/l", "the term F*x/l is missing"), ("(W*z - F*x)/l", "for F with the opposite sign")]
)
def test_a_letter_or_a_term(stated: str, said: str) -> None:
    assert_explained("pendulum-in-wind", "reactions", {"rod": stated}, said)
