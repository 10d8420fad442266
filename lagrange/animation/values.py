"""Values with which a motion begins on a page: those of the file, and sensible ones where it has none.

Lengths are those of the drawing, so that the figure looks as it does on paper; what has a unit of its own gets a value
by the unit (9.81 m/s², 20 N/m). The motion begins in the position that is drawn, unless the file has an initial state:
a coordinate that the potential energy contains starts from rest, one that it does not contain starts moving, so that
something happens. A spinning body spins fast, as a top does.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import product

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.animation.figure import Slider
from lagrange.core.symbols import Bounded, Sign
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.pictures.floats import NoValueError, value
from lagrange.problem.model import Assumption, Parameter, Problem

_BY_UNIT = {"m/s^2": 9.81, "N/m": 20.0, "N*s/m": 0.4, "1/s": 2.0, "rad/s": 2.0, "m/s": 1.0, "N": 5.0, "kg*m^2": 0.5}
_BY_LETTER = {"g": 9.81, "k": 20.0, "c": 0.4, "mu": 0.3, "omega": 2.0, "Omega": 2.0, "w": 2.0, "F": 5.0}
MOST_TRIED = 3
SPIN = 14.0
"""Of a body in space about its own axis where there is gravity, in radians per second."""


def angles_in(expressions: Iterable[sp.Expr]) -> frozenset[sp.Symbol]:
    """The symbols that are a term of the argument of a sine or cosine, up to a factor."""
    terms = (a for e in expressions for f in e.atoms(TrigonometricFunction) for a in sp.Add.make_args(f.args[0]))
    return frozenset(s for a in terms if (s := a.as_coeff_Mul()[1]).is_Symbol)


def parameter_slider(symbol: sp.Symbol, problem: Problem, drawn: Mapping[sp.Symbol, float], angle: bool) -> Slider:
    """The slider of a parameter; `drawn`: the values with which the figure is drawn."""
    declared = next((p for p in problem.parameters if p.symbol == symbol), None)
    given = declared is not None and declared.value is not None
    number = float(declared.value) if declared is not None and declared.value is not None else None
    if number is None:
        number = _sensible(symbol, declared, problem, drawn, angle)
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


def _sensible(
    symbol: sp.Symbol, declared: Parameter | None, problem: Problem, drawn: Mapping[sp.Symbol, float], angle: bool
) -> float:
    if isinstance(symbol, Sign):
        return 1.0
    at = problem.figure.at.get(symbol.name)
    if at is not None:
        return float(at)
    unit = "" if declared is None else declared.unit or declared.stated_unit
    letter = symbol.name.split("_")[0].rstrip("0123456789")
    by = _BY_UNIT.get(unit) or (None if unit in ("m", "kg", "rad", "1") else _BY_LETTER.get(letter))
    number = by if by is not None else drawn.get(symbol)
    number = 1.0 if number is None else number
    number = float(f"{float(number):.2g}") if unit in ("m", "kg") or not declared else float(number)
    if angle and abs(number) > math.pi / 2:
        number = 0.5
    if isinstance(symbol, Bounded) and not symbol.low <= number <= symbol.high:
        number = float((symbol.low + symbol.high) / 2)
    return float(number)


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


def initial_state(
    problem: Problem,
    configuration: Configuration,
    position: Mapping[sp.Symbol, float],
    parameters: Mapping[sp.Symbol, float],
    potential: sp.Expr,
) -> dict[sp.Symbol, float]:
    """The values of the coordinates and velocities at t = 0."""
    slots = configuration.slots
    stated = {s.symbol: s.value for s in problem.initial}
    known = dict(parameters)
    state: dict[sp.Symbol, float] = {}
    for q in slots.coordinates:
        state[q] = _number(stated[q], known) if q in stated else position.get(q, 0.5)
    turning = spins(configuration) if problem.gravity is not None else ()
    spin = 5.0 if configuration.rows else SPIN
    for q, v in zip(slots.coordinates, slots.velocities, strict=True):
        if v in stated:
            state[v] = _number(stated[v], known)
        elif stated or potential.has(q):
            state[v] = 0.0
        else:
            state[v] = spin if q in turning else 1.0 if not (turning and configuration.rows) else 0.0
    return state


def slipping(
    state: dict[sp.Symbol, float],
    speeds: Sequence[sp.Symbol],
    slips: Sequence[sp.Expr],
    parameters: Mapping[sp.Symbol, float],
) -> dict[sp.Symbol, float]:
    """The state with other speeds, where what is to slip would not slip in it: the first that does of a few."""

    def slips_in(s: Mapping[sp.Symbol, float]) -> bool:
        return all(_number(e, {**parameters, **s}) > 0.1 for e in slips)

    if not slips or slips_in(state) or len(speeds) > MOST_TRIED:
        return state
    for trial in product((0.6, 0.0, -0.6, 2.0, -2.0), repeat=len(speeds)):
        tried = {**state, **dict(zip(speeds, trial, strict=True))}
        if slips_in(tried):
            return tried
    return state


def _number(e: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    try:
        return value(sp.sympify(e, strict=True), values)
    except NoValueError:
        return 0.0


def spins(configuration: Configuration) -> Sequence[sp.Symbol]:
    """The coordinates that turn a body in space about its third axis: they do not move that axis."""
    turning = []
    for r in configuration.rotations:
        first, third = r.axes[0].fixed(), r.axes[2].fixed()
        moving = set().union(*(c.free_symbols for c in third.components))
        if moving & {*configuration.slots.coordinates}:
            own = set().union(*(c.free_symbols for c in first.components)) - moving
            turning += [q for q in configuration.slots.coordinates if q in own]
    return turning
