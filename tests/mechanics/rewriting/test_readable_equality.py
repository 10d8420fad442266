"""What is the same to a reader, by multiplying out alone."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import Slots
from lagrange.core.vectors import Vector
from lagrange.mechanics.rewriting.readable_equality import (
    are_same_equations,
    are_same_formulas,
    divisors,
    has_plain_accelerations,
    is_linear,
    is_same,
    multiplied_out,
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
