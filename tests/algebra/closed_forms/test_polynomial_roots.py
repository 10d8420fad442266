"""Real roots in closed form, against SymPy's numerical roots at random values of the parameters.

Equations that are linear in powers of the unknowns, and forms that vanish at the origin alone.
"""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.polynomial_roots import (
    irreducible_factors,
    numerator,
    other_wave,
    polynomial_roots,
    shortest_value,
    solved_for_powers,
    square_root,
    vanish_at_origin_alone,
    zeros_of_even_sum,
)

x, p = sp.symbols("x p", real=True)
a, b, c = sp.symbols("a b c", positive=True)
RELATIONS = {"≥": sp.Ge, "≤": sp.Le, ">": sp.Gt, "<": sp.Lt, "≠": sp.Ne}
SOLVED = [
    a * x - b, p * x + b, x**2 - a, x**2 + a, x**2 - p, a * x**2 + p * x - c, a * x**2 + p * x + c, -a * x**2 + b * x + c,
    (b - c) * x**2 - a, (b**2 - c**2) * x**2 + a**2, (a - b) * x**4 + c,
    x**3 - a, x**3 - p, x**3 + a, x**4 - a, x**4 + a, x**4 - p * x**2 - a, x**4 - 3 * a * x**2 + a**2,
]  # fmt: skip


@pytest.mark.parametrize("f", SOLVED, ids=str)
def test_the_roots_are_all_real_roots(f: sp.Expr) -> None:
    found = polynomial_roots(f, x)
    assert found is not None
    random = Random(2)
    for _ in range(12):
        there = {s: sp.Rational(random.randint(1, 60), random.randint(1, 12)) for s in (a, b, c)}
        there[p] = sp.Rational(random.choice([-1, 1]) * random.randint(1, 60), random.randint(1, 12))
        real = [
            v
            for v in found
            if all(RELATIONS[k.relation](k.lhs.xreplace(there), k.rhs.xreplace(there)) for k in v.conditions)
        ]
        ours = sorted(float(v.value.xreplace(there).evalf(20)) for v in real)
        theirs = sorted(
            float(r) for r in sp.Poly(f.xreplace(there), x).nroots(n=20, maxsteps=200) if abs(sp.im(r)) < 1e-12
        )
        assert ours == pytest.approx(theirs, rel=1e-9)
        assert not any(v.value.has(sp.I) for v in found)
        for v in real:
            if v.stated is not None:
                assert (v.value**v.power - v.stated).xreplace(there).evalf(20) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("f", [x**3 + a * x + b, x**5 - x - a, x**9 - a, sp.sin(x) - a, sp.S.One * a], ids=str)
def test_what_is_not_solved_is_none(f: sp.Expr) -> None:
    assert polynomial_roots(f, x) is None


def test_factors_are_each_given_once() -> None:
    found = irreducible_factors((x - a) ** 3 * (x + b) * 6)
    assert found is not None
    assert sorted(map(str, found)) == sorted(map(str, [x - a, x + b]))
    assert irreducible_factors(sp.Add(*(sp.Symbol(f"s{n}") for n in range(20)))) is None


def test_numerator_in_lowest_terms() -> None:
    found = numerator((x**2 - a**2) / (x - a) + 1 / b)
    assert found is not None
    above, below = found
    assert sp.expand(above / below - (x + a + 1 / b)) == 0
    assert sp.degree(above, x) == 1


@pytest.mark.parametrize("e", [a**2 * b, 4 * a, a**3 / b**2, a**2 * (b + c), (a + b) ** 2 / c], ids=str)
def test_a_square_root_has_its_square(e: sp.Expr) -> None:
    assert sp.simplify(square_root(e) ** 2 - e) == 0


# Linear in powers


x_linear_in_powers, y, z = sp.symbols("x y z", real=True)
a_linear_in_powers, b_linear_in_powers, c_linear_in_powers = sp.symbols("a b c", positive=True)


@pytest.mark.parametrize(
    ("sum_of_powers", "zero"),
    [
        (2 * x_linear_in_powers**2 + y**2, True),
        (-3 * x_linear_in_powers**4 - x_linear_in_powers**2 * y**2 - y**6, True),
        (x_linear_in_powers**2 - y**2, False),
        (x_linear_in_powers**2 + x_linear_in_powers**2 * y**2, False),  # y has no power of its own
        (x_linear_in_powers**2 + y**3, False),
    ],
)
def test_a_sum_of_even_powers_vanishes_where_all_unknowns_do(sum_of_powers: sp.Expr, zero: bool) -> None:
    assert zeros_of_even_sum(sum_of_powers, (x_linear_in_powers, y)) == ((x_linear_in_powers, y) if zero else ())


def test_equations_linear_in_squares_are_solved_for_them() -> None:
    assert solved_for_powers(
        [2 * x_linear_in_powers**2 - 3 * y**2, 3 * x_linear_in_powers**2 - 2 * y**2], [x_linear_in_powers, y]
    ) == (x_linear_in_powers**2, y**2)
    assert solved_for_powers(
        [2 * x_linear_in_powers**2 + y**2 - a_linear_in_powers, x_linear_in_powers**2 + 2 * y**2 - b_linear_in_powers],
        [x_linear_in_powers, y],
    ) == (
        3 * x_linear_in_powers**2 - 2 * a_linear_in_powers + b_linear_in_powers,
        3 * y**2 + a_linear_in_powers - 2 * b_linear_in_powers,
    )
    assert (
        solved_for_powers(
            [2 * x_linear_in_powers**2 - 3 * y**2, 4 * x_linear_in_powers**2 - 6 * y**2], [x_linear_in_powers, y]
        )
        is None
    )  # one line
    assert (
        solved_for_powers([x_linear_in_powers**2 - y**2, x_linear_in_powers * y - z], [x_linear_in_powers, y, z])
        is None
    )  # more monomials than equations
    assert (
        solved_for_powers(
            [x_linear_in_powers * y - a_linear_in_powers, x_linear_in_powers * z - b_linear_in_powers],
            [x_linear_in_powers, y, z],
        )
        is None
    )  # of products: a skate, λ sin θ and λ cos θ
    assert (
        solved_for_powers(
            [x_linear_in_powers**2 - a_linear_in_powers, y**2 - b_linear_in_powers], [x_linear_in_powers, y]
        )
        is None
    )  # solved already


@pytest.mark.parametrize(
    ("forms", "alone"),
    [
        ([2 * x_linear_in_powers**2 - 3 * y**2, 3 * x_linear_in_powers**2 - 2 * y**2], True),
        ([c_linear_in_powers * (2 * x_linear_in_powers**2 + 3 * x_linear_in_powers * y + 8 * y**2)], True),
        ([x_linear_in_powers**2 + 3 * x_linear_in_powers * y + 2 * y**2], False),
        ([4 * x_linear_in_powers**3 + y**3, x_linear_in_powers**2 - y**2], True),
        ([x_linear_in_powers * y, y**2], False),  # y = 0
        ([x_linear_in_powers * y, x_linear_in_powers**2], False),
        ([x_linear_in_powers**2 - y**2, x_linear_in_powers**3 - y**3], False),  # x = y
        ([x_linear_in_powers**2 + y], False),  # of no one degree
        (
            [
                a_linear_in_powers * x_linear_in_powers**2
                + b_linear_in_powers * y**2
                - c_linear_in_powers * x_linear_in_powers * y
            ],
            False,
        ),  # it depends on the letters
    ],
)
def test_forms_in_two_unknowns(forms: list[sp.Expr], alone: bool) -> None:
    assert vanish_at_origin_alone(forms, [x_linear_in_powers, y]) is alone


@pytest.mark.parametrize(
    ("potential", "points"),
    [
        (c_linear_in_powers * (x_linear_in_powers**4 + y**4 - 3 * x_linear_in_powers**2 * y**2), 1),
        (x_linear_in_powers**4 + x_linear_in_powers * y**3 + 2 * y**4 + x_linear_in_powers**2 * y**2, 1),
        (
            x_linear_in_powers**4
            + y**4
            + z**4
            - 3 * x_linear_in_powers**2 * y**2
            - 5 * y**2 * z**2
            - x_linear_in_powers**2 * z**2,
            1,
        ),
        (x_linear_in_powers**6 + y**6 - 3 * x_linear_in_powers**2 * y**2, 5),  # and |x| = |y| = 1
    ],
)
def test_no_branch_that_is_only_the_origin_is_left_as_equations(potential: sp.Expr, points: int) -> None:
    unknowns = sorted(potential.free_symbols - {c_linear_in_powers}, key=str)
    found = solutions([potential.diff(u) for u in unknowns], unknowns)
    assert found.solved
    assert sum(len(b.points) for b in found.branches) == points
    assert not any(b.left for b in found.branches)


def test_equations_linear_in_cosines() -> None:
    """2 cos φ + 1 = 3 cos θ and 2 cos θ + 1 = 3 cos φ hold where both cosines are 1."""
    found = solutions(
        [1 - 3 * sp.cos(x_linear_in_powers) + 2 * sp.cos(y), 1 - 3 * sp.cos(y) + 2 * sp.cos(x_linear_in_powers)],
        [x_linear_in_powers, y],
    )
    assert [{r.lhs: r.rhs for r in branch.relations} for branch in found.branches] == [{x_linear_in_powers: 0, y: 0}]


def test_squares_that_exist_under_conditions() -> None:
    """V = x⁴ + y⁴ + x² y² − a x² − b y² has x² = (2a − b)/3, y² = (2b − a)/3 where neither is negative."""
    v = (
        x_linear_in_powers**4
        + y**4
        + x_linear_in_powers**2 * y**2
        - a_linear_in_powers * x_linear_in_powers**2
        - b_linear_in_powers * y**2
    )
    found = solutions([v.diff(x_linear_in_powers), v.diff(y)], [x_linear_in_powers, y])
    both = [branch for branch in found.branches if branch.conditions]
    assert len(both) == 4
    assert len(found.branches) == 9
    for branch in both:
        values = {r.lhs: r.rhs for r in branch.relations}
        assert sp.expand(values[x_linear_in_powers] ** 2 - (2 * a_linear_in_powers - b_linear_in_powers) / 3) == 0
        assert sp.expand(values[y] ** 2 - (2 * b_linear_in_powers - a_linear_in_powers) / 3) == 0
        assert {(k.lhs, k.rhs) for k in branch.conditions} == {
            (2 * b_linear_in_powers, a_linear_in_powers),
            (2 * a_linear_in_powers, b_linear_in_powers),
        }


# -- Values as a book would print them ---------------------------------------------------------------------------------


B, W, l, b, g, M, m = sp.symbols("B W l b g M m", positive=True)


@pytest.mark.parametrize(
    ("long", "short"),
    [
        ((B * l + 2 * W * b) / (2 * l), "B/2 + W*b/l"),
        ((B * l + 2 * W * (l - b)) / (2 * l), "B/2 - W*b/l + W"),
        (g * (M / m + 1) / 2, "g*(M + m)/(2*m)"),
        ((l**2 + b**2) / (b * l), "(b**2 + l**2)/(b*l)"),  # and not b/l + l/b
        (g * (m - M) / (-m - M), "g*(M - m)/(M + m)"),
    ],
)
def test_a_value_is_in_its_shortest_form(long: sp.Expr, short: str) -> None:
    found = shortest_value(long)
    assert sp.cancel(found - long) == 0
    assert str(found) == short


def test_the_cosine_of_a_sine_with_a_root_has_no_root_of_what_is_negative() -> None:
    a, R = sp.symbols("a R", positive=True)
    found = other_wave((a - b) / (2 * sp.sqrt(R**2 - a * b)))
    assert sp.expand(found**2 * 4 * (R**2 - a * b)) == sp.expand(4 * R**2 - (a + b) ** 2)
    roots = [x.base.xreplace({R: 1, a: sp.Rational(1, 2), b: sp.Rational(1, 3)}) for x in found.atoms(sp.Pow)]
    assert all(base > 0 for base in roots)
