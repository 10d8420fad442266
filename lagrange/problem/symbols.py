"""Which quantities may occur where: a position has no velocity in it, a mass nothing that changes.

    a mass, a moment of inertia     parameters
    a position, an angle            parameters, time, coordinates
    a potential energy              the same, and unknown forces
    a quasi-velocity                parameters, time, coordinates, velocities
    a constraint                    the same, and differentials d(x)
    a force                         parameters, time, coordinates, velocities, unknown forces

An acceleration may occur in none of them. Prescribed motions u, u', u'' belong to time.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, differential, t, variation


class Quantity(StrEnum):
    """What a symbol is, as far as that decides where it may occur."""

    TIME = "time"
    COORDINATE = "the coordinate"
    VELOCITY = "the velocity"
    ACCELERATION = "the acceleration"
    UNKNOWN = "the unknown force"
    DIFFERENTIAL = "the differential"
    VARIATION = "the virtual displacement"


@record
class Allowed:
    """The quantities that may occur in an expression beside parameters, and what to say where another does."""

    quantities: frozenset[Quantity]
    help: str
    code: str = "not-allowed-here"


_T, _Q, _V, _P, _D = (
    Quantity.TIME,
    Quantity.COORDINATE,
    Quantity.VELOCITY,
    Quantity.UNKNOWN,
    Quantity.DIFFERENTIAL,
)
CONSTANT = Allowed(frozenset(), "it is made of numbers and of names under `parameters:`", "not-constant")
POSITION = Allowed(frozenset({_T, _Q}), "positions depend on coordinates and time")
ENERGY = Allowed(frozenset({_T, _Q, _P}), "it depends on coordinates and time")
RATE = Allowed(frozenset({_T, _Q, _V}), "it depends on coordinates, velocities and time")
CONSTRAINT = Allowed(frozenset({_T, _Q, _V, _D}), "a constraint relates coordinates, velocities and time")
FORCE = Allowed(frozenset({_T, _Q, _V, _P}), "forces depend on coordinates, velocities and time")
SUBSTITUTION = Allowed(frozenset({_T, _Q}), "it depends on coordinates and time; velocities follow by differentiation")
ANYTHING = Allowed(frozenset(Quantity), "")


def quantity(symbol: sp.Symbol, slots: Slots, unknowns: Iterable[sp.Symbol]) -> Quantity | None:
    """What a symbol is; None for a parameter."""
    if symbol in unknowns:
        return Quantity.UNKNOWN
    plain = base(symbol)
    if symbol == t or plain in slots.prescribed:
        return Quantity.TIME
    if plain in slots.coordinates:
        order = len(symbol.name) - len(plain.name)
        return (Quantity.COORDINATE, Quantity.VELOCITY, Quantity.ACCELERATION)[min(order, 2)]
    moving = (*slots.coordinates, *slots.prescribed, t)
    if symbol in {differential(q) for q in moving}:
        return Quantity.DIFFERENTIAL
    return Quantity.VARIATION if symbol in {variation(q) for q in moving} else None


def first_refused(
    expression: sp.Expr, allowed: Allowed, slots: Slots, unknowns: Iterable[sp.Symbol]
) -> tuple[sp.Symbol, Quantity] | None:
    """A symbol that may not occur in an expression, if there is one."""
    for symbol in sorted(expression.free_symbols, key=lambda s: str(s.name)):
        found = quantity(symbol, slots, unknowns)
        if found is not None and found not in allowed.quantities:
            return symbol, found
    return None
