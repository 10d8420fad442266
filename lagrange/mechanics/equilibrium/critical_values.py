"""Critical values: a condition in which all parameters but one have values, solved for that one.

An equilibrium that is stable where k l > P is so for P < 100 N if k and l are given. The condition is solved where the
parameter occurs in one power, a p^n + b; a bound that the sign of the parameter makes idle is omitted.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.core.records import record
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.linearization import Linearization
from lagrange.mechanics.equilibrium.stability import SecondVariation
from lagrange.values.quantities import NotRealError, Quantity, Values, real_value

REVERSED = {">": "<", "<": ">", "≥": "≤", "≤": "≥", "≠": "≠"}


@record
class CriticalValue:
    """The condition, and what it says of a parameter with the values: parameter relation bound."""

    condition: SignCondition
    parameter: sp.Symbol
    relation: str
    bound: Quantity


def critical_values(
    e: Equilibrium | None, second: SecondVariation | None, linear: Linearization | None, values: Values
) -> tuple[CriticalValue, ...]:
    """All critical values of the equilibria of one set of coordinates, each once."""
    conditions: list[SignCondition] = []
    branches = linear.branches if linear is not None else e.branches if e is not None else ()
    conditions += [c for b in branches for c in b.conditions]
    verdicts = [*(second.verdicts if second is not None else ())]
    verdicts += [s.judgement.stability for s in linear.at if s is not None] if linear is not None else []
    conditions += [c for s in verdicts for c in (*s.conditions, *s.presupposed, *s.unstable)]
    return tuple(_each(dict.fromkeys(conditions), values))


def _each(conditions: Iterable[SignCondition], values: Values) -> Iterator[CriticalValue]:
    for c in conditions:
        difference = c.lhs - c.rhs
        missing = (difference.free_symbols & values.parameters) - values.numbers.keys()
        others = difference.free_symbols - values.parameters
        if len(missing) == 1 and not others and len(difference.free_symbols) > 1:
            [p] = missing
            solved = _solved(c, p, values)
            if solved is not None:
                yield solved


def _solved(c: SignCondition, p: sp.Symbol, values: Values) -> CriticalValue | None:
    difference = sp.expand(c.lhs - c.rhs)
    if not difference.is_polynomial(p):
        return None
    powers = [k for (k,), _ in sp.Poly(difference, p).terms() if k]
    if len(powers) != 1 or (powers[0] > 1 and not p.is_positive):
        return None
    [n] = powers
    a, b = difference.coeff(p, n), difference.coeff(p, 0)
    ratio = -b / a
    try:
        bound, slope = real_value(values.put_in(ratio)), real_value(values.put_in(a))
    except NotRealError:
        return None
    if slope.is_zero or (p.is_positive and bound <= 0):
        return None
    root = ratio ** sp.Rational(1, n)
    quantity = values.quantity(root, is_angle=p in values.angles)
    if quantity is None:
        return None
    return CriticalValue(c, p, c.relation if slope > 0 else REVERSED[c.relation], quantity)
