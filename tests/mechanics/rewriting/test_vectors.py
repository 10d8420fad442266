"""Vectors written by the unit vectors that a file names.

Newton's law along named unit vectors.

Sums of reactions along unit vectors that turn.

Formulas in vectors are those of the components, and a wrong one is refused.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.conservation import EnergyRate
from lagrange.mechanics.rewriting.vectors import (
    Directions,
    curvature_term,
    in_named_components,
    in_named_directions,
    is_power,
    is_surface_multiplier,
    is_tension_of_link,
    sum_along_axes,
    turning_axes,
    unit_directions,
)
from tests.support.shared import solved

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


# Named components


DOWN = "cylinder-on-wedge"


def test_a_cylinder_on_a_wedge_along_the_slope() -> None:
    """m (X'' cos α + s'') = m g sin α + F: the normal force has no part in it; and the vectors add up to the same."""
    solution = solved(DOWN, complete=False)
    law = solution.law
    assert law is not None
    assert law.newton.bodies is not None
    body = next(b for b in law.newton.bodies if b.name == "cylinder")
    named = in_named_components(body, unit_directions(solution.problem))
    N, F = (r.force for r in law.newton.reactions)
    assert [{*c.right.free_symbols} & {N, F} for c in named.components] == [{F}, {N}]
    for axis in range(3):
        for part in ("inertia", "applied", "reaction"):
            before, after = (
                sp.Add(*(getattr(c, part) * c.along.fixed().components[axis] for c in b.components))
                for b in (body, named)
            )
            assert sp.simplify(before - after) == 0


def test_what_is_no_shorter_stays() -> None:
    law = solved(DOWN, complete=False).law
    assert law is not None
    assert law.newton.bodies is not None
    wedge, *_ = law.newton.bodies
    tilted: Directions = {"n": Vector((sp.Rational(3, 5), sp.Rational(4, 5), sp.S.Zero))}
    assert in_named_components(wedge, tilted) is wedge
    assert in_named_components(replace(wedge, components=()), tilted).components == ()


# Turned reactions


a_turned_reactions, b_turned_reactions = sp.symbols("a b", positive=True)
u = sp.Symbol("u", real=True)
AHEAD = Vector((sp.cos(u), sp.sin(u), sp.S.Zero))
ASIDE = Vector((-sp.sin(u), sp.cos(u), sp.S.Zero))
AXES = ((VectorSymbol("ahead"), AHEAD), (VectorSymbol("aside"), ASIDE))
I, J = (Vector(tuple(sp.Integer(k == n) for k in range(3))) for n in range(2))


def test_two_forces_in_the_directions_of_a_wheel() -> None:
    shares = [
        (I, a_turned_reactions * sp.cos(u) - b_turned_reactions * u * sp.sin(u)),
        (J, a_turned_reactions * sp.sin(u) + b_turned_reactions * u * sp.cos(u)),
    ]
    assert sum_along_axes(shares, AXES) == sp.Add(
        a_turned_reactions * VectorSymbol("ahead"), b_turned_reactions * u * VectorSymbol("aside")
    )


def test_what_gains_little_or_leaves_the_plane_stays() -> None:
    K = Vector((sp.S.Zero, sp.S.Zero, sp.S.One))
    assert sum_along_axes([(I, a_turned_reactions), (J, b_turned_reactions)], AXES) is None
    assert sum_along_axes([(I, a_turned_reactions * sp.cos(u)), (K, a_turned_reactions * sp.sin(u))], AXES) is None
    assert sum_along_axes([(I, a_turned_reactions * sp.cos(u) ** 3)], AXES) is None


def test_the_axes_of_a_coin_are_perpendicular() -> None:
    axes = {symbol.name: e for symbol, e in turning_axes(solved("coin-on-incline", complete=False))}
    assert {"ahead", "axle", "i", "j", "k"} <= {*axes}
    assert sp.simplify(axes["ahead"].dot(axes["axle"])) == 0


# Vector laws


g, m = sp.symbols("g m", positive=True)


def test_the_multiplier_of_a_particle_on_a_surface() -> None:
    """z = f(x, y) under its weight: λ |a|² = −m D − F·a, and no other multiple of it."""
    solution = solved("ex12-smooth-surface")
    own, law = solution.own, solution.law
    assert own.dynamics is not None
    assert own.dynamics.reactions is not None
    assert law is not None
    [row], [point] = own.configuration.rows, own.configuration.points
    [value] = own.dynamics.reactions.multipliers.values()
    force = sum((f.vector for f in law.configuration.loads), Vector.zero())
    assert value is not None
    assert is_surface_multiplier(value, own.configuration, point.mass, row.coefficients, force)
    assert not is_surface_multiplier(2 * value, own.configuration, point.mass, row.coefficients, force)
    assert not {*own.configuration.slots.accelerations} & curvature_term(own.configuration).free_symbols


def test_the_tension_of_a_link() -> None:
    own = solved("ex14-two-particles").own
    first, second = own.configuration.points
    assert own.dynamics is not None
    assert own.dynamics.reactions is not None
    [tension] = own.dynamics.reactions.sizes.values()
    loads = own.configuration.loads
    at_first, at_second = (
        sum((f.vector for f in loads if f.on == p.name), Vector.zero()).fixed() for p in (first, second)
    )
    length = next(s for s in own.configuration.rows[0].finite.free_symbols if s.name == "l")  # type: ignore[union-attr]
    assert tension is not None
    assert is_tension_of_link(tension, own.configuration, (at_first, at_second), length)
    assert not is_tension_of_link(-tension, own.configuration, (at_first, at_second), length)


def test_the_rate_of_the_energy_is_a_power() -> None:
    vx, vy = sp.symbols("x' y'", real=True)
    energy = EnergyRate(m * (vx**2 + vy**2) / 2, -m * g * vy)
    weight = Vector((sp.S.Zero, -m * g, sp.S.Zero))
    speeds = (vx, vy, sp.S.Zero)
    assert is_power(energy, m, weight, speeds, sp.S.Zero)
    assert not is_power(energy, m, weight, speeds, vx)
    assert not is_power(energy, 2 * m, weight, speeds, sp.S.Zero)
