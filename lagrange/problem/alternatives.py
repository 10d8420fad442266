"""What a constraint may mean: alternatives, each a list of functions that are all zero.

An alternative that says no more than another is left out: x' = y' = 0 is part of x' = y'. So is one that contradicts
itself, as x' = 0 with x' = 1, and within one alternative what follows from the rest. Affine forms are compared by rank.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from enum import StrEnum

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, rank
from lagrange.core.records import record
from lagrange.core.symbols import Slots


class Why(StrEnum):
    """Why a function is zero just when others are."""

    POWER = "power"  # u^n = 0: u = 0
    FACTOR = "factor"  # a u = 0 with a ≠ 0: u = 0
    QUOTIENT = "quotient"  # u/v = 0: u = 0, with v ≠ 0
    FUNCTION = "function"  # |u| = 0, sinh u = 0: u = 0
    INVERSE = "inverse"  # exp u = w: u = log w
    DIRECTION = "direction"  # atan2(u, v) = w: u cos w − v sin w = 0
    SQUARED = "squared"  # √u = w: u = w²
    SQUARES = "squares"  # u² + v² = 0: u = 0 and v = 0
    FACTORED = "factored"  # u² − 2 u v + v² = 0: (u − v)² = 0
    EXPANDED = "expanded"  # multiplied out, it is linear
    SPLIT = "split"  # u v = 0: u = 0 or v = 0


Condition = tuple[sp.Expr, str]
"""What is assumed on the way: (e, "≠") for e ≠ 0, (e, "≥") for e ≥ 0."""


@record
class Reduction:
    """`function` is zero just when all of `forms` are; where it splits, when one of them is: the first is followed."""

    function: sp.Expr
    why: Why
    forms: tuple[sp.Expr, ...]
    conditions: tuple[Condition, ...] = ()


@record
class Alternative:
    """Functions of q, q', t that are all zero, and how that was found."""

    forms: tuple[sp.Expr, ...]
    steps: tuple[Reduction, ...] = ()


@record
class Alternatives:
    """All that a constraint may mean; none: it cannot be satisfied. `endless`: the first of infinitely many."""

    members: tuple[Alternative, ...]
    endless: bool = False


def is_affine(function: sp.Expr, slots: Slots) -> bool:
    """Whether a function is written as one that is affine in the velocities, or can be by multiplying out."""
    derivatives = [function.diff(v) for v in slots.velocities if function.has(v)]
    return all(sp.expand(d).free_symbols.isdisjoint(slots.velocities) for d in derivatives)


def without_implied(found: Iterable[Alternative], slots: Slots) -> tuple[Alternative, ...]:
    """Alternatives that say something new: x' = y' = 0 is part of x' = y'."""
    kept: list[Alternative] = []
    for alternative in found:
        regular = _independent(alternative, slots)
        if regular is None or any(_implies(regular, k, slots) for k in kept):
            continue
        kept = [k for k in kept if not _implies(k, regular, slots)]
        kept.append(regular)
    return tuple(kept)


def _independent(alternative: Alternative, slots: Slots) -> Alternative | None:
    """The alternative without affine forms that follow from the others; None where they contradict one another."""
    kept: list[sp.Expr] = []
    for form in alternative.forms:
        affine = [f for f in kept if is_affine(f, slots) and _is_kinematic(f, slots)]
        if is_affine(form, slots) and _is_kinematic(form, slots):
            whole = _rank([*affine, form], slots, with_constant=True)
            if whole == len(affine):
                continue
            if whole is not None and whole != _rank([*affine, form], slots, with_constant=False):
                return None
        kept.append(form)
    return Alternative(tuple(kept), alternative.steps)


def _implies(one: Alternative, other: Alternative, slots: Slots) -> bool:
    """Whether the affine forms of the other are combinations of those of the one."""
    if set(other.forms) <= set(one.forms):
        return True
    if not all(is_affine(f, slots) for f in (*one.forms, *other.forms)):
        return False
    return _rank([*one.forms, *other.forms], slots, with_constant=True) == len(one.forms)


def _is_kinematic(form: sp.Expr, slots: Slots) -> bool:
    return not form.free_symbols.isdisjoint(slots.velocities)


def _rank(forms: Sequence[sp.Expr], slots: Slots, *, with_constant: bool) -> int | None:
    at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
    rows = [[*(f.diff(v) for v in slots.velocities), *((f.xreplace(at_rest),) if with_constant else ())] for f in forms]
    try:
        return rank(rows)
    except DivisionByZeroError:
        return None
