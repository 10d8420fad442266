"""Coordinates and velocities that the constraints give outright in terms of the others.

x = l sin θ gives x and x' wherever they occur, so that the equations of a question are left with θ and θ' alone. A
symbol is expressed where it occurs linearly, with a factor of known sign and nowhere else in the constraint.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.exact.zero_test import vanishes
from lagrange.core.operations import count_operations
from lagrange.mechanics.constraints.kinematics import Configuration

Substitution = Mapping[sp.Symbol, sp.Expr]


def dependent(
    configuration: Configuration, rather_not: Collection[sp.Symbol] = (), never: sp.Symbol | None = None
) -> dict[sp.Symbol, sp.Expr]:
    """The symbols that are expressed, each in terms of those that are not.

    rather_not  symbols that are expressed only where no other can be
    never       a symbol that is not expressed
    """
    slots = configuration.slots
    rule: dict[sp.Symbol, sp.Expr] = {}
    coordinates = [q for q in slots.coordinates if q != never]
    _express(configuration.finite_constraints, coordinates, rather_not, rule)
    _express([r.velocity_form(slots) for r in configuration.rows], slots.velocities, rather_not, rule)
    return rule


def _express(
    equations: Sequence[sp.Expr],
    symbols: Sequence[sp.Symbol],
    rather_not: Collection[sp.Symbol],
    rule: dict[sp.Symbol, sp.Expr],
) -> None:
    """Adds what the equations give, one after another, to the rule."""
    for e in equations:
        present = e.xreplace(rule)
        for s in sorted((s for s in symbols if s in present.free_symbols), key=lambda s: s in rather_not):
            slope = present.diff(s)
            if s in slope.free_symbols or not _has_sign(slope):
                continue
            value = sp.expand(-present.xreplace({s: sp.S.Zero}) / slope)
            for other, known in rule.items():
                rule[other] = known.xreplace({s: value})
            rule[s] = value
            break


def held_at(rule: Substitution, held: Substitution) -> dict[sp.Symbol, sp.Expr]:
    """What is dependent where some symbols keep their values, and these symbols."""
    values = dict(held)
    return {**{s: e.xreplace(values) for s, e in rule.items()}, **values}


def _has_sign(slope: sp.Expr) -> bool:
    return slope != 0 and count_operations(slope) < 20 and sign_of(slope) in (1, -1)


def reduced(equations: Sequence[sp.Expr], rule: Substitution) -> list[sp.Expr]:
    """The equations with what is dependent expressed, without those that hold by themselves."""
    changed = [e.xreplace(dict(rule)) for e in equations]
    return [e for e, old in zip(changed, equations, strict=True) if e is old or e == old or not vanishes(e)]


def completed(state: Substitution, rule: Substitution, moving: Collection[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """A state with the dependent symbols that it determines; `moving` are all coordinates and velocities."""
    values = {s: e.xreplace(dict(state)) for s, e in rule.items() if s not in state}
    return {**state, **{s: v for s, v in values.items() if v.free_symbols.isdisjoint(moving)}}
