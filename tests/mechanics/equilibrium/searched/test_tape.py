"""Expressions as lists of operations, against SymPy's own evaluation."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from lagrange.mechanics.equilibrium.searched.tape import DIGITS, NoTapeError, Tape

x, y = sp.symbols("x y", real=True)
EXPRESSIONS = [
    sp.Rational(2, 3) * x - y**-2,
    sp.sqrt(x**2 + y**2) / 5 + (x**2 + 1) ** sp.Rational(-3, 2),
    sp.pi * sp.sin(x) * sp.cos(y) + sp.exp(-x) + sp.Abs(y),
]
AT = {x: sp.Rational(7, 5), y: sp.Rational(-3, 4)}


def test_floats_and_many_digits_have_the_values_of_sympy() -> None:
    tape = Tape(EXPRESSIONS, (x, y))
    exact = [e.xreplace(AT).evalf(50) for e in EXPRESSIONS]
    assert tape.values([1.4, -0.75]) == pytest.approx([float(e) for e in exact])
    with mpmath.workdps(50):
        by_digits = tape.values([mpmath.mpf("1.4"), mpmath.mpf("-0.75")], DIGITS)
        assert all(abs(a - mpmath.mpf(str(b))) < mpmath.mpf(10) ** -45 for a, b in zip(by_digits, exact, strict=True))


def test_what_occurs_twice_is_carried_out_once() -> None:
    once, twice = Tape([sp.sin(x * y)], (x, y)), Tape([sp.sin(x * y), sp.sin(x * y) ** 2], (x, y))
    once.values([1.0, 2.0])
    twice.values([1.0, 2.0])
    assert twice.carried_out == once.carried_out + 1


def test_no_real_value_and_no_operation_are_refused() -> None:
    with pytest.raises((ValueError, ArithmeticError)):
        Tape([sp.sqrt(x)], (x, y)).values([-1.0, 0.0])
    with pytest.raises((ValueError, ArithmeticError)):
        Tape([sp.sqrt(x)], (x, y)).values([mpmath.mpf(-1), mpmath.mpf(0)], DIGITS)
    with pytest.raises(NoTapeError):
        Tape([sp.Function("f")(x)], (x, y))
