from __future__ import annotations

import random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.intervals import EmptyIntervalError, circle, enclosure

x, y = sp.symbols("x y", real=True)
EXPRESSIONS = [
    x**3 - 2 * x * y + sp.Rational(1, 3),
    sp.sqrt(x**2 + y**2) ** 3 - sp.pi * x,
    (x - y) ** 2 * (x + y - sp.sqrt(2)),
    -(x**2) * y**5 + 10**20,
]


@pytest.mark.parametrize("e", EXPRESSIONS, ids=str)
def test_no_value_lies_outside(e: sp.Expr) -> None:
    rng = random.Random(7)
    for _ in range(20):
        box = {s: tuple(sorted((rng.uniform(-3, 3), rng.uniform(-3, 3)))) for s in (x, y)}
        low, high = enclosure(e, box)
        for _ in range(5):
            at = {s: sp.Rational(rng.uniform(*box[s])) for s in (x, y)}
            assert low <= e.xreplace(at).evalf(40) <= high


def test_the_circle_contains_the_extremes_between_the_ends() -> None:
    cosine, sine = circle(0.9, 2.1)
    assert cosine[0] == -1
    assert sine[1] == 1
    assert cosine[1] == pytest.approx(0.15643446504)
    assert sine[0] == pytest.approx(-0.15643446504)


def test_a_root_of_negative_numbers_is_empty() -> None:
    with pytest.raises(EmptyIntervalError):
        enclosure(sp.sqrt(x), {x: (-2.0, -1.0)})
