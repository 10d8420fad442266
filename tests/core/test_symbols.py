"""State slots: the explicit time derivative against SymPy's derivative of functions of time.

Signs of functions of parameters with a range, against sampled values.
"""

from __future__ import annotations

import pickle

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.symbols import (
    Bounded,
    Decimal,
    Sign,
    Slots,
    Unspecified,
    base,
    derivative,
    differential,
    multiplier,
    never_vanishes,
    partial,
    prime,
    sign_in_range,
    t,
    variation,
)

x, y, u = sp.symbols("x y u", real=True)
a, b = sp.symbols("a b", positive=True)
SLOTS = Slots((x, y), (u,))

EXPRESSIONS = [
    x**2 * y,
    sp.sin(x * y) * sp.exp(-a * t),
    sp.sqrt(a**2 - x**2) / (1 + y**2),
    sp.atan2(y, x) + sp.log(1 + x**2),
    (x + u) ** 3 * sp.cos(b * t + x),
    prime(x) * sp.tan(y) + prime(u) * x,
    x**y * a**t + sp.Abs(b + x**2),
]


def as_functions(expression: sp.Expr) -> sp.Expr:
    """The expression with every slot replaced by a function of time and its derivatives."""
    rule = {}
    for q in (x, y, u):
        f = sp.Function(q.name)(t)
        rule |= {q: f, prime(q): f.diff(t), prime(q, 2): f.diff(t, 2)}
    return expression.xreplace(rule)


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_total_derivative_is_that_of_functions_of_time(expression: sp.Expr) -> None:
    ours = as_functions(SLOTS.time_derivative(expression))
    theirs = as_functions(expression).diff(t)
    numbers = {t: sp.Rational(2, 7), a: sp.Rational(9, 4), b: sp.Rational(5, 3)}
    for q, value in ((x, sp.Rational(1, 3)), (y, sp.Rational(4, 5)), (u, sp.Rational(3, 8))):
        f = sp.Function(q.name)(t)
        numbers |= {f.diff(t, 2): value + 2, f.diff(t): value + 1, f: value}
    difference = (ours - theirs).subs(sorted(numbers.items(), key=lambda kv: -sp.count_ops(kv[0])))
    assert abs(difference.evalf(30)) < sp.Float(10) ** -25


def test_frozen_derivative_takes_prescribed_motions_along() -> None:
    assert SLOTS.frozen_derivative(x * u + t * y + prime(u)) == x * prime(u) + y + prime(u, 2)


def test_partial_derivative_by_one_symbol() -> None:
    found = derivative(sp.sin(x * y) + x**3, lambda s: sp.S.One if s == x else sp.S.Zero)
    assert found == y * sp.cos(x * y) + 3 * x**2


def test_unspecified_functions_follow_the_chain_rule() -> None:
    f = Unspecified.of("f", ("X", "Y"), x - a * t, y)
    expected = f.partial(0) * (prime(x) - a) + f.partial(1) * prime(y)
    assert sp.expand(SLOTS.time_derivative(f) - expected) == 0
    assert f.diff(x) == f.partial(0)
    assert f.partial(0).orders == (1, 0)
    assert f.partial(0).partial(1) == f.partial(1).partial(0)
    assert f.diff(t) == -a * f.partial(0)


def test_a_sign_has_square_one() -> None:
    s = Sign("sigma")
    assert s**2 == 1
    assert s**3 == s
    assert 1 / s == s
    assert sp.Abs(s) == 1
    assert (s * x) ** 2 == x**2
    assert s != 1


def test_names_are_the_text_form() -> None:
    assert [s.name for s in (prime(x), prime(x, 2), differential(x), variation(x), multiplier("rod"))] == [
        "x'",
        "x''",
        "d(x)",
        "delta(x)",
        "lambda_rod",
    ]
    assert base(prime(x, 2)) == x
    assert base(x) == x


def test_a_sign_is_constant_away_from_its_jump() -> None:
    """SymPy has Derivative(sign(x), x), or a DiracDelta, neither of which can be evaluated or printed."""
    x = sp.Symbol("x", real=True)
    slots = Slots((x,))
    assert partial(sp.sign(x) * x**2, x) == 2 * x * sp.sign(x)
    assert partial(sp.Abs(x**2 - 1), x) == 2 * x * sp.sign(x**2 - 1)
    twice = slots.time_derivative(slots.time_derivative(sp.Abs(x)))
    assert twice == sp.sign(x) * slots.accelerations[0]


# Ranges


pi = sp.pi
a_ranges = Bounded("a", sp.S.Zero, pi / 2, (True, True))
b_ranges = Bounded("b", sp.S.Zero, pi / 2)
c = Bounded("c", -pi / 4, pi / 3)
d = Bounded("d", sp.Rational(1, 2), sp.Integer(2))

FUNCTIONS = [
    sp.sin(a_ranges), sp.cos(a_ranges), sp.tan(a_ranges), sp.sin(2 * a_ranges), sp.cos(2 * a_ranges), sp.cos(a_ranges / 2), sp.sin(a_ranges - pi / 2), sp.sin(b_ranges),
    sp.cos(b_ranges), sp.sin(2 * b_ranges), sp.cos(c), sp.sin(c), c - pi / 2, a_ranges - pi / 2, sp.sin(a_ranges + b_ranges), sp.cos(a_ranges - b_ranges), sp.sin(3 * a_ranges),
    sp.cot(a_ranges), 1 - 3 * d, d - 2, 2 * d - c, sp.cos(d), sp.sin(d), sp.sin(d + a_ranges), sp.tan(2 * c), sp.sin(5 * d),
]  # fmt: skip
DECIDED = {
    sp.sin(a_ranges): 1, sp.cos(a_ranges): 1, sp.tan(a_ranges): 1, sp.sin(2 * a_ranges): 1, sp.cos(a_ranges / 2): 1, sp.cos(c): 1, c - pi / 2: -1,
    a_ranges - pi / 2: -1, sp.sin(a_ranges + b_ranges): 1, sp.cot(a_ranges): 1, 1 - 3 * d: -1, sp.sin(d): 1, sp.cos(a_ranges - b_ranges): 1,
}  # fmt: skip


@pytest.mark.parametrize("f", FUNCTIONS, ids=str)
def test_signs_agree_with_samples(f: sp.Expr) -> None:
    sign = sign_of(f)
    assert sign == DECIDED.get(f, sign)
    values = [f]
    for s in sorted(f.free_symbols, key=str):
        steps = [sp.Rational(n, 12) for n in range(0 if not s.strict[0] else 1, 13 if not s.strict[1] else 12)]
        values = [v.subs(s, s.low + (s.high - s.low) * part) for v in values for part in steps]
    if sign is not None:
        assert all((v.evalf() > 0) if sign == 1 else (v.evalf() < 0) for v in values)


def test_ends_that_belong_to_the_range_are_not_forgotten() -> None:
    assert sign_in_range(sp.sin(b_ranges)) is None
    assert sign_in_range(sp.cos(b_ranges)) is None
    assert not never_vanishes(sp.cos(b_ranges))
    assert never_vanishes(sp.cos(a_ranges))


def test_parameters_with_different_ranges_are_different() -> None:
    assert a_ranges != Bounded("a", sp.S.Zero, pi / 2)
    assert a_ranges == Bounded("a", sp.S.Zero, pi / 2, (True, True))
    assert a_ranges != sp.Symbol("a", positive=True)
    assert pickle.loads(pickle.dumps(a_ranges)) == a_ranges
    assert (a_ranges.is_positive, b_ranges.is_positive, b_ranges.is_nonnegative, c.is_positive) == (
        True,
        None,
        True,
        None,
    )


@pytest.mark.parametrize(
    ("text", "half"), [("14.01", "1/200"), ("353", "1/2"), ("346000", "500"), ("2000", "5"), ("346e6", "500000")]
)
def test_a_whole_number_is_rounded_to_three_digits_or_more(text: str, half: str) -> None:
    assert Decimal(text, "1").half_width == sp.Rational(half)
