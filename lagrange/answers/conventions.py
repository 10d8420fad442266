"""Answers that are right for a coordinate measured in another way: θ from the upward vertical, x to the left.

The answer is rewritten with q = −q*, q* + π, π − q*, q* ± π/2 or ±π/2 − q* for one coordinate q, and compared
again. Only an angle, which occurs in sines and cosines, can be measured from another direction.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import Enum

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, InadmissibleError, NoPointError, UnsupportedError
from lagrange.answers.models.residues import Residues, follows
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime


class Turn(Enum):
    """How a coordinate may have been measured instead."""

    REVERSED = "the other way"
    OPPOSITE = "from the opposite direction"
    SUPPLEMENT = "from the opposite direction, the other way"
    RIGHT_ANGLE = "from the perpendicular direction"
    COMPLEMENT = "from the perpendicular direction, the other way"


@record
class Convention:
    """A coordinate measured in another way: what the answer calls q is `meant` in the problem's coordinate q."""

    coordinate: sp.Symbol
    turn: Turn
    meant: sp.Expr


def other_convention(equations: Sequence[sp.Expr], residues: Residues) -> Convention | None:
    """The other way of measuring one coordinate with which all the equations follow; None if there is none."""
    try:
        states = residues.states(equations)
        for convention in _conventions(equations, residues.system.configuration.slots):
            if all(follows(_in_convention(e, convention), states) for e in equations):
                return convention
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
        pass
    return None


def _conventions(equations: Sequence[sp.Expr], slots: Slots) -> Iterator[Convention]:
    used = set().union(*(e.free_symbols for e in equations))
    waves = set().union(*(w.free_symbols for e in equations for w in e.atoms(sp.sin, sp.cos, sp.tan)))
    for q in slots.coordinates:
        if not used & {q, prime(q), prime(q, 2)}:
            continue
        yield Convention(q, Turn.REVERSED, -q)
        if q in waves:
            yield Convention(q, Turn.OPPOSITE, q + sp.pi)
            yield Convention(q, Turn.SUPPLEMENT, sp.pi - q)
            for quarter in (sp.pi / 2, -sp.pi / 2):
                yield Convention(q, Turn.RIGHT_ANGLE, q + quarter)
                yield Convention(q, Turn.COMPLEMENT, quarter - q)


def _in_convention(equation: sp.Expr, convention: Convention) -> sp.Expr:
    q = convention.coordinate
    sign = convention.meant.diff(q)
    rule = {q: convention.meant, prime(q): sign * prime(q), prime(q, 2): sign * prime(q, 2)}
    return equation.xreplace(rule)
