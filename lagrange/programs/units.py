"""Units of SI for the numbers of a motion: m, rad/s, N m; empty where the units of the file do not determine one."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.core.symbols import base
from lagrange.core.units import NO_DIMENSION, Dimension, unit_called, unit_of
from lagrange.problem.values import no_values, values_of
from lagrange.programs.state_equations import StateEquations
from lagrange.values.dimensions import dimension, dimensions_needed


class Units:
    """The units of the expressions of a motion."""

    def __init__(self, states: StateEquations) -> None:
        problem = states.problem
        known: dict[sp.Symbol, Dimension] = dict((values_of(problem) or no_values(problem)).units)
        configuration = states.configuration
        vectors = [p.position for p in configuration.points] + [a for r in configuration.rotations for a in r.axes]
        places = (c for v in vectors for c in v.fixed().components)
        waves = (w.args[0] for e in (*states.expressions, *places) for w in e.atoms(sp.sin, sp.cos, sp.tan))
        angles = {s for w in waves for term in sp.Add.make_args(w) if (s := term.as_coeff_Mul()[1]).is_Symbol}
        self._angles = {q for q in states.equations.slots.coordinates if q in angles and _is_number(known.get(q))}
        self._angles |= {q.symbol for q in problem.coordinates if (u := unit_of(q.unit)) is not None and u.is_angle}
        known |= dict.fromkeys(self._angles, NO_DIMENSION)
        for choice in problem.choices:
            stated = [(e, known[q]) for q, e in (choice.substitute or {}).items() if q in known]
            known = {**(dimensions_needed(stated, known) or {}), **known}
        for speed in problem.speeds:
            unit = dimension(speed.definition, known)
            if unit is not None:
                known[speed.symbol] = unit
        self._known: Mapping[sp.Symbol, Dimension] = known

    def of(self, expression: sp.Expr) -> str:
        """The unit of an expression; of a number none, of an angle rad."""
        unit = dimension(expression, self._known)
        if unit is None:
            return ""
        turns = bool(expression.is_Symbol) and base(expression) in self._angles
        return unit_called(unit, turns)


def _is_number(unit: Dimension | None) -> bool:
    return unit is None or unit == NO_DIMENSION


def with_unit(name: str, unit: str) -> str:
    """A name with its unit: `theta (rad)`."""
    return f"{name} ({unit})" if unit else name
