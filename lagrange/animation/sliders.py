"""The sliders of a page: how far a parameter or a coordinate can be moved from where the page begins."""

from __future__ import annotations

import math

import sympy as sp

from lagrange.animation.figure import Slider
from lagrange.core.symbols import Bounded, Sign
from lagrange.problem.model import Assumption, Parameter, Problem


def parameter_slider(symbol: sp.Symbol, problem: Problem, number: float, angle: bool) -> Slider:
    """The slider of a parameter."""
    declared = next((p for p in problem.parameters if p.symbol == symbol), None)
    given = declared is not None and declared.value is not None
    low, high = _ends(symbol, declared, number, angle)
    return Slider(
        symbol,
        number,
        min(low, number),
        max(high, number),
        "" if declared is None else declared.unit or declared.stated_unit,
        "" if declared is None else declared.meaning,
        given,
        angle,
        2.0 if isinstance(symbol, Sign) else 0.0,
    )


def _ends(symbol: sp.Symbol, declared: Parameter | None, number: float, angle: bool) -> tuple[float, float]:
    if isinstance(symbol, Sign):
        return -1.0, 1.0
    if isinstance(symbol, Bounded):
        width = float(symbol.high - symbol.low)
        return float(symbol.low) + 0.001 * width, float(symbol.high) - 0.001 * width
    if declared is not None and declared.assume is Assumption.REAL:
        size = math.pi if angle else 3 * (abs(number) or 1.0)
        return -size, size
    return (0.0, math.pi) if angle else (0.1 * number, 3 * number) if number > 0 else (0.0, 3.0)


def coordinate_slider(symbol: sp.Symbol, problem: Problem, number: float, angle: bool) -> Slider:
    """The slider of a coordinate."""
    declared = next((q for q in problem.coordinates if q.symbol == symbol), None)
    reach = math.pi if angle else max(3.0, 2 * abs(number))
    low, high = -reach, reach
    if declared is not None and declared.range is not None:
        ends = [e for e in (declared.range.low, declared.range.high) if e.is_number]
        low, high = (float(ends[0]), float(ends[1])) if len(ends) == 2 else (low, high)
    unit = "rad" if angle else "" if declared is None else declared.unit
    meaning = "" if declared is None else declared.meaning
    return Slider(symbol, number, min(low, number), max(high, number), unit, meaning, False, angle)
