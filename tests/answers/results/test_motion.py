"""Wrong speeds, times and distances of a motion with a constant acceleration.

Wrong accelerations and reactions at the start.

Wrong times, places and motions: what happens then and there instead.
"""

from __future__ import annotations

import pytest

from tests.answers.results.diagnoses import Row, assert_explained


@pytest.mark.parametrize(
    ("stated", "said"),
    [
        ({"distance": "v^2/(2*g*sin(alpha))"}, "this is the answer without the friction `rub`"),
        ({"time": "v/(g*(sin(alpha) - mu*cos(alpha)))"}, "the friction `rub` acting the other way"),
        ({"time": "v/(g*(sin(alpha) + mu))"}, "the normal force m*g, the whole weight"),
    ],
)
def test_a_stopping_sledge(stated: object, said: str) -> None:
    assert_explained("sledge-up-a-slope", "ask", stated, said)


# Starts


WRONG: list[Row] = [
    ("rear-wheel-drive", "ask", {"behind": "m*g*c/(b + c)"}, "without the force `drive`"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_values_at_the_start(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# Instants


WRONG_INSTANTS: list[Row] = [
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
    ("thrown-stone", "ask", {"path": "x*tan(alpha) - g*x^2/(2*v^2)"}, "no division by cos(alpha)^2 in the term"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG_INSTANTS)
def test_times_places_and_motions(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# Forces of constraints


FREE = "this is the acceleration without the forces of the constraints, as if it moved freely"
OF_REACTIONS: list[Row] = [
    ("rod-cut-loose", "ask", {"falling": "-g"}, FREE),
    ("rod-cut-loose", "ask", {"turning": "0"}, FREE),
    ("rear-wheel-drive", "ask", {"greatest": "mu*m*g"}, "N_A is taken as the whole weight"),
    ("released-pendulum", "ask", {"start": "-g/l*cos(alpha)"}, "alpha measured from the perpendicular direction"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), OF_REACTIONS)
def test_reactions_left_out_or_taken_as_the_weight(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# The acceleration at the start


FIRST = "the acceleration at the start is taken as constant, but it changes"
OF_THE_START: list[Row] = [
    ("boat-that-drifts", "ask", {"in_all": "m*v/(2*b)"}, FIRST),
    ("boat-that-drifts", "ask", {"half": "m/(2*b)"}, FIRST),
    ("stone-in-linear-drag", "ask", {"time": "v/(g + c*v/m)"}, FIRST),
    ("fall-through-air", "ask", {"speed": "sqrt(2*g*h)"}, "without c, as if c = 0"),
    ("coasting-away", "ask", {"time": "3*R/sqrt(2*K/R)"}, "the velocity at the start is taken for the whole way"),
    ("wandering-energy", "ask", {"first": "a*cos(sqrt((k + c)/m)*t)"}, "the motion with y held fast"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), OF_THE_START)
def test_an_acceleration_taken_as_constant(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
