"""Zeros in floating point, and their confirmation with many digits."""

from __future__ import annotations

import math
from collections.abc import Sequence

import mpmath
import pytest
import sympy as sp

from lagrange.core.floats import FUNCTIONS
from lagrange.mechanics.equilibrium.searched.newton import Number, confirmed, numerical_rank, with_best, zero_near
from lagrange.mechanics.equilibrium.searched.tape import DIGITS, NoTapeError, Tape

x, y = sp.symbols("x y", real=True)


def tape(*expressions: sp.Expr) -> Tape:
    return Tape(expressions, (x, y))


def test_a_regular_zero_is_confirmed() -> None:
    """x² + y² = 2, x = y."""
    t = tape(x**2 + y**2 - 2, x - y)
    guess = zero_near(t.values, [0.3, 2.0], 10)
    assert guess == pytest.approx([1, 1])
    exact = confirmed(lambda z: t.values(z, DIGITS), guess or [])
    assert exact is not None
    assert abs(exact[0] - 1) < mpmath.mpf(10) ** -40


def test_zeros_that_fill_a_curve_are_confirmed() -> None:
    """x (x² + y² − 1) = 0 and y (x² + y² − 1) = 0: the rank drops on the circle."""
    t = tape(x * (x**2 + y**2 - 1), y * (x**2 + y**2 - 1))
    guess = zero_near(t.values, [0.9, 0.8], 10)
    assert guess is not None
    assert math.hypot(*guess) == pytest.approx(1)
    assert confirmed(lambda z: t.values(z, DIGITS), guess) is not None


@pytest.mark.parametrize("nearly", [x**2 + sp.Rational(1, 10**21), sp.exp(-(x**2)), x**4])
def test_what_is_only_small_is_not_confirmed(nearly: sp.Expr) -> None:
    t = tape(nearly, y)

    def f(z: Sequence[Number]) -> list[Number]:
        return t.values(z, DIGITS)

    guess = zero_near(t.values, [2.0, 1.0], 20) or [1e-6, 0.0]
    assert confirmed(f, guess) is None


def test_unknowns_that_occur_linearly_start_at_their_best() -> None:
    assert with_best(tape(x**2 + 3 * y - 5, x**2 + 3 * y - 5).values, [1.0, 0.0], 1) == pytest.approx([1, 4 / 3])


def test_rank() -> None:
    assert numerical_rank([[1, 2, 3], [2, 4, 6.0000000001]]) == 1
    assert numerical_rank([[1, 2], [3, 4]]) == 2
    assert numerical_rank([]) == 0


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_function_in_both_arithmetics(function: type[sp.Function]) -> None:
    e = function(x, y) if function is sp.atan2 else function(x)
    [rough], [fine] = tape(e).values([0.3, 0.7]), tape(e).values([mpmath.mpf("0.3"), mpmath.mpf("0.7")], DIGITS)
    assert float(fine) == pytest.approx(rough)


def test_powers_and_numbers() -> None:
    e = x**-2 + sp.sqrt(y) + y ** sp.Rational(-3, 2) + sp.pi * x**3 - sp.Rational(1, 3) + y**x
    assert tape(e).values([0.5, 2.0]) == pytest.approx([float(e.subs({x: 0.5, y: 2.0}))])
    with pytest.raises(ValueError, match="domain"):
        tape(sp.sqrt(x)).values([-1.0, 0.0])
    with pytest.raises(NoTapeError):
        tape(sp.Function("f")(x))
