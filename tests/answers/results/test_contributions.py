"""Wrong positions of rest, force by force: an arm, a force in one equation only, a force where it does not act."""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained

WRONG: list[Row] = [
    (
        "lorry-on-a-bridge",
        "equilibrium",
        ["P = B/2 + W*b/l", "Q = B/2 + W*(l - b)/l"],
        "l*W*cos(theta) - b*W*cos(theta) in place of b*W*cos(theta) as the contribution of the force `lorry`",
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


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_contributions_of_one_force(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
