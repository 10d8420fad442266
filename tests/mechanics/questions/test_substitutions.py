"""Times with a sine as variable, against numerical integration."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp

from lagrange.mechanics.questions.quadrature import time_between
from lagrange.mechanics.questions.substitutions import in_sine

q = sp.Symbol("x", real=True)
u, v, a = sp.symbols("U v a", positive=True)
VALUES = {u: sp.Rational(3, 2), v: sp.Rational(6, 5), a: sp.Rational(7, 10)}
WELL = v**2 - u * sp.tan(a * q) ** 2


@pytest.mark.parametrize("end", [sp.atan(v / sp.sqrt(u)) / a, sp.pi / (8 * a)])
def test_the_time_is_that_of_numerical_integration(end: sp.Expr) -> None:
    time = time_between(q, sp.sqrt(WELL), sp.S.Zero, end, 1)
    assert time is not None
    most, way = (float(s.evalf(subs=VALUES)) for s in (sp.atan(v / sp.sqrt(u)) / a, end))
    square = lambda x: 1.44 - 1.5 * mpmath.tan(mpmath.mpf("0.7") * x) ** 2  # noqa: E731
    number = mpmath.quad(lambda s: 2 * s / mpmath.sqrt(abs(square(most - s**2))), [(most - way) ** 0.5, most**0.5])
    assert abs(float(time.xreplace(VALUES)) - number) < 1e-6


def test_a_sine_is_no_variable_beyond_a_right_angle() -> None:
    assert in_sine(q, WELL, sp.S.Zero, sp.pi / a) is None
    assert in_sine(q, v**2 - u * sp.cos(a * q), sp.S.Zero, sp.pi / (8 * a)) is None
