"""Which branches of an answer the motion gets to, and under what conditions: `reach`, for the states of a question."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.questions.branches import Beginning
from lagrange.mechanics.questions.reach import Path, Reach, Reached
from lagrange.mechanics.questions.results import AnswerBranch
from lagrange.mechanics.questions.setting import Setting
from lagrange.mechanics.questions.states import Values


@record
class Arrivals:
    """The states that a question is about.

    rule       the coordinates and velocities that the constraints express by the others
    when       the conditions, each zero
    parameter  the parameter that is asked for, if it is one
    """

    setting: Setting
    beginning: Beginning
    rule: Mapping[sp.Symbol, sp.Expr]
    when: tuple[sp.Expr, ...]
    parameter: sp.Symbol | None

    def reached(self, branches: Sequence[AnswerBranch]) -> list[AnswerBranch]:
        """The branches to which the motion gets, with the conditions of that; a doubt stays with the branch."""
        kept: list[AnswerBranch] = []
        for b in branches:
            found = [self._reach_of(s, b) for s in b.states[:1]] or [Reach(Reached.OPEN)]
            reach = found[0]
            if reach.verdict is Reached.NEVER:
                continue
            conditions = tuple(c for c in reach.conditions if c not in b.conditions)
            limit = any(self._is_equilibrium(s) for s in b.states[:1])
            is_open = reach.verdict is Reached.OPEN
            kept.append(replace(b, conditions=(*b.conditions, *conditions), provided=is_open, limit=limit))
        return kept

    def _reach_of(self, state: Values, b: AnswerBranch) -> Reach:
        """Whether the motion gets to a state: along the one coordinate that moves, or that the conditions are about."""
        beginning, fixed = self.beginning, {*self.setting.fixed}
        found = {self.parameter: b.values[0]} if self.parameter is not None and b.values else {}
        initial = {s: v.xreplace(found) for s, v in self.setting.initial.items()}
        moving = {*self.setting.place.moving}
        asked = {base(s) for e in self.when for s in e.xreplace(self.rule).free_symbols & moving} - fixed
        if not asked or self._is_where_it_starts(state, initial, found):
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
            square=square.xreplace(found),
            start=initial[q],
            direction=replace(beginning, initial=initial).direction(q),
            rest=initial.get(prime(q)) == 0,
            positive=q in beginning.radii,
            values={p.symbol: p.value for p in self.setting.problem.parameters if p.value is not None},
            known=tuple(c for c in b.conditions if c.relation != "="),
        )
        return path.to(state[q])

    def _is_where_it_starts(self, state: Values, initial: Values, found: Values) -> bool:
        """Whether the conditions hold at t = 0, and the state is that one as far as both are known."""
        moving = {*self.setting.place.moving}
        at_start = [e.xreplace(found).xreplace({t: sp.S.Zero, **initial}) for e in self.when]
        if not all(e.free_symbols.isdisjoint(moving) and is_zero(e) is True for e in at_start):
            return False
        return all(is_zero(e.xreplace(found) - initial[s]) is True for s, e in state.items() if s in initial)

    def _is_equilibrium(self, state: Values) -> bool:
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
