"""Wrong positions of rest that satisfy another balance: derived by hand from it."""

from __future__ import annotations

import pytest

from tests.answers.models.slips import feedback_on

BALANCES = [
    ("rod-in-bowl", "a*sin(theta) = r*sin(2*theta)", "the potential energy itself vanishes there"),
    ("rod-over-peg", "b*cos(theta) = c", "the applied forces alone have no moment about O"),
    ("masses-on-springs", "x_1 = 2*(m_1 + m_2)*g/c_1;x_2 = 2*m_2*g/c_2", "the potential energy is again that at x_1"),
    (
        "masses-on-springs",
        "x_1 = (m_1 + m_2)*g/c_1;x_2 = 2*m_2*g/c_2",
        "for the force of the potential `lower_spring` half as large",
    ),
    ("lazy-tongs", "P*tan(theta) = W", "the displacement of `foot` 3 times as large as it is, or that of `top` 1/3"),
    ("lazy-tongs", "P*tan(theta) = 6*W", "the force `load` twice as large"),
    ("roberval-balance", "P = 3*W", "the displacement of `left` 3 times"),
    ("inverted-pendulum-springs", "cos(theta) = 2*W*l/(c*b^2)", "or for the spring `spring` half as large"),
]


@pytest.mark.parametrize(("problem", "stated", "said"), BALANCES)
def test_the_other_balance_is_named(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)


@pytest.mark.parametrize(
    ("problem", "stated", "said"),
    [
        ("rod-on-unequal-planes", "N_A = W*sin(alpha)/sin(alpha + beta)", "this is `N_B`, and not `N_A`"),
        ("bifilar-suspension", "M = W*a^2*sin(theta)/z;T = W", "it is the force where theta = 0 alone"),
    ],
)
def test_another_force_or_another_place_is_named(problem: str, stated: str, said: str) -> None:
    assert said in feedback_on(problem, stated)
