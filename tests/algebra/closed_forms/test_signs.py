"""Signs, against values at random places: a sign that is claimed holds at every one of them."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import (
    SignCondition,
    always_holds,
    between_minus_one_and_one,
    different_from_zero,
    more_than_zero,
    not_negative,
    sign_of,
    takes_both_signs,
)
from lagrange.core.symbols import Bounded

a, b, c = sp.symbols("a b c", positive=True)
x, y = sp.symbols("x y", real=True)
RELATIONS = {"≥": sp.Ge, "≤": sp.Le, ">": sp.Gt, "<": sp.Lt, "≠": sp.Ne}
EXPRESSIONS = [
    a, -a, a * b, -a / b, a + b, -a - b * c, a - b, x, x**2, x * y, x**2 + a, -(x**2) - a, 1 - sp.cos(x), sp.sin(x) - 2,
    a**2 - a * b + b**2, x**2 + x + 1, x**2 + x - 1, a + sp.sqrt(a**2 + b**2), a - sp.sqrt(a**2 + b**2),
    sp.sqrt(a**2 + b**2) - b, a * (x**2 + 1) / (b + c), sp.sqrt(a) - sp.sqrt(b), a**3 - b**3,
    8 * a - b - sp.sqrt(b**2 + 32 * a**2), b - 8 * a + sp.sqrt(b**2 + 32 * a**2), a - b - sp.sqrt(a**2 + b**2),
    a - b + sp.sqrt(b**2 + c**2), 3 * a - sp.sqrt(b**2 + c**2), a - b - sp.sqrt(b**2 + a * c), 2 * a - b + sp.sqrt(a * b),
    2 * a - b - sp.sqrt(a * b), x - sp.sqrt(x**2 + a), a - b * sp.sqrt(x**2 + 1),
]  # fmt: skip
DECIDED = 18
"""Those of them whose signs can be decided."""


def places(count: int = 40) -> list[dict[sp.Symbol, sp.Rational]]:
    random = Random(1)
    draw = lambda low: sp.Rational(random.randint(low, 40), random.randint(1, 15))  # noqa: E731
    return [{s: draw(1) for s in (a, b, c)} | {s: draw(-40) for s in (x, y)} for _ in range(count)]


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_a_sign_that_is_claimed_is_met_everywhere(expression: sp.Expr) -> None:
    sign = sign_of(expression)
    found = {int(sp.sign(expression.xreplace(p).evalf(30))) for p in places()}
    assert sign is None or found <= {sign, 0}


def test_signs_are_found() -> None:
    found = [e for e in EXPRESSIONS if sign_of(e) is not None]
    assert len(found) >= DECIDED - 4
    assert sign_of(sp.S.Zero) == 0
    assert sign_of(a - b) is None
    assert sign_of(x) is None
    assert sign_of(a - b, positive=[a - b]) == 1
    assert sign_of(b - a, positive=[a - b]) == -1
    # more than a known one
    assert sign_of(a - b + a * c, positive=[a - b]) == 1
    assert sign_of(b - a - 2 * c, positive=[a - b]) == -1
    assert sign_of(b - a + c, positive=[a - b]) is None
    assert sign_of(a - b - c, positive=[a - b]) is None


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_conditions_hold_where_the_expression_is_not_negative(expression: sp.Expr) -> None:
    conditions = not_negative(expression)
    for p in places():
        holds = conditions is not None and all(
            bool(RELATIONS[k.relation](k.lhs.xreplace(p), k.rhs.xreplace(p))) for k in conditions
        )
        assert holds == (expression.xreplace(p).evalf(30) >= 0)


def test_a_condition_has_no_minus_signs() -> None:
    [condition] = not_negative(a * b - c)  # type: ignore[misc]
    assert (condition.lhs, condition.relation, condition.rhs) == (a * b, "≥", c)
    greater = more_than_zero(a * (b - c))
    assert (greater.lhs, greater.relation, greater.rhs) == (b, ">", c)
    [different] = different_from_zero(x - y)
    assert (different.lhs - different.rhs) in (x - y, y - x)
    assert different_from_zero(a + b) == ()


def test_a_condition_with_a_root_is_stated_without_it_where_that_is_shorter() -> None:
    """8a ≥ b + √(b² + 32a²) is b ≤ 2a; a − b ≥ √(b² + a c) says a ≥ b besides, which (a − b)² ≥ ... does not."""
    root = sp.sqrt(b**2 + 32 * a**2)
    assert not_negative(8 * a - b - root) == (SignCondition(2 * a, "≥", b),)
    assert more_than_zero(b + root - 8 * a) == SignCondition(b, ">", 2 * a)
    [kept] = not_negative(a - b - sp.sqrt(b**2 + a * c)) or ()
    assert kept.lhs.has(sp.sqrt) or kept.rhs.has(sp.sqrt) or kept == SignCondition(a, "≥", 2 * b + c)


@pytest.mark.parametrize(
    "value", [a / b, x, (a - b) / (a + b), 1 + a, -1 - a, 2 * a / (a + b), a / sp.sqrt(a**2 + b**2), a / (a - b)]
)
def test_where_an_arc_cosine_exists(value: sp.Expr) -> None:
    conditions = between_minus_one_and_one(value)
    for p in places():
        holds = conditions is not None and all(
            bool(RELATIONS[k.relation](k.lhs.xreplace(p), k.rhs.xreplace(p))) for k in conditions
        )
        assert holds == (abs(value.xreplace(p).evalf(30)) <= 1)


ALPHA = Bounded("alpha", sp.S.Zero, sp.pi / 2, (True, True))


@pytest.mark.parametrize(
    ("e", "sign"),
    [
        (1 - sp.Rational(2, 3) * sp.Abs(sp.cos(x)), 1),
        (2 * sp.sin(x) ** 2 * sp.cos(y) - 3, -1),
        (1 - 2 * sp.Abs(sp.sin(x)), None),
        (sp.sqrt(9 - 4 * sp.sin(ALPHA) ** 2) / 3 - sp.cos(ALPHA), 1),  # squared, 5 sin² α > 0
    ],
)
def test_sines_and_cosines_are_at_most_one(e: sp.Expr, sign: int | None) -> None:
    assert sign_of(e) == sign


def test_conditions_that_always_hold() -> None:
    two_thirds = sp.Rational(2, 3) * sp.Abs(sp.cos(x))
    assert always_holds(SignCondition(two_thirds, "≤", sp.S.One))
    assert always_holds(SignCondition(sp.exp(a), "≥", sp.S.One))
    assert not always_holds(SignCondition(2 * two_thirds, "≤", sp.S.One))
    assert not always_holds(SignCondition(a, "≥", b))


def test_square_roots_on_both_sides_are_squared() -> None:
    [condition] = not_negative(sp.sqrt(a) - sp.sqrt(2) * sp.sqrt(c)) or ()
    assert (condition.lhs, condition.relation, condition.rhs) == (a, "≥", 2 * c)
    assert not_negative(sp.sqrt(a) - sp.sqrt(2) * sp.sqrt(c), [a - 2 * c]) == (), "known of the roots, too"


def test_a_squared_condition_has_no_common_factor() -> None:
    [condition] = not_negative(10 * a - sp.sqrt(a) * sp.sqrt(a + 2 * b)) or ()
    assert (condition.lhs, condition.relation, condition.rhs) == (99 * a, "≥", 2 * b)


def test_a_known_sum_and_what_is_never_negative() -> None:
    assert sign_of(a - 2 * c + 3 * a * sp.sin(x) ** 2, [a - 2 * c]) == 1
    assert sign_of(2 * c - a - 3 * a * sp.sin(x) ** 2, [a - 2 * c]) == -1
    assert sign_of(a - 2 * c - 3 * a * sp.sin(x) ** 2, [a - 2 * c]) is None


def test_what_is_not_zero_is_said_without_the_root() -> None:
    """16r² − a² − a √(a² + 32r²) vanishes for a = 2r, and on both sides of it has another sign."""
    a, r = sp.symbols("a r", positive=True)
    for e, shorter, zero in (
        (16 * r**2 - a**2 - a * sp.sqrt(a**2 + 32 * r**2), 2 * r - a, 2 * r),
        (3 * r - a - sp.sqrt(a**2 + r**2), 4 * r - 3 * a, sp.Rational(4, 3) * r),
    ):
        [c] = different_from_zero(e)
        assert (c.relation, c.lhs - c.rhs) == ("≠", shorter)
        values = [e.subs(a, scale * zero).subs(r, 1) for scale in (sp.Rational(9, 10), 1, sp.Rational(11, 10))]
        assert (values[0] > 0, sp.simplify(values[1]), values[2] < 0) == (True, 0, True)


def test_roots_on_both_sides_are_raised_to_their_common_power() -> None:
    """∛b > ∛c says b > c, and a ∛b > c says a³ b > c³; √2 a > b stays."""
    a, b, c = sp.symbols("a b c", positive=True)
    third = sp.Rational(1, 3)
    assert different_from_zero(b ** (2 * third) - c ** (2 * third)) == (SignCondition(b, "≠", c),)
    assert more_than_zero(a * b**third - c) == SignCondition(a**3 * b, ">", c**3)
    assert more_than_zero(sp.sqrt(2) * a - b) == SignCondition(sp.sqrt(2) * a, ">", b)


# -- Whether an expression takes both signs, seen at points ------------------------------------------------------------


def test_both_signs_are_seen_at_points_and_one_sign_is_not() -> None:
    long = (a + b) * (a + c) * (b + c) + a * b
    assert takes_both_signs(sp.expand(long - 3 * a * b * c * x)) is True
    assert takes_both_signs(sp.expand(long)) is False
    # where x > 0 it is positive, and points outside are not looked at
    assert takes_both_signs(sp.expand(long * x), (x,)) is False
    assert sign_of(sp.expand(long * x), (x,)) == 1


def test_a_sign_of_several_factors_whose_product_is_known() -> None:
    product = (a * b - c) * (b - c)
    assert sign_of((a * b - c) / (c - b), [product]) == -1
    assert sign_of(a**2 * (a * b - c) ** 3 * (b - c), [product]) == 1
    assert sign_of((a * b - c) / (c - a), [product]) is None
    assert sign_of(a * b - c, [product]) is None


BETA = Bounded("beta", sp.S.Zero, sp.pi / 2, (True, True))
WIDE = Bounded("gamma", -sp.pi, 2 * sp.pi)
POINTS = [(0.3, 0.2), (0.2, 0.3), (0.9, 1.1), (1.2, 1.5), (1.5, 0.1), (0.7, 0.7)]


@pytest.mark.parametrize(
    ("e", "shown"),
    [
        (sp.sin(BETA) - sp.cos(BETA) * sp.tan(ALPHA), "beta > alpha"),
        (a * sp.tan(ALPHA) - a * sp.tan(BETA), "alpha > beta"),
        (1 - sp.tan(ALPHA) * sp.tan(BETA), "pi/2 > alpha + beta"),
        (sp.sin(2 * ALPHA) * sp.cos(BETA) - sp.cos(2 * ALPHA) * sp.sin(BETA), "2*alpha > beta"),
    ],
)
def test_the_sine_of_a_sum_of_acute_angles_has_the_sign_of_an_angle(e: sp.Expr, shown: str) -> None:
    found = more_than_zero(e)
    assert f"{found.lhs} {found.relation} {found.rhs}" == shown
    for point in POINTS:
        values = {ALPHA: point[0], BETA: point[1], a: 2}
        if abs(before := e.subs(values)) > 1e-9:
            assert (before > 0) == ((found.lhs - found.rhs).subs(values) > 0)


def test_an_angle_of_more_than_half_a_turn_stays_in_its_sine() -> None:
    """sin(γ − α) changes its sign at γ − α = π, −π."""
    found = more_than_zero(sp.sin(WIDE) * sp.cos(ALPHA) - sp.cos(WIDE) * sp.sin(ALPHA))
    assert found.lhs.has(sp.sin)


def test_a_positive_power_is_no_part_of_a_condition() -> None:
    """Neither e^(−r/a), nor r and r^n where r is known to be positive, changes the sign of a r − r²."""
    r, n = sp.symbols("r n", real=True)
    found = more_than_zero(r**n * (a * r - r**2) * sp.exp(-r / a), [r])
    assert (found.lhs, found.relation, found.rhs) == (a, ">", r)
    assert more_than_zero(r**n * (a - r)).lhs.has(n)  # r^n of a negative r has no sign


def test_a_difference_of_roots_has_the_sign_that_its_squares_are_known_to_have() -> None:
    m, U, v = sp.symbols("m U v", positive=True)
    e = 2 * sp.sqrt(U) - sp.sqrt(2) * sp.sqrt(m) * v
    assert sign_of(e) is None
    assert sign_of(e, [4 * U - 2 * m * v**2]) == 1
    assert sign_of(-e, [4 * U - 2 * m * v**2]) == -1
    assert sign_of(e, [2 * m * v**2 - 4 * U]) == -1


def test_what_only_divides_may_not_vanish() -> None:
    a, theta = sp.Symbol("a", positive=True), sp.Symbol("theta", real=True)
    assert not_negative(a / sp.cos(theta)) == (SignCondition(sp.cos(theta), ">", sp.S.Zero),)
    assert not_negative(a * sp.cos(theta)) == (SignCondition(sp.cos(theta), "≥", sp.S.Zero),)


def test_a_quotient_with_a_root_is_compared_by_squares() -> None:
    """|a − b|/(2 √(R² − a b)) ≤ 1 where 4 R² ≥ (a + b)²."""
    b, R = sp.symbols("b R", positive=True)
    found = between_minus_one_and_one((a - b) / (2 * sp.sqrt(R**2 - a * b)))
    assert found == (SignCondition(2 * R, "≥", a + b),)
    assert between_minus_one_and_one((3 * R + a) / sp.sqrt(R**2 + a * R)) is None
