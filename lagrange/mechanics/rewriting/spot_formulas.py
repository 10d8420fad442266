"""Numbers for a pocket calculator as a reader sees them: only the relevant ones, angles within a turn, short terms."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.mechanics.limits import LONGEST_SOLVED, LONGEST_SPOT_FORMULA
from lagrange.mechanics.results import InCoordinates


def values_that_matter(view: InCoordinates, values: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The values without coordinates that occur in no equation, with angles between −π and π."""
    equations = _equations(view)
    coordinates = {*view.configuration.slots.coordinates}
    used = {s: e for s, e in values.items() if s not in coordinates or any(a.has(s) for a in equations)}
    far = {s: e for s, e in used.items() if s in coordinates and e.is_number and not abs(e) < 3}
    if not far:
        return used
    plain = [e.replace(lambda x: isinstance(x, TrigonometricFunction), lambda _: sp.Dummy()) for e in equations]
    turns = {s: sp.floor((e + sp.pi) / (2 * sp.pi)) for s, e in far.items() if not any(p.has(s) for p in plain)}
    return {s: sp.N(e - 2 * sp.pi * turns[s], 6) if turns.get(s) else e for s, e in used.items()}


def _equations(view: InCoordinates) -> list[sp.Expr]:
    """What the accelerations follow from."""
    rows = view.configuration.rows
    equations = [] if view.motion is None else [e.expression for e in view.motion.equations]
    equations += [e for r in rows for e in (*r.coefficients, r.drift, *([r.finite] if r.finite is not None else []))]
    return [*equations, *(r.nonlinear for r in rows if r.nonlinear is not None)]


def acceleration_formula(view: InCoordinates, acceleration: sp.Symbol) -> sp.Expr | None:
    """The acceleration as a formula, where there is only one and it is short."""
    if view.motion is None or len(view.motion.equations) != 1 or view.configuration.rows:
        return None
    equation = view.motion.equations[0].expression
    if count_operations(equation) > LONGEST_SOLVED:
        return None
    factor = equation.diff(acceleration)
    if factor == 0 or factor.has(acceleration):
        return None
    formula = textbook_form(-(equation - factor * acceleration).expand() / factor)
    return formula if count_operations(formula) <= LONGEST_SPOT_FORMULA and not formula.is_number else None
