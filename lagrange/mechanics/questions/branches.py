"""Which of several branches is meant: the first one after t = 0, where that can be decided.

    an unknown parameter has the sign that the file gives it
    a radius of the frame of the file stays positive
    the initial state itself is omitted, where there is another branch
    a coordinate reaches a value q_1 ≠ q_0 for the first time moving towards it: q' has the sign of q_1 − q_0, or is 0
    as a function of a coordinate, the branch is meant that begins with the initial state
    with one degree of freedom q starts with the sign of q'_0, or of q''_0 where it starts at rest, and keeps its
    direction up to the first turning point: of the turning points in that direction the nearest comes first; so does
    one of several coordinates, if the question is about it alone and q'^2 is a function of it

The second of these is about a value that the conditions give, or about one degree of freedom. All are signs of
expressions in the parameters; where one is not known, the branch stays. That a turning point lies in the direction of
the start may be a condition: r_1 > R, where 2k > R v².
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import field, replace
from functools import lru_cache

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.records import record
from lagrange.core.symbols import Bounded, Slots, base, prime, t, without_known_magnitudes
from lagrange.mechanics.questions.forms import with_joined_logarithms
from lagrange.mechanics.questions.limits import MOST_SIGNS
from lagrange.mechanics.questions.results import AnswerBranch, Reason
from lagrange.problem.model import Problem

State = Mapping[sp.Symbol, sp.Expr]


@record
class Chosen:
    """The branches that are left, those that were dropped, and what decided."""

    branches: tuple[AnswerBranch, ...]
    dropped: tuple[tuple[AnswerBranch, Reason], ...] = ()
    mirrored: bool = False


@record
class InitialMotion:
    """The initial state, and what is known about the motion that starts from it.

    accelerations  as functions of the state
    free           the number of degrees of freedom
    radii          coordinates that are radii, and positive at first
    turning        the coordinate at all turning points of a motion with one degree of freedom; None: not known
    own            the coordinates that are not expressed by the others
    values         numbers for the parameters, which decide what letters leave open
    ranges         what the ranges of coordinates make not negative: q, q − low and q, high − q
    along          of several degrees of freedom the coordinate that the conditions are about, if its velocity is a
                   function of it alone, as the distance from a centre and the depth of a spherical pendulum
    place          a condition on the coordinates alone that is the only one, zero where it holds: x_2 − x_1 − d
    """

    initial: State
    accelerations: State
    slots: Slots
    free: int
    radii: tuple[sp.Symbol, ...] = ()
    turning: Callable[[], Sequence[sp.Expr] | None] = lambda: None
    own: tuple[sp.Symbol, ...] = ()
    values: State = field(default_factory=dict)
    ranges: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    along: sp.Symbol | None = None
    place: sp.Expr | None = None

    @property
    def by_themselves(self) -> tuple[sp.Symbol, ...]:
        """The coordinates that go on in their direction up to a turning point."""
        if self.free == 1:
            return tuple(self.slots.coordinates)
        return () if self.along is None else (self.along,)

    def sign(self, e: sp.Expr, conditions: Sequence[SignCondition] = ()) -> int | None:
        """The sign of a value; where letters leave it open, that with the values of the parameters."""
        sign = sign_of_value(e, conditions)
        if sign is not None or not e.free_symbols or not e.free_symbols <= self.values.keys():
            return sign
        return sign_of_value(e.xreplace(dict(self.values)))

    def direction(self, q: sp.Symbol) -> int | None:
        """The sign with which q starts; 0 where it is at rest and not accelerated; None: not known."""
        rate = self.starting_rate(q)
        return None if rate is None else self.sign(rate)

    def starting_rate(self, q: sp.Symbol) -> sp.Expr | None:
        """What has the sign with which q starts: its velocity, or at rest its acceleration; None: not known."""
        speed = self.initial.get(prime(q))
        if speed is None or self.sign(speed) != 0:
            return speed
        a = self.accelerations.get(prime(q, 2))
        if a is None:
            return None
        value = a.xreplace(dict(self.initial))
        undefined = value.has(sp.zoo, sp.nan, sp.oo)  # at the cusp of a cycloid
        if undefined or value.free_symbols & {*self.slots.coordinates, *self.slots.velocities}:
            return None
        return value

    def is_initial(self, state: State) -> bool:
        """Whether a state is the initial one."""
        used = set().union(*(a.free_symbols for a in self.accelerations.values()))
        slots = [s for s in (*self.slots.coordinates, *self.slots.velocities) if s in state or s in used]
        if not slots or not all(s in state and s in self.initial for s in slots):
            return False
        return all(is_zero(state[s] - self.initial[s]) is True for s in slots)


def bounds(problem: Problem) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """What the ranges of coordinates make not negative: q, q − low and q, high − q."""
    bounded = ((c.symbol, c.range) for c in problem.coordinates)
    return tuple((q, e) for q, r in bounded if r is not None for e in (q - r.low, r.high - q))


def first_branches(
    branches: Sequence[AnswerBranch],
    beginning: InitialMotion,
    reached: Collection[sp.Symbol],
    by: sp.Symbol | None,
    quantity: sp.Expr,
) -> Chosen:
    """The branches without those that cannot come first.

    reached  coordinates whose value the conditions give
    by       the coordinate as a function of which the quantity is wanted
    """
    dropped: list[tuple[AnswerBranch, Reason]] = []
    left = [_with_sign(b, quantity) for b in branches if not _has_wrong_sign(b, quantity)]
    left = [_with_radius(b, beginning) for b in (_without_negative_radii(b, beginning) for b in left) if b is not None]
    if by is not None:
        left, gone = _beginning_right(left, beginning, by, quantity)
        left = _each_with_its_start(left, beginning, by)
        either = _are_mirrored(left) and (not beginning.initial or beginning.direction(by) == 0)
        return Chosen(tuple(left), tuple((b, Reason.START) for b in gone), either)
    one = bool(beginning.by_themselves)
    arriving = beginning.slots.coordinates if beginning.free == 1 else tuple(reached)
    for reason in (Reason.INITIAL, Reason.ARRIVAL, Reason.TURNING):
        parted = [_parted(b, reason, beginning, arriving, one) for b in left]
        kept = [b for b, _ in parted if b is not None]
        gone = [b for _, b in parted if b is not None]
        if kept:
            left = kept
            dropped += [(b, reason) for b in gone]
    if one:
        for choose in (_nearest, _reached_first):
            left, later = choose(left, beginning)
            dropped += [(b, Reason.LATER) for b in later]
    if one:
        left = [_with_direction(b, beginning) for b in left]
    still = all(beginning.direction(q) == 0 for q in beginning.slots.coordinates)
    either = still or (not beginning.initial and _is_reversed(quantity, beginning.slots))
    return Chosen(tuple(left), tuple(dropped), either and _are_mirrored(left))


def _has_wrong_sign(b: AnswerBranch, quantity: sp.Expr) -> bool:
    """Whether a parameter that the file says to be positive would be negative."""
    if not quantity.is_nonnegative:
        return False
    return all(sign_of(v) == -1 or (v == 0 and quantity.is_positive) for v in b.values)


def _with_sign(b: AnswerBranch, quantity: sp.Expr) -> AnswerBranch:
    """The branch with the condition that a positive parameter is positive, where that is open."""
    if not (quantity.is_Symbol and quantity.is_positive and len(b.values) == 1):
        return b
    [value] = b.values
    is_open = sign_of_value(value, b.conditions) is None
    return replace(b, conditions=(*b.conditions, more_than_zero(value))) if is_open else b


def _beginning_right(
    branches: Sequence[AnswerBranch], beginning: InitialMotion, by: sp.Symbol, quantity: sp.Expr
) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """The branches that have the initial value of the quantity at the initial place, and the others."""
    way = beginning.direction(by)
    if way in (1, -1):
        start = beginning.initial.get(by)
        right = [b.at(kept) for b in branches if (kept := _moving(b, by, way or 0, start)) or not b.states]
        gone = [b for b in branches if b.states and not _moving(b, by, way or 0, start)]
        if right and gone:
            return right, gone
    start = quantity.xreplace(dict(beginning.initial))
    slots = {*beginning.slots.coordinates, *beginning.slots.velocities}
    if len(branches) < 2 or by not in beginning.initial or start.free_symbols & slots:
        return list(branches), []
    at = {by: beginning.initial[by]}
    begins: list[bool] = []
    for b in branches:
        try:
            begins.append(any(is_zero(v.xreplace(at) - start) is not False for v in b.values))
        except DivisionByZeroError:
            begins.append(True)
    if not any(begins):
        return list(branches), []
    pairs = list(zip(branches, begins, strict=True))
    return [b for b, keeps in pairs if keeps], [b for b, keeps in pairs if not keeps]


def _each_with_its_start(
    branches: Sequence[AnswerBranch], beginning: InitialMotion, by: sp.Symbol
) -> list[AnswerBranch]:
    """Two opposite motions, each with the condition that it starts in its direction, where that is open."""
    rate = beginning.starting_rate(by)
    if rate is None or by not in beginning.initial or not _are_mirrored(branches) or beginning.sign(rate) is not None:
        return list(branches)
    roots = {
        e: sp.Dummy("w", positive=True)
        for b in branches
        for v in b.values
        for e in v.atoms(sp.Pow)
        if e.exp == sp.S.Half
    }
    at_start = {by: beginning.initial[by]}
    speeds = [b.states[0].get(prime(by), sp.nan) if len(b.states) == 1 else sp.nan for b in branches]
    ways = [sign_of_value(v.xreplace(roots).xreplace(at_start)) for v in speeds]
    if sorted(w or 0 for w in ways) != [-1, 1]:
        return list(branches)
    started = [more_than_zero(way * rate) for way in ways if way]
    return [replace(b, conditions=(*b.conditions, c)) for b, c in zip(branches, started, strict=True)]


def _moving(b: AnswerBranch, q: sp.Symbol, way: int, start: sp.Expr | None) -> tuple[State, ...]:
    """The states in which q does not move against a direction, in which it starts: it is ahead of its start then."""
    ahead = {} if start is None else {q: start + way * sp.Dummy("s", positive=True)}

    def is_against(speed: sp.Expr) -> bool:
        sign = sign_of_value(speed, b.conditions)
        return (sign_of_value(speed.xreplace(ahead)) if sign is None else sign) == -way

    return tuple(s for s in b.states if prime(q) not in s or not is_against(s[prime(q)]))


def _without_negative_radii(b: AnswerBranch, beginning: InitialMotion) -> AnswerBranch | None:
    """The part of a branch with no negative radius and each coordinate in its range; None if there is none."""
    kept = tuple(
        s
        for s in b.states
        if not any(q in s and beginning.sign(s[q], b.conditions) == -1 for q in beginning.radii)
        and not any(beginning.sign(e.xreplace(s), b.conditions) == -1 for q, e in beginning.ranges if q in s)
    )
    return b.at(kept) if kept or not b.states else None


def _with_radius(b: AnswerBranch, beginning: InitialMotion) -> AnswerBranch:
    """A branch with the condition that a radius is positive, where that is open."""
    conditions = list(b.conditions)
    for q in beginning.radii:
        if len(b.states) == 1 and q in b.states[0] and beginning.sign(b.states[0][q], b.conditions) is None:
            conditions.append(more_than_zero(b.states[0][q]))
    return replace(b, conditions=tuple(conditions))


def _parted(
    b: AnswerBranch, reason: Reason, beginning: InitialMotion, arriving: Collection[sp.Symbol], one: bool
) -> tuple[AnswerBranch | None, AnswerBranch | None]:
    """The part of a branch that may come first, and the branch if no part of it may."""
    kept = tuple(s for s in b.states if not _is_ruled_out(s, reason, beginning, arriving, one, b.conditions))
    if len(kept) == len(b.states):
        return b, None
    return (b.at(kept), None) if kept else (None, b)


def _is_ruled_out(
    state: State,
    reason: Reason,
    beginning: InitialMotion,
    arriving: Collection[sp.Symbol],
    one: bool,
    conditions: Sequence[SignCondition],
) -> bool:
    if reason is Reason.INITIAL:
        return beginning.is_initial(state)
    if reason is Reason.ARRIVAL:
        beyond = any(_comes_from_beyond(state, q, beginning, conditions) for q in arriving)
        return beyond or _leaves(state, beginning, conditions)
    return one and any(_is_behind(state, q, beginning, conditions) for q in beginning.by_themselves)


def _comes_from_beyond(
    state: State, q: sp.Symbol, beginning: InitialMotion, conditions: Sequence[SignCondition]
) -> bool:
    """Whether q has the wrong sense for its first arrival: q' (q_1 − q_0) is negative, whichever is the larger."""
    way, speed = _way(state, q, beginning, conditions), state.get(prime(q))
    if speed is None or q not in state or q not in beginning.initial:
        return False
    if way is None:
        return beginning.sign(factored_quotient(speed * (state[q] - beginning.initial[q])), conditions) == -1
    sign = beginning.sign(speed, conditions)
    if way == 0:  # it comes back, from the side to which it went
        start = beginning.direction(q)
        return start in (1, -1) and sign == start
    return sign == -way


def _leaves(state: State, beginning: InitialMotion, conditions: Sequence[SignCondition]) -> bool:
    """Whether a function of the position that is zero in a state grows in size: it came from the side of its start."""
    f = beginning.place
    if f is None:
        return False
    slots = beginning.slots
    start = f.xreplace(dict(beginning.initial))
    rate = sp.Add(*(f.diff(q) * prime(q) for q in slots.coordinates)).xreplace(dict(state))
    if (start.free_symbols | rate.free_symbols) & {*slots.coordinates, *slots.velocities}:
        return False
    return beginning.sign(factored_quotient(start * rate), conditions) == 1


def _is_behind(state: State, q: sp.Symbol, beginning: InitialMotion, conditions: Sequence[SignCondition]) -> bool:
    """Whether a state is a turning point on the other side than that to which q starts."""
    start = beginning.direction(q)
    return state.get(prime(q)) == 0 and start in (1, -1) and _way(state, q, beginning, conditions) == -(start or 0)


def _way(state: State, q: sp.Symbol, beginning: InitialMotion, conditions: Sequence[SignCondition] = ()) -> int | None:
    """The sign of q_1 − q_0; 0 where they are equal, and ±1 where the conditions exclude the other sign."""
    if q not in state or q not in beginning.initial:
        return None
    return beginning.sign(state[q] - beginning.initial[q], conditions)


def sign_of_value(e: sp.Expr, conditions: Sequence[SignCondition] = ()) -> int | None:
    """The sign of a value, where conditions hold; for a number by its digits, where it is not zero."""
    return _sign_where(e, tuple(conditions))


@lru_cache(maxsize=MOST_SIGNS)
def _sign_where(e: sp.Expr, conditions: tuple[SignCondition, ...]) -> int | None:
    e = without_known_magnitudes(e)
    if is_zero(e) is True:
        return 0
    sign = _sign_of_angle(e, conditions) if e.has(sp.acos) else None  # first: of the whole it takes long
    if sign is None:
        sign = _sign(e, conditions)
    return _sign(factored_quotient(sp.expand(e)), conditions) if sign is None else sign


def _sign_of_angle(e: sp.Expr, conditions: Sequence[SignCondition]) -> int | None:
    """The sign of c acos(u) + a: acos lies between 0 and π, and falls with u."""
    [angle, *others] = e.atoms(sp.acos)
    if others and (sign := _sign_beyond_half_turns(e)) is not None:
        return sign
    if len(others) > 1:
        return None
    letter = sp.Dummy(real=True)
    linear = sp.expand(e.xreplace({angle: letter}))
    c, rest = linear.coeff(letter, 1), linear.coeff(letter, 0)
    if not c.is_number or c == 0 or linear != c * letter + rest:
        return None
    way = 1 if c > 0 else -1
    against = sp.expand(-rest / c)  # the sign is that of acos(u) − against
    if against.is_number:
        if against <= 0 or against >= sp.pi:
            return way if against <= 0 else -way
    elif not _is_half_turn(against):
        beyond = _sign(against - sp.pi, conditions) in (0, 1)
        return -way if beyond else way if _sign(-against, conditions) in (0, 1) else None
    difference = sign_of_value(angle.args[0] - sp.cos(against), conditions)
    return None if difference is None else -way * difference


def _sign_beyond_half_turns(e: sp.Expr) -> int | None:
    """The sign of a + c_1 acos(u_1) + c_2 acos(u_2) with numbers a, c_1, c_2, where any angles in [0, π] have it."""
    terms = [t.as_independent(sp.acos, as_Add=False) for t in sp.Add.make_args(sp.expand(e))]
    if not all((c.is_number and isinstance(u, sp.acos)) or (c.is_number and u == 1) for c, u in terms):
        return None
    constant = sp.Add(*(c for c, u in terms if u == 1))
    lowest, highest = (constant + sp.pi * sp.Add(*(f(c, 0) for c, u in terms if u != 1)) for f in (sp.Min, sp.Max))
    if lowest.is_positive:
        return 1
    return -1 if highest.is_negative else None


def _is_half_turn(angle: sp.Expr) -> bool:
    """Whether an angle lies between 0 and π."""
    return isinstance(angle, sp.acos) or (
        isinstance(angle, Bounded) and bool(angle.is_nonnegative) and (angle.high - sp.pi).is_nonpositive is True
    )


def _sign(e: sp.Expr, conditions: Sequence[SignCondition]) -> int | None:
    """The sign of an expression that is not zero."""
    number, rest = e.as_independent(*e.free_symbols, as_Add=False) if e.free_symbols else (e, sp.S.One)
    if not number.is_real:
        return None
    above = [(c.lhs - c.rhs) * (1 if c.relation in (">", "≥") else -1) for c in conditions if c.relation in "><≥≤"]
    sign = sign_of(rest, above)
    if sign is None:
        sign = _by_squares(sp.factor_terms(rest), above)
    if sign is None and rest.has(sp.log):
        sign = _beside_logarithm(with_joined_logarithms(sp.expand(rest)))
    return None if sign is None else sign * (1 if number.evalf() > 0 else -1)


def _by_squares(e: sp.Expr, above: Sequence[sp.Expr] = ()) -> int | None:
    """The sign of a product with sums A − B of two positive terms in it, A² − B² deciding: m v − √m √(m v² + b)."""
    sign = 1
    for f in sp.Mul.make_args(e):
        own = sign_of(f)
        if own is None and isinstance(f, sp.log):  # log u has the sign of u − 1
            own = sign_of(sp.factor(f.args[0] - 1)) if sign_of(f.args[0], above) == 1 else None
        if own is None and isinstance(f, sp.asinh):
            own = sign_of(f.args[0], above)
        if own is None and f.is_Add and len(f.args) == 2:
            a, b = f.args
            of_a, of_b = sign_of(a), sign_of(b)
            larger = sign_of(sp.expand(a**2 - b**2))
            own = None if None in (of_a, of_b, larger) else (of_a or 0) if larger in (0, 1) else of_b
            if larger == 0 and of_a is not None and of_b == -of_a:
                own = 0  # |s| − s of a positive s
        if own is None:
            return None
        sign *= own
    return sign


def _beside_logarithm(e: sp.Expr) -> int | None:
    """The sign of a + c log w, where 1 − 1/w < log w < w − 1 decides it: k v − g log(1 + k v/g) is positive."""
    logs = [*e.atoms(sp.log)]
    if len(logs) != 1:
        return None
    [log] = logs
    w, c = log.args[0], e.coeff(log, 1)
    a = sp.expand(e - c * log)
    sign = sign_of(c)
    if a.has(sp.log) or c.has(sp.log) or sign not in (1, -1) or sign_of(w) != 1:
        return None
    if sign_of(sp.factor(w - 1)) not in (1, -1):
        return None
    bounds = (factored_quotient(a + c * (w - 1)), factored_quotient(a + c * (1 - 1 / w)))
    upper, lower = bounds if sign == 1 else bounds[::-1]
    if sign_of(lower) in (0, 1):
        return 1
    return -1 if sign_of(upper) in (0, -1) else None


def _with_direction(b: AnswerBranch, beginning: InitialMotion) -> AnswerBranch:
    """A turning point, with the condition that it lies in the direction of the start, where that is not certain."""
    conditions: list[SignCondition] = []
    for q in beginning.by_themselves:
        start = beginning.direction(q)
        if start not in (1, -1) or len(b.states) != 1 or b.states[0].get(prime(q)) != 0:
            continue
        if _way(b.states[0], q, beginning, b.conditions) is None and q in b.states[0] and q in beginning.initial:
            conditions.append(more_than_zero(start * (b.states[0][q] - beginning.initial[q])))
    new = {c.lhs - c.rhs for c in conditions}
    kept = [c for c in b.conditions if not (c.relation == "≠" and {c.lhs - c.rhs, c.rhs - c.lhs} & new)]
    return replace(b, conditions=(*kept, *(c for c in conditions if c not in kept)))


def _nearest(
    branches: Sequence[AnswerBranch], beginning: InitialMotion
) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """The nearest of several turning points in the direction of the start, and the others."""
    branches = list(branches)
    if len(branches) < 2 or not all(len(b.states) == 1 for b in branches):
        return branches, []
    for q in beginning.by_themselves:
        start = beginning.direction(q)
        states = [b.states[0] for b in branches]
        if start not in (1, -1) or not all(s.get(prime(q)) == 0 for s in states):
            continue
        if not all(_way(s, q, beginning) == start for s in states):
            continue
        for b, s in zip(branches, states, strict=True):
            if all(beginning.sign(o[q] - s[q]) in (0, start) for o in states):
                return [b], [o for o in branches if o is not b]
    return branches, []


def _reached_first(
    branches: Sequence[AnswerBranch], beginning: InitialMotion
) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """The part of the branches that the motion reaches first, where it is certain that no turning point lies before it.

    One coordinate goes on in the direction of the start up to the first turning point; the other side comes later.
    """
    branches = list(branches)
    own = beginning.own if beginning.along is None else (beginning.along,)
    moving = [q for q in own if any(q in s for b in branches for s in b.states)]
    if len(moving) == 1 and beginning.direction(moving[0]) == 0:
        return _nearest_on_each_side(branches, moving[0], beginning)
    coordinates = [q for q in own if beginning.direction(q) in (1, -1)]
    pairs = [(b, s) for b in branches for s in b.states]
    if len(coordinates) != 1 or len(pairs) < 2:
        return branches, []
    [q] = coordinates
    way = beginning.direction(q) or 0
    if not all(q in s and _way(s, q, beginning) in (1, -1) for _, s in pairs):
        return branches, []
    ahead = [(b, s) for b, s in pairs if _way(s, q, beginning) == way]
    nearest = [(b, s) for b, s in ahead if all(beginning.sign(o[q] - s[q]) in (0, way) for _, o in ahead)]
    if not nearest or q not in beginning.initial:
        return branches, []
    [b, state], *_ = nearest
    if not _is_free(state[q], q, way, beginning) and not _is_mirror_image(q, [s for _, s in pairs], beginning):
        return branches, []
    return [b.at([state])], [o for o in branches if o is not b]


def _nearest_on_each_side(
    branches: Sequence[AnswerBranch], q: sp.Symbol, beginning: InitialMotion
) -> tuple[list[AnswerBranch], list[AnswerBranch]]:
    """From an equilibrium the motion starts in either direction: what comes first in each of them, and the others."""
    places = [s[q] for b in branches for s in b.states if q in s]
    start = beginning.initial.get(q)
    if start is None or len(places) != sum(len(b.states) for b in branches):
        return list(branches), []

    def is_later(place: sp.Expr) -> bool:
        way = beginning.sign(place - start)
        return way in (1, -1) and any(
            beginning.sign(o - start) == way and beginning.sign(place - o) == way for o in places
        )

    kept = [b for b in branches if not all(is_later(s[q]) for s in b.states)]
    return kept, [b for b in branches if b not in kept]


def _is_free(place: sp.Expr, q: sp.Symbol, way: int, beginning: InitialMotion) -> bool:
    """Whether no turning point lies between the start and a place."""
    turning = beginning.turning()
    if turning is None:
        return False
    for p in turning:
        past_start = beginning.sign(p - beginning.initial[q])
        before_end = beginning.sign(place - p)
        if past_start not in (0, -way) and before_end not in (0, -way):
            return False
    return True


def _is_mirror_image(q: sp.Symbol, states: Sequence[State], beginning: InitialMotion) -> bool:
    """Whether two places lie opposite each other about the start, and motions to either side are mirror images.

    Then the one ahead comes first: a motion that turns before it swings no farther to the other side.
    """
    acceleration = beginning.accelerations.get(prime(q, 2))
    if len(states) != 2 or acceleration is None or is_zero(beginning.initial[q]) is not True:
        return False
    others = {t, *beginning.slots.coordinates, *beginning.slots.velocities} - {q, prime(q)}
    if acceleration.free_symbols & others:
        return False
    mirrored = acceleration.xreplace({q: -q, prime(q): -prime(q)})
    return is_zero(states[0][q] + states[1][q]) is True and is_zero(acceleration + mirrored) is True


def _are_mirrored(branches: Sequence[AnswerBranch]) -> bool:
    """Whether there are two values, one the opposite of the other."""
    values = [v for b in branches for v in b.values]
    return len(values) == 2 and len(branches) == 2 and is_zero(values[0] + values[1]) is True


def _is_reversed(quantity: sp.Expr, slots: Slots) -> bool:
    """Whether a quantity has the opposite sign in the motion with opposite velocities: a steady rate has no sense."""
    return bool(sp.expand(quantity + quantity.xreplace({v: -v for v in slots.velocities})) == 0)


def outright(conditions: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> list[sp.Symbol]:
    """The coordinates whose value a condition gives."""
    alone = [e.free_symbols & {*coordinates} for e in conditions if not _moves(e)]
    return [next(iter(s)) for s in alone if len(s) == 1]


def _moves(e: sp.Expr) -> bool:
    return any(base(s) != s for s in e.free_symbols)
