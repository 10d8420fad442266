"""Wrong times, places and motions where the motion is known as a function of time: what happens then and there instead.

A time that is asked for belongs to an event, y = 0 or x' = 0. A wrong one often belongs to another event: the stone is
at its highest point, the oscillation is over once and not half. A wrong place is where the acceleration vanishes, or
where another velocity does. A wrong motion x(t) does not begin as the problem says.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.core.symbols import base, prime, t
from lagrange.document.math_writer import text
from lagrange.document.notation import Notation
from lagrange.mechanics.questions.results import Asked

StateAndRates = Mapping[sp.Symbol, sp.Expr]


def explained_instant(claim: sp.Expr, asked: Asked, others: Sequence[Asked]) -> str:
    """What happens at a wrong time or place, or how a wrong motion begins, in a sentence; empty if that is not found.

    others  all questions, in some of which the motion was found as a function of time
    """
    motion: dict[sp.Symbol, sp.Expr] = {}
    for a in others:
        motion |= {q: e for q, e in a.solutions.items() if a.choice == asked.choice}
    question = asked.question
    initial = {s.symbol: s.value for s in asked.initial}
    try:
        if question.by == t and question.quantity.is_Symbol:
            return next(_beginnings(claim, question.quantity, initial), "")
        if not motion or question.by is not None:
            return ""
        if question.quantity == t:
            return next(_events(claim, motion, initial, "then"), "")
        own = motion.get(question.quantity) if question.quantity.is_Symbol else None
        return "" if own is None else next(_at_place(claim, question.quantity, own, motion, initial), "")
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return ""


def _beginnings(claim: sp.Expr, quantity: sp.Symbol, initial: Mapping[sp.Basic, sp.Expr]) -> Iterator[str]:
    for symbol, value in ((quantity, claim), (prime(quantity), sp.diff(claim, t))):
        if base(quantity) == quantity and symbol in initial:
            begins = value.xreplace({t: sp.S.Zero})
            if is_zero(begins - initial[symbol]) is False:
                yield f"at t = 0 this gives {symbol} = {_written(begins)} and not {_written(initial[symbol])}"


def _events(time: sp.Expr, motion: StateAndRates, initial: Mapping[sp.Basic, sp.Expr], when: str) -> Iterator[str]:
    """What happens at a time."""
    if is_zero(time) is not False:
        return
    states = {
        prime(q, n) if n else q: sp.diff(e, t, n).xreplace({t: time}) for q, e in motion.items() for n in (0, 1, 2)
    }
    start = {s: v for s, v in states.items() if s in initial}
    if len(start) >= 2 * len(motion) and all(is_zero(v - initial[s]) is True for s, v in start.items()):
        yield f"{when} everything is as at the start again: it is a whole period, or several"
    for n in (1, 2, 0):
        for q, e in motion.items():
            s = prime(q, n) if n else q
            rate = sp.diff(e, t, n)  # one that is constant is zero at all times
            if rate.has(t) and is_zero(states[s]) is True and is_zero(sp.diff(rate, t)) is not True:
                yield f"{when} {s} = 0, which is not what is asked for"


def _at_place(
    claim: sp.Expr, q: sp.Symbol, own: sp.Expr, motion: StateAndRates, initial: Mapping[sp.Basic, sp.Expr]
) -> Iterator[str]:
    """What happens where a coordinate has a value."""
    rate = sp.diff(own, t)
    if rate != 0 and not rate.has(t):
        yield from _events((claim - own.xreplace({t: sp.S.Zero})) / rate, motion, initial, "there")
        return
    turning = [w for w in own.atoms(sp.sin, sp.cos) if w.has(t)]
    middle = own.xreplace(dict.fromkeys(turning, sp.S.Zero))
    if turning and not middle.has(t) and is_zero(claim - middle) is True:
        yield f"there {prime(q, 2)} = 0: it is the middle of the oscillation"


def _written(e: sp.Expr) -> str:
    return text(e, Notation())
