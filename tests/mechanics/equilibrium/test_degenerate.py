"""Minima that the second variation leaves open in one direction: the potential along the valley."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Source
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.degenerate import along_valley, rises_in_even_powers
from lagrange.mechanics.equilibrium.stability import StabilityVerdict
from lagrange.problem.loader import read_problem
from lagrange.render import terminal

x, y, z = sp.symbols("x y z", real=True)
a, b = sp.symbols("a b", positive=True)


def first(potential: sp.Expr, coordinates: tuple[sp.Symbol, ...]) -> tuple[int, sp.Expr] | None:
    """The first derivative along x that does not vanish, at the origin."""
    origin = dict.fromkeys(coordinates, sp.S.Zero)
    found = along_valley(
        sp.hessian(potential, coordinates).tolist(), 0, lambda f, j: f.diff(coordinates[j]), lambda f: f.subs(origin)
    )
    return next(((n, v) for n, v in found if v != 0), None)


@pytest.mark.parametrize(
    ("potential", "expected"),
    [
        (a * (x**4 + y**2), (4, 24 * a)),
        (a * (y - x**2) ** 2 - b * x**4, (4, -24 * b)),
        (a * (y - x**2) ** 2 + b * x**6, (6, 720 * b)),
        (a * (x - y) ** 2 + b * x**3, (3, 6 * b)),
        (a * (x - y) ** 2 + b * y**4, (4, 24 * b)),
        (a * y**2 + 2 * b * x * y * (1 - sp.cos(x)) + x**4, (4, sp.Integer(24))),
        (a * (y - sp.sin(x) ** 2) ** 2 + b * (1 - sp.cos(x)) ** 2, (4, 6 * b)),
        (a * (y - x**2) ** 2, None),
        (a * (y - x**2) ** 2 + b * (z - x * y) ** 2 + x**4 + y * z * x, (4, sp.Integer(24))),
    ],
    ids=str,
)
def test_the_potential_along_the_valley(potential: sp.Expr, expected: tuple[int, sp.Expr] | None) -> None:
    """By hand: a (y − x²)² − b x⁴ has the valley y = x², where it falls as −b x⁴, although both axes rise."""
    coordinates = (x, y, z) if potential.has(z) else (x, y)
    found = first(potential, coordinates)
    assert found == expected or (
        found and expected and (found[0], sp.simplify(found[1] - expected[1])) == (expected[0], 0)
    )


def test_a_valley_decides_and_is_told() -> None:
    text = """
title: v
parameters: [c]
coordinates: [x, y]
forces: {v: {potential: "c*(x^4 + y^2)"}}
find: equilibrium
"""
    told = report(read_problem(Source("problem.yaml", text)))
    assert told.solution.own.stability is not None
    assert [(s.verdict, s.order) for s in told.solution.own.stability.verdicts] == [(StabilityVerdict.STABLE, 4)]
    page = " ".join(terminal.text(told.derivation, told.notation, 100).split())
    assert "Along the valley of V in that direction" in page
    assert "with respect to x is 24c, of order 4, even, and positive: stable." in page


def test_sums_of_even_powers() -> None:
    x, y = sp.symbols("x y", real=True)
    c = sp.Symbol("c", positive=True)
    cases = {
        c * (x**4 + y**4 + x**2 * y**2): True,
        c * (x**4 + y**2): True,
        c * (x**4 - y**4): False,
        c * (x**4 + y**4 - 3 * x**2 * y**2): False,
        c * x**2 * y**2 + x**4: False,
        c * (x**4 + y**4) + x * y**5: False,
    }
    for v, expected in cases.items():
        assert rises_in_even_powers([v.diff(x), v.diff(y)], [(x, sp.S.Zero), (y, sp.S.Zero)]) is expected
    there = c * ((x - 2) ** 4 + (y + 1) ** 6)
    assert rises_in_even_powers([there.diff(x), there.diff(y)], [(x, sp.Integer(2)), (y, sp.Integer(-1))])
