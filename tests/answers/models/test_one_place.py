"""Values that differ from the right one in one place: what each answer is was worked out from the slip, by hand."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.models.one_place import of_arguments, of_damping, of_one_place, wrong_square
from lagrange.answers.models.questions import explained_value

a, b, c, g, k, l, m, M, alpha = sp.symbols("a b c g k l m M alpha", positive=True)
t = sp.Symbol("t", real=True)


@pytest.mark.parametrize(
    ("claim", "right", "said"),
    [
        (3 * c / m + 3 * g / (2 * l), 3 * c * a**2 / (m * l**2) + 3 * g / (2 * l), "l stands where a belongs"),
        (sp.sqrt(g * (M - m) / (M + m)), sp.sqrt(g * (M - m * sp.sin(alpha)) / (M + m)), "a factor sin(alpha)"),
        (c / (m + M), c * (m + M) / (m * M), "the reduced mass"),
        (c / m, c * (m + M) / (m * M), "the reduced mass"),
        (c / m + k / m, c / m + 2 * k / m, "half the term 2*k/m"),
    ],
)
def test_a_letter_or_factor_of_one_term(claim: sp.Expr, right: sp.Expr, said: str) -> None:
    assert said in next(of_one_place(claim, right), "")


@pytest.mark.parametrize(
    ("claim", "right", "said"),
    [
        (a * sp.cos(sp.sqrt(m / k) * t), a * sp.cos(sp.sqrt(k / m) * t), "the other way round"),
        (a * alpha + b, a * sp.sin(alpha) + b, "as for a small angle"),
        (a * sp.exp(b) + c, a * sp.exp(-b) + c, "the sign of the exponent"),
        (a * sp.sin(2 * alpha) + c, a * sp.cos(2 * alpha) + c, "sine and cosine are exchanged"),
    ],
)
def test_an_argument_or_a_function(claim: sp.Expr, right: sp.Expr, said: str) -> None:
    assert said in next(of_arguments(claim, right), "")


def test_a_change_that_divides_by_zero_does_not_end_the_search() -> None:
    assert explained_value(3 * c / m + 3 * g / (2 * l), 3 * c * a**2 / (m * l**2) + 3 * g / (2 * l), set())


def test_nothing_is_said_of_two_changes_or_none() -> None:
    assert not [*of_one_place(2 * c / m + 3 * k / l, c / m + k / m)]
    assert not [*of_one_place(c / m + k / m, c / m + k / m)]
    assert not [*of_arguments(a * sp.cos(t), a * sp.cos(t))]


def test_squares_of_frequencies_and_decay_rates() -> None:
    squares = [c / m, c / m + 2 * k / m]
    assert "2*k/m" in wrong_square(c / m + k / m, squares[1:], {})
    assert "2 times" in of_damping(b / (2 * m), b / m, squared=False)
    assert "a quarter of the term b^2/m^2" in of_damping(c / m - b**2 / (4 * m**2), c / m - b**2 / m**2, squared=True)
