"""Roots by interval arithmetic, against changes of sign on a fine grid."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import pytest
import sympy as sp

from lagrange.values import numerical_roots
from lagrange.values.numerical_roots import real_roots, sign_at

x, y, z = sp.symbols("x y z", real=True)
half = sp.Rational(1, 2)

ONE: list[tuple[sp.Expr, Callable[[float], float], float]] = [
    (sp.sin(x), math.sin, 3.3),
    (x - 3 * sp.sin(x), lambda v: v - 3 * math.sin(v), 12.5),
    (x**2 - 2, lambda v: v * v - 2, 10),
    (x**2 + 1, lambda v: v * v + 1, 100),
    (sp.cos(x) - half * sp.sin(2 * x) + sp.Rational(3, 10),
     lambda v: math.cos(v) - 0.5 * math.sin(2 * v) + 0.3, 3.3),
    (sp.sqrt(x**2 + 1) - 2 * x + half, lambda v: math.sqrt(v * v + 1) - 2 * v + 0.5, 10),
    (x**3 - 6 * x**2 + 11 * x - 6, lambda v: (v - 1) * (v - 2) * (v - 3), 10),
    (sp.exp(x) - 5 * x, lambda v: math.exp(v) - 5 * v, 6),
    (sp.sin(10 * x) - x / 5, lambda v: math.sin(10 * v) - v / 5, 4),
]  # fmt: skip


@pytest.mark.parametrize(("f", "by_hand", "limit"), ONE, ids=lambda p: str(p) if isinstance(p, sp.Expr) else "")
def test_all_roots_of_one_equation(f: sp.Expr, by_hand: Callable[[float], float], limit: float) -> None:
    found = real_roots([f], [x], [(-limit, limit)])
    assert found.complete
    steps = 20_011
    grid = [-limit + 2 * limit * n / steps for n in range(steps + 1)]
    values = [by_hand(v) for v in grid]
    changes = [v for v, a, b in zip(grid, values, values[1:], strict=False) if a * b < 0]
    assert len(found.roots) == len(changes)
    for root, near in zip(found.roots, changes, strict=True):
        [value] = root.values
        assert abs(float(value) - near) <= 2 * limit / steps
        assert abs(f.subs(x, value).evalf(25)) < sp.Float("1e-24")


def test_two_equations() -> None:
    found = real_roots([x**2 + y**2 - 1, x - y], [x, y], [(-10, 10), (-10, 10)])
    assert found.complete
    numbers = [float(v) for r in found.roots for v in r.values]
    assert numbers == pytest.approx([-math.sqrt(0.5), -math.sqrt(0.5), math.sqrt(0.5), math.sqrt(0.5)])


@pytest.mark.parametrize("f", [(x - 1) ** 2, sp.Abs(x), 1 / x, 1 - sp.cos(x)], ids=str)
def test_what_is_not_proved_is_not_called_complete(f: sp.Expr) -> None:
    assert not real_roots([f], [x], [(-4, 5)]).complete


def test_the_number_of_boxes_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numerical_roots, "MOST_BOXES", 5)
    assert not real_roots([sp.sin(7 * x)], [x], [(-4, 5)]).complete


def test_signs_at_a_root() -> None:
    [root] = real_roots([x**3 - 2], [x], [(-4, 5)]).roots
    assert sign_at(x - 1, [x], root) == 1
    assert sign_at(x - 2, [x], root) == -1
    assert sign_at(x**3 - 2, [x], root) is None


def test_a_modulus_has_a_kink() -> None:
    """20 |cos x| sin x − 4/3 |cos x| = 12 sin x has one root in (0, 0.5), by a table of its signs."""
    f = 20 * sp.Abs(sp.cos(x)) * sp.sin(x) - sp.Rational(4, 3) * sp.Abs(sp.cos(x)) - 12 * sp.sin(x)
    found = real_roots([f], [x], [(0, 1.2)])
    table = [(n / 100, float(f.xreplace({x: sp.Float(n / 100)}))) for n in range(121)]
    changes = [a for (a, left), (_, right) in pairwise(table) if left * right < 0]
    assert found.complete
    assert [math.floor(float(r.values[0]) * 100) / 100 for r in found.roots] == changes
    assert len(changes) == 2


def test_three_unknowns() -> None:
    """By hand: a + b = 1 − c and a b = c in a² + b² + c² = 3 give c² − 2c − 1 = 0, and a, b are real for c = 1 − √2."""
    p, q, r = sp.symbols("p q r", real=True)
    found = real_roots([p**2 + q**2 + r**2 - 3, p * q - r, p + q + r - 1], [p, q, r], [(-3, 3)] * 3)
    c = 1 - math.sqrt(2)
    root = math.sqrt((1 - c) ** 2 - 4 * c)
    ends = sorted(((1 - c) - sign * root) / 2 for sign in (1, -1))
    assert found.complete
    assert [[float(v) for v in x.values] for x in found.roots] == [
        pytest.approx([ends[0], ends[1], c]),
        pytest.approx([ends[1], ends[0], c]),
    ]


def test_a_pivot_that_is_zero_but_for_rounding() -> None:
    """The slopes of a four-bar linkage with two rods in line: SymPy takes 10⁻⁶¹ for a pivot, and ends in an error."""
    slope = sp.Matrix([[sp.Float("-6e-61", 60), -18, 18], [-sp.sqrt(3), 3, -1], [1, 2, -1]]).evalf(60)
    residual = sp.Matrix([1, 2, 3])
    step = numerical_roots._solved(slope, residual)
    assert step is not None
    assert (slope * sp.Matrix(step) - residual).norm() < 1e-40
    assert numerical_roots._solved(sp.Matrix([[1, 2], [2, 4]]), sp.Matrix([1, 1])) is None


def test_roots_that_fill_a_curve_end_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    """A circle of roots needs ever more boxes; after a few that stay undecided nothing more is tried."""
    krawczyk = numerical_roots._System.krawczyk
    tried = []

    def counted(system: numerical_roots._System, box: numerical_roots.RootBox) -> numerical_roots.RootBox | None:
        tried.append(box)
        return krawczyk(system, box)

    monkeypatch.setattr(numerical_roots._System, "krawczyk", counted)
    circle = x**2 + y**2 - 1
    found = real_roots([circle, circle * (x - 3), z], [x, y, z], [(-2, 2)] * 3)
    assert not found.complete
    assert 0 < len(tried) < 1000
