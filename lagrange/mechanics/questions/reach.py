"""Whether a motion reaches a state, for one coordinate q whose velocity is a function of it: q'^2 = f(q).

    from q_0 to q_1 in the direction of the start     f > 0 between them
    back over q_0                                     a turning point f = 0 ahead, then the same

f is smallest between two places at an end or where f' = 0, so that an energy barrier is a zero p of f' with f'' >= 0
between them, and f(p) > 0 is the condition for passing it. At q_1 itself f must not be negative. With q' = v at the
start a pendulum passes the top where v^2 > 4 g l; one that is let go below the horizontal never gets there.

A state with q' = 0 and q'' = 0 is an equilibrium: a motion that is not there already only approaches it, for t → ∞.
If this is undecided, the answer holds provided that the motion gets there.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field, replace
from enum import Enum
from functools import lru_cache

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, not_negative, sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.questions.branches import InitialMotion, bounds, outright, sign_of_value
from lagrange.mechanics.questions.elimination import eliminated
from lagrange.mechanics.questions.forms import shown, under_one_root
from lagrange.mechanics.questions.limits import LONGEST_INTEGRATED, MOST_FUNCTIONS, SMALLEST_DIFFERENCE
from lagrange.mechanics.questions.quadrature import time_between
from lagrange.mechanics.questions.results import AnswerBranch, Asked
from lagrange.mechanics.questions.setting import Setting


class Reached(Enum):
    """Whether a state is reached."""

    YES = "yes"  # under the conditions
    NEVER = "never"
    OPEN = "open"


@record
class Reach:
    """The verdict, with the conditions under which it holds."""

    verdict: Reached
    conditions: tuple[SignCondition, ...] = ()


@record
class Path:
    """A motion along one coordinate.

    square     q'^2 as a function f of q
    start      q_0
    direction  the sign with which q starts; 0: from an equilibrium, either; None: not known
    rest       whether it starts at rest
    known      conditions that hold
    values     numbers for the parameters, which decide what letters leave open
    positive   whether q is a radius, and does not get to 0
    """

    q: sp.Symbol
    square: sp.Expr
    start: sp.Expr
    direction: int | None
    rest: bool = False
    positive: bool = False
    values: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    known: tuple[SignCondition, ...] = field(default_factory=tuple)

    def to(self, end: sp.Expr) -> Reach:
        """Whether the motion gets to q_1; to q_0 itself on its way back."""
        way = self._sign(end - self.start)
        if way is None and self.rest:
            return self._either_way(end)
        far = self._is_periodic and self.start.is_number and abs(self.start) > 2 * sp.pi
        if (
            (self.direction is None and not self.rest)
            or way is None
            or far
            or count_operations(self.square) > LONGEST_INTEGRATED
        ):
            return Reach(Reached.OPEN)
        conditions = not_negative(factored_quotient(self._at(end)))
        if conditions is None or self._sign(self._at(end)) == -1:
            return Reach(Reached.NEVER)
        if self._sign(self._at(end)) is not None:
            conditions = ()
        if (way == 0 or way == -(self.direction or 0)) and not (self.rest and self.direction is None):
            turned = self._turns()
            if turned.verdict is not Reached.YES:
                return turned
            conditions = (*conditions, *turned.conditions)
        if way == 0 or (way == self.direction and self._is_next_turn(end, way)):
            return Reach(Reached.YES, conditions)
        passed = self._passes(end, way)
        return Reach(passed.verdict, (*conditions, *passed.conditions))

    def _either_way(self, end: sp.Expr) -> Reach:
        """From rest, where letters leave open which of the two places is the larger: both orders must agree."""
        ends = []
        for relation in (">", "<"):
            order = SignCondition(end - self.start, relation, sp.S.Zero)
            path = replace(self, known=(*self.known, order))
            way = path._sign(self._value(self.square.diff(self.q), self.start))
            if path._sign(end - self.start) is None:
                return Reach(Reached.OPEN)
            ends.append(replace(path, direction=way).to(end))
        return ends[0] if ends[0] == ends[1] else Reach(Reached.OPEN)

    def _is_next_turn(self, end: sp.Expr, way: int) -> bool:
        """Whether q_1 is a turning point, and no other lies before it."""
        zeros = self.turning_places() if self._sign(self._at(end)) == 0 else None
        return zeros is not None and all(self._inside(p, end, way) is False for p in zeros)

    def turning_places(self) -> list[sp.Expr] | None:
        """All q with f = 0, of an angle over some turns; None if they are not found."""
        zeros = self._zeros(self.square)
        return None if zeros is None else [p for p, _ in zeros]

    def lies_ahead(self, place: sp.Expr) -> bool:
        """Whether a place lies in the direction of the start."""
        return self._sign(place - self.start) == self.direction

    def _turns(self) -> Reach:
        """Whether a turning point lies ahead."""
        if self.direction in (0, None):
            return Reach(Reached.OPEN)
        assert self.direction is not None
        zeros = self._zeros(self.square)
        if zeros is None:
            return Reach(Reached.OPEN)
        signs = [self._sign(p - self.start) for p, _ in zeros]
        ahead = [c for (_, c), s in zip(zeros, signs, strict=True) if s == self.direction]
        if any(not c for c in ahead) or len(ahead) == 1:
            return Reach(Reached.YES, min(ahead, key=len))
        if ahead:  # of several families of turning points one may exist without the others
            is_one = self._is_periodic and len({frozenset(c) for c in ahead}) == 1
            return Reach(Reached.YES, ahead[0]) if is_one else Reach(Reached.OPEN)
        if self._is_periodic and not zeros:
            return Reach(Reached.NEVER)  # it goes on round
        if len(zeros) == 1 and signs == [None]:
            [(p, existing)] = zeros
            lies_ahead = more_than_zero(factored_quotient(self.direction * (p - self.start)))
            return Reach(Reached.YES, (*existing, lies_ahead))
        return Reach(Reached.OPEN if None in signs else Reached.NEVER)

    def _passes(self, end: sp.Expr, way: int) -> Reach:
        """Whether f is positive between q_0 and q_1; for an angle at most over one turn, which is like all others."""
        if self._is_periodic and (end - self.start).is_number and abs(end - self.start) > 2 * sp.pi:
            end = self.start + 2 * sp.pi * way
        below = sp.fraction(sp.together(self.square))[1]
        poles = self._zeros(below) if self.q in below.free_symbols else []
        slope = sp.factor(self.square.diff(self.q))
        level = sp.fraction(sp.together(slope))[0]
        lowest = self._zeros(level) if self.q in level.free_symbols else []
        if poles is None or any(self._inside(p, end, way) is not False for p, _ in poles):
            return Reach(Reached.OPEN)
        if lowest is None:
            return self._passes_in_numbers(slope, end)
        conditions: list[SignCondition] = []
        curvature = slope.diff(self.q)
        for p, existing in lowest:
            inside = self._inside(p, end, way)
            if inside is False or self._sign(self._value(curvature, p)) == -1:
                continue
            height = self._at(p)
            sign = self._sign(height)
            if sign == 1:
                continue
            if sign == 0 and inside is None and not existing and self._sign(p - self.start) == way:
                conditions.append(more_than_zero(factored_quotient(way * (p - end))))  # it is only approached
                continue
            if inside is None or existing:
                return Reach(Reached.OPEN)
            if sign in (0, -1):
                return Reach(Reached.NEVER)
            conditions.append(more_than_zero(sp.factor(height)))
        return Reach(Reached.YES, tuple(dict.fromkeys(conditions)))

    def _passes_in_numbers(self, slope: sp.Expr, end: sp.Expr) -> Reach:
        """The same where f' has no zeros in closed form, and all parameters have values."""
        from lagrange.values.numerical_roots import real_roots

        in_numbers = slope.xreplace(dict(self.values))
        ends = [self._number(e) for e in (self.start, end)]
        if in_numbers.free_symbols != {self.q} or None in ends or ends[0] == ends[1]:
            return Reach(Reached.OPEN)
        low, high = sorted(float(x) for x in ends if x is not None)
        roots = real_roots([in_numbers], [self.q], [(low, high)])
        heights = [self._number(self._at(r.values[0])) for r in roots.roots]
        inside = [h for r, h in zip(roots.roots, heights, strict=True) if low < r.values[0] < high]
        if not roots.complete or None in inside:
            return Reach(Reached.OPEN)
        return Reach(Reached.NEVER if any(h < 0 for h in inside if h is not None) else Reached.YES)

    def _inside(self, p: sp.Expr, end: sp.Expr, way: int) -> bool | None:
        if self.positive and p == 0:
            return False
        if (after := self._sign(p - self.start)) in (0, -way):
            return False
        if (before := self._sign(end - p)) in (0, -way):
            return False
        return None if None in (after, before) else True

    @property
    def _is_periodic(self) -> bool:
        return bool(self.square.has(sp.cos, sp.sin)) and self._at(self.q + 2 * sp.pi) == self.square

    def _zeros(self, e: sp.Expr) -> list[tuple[sp.Expr, tuple[SignCondition, ...]]] | None:
        """All zeros in closed form, those of a periodic function over some periods; None if they are not found."""
        zeros = _zeros_of(e, self.q)
        turns: Sequence[int] = range(-2, 3) if self._is_periodic else range(1)
        if zeros is None:
            return None
        return [(p + 2 * sp.pi * n, c) for p, c in zeros if self._may_exist(p, c) for n in turns]

    def _may_exist(self, place: sp.Expr, conditions: Sequence[SignCondition]) -> bool:
        """Whether a zero is real, and its conditions hold, with the values of the parameters; True where they lack."""
        if not place.free_symbols <= self.values.keys():
            return True
        way = {">": 1, "≥": 1, "<": -1, "≤": -1}
        margins = [self._number(way[c.relation] * (c.lhs - c.rhs)) for c in conditions if c.relation in way]
        if any(m is not None and m < -SMALLEST_DIFFERENCE for m in margins):
            return False
        height = sp.im(sp.N(place.xreplace(dict(self.values)), 20))
        return not (height.is_number and abs(height) > SMALLEST_DIFFERENCE)

    def _at(self, place: sp.Expr) -> sp.Expr:
        return self._value(self.square, place)

    def _value(self, e: sp.Expr, place: sp.Expr) -> sp.Expr:
        value = e.xreplace({self.q: place})
        if value == e or not place.free_symbols or count_operations(value) > LONGEST_INTEGRATED:
            return value
        return value.replace(lambda f: isinstance(f, sp.Abs) or (f.is_Pow and f.exp.is_Rational), self._without_root)

    def _without_root(self, f: sp.Expr) -> sp.Expr:
        """d (M² + m²)/(M − m) for √(d² (M² + m²)²/(M − m)²) where M > m; the same for a magnitude."""
        if f.is_Pow and (f.exp.q != 2 or f.base.is_Atom):
            return f
        inside = sp.factor(f.base if f.is_Pow else f.args[0])
        factors = [x.as_base_exp() for x in sp.Mul.make_args(inside)]
        if f.is_Pow and not all(n.is_Integer and (n % 2 == 0 or b.is_positive) for b, n in factors):
            return f
        signs = [sign_of_value(b, self.known) for b, _ in factors]
        if not {*signs} <= {1, -1}:
            return f
        half = f.exp if f.is_Pow else sp.S.One
        return sp.Mul(*((s * b) ** (n * half) for s, (b, n) in zip(signs, factors, strict=True) if s is not None))

    def _sign(self, e: sp.Expr) -> int | None:
        number = self._number(e)  # first: signs of long expressions in letters take seconds
        if number is not None and abs(number) >= SMALLEST_DIFFERENCE:
            return 1 if number > 0 else -1
        return sign_of_value(e, self.known)

    def _number(self, e: sp.Expr) -> sp.Expr | None:
        """An expression with the values of the parameters; None if one is missing, or it is not real."""
        if not e.free_symbols <= self.values.keys():
            return None
        value = sp.N(e.xreplace(dict(self.values)), 20)
        return value if value.is_Float or value.is_Rational else None


@lru_cache(maxsize=MOST_FUNCTIONS)
def _zeros_of(e: sp.Expr, q: sp.Symbol) -> tuple[tuple[sp.Expr, tuple[SignCondition, ...]], ...] | None:
    """All zeros in closed form, of a periodic function in one period; None if they are not found."""
    if sign_of(e) in (1, -1):
        return ()
    elimination = eliminated([e], q, [q], [], q)
    if elimination.never:
        return ()
    if not elimination.solved or elimination.free or elimination.verified is not True:
        return None
    return tuple((v, b.conditions) for b in elimination.branches for v in b.values)


def place_stated(when: sp.Expr, setting: Setting, beginning: InitialMotion) -> tuple[sp.Symbol, sp.Expr] | None:
    """The coordinate of which a condition states the place, and that place; of q' = 0 the turning point ahead."""
    coordinates = setting.place.configuration.slots.coordinates
    reached = outright([when], coordinates)
    if len(reached) == 1:
        [q] = reached
        return q, when.xreplace({q: sp.S.Zero}) / -when.diff(q)
    for q in coordinates:
        rate, square = when.diff(prime(q)), setting.square_of(q)
        if when != rate * prime(q) or not rate.is_number or rate == 0 or square is None or q not in setting.initial:
            continue
        path = Path(q, square, setting.initial[q], beginning.direction(q), values=setting.values)
        ahead = [p for p in path.turning_places() or () if path.direction and path.lies_ahead(p)]
        return (q, ahead[0]) if len(ahead) == 1 else None
    return None


def approach(asked: Asked, when: sp.Expr, setting: Setting) -> Asked | None:
    """The time in which two bodies come to a distance u, if u'² is a function of u that increases all the way.

    asked  without the answer
    when   u − u_1, with u a sum of several coordinates with numbers as factors
    """
    slots = setting.place.configuration.slots
    shares = {q: when.diff(q) for q in slots.coordinates if when.diff(q) != 0}
    along = sp.Add(*(c * q for q, c in shares.items()))
    rate = sp.Add(*(c * prime(q) for q, c in shares.items()))
    end = sp.expand(along - when)
    moving = {*setting.place.moving}
    start, speed = (e.xreplace(dict(setting.initial)) for e in (along, rate))
    pushed = sp.Add(*(c * setting.known.accelerations.get(prime(q, 2), sp.nan) for q, c in shares.items()))
    pushed = pushed.xreplace(dict(setting.initial))
    is_sum = len(shares) > 1 and all(c.is_number for c in shares.values()) and not setting.place.configuration.rows
    if not is_sum or pushed.has(sp.nan) or any(e.free_symbols & moving for e in (start, end, speed, pushed)):
        return None
    way = sign_of_value(end - start)
    starts = sign_of_value(pushed if is_zero(speed) is True else speed)
    if way not in (1, -1) or starts != way:
        return None
    side = {sign_of_value(e) for e in (start, end)} <= {0, 1}
    u = sp.Dummy("u", positive=True) if side else sp.Dummy("u", real=True)
    first, c = next(iter(shares.items()))
    rule = {first: sp.expand(first + (u - along) / c)}
    used = [(i.expression - i.value).xreplace(rule) for i in setting.integrals]
    unknowns = [*slots.velocities, *(q for q in slots.coordinates if q != first)]
    found = eliminated(used, rate**2, unknowns, slots.velocities, rate**2)
    values = {v for b in found.branches for v in b.values}
    if not found.solved or found.free or len(values) != 1 or (square := values.pop()).free_symbols & moving:
        return None
    if sign_of_value(sp.factor(square.diff(u))) != way:
        return None
    velocity = way * sp.sqrt(square)
    time = time_between(u, velocity, start, end, way)
    integrand = (along, under_one_root(velocity).xreplace({u: along}), start, end)
    return (
        None if time is None else replace(asked, integrand=integrand, branches=(shown(AnswerBranch(t, time, (time,))),))
    )


def initial_motion(setting: Setting, rule: Mapping[sp.Symbol, sp.Expr], when: Sequence[sp.Expr]) -> InitialMotion:
    """The initial state, with what is known of the motion from it.

    rule  the coordinates and velocities that the constraints express by the others
    when  the conditions of a question
    """
    configuration, initial = setting.place.configuration, setting.initial
    coordinates = configuration.slots.coordinates
    radii = tuple(
        q
        for q in coordinates
        if sign_of_value(initial.get(q, sp.S.Zero)) == 1
        and (q == setting.problem.radius or setting.is_kept_from_zero(q))
    )
    own = tuple(q for q in coordinates if q not in rule and q not in setting.fixed)
    free = len(coordinates) - len(configuration.rows)
    along = None if free == 1 else _along(setting, own, [e.xreplace(dict(rule)) for e in when])
    return InitialMotion(
        initial,
        setting.known.accelerations,
        configuration.slots,
        free,
        radii,
        lambda: _turning(setting, own if along is None else (along,)),
        own,
        setting.values,
        bounds(setting.problem),
        along,
        _place(setting, [e.xreplace(dict(rule)) for e in when]),
    )


def _place(setting: Setting, when: Sequence[sp.Expr]) -> sp.Expr | None:
    """The one condition, if it is a continuous function of the coordinates alone."""
    coordinates = {*setting.place.configuration.slots.coordinates}
    if len(when) != 1 or (when[0].free_symbols & {*setting.place.moving}) - coordinates:
        return None
    [e] = when
    is_continuous = not e.has(sp.tan, sp.cot, sp.log, sp.sign, sp.sec, sp.csc) and not any(
        p.exp.is_negative and p.free_symbols & coordinates for p in e.atoms(sp.Pow)
    )
    return e if is_continuous and e.free_symbols & coordinates else None


def _along(setting: Setting, own: Collection[sp.Symbol], when: Sequence[sp.Expr]) -> sp.Symbol | None:
    """The one coordinate that the conditions are about, where its velocity is a function of it alone."""
    asked = {base(s) for e in when for s in e.free_symbols & {*setting.place.moving}}
    if len(asked) != 1 or not asked <= {*own}:
        return None
    [q] = asked
    return q if {q, prime(q)} <= {*setting.initial} and setting.square_of(q) is not None else None


def _turning(setting: Setting, own: Collection[sp.Symbol]) -> Sequence[sp.Expr] | None:
    """The coordinate at all states of rest, for one that moves by itself; None if they are not known."""
    moving = [q for q in own if setting.known.accelerations.get(prime(q, 2), 0) != 0]
    if len(moving) != 1 or moving[0] not in setting.initial:
        return None
    [q] = moving
    square = setting.square_of(q)
    return None if square is None else Path(q, square, setting.initial[q], None).turning_places()


def kept_senses(when: Sequence[sp.Expr], setting: Setting) -> dict[sp.Symbol, int]:
    """The sense in which a coordinate moves as long as the equations of motion hold, where conditions state its place.

    Friction is taken with one sense of the slip: what lies against that from the start was never reached in it.
    """
    configuration = setting.place.configuration
    stated = {q for q in outright(when, configuration.slots.coordinates) if all(e.diff(q, 2) == 0 for e in when)}
    senses: dict[sp.Symbol, int] = {}
    for e in setting.slips if stated else ():
        for q in stated & setting.initial.keys():
            rate = e.diff(prime(q))
            sense = None if rate.free_symbols & {*setting.place.moving} else sign_of_value(rate)
            if sense in (1, -1) and sp.expand(e - rate * prime(q)) == 0:
                senses[q] = sense
    return senses
