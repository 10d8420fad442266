"""A bench: one random state at which terms of an equation are laid out and weighed against the derived equations.

A term, affine in the unknowns u, is a row [A | b] there. Its residue is what is left of the row modulo the row space of
the derived equations: an equation Σ t_i follows just when the residues of its terms add up to zero. Residues are
linear, so that the sum for a changed equation costs next to nothing. Two benches share no random number.

Roots and absolute values are on either branch in a prime field, at random: what fits at two states may fit on one
branch only. Where there are branches more states are taken, real ones among them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, InadmissibleError, Point, Surface
from lagrange.algebra.exact.linear_algebra import RowSpace
from lagrange.core.records import record
from lagrange.mechanics.dynamics.comparison import System, affine_rows, state, symbols_of

_STATES = 2
_BRANCHING_STATES = 12
_REAL_STATES = 4


@record
class Bench:
    """One state.

    moving    the point, with velocities that satisfy the constraints
    unknowns  the multipliers and accelerations
    derived   the rows of the derived equations there
    """

    moving: Point
    unknowns: tuple[sp.Symbol, ...]
    derived: RowSpace

    def residue(self, term: sp.Expr) -> list[Any] | None:
        """What is left of a term modulo the derived equations; None where it is not affine in the unknowns."""
        try:
            if term.free_symbols.isdisjoint(self.unknowns):
                return self.derived.residue([*self.no_unknowns, self.moving.value(term)])
            rows = self.moving.affine([term], self.unknowns)
        except (InadmissibleError, DivisionByZeroError):
            return None
        return None if rows is None else self.derived.residue(rows[0])

    @cached_property
    def no_unknowns(self) -> list[Any]:
        """The coefficients of a term without unknowns."""
        return [self.moving.number(0)] * len(self.unknowns)

    def vanishes(self, row: Iterable[Any]) -> bool:
        """Whether a row is zero."""
        return all(self.moving.arithmetic.vanishes(x) for x in row)

    def ratio(self, a: Sequence[Any], b: Sequence[Any]) -> Any | None:
        """a / b, where a is a multiple of b; None where it is not, or b is zero."""
        arithmetic = self.moving.arithmetic
        n = next((n for n, x in enumerate(b) if not arithmetic.vanishes(x)), None)
        if n is None:
            return None
        c = arithmetic.reduce(a[n] * arithmetic.inverse(b[n]))
        same = self.vanishes(arithmetic.reduce(x - c * y) for x, y in zip(a, b, strict=True))
        return c if same else None

    def value(self, factor: sp.Expr) -> Any | None:
        """The value of what has no unknowns; None where it has none."""
        try:
            return self.moving.value(factor)
        except (InadmissibleError, DivisionByZeroError):
            return None


def benches(equations: Sequence[sp.Expr], system: System) -> list[Bench]:
    """Several states at which the equations and the system have values.

    Raises NoPointError, UnsupportedError, DivisionByZeroError.
    """
    configuration = system.configuration
    derived = equations_of(system)
    symbols = symbols_of((*equations, *derived))
    unknowns = (*system.multipliers, *configuration.slots.accelerations)

    def at(point: Point) -> Bench:
        moving = state(point, configuration, symbols)
        return Bench(moving, unknowns, RowSpace(moving.arithmetic, affine_rows(moving, derived, unknowns)))

    states = configuration.states
    if not _branches((*equations, *derived), states):
        return states.sampled(at, _STATES)
    return [*states.sampled(at, _BRANCHING_STATES), *states.sampled(at, _REAL_STATES, real=True)]


def _branches(expressions: Sequence[sp.Expr], states: Surface) -> bool:
    """Whether expressions depend on signs that a prime field picks at random."""
    return any(states.graph.marks[states.graph.node(e)] for e in expressions)


def equations_of(system: System) -> tuple[sp.Expr, ...]:
    """The constraints, differentiated until accelerations occur, and the equations of a system."""
    return (*system.accelerated_constraints, *system.equations)


def follows(equation: sp.Expr, at: Sequence[Bench]) -> bool:
    """Whether an equation follows from the system, at all states."""
    return all((r := bench.residue(equation)) is not None and bench.vanishes(r) for bench in at)
