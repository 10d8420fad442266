"""A figure that moves, as data, with its sliders and the sample functions in it.

A figure that moves, as data: a program in JavaScript, numbers for the page, and what is written beside them.

The sliders of a page: how far a parameter or a coordinate can be moved from where the page begins.

Sample functions in the figure: the constraints with them, and the surface of a bowl.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Bounded, Sign
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.results import Solution
from lagrange.problem.keys import Assumption
from lagrange.problem.model import Parameter, Problem
from lagrange.programs.defaults import SampleFunctions
from lagrange.programs.state_equations import filled


@record
class Slider:
    """A quantity that the reader can change.

    label   how it is written
    given   whether the file has its value
    angle   whether it turns something
    """

    label: sp.Expr | str
    value: float
    low: float
    high: float
    unit: str = ""
    meaning: str = ""
    given: bool = False
    angle: bool = False
    step: float = 0.0


class UnmovableError(ValueError):
    """A figure cannot move; the message says why, in words for a reader."""


@record
class Still:
    """Why a page does not move."""

    reason: str


@record
class EquilibriumButton:
    """An equilibrium that can be chosen: how it is written, and whether it is stable."""

    relations: tuple[tuple[sp.Expr, sp.Expr], ...]
    stability: str


@record
class MovingFigure:
    """The figure of a page that can be moved.

    code         an object of functions in JavaScript
    data         numbers and names of functions for the page, without any text of the file
    labels       what is written into the figure, by number
    coordinates, parameters  what the reader can change
    reactions    the unknowns in which the reactions are written
    conserved    what is constant along the motion
    equilibria   where it can be at rest
    moves        whether there are equations of motion
    rests        whether there are generalized forces that vanish at rest
    released     whether the file says how the motion begins
    pushed       whether it begins slightly away from an equilibrium
    orbits       whether it begins in a nearly circular orbit, chosen by default
    assumed      what the page takes for functions that the file leaves open
    needed       generalized forces at rest that no position changes: there is no rest unless they vanish
    driven       prescribed motions that the file leaves open, which oscillate
    divided      whether the energy is kinetic and potential; that of a Lagrangian given outright is not
    """

    code: str
    data: Mapping[str, Any]
    labels: tuple[sp.Expr | str, ...]
    coordinates: tuple[Slider, ...]
    parameters: tuple[Slider, ...]
    reactions: tuple[sp.Expr, ...]
    conserved: tuple[tuple[str, sp.Expr], ...]
    equilibria: tuple[EquilibriumButton, ...]
    moves: bool
    rests: bool
    released: bool
    pushed: bool = False
    orbits: bool = False
    assumed: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    needed: tuple[sp.Expr, ...] = ()
    driven: tuple[sp.Symbol, ...] = ()
    divided: bool = True


# Sliders


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


# Samples


def sampled(solution: Solution, taken: SampleFunctions) -> Solution:
    """The solution with the samples in the constraints of its configurations, for the figure."""
    if not taken:
        return solution

    own = solution.own.configuration

    def put(e: sp.Expr) -> sp.Expr:
        return filled(sp.sympify(e, strict=True), taken, own.slots, solution.problem)

    rows = tuple(
        replace(
            row,
            coefficients=tuple(map(put, row.coefficients)),
            drift=put(row.drift),
            finite=None if row.finite is None else put(row.finite),
        )
        for row in own.rows
    )
    drawn = replace(own, constrained=ConstrainedSystem(own.slots, rows))
    return replace(solution, own=replace(solution.own, configuration=drawn))


def surfaces(configuration: Configuration) -> Iterator[tuple[tuple[sp.Expr, ...], tuple[sp.Symbol, ...], sp.Expr]]:
    """The surface z = z(x, y) on which a relation keeps a particle at (x, y, z): its point, along what, its shift.

    Only where z can be solved for; the shift is that of the surface along its first coordinate.
    """
    for f in configuration.finite_constraints:
        for p in configuration.points:
            parts = p.position.fixed().components
            if not all(c.is_Symbol and c in configuration.slots.coordinates for c in parts):
                continue
            x, y, z = parts
            relation = sp.sympify(f, strict=True)
            slope = relation.diff(z)
            if slope != 0 and not slope.has(z) and not slope.has(x):
                height = sp.expand(z - relation / slope)
                bottom = sp.solve(sp.expand(height.diff(x)), x) if height.diff(x, 2) != 0 else []
                yield (x, y, height), (x, y), bottom[0] if len(bottom) == 1 and not bottom[0].has(y) else sp.S.Zero
                return
