"""What is the same to a reader, by multiplying out alone.

Long roots by letters, and only these.

Numbers for a calculator: what matters, angles within a turn, a formula where it is short.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import Slots
from lagrange.core.vectors import Vector
from lagrange.mechanics.rewriting.readable_forms import (
    acceleration_formula,
    are_same_equations,
    are_same_formulas,
    divisors,
    has_plain_accelerations,
    is_linear,
    is_root_of,
    is_same,
    multiplied_out,
    roots_by_letters,
    values_that_matter,
)
from tests.support.shared import solved

a, b, r, x, theta = sp.symbols("a b r x theta", real=True)
R = sp.Symbol("R", positive=True)
SLOTS = Slots((x, theta))
ax, at = SLOTS.accelerations


def test_what_is_the_same_multiplied_out() -> None:
    assert is_same(a * (a + b), a**2 + a * b)
    assert not is_same(sp.sin(x) ** 2 + sp.cos(x) ** 2, sp.S.One)  # that takes more than a look
    assert multiplied_out(Vector((a * (a + b), x, sp.S.Zero))) == (a**2 + a * b, x, 0)


@pytest.mark.parametrize(
    ("stated", "shown", "same"),
    [
        (((ax, a * sp.cot(theta)),), [ax - a * sp.cos(theta) / sp.sin(theta)], True),
        (((a * x, ax),), [ax - a * x], True),
        (((2 * ax, a),), [ax - a / 2], True),
        (((2 * ax, a),), [ax - a], False),
        (((R * ax, R * r),), [ax - r], True),
        (((x * ax, x * a),), [ax - a], False),
        (((ax, a), (at, b)), [ax - a], False),
    ],
)
def test_equations_with_terms_brought_to_the_other_side(
    stated: tuple[tuple[sp.Expr, ...], ...], shown: list[sp.Expr], same: bool
) -> None:
    assert are_same_equations(stated, shown) is same


def test_formulas_with_other_names() -> None:
    assert are_same_formulas(a**2 / r, b**2 / r, {a: b})
    assert are_same_formulas((a**2 - b**2) / (a - b), a + b, {})
    assert not are_same_formulas(a * (b + r), x * b + x * r, {a: x})  # longer: it is said


@pytest.mark.parametrize(
    ("component", "plain"), [(ax + a * at, True), (x * at, False), (ax + a, False), (ax * at, False), (sp.S.Zero, True)]
)
def test_accelerations_with_constant_coefficients(component: sp.Expr, plain: bool) -> None:
    assert bool(has_plain_accelerations(Vector((component, ax, sp.S.Zero)), SLOTS)) is plain


def test_what_is_linear_before_anything_is_neglected() -> None:
    pendulum = solved("double-pendulum-small-oscillations")
    [linearization] = [v.linearization for v in pendulum.views if v.linearization is not None]
    assert not is_linear(linearization)
    springs = solved("coupled-oscillators")
    assert all(is_linear(v.linearization) for v in springs.views if v.linearization is not None)
    assert any(v.linearization is not None for v in springs.views)


def test_what_values_divide_by() -> None:
    assert divisors([a / (b * (x - r) ** 2), x]) == {sp.S.One, b, sp.factor((x - r) ** 2).base}


# Root letters


a_root_letters, l, c, d = sp.symbols("a l c d", positive=True)
u, v = sp.symbols("u v", real=True)
RADICAND = a_root_letters**2 - 2 * a_root_letters * l * (sp.sin(u) - sp.sin(v)) + 2 * l**2 * (1 - sp.cos(u - v))


def test_the_root_its_inverse_and_that_of_a_multiple() -> None:
    e = c * sp.sqrt(RADICAND) + a_root_letters / sp.sqrt(sp.expand(2 * RADICAND)) + RADICAND ** sp.Rational(3, 2)
    assert roots_by_letters(e, {RADICAND: d}) == c * d + a_root_letters / (sp.sqrt(2) * d) + d**3


def test_what_a_damper_divides_by() -> None:
    assert roots_by_letters(c * l / RADICAND, {RADICAND: d}) == c * l / d**2


def test_other_roots_stay() -> None:
    e = sp.sqrt(RADICAND) + sp.sqrt(RADICAND + a_root_letters * l)
    assert roots_by_letters(e, {RADICAND: d}) == d + sp.sqrt(RADICAND + a_root_letters * l)


def test_a_root_in_another_form() -> None:
    other = sp.sqrt((a_root_letters - l * sp.sin(u) + l * sp.sin(v)) ** 2 + l**2 * (sp.cos(v) - sp.cos(u)) ** 2)
    assert is_root_of(other, RADICAND)
    assert not is_root_of(other + a_root_letters, RADICAND)


# Spot formulas


theta_spot_formulas = sp.Symbol("theta", real=True)


def test_the_acceleration_of_a_pendulum() -> None:
    view = solved("ex11-ideal-pendulum").choices[0]
    [acceleration] = view.configuration.slots.accelerations
    formula = acceleration_formula(view, acceleration)
    assert formula is not None
    assert view.motion is not None
    assert sp.expand(view.motion.expressions[0].subs(acceleration, formula)) == 0
    assert acceleration_formula(solved("ex11-ideal-pendulum").own, acceleration) is None  # it keeps a constraint


def test_an_angle_is_within_a_turn_and_what_occurs_nowhere_is_left_out() -> None:
    view = solved("ex11-ideal-pendulum").choices[0]
    [q] = view.configuration.slots.coordinates
    shown = values_that_matter(view, {q: sp.Integer(7), sp.Symbol("g", positive=True): sp.Integer(10)})
    assert abs(shown[q] - (7 - 2 * sp.pi)) < 1e-5
    assert shown[sp.Symbol("g", positive=True)] == 10
    free = solved("ex11-ideal-pendulum").own
    kept = values_that_matter(free, dict.fromkeys(free.configuration.slots.coordinates, sp.Integer(7)))
    assert all(v == 7 for v in kept.values())  # lengths are no angles
