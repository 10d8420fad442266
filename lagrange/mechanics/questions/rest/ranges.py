"""The states of an answer in the ranges of the coordinates: the slider of a crank on this side of the shaft."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.equilibrium.within_ranges import distances
from lagrange.mechanics.questions.limits import DIGITS
from lagrange.mechanics.questions.results import AnswerBranch

SymbolValues = Mapping[sp.Symbol, sp.Expr]
_TOLERANCE = sp.Float(10) ** (-DIGITS // 2)


def in_ranges(b: AnswerBranch, configuration: Configuration, values: SymbolValues) -> AnswerBranch | None:
    """The part of a branch in the ranges of the coordinates; None where there is none."""
    kept = [s for s in b.states if not any(_is_outside(q, s, configuration, values) for q in configuration.ranges)]
    return b.at(kept) if kept or not b.states else None


def _is_outside(q: sp.Symbol, state: SymbolValues, configuration: Configuration, values: SymbolValues) -> bool:
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
