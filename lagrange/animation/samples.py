"""Sample functions for those that the file leaves open, so that the figure can be drawn and moved.

A surface f(x − u t, y, z) = c of no particular shape becomes a bowl, f = Z − (X² + Y²)/4, a curve y = f(x) a parabola;
a potential U(r) becomes that of a spring, a resistance D(v) one that is proportional to the speed. A force F_x(x, ...)
along a Cartesian axis is zero, except for the weight of a particle on a surface. The page states these choices.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import Unspecified
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.results import Solution
from lagrange.programs.state_equations import filled

Samples = dict[str, sp.Expr]
"""By name of a function: what is taken for it, in the names of its arguments."""
UNDECLARED_GRAVITY = sp.Symbol("g", positive=True)
"""In samples of a problem that has no `g` of its own."""


def samples(solution: Solution) -> Samples:
    """What is taken for each function of the problem that has no value."""
    configuration = solution.own.configuration
    relations = [sp.sympify(f, strict=True) for f in configuration.finite_constraints]
    bound = {f.name for r in relations for f in r.atoms(Unspecified)}
    out: Samples = {}
    gravity = UNDECLARED_GRAVITY if "g" not in solution.problem.scope.names() else sp.Integer(10)
    for declared in solution.problem.functions:
        names = tuple(sp.Symbol(a, real=True) for a in declared.arguments)
        squares = sp.Add(*(a**2 for a in names))
        if declared.name in bound:
            implicit = any(_is_alone(r, declared.name, configuration) for r in relations) and len(names) > 1
            taken = names[-1] - (squares - names[-1] ** 2) / 4 if implicit else squares / 4
        elif sp.sympify(configuration.potential, strict=True).has(Unspecified) and len(names) == 1:
            taken = 2 * squares
        elif len(names) == 1 and not _component(configuration, declared.name):
            taken = names[0] / 5
        else:
            part = _component(configuration, declared.name)
            taken = -gravity * part if part is not None and bound else sp.S.Zero
        out[declared.name] = sp.sympify(taken, strict=True)
    return out


def _is_alone(relation: sp.Expr, name: str, configuration: Configuration) -> bool:
    """Whether a relation is f(...) = c, and not z = f(x, y)."""
    functions = [f for f in relation.atoms(Unspecified) if f.name == name]
    rest = relation.xreplace(dict.fromkeys(functions, sp.S.Zero))
    return bool(rest.free_symbols.isdisjoint(configuration.slots.coordinates))


def _component(configuration: Configuration, name: str) -> sp.Expr | None:
    """The mass of the particle on which the function is the last component of a force; None if it is none."""
    for load in configuration.loads:
        parts = load.vector.fixed().components
        last = next((c for c in reversed(parts) if c != 0), sp.S.Zero)
        if isinstance(last, Unspecified) and last.name == name:
            return next(p.mass for p in configuration.points if p.name == load.on)
    return None


def sampled(solution: Solution, taken: Samples) -> Solution:
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
