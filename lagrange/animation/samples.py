"""Sample functions in the figure: the constraints with them, and the surface of a bowl."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.results import Solution
from lagrange.programs.special.samples import SampleFunctions
from lagrange.programs.state_equations import filled


def sampled(solution: Solution, taken: SampleFunctions) -> Solution:
    """The solution with the samples in the constraints of its configurations, for the figure."""
    if not taken:
        return solution

    own = solution.own.configuration

    def put(e: sp.Expr) -> sp.Expr:
        return filled(sp.sympify(e, strict=True), taken, own.slots, solution.problem)

    rows = tuple(
        replace(
            row,
            coefficients=tuple(map(put, row.coefficients)),
            drift=put(row.drift),
            finite=None if row.finite is None else put(row.finite),
        )
        for row in own.rows
    )
    drawn = replace(own, constrained=ConstrainedSystem(own.slots, rows))
    return replace(solution, own=replace(solution.own, configuration=drawn))


def surfaces(configuration: Configuration) -> Iterator[tuple[tuple[sp.Expr, ...], tuple[sp.Symbol, ...], sp.Expr]]:
    """The surface z = z(x, y) on which a relation keeps a particle at (x, y, z): its point, along what, its shift.

    Only where z can be solved for; the shift is that of the surface along its first coordinate.
    """
    for f in configuration.finite_constraints:
        for p in configuration.points:
            parts = p.position.fixed().components
            if not all(c.is_Symbol and c in configuration.slots.coordinates for c in parts):
                continue
            x, y, z = parts
            relation = sp.sympify(f, strict=True)
            slope = relation.diff(z)
            if slope != 0 and not slope.has(z) and not slope.has(x):
                height = sp.expand(z - relation / slope)
                bottom = sp.solve(sp.expand(height.diff(x)), x) if height.diff(x, 2) != 0 else []
                yield (x, y, height), (x, y), bottom[0] if len(bottom) == 1 and not bottom[0].has(y) else sp.S.Zero
                return
