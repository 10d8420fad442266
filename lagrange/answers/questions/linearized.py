"""Are equations those of small motions about an equilibrium?

Each must be a combination of the linear equations with constant coefficients: M ξ'' + D ξ' + K ξ = 0 at one of the
equilibria. Coordinates that are zero there may be written for the ξ. The rank of the coefficients is compared at random
values of the parameters.
"""

from __future__ import annotations

import random
from collections.abc import Sequence

import sympy as sp

from lagrange.answers.readings import GivenEquation
from lagrange.core.diagnostics import Fragment
from lagrange.core.symbols import prime
from lagrange.mechanics.results import Solution

DRAWS = 2


def are_linear_equations(judged: Sequence[Fragment], solution: Solution) -> bool:
    """Whether all equations follow from the linear equations at one equilibrium."""
    stated = [e for f in judged if isinstance(f, GivenEquation) for e in f.reading.components]
    if not stated or len(stated) < len(judged):
        return False
    for found in (v.linearization for v in solution.views):
        for branch, small in zip(found.branches, found.at, strict=True) if found is not None else ():
            if found is None or small is None:
                continue
            at_zero = [
                q
                for q in found.configuration.slots.coordinates
                if any(r.lhs == q and r.rhs == 0 for r in branch.relations)
            ]
            pairs = dict(zip(found.configuration.slots.coordinates, found.displacements, strict=True))
            rule = {d(q): d(pairs[q]) for q in at_zero for d in (_same, prime, _second)}
            symbols = [d(x) for x in found.displacements for d in (_same, prime, _second)]
            if _follow([e.xreplace(rule) for e in stated], small.equations, symbols):
                return True
    return False


def _same(q: sp.Symbol) -> sp.Symbol:
    return q


def _second(q: sp.Symbol) -> sp.Symbol:
    return prime(prime(q))


def _follow(stated: Sequence[sp.Expr], derived: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> bool:
    """Whether the stated equations are linear in the symbols and combinations of the derived ones."""
    draw = random.Random(3)
    rows = [[e.diff(s) for s in symbols] for e in (*stated, *derived)]
    if any(c.free_symbols & {*symbols} for row in rows for c in row):
        return False
    if any(
        sp.expand(e - sum(c * s for c, s in zip(row, symbols, strict=True))) != 0
        for e, row in zip((*stated, *derived), rows, strict=True)
    ):
        return False
    parameters = sorted({s for row in rows for c in row for s in c.free_symbols}, key=str)
    for _ in range(DRAWS):
        numbers = {s: sp.Integer(draw.randint(2, 97)) for s in parameters}
        matrix = sp.Matrix([[c.xreplace(numbers) for c in row] for row in rows])
        if matrix.rank() > matrix[len(stated) :, :].rank():
            return False
    return True
