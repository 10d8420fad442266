"""Poles of a chart among the equilibria: positions at which a coordinate moves nothing.

With r = l (sin θ cos φ, sin θ sin φ, −cos θ) the position θ = 0 is the same for every φ. There δφ moves nothing, and
the displacements δθ at one φ are not all the displacements of the particle. So Q_θ = Q_φ = 0 is necessary for
equilibrium, and sufficient only if it holds for every φ: a horizontal force is not balanced at θ = 0, although
Q_θ = F l cos φ vanishes for φ = π/2.

A crank at its dead centre is no pole. There ∂r/∂φ vanishes for one value of φ, not for all.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.mechanics.constraints.kinematics import Configuration


def idle_coordinates(configuration: Configuration, solution: SolutionSet, b: Branch) -> tuple[sp.Symbol, ...]:
    """The coordinates that change nothing at the points of a branch, whatever their values, but do so elsewhere."""
    coordinates = configuration.slots.coordinates
    if len(coordinates) == 1 or not b.points:
        return ()
    return tuple(
        q
        for k, q in enumerate(coordinates)
        if (effects := [e for e in _effects(configuration, k) if e != 0])
        and all(_all_vanish(effects, solution, _without(q, p, solution)) for p in b.points)
    )


def _effects(configuration: Configuration, k: int) -> Iterator[sp.Expr]:
    """What a displacement δq_k moves, turns, or violates."""
    q = configuration.slots.coordinates[k]
    for p in configuration.points:
        yield from p.partials[k].fixed().components
    for r in configuration.rotations:
        yield from r.partials[k].components
    for load in configuration.loads:
        yield from (c.diff(q) for c in load.point.fixed().components)
    for spring in configuration.springs:
        yield spring.distance.diff(q)
    for row in configuration.rows:
        yield row.coefficients[k]


def _without(q: sp.Symbol, point: Values, solution: SolutionSet) -> Values:
    """A point with a coordinate left open."""
    angle = solution.letters.angles.get(q)
    own = {q, *(angle.letters if angle else ())}
    return {s: v for s, v in point.items() if s not in own}


def _all_vanish(effects: list[sp.Expr], solution: SolutionSet, point: Values) -> bool:
    try:
        return all(is_zero(solution.at(point, e)) for e in effects)
    except (NotAlgebraicError, DivisionByZeroError):
        return False
