"""Orbits round a centre as functions of the angle, against integration by numbers and by hand."""

from __future__ import annotations

import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from lagrange.core.symbols import prime
from lagrange.mechanics.questions.branches import sign_of_value
from lagrange.mechanics.questions.orbits import Orbit, orbit

r, phi = sp.Symbol("r", real=True), sp.Symbol("phi", real=True)
K, c, a, e = sp.symbols("K c a e", positive=True)
VALUES = {K: 1.7, c: 0.2, a: 1.3, e: 0.4}


def _orbit(force: sp.Expr, outward: sp.Expr, around: sp.Expr, turning: sp.Expr = sp.S.One) -> Orbit | None:
    rates = {
        prime(r, 2): turning * r * prime(phi) ** 2 + force,
        prime(phi, 2): -2 * prime(r) * prime(phi) / r,
    }
    start = {r: a, phi: sp.S.Zero, prime(r): outward, prime(phi): around}
    return orbit(rates, start, (phi, r), sign_of_value)


@pytest.mark.parametrize(
    ("force", "outward", "around", "turning"),
    [
        (-K / r**2, sp.S.Zero, sp.sqrt(K * (1 + e) / a**3), sp.S.One),  # Kepler
        (-K / r**2, sp.sqrt(K / a) / 3, sp.sqrt(K / a**3), sp.S.One),
        (-K / r**2 + 2 * c / r**3, sp.S.Zero, sp.sqrt(K / a**3), sp.S.One),  # the apsides turn
        (-K / r**3, sp.S.Zero, sp.sqrt(K) / (2 * a**2), sp.S.One),  # hyperbolic functions
        (-K / r**3, -sp.sqrt(K) / a, sp.sqrt(K) / a**2, sp.S.One),  # r = a/(1 + φ)
        (-K / r**2, sp.S.Zero, sp.sqrt(K * (1 + e) / a**3), sp.Rational(1, 4)),  # as on a developable surface
    ],
)
def test_the_orbit_is_that_of_integration(force: sp.Expr, outward: sp.Expr, around: sp.Expr, turning: sp.Expr) -> None:
    found = _orbit(force, outward, around, turning)
    assert found is not None
    pull = sp.lambdify(r, force.xreplace(VALUES), "math")
    share = float(turning)
    start = [float(x.xreplace(VALUES)) for x in (a, sp.S.Zero, outward, around)]
    run = solve_ivp(
        lambda _, y: [y[2], y[3], share * y[0] * y[3] ** 2 + pull(y[0]), -2 * y[2] * y[3] / y[0]],
        (0, 0.6),
        start,
        rtol=1e-10,
        atol=1e-12,
    )
    distance, angle, speed, rate = (float(x[-1]) for x in run.y)
    for symbol, expected in ((r, distance), (prime(r), speed), (prime(phi), rate)):
        assert float(found.state[symbol].xreplace({**VALUES, phi: angle})) == pytest.approx(expected, rel=1e-6)


def test_other_fields_and_straight_lines_have_none() -> None:
    assert _orbit(-K * r, sp.S.Zero, sp.sqrt(K)) is None  # a spring: 1/r² is a wave, and not 1/r
    assert _orbit(-K / r**2, sp.S.One, sp.S.Zero) is None  # no angular momentum


def test_the_far_end_of_an_ellipse_is_reached_where_it_is_one() -> None:
    ellipse = _orbit(-K / r**2, sp.S.Zero, sp.sqrt(K * (1 + e) / a**3))
    assert ellipse is not None
    conditions = ellipse.lasts(sp.pi, sign_of_value)
    assert conditions is not None
    assert [str(x.lhs - x.rhs) for x in conditions] in (["1 - e"], ["-e + 1"])
    assert ellipse.lasts(sp.pi / 2, sign_of_value) == ()  # also on a parabola or hyperbola
    assert ellipse.lasts(-sp.pi / 2, sign_of_value) is None  # the other way round
    hyperbola = _orbit(-K / r**2, sp.S.Zero, sp.sqrt(3 * K / a**3))
    assert hyperbola is not None
    assert hyperbola.lasts(sp.pi, sign_of_value) is None


def test_the_apsidal_angle_is_found() -> None:
    found = _orbit(-K / r**3, sp.S.Zero, 2 * sp.sqrt(K) / a**2)  # k = 3/4: flung out, φ → π/√3 only in the limit
    assert found is not None
    places = found.places(prime(r) - sp.sqrt(3 * K) / a * sp.sin(sp.pi / 4), sign_of_value)
    assert places is not None  # r' = h √k/a sin √k φ
    assert [sp.nsimplify(p - sp.pi / (2 * sp.sqrt(3))) for p, _ in places] == [0]
