"""Vectors by the unit vectors that the file names in `let`, or of its frame: a force N n, not N sin θ i − N cos θ j.

The line that says what n is stays.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from lagrange.core.symbols import UnitVector, VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.derivation import Block, Display, Equation, Math, Mathematics, Part, Prose, Step
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.named_directions import Directions, in_named_directions, unit_directions


def in_directions(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with vectors along the unit vectors of the file written as their multiples."""
    units = unit_directions(solution.problem)
    for step in steps:
        yield replace(step, body=tuple(_block(b, units) for b in step.body)) if units else step


def _block(block: Block, units: Directions) -> Block:
    if isinstance(block, Prose):
        return replace(block, parts=tuple(_part(p, units) for p in block.parts))
    if isinstance(block, Display):
        return replace(block, equations=tuple(_line(e, units) for e in block.equations))
    return block


def _part(part: Part, units: Directions) -> Part:
    return replace(part, sides=tuple(_side(s, units) for s in part.sides)) if isinstance(part, Math) else part


def _line(line: Equation, units: Directions) -> Equation:
    if isinstance(line.sides[0], VectorSymbol | UnitVector) and line.sides[0].name in units:
        return line
    return replace(line, sides=tuple(_side(s, units) for s in line.sides))


def _side(side: Mathematics, units: Directions) -> Mathematics:
    return in_named_directions(side, units) if isinstance(side, Vector) else side
