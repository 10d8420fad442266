"""Dimensions that follow because equations are homogeneous."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import Unspecified, prime, t
from lagrange.core.units import unit_called, unit_of
from lagrange.values.homogeneity import Homogeneity

m, g, x, y, phi, k, c = sp.symbols("m g x y phi k c", real=True)


def known(**units: str) -> Homogeneity:
    read = {name: unit_of(unit) for name, unit in units.items()}
    return Homogeneity({sp.Symbol(n, real=True): u.dimension for n, u in read.items() if u is not None})


def called(found: Homogeneity, e: sp.Expr) -> str | None:
    dimension = found.dimension(e)
    return None if dimension is None else unit_called(dimension) or "1"


def test_terms_of_a_sum_have_one_dimension() -> None:
    found = known(m="kg", x="m")
    assert found.dimension(k) is None
    found.exponents(m * prime(x, 2) + k * x + c * prime(x) + m * g)
    assert [called(found, e) for e in (k, c, g, k * x**2)] == ["N/m", "N s/m", "m/s^2", "N m"]


def test_what_is_learned_later_completes_what_was_read_before() -> None:
    found = known(x="m")
    found.equal(k * y, x)
    assert found.dimension(y) is None
    found.equal(k, sp.sqrt(x))
    assert found.dimension(y) == (0, sp.Rational(1, 2), 0, 0, 0)


def test_arguments_of_waves_are_numbers() -> None:
    found = known(x="m")
    found.exponents(sp.sin(k * x - c * t) + sp.cos(phi))
    assert [called(found, e) for e in (k, c, phi, prime(phi))] == ["m^-1", "s^-1", "1", "s^-1"]


def test_a_function_of_which_nothing_is_known_and_its_slope() -> None:
    found = known(x="m", y="m", m="kg")
    f = Unspecified.of("f", ("x",), x)
    found.equal(y, f)
    slope = Unspecified(*f.args[:2], sp.Tuple(1), x)
    assert [called(found, e) for e in (f, slope, m * slope)] == ["m", "1", "kg"]


def test_a_large_number_may_hide_a_unit() -> None:
    found = known(m="kg", x="m")
    found.exponents(10 * m + k)  # 10 m/s^2: k is a force
    assert found.dimension(k) is None


def test_contradictory_terms_have_no_dimension() -> None:
    found = known(m="kg", x="m")
    assert found.dimension(m + x) is None
    assert called(found, m) == "kg"
