"""Identities, near misses and what must stay undecided."""

from __future__ import annotations

import operator
from functools import reduce

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    Fields,
    Surface,
    are_equal,
    is_zero,
    kept_surface,
    process_fields,
    rank,
)
from lagrange.core.effort import allowed
from lagrange.core.symbols import Sign, Slots, Unspecified, prime
from tests.support.chance import examples

x, y, z, theta, phi, t = sp.symbols("x y z theta phi t", real=True)
m, l, g, k, omega = sp.symbols("m l g k omega", positive=True)
sigma, tau = Sign("sigma"), Sign("tau")
sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi
half = sp.Rational(1, 2)


def raw(function: type, *arguments: sp.Expr) -> sp.Expr:
    return function(*arguments, evaluate=False)


IDENTITIES = {
    "pythagoras": sin(theta) ** 2 + cos(theta) ** 2 - 1,
    "double angle": sin(2 * theta) - 2 * sin(theta) * cos(theta),
    "triple angle": cos(3 * theta) - 4 * cos(theta) ** 3 + 3 * cos(theta),
    "half angle": sin(theta) - 2 * sin(theta / 2) * cos(theta / 2),
    "half angle before the angle": 2 * cos(theta / 2) ** 2 - 1 - cos(theta),
    "third of an angle": sin(theta) - 3 * sin(theta / 3) + 4 * sin(theta / 3) ** 3,
    "sum of angles": cos(theta - phi) - cos(theta) * cos(phi) - sin(theta) * sin(phi),
    "tangent": tan(theta / 2) - (1 - cos(theta)) / sin(theta),
    "cotangent": sp.cot(theta) * tan(theta) - 1,
    "secant": sp.sec(theta) ** 2 - 1 - tan(theta) ** 2,
    "cosecant": sp.csc(theta) * sin(theta) - 1,
    "product of parameters in the angle": sin(2 * omega * t) - 2 * sin(omega * t) * cos(omega * t),
    "quotients in the angle": cos(x / (l + k) * l + x / (l + k) * k) - cos(x),
    "pi/12": cos(theta + pi / 12) - cos(theta) * (sqrt(6) + sqrt(2)) / 4 + sin(theta) * (sqrt(6) - sqrt(2)) / 4,
    "pi/5": raw(cos, pi / 5) - (1 + sqrt(5)) / 4,
    "pi/60": sin(theta + pi / 60) * 2 * cos(theta - pi / 60) - sin(2 * theta) - sin(pi / 30),
    "pi/7": cos(pi / 7) - cos(2 * pi / 7) + cos(3 * pi / 7) - half,
    "23-gon": reduce(operator.add, (cos(2 * pi * j / 23) for j in range(1, 12))) + half,
    "turn by 2 pi": raw(sin, theta + 2 * pi) - sin(theta),
    "hyperbolic": sp.cosh(x) ** 2 - sp.sinh(x) ** 2 - 1,
    "hyperbolic tangent": sp.tanh(2 * x) - 2 * sp.tanh(x) / (1 + sp.tanh(x) ** 2),
    "exponentials": sp.exp(x + 2 * y) - sp.exp(x) * sp.exp(y) ** 2,
    "exponential and hyperbolic": sp.exp(x) - sp.cosh(x) - sp.sinh(x),
    "symbolic exponent": l ** (k + 1) / l - l**k,
    "roots of numbers": sqrt(6) - raw(sp.Mul, sqrt(2), sqrt(3)),
    "roots of large primes": raw(sp.Mul, sqrt(109), sqrt(113)) - sqrt(109 * 113),
    "root of a decimal": sqrt(sp.Rational(981, 200)) ** 2 - sp.Rational(981, 200),
    "roots of parameters": sqrt(4 * g / l) - 2 * sqrt(g) / sqrt(l),
    "cube roots": ((l + m) ** 2) ** sp.Rational(1, 3) - raw(sp.Pow, (l + m) ** sp.Rational(1, 3), 2),
    "nested root": sqrt(2 + sqrt(3)) - (sqrt(6) + sqrt(2)) / 2,
    "root of a square of positives": sqrt(l**2 + 2 * l * m + m**2) - l - m,
    "root of a square": raw(sp.Pow, x**2, half) - sp.Abs(x),
    "root of a square, expanded": sqrt(x**2 + 2 * x + 1) - sp.Abs(x + 1),
    "one root": sqrt(l**2 - y**2) - (l**2 - y**2) / sqrt(l**2 - y**2),
    "product of roots": sqrt(l**2 - y**2) * sqrt(l**2 + y**2) - sqrt(l**4 - y**4),
    "root and sine": sqrt(1 - cos(theta) ** 2) - sp.Abs(sin(theta)),
    "absolute value of what is positive": sp.Abs(cos(theta) - 2) + cos(theta) - 2,
    "absolute values": sp.Abs(x) * sp.Abs(y) - sp.Abs(x * y),
    "sign": sp.sign(x) * sp.Abs(x) - x,
    "sign of what is positive": sp.sign(2 + sin(theta)) - 1,
    "sign symbols": sigma**3 * tau - sigma * tau,
    "sign symbols in a sum": (sigma + tau) ** 2 - raw(sp.Mul, 2, 1 + sigma * tau),
    "arc tangents": sp.atan(l) + sp.atan(1 / l) - pi / 2,
    "arc sine and cosine": sp.asin(x) + sp.acos(x) - pi / 2,
    "arc tangent of two": sp.atan2(k * y, k * x) - sp.atan2(y, x),
    "odd function": sp.atan(x - y) + raw(sp.atan, y - x),
    "logarithms": sp.log(l * m + m) - sp.log(m) - sp.log(l + 1),
    "logarithms in a divisor": 1 / sp.log(l / m) - 1 / (sp.log(l) - sp.log(m)),
    "logarithms with factors": x * (sp.log(l * m) - sp.log(m)) - x * sp.log(l),
    "root in an angle": cos(2 * sqrt(k / m) * t) - 2 * cos(sqrt(k / m) * t) ** 2 + 1,
    "sum of roots in an angle": cos(sqrt(l**2 + x**2) * t + theta)
    - cos(sqrt(l**2 + x**2) * t) * cos(theta)
    + sin(sqrt(l**2 + x**2) * t) * sin(theta),
    "function in an angle": cos(sin(theta) ** 2 + cos(theta) ** 2) - cos(1),
    "undefined function": Unspecified.of("f", "XY", x - k * t, y) - Unspecified.of("f", "XY", -(k * t - x), y),
    "mixed derivatives": Unspecified.of("f", "XY", x, y).diff(x).diff(y) - Unspecified.of("f", "XY", x, y).diff(y, x),
}


@pytest.mark.parametrize("identity", IDENTITIES.values(), ids=IDENTITIES.keys())
def test_identity(identity: sp.Expr) -> None:
    assert is_zero(identity) is True


@pytest.mark.parametrize("identity", IDENTITIES.values(), ids=IDENTITIES.keys())
def test_identity_with_a_small_error_is_none(identity: sp.Expr) -> None:
    assert is_zero(identity + sp.Rational(1, 10**12)) is False
    assert is_zero(identity + x / 10**12) is False


NOT_ZERO = {
    "sine and angle": sin(theta) - theta,
    "cosine and one": cos(theta) - 1,
    "angles apart": cos(x) * cos(y) - cos(x + y),
    "sine and cosine": sin(theta) - cos(theta),
    "pi by Metius": pi - sp.Rational(355, 113),
    "pi to thirty digits": pi - sp.Rational(314159265358979323846264338327, 10**29),
    "e to twenty digits": sp.E - sp.Rational(271828182845904523536, 10**20),
    "a third": sp.Rational(1, 3) - sp.Rational(33333333333333333333, 10**20),
    "thirty digits": x * (1 + sp.Rational(1, 10**30)) - x,
    "almost a root": sqrt(2) - sp.Rational(14142135623730950488016887242, 10**28),
    "almost a nested root": sqrt(2 + sqrt(3)) - (sqrt(6) + sqrt(2)) / 2 - sp.Rational(1, 10**25),
    "absolute value of a real": sp.Abs(x) - x,
    "absolute value of a real, negative": sp.Abs(x) + x,
    "root of the square of a real": sqrt(x**2 + 2 * x * y + y**2) - x - y,
    "wrong branch": sqrt(l**2 - 2 * l * m + m**2) - l + m,
    "wrong branch of a number": sqrt(2 + sqrt(3)) + (sqrt(6) + sqrt(2)) / 2,
    "conjugate root": sqrt(3 - 2 * sqrt(2)) - 1 + sqrt(2),
    "half angle with a root": sqrt((1 - cos(theta)) / 2) - sin(theta / 2),
    "sum of roots": sqrt(l**2 + m**2) - l - m,
    "far from the origin": sp.Abs(x - 1000) + x - 1000,
    "between two roots": sp.Abs((x - 10) * (x - 11)) - (x - 10) * (x - 11),
    "inside a small circle": sp.Abs(x**2 + y**2 - sp.Rational(1, 100)) - x**2 - y**2 + sp.Rational(1, 100),
    "sign of a sine": sp.sign(sin(theta)) - 1,
    "one of two signs": sigma - 1,
    "product of signs": sigma * tau - 1,
    "one combination of signs": (1 + sigma) * (1 + tau),
    "arc tangent of two quadrants": sp.atan2(y, x) - sp.atan(y / x),
    "arc tangents of a real": sp.atan(x) + sp.atan(1 / x) - pi / 2,
    "neighbouring arc tangents": sp.atan(x) - sp.atan(x + sp.Rational(1, 10**12)),
    "undefined function": Unspecified.of("f", "X", x) - Unspecified.of("f", "X", x + y),
    "function and derivative": Unspecified.of("f", "X", x).diff(x) - Unspecified.of("f", "X", x),
    "two functions": Unspecified.of("f", "X", x) - Unspecified.of("h", "X", x),
    "pi/25": raw(cos, pi / 25) - raw(cos, 24 * pi / 25),
    "velocity": prime(theta) - prime(theta, 2),
}


@pytest.mark.parametrize("expression", NOT_ZERO.values(), ids=NOT_ZERO.keys())
def test_not_zero(expression: sp.Expr) -> None:
    assert is_zero(expression) is False


UNDECIDED = {
    "piecewise": sp.Piecewise((x, x > 0), (0, True)),
    "float": sp.Float("0.1") * x - sp.Float("0.1") * y,
    "maximum": sp.Max(x, y),
    "unknown function": sp.gamma(x) - 1,
    "imaginary": sp.I * x,
    "missed dependence of angles": cos(sqrt(l**2 + 2 * l * k + k**2)) - cos(l) * cos(k) + sin(l) * sin(k),
    "missed addition theorem": tan(sp.atan(x) + theta) * (1 - x * tan(theta)) - x - tan(theta),
}


@pytest.mark.parametrize("expression", UNDECIDED.values(), ids=UNDECIDED.keys())
def test_undecided_is_none_and_not_false(expression: sp.Expr) -> None:
    assert is_zero(expression) is None
    assert rank([[expression, 0], [0, 1]]) is None


@pytest.mark.parametrize(
    ("expression", "denominator"),
    [
        (1 / (cos(2 * theta) - 2 * cos(theta) ** 2 + 1), cos(2 * theta) - 2 * cos(theta) ** 2 + 1),
        (x + y / (sin(theta) ** 2 + cos(theta) ** 2 - 1) ** 2, sin(theta) ** 2 + cos(theta) ** 2 - 1),
        (tan(theta) / (tan(theta) * cos(theta) - sin(theta)), tan(theta) * cos(theta) - sin(theta)),
        (y / ((x + 1) ** 2 - x**2 - 2 * x - 1), (x + 1) ** 2 - x**2 - 2 * x - 1),
    ],
)
def test_division_by_what_is_zero_is_reported(expression: sp.Expr, denominator: sp.Expr) -> None:
    with pytest.raises(DivisionByZeroError) as caught:
        is_zero(expression)
    assert caught.value.denominator == denominator


def test_division_by_zero_for_positive_parameters_only() -> None:
    with pytest.raises(DivisionByZeroError):
        is_zero(1 / (sqrt(l**2 + 2 * l * m + m**2) - l - m))


def test_division_by_zero_on_a_surface() -> None:
    surface = Surface([z], [x, y, z])
    with pytest.raises(DivisionByZeroError) as caught:
        surface.is_zero(x / z)
    assert caught.value.denominator == z
    assert Surface().is_zero(x / z) is False


def test_a_written_infinity_is_a_division_by_zero() -> None:
    with pytest.raises(DivisionByZeroError):
        is_zero(sp.zoo)


def test_a_denominator_that_vanishes_here_and_there_is_none() -> None:
    assert is_zero(1 / (sp.Abs(x) - x)) is False  # for x < 0
    assert is_zero((1 + sigma) / (1 + sigma) - 1) is True


# Sizes.


def chain(n: int) -> tuple[Slots, list[sp.Expr], list[sp.Expr]]:
    """The n-link pendulum: Lagrange's equations as they come, and in the form of a textbook."""
    q = [sp.Symbol(f"q{i}", real=True) for i in range(n)]
    slots = Slots(tuple(q))
    v, w = slots.velocities, slots.accelerations
    masses = [sp.Symbol(f"m{i}", positive=True) for i in range(n)]
    rods = [sp.Symbol(f"l{i}", positive=True) for i in range(n)]
    x = [sp.Add(*(rods[j] * sin(q[j]) for j in range(i + 1))) for i in range(n)]
    y = [-sp.Add(*(rods[j] * cos(q[j]) for j in range(i + 1))) for i in range(n)]
    d = slots.time_derivative
    lagrangian = sp.Add(*(masses[i] * ((d(x[i]) ** 2 + d(y[i]) ** 2) / 2 - g * y[i]) for i in range(n)))
    derived = [d(lagrangian.diff(v[i])) - lagrangian.diff(q[i]) for i in range(n)]
    textbook = []
    for i in range(n):
        terms = [
            sp.Add(*masses[max(i, j) :]) * rods[i] * rods[j] * (w[j] * cos(q[i] - q[j]) + v[j] ** 2 * sin(q[i] - q[j]))
            for j in range(n)
        ]
        textbook.append(sp.Add(*terms, sp.Add(*masses[i:]) * g * rods[i] * sin(q[i])))
    return slots, derived, textbook


@pytest.mark.parametrize("n", [2, 8])
def test_pendulum_chain_as_derived_and_as_printed(n: int) -> None:
    slots, derived, textbook = chain(n)
    surface = Surface()
    assert [surface.are_equal(*pair) for pair in zip(derived, textbook, strict=True)] == [True] * n
    wrong = textbook[0].subs(g, -g)
    assert surface.are_equal(derived[0], wrong) is False
    assert surface.are_equal(derived[0], textbook[0] + slots.accelerations[0] / 10**12) is False


# Ranks.


def test_rank_of_matrices() -> None:
    assert rank(sp.Matrix([[1, 2], [2, 4]])) == 1
    assert rank(sp.Matrix([[cos(theta), sin(theta)], [-sin(theta), cos(theta)]])) == 2
    assert rank([[cos(2 * theta), 1], [2 * cos(theta) ** 2 - 1, 1]]) == 1
    assert rank([[0, 0], [0, 0]]) == 0
    assert rank(sp.zeros(0, 3)) == 0
    assert rank([]) == 0
    assert rank([[x, y, z], [x**2, x * y, x * z]]) == 1


def test_a_full_rank_needs_one_point() -> None:
    """On a circle, whose points come from roots; a rank that is not full needs many."""
    asked: list[int] = []

    class Counted(Surface):
        def point(self, number: int = 0) -> Point:
            asked.append(number)
            return super().point(number)

    circle = Counted([x**2 + y**2 - 1], [x, y])
    assert circle.rank([[x, y], [y, x]]) == 2
    assert len(asked) == 1
    assert circle.rank([[x, y], [2 * x, 2 * y]]) == 1
    assert len(asked) > 10


def test_rank_with_branches() -> None:
    assert rank([[sqrt(l**2 + 2 * l * m + m**2), 1], [l + m, 1]]) == 1
    assert rank([[sqrt(l**2 - y**2), y], [l**2 - y**2, y * sqrt(l**2 - y**2)]]) == 1
    assert rank([[sqrt(x**2 + 2 * x * y + y**2), 1], [x + y, 1]]) is None  # 1 or 2, as x + y is positive or not
    assert rank([[1 + sigma, 0], [0, 1 - sigma]]) == 1
    assert rank([[sp.atan(l), 1], [pi / 2 - sp.atan(1 / l), 1]]) in (1, None)
    assert rank([[sp.log(x**2 + 1), 1], [x, 1]]) == 2


def test_rank_drops_on_the_surface() -> None:
    rows = [[x, y], [y, x]]
    assert rank(rows) == 2
    assert rank(rows, Surface([x - y], [x, y])) == 1


# Laws.


atoms = st.sampled_from(
    [x, y, l, m, theta, sp.Integer(2), sp.Rational(3, 7), sin(theta), cos(theta / 2), sin(omega * t)]
)


def _combined(children: st.SearchStrategy[sp.Expr]) -> st.SearchStrategy[sp.Expr]:
    pairs = st.tuples(children, children)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0] * p[1]),
        pairs.map(lambda p: p[0] / (p[1] ** 2 + 1)),
        children.map(lambda e: e**2 - 1),
    )


expressions = st.recursive(atoms, _combined, max_leaves=8)


@settings(max_examples=examples(60), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(expressions, expressions)
def test_expanding_changes_nothing_and_adding_does(e: sp.Expr, f: sp.Expr) -> None:
    assert are_equal(e * f, sp.expand(sp.expand_trig(e) * f)) is True
    assert are_equal(e, e + (f**2 + 1) / 10**12) is False


@settings(max_examples=examples(40), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(expressions)
def test_field_and_reals_agree(e: sp.Expr) -> None:
    surface = Surface(fields=Fields(1))
    node = surface.graph.node(sp.sympify(e))
    assert surface.is_zero(e) is surface.real_point().vanishes(node)


@settings(max_examples=20, deadline=None)
@given(st.lists(st.lists(st.integers(-3, 3), min_size=3, max_size=3), min_size=1, max_size=4))
def test_rank_of_numbers_is_sympys(rows: list[list[int]]) -> None:
    assert rank(rows) == sp.Matrix(rows).rank()
    rotation = sp.Matrix([[cos(theta), -sin(theta), 0], [sin(theta), cos(theta), 0], [0, 0, 1]])
    assert rank(sp.Matrix(rows) * rotation) == sp.Matrix(rows).rank()


def test_seeded_surfaces_repeat() -> None:
    first, second = (Surface(fields=Fields(7)).point().value(x * cos(theta)) for _ in range(2))
    assert first == second
    assert first != Surface(fields=process_fields()).point().value(x * cos(theta))


def test_a_symbol_that_is_not_negative_keeps_its_sign() -> None:
    """√(v⁴ + 8 v²) = v √(v² + 8) for v ≥ 0, and not for every real v."""
    for v, same in ((sp.Symbol("v", nonnegative=True), True), (sp.Symbol("v", real=True), False)):
        assert is_zero(sp.sqrt(v**4 + 8 * v**2) - v * sp.sqrt(v**2 + 8)) is same


def test_positive_factors_of_a_base_are_powers_of_their_own() -> None:
    """(1 + q t/m)^n = (m + q t)^n m^(-n), as books write the speed of a rocket with drag in one way or the other."""
    m, q, b, t = sp.symbols("m q b t", positive=True)
    ratio, mass = 1 + q * t / m, m + q * t
    assert is_zero(ratio ** (b / q) - mass ** (b / q) / m ** (b / q)) is True
    assert is_zero(ratio ** ((b + q) / q) - mass ** (b / q + 1) / m ** (b / q + 1)) is True
    assert is_zero(ratio ** (b / q) - mass ** (b / q) / m ** (b / q + 1)) is False


def test_a_surface_is_kept_within_an_allowance() -> None:
    with allowed(10**6):
        circle = kept_surface([x**2 + y**2 - l**2], [x, y])
        assert kept_surface((x**2 + y**2 - l**2,), (x, y)) is circle
        assert kept_surface() is not circle
        assert is_zero(sin(theta) ** 2 + cos(theta) ** 2 - 1) is True
        free = kept_surface()
        assert kept_surface() is free
        free.is_zero(sqrt(29) * x)  # of all further fields a root of 29 would be demanded
        assert kept_surface() is not free
    assert kept_surface() is not kept_surface(), "without an allowance nothing is kept"
