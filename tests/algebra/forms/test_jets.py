"""Jets against derivatives taken by SymPy, coefficient by coefficient, and the laws of Taylor series."""

from __future__ import annotations

import itertools
import math
import random

import pytest
import sympy as sp

from lagrange.algebra.exact.prime_field import InadmissibleError, PrimeField, ZeroDivisorError
from lagrange.algebra.exact.zero_test import Fields, Surface, UnsupportedError
from lagrange.algebra.forms.jets import (
    BITS,
    Expansion,
    Jet,
    JetRing,
    NoExpansionError,
    WorkLimitError,
    constant_term,
    is_zero_jet,
    nilpotent,
    truncated,
)
from lagrange.core.symbols import Slots, Unspecified, prime, t

ORDER = 3
x, y, z = sp.symbols("x y z", real=True)
a, k = sp.symbols("a k", positive=True)
u = sp.Symbol("u", real=True)
VARIABLES = (x, y, z, t)
FIELD = PrimeField.draw(random.Random(6))

f = Unspecified.of("f", "XY", x - a * t, y * z)
g = Unspecified.of("g", "XYZ", x, y, z)

EXPRESSIONS = [
    x**3 * y - 5 * z**2 + a,
    1 / (x + y),
    (x + a) / (y**2 + z) ** 2,
    sp.sin(x * y + a),
    sp.cos(x + 2 * t),
    sp.sin(x) ** 2 * sp.cos(y),
    sp.tan(x * t),
    sp.cot(x),
    sp.sec(x) * sp.csc(y),
    sp.exp(x * y) / z,
    sp.exp(-k * t) * sp.cos(x),
    sp.sinh(x * y),
    sp.cosh(x) * sp.tanh(z),
    sp.sqrt(x**2 + a),
    (x**2 + y) ** sp.Rational(-3, 2),
    (x + y) ** sp.Rational(1, 3),
    (x + a) ** a,
    a * (x + a) * sp.sin(y),
    x**y,
    sp.log(x + y * z),
    sp.atan(x * y),
    sp.atan2(y, x),
    sp.asin(x * y),
    sp.acos(x) * z,
    f,
    x * f.partial(0),
    f.partial(1) * g,
    g.partial(0).partial(0).partial(2),
    sp.sin(g) + sp.sqrt(g**2 + 1),
    Unspecified.of("h", "X", 3 + a),
]


def points(count: int = 40) -> Surface:
    return Surface(fields=Fields(count))


def expansion(point, order: int = ORDER, prescribed: tuple[sp.Symbol, ...] = ()) -> Expansion:
    ring = JetRing(point.arithmetic)
    jets = {v: ring.variable(n, point.value(v), order) for n, v in enumerate(VARIABLES)}
    return Expansion(ring, point.value, jets, prescribed)


def coefficient(jet: Jet, *exponents: int) -> int:
    key = sum(n << BITS * place for place, n in enumerate(exponents))
    return jet[sum(exponents)].get(key, 0)


def by_derivatives(point, e: sp.Expr, exponents: tuple[int, ...]) -> int:
    for v, n in zip(VARIABLES, exponents, strict=True):
        if n:
            e = sp.diff(e, v, n)
    divisor = math.prod(math.factorial(n) for n in exponents)
    return point.value(e) * point.number(1, divisor) % point.p


def multi_indices(order: int = ORDER) -> list[tuple[int, ...]]:
    every = itertools.product(range(order + 1), repeat=len(VARIABLES))
    return [n for n in every if sum(n) <= order]


@pytest.mark.parametrize("e", EXPRESSIONS, ids=str)
def test_every_coefficient_is_a_derivative_over_factorials(e):
    def both(point) -> list[tuple[int, int]]:
        jet = expansion(point)(e)
        return [(coefficient(jet, *n), by_derivatives(point, e, n)) for n in multi_indices()]

    [pairs] = points().sampled(both, 1)
    assert all(left == right for left, right in pairs)
    assert any(left for left, _ in pairs)


@pytest.mark.parametrize("e", [sp.Abs(x * y), sp.sign(x) * y, sp.Abs(x) ** 3 + sp.sqrt(x**2)], ids=str)
def test_signs_are_constant_near_a_point(e):
    def both(point) -> tuple[Jet, Jet]:
        expand = expansion(point)
        sign = {
            sp.Abs(x * y): sp.sign(x * y) * x * y,
            sp.Abs(x): sp.sign(x) * x,
            sp.sqrt(x**2): sp.sign(x) * x,
        }
        constant = {s: point.value(s) for s in (sp.sign(x), sp.sign(y), sp.sign(x * y))}
        written = e.xreplace(sign).xreplace({s: sp.Integer(1 if v == 1 else -1) for s, v in constant.items()})
        return expand(e), expand(written)

    for left, right in points().sampled(both, 6):
        assert left == right


def test_no_sign_where_the_argument_vanishes():
    surface = Surface([x], [x], fields=Fields(3))
    with pytest.raises(ZeroDivisorError):
        expansion(surface.point())(sp.Abs(x))


def test_a_prescribed_motion_has_its_own_slots_as_coefficients():
    point = points().point()
    expand = expansion(point, prescribed=(u,))
    slots, e = Slots((x, y, z), (u,)), x * sp.sin(u) + prime(u) ** 2
    jet, derivative, divisor = expand(e), e, 1
    for n in range(ORDER + 1):
        assert coefficient(jet, 0, 0, 0, n) == point.value(derivative) * point.number(1, divisor) % point.p
        derivative, divisor = slots.frozen_derivative(derivative), divisor * (n + 1)
    assert coefficient(jet, 1, 0, 0, 1) == point.value(sp.cos(u) * prime(u))
    assert not coefficient(expansion(point)(e), 1, 0, 0, 1)  # u is a constant unless it is prescribed


def test_mixed_derivatives_of_an_undefined_function_commute():
    point = points().point()
    jet = expansion(point)(g)
    mixed = point.value(g.partial(1).partial(0))
    assert coefficient(jet, 1, 1, 0, 0) == mixed == point.value(g.partial(0).partial(1))
    assert coefficient(jet, 2, 0, 0, 0) != mixed


IDENTITIES = [
    sp.sin(x + y) - sp.sin(x) * sp.cos(y) - sp.cos(x) * sp.sin(y),
    sp.cos(x) ** 2 + sp.sin(x) ** 2 - 1,
    sp.tan(x) * sp.cos(x) - sp.sin(x),
    sp.exp(x + y) - sp.exp(x) * sp.exp(y),
    sp.cosh(x) ** 2 - sp.sinh(x) ** 2 - 1,
    sp.sqrt(x**2 + y**2) ** 2 - x**2 - y**2,
    (x**2 + y**2) / (x + y) - (x + y) + 2 * x * y / (x + y),
    sp.sin(2 * x) - 2 * sp.sin(x) * sp.cos(x),
]


@pytest.mark.parametrize("e", IDENTITIES, ids=str)
def test_identities_hold_to_every_order(e):
    [jet] = points().sampled(lambda p: expansion(p, order=5)(e), 1)
    assert is_zero_jet(jet)


@pytest.mark.parametrize("e", [sp.Piecewise((x, x > 0), (y, True)), sp.Max(x, y), sp.gamma(x)], ids=str)
def test_what_has_no_series_is_said(e):
    with pytest.raises((NoExpansionError, UnsupportedError)):
        expansion(points().point())(e)


def random_jet(rng: random.Random, order: int) -> Jet:
    levels: list[dict[int, int]] = [{} for _ in range(order + 1)]
    for n in multi_indices(order):
        if rng.random() < 0.6:
            levels[sum(n)][sum(m << BITS * place for place, m in enumerate(n))] = rng.randrange(1, FIELD.p)
    levels[0] = {0: rng.randrange(1, FIELD.p)}
    return tuple(levels)


@pytest.mark.parametrize("seed", range(5))
def test_ring_laws(seed):
    ring, rng = JetRing(FIELD), random.Random(seed)
    p, q, r = (random_jet(rng, 4) for _ in range(3))
    assert ring.multiply(p, ring.add(q, r)) == ring.add(ring.multiply(p, q), ring.multiply(p, r))
    assert ring.multiply(p, ring.multiply(q, r)) == ring.multiply(ring.multiply(p, q), r)
    assert ring.subtract(ring.add(p, q), q) == p
    assert ring.multiply(p, ring.inverse(p)) == ring.constant(1, 4)
    assert ring.power(p, 5) == ring.multiply(ring.power(p, 2), ring.power(p, 3))
    assert ring.multiply(ring.power(p, -2), ring.power(p, 2)) == ring.constant(1, 4)
    assert ring.multiply(p, q) != ring.multiply(p, r)


@pytest.mark.parametrize("index", range(4))
def test_leibniz(index):
    ring, rng = JetRing(FIELD), random.Random(index)
    p, q = random_jet(rng, 4), random_jet(rng, 4)
    left = ring.derivative(ring.multiply(p, q), index)
    right = ring.add(
        ring.multiply(ring.derivative(p, index), truncated(q, 3)),
        ring.multiply(truncated(p, 3), ring.derivative(q, index)),
    )
    assert left == right
    assert not is_zero_jet(left)


def test_functions_undo_each_other():
    ring, rng = JetRing(FIELD), random.Random(1)
    p = random_jet(rng, 4)
    square = ring.multiply(p, p)
    root = ring.real_power(square, FIELD.number(1, 2), constant_term(p))
    assert root == p
    log = ring.logarithm(p, 17)
    assert ring.exponential(log, constant_term(p)) == p
    cosine, sine = ring.rotation(nilpotent(p), 1, 0)
    assert ring.angle(sine, cosine, 0) == nilpotent(p)


def test_a_product_has_the_lower_order():
    ring = JetRing(FIELD)
    high, low = ring.variable(0, 3, 4), ring.variable(1, 5, 2)
    assert len(ring.multiply(high, low)) == len(low)
    assert len(ring.derivative(high, 0)) == len(high) - 1


def test_work_is_limited():
    ring = JetRing(FIELD, limit=100)
    jet = random_jet(random.Random(2), 4)
    with pytest.raises(WorkLimitError):
        ring.multiply(jet, jet)
    assert ring.work > 100


def test_division_by_a_jet_that_is_zero_at_the_point():
    ring = JetRing(FIELD)
    with pytest.raises(InadmissibleError):
        ring.inverse(nilpotent(ring.variable(0, 3, 2)))


def test_reals_give_the_same_series():
    """sin(x y)/√(1 + x²) at a real point, against SymPy's series."""
    e = sp.sin(x * y) / sp.sqrt(1 + x**2)
    point = points().real_point()
    jet = expansion(point)(e)
    for n in multi_indices():
        d = e
        for v, m in zip(VARIABLES, n, strict=True):
            d = sp.diff(d, v, m) if m else d
        expected = point.value(d) / math.prod(math.factorial(m) for m in n)
        assert abs(coefficient(jet, *n) - expected) < 1e-50
