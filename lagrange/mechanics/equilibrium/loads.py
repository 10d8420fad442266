"""The loads at rest, and those among the parameters.

A damper has no force at rest, nor has a drag that is proportional to the velocity. A condition such as 2 k > l P is
that on the critical load, P < 2 k/l.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.conditions import OPPOSITE
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, sign_of
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.expression_size import count_operations
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.lagrangian import is_constant
from lagrange.mechanics.dynamics.principle import given_forces
from lagrange.mechanics.equilibrium.limits import LONGEST_POTENTIAL

WEIGHT = "weight"


def at_rest(configuration: Configuration) -> Configuration:
    """The system under the forces that act at rest. Raises NotCoveredError if one has no value there."""
    slots = configuration.slots
    still: dict[sp.Basic, sp.Basic] = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)

    def resting(name: str, vector: Vector) -> Vector:
        value = vector.xreplace(still)
        if any(c.has(sp.nan, sp.zoo) for c in value.components):
            raise NotCoveredError(f"rest under the force `{name}`, which has no value where the velocities vanish,")
        return value

    return replace(
        configuration,
        loads=tuple(replace(f, vector=resting(f.name, f.vector)) for f in configuration.loads),
        torques=tuple(replace(m, vector=resting(m.name, m.vector)) for m in configuration.torques),
        generalized=tuple(q.xreplace(still) for q in given_forces(configuration)),
        velocity_part=sp.S.Zero,
        dampers=(),
    )


def load_parameters(configuration: Configuration, unknown_forces: Sequence[sp.Symbol] = ()) -> tuple[sp.Symbol, ...]:
    """The parameters that are the size of an applied force or moment; weights and forces that vary are none.

    In a vector with an unknown force this is the size, and no parameter.
    """
    coordinates = {*configuration.slots.coordinates, *configuration.slots.velocities}
    vectors = [load.vector for load in configuration.loads if load.name != WEIGHT]
    vectors += [torque.vector for torque in configuration.torques]
    sizes: dict[sp.Symbol, None] = {}
    for vector in vectors:
        components = [c for c in vector.components if c != 0]
        outside = [c.xreplace({f: sp.Dummy() for f in c.atoms(*CIRCULAR)}) for c in components]
        if any(c.free_symbols & (coordinates | {*unknown_forces}) for c in outside):
            continue
        for s in sorted({s for c in components for s in c.free_symbols}, key=str):
            rates = [sp.expand(c).diff(s) for c in components]
            if (
                s.is_positive
                and all(s not in r.free_symbols for r in rates)
                and all(sp.expand(c - s * r) == 0 for c, r in zip(components, rates, strict=True))
            ):
                sizes[s] = None
    return tuple(sizes)


def for_loads(conditions: Sequence[SignCondition], configuration: Configuration) -> tuple[SignCondition, ...]:
    """Conditions solved for loads, in their shortest forms."""
    solved = solved_for(conditions, load_parameters(configuration))
    return tuple(
        SignCondition(shortest_form(c.lhs), c.relation, shortest_form(c.rhs)) if c.rhs != 0 else c for c in solved
    )


def solved_for(conditions: Sequence[SignCondition], loads: Sequence[sp.Symbol]) -> tuple[SignCondition, ...]:
    """Conditions that are linear in one of some parameters, the loads, solved for it: P < (3 − √5) k/(2 l)."""
    return tuple(_solved_for(c, loads) for c in conditions)


def _solved_for(c: SignCondition, loads: Sequence[sp.Symbol]) -> SignCondition:
    if c.lhs.has(sp.Abs) or c.rhs.has(sp.Abs):
        return c
    difference = sp.expand(c.lhs - c.rhs)
    occurring = [p for p in loads if p in difference.free_symbols]
    if len(occurring) > 1:
        return _by_loads(c, difference, occurring)
    if not occurring:
        return c
    [p] = occurring
    rate = difference.diff(p)
    if p in rate.free_symbols:
        return c
    rate = sp.factor(rate)
    if not (rate.is_positive or rate.is_negative):
        return c
    value = sp.factor(sp.together((p * rate - difference).expand() / rate))
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    value = sp.radsimp(number) * rest
    value = min((value, sp.expand(value)), key=lambda e: count_operations(e))
    if value.is_negative or value == 0 or value.could_extract_minus_sign():
        return c
    return replace(c, lhs=p, relation=c.relation if rate.is_positive else OPPOSITE[c.relation], rhs=value)


def _by_loads(c: SignCondition, difference: sp.Expr, loads: Sequence[sp.Symbol]) -> SignCondition:
    """A condition on a sum of multiples of loads, each on the side on which it is positive: b² Q > 2 P c²."""
    rates = {p: sp.factor(difference.diff(p)) for p in loads}
    senses = {p: sign_of(rate) for p, rate in rates.items()}
    left, right = (sp.Add(*(s * p * rates[p] for p in loads if senses[p] == s)) for s in (1, -1))
    if None in senses.values() or 0 in (left, right) or sp.expand(difference - left + right) != 0:
        return c
    return replace(c, lhs=left, rhs=right)


def potential_of_all(configuration: Configuration, force: sp.Expr) -> sp.Expr | None:
    """V(q) of one coordinate, of springs, fields and constant forces together, as far as it varies.

    None if another force acts, or if −dV/dq is not the given generalized force.
    """
    if configuration.torques or configuration.generalized or configuration.rows:
        return None
    if not all(is_constant(f, configuration) for f in configuration.loads):
        return None
    [q] = configuration.slots.coordinates
    lost = (f.vector.fixed().dot(f.point.fixed().map(configuration.rewritten)) for f in configuration.loads)
    whole = textbook_form(configuration.potential - sp.Add(*lost))
    varying = sp.Add(*(e for e in sp.Add.make_args(whole) if q in e.free_symbols))
    short = count_operations(varying) <= LONGEST_POTENTIAL
    return varying if short and is_zero(varying.diff(q) + force) is True else None
