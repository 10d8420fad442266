"""Real roots in closed form, against SymPy's numerical roots at random values of the parameters."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import irreducible_factors, numerator, polynomial_roots, square_root

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
