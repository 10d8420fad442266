"""A form that is integrable on a surface only."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.forms.restrictions import finite_form, restriction
from lagrange.core.symbols import Slots, Unspecified, t
from tests.support.exterior import real_point
from tests.support.integrability_text import words

x, y, z, w, r, theta, phi = sp.symbols("x y z w r theta phi", real=True)
a, b, length, omega, k = sp.symbols("a b l omega k", positive=True)
c, n = sp.symbols("c n", real=True)
u = sp.Symbol("u", real=True)
sin, cos, tan, exp, log, sqrt = sp.sin, sp.cos, sp.tan, sp.exp, sp.log, sp.sqrt
f = Unspecified.of("f", "XYZ", x, y, z)
VARIABLES = (x, y, z, w, r, theta, phi, t)
SLOTS = Slots(VARIABLES[:-1], (u,))
Form = dict[sp.Symbol, object]


def coefficients(form: Form) -> list[sp.Expr]:
    return [sp.sympify(form.get(v, 0)) for v in VARIABLES]


def numerical_gradient(e: sp.Expr, point: dict[sp.Symbol, sp.Expr]) -> list[sp.Float]:
    """Central differences of fifty digits."""
    h = sp.Rational(1, 10**14)

    def at(v: sp.Symbol, step: sp.Expr) -> sp.Float:
        return sp.N(e.xreplace({**point, v: point[v] + step}), 50)

    return [(at(v, h) - at(v, -h)) / (2 * h) for v in VARIABLES]


ON_SURFACES: list[tuple[str, Form, tuple[sp.Expr, ...], tuple[sp.Symbol, ...]]] = [
    ("plane", {x: 1, w: y * z}, (z,), (z,)),
    ("sphere", {x: y, y: -x, z: 1}, (x**2 + y**2 + z**2 - length**2,), (z,)),
    ("cylinder", {x: -y, y: x, z: -a}, (x**2 + y**2 - length**2,), (y,)),
    ("cylinder beside the axis", {x: -y, y: x - a, z: -a}, ((x - a) ** 2 + y**2 - length**2,), (y,)),
    ("cone", {x: -y, y: x, z: z}, (x**2 + y**2 - z**2,), (z,)),
    ("factor that vanishes", {x: 1, y: z * (x + y - w)}, (x + y - w,), (w,)),
    ("two planes", {x: 1, w: y * z}, (y - 1, z - a), (y, z)),
    ("heading held", {x: sin(theta), y: -cos(theta)}, (theta - a * x,), (theta,)),
    ("fixed height", {x: 1, y: z}, (z - sin(omega * a),), (z,)),
    ("paraboloid", {x: y, y: -x, z: z}, (z - x**2 - y**2,), (z,)),
]


@pytest.mark.parametrize(("form", "on", "solved"), [s[1:] for s in ON_SURFACES], ids=[s[0] for s in ON_SURFACES])
def test_a_form_that_is_integrable_on_a_surface_only(form, on, solved):
    """dF ∧ ω ∧ df_1 ∧ ... = 0 at real points of the surface: the rank of dF, ω, df_1, ... is one less than it could be."""
    result = finite_form(coefficients(form), Surface(on, SLOTS.coordinates), SLOTS)
    assert result is not None
    assert result.integral is not None
    assert not result.integral.free_symbols - {*VARIABLES, a, length, omega}
    symbols = {*VARIABLES, a, length, omega}
    for seed in range(1, 4):
        point = dict(real_point(on, solved, list(symbols), seed))
        rows = [numerical_gradient(result.integral, point), [sp.N(g.xreplace(point), 50) for g in coefficients(form)]]
        rows += [numerical_gradient(g, point) for g in on]
        rounded = sp.Matrix([[sp.Float(str(sp.re(e)), 50) for e in row] for row in rows])
        squares = sorted(abs(e) for e in (rounded * rounded.T).applyfunc(sp.N).eigenvals(multiple=True))
        assert squares[0] < 1e-12
        without = rounded[[0, *range(2, len(rows))], :]
        assert min(abs(e) for e in (without * without.T).applyfunc(sp.N).eigenvals(multiple=True)) > 1e-6


def test_a_factor_that_is_infinite_on_the_surface_is_not_taken():
    """z dx + x z dy = 0: e^y/z is a factor on z = x; on z = 0 the form is 0."""
    result = finite_form(coefficients({x: z, y: z * x}), Surface([z - x], SLOTS.coordinates), SLOTS)
    assert result is not None
    assert result.restriction is None
    assert finite_form(coefficients({x: z, y: z * x}), Surface([z], SLOTS.coordinates), SLOTS) is None


def test_a_surface_that_is_not_solved_by_hand():
    assert restriction(coefficients({x: 1}), [x + sin(x) + exp(y) * y], SLOTS) is None
    assert finite_form(coefficients({x: y, y: -x, z: 1}), Surface([f - c], SLOTS.coordinates), SLOTS) is None


def test_the_derivation_restricts_the_form(problem):
    said = words(problem, "{s: x^2 + y^2 = l^2, c: \"x*y' - y*x' - a*z' = 0\"}")
    assert "x = l*cos(psi) and y = l*sin(psi)" in said
    assert "atan2(y, x)" in said
