"""The states of an answer in the ranges of the coordinates: the slider of a crank on this side of the shaft."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.equilibrium.within_ranges import distances
from lagrange.mechanics.questions.limits import DIGITS
from lagrange.mechanics.questions.results import AnswerBranch

Values = Mapping[sp.Symbol, sp.Expr]
_TOLERANCE = sp.Float(10) ** (-DIGITS // 2)


def in_ranges(b: AnswerBranch, configuration: Configuration, values: Values) -> AnswerBranch | None:
    """The part of a branch in the ranges of the coordinates; None where there is none."""
    kept = [
        n
        for n, s in enumerate(b.states)
        if not any(_is_outside(q, s, configuration, values) for q in configuration.ranges)
    ]
    if len(kept) == len(b.states):
        return b
    if not kept:
        return None
    several = len(b.values) == len(b.states)
    left = tuple(b.values[n] for n in kept) if several else b.values
    return replace(b, rhs=left[0] if len(left) == 1 else b.rhs, values=left, states=tuple(b.states[n] for n in kept))


def _is_outside(q: sp.Symbol, state: Values, configuration: Configuration, values: Values) -> bool:
    if q not in state:
        return False
    expressions = (
        *configuration.finite_constraints,
        *(c for p in configuration.points for c in p.position.fixed().components),
    )
    is_angle = any(q in f.free_symbols for e in expressions for f in e.atoms(*CIRCULAR))
    tested, complement = distances(q, configuration.ranges[q], is_angle)
    numbers = [e.xreplace({q: state[q]}).xreplace(dict(values)).evalf(DIGITS) for e in tested]
    if not all(n.is_number and n.is_real for n in numbers):
        return False
    return all(n > _TOLERANCE for n in numbers) if complement and numbers else any(n < -_TOLERANCE for n in numbers)
