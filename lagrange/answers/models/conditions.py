"""Wrong conditions of rest: what they are the conditions of.

A condition is slack s ≥ 0, and its limit is s = 0. A stated one is put beside each derived one, changed as people get
it wrong: the sense of the inequality, another meaning of a letter (`meanings`), two contacts whose limits are added up,
a factor of one side, one term of the balance. Limits are the same where the value of a letter in which the changed one
is linear makes the stated one vanish: at random numbers first, then exactly.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.models.meanings import Meaning, other_meanings, with_waves_exchanged
from lagrange.core.records import record
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation

MOST_TERMS = 8
"""Terms of a condition, multiplied out, in which one wrong term is sought."""

_SAMPLES = 3
_CLOSE = 1e-9


@record
class Stated:
    """A stated condition that is none of the derived ones: its text and its slack; an equation where it vanishes."""

    text: str
    slack: sp.Expr
    equation: bool


def explained_conditions(
    stated: Sequence[Stated], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]
) -> str:
    """What the stated conditions are instead, in a sentence; empty if that is not found.

    derived       the slacks of the derived conditions, all of which have to hold
    coefficients  those of friction
    """
    if not stated or not derived:
        return ""
    try:
        if (together := _of_all(stated, derived, coefficients)) is not None:
            return together
    except _unknown:
        pass
    reasons = {}
    for s in stated:
        try:
            reason = next(_reasons(s, derived, coefficients), "")
        except _unknown:
            continue
        if reason:
            reasons.setdefault(s.text, reason)
    if len(reasons) == 1 and len({s.text for s in stated}) == 1:
        return next(iter(reasons.values()))
    return "; ".join(f"`{text_}`: {reason}" for text_, reason in reasons.items())


_unknown = (NoPointError, UnsupportedError, DivisionByZeroError, ZeroDivisionError, sp.PolynomialError)


def _of_all(stated: Sequence[Stated], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]) -> str | None:
    """The one meaning of the letters, or the sense of the inequalities, that makes all stated conditions right."""
    limits = [limit for d in derived if (limit := _Limit.of(d)) is not None]
    if any(s.equation for s in stated):
        return None
    if all(any(limit.is_of(s.slack) for limit in limits) for s in stated):
        return _REVERSED
    if len(stated) < 2:
        return None
    for meaning in _meanings(stated, derived, coefficients):
        changed = [c for d in limits if (c := _Limit.of(d.slack.xreplace(dict(meaning.rule)))) is not None]
        if all(any(c.is_of(s.slack) and c.sense(s.slack) > 0 for c in changed) for s in stated):
            return _scaled_limit(meaning, stated[0].slack) or f"these are the conditions {meaning.clause}"
    return None


def _scaled_limit(meaning: Meaning, slack: sp.Expr) -> str:
    """P <= 2 W for P <= W: with P/2 in place of P; empty for other changes."""
    [(letter, value), *others] = meaning.rule.items()
    factor = value / letter
    if others or not factor.is_Rational or factor <= 0 or not isinstance(letter, sp.Symbol):
        return ""
    rate = sp.diff(slack, letter)
    if letter in rate.free_symbols or rate == 0:
        return ""
    return f"the limit of {letter} is {_TIMES.get(1 / factor, f'{1 / factor} times')} what it should be"


def _meanings(
    stated: Sequence[Stated], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]
) -> list[Meaning]:
    letters, used = (set().union(*map(_symbols, es)) for es in (derived, [s.slack for s in stated]))
    return [*with_waves_exchanged(derived), *other_meanings(letters, used, coefficients)]


def explained_limits(stated: Sequence[Stated], derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]) -> str:
    """The same for limits that are stated as equations: friction is about to give way."""
    found = explained_conditions([replace(s, equation=False) for s in stated], derived, coefficients)
    if _REVERSED in found or _AND_REVERSED in found:
        return ""
    return found.replace("this is the condition", "this is the limit").replace(
        "these are the conditions", "these are the limits"
    )


def is_limit(slack: sp.Expr, stated: sp.Expr) -> bool:
    """Whether a stated slack vanishes at the limit of another."""
    try:
        limit = _Limit.of(slack)
        return limit is not None and limit.is_of(stated)
    except _unknown:
        return False


def is_other_sense(missing: sp.Expr, stated: sp.Expr, coefficients: Collection[sp.Expr]) -> bool:
    """Whether a condition is another one for friction that acts the other way."""
    rule = {mu: -mu for mu in coefficients}
    changed = _Limit.of(missing.xreplace(rule))
    return bool(rule) and changed is not None and changed.is_of(stated)


def _reasons(stated: Stated, derived: Sequence[sp.Expr], coefficients: Collection[sp.Expr]) -> Iterator[str]:
    limits = [_Limit.of(d) for d in derived]
    known = [limit for limit in limits if limit is not None]
    for limit in known:
        if limit.is_of(stated.slack):
            yield _AN_EQUATION if stated.equation else _REVERSED
    for limit in known:
        yield from _of_sides(stated.slack, limit.slack)
    meanings = _meanings([stated], derived, coefficients)
    for limit in known:
        for meaning in meanings:
            if limit.slack.free_symbols.isdisjoint(meaning.rule):
                continue
            changed = _Limit.of(limit.slack.xreplace(dict(meaning.rule)))
            if changed is not None and changed.is_of(stated.slack):
                reversed_ = not stated.equation and changed.sense(stated.slack) < 0
                said = _scaled_limit(meaning, stated.slack) or f"this is the condition {meaning.clause}"
                yield f"{said}{_AND_REVERSED if reversed_ else ''}"
    for n, a in enumerate(known):
        for b in known[:n]:
            if (total := a.added(b)) is not None and total.is_of(stated.slack):
                yield _ADDED
    for limit in known:
        yield from _of_terms(stated.slack, limit.slack)


_REVERSED = "the limit is right, and the inequality has the wrong sense"
_AND_REVERSED = ", and with the wrong sense of the inequality"
_AN_EQUATION = "this is the limit, and not the range in which the system rests"
_ADDED = "the limits of two contacts are added: each of them has to hold by itself"


@record
class _Limit:
    """slack = 0, solved for a letter in which it is linear."""

    slack: sp.Expr
    letter: sp.Symbol
    value: sp.Expr

    @classmethod
    def of(cls, slack: sp.Expr) -> _Limit | None:
        """The limit of a slack; None if it is linear in no letter."""
        for form in (slack, _cleared(slack)):
            for s in sorted(_symbols(form), key=lambda s: (sp.diff(form, s).count_ops(), str(s))):  # noqa: B023
                rate = sp.diff(form, s)
                if s not in rate.free_symbols and rate != 0:
                    return cls(slack, s, s - form / rate)
        return None

    def is_of(self, other: sp.Expr) -> bool:
        """Whether another slack vanishes at this limit."""
        if not any(s in other.free_symbols for s in self.slack.free_symbols):
            return False
        residual = other.xreplace({self.letter: self.value})
        if self.letter not in other.free_symbols or not all(
            abs(_value(residual, p)) < _CLOSE for p in _points(residual)
        ):
            return False
        return is_zero(sp.expand(residual)) is True

    def sense(self, other: sp.Expr) -> int:
        """1 if the other slack has the sign of this one, −1 if it has the opposite one."""
        signs = {
            1 if _value(self.slack, p) * _value(other, p) > 0 else -1 for p in _points(sp.Add(self.slack, other))
        }
        return signs.pop() if len(signs) == 1 else 1

    def added(self, other: _Limit) -> _Limit | None:
        """s ≤ f + g, of s ≤ f and s ≤ g."""
        for s in sorted(_symbols(self.slack) & _symbols(other.slack), key=str):
            rates = [sp.diff(x, s) for x in (self.slack, other.slack)]
            if all(s not in r.free_symbols and all(_value(r, p) < 0 for p in _points(r)) for r in rates):
                bounds = [s - x / r for x, r in zip((self.slack, other.slack), rates, strict=True)]
                if not any(_same(b, 0) for b in bounds):
                    return _Limit(sp.Add(*bounds) - s, s, sp.Add(*bounds))
        return None


def _same(a: sp.Expr, b: sp.Expr) -> bool:
    return sp.expand(a - b) == 0


def _cleared(e: sp.Expr) -> sp.Expr:
    """A slack without denominators, tangents by sines and cosines, multiplied out."""
    plain = e.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)).replace(sp.cot, lambda x: sp.cos(x) / sp.sin(x))
    return sp.expand(sp.fraction(sp.together(plain))[0])


def _of_sides(stated: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """The limit of a letter that is a multiple of the right one."""
    own, other = (sp.Add.make_args(_cleared(e)) for e in (stated, right))
    if len(own) != 2 or len(other) != 2:
        return
    ratios = [(a / b) / (other[0] / other[1]) for a, b in (own, own[::-1])]
    for ratio in (r for r in ratios if r.is_Rational and r > 0 and r != 1):
        of_term = [{s for s in _symbols(term) if sp.diff(term, s, 2) == 0} for term in other]
        alone = [[s for s in of_term[n] if s not in of_term[1 - n]] for n in (0, 1)]
        n = min((n for n in (0, 1) if alone[n]), key=lambda n: other[n].count_ops(), default=None)
        if n is None:
            return
        letter = min(alone[n], key=str)
        factor = ratio if n == 1 else 1 / ratio
        yield f"the limit of {letter} is {_TIMES.get(factor, f'{factor} times')} what it should be"
        return


_TIMES = {sp.Integer(2): "twice", sp.Rational(1, 2): "half of"}


def _of_terms(stated: sp.Expr, right: sp.Expr) -> Iterator[str]:
    """One term of the balance that is missing, has the wrong sign, or is another one."""
    own, other = ([*sp.Add.make_args(_cleared(e))] for e in (stated, right))
    if not 1 < len(other) <= MOST_TERMS or len(own) > MOST_TERMS:
        return
    for scale in dict.fromkeys(a / b for a in own for b in other):
        scaled = [sp.powsimp(scale * b) for b in other]
        lost, gained = [a for a in own if a not in scaled], [b for b in scaled if b not in own]
        if max(len(lost), len(gained)) != 1 or len(gained) == len(other):
            continue
        term = gained[0] / scale if gained else None
        if not lost and term is not None:
            yield f"the term {_written(term)} is missing"
        elif term is None:
            yield f"the term {_written(lost[0] / scale)} does not belong there"
        elif sp.expand(lost[0] + gained[0]) == 0:
            yield f"the sign of the term {_written(term)} is wrong"
        elif len(other) > 2:
            yield f"{_written(lost[0] / scale)} stands where {_written(term)} belongs"


def _written(term: sp.Expr) -> str:
    return text(-term if term.could_extract_minus_sign() else term, Notation())


def _symbols(e: sp.Expr) -> set[sp.Symbol]:
    return {s for s in e.free_symbols if isinstance(s, sp.Symbol)}


def _points(e: sp.Expr) -> Iterator[Mapping[sp.Symbol, sp.Float]]:
    """Random numbers of order one for all letters: acute angles."""
    draw = random.Random(7)
    letters = sorted(_symbols(e), key=str)
    for _ in range(_SAMPLES):
        yield {s: sp.Float(draw.uniform(0.3, 1.3)) for s in letters}


def _value(e: sp.Expr, point: Mapping[sp.Symbol, sp.Float]) -> float:
    value = e.xreplace(dict(point)).evalf()
    return float(value) if value.is_real and value.is_finite else float("inf")
