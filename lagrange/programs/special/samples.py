"""Sample functions for those that the file leaves open, so that the system can be drawn, moved and simulated.

A surface f(x − u t, y, z) = c of no particular shape becomes a bowl, f = Z − (X² + Y²)/4, a curve y = f(x) a parabola;
a potential U(r) becomes that of a spring, a resistance D(v) one that is proportional to the speed. A force F_x(x, ...)
along a Cartesian axis is zero, except for the weight of a particle on a surface. A prescribed motion u(t) oscillates
about a mean. The page and the report of a simulation state these choices.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.core.symbols import Unspecified, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.results import Solution

SampleFunctions = dict[str, sp.Expr]
"""By name of a function: what is taken for it, in the names of its arguments."""
UNDECLARED_GRAVITY = sp.Symbol("g", positive=True)
"""In samples of a problem that has no `g` of its own."""
AMPLITUDE, FREQUENCY = 0.3, 2.0
"""Of a prescribed motion, in SI units."""


def samples(solution: Solution) -> SampleFunctions:
    """What is taken for each function of the problem that has no value."""
    configuration = solution.own.configuration
    relations = [sp.sympify(f, strict=True) for f in configuration.finite_constraints]
    bound = {f.name for r in relations for f in r.atoms(Unspecified)}
    out: SampleFunctions = {}
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


def oscillation(u: sp.Symbol, drawn: Mapping[sp.Symbol, float]) -> sp.Expr:
    """What is taken for a prescribed motion u(t): an oscillation about its place in the figure."""
    mean, size, rate = (sp.Float(f"{x:.6g}") for x in (drawn.get(u, 0.5), AMPLITUDE, FREQUENCY))
    return sp.Add(mean, size * sp.sin(rate * t))
