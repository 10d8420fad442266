"""Whether two expressions are the same to a reader: equal when multiplied out, without anything else being used.

What is decided here chooses what a page repeats, not what is true; `is_zero` in `algebra/exact` decides that.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import in_sines
from lagrange.core.operations import count_operations
from lagrange.core.symbols import Slots, Unspecified, base, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.limits import LONGEST_RATIO

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.linearization import Linearization


def is_same(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether the difference vanishes when it is multiplied out; that of different letters never does here."""
    return bool(a == b or (a.free_symbols == b.free_symbols and sp.expand(a - b) == 0))


def multiplied_out(v: Vector) -> tuple[sp.Expr, ...]:
    """The components along i, j, k, multiplied out: equal for vectors that a reader sees are equal."""
    return tuple(sp.expand(c) for c in v.fixed().components)


def are_same_equations(left: Sequence[tuple[sp.Expr, ...]], right: Sequence[sp.Expr]) -> bool:
    """Whether each equation a = b of the left is one of e = 0 of the right, or a constant times it."""
    differences, expressions = [in_sines(a - b) for a, b, *_ in left], [in_sines(e) for e in right]
    return all(any(_is_multiple(d, e) for e in expressions) for d in differences)


def _is_multiple(a: sp.Expr, b: sp.Expr) -> bool:
    """Whether the first is the second, or −1, ½ or another constant times it: R times it."""
    if is_same(a, b) or is_same(a, -b):
        return True
    if (
        any(not s.is_positive for s in a.free_symbols ^ b.free_symbols)
        or b == 0
        or count_operations(a) + count_operations(b) > LONGEST_RATIO
    ):
        return False
    ratio = sp.cancel(a / b)
    return ratio.is_nonzero is True and all(s.is_positive for s in ratio.free_symbols)


def are_same_formulas(a: sp.Expr, b: sp.Expr, rule: dict[sp.Symbol, sp.Expr]) -> bool:
    """Whether the first is the second written otherwise, or with other names: r for R."""
    if a.free_symbols == b.free_symbols and sp.cancel(a - b) == 0:
        return True
    return is_same(a.xreplace(rule), b) and count_operations(a) == count_operations(b)


def has_plain_accelerations(value: Vector, slots: Slots) -> bool:
    """Whether the components are sums of accelerations of coordinates with constant coefficients."""
    terms = [a for c in value.components for a in sp.Add.make_args(sp.expand(c)) if a != 0]
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, *slots.accelerations, t}
    return all(len(a.free_symbols & moving) == 1 and a.free_symbols & {*slots.accelerations} for a in terms)


def is_linear(linearization: Linearization) -> bool:
    """Whether the equations of motion are linear with constant coefficients, without anything being neglected."""
    expressions = linearization.motion.expressions
    symbols = {s for e in expressions for s in e.free_symbols}
    moving = {*linearization.configuration.slots.coordinates, *(s for s in symbols if base(s) != s)}  # cyclic ones, too
    if linearization.configuration.rows or any(e.has(Unspecified, sp.sign, sp.Abs, t) for e in expressions):
        return False
    return all(not e.diff(x).free_symbols & moving for e in expressions for x in moving)


def divisors(values: Sequence[sp.Expr]) -> set[sp.Expr]:
    """What the values divide by: the bases of the factors of their denominators."""
    below = (sp.factor(sp.fraction(sp.together(v))[1]) for v in values)
    return {f.as_base_exp()[0] for d in below for f in sp.Mul.make_args(d)}
