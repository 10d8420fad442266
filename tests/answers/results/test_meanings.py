"""Other meanings of the letters of a right result.

Wrong values whose dimensions betray them.

Values and conditions that are right for bodies with other moments of inertia.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.results.meanings import other_meanings, with_waves_exchanged
from tests.answers.results.diagnoses import Row, assert_explained

W, h, b, mu = sp.symbols("W h b mu", positive=True)
alpha = sp.Symbol("alpha", real=True)


def test_one_letter_for_another_and_letters_exchanged() -> None:
    right = W * b / h
    meant = [sp.simplify(right.xreplace(dict(m.rule))) for m in other_meanings([W, b, h], [W, b, h])]
    assert sp.simplify(W * h / b) in meant
    assert all(m.clause for m in other_meanings([W, b, h], [W, b, h]))


def test_sine_for_cosine() -> None:
    [exchanged] = with_waves_exchanged([W * sp.sin(alpha) + mu * sp.cos(alpha)])
    assert (W * sp.sin(alpha)).xreplace(dict(exchanged.rule)) == W * sp.cos(alpha)


# Units


WRONG: list[Row] = [
    ("damped-oscillator", "response", {"x": "F/sqrt((c - m*w^2)^2 + b^2)"}, "its terms have different dimensions"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG)
def test_dimensions(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)


# Bodies


ROLLING = "cylinder-on-rough-incline"

WRONG_BODIES: list[Row] = [
    (ROLLING, "rest", ["tan(alpha) <= 2*mu_s"], "with the moment of inertia m*R^2 for `cylinder`, which a hoop has"),
    ("bowling-ball", "ask", {"speed": "2*v/3"}, "which a disc or solid cylinder has"),
]


@pytest.mark.parametrize(("problem", "key", "stated", "said"), WRONG_BODIES)
def test_results_for_other_bodies(problem: str, key: str, stated: object, said: str) -> None:
    assert_explained(problem, key, stated, said)
