"""Equations between displacements in an answer: δz = λ δφ, x dx + y dy = 0, and d'Alembert's principle.

Such an equation is linear and homogeneous in the displacements. With possible displacements dq, dt it states what it
states of the velocities, for dq = q' dt. With virtual displacements, A δq = 0, the dependent ones are substituted
first; then it holds for all virtual displacements if and only if the coefficient of each independent one vanishes,

    δz = λ δφ                     0 = 0                          if z = λ φ is a constraint: this is restated
    (m x'' + k x) δx = 0          m x'' + k x = 0                if x is free

and these coefficients are compared like any other equations.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.symbols import differential, prime, t, variation
from lagrange.mechanics.constraints.displacements import virtual_displacements
from lagrange.mechanics.constraints.kinematics import Configuration

NOT_FOR_ALL = "it does not hold for all displacements that the constraints admit"


def displaced_coordinates(expressions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> frozenset[sp.Symbol]:
    """The coordinates whose displacements, dq or δq, occur in expressions."""
    used = {s for e in expressions for s in e.free_symbols}
    return frozenset(q for q in coordinates if used & {variation(q), differential(q)})


def without_displacements(equation: sp.Expr, configuration: Configuration) -> tuple[sp.Expr, ...]:
    """The equations, each zero, that state the same without displacements; the equation itself if it has none.

    One that is not linear and homogeneous in them is returned as it is, too.
    """
    slots = configuration.slots
    present = (*slots.coordinates, *configuration.expressed)
    virtual = [variation(q) for q in present if variation(q) in equation.free_symbols]
    possible = {d: rate for q in present if (d := differential(q)) in equation.free_symbols for rate in [prime(q)]}
    if differential(t) in equation.free_symbols:
        possible[differential(t)] = sp.S.One
    if bool(virtual) == bool(possible) or not _is_linear(equation, [*virtual, *possible]):
        return (equation,)
    if possible:
        return (configuration.rewritten(equation.xreplace(possible)),)
    chain = {
        variation(q): sp.Add(*(e.diff(p) * variation(p) for p in slots.coordinates))
        for q, e in configuration.expressed.items()
    }
    elimination = virtual_displacements(configuration.constrained)
    reduced = equation.xreplace(chain).xreplace(dict(elimination.solved(slots)))
    independent = [variation(slots.coordinates[k]) for k in elimination.independent]
    return tuple(reduced.diff(d) for d in independent if d in reduced.free_symbols) or (sp.S.Zero,)


def _is_linear(equation: sp.Expr, displacements: Sequence[sp.Symbol]) -> bool:
    """Whether an expression is linear and homogeneous in displacements."""
    rates = [equation.diff(d) for d in displacements]
    if any(not r.free_symbols.isdisjoint(displacements) for r in rates):
        return False
    return bool(equation.xreplace(dict.fromkeys(displacements, sp.S.Zero)) == 0)
