"""Points of a family of solutions at which an equation has no value, although it holds everywhere around them.

    x cos θ + y sin θ = 0     as     y = −x cos θ/sin θ

The second loses x = 0, θ = 0, where y is arbitrary: dividing by sin θ is not allowed there. A term p/q without common
factors is a point [p : q] of the projective line, and has no meaning where p and q both vanish. Where only q does, it
is infinite: tan θ = h/x holds at θ = π/2, x = 0, where both sides are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.limits import LONGEST_DENOMINATOR
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import SolutionSet
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.core.expression_size import count_operations


def quotients(e: sp.Expr, unknowns: Sequence[sp.Symbol]) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The terms of an expression that have an unknown in their denominator, as numerators and denominators."""
    for term in sp.Add.make_args(e):
        in_sines = term.replace(sp.tan, lambda a: sp.sin(a) / sp.cos(a))
        in_sines = in_sines.replace(sp.cot, lambda a: sp.cos(a) / sp.sin(a))
        above, below = sp.fraction(sp.together(in_sines))
        moving = [f for f in sp.Mul.make_args(below) if f.free_symbols & {*unknowns}]
        if moving and count_operations(below) <= LONGEST_DENOMINATOR:
            yield above, sp.Mul(*moving)


def undefined_points(
    equation: sp.Expr, point: Values, solution: SolutionSet, unknowns: Sequence[sp.Symbol]
) -> Iterator[Values]:
    """The part of a family of solutions at which an equation has no value.

    point  of `solution`; it leaves some of the unknowns open
    """
    for terms in quotients(equation, unknowns):
        try:
            parts = [solution.at(point, part) for part in terms]
        except (NotAlgebraicError, DivisionByZeroError):
            continue
        left = [u for u in unknowns if any(u in part.free_symbols for part in parts)]
        if not left or any(part.has(sp.nan, sp.zoo) for part in parts):
            continue
        within = solutions(parts, left)
        if not within.solved or not within.verified:
            continue
        for branch in within.branches:
            if not branch.special:
                narrowed = (_narrowed(point, solution, p, within, left) for p in branch.points)
                yield from (p for p in narrowed if p is not None)


def _narrowed(
    point: Values, solution: SolutionSet, at: Values, within: SolutionSet, left: Sequence[sp.Symbol]
) -> Values | None:
    """A point of a family with values of the unknowns that it left open; None if the two measure angles differently."""
    own, other = solution.letters.angles, within.letters.angles
    given: dict[sp.Symbol, sp.Expr] = {}
    for u in left:
        if u in other:
            if u not in own or own[u].measure != other[u].measure:
                return None
            if other[u].cosine in at:
                given |= dict(zip(own[u].letters, (within.at(at, f) for f in _circle(own[u].measure)), strict=True))
        elif u in at:
            given[u] = within.at(at, u)
    try:
        kept = {k: solution.letters.read(within.at(at, solution.letters.write(v))) for k, v in point.items()}
    except (NotAlgebraicError, DivisionByZeroError):
        return None
    return {**kept, **given}


def _circle(angle: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    return sp.cos(angle), sp.sin(angle)
