"""Units of LaTeX as plain text.

14,01 as 14.01, and no list taken for a decimal.
"""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.numbers import plain_unit, unit_behind, units_in_si, with_decimal_points
from tests.support.scopes import PLANE


def test_units_of_latex_as_text() -> None:
    assert plain_unit(r"\mathrm{m}/\mathrm{s}^{2}") == "m/s^2"


def test_feet_and_inches_may_be_spelled_out() -> None:
    for word, short in (("inches", "in"), ("feet", "ft")):
        [(_, _, written)], [(_, _, usual)] = (units_in_si(f"y = 12 {unit}", PLANE) for unit in (word, short))
        assert written == usual != ""


@pytest.mark.parametrize(
    ("text", "equation"),
    [
        ("x'' = g sin(a)   [m/s^2]", "x'' = g sin(a)"),
        ("x'' = g sin(a) (rad/s²).", "x'' = g sin(a)"),
        ("N = m g [N]", "N = m g"),
        (r"\ddot x = g \quad [\mathrm{m\,s^{-2}}]", r"\ddot x = g"),
        ("x = v (s)", "x = v (s)"),  # s is a name: a factor
        ("x = l [x + y]", "x = l [x + y]"),
        ("a = 2 [g]", "a = 2 [g]"),
        ("a = 2 [kg]", "a = 2"),
        ("theta'' = [rad/s]", "theta'' = [rad/s]"),  # nothing else is there
        ("m a = m [x''] [kg m/s^2]", "m a = m [x'']"),
    ],
)
def test_units_behind_an_equation_are_no_factors(text: str, equation: str) -> None:
    assert text[: unit_behind(text, {"s", "m", "g", "N", "l"})].rstrip() == equation


# Decimal commas


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("h = 2,5 R, v = 3", "h = 2.5 R, v = 3"),
        ("sin(0,5 x)", "sin(0.5 x)"),
        (r"\frac{2,5}{3} x_{1,2}", r"\frac{2.5}{3} x_{1,2}"),
        ("atan2(1,2) + f(1,2) + [1,2]", "atan2(1,2) + f(1,2) + [1,2]"),
        ("n = 1,2,3 and W = 10,000", "n = 1,2,3 and W = 10,000"),
    ],
)
def test_decimal_commas(text: str, written: str) -> None:
    assert with_decimal_points(text) == written
