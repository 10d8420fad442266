"""Vectors by the unit vectors that the file names in `let`, or of its frame: a force N n, not N sin θ i − N cos θ j.

v = c n + w with c = v_k/n_k, where w lacks the component k, or with c = v·n. It is written so where that is shorter.
The line that says what n is stays.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.symbols import UnitVector, VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.derivation import Block, Display, Equation, Math, Mathematics, Part, Prose, Step
from lagrange.mechanics.results import Solution

LONGEST = 120
"""The most operations of a vector that is looked at."""

Directions = Mapping[str, Vector]


def in_directions(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with vectors along the unit vectors of the file written as their multiples."""
    units = unit_vectors(solution)
    for step in steps:
        yield replace(step, body=tuple(_block(b, units) for b in step.body)) if units else step


def unit_vectors(solution: Solution) -> Directions:
    """The unit vectors of `let` and of the frame that are not along an axis, in i, j, k, by name."""
    named = {n: v for n, v in solution.problem.abbreviations.items() if isinstance(v, Vector)}
    units = {n: v.fixed() for n, v in named.items() if is_zero(v.dot(v) - 1) is True}
    frame = solution.problem.frame
    if frame is not None and frame.directions is not None:
        rows = (frame.directions.row(n) for n in range(3))
        units = {n: Vector((row[0], row[1], row[2])) for n, row in zip(frame.names, rows, strict=True)} | units
    return {n: v for n, v in units.items() if sum(c != 0 for c in v.components) > 1}


def unit_along(vector: Vector, units: Directions) -> sp.Expr | None:
    """e or −e, where a vector is that; None where it is neither."""
    for name, unit in units.items():
        for sign in (1, -1):
            if all(is_zero(c) is True for c in (vector.fixed() - unit * sp.Integer(sign)).components):
                return sign * VectorSymbol(name)
    return None


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
    """c n + w in place of a vector, or a sum of two such."""
    if not isinstance(side, Vector) or sum(c != 0 for c in side.components) < 2 or _length(side) > LONGEST:
        return side
    units = {n: u for n, u in units.items() if n not in side.triad.names}
    if not units:
        return side
    left, terms = side.fixed(), sp.S.Zero
    for _ in range(2):
        along = [(factor, name, rest) for name, unit in units.items() for factor, rest in _splits(left, unit)]
        factor, name, rest = min(along, key=lambda split: count_operations(split[0]) + _length(split[2]))
        if factor != 0:
            left, terms = rest, terms + factor * VectorSymbol(name)
    beside = [c for c in left.components if c != 0]
    if len(beside) > 1 and any(c.has(sp.sin, sp.cos) for c in beside):
        return side  # in two kinds of directions that turn it would be no clearer
    return terms + left.as_sum() if terms != 0 and count_operations(terms) + _length(left) < _length(side) else side


def _length(vector: Vector) -> int:
    return sum(count_operations(c) + (c != 0) for c in vector.components)


def _splits(vector: Vector, unit: Vector) -> Iterator[tuple[sp.Expr, Vector]]:
    """Pairs c, w of a vector c n + w, where w lacks a component: c = v_k/n_k; and none, c = 0."""
    yield sp.S.Zero, vector
    pairs = [(v, n) for v, n in zip(vector.components, unit.components, strict=True) if v != 0 and n != 0]
    factors = [*(sp.cancel(v / n) for v, n in pairs), *(_share(v, n) for v, n in pairs)]
    for factor in dict.fromkeys([*factors, textbook_form(vector.dot(unit))]):
        if not all(s.is_positive for s in sp.fraction(sp.together(factor))[1].free_symbols):
            continue
        rest = (vector - unit * factor).map(lambda c: sp.S.Zero if is_zero(c) is True else textbook_form(c))
        yield factor, rest


def _share(whole: sp.Expr, part: sp.Expr) -> sp.Expr:
    """The coefficient of sin θ in x − b sin θ, over the sign that sin θ has in the unit vector."""
    sign, core = part.as_coeff_Mul()
    return sp.expand(whole).coeff(core) / sign
