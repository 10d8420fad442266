"""Values in many digits: signs are respected."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from lagrange.algebra.exact.real_points import Reals, _rough_step, _smallest_step
from lagrange.algebra.exact.zero_test import InadmissibleError, Point, Surface, has_real_point
from lagrange.core.symbols import Sign
from tests.support.points import close, real_point

x, y, theta, u, v, w = sp.symbols("x y theta u v w", real=True)
m, l, R = sp.symbols("m l R", positive=True)


def test_signs_of_symbols_are_respected(point: Point) -> None:
    negative = sp.Symbol("n", negative=True)
    sigma = Sign("sigma")
    point.require_positive(point.value(m))
    point.require_positive(-point.value(negative))
    assert close(point, point.value(sigma + 1) * point.value(sigma - 1), point.number(0))
    with pytest.raises(InadmissibleError):
        point.require_positive(point.value(-m))


def test_a_real_symbol_may_have_either_sign() -> None:
    surface = Surface()
    signs = {surface.point(n).field.sign(surface.point(n).value(x)) for n in range(30)}  # type: ignore[attr-defined]
    assert signs == {1, -1}
    assert {surface.real_point(n).value(x) > 0 for n in range(30)} == {True, False}


def test_a_difference_of_large_numbers_may_be_rounding() -> None:
    """sin(x/7919) + sin(3 x/7901) + ... over a common denominator has coefficients of 10^75."""
    here = real_point()
    one, large = here.number(1), here.number(10**75)
    with pytest.raises(InadmissibleError):
        here.is_difference_zero(one / 1000, [large, -large])
    assert not here.is_difference_zero(one / 1000, [one])
    assert here.is_difference_zero(one / large, [large])
    rounded = 0
    for n in range(10**80, 10**80 + 12):
        try:
            assert here.affine([n * ((x + sp.cos(theta)) ** 2 + u * sp.sin(x) + v * sp.cos(x))], [u, v])
        except InadmissibleError:
            rounded += 1
    assert rounded
    assert here.affine([10**75 * u**2 + v], [u, v]) is None


def test_a_system_too_steep_for_a_step() -> None:
    """Rounding may leave JᵀJ dx = −Jᵀf, of more equations than unknowns, without a solution."""

    class Rounded:
        def solution(self, *_: object) -> None:
            return None

    assert _smallest_step(Rounded(), [[1], [10**99]], [1, 1]) is None


def test_a_rough_step_is_the_smallest_one_in_sixteen_digits() -> None:
    """Of six sparse equations; none where two of them are alike, or where there are few."""
    number = real_point().number
    rows = [[number((3 * i + k) % 7 - 3 if (i + k) % 3 else 0) for k in range(9)] for i in range(6)]
    off = [number(i - 2) for i in range(6)]
    exact, rough = _smallest_step(real_point(), rows, off), _rough_step(rows, off)
    assert exact is not None
    assert rough is not None
    assert [float(x) for x in rough] == pytest.approx([float(x) for x in exact])
    assert _rough_step([*rows[:5], rows[0]], off) is None
    assert _rough_step(rows[:5], off[:5]) is None


def test_rounding_is_not_magnified_into_what_is_not_zero() -> None:
    """Where v is 10^-78, √(1/2 − √(1 − v²/4)/2) is 10^-41 by rounding, and so is acos(1 − v²/2): no such point counts."""
    reals = Reals(Random(1))
    with pytest.raises(InadmissibleError):
        reals.root(reals.number(1, 10**70))
    assert reals.root(reals.number(0)) == 0
    v = sp.Symbol("v", positive=True)
    halved = sp.sin(sp.acos(1 - v**2 / 2) / 4) - sp.sqrt(sp.Rational(1, 2) - sp.sqrt(4 - v**2) / 4)
    assert {Surface().is_zero(halved) for _ in range(3)} == {None}


def test_a_position_where_several_angles_vanish_is_reached() -> None:
    """On the way there the product of their sines soon becomes too small to distinguish from zero, which decides nothing."""
    x, y, z = sp.symbols("x y z", real=True)
    product = sp.sin(x) * sp.sin(y) * sp.sin(z)
    constraints = (sp.sin(x) + product, sp.sin(y) - 2 * product, sp.sin(z) + sp.sin(x) * sp.sin(y) + 3 * product)
    surface = Surface(constraints, (x, y, z))
    assert has_real_point(surface)
