"""Two coordinates whose accelerations contain each other's velocity: circles, and oscillations whose plane turns.

x'' = −k x + c y' and y'' = −k y − c x', with constants k and c, are for ζ = x + i y the one equation
ζ'' + i c ζ' + k ζ = 0. Without k the velocity ζ' turns at the rate −c, and the point runs on a circle. With k, seen
from axes that turn at the rate ν = −c/2 (ζ = e^{iνt} η), the velocities drop out: η'' + (k + c²/4) η = 0. The pendulum
of Foucault, a charge in a magnetic field (Larmor) and a ball on a turntable are of this kind. If the k of x and y
differ, but only in the second order of a parameter in which c is of first order, this holds to first order, and there
k + c²/4 is k.
"""

from __future__ import annotations

from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, partial, t
from lagrange.mechanics.consequences.oscillations import between_positive_sums
from lagrange.mechanics.limits import LONGEST_TURNING, LONGEST_TURNING_RATE
from lagrange.mechanics.results import InCoordinates


@record
class Turning:
    """Two coordinates relative to rotating axes.

    rate       of the velocity on its circle, if `stiffness` is None; otherwise of the axes
    stiffness  k with η'' + k η = 0 in the turning axes
    small      the parameter in which this holds to first order; None: it holds exactly
    bounded    sides of the inequality more > less without which η grows; None where k > 0 in any case, or is not exact
    """

    first: sp.Symbol
    second: sp.Symbol
    accelerations: tuple[sp.Expr, sp.Expr]
    rate: sp.Expr
    stiffness: sp.Expr | None = None
    small: sp.Symbol | None = None
    bounded: tuple[sp.Expr, sp.Expr] | None = None


def turning(view: InCoordinates) -> Turning | None:
    """The first pair of coordinates of that kind."""
    motion = view.motion
    slots = view.configuration.slots
    if motion is None or len(slots.coordinates) < 2 or slots.prescribed:
        return None
    equations = [*(e.expression for e in motion.final), *view.configuration.accelerated_constraints]
    moving = {*slots.coordinates, t}
    if sum(count_operations(e) for e in equations) > LONGEST_TURNING or any(e.has(Unspecified) for e in equations):
        return None
    rows = [[partial(e, a) for a in slots.accelerations] for e in equations]
    if any(c.free_symbols & moving for row in rows for c in row):
        return None
    rest = dict.fromkeys(slots.accelerations, sp.S.Zero)
    try:
        solved = solved_linear(rows, [-e.xreplace(rest) for e in equations], view.configuration.states)
    except DivisionByZeroError:
        return None
    if solved is None:
        return None
    for m, n in combinations(range(len(slots.coordinates)), 2):
        pair = _pair(view, m, n, solved[m], solved[n])
        if pair is not None:
            return pair
    return None


def _pair(view: InCoordinates, m: int, n: int, a: sp.Expr | None, b: sp.Expr | None) -> Turning | None:
    slots = view.configuration.slots
    x, y, u, v = slots.coordinates[m], slots.coordinates[n], slots.velocities[m], slots.velocities[n]
    if a is None or b is None:
        return None
    a, b = textbook_form(a), textbook_form(b)
    c, k, other = a.diff(v), -a.diff(x), -b.diff(y)
    moving = {*slots.coordinates, *slots.velocities, t}
    rates = (c, k, other)
    if c == 0 or any(e.free_symbols & moving for e in rates):
        return None
    if is_zero(a - c * v + k * x) is not True or is_zero(b + c * u + other * y) is not True:
        return None
    if is_zero(k) is True and is_zero(other) is True:
        return Turning(x, y, (a, b), textbook_form(-c))
    rate = textbook_form(-c / 2)
    if is_zero(k - other) is True:
        stiffness = k + c**2 / 4
        sides = None if stiffness.is_positive else between_positive_sums(sp.expand(stiffness))
        pair = Turning(x, y, (a, b), rate, textbook_form(stiffness), bounded=sides)
    else:
        small = next((s for s in sorted(c.free_symbols, key=str) if _of_second_order(c, k, other, s)), None)
        if small is None:
            return None
        pair = Turning(x, y, (a, b), rate, textbook_form(k.xreplace({small: sp.S.Zero})), small)
    assert pair.stiffness is not None
    return pair if max(count_operations(rate), count_operations(pair.stiffness)) <= LONGEST_TURNING_RATE else None


def _of_second_order(c: sp.Expr, k: sp.Expr, other: sp.Expr, small: sp.Symbol) -> bool:
    """Whether c is proportional to the parameter, and the stiffnesses are the same up to its second order."""
    zero = {small: sp.S.Zero}
    linear = is_zero(c.xreplace(zero)) is True and is_zero(c.diff(small, 2)) is True
    even = all(is_zero(e.diff(small).xreplace(zero)) is True for e in (k, other))
    return linear and even and is_zero((k - other).xreplace(zero)) is True
