"""Which branches of an answer the motion reaches, and under what conditions.

`reach` decides that for the states of a question. The equations of motion with kinetic friction hold while the slip
has the sense for which they were found: a ball that has begun to roll goes on in another way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, not_negative, sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.questions.branches import InitialMotion, sign_of_value
from lagrange.mechanics.questions.closed_motions import ClosedMotion
from lagrange.mechanics.questions.limits import MOST_TURNS
from lagrange.mechanics.questions.ranges import contact_has_ended, never_holds
from lagrange.mechanics.questions.reach import Path, Reach, Reached
from lagrange.mechanics.questions.results import AnswerBranch
from lagrange.mechanics.questions.setting import Setting
from lagrange.mechanics.questions.states import SymbolValues
from lagrange.mechanics.questions.times import fades, limit_in_time, times
from lagrange.problem.model import Question


@record
class Arrivals:
    """The states that a question is about.

    rule       the coordinates and velocities that the constraints express by the others
    when       the conditions, each zero
    parameter  the parameter that is asked for, if it is one
    quantity   what is asked for
    question   for messages
    """

    setting: Setting
    beginning: InitialMotion
    rule: Mapping[sp.Symbol, sp.Expr]
    when: tuple[sp.Expr, ...]
    parameter: sp.Symbol | None
    quantity: sp.Expr
    question: Question

    def at_the_start(self, branches: Sequence[AnswerBranch]) -> list[AnswerBranch]:
        """The initial state, where the conditions hold there and at no later time: the force on the crest of a hill."""
        values = []
        for b in branches:
            known = {self.parameter: b.values[0]} if self.parameter is not None and b.values else {}
            start = {s: v.xreplace(known) for s, v in self.setting.initial.items()}
            beginning = replace(self.beginning, initial=start)
            states = [s for s in b.states if beginning.is_initial(s)]
            if states and not (known and self.question.quantity.is_positive and sign_of(b.values[0]) == -1):
                values.append(b.at(states))
        return values

    def reached(self, branches: Sequence[AnswerBranch]) -> list[AnswerBranch]:
        """The branches to which the motion gets, with the conditions of that; a doubt stays with the branch.

        Raises ProblemError if it gets there only after a contact has ended.
        """
        kept: list[AnswerBranch] = []
        parted: list[str] = []
        for b in branches:
            if self._is_value_at_start(b):
                kept.append(replace(b, conditions=()))
                continue
            if b.states and self._is_terminal(b.states[0]):
                return [replace(b, limit=True)]  # and gets to no other
            reach = Reach(Reached.OPEN)
            for n, state in enumerate(b.states):
                reach = self._reach_of(state, b)
                if reach.verdict is not Reached.NEVER:
                    b = b.at(b.states[n:])
                    break
            if reach.verdict is Reached.NEVER:
                continue
            in_contact = self._in_contact(b)
            if isinstance(in_contact, str):
                parted.append(in_contact)
                continue
            others = [c for c in (*b.conditions, *reach.conditions) if not _follows(c, in_contact)]
            conditions = tuple(dict.fromkeys((*map(partial(self._in_finite_time, b), others), *in_contact)))
            limit = any(self._is_equilibrium(s) for s in b.states[:1])
            is_open = reach.verdict is Reached.OPEN
            kept.append(replace(b, conditions=conditions, provided=is_open, limit=limit))
        if parted and not kept:
            raise ProblemError(contact_has_ended(self.question, parted[0]))
        return kept

    def _in_contact(self, b: AnswerBranch) -> tuple[SignCondition, ...] | str:
        """The conditions under which one-sided constraints push, or pull, all the way to a state; the first that fails.

        A force of the wrong sign means that contact has ended before: the ball has left the dome.
        """
        if self.parameter is not None or not b.states:
            return ()
        conditions: list[SignCondition] = []
        for r in self.setting.place.law.newton.reactions:
            force = self.setting.known.reactions.get(r.force) if r.constraint.side is not None else None
            for value in () if force is None else self._values_on_the_way(force, b.states[0]):
                sign = self.beginning.sign(value, b.conditions)
                needed = not_negative(factored_quotient(value)) if sign is None else ()
                if sign == -1 or needed is None:
                    return r.name
                conditions += needed
        return tuple(dict.fromkeys(conditions))

    def _values_on_the_way(self, force: sp.Expr, state: SymbolValues) -> Iterator[sp.Expr]:
        """A reaction where the state is, and where it has an extreme on the way: at multiples of a right angle."""
        moving = {*self.setting.place.moving}
        at_end = force.xreplace(dict(state))
        if not at_end.free_symbols & moving:
            yield at_end
        involved = {base(s) for s in force.free_symbols & moving}
        if len(involved) != 1:
            return
        [q] = involved
        ends = [self.setting.initial.get(q), state.get(q)]
        square = self.setting.square_of(q)
        if square is None or any(e is None or not (e / sp.pi).is_Rational for e in ends):
            return
        along = sp.expand(force).subs(prime(q) ** 2, square)
        if along.free_symbols & moving - {q}:
            return
        low, high = sorted(int(sp.floor(2 * e / sp.pi)) for e in ends if e is not None)
        for k in range(low + 1, min(high, low + MOST_TURNS) + 1):
            place = {q: k * sp.pi / 2}
            if place[q] not in ends and is_zero(along.diff(q).xreplace(place)) is True:
                yield along.xreplace(place)

    def _reach_of(self, state: SymbolValues, b: AnswerBranch) -> Reach:
        """Whether the motion gets to a state: along the one coordinate that moves, or that the conditions are about."""
        beginning, fixed = self.beginning, {*self.setting.fixed}
        reached = {self.parameter: b.values[0]} if self.parameter is not None and b.values else {}
        initial = {s: v.xreplace(reached) for s, v in self.setting.initial.items()}
        moving = {*self.setting.place.moving}
        asked = {base(s) for e in self.when for s in e.xreplace(self.rule).free_symbols & moving} - fixed
        if not asked or self._is_where_it_starts(state, initial, reached):
            return Reach(Reached.YES)
        free = [q for q in self.setting.place.configuration.slots.coordinates if q not in self.rule and q not in fixed]
        candidates = free if len(free) == 1 else [q for q in free if q in asked]
        if len(candidates) != 1 or (len(free) > 1 and len(asked) > 1):
            return Reach(Reached.OPEN)
        [q] = candidates
        square = self.setting.square_of(q)
        if square is None or q not in state or q not in initial:
            return Reach(Reached.OPEN)
        path = Path(
            q=q,
            square=square.xreplace(reached),
            start=initial[q],
            direction=replace(beginning, initial=initial).direction(q),
            rest=initial.get(prime(q)) == 0,
            positive=q in beginning.radii,
            values=self.setting.values,
            known=tuple(c for c in b.conditions if c.relation != "="),
        )
        return path.to(state[q])

    def _is_where_it_starts(self, state: SymbolValues, initial: SymbolValues, reached: SymbolValues) -> bool:
        """Whether the conditions hold at t = 0, and the state is that one as far as both are known."""
        moving = {*self.setting.place.moving}
        at_start = [e.xreplace(reached).xreplace({t: sp.S.Zero, **initial}) for e in self.when]
        if not all(e.free_symbols.isdisjoint(moving) and is_zero(e) is True for e in at_start):
            return False
        return all(is_zero(e.xreplace(reached) - initial[s]) is True for s, e in state.items() if s in initial)

    def _is_value_at_start(self, b: AnswerBranch) -> bool:
        """Whether the conditions hold at t = 0 with the same value, so that the motion need not get there again."""
        if self.parameter is not None or len(b.values) != 1:
            return False
        initial, moving = self.setting.initial, {*self.setting.place.moving}
        start = {t: sp.S.Zero, **initial}
        values = [e.xreplace(start) for e in (self.quantity - b.values[0], *self.when)]
        if any(e.has(sp.nan, sp.zoo) for e in values):  # x'/y' of what starts from rest
            return False
        return all(e.free_symbols.isdisjoint(moving) and is_zero(e) is True for e in values)

    def _is_terminal(self, state: SymbolValues) -> bool:
        """Whether a state has a speed that the motion approaches: v' = a(v), with a = 0 and a' < 0 there.

        With at most two roots, of which every second one is approached, the other is not on the way if v' at t = 0
        has the sense of the way.
        """
        initial, moving = self.setting.initial, {*self.setting.place.moving}
        for v in self.setting.place.configuration.slots.velocities:
            a = self.setting.known.accelerations.get(prime(v))
            if a is None or v not in state or v not in initial or a.free_symbols & moving != {v}:
                continue
            above, below = sp.fraction(sp.together(a))
            if v in below.free_symbols or not above.is_polynomial(v) or sp.degree(above, v) > 2:
                continue
            end, start = state[v], initial[v]
            sign = self.beginning.sign
            way = sign(end - start)
            if way is None or way == 0 or is_zero(a.xreplace({v: end})) is not True:
                continue
            if sign(a.diff(v).xreplace({v: end})) == -1 and sign(a.xreplace({v: start})) == way:
                return True
        return False

    def _in_finite_time(self, b: AnswerBranch, c: SignCondition) -> SignCondition:
        """A condition |x| ≤ 1 of an angle acos x without equality, where the motion only approaches that place.

        A pendulum with just the energy to get upright never gets there: 4 g l > v².
        """
        state = b.states[0] if b.states else {}
        for q, angle in state.items() if c.relation in "≥≤" else ():
            if not isinstance(angle, sp.acos):
                continue
            margin = (c.lhs - c.rhs) * (1 if c.relation == "≥" else -1)
            for end in (1, -1):
                ratio = sp.cancel(margin / (1 - end * angle.args[0]))
                if sign_of(ratio) == 1 and self._is_equilibrium({**state, q: sp.acos(end)}):
                    return replace(c, relation=">" if c.relation == "≥" else "<")
        return c

    def _is_equilibrium(self, state: SymbolValues) -> bool:
        """Whether the motion only approaches a state: velocities and accelerations vanish there."""
        known, slots = self.setting.known, self.setting.place.configuration.slots
        left_out = {*self.setting.fixed, *self.rule}
        resting = [q for q, v in zip(slots.coordinates, slots.velocities, strict=True)
                   if state.get(v) == 0 and not {q, v} & left_out]  # fmt: skip
        initial = self.setting.initial
        both = [s for q in resting for s in (q, prime(q)) if s in state and s in initial]
        same = all(is_zero(state[s] - initial[s]) is True for s in both)
        if not resting or same or any(e.has(sp.sign) for e in known.accelerations.values()):
            return False
        if self.setting.place.law.frictions:
            return False
        values = [known.accelerations.get(prime(q, 2), sp.S.One).xreplace(dict(state)) for q in resting]
        return all(is_zero(e) is True for e in values)


def _follows(c: SignCondition, known: Sequence[SignCondition]) -> bool:
    """Whether a condition follows from one of others, because its margin is larger: 4 g l ≥ v² from 2 g l ≥ v².

    Or larger than a multiple of that: h ≥ 2 R from 2 h ≥ 5 R.
    """
    margin, enough = _margin(c), (0, 1) if c.relation in ("≥", "≤") else (1,)
    return margin is not None and any(
        (other := _margin(k)) is not None
        and any(sign_of_value(sp.expand(margin - m * other)) in enough for m in _multiples(margin, other))
        for k in known
    )


def _multiples(margin: sp.Expr, other: sp.Expr) -> list[sp.Expr]:
    """1, and the numbers by which a symbol's share in a margin exceeds that in another."""
    shares = [(margin.diff(s), other.diff(s)) for s in sorted(margin.free_symbols & other.free_symbols, key=str)]
    ratios = [a / b for a, b in shares if a.is_number and b.is_number and b != 0]
    return [sp.S.One, *(r for r in dict.fromkeys(ratios) if r.is_positive and r != 1)]


def _margin(c: SignCondition) -> sp.Expr | None:
    """The expression that must not be negative; None for an equation and other relations."""
    way = {">": 1, "≥": 1, "<": -1, "≤": -1}.get(c.relation)
    return None if way is None else way * (c.lhs - c.rhs)


def approached(
    question: Question, quantity: sp.Expr, when: Sequence[sp.Expr], rule: SymbolValues, motions: Sequence[ClosedMotion]
) -> AnswerBranch:
    """The value for t → ∞ of a quantity, where a condition holds in this limit only: the final speed of a fall.

    Raises ProblemError if the condition never holds, or the limit is not known.
    """
    is_approached = any(fades(m.at_time(e.xreplace(dict(rule)))) for m in motions for e in when)
    value = limit_in_time(motions[0].at_time(quantity)) if is_approached and len(motions) == len(when) == 1 else None
    if value is None or question.quantity == t:
        raise ProblemError(never_holds(question, is_approached))
    value = shortest_form(factored_quotient(value))
    return AnswerBranch(question.quantity, value, (value,), limit=True)


def goes_on(speed: sp.Expr, state: SymbolValues, beginning: InitialMotion) -> bool:
    """Whether a speed of slip is c q' with the sign that it has while q goes from its start to the state.

    state  one that is reached, along one coordinate if there are several, for the first time
    """
    moving = [q for q in beginning.by_themselves if prime(q) in speed.free_symbols]
    if len(moving) != 1 or moving[0] not in state or moving[0] not in beginning.initial:
        return False
    [q] = moving
    factor = speed.diff(prime(q))
    way = beginning.sign(state[q] - beginning.initial[q])
    if way not in (1, -1) or way != beginning.direction(q) or sp.expand(speed - factor * prime(q)) != 0:
        return False
    return factor.free_symbols.isdisjoint((q, prime(q))) and beginning.sign(factor) == way


def while_slipping(
    speeds: Sequence[sp.Expr], until: sp.Expr, sign: Callable[[sp.Expr], int | None]
) -> tuple[SignCondition, ...] | None:
    """The conditions under which slip lasts up to a time; None if it has ended before, or never begins.

    speeds  of the slip, as functions of time in the sense for which the equations hold: not negative while they do
    until   a time, or t itself
    sign    of an expression in parameters

    Raises UndecidedError if that is not found.
    """
    conditions: list[SignCondition] = []
    for speed in speeds:
        start = speed.xreplace({t: sp.S.Zero})
        if is_zero(start) is True:
            start = speed.diff(t).xreplace({t: sp.S.Zero})
        beginning = sign(start)
        if beginning == -1:
            return None
        if beginning is None:
            conditions.append(more_than_zero(start))
        least = _least_of_wave(speed, until, sign)
        if least is not None:
            signs = [sign(e) for e in least]
            if -1 in signs:
                return None
            conditions += [_not_below(e) for e, s in zip(least, signs, strict=True) if s is None]
            continue
        ends = times(speed)
        if ends is None:
            raise SlipEndUndecidedError
        for end in ends:
            lasts = None if until == t else sign(end.value - until)
            if lasts == -1 and not end.conditions:
                return None
            if lasts not in (0, 1):
                if end.conditions and len(ends) > 1:
                    raise SlipEndUndecidedError
                before = SignCondition(t, "≤", end.value) if until == t else _not_below(end.value - until)
                conditions.append(before)
    return tuple(dict.fromkeys(conditions))


def _least_of_wave(speed: sp.Expr, until: sp.Expr, sign: Callable[[sp.Expr], int | None]) -> list[sp.Expr] | None:
    """The least values of A + B cos ωt, or with the sine, between t = 0 and a time, without that at t = 0.

    Two where the sign of B is open. None if the speed is no such wave, or ω times the time no number: for
    z − sin ωt up to t = c/ω this is z − sin c, or z − 1 if c ≥ π/2.
    """
    e = sp.expand(speed)
    waves = [f for f in e.atoms(sp.sin, sp.cos) if t in f.free_symbols]
    if len(waves) != 1 or until == t:
        return None
    [wave] = waves
    size, phase = e.coeff(wave, 1), sp.cancel(sp.powdenest(wave.args[0].xreplace({t: until}), force=True))
    mean = sp.expand(e - size * wave)
    if t in mean.free_symbols | size.free_symbols or not phase.is_number or not phase.is_positive:
        return None
    if wave.args[0].xreplace({t: sp.S.Zero}) != 0:
        return None
    first = 0 if isinstance(wave, sp.cos) else sp.pi / 2
    turns = [first, first + sp.pi]  # one more period tells nothing new
    heights = [wave.func(0), *(wave.func(x) for x in turns if x < phase), wave.func(phase)]
    low, high = sp.Min(*heights), sp.Max(*heights)
    known = sign(size)
    needed = [low] if known == 1 else [high] if known == -1 else [low, high]
    return [mean + size * h for h in needed if h != heights[0]]


def while_it_begins(
    setting: Setting, rule: SymbolValues, sign: Callable[[sp.Expr], int | None]
) -> list[SignCondition] | None:
    """The conditions under which slip that is zero at t = 0 begins in the sense of the file; None if it does not."""
    initial, slots = setting.initial, setting.place.configuration.slots
    pairs = list(zip(slots.velocities, slots.accelerations, strict=True))
    conditions = []
    for e in setting.stated_slips:
        speed = e.xreplace(dict(rule))
        if not {*speed.free_symbols} & {*slots.velocities} <= initial.keys() or speed.xreplace(dict(initial)) != 0:
            continue
        rate = sp.Add(*(speed.diff(v) * setting.known.accelerations.get(a, a) for v, a in pairs)).xreplace(
            dict(initial)
        )
        if rate.free_symbols & {*setting.place.moving, *slots.accelerations}:
            continue
        at_rest = {f.coefficient: f.static for f in setting.place.law.frictions
                   if f.static is not None and f.coefficient.is_Symbol}  # fmt: skip
        rate = rate.xreplace(at_rest)
        begins = sign(rate)
        if begins in (0, -1):
            return None
        conditions += [more_than_zero(rate)] if begins is None else []
    return conditions


def _not_below(e: sp.Expr) -> SignCondition:
    """e ≥ 0; for a root and a negative term without the root: 12 v² ≥ 49 μ g L for 7 √(v² − 2μ g L) ≥ 5 v."""
    e = sp.expand(sp.fraction(sp.together(e))[0] * (sign_of(sp.fraction(sp.together(e))[1]) or 1))
    roots = [f for f in e.atoms(sp.Pow) if f.exp == sp.Rational(1, 2) and not f.base.is_number and f.base.is_Add]
    if len(roots) == 1:
        letter = sp.Dummy(positive=True)
        factor, rest = sp.expand(e.xreplace({roots[0]: letter})).coeff(letter, 1), e.xreplace({roots[0]: sp.S.Zero})
        if sign_of(factor) == 1 and sign_of(rest) == -1 and is_zero(factor * roots[0] + rest - e) is True:
            e = sp.expand(factor**2 * roots[0].base - rest**2)
    condition = more_than_zero(e)
    return replace(condition, relation=condition.relation.replace(">", "≥").replace("<", "≤"))


class SlipEndUndecidedError(Exception):
    """It is not known when slip ends."""
