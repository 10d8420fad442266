"""Which of several branches is meant: the first one after t = 0, where that can be decided.

    an unknown parameter has the sign that the file gives it
    the initial state itself is left out, where there is another branch
    a coordinate reaches a value q_1 ≠ q_0 for the first time moving towards it: q' has the sign of q_1 − q_0, or is 0
    as a function of a coordinate, the branch is meant that begins with the initial state
    with one degree of freedom q starts with the sign of q'_0, or of q''_0 where it starts at rest, and keeps its
    direction up to the first turning point: of the turning points in that direction the nearest comes first

The second of these is about a value that the conditions give, or about one degree of freedom. All are signs of
expressions in the parameters; where one is not known, the branch stays. That a turning point lies in the direction of
the start may be a condition: r_1 > R, where 2k > R v².
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.records import record
from lagrange.core.symbols import Slots, base, prime
from lagrange.mechanics.questions.results import AnswerBranch, Because

State = Mapping[sp.Symbol, sp.Expr]


@record
class Chosen:
    """The branches that are left, those that were dropped, and what decided."""

    branches: tuple[AnswerBranch, ...]
    dropped: tuple[tuple[AnswerBranch, Because], ...] = ()
    mirrored: bool = False


@record
class Beginning:
    """The initial state, and what is known of the motion from it.

    accelerations  as functions of the state
    free           the number of degrees of freedom
    """

    initial: State
    accelerations: State
    slots: Slots
    free: int

    def direction(self, q: sp.Symbol) -> int | None:
        """The sign with which q starts; 0 where it is at rest and not accelerated; None: not known."""
        speed = self.initial.get(prime(q))
        if speed is None:
            return None
        sign = sign_of(speed)
        if sign != 0:
            return sign
        a = self.accelerations.get(prime(q, 2))
        if a is None:
            return None
        value = a.xreplace(dict(self.initial))
        if value.free_symbols & {*self.slots.coordinates, *self.slots.velocities}:
            return None
        return 0 if is_zero(value) else sign_of(value)

    def is_initial(self, state: State) -> bool:
        """Whether a state is the initial one."""
        slots = (*self.slots.coordinates, *self.slots.velocities)
        if not all(s in state and s in self.initial for s in slots):
            return False
        return all(is_zero(state[s] - self.initial[s]) is True for s in slots)


def first_branches(
    branches: Sequence[AnswerBranch],
    beginning: Beginning,
    reached: Collection[sp.Symbol],
    by: sp.Symbol | None,
    quantity: sp.Expr,
) -> Chosen:
    """The branches without those that cannot come first.

    reached  coordinates whose value the conditions give
    by       the coordinate as a function of which the quantity is wanted
    """
    dropped: list[tuple[AnswerBranch, Because]] = []
    left = [b for b in branches if not _has_wrong_sign(b, quantity)]
    if by is not None:
        left, gone = _beginning_right(left, beginning, by, quantity)
        return Chosen(tuple(left), tuple((b, Because.START) for b in gone), _are_mirrored(left))
    one = beginning.free == 1
    arriving = beginning.slots.coordinates if one else tuple(reached)
    for reason in (Because.INITIAL, Because.ARRIVAL, Because.TURNING):
        parted = [_parted(b, reason, beginning, arriving, one) for b in left]
        kept = [b for b, _ in parted if b is not None]
        gone = [b for _, b in parted if b is not None]
        if kept and gone:
            left = kept
            dropped += [(b, reason) for b in gone]
    left, later = _nearest(left, beginning) if one else (left, [])
    dropped += [(b, Because.LATER) for b in later]
    if one:
        left = [_with_direction(b, beginning) for b in left]
    still = all(beginning.direction(q) == 0 for q in beginning.slots.coordinates)
    return Chosen(tuple(left), tuple(dropped), _are_mirrored(left) and still)


def _has_wrong_sign(b: AnswerBranch, quantity: sp.Expr) -> bool:
    """Whether a parameter that the file says to be positive would be negative."""
    if not quantity.is_nonnegative:
        return False
    return all(sign_of(v) == -1 or (v == 0 and quantity.is_positive) for v in b.values)


def _beginning_right(
    branches: Sequence[AnswerBranch], beginning: Beginning, by: sp.Symbol, quantity: sp.Expr
) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """The branches that have the initial value of the quantity at the initial place, and the others."""
    start = quantity.xreplace(dict(beginning.initial))
    slots = {*beginning.slots.coordinates, *beginning.slots.velocities}
    if len(branches) < 2 or by not in beginning.initial or start.free_symbols & slots:
        return list(branches), []
    at = {by: beginning.initial[by]}
    right = []
    for b in branches:
        try:
            right.append(any(is_zero(v.xreplace(at) - start) is not False for v in b.values))
        except DivisionByZeroError:
            right.append(True)
    if not any(right):
        return list(branches), []
    pairs = list(zip(branches, right, strict=True))
    return [b for b, keeps in pairs if keeps], [b for b, keeps in pairs if not keeps]


def _parted(
    b: AnswerBranch, reason: Because, beginning: Beginning, arriving: Collection[sp.Symbol], one: bool
) -> tuple[AnswerBranch | None, AnswerBranch | None]:
    """The part of a branch that may come first, and the branch if no part of it may."""
    kept = tuple(s for s in b.states if not _is_ruled_out(s, reason, beginning, arriving, one))
    if len(kept) == len(b.states):
        return b, None
    return (replace(b, states=kept), None) if kept else (None, b)


def _is_ruled_out(
    state: State, reason: Because, beginning: Beginning, arriving: Collection[sp.Symbol], one: bool
) -> bool:
    if reason is Because.INITIAL:
        return beginning.is_initial(state)
    if reason is Because.ARRIVAL:
        return any(_comes_from_beyond(state, q, beginning) for q in arriving)
    return one and any(_is_behind(state, q, beginning) for q in beginning.slots.coordinates)


def _comes_from_beyond(state: State, q: sp.Symbol, beginning: Beginning) -> bool:
    """Whether q has the wrong sense for its first arrival."""
    way, speed = _way(state, q, beginning), state.get(prime(q))
    if way is None or speed is None:
        return False
    sign = sign_of(speed)
    if way == 0:  # it comes back, from the side to which it went
        start = beginning.direction(q)
        return start in (1, -1) and sign == start
    return sign == -way


def _is_behind(state: State, q: sp.Symbol, beginning: Beginning) -> bool:
    """Whether a state is a turning point on the other side than that to which q starts."""
    start = beginning.direction(q)
    return state.get(prime(q)) == 0 and start in (1, -1) and _way(state, q, beginning) == -(start or 0)


def _way(state: State, q: sp.Symbol, beginning: Beginning) -> int | None:
    """The sign of q_1 − q_0."""
    if q not in state or q not in beginning.initial:
        return None
    return sign_of_value(state[q] - beginning.initial[q])


def sign_of_value(e: sp.Expr) -> int | None:
    """The sign of a value; of a number by its digits, where it is not zero."""
    if is_zero(e) is True:
        return 0
    if e.is_number and e.is_real:
        return 1 if e.evalf() > 0 else -1
    return sign_of(e)


def _with_direction(b: AnswerBranch, beginning: Beginning) -> AnswerBranch:
    """A turning point, with the condition that it lies in the direction of the start, where that is not certain."""
    conditions: list[SignCondition] = []
    for q in beginning.slots.coordinates:
        start = beginning.direction(q)
        if start not in (1, -1) or len(b.states) != 1 or b.states[0].get(prime(q)) != 0:
            continue
        if _way(b.states[0], q, beginning) is None and q in b.states[0] and q in beginning.initial:
            conditions.append(more_than_zero(start * (b.states[0][q] - beginning.initial[q])))
    new = {c.lhs - c.rhs for c in conditions}
    kept = [c for c in b.conditions if not (c.relation == "≠" and {c.lhs - c.rhs, c.rhs - c.lhs} & new)]
    return replace(b, conditions=(*kept, *(c for c in conditions if c not in kept)))


def _nearest(branches: Sequence[AnswerBranch], beginning: Beginning) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """Of several turning points in the direction of the start the nearest, and the others."""
    branches = list(branches)
    if len(branches) < 2 or not all(len(b.states) == 1 for b in branches):
        return branches, []
    for q in beginning.slots.coordinates:
        start = beginning.direction(q)
        states = [b.states[0] for b in branches]
        if start not in (1, -1) or not all(s.get(prime(q)) == 0 for s in states):
            continue
        if not all(_way(s, q, beginning) == start for s in states):
            continue
        for b, s in zip(branches, states, strict=True):
            if all(sign_of_value(o[q] - s[q]) in (0, start) for o in states):
                return [b], [o for o in branches if o is not b]
    return branches, []


def _are_mirrored(branches: Sequence[AnswerBranch]) -> bool:
    """Whether there are two values, one the opposite of the other."""
    values = [v for b in branches for v in b.values]
    return len(values) == 2 and len(branches) == 2 and is_zero(values[0] + values[1]) is True


def outright(conditions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> list[sp.Symbol]:
    """The coordinates whose value a condition gives."""
    alone = [e.free_symbols & {*coordinates} for e in conditions if not _moves(e)]
    return [next(iter(s)) for s in alone if len(s) == 1]


def _moves(e: sp.Expr) -> bool:
    return any(base(s) != s for s in e.free_symbols)
