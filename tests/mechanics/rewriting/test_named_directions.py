"""Vectors written by the unit vectors that a file names."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.mechanics.rewriting.named_directions import in_named_directions

a, b, theta = sp.symbols("a b theta", positive=True)
s, c = sp.sin(theta), sp.cos(theta)
UNITS = {"s": Vector((c, s, sp.S.Zero)), "n": Vector((-s, c, sp.S.Zero))}
ALONG, ACROSS = VectorSymbol("s"), VectorSymbol("n")


@pytest.mark.parametrize(
    ("components", "written"),
    [
        ((-a * s, a * c, 0), a * ACROSS),
        (((a + b) * c, a * s + b * s, 0), (a + b) * ALONG),
        ((a * c - b * s, a * s + b * c, 0), a * ALONG + b * ACROSS),
    ],
)
def test_a_vector_along_named_unit_vectors(components: tuple[sp.Expr, ...], written: sp.Expr) -> None:
    x, y, z = map(sp.sympify, components)
    assert sp.expand(in_named_directions(Vector((x, y, z)), UNITS) - written) == 0


@pytest.mark.parametrize("components", [(a, b, 0), (c, a, 0), (0, a * s, 0)])
def test_what_would_not_be_shorter_stays(components: tuple[sp.Expr, ...]) -> None:
    x, y, z = map(sp.sympify, components)
    vector = Vector((x, y, z))
    assert in_named_directions(vector, UNITS) is vector


def test_nothing_is_divided_by_what_may_vanish() -> None:
    written = in_named_directions(Vector((a * s * c, a * (1 + c), sp.S.Zero)), UNITS)
    terms = written.as_sum() if isinstance(written, Vector) else written
    assert not sp.fraction(sp.together(terms))[1].has(sp.sin, sp.cos)


def test_three_perpendicular_vectors() -> None:
    """r'' of a pendulum on a cylinder's directions; with k as the third where two are named."""
    written = in_named_directions(Vector((a * c - b * s, a * s + b * c, a + b)), UNITS)
    assert isinstance(written, sp.Expr)
    assert {str(f) for f in written.free_symbols} == {"a", "b", "s", "n", "k"}
