"""Coordinates of the answer's own: names that an equation with a coordinate of the problem defines.

    r = l + s, s the extension of the spring      s = r − l
    x = R φ,   x' = R φ'                          φ = x/R

One side is a coordinate alone, or has velocities alone, or accelerations alone, linearly; the other has one name that
nobody declared, to the same order and linearly. Where it has only rates of that name, its coefficients are constants,
so that the equation can be integrated; the constant of integration does not matter in an equation of motion. A velocity
may have a name without a prime, `x' = R omega`.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.answers.limits import LONGEST_NEW_COORDINATE
from lagrange.answers.written.reading import read_as_written
from lagrange.core.diagnostics import Fragment
from lagrange.core.operations import count_operations
from lagrange.core.symbols import Slots, base, prime, t
from lagrange.core.vectors import Vector
from lagrange.expressions.scope import Scope


def defined_coordinate(fragment: Fragment, name: str, scope: Scope) -> sp.Expr | None:
    """What a name means, as a coordinate of its own; None if an equation does not define it so."""
    slots = scope.slots
    own = sp.Symbol(name, real=True)
    reading = read_as_written(fragment, replace(scope, slots=replace(slots, coordinates=(*slots.coordinates, own))))
    if reading.error is not None or len(reading.sides) != 2:
        return None
    left, right = reading.sides
    if isinstance(left, Vector) or isinstance(right, Vector):
        return None
    for known, other in ((left, right), (right, left)):
        order = _order(known, slots)
        rates = [n for n in range(3) if prime(own, n) in other.free_symbols]
        if (
            order is None
            or not rates
            or count_operations(other) > LONGEST_NEW_COORDINATE
            or count_operations(known) > LONGEST_NEW_COORDINATE
        ):
            continue
        if rates == [order]:
            return _integrated(known, other, prime(own, order), order, scope)
        if rates == [0] and order == 1:
            return _solved(known, other, own)
    return None


def _order(side: sp.Expr, slots: Slots) -> int | None:
    """0 for a coordinate alone, 1 or 2 for an expression linear in velocities alone, or in accelerations alone."""
    if side in slots.coordinates:
        return 0
    rates = {s for s in side.free_symbols if base(s) != s}
    orders = {len(s.name) - len(base(s).name) for s in rates}
    linear = all(sp.diff(side, s).free_symbols.isdisjoint(rates) for s in rates)
    return orders.pop() if len(orders) == 1 and linear and orders <= {1, 2} else None


def _solved(known: sp.Expr, other: sp.Expr, unknown: sp.Symbol) -> sp.Expr | None:
    """The unknown from an equation that is linear in it."""
    slope = sp.diff(other, unknown)
    if unknown in slope.free_symbols or slope == 0:
        return None
    return (known - other.xreplace({unknown: sp.S.Zero})) / slope


def _integrated(known: sp.Expr, other: sp.Expr, unknown: sp.Symbol, order: int, scope: Scope) -> sp.Expr | None:
    """The coordinate from its rate, where that is a sum of rates of this order with constant coefficients."""
    value = _solved(known, other, unknown)
    if value is None or order == 0:
        return value
    slots = scope.slots
    rates = {prime(q, order): q for q in (*slots.coordinates, *slots.prescribed)}
    moving = {t, *slots.coordinates, *slots.prescribed, *slots.velocities, *slots.accelerations}
    value = sp.expand(value)
    for term in sp.Add.make_args(value):
        coefficient, rate = term.as_independent(*rates, as_Add=False)
        if rate not in rates or coefficient.free_symbols & moving:
            return None
    return value.xreplace(rates)
