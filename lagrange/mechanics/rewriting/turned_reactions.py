"""The sum of several reactions along unit vectors that turn with a body, where that is shorter than each by itself.

The two forces that keep a coin from slipping, along i and j of the plane, are sums of products of sin θ and cos θ.
Along the heading and the axle of the coin each is one term: R = Σ λ_j g_j = Σ (R·e) e for perpendicular unit vectors e.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.symbols import UnitVector, VectorSymbol
from lagrange.core.vectors import FIXED, UNITS, Vector
from lagrange.mechanics.limits import LONGEST_IN_DIRECTIONS, SHORTER_ALONG_AXES
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import in_factors
from lagrange.mechanics.rewriting.held_coordinates import held_values
from lagrange.mechanics.rewriting.named_directions import unit_directions

Axes = Sequence[tuple[sp.Symbol, Vector]]
"""Unit vectors: the symbol of each, and what it is in i, j, k."""


def turning_axes(solution: Solution) -> Axes:
    """The unit vectors that turn and have names: those of the file and its frame, axes of bodies; and i, j, k."""
    named = {n: (VectorSymbol(n), v) for n, v in unit_directions(solution.problem).items()}
    for rotation in solution.own.configuration.rotations:
        triad = rotation.angular_velocity.triad
        if triad == FIXED or triad.directions is None:
            continue
        for n, unit in enumerate(triad.units):
            row = triad.directions[n, :]
            named.setdefault(unit.name, (unit, Vector((row[0], row[1], row[2]))))
    known = [(symbol, where_constant(solution, v)) for symbol, v in named.values()]
    turning = [(symbol, v) for symbol, v in known if any(c.free_symbols for c in v.components)]
    fixed = [(UnitVector(n), Vector(tuple(sp.Integer(k == m) for m in range(3)))) for k, n in enumerate(UNITS)]
    return (*turning, *fixed) if turning else ()


def where_constant(solution: Solution, v: Vector) -> Vector:
    """A vector in i, j, k, with the coordinates that constraints keep constant."""
    held = held_values(solution.own.configuration)
    return v.fixed().map(lambda c: textbook_form(c.xreplace(held)))


def sum_along_axes(shares: Sequence[tuple[Vector, sp.Expr]], axes: Axes) -> sp.Expr | None:
    """The sum of force times direction along perpendicular unit vectors; None where that is not much shorter.

    shares  of each reaction, its direction for a force 1, and the force
    """
    before = sum(count_operations(value) for _, value in shares)
    if len(shares) < 2 or before > LONGEST_IN_DIRECTIONS:
        return None
    total = sum((direction.fixed() * value for direction, value in shares), Vector.zero())
    return min(
        (form for form in _forms(total, axes) if count_operations(form) <= SHORTER_ALONG_AXES * before),
        key=count_operations,
        default=None,
    )


def _forms(total: Vector, axes: Axes) -> Iterator[sp.Expr]:
    """The vector along each set of perpendicular axes that it takes; components that vanish are not written."""
    parts = [(symbol, e, _component(total, e)) for symbol, e in axes]
    parts = [(symbol, e, c) for symbol, e, c in parts if c != 0]
    for number in (1, 2, 3):
        for some in combinations(parts, number):
            if all(is_zero(a.dot(b)) is True for (_, a, _), (_, b, _) in combinations(some, 2)):
                rest = total - sum((e * c for _, e, c in some), Vector.zero())
                if all(is_zero(c) is True for c in rest.components):
                    yield sp.Add(*(symbol * c for symbol, _, c in some), evaluate=False)


def _component(total: Vector, e: Vector) -> sp.Expr:
    """The component along a unit vector, in factors."""
    above, below = sp.fraction(sp.together(total.dot(e)))
    quotient = textbook_form(sp.expand(above)) / below
    return sp.S.Zero if is_zero(quotient) is True else in_factors(sp.cancel(quotient) if below.is_Add else quotient)
