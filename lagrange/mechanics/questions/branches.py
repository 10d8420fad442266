"""Which of several branches is meant: the first one after t = 0, where that can be decided.

For one degree of freedom q, which starts at q_0:

    the initial state itself is left out, where there is another branch
    q reaches a value q_1 ≠ q_0 for the first time moving towards it: q' has the sign of q_1 − q_0, or is 0
    q starts with the sign of q'_0, or of q''_0 where it starts at rest, and keeps its direction up to the first turning
    point: of the turning points in that direction the nearest comes first

All of these are signs of expressions in the parameters; where one is not known, the branch stays.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime
from lagrange.mechanics.questions.results import AnswerBranch, Because

State = Mapping[sp.Symbol, sp.Expr]


@record
class Chosen:
    """The branches that are left, those that were dropped, and what decided."""

    branches: tuple[AnswerBranch, ...]
    dropped: tuple[tuple[AnswerBranch, Because], ...] = ()
    mirrored: bool = False
    first: Because | None = None


def first_branches(branches: Sequence[AnswerBranch], initial: State, accelerations: State, slots: Slots) -> Chosen:
    """The branches without those that cannot come first."""
    left = tuple(branches)
    dropped: list[tuple[AnswerBranch, Because]] = []
    if len(slots.coordinates) != 1 or not all(s in initial for s in (*slots.coordinates, *slots.velocities)):
        return Chosen(left, mirrored=_are_mirrored(left))
    [q], [v] = slots.coordinates, slots.velocities
    start = _direction(q, v, initial, accelerations)
    first = None
    for reason in (Because.INITIAL, Because.ARRIVAL, Because.TURNING):
        if len(left) == 1 and len(left[0].states) <= 1:
            break
        parted = [_parted(b, reason, q, v, initial, start) for b in left]
        kept = [b for b, _ in parted if b is not None]
        gone = [b for _, b in parted if b is not None]
        if kept and gone:
            left, first = tuple(kept), reason
            dropped += [(b, reason) for b in gone]
    left, later = _nearest(left, q, v, initial, start)
    dropped += [(b, Because.LATER) for b in later]
    return Chosen(left, tuple(dropped), len(left) > 1 and _are_mirrored(left) and start == 0, first)


def _direction(q: sp.Symbol, v: sp.Symbol, initial: State, accelerations: State) -> int | None:
    """The sign with which q starts; 0 where it is at rest in equilibrium; None: not known."""
    sign = sign_of(initial[v])
    if sign != 0:
        return sign
    a = accelerations.get(prime(q, 2))
    if a is None:
        return None
    value = a.xreplace(dict(initial))
    if value.free_symbols & {q, v}:
        return None
    return 0 if is_zero(value) else sign_of(value)


def _parted(
    b: AnswerBranch, reason: Because, q: sp.Symbol, v: sp.Symbol, initial: State, start: int | None
) -> tuple[AnswerBranch | None, AnswerBranch | None]:
    """The part of a branch that may come first, and the part that cannot."""
    kept = tuple(s for s in b.states if not _is_ruled_out(s, reason, q, v, initial, start))
    gone = tuple(s for s in b.states if s not in kept)
    if not gone:
        return b, None
    if not kept:
        return None, b
    return AnswerBranch(b.lhs, b.rhs, b.values, kept, b.conditions), None


def _is_ruled_out(state: State, reason: Because, q: sp.Symbol, v: sp.Symbol, initial: State, start: int | None) -> bool:
    here, speed = state.get(q), state.get(v)
    if here is None or speed is None:
        return False
    way = _sign(here - initial[q])
    if reason is Because.INITIAL:
        return way == 0 and is_zero(speed - initial[v]) is True
    if reason is Because.ARRIVAL:
        sign = sign_of(speed)
        if way == 0:  # it comes back: with one degree of freedom, in the other direction
            return start in (1, -1) and sign == start
        return way in (1, -1) and sign == -way
    return speed == 0 and start in (1, -1) and way == -start


def _sign(e: sp.Expr) -> int | None:
    if is_zero(e) is True:
        return 0
    if e.is_number:
        return 1 if e.evalf() > 0 else -1
    return sign_of(e)


def _nearest(
    branches: tuple[AnswerBranch, ...], q: sp.Symbol, v: sp.Symbol, initial: State, start: int | None
) -> tuple[tuple[AnswerBranch, ...], list[AnswerBranch]]:
    """Of several turning points in the direction of the start the nearest, and the others."""
    if len(branches) < 2 or start not in (1, -1) or not all(len(b.states) == 1 for b in branches):
        return branches, []
    if not all(b.states[0].get(v) == 0 and q in b.states[0] for b in branches):
        return branches, []
    places = [b.states[0][q] for b in branches]
    if not all(_sign(p - initial[q]) == start for p in places):
        return branches, []
    for b, place in zip(branches, places, strict=True):
        if all(_sign(other - place) in (0, start) for other in places):
            return (b,), [o for o in branches if o is not b]
    return branches, []


def _are_mirrored(branches: Sequence[AnswerBranch]) -> bool:
    """Whether there are two values, one the opposite of the other."""
    values = [v for b in branches for v in b.values]
    return len(values) == 2 and is_zero(values[0] + values[1]) is True
