"""Sums of reactions along unit vectors that turn."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.mechanics.rewriting.turned_reactions import sum_along_axes, turning_axes
from tests.support.shared import solved

a, b = sp.symbols("a b", positive=True)
u = sp.Symbol("u", real=True)
AHEAD = Vector((sp.cos(u), sp.sin(u), sp.S.Zero))
ASIDE = Vector((-sp.sin(u), sp.cos(u), sp.S.Zero))
AXES = ((VectorSymbol("ahead"), AHEAD), (VectorSymbol("aside"), ASIDE))
I, J = (Vector(tuple(sp.Integer(k == n) for k in range(3))) for n in range(2))


def test_two_forces_in_the_directions_of_a_wheel() -> None:
    shares = [(I, a * sp.cos(u) - b * u * sp.sin(u)), (J, a * sp.sin(u) + b * u * sp.cos(u))]
    assert sum_along_axes(shares, AXES) == sp.Add(a * VectorSymbol("ahead"), b * u * VectorSymbol("aside"))


def test_what_gains_little_or_leaves_the_plane_stays() -> None:
    K = Vector((sp.S.Zero, sp.S.Zero, sp.S.One))
    assert sum_along_axes([(I, a), (J, b)], AXES) is None
    assert sum_along_axes([(I, a * sp.cos(u)), (K, a * sp.sin(u))], AXES) is None
    assert sum_along_axes([(I, a * sp.cos(u) ** 3)], AXES) is None


def test_the_axes_of_a_coin_are_perpendicular() -> None:
    axes = {symbol.name: e for symbol, e in turning_axes(solved("coin-on-incline", complete=False))}
    assert {"ahead", "axle", "i", "j", "k"} <= {*axes}
    assert sp.simplify(axes["ahead"].dot(axes["axle"])) == 0
