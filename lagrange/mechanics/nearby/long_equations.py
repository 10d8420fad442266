"""Equations of motion with multipliers of a system in which nothing is eliminated, written with abbreviations.

    Σ m r''·∂r/∂q_k + Σ dH/dt·ω_k − Q_k = Σ λ a_k

is put together from the accelerations as they come, without multiplying out. Whatever occurs in it several times gets a
name z_1, z_2, ..., each defined by earlier ones only: so the equations of a bicycle are some hundred short lines,
quickly evaluated by a program; multiplied out they fill fifty pages.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.core.records import record
from lagrange.core.verdicts import all_hold
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations, share_of_damper, share_of_spring
from lagrange.problem.model import Problem


@record
class LongEquations:
    """The equations of motion in abbreviations.

    definitions  z_1, z_2, ... in their order; a definition contains symbols of the problem, and earlier ones
    left         shape (n,): the left sides, without reactions
    right        shape (n,): the reactions, Σ λ a_k
    whole        shape (n,): the left sides without abbreviations
    """

    definitions: Mapping[sp.Symbol, sp.Expr]
    left: tuple[sp.Expr, ...]
    right: tuple[sp.Expr, ...]
    whole: tuple[sp.Expr, ...]


def long_equations(problem: Problem, configuration: Configuration) -> LongEquations:
    """D'Alembert's principle for each coordinate, in abbreviations."""
    whole = tuple(_coefficients(configuration))
    n = len(configuration.slots.coordinates)
    used = [r for r in configuration.rows if not r.is_identity]
    right = [sp.Add(*(r.multiplier * r.coefficients[k] for r in used)) for k in range(n)]
    taken = {name.partition("_")[0] for name in problem.scope.names()}
    definitions, short = abbreviated([*whole, *right], taken)
    return LongEquations(definitions, tuple(short[:n]), tuple(short[n:]), whole)


def _coefficients(configuration: Configuration) -> list[sp.Expr]:
    """Σ m r''·∂r/∂q_k + Σ dH/dt·ω_k − Q_k."""
    slots = configuration.slots
    turning = {r.name: r for r in configuration.rotations}
    centres = {p.name: p for p in configuration.points}
    totals = []
    for k, (q, v) in enumerate(zip(slots.coordinates, slots.velocities, strict=True)):
        terms = [p.mass * p.acceleration.dot(p.partials[k]) for p in configuration.points if p.mass != 0]
        terms += [r.momentum_rate.dot(r.partials[k]) for r in configuration.rotations if r.has_inertia]
        for load in configuration.loads:
            moved = centres[load.on].partials[k] if load.on in turning else load.point.partial(q)
            terms.append(-load.vector.dot(moved))
        terms += [-m.dot(r.partials[k]) for name, r in turning.items() for m in configuration.moments_on(name)]
        terms += [-share_of_spring(s, q) for s in configuration.springs]
        terms += [-share_of_damper(d, v, slots) for d in configuration.dampers]
        field = configuration.potential - sp.Add(*(s.energy for s in configuration.springs))
        terms.append(field.diff(q))
        terms += [-configuration.generalized[k]] if configuration.generalized else []
        totals.append(sp.Add(*terms))
    return totals


def abbreviated(
    expressions: Sequence[sp.Expr], taken: Collection[str]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Names z_1, z_2, ... for what occurs several times in some expressions, and the expressions with these names.

    taken  names, up to an index, that must not be used
    """
    uses: Counter[sp.Expr] = Counter()
    stack = list(expressions)
    while stack:  # each distinct part once; a part of a part that is named is not counted again
        e = stack.pop()
        for a in e.args:
            if a.args and not a.is_number:
                uses[a] += 1
                if uses[a] == 1:
                    stack.append(a)
    definitions: dict[sp.Symbol, sp.Expr] = {}
    known: dict[sp.Expr, sp.Expr] = {}

    def written(e: sp.Expr) -> sp.Expr:
        if not e.args or e.is_number:
            return e
        if e not in known:
            inner = [written(a) for a in e.args]
            short = e.func(*inner, evaluate=False) if e.is_Add or e.is_Mul or e.is_Pow else e.func(*inner)
            if uses[e] > 1 and not (e.is_Mul and len(e.args) == 2 and e.args[0] == -1):
                name = _name(len(definitions) + 1, taken)
                definitions[name] = short
                short = name
            known[e] = short
        return known[e]

    return definitions, [written(e) for e in expressions]


def _name(number: int, taken: Collection[str]) -> sp.Symbol:
    letter = next(c for c in ("z", "Z", "zz", "ZZ", "zzz") if c not in taken)
    return sp.Symbol(f"{letter}_{number}", real=True)


def check_long_equations(equations: LongEquations, configuration: Configuration) -> list[Check]:
    """Lagrange's equations, differentiated in symbols, at random points of a prime field."""
    others = lagrange_equations(configuration).left
    surface = Surface()
    verdicts = [surface.is_zero(a - b) for a, b in zip(equations.whole, others, strict=True)]
    how = "exact, at random points: T differentiated, nothing multiplied out"
    return [Check("Lagrange's equations give the same equations of motion", all_hold(verdicts), how)]
