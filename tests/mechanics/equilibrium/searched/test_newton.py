"""Zeros in floating point, and their confirmation with many digits.

Expressions as lists of operations, against SymPy's own evaluation.

Numbers for parameters have the sign or the range that is declared.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import mpmath
import pytest
import sympy as sp

from lagrange.core.floats import FUNCTIONS
from lagrange.core.symbols import Bounded, Sign
from lagrange.mechanics.equilibrium.limits import BOX
from lagrange.mechanics.equilibrium.searched.newton import (
    DIGITS,
    NoTapeError,
    Number,
    Tape,
    confirmed,
    numerical_rank,
    random_start,
    random_value,
    with_best,
    zero_near,
)

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


# Tape


x_tape, y_tape = sp.symbols("x y", real=True)
EXPRESSIONS = [
    sp.Rational(2, 3) * x_tape - y_tape**-2,
    sp.sqrt(x_tape**2 + y_tape**2) / 5 + (x_tape**2 + 1) ** sp.Rational(-3, 2),
    sp.pi * sp.sin(x_tape) * sp.cos(y_tape) + sp.exp(-x_tape) + sp.Abs(y_tape),
]
AT = {x_tape: sp.Rational(7, 5), y_tape: sp.Rational(-3, 4)}


def test_floats_and_many_digits_have_the_values_of_sympy() -> None:
    tape = Tape(EXPRESSIONS, (x_tape, y_tape))
    exact = [e.xreplace(AT).evalf(50) for e in EXPRESSIONS]
    assert tape.values([1.4, -0.75]) == pytest.approx([float(e) for e in exact])
    with mpmath.workdps(50):
        by_digits = tape.values([mpmath.mpf("1.4"), mpmath.mpf("-0.75")], DIGITS)
        assert all(abs(a - mpmath.mpf(str(b))) < mpmath.mpf(10) ** -45 for a, b in zip(by_digits, exact, strict=True))


def test_what_occurs_twice_is_carried_out_once() -> None:
    once, twice = (
        Tape([sp.sin(x_tape * y_tape)], (x_tape, y_tape)),
        Tape([sp.sin(x_tape * y_tape), sp.sin(x_tape * y_tape) ** 2], (x_tape, y_tape)),
    )
    once.values([1.0, 2.0])
    twice.values([1.0, 2.0])
    assert twice.carried_out == once.carried_out + 1


def test_no_real_value_and_no_operation_are_refused() -> None:
    with pytest.raises((ValueError, ArithmeticError)):
        Tape([sp.sqrt(x_tape)], (x_tape, y_tape)).values([-1.0, 0.0])
    with pytest.raises((ValueError, ArithmeticError)):
        Tape([sp.sqrt(x_tape)], (x_tape, y_tape)).values([mpmath.mpf(-1), mpmath.mpf(0)], DIGITS)
    with pytest.raises(NoTapeError):
        Tape([sp.Function("f")(x_tape)], (x_tape, y_tape))


# Random starts


THETA, X, FORCE = sp.symbols("theta x F", real=True)


def test_parameters() -> None:
    random = Random(1)
    for _ in range(20):
        assert random_value(sp.Symbol("m", positive=True), 2, random) > 0
        assert random_value(sp.Symbol("n", negative=True), 2, random) < 0
        assert random_value(Sign("sigma"), 2, random) in (-1, 1)
        assert 0 < random_value(Bounded("alpha", sp.S.Zero, sp.pi / 2), 2, random) < 1.5708
    assert {random_value(sp.Symbol("c", real=True), 1, random) > 0 for _ in range(20)} == {True, False}


def test_places() -> None:
    random = Random(1)
    assert random_start(FORCE, [THETA, X], [THETA], random) == 0
    assert max(abs(random_start(X, [THETA, X], [THETA], random)) for _ in range(50)) <= BOX
    assert max(abs(random_start(THETA, [THETA, X], [THETA], random)) for _ in range(50)) > BOX
