"""Random states at which terms of answers are reduced modulo the derived equations.

At a state each term is a row [A | b], affine in the unknowns (accelerations, multipliers). Its residue r is the row
reduced modulo the row space of the derived equations and of the constraints, differentiated until accelerations occur.
Residues are linear, and an equation follows if and only if those of its terms add up to zero.

States are kept from one answer to the next, with everything evaluated there: an equation that is wrong at a random
state is wrong, whatever was compared before it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import RowSpace
from lagrange.algebra.exact.zero_test import DivisionByZeroError, InadmissibleError, Point
from lagrange.answers.limits import BRANCHING_STATES, REAL_STATES, STATES
from lagrange.core.records import record
from lagrange.mechanics.dynamics.comparison import System, affine_rows, symbols_of
from lagrange.mechanics.dynamics.comparison import random_state as state_of_motion


@record
class ResidueState:
    """A random state at which each term of an answer is reduced modulo the derived equations.

    point     the state, with velocities that satisfy the constraints
    unknowns  the multipliers and accelerations
    derived   the row space of the derived equations
    """

    point: Point
    unknowns: tuple[sp.Symbol, ...]
    derived: RowSpace

    def residue(self, term: sp.Expr) -> list[Any] | None:
        """A term modulo the derived equations; None if it is not affine in the unknowns."""
        try:
            # Most of the many terms tried have no unknowns, and `affine` would evaluate them at two more points.
            if term.free_symbols.isdisjoint(self.unknowns):
                return self.derived.residue([*self.no_unknowns, self.point.value(term)])
            rows = self.point.affine([term], self.unknowns)
        except (InadmissibleError, DivisionByZeroError):
            return None
        return None if rows is None else self.derived.residue(rows[0])

    def residue_kept(self, term: sp.Expr) -> list[Any] | None:
        """The same for a term of a derived equation, with which one answer after the other is compared."""
        if term not in self._residues:
            self._residues[term] = self.residue(term)
        return self._residues[term]

    @cached_property
    def _residues(self) -> dict[sp.Expr, list[Any] | None]:
        return {}

    @cached_property
    def no_unknowns(self) -> list[Any]:
        """The coefficients of a term without unknowns."""
        return [self.point.number(0)] * len(self.unknowns)

    def vanishes(self, row: Iterable[Any]) -> bool:
        """Whether a row is zero."""
        return all(self.point.arithmetic.vanishes(x) for x in row)

    def ratio(self, a: Sequence[Any], b: Sequence[Any]) -> Any | None:
        """a / b if a is a multiple of b; None if it is not, or b is zero."""
        arithmetic = self.point.arithmetic
        n = next((n for n, x in enumerate(b) if not arithmetic.vanishes(x)), None)
        if n is None:
            return None
        c = arithmetic.reduce(a[n] * arithmetic.inverse(b[n]))
        same = self.vanishes(arithmetic.reduce(x - c * y) for x, y in zip(a, b, strict=True))
        return c if same else None

    def value(self, factor: sp.Expr) -> Any | None:
        """The value of a factor without unknowns; None if it has none at this state."""
        try:
            return self.point.value(factor)
        except (InadmissibleError, DivisionByZeroError):
            return None

    def values_of(self, factors: tuple[sp.Expr, ...]) -> tuple[list[Any | None], dict[Any, list[int]]]:
        """The value of each factor, None if it has none or vanishes; and the factors that are no numbers by value.

        They are kept: the factors that are tried in one equation after the other are the same.
        """
        kept = self._factors.get(factors)
        if kept is None:
            vanishes = self.point.arithmetic.vanishes
            values = [None if (v := self.value(f)) is None or vanishes(v) else v for f in factors]
            by_value: dict[Any, list[int]] = {}
            for n, (factor, value) in enumerate(zip(factors, values, strict=True)):
                if value is not None and not factor.is_number:
                    by_value.setdefault(value, []).append(n)
            kept = self._factors[factors] = values, by_value
        return kept

    @cached_property
    def _factors(self) -> dict[tuple[sp.Expr, ...], tuple[list[Any | None], dict[Any, list[int]]]]:
        return {}


class Residues:
    """The states of one system, and values at them that one search after the other asks for."""

    def __init__(self, system: System) -> None:
        self.system = system
        self._states: dict[bool, list[ResidueState]] = {}

    def states(self, equations: Sequence[sp.Expr]) -> list[ResidueState]:
        """Independent random states at which the equations and the system are defined.

        Raises NoPointError, UnsupportedError, DivisionByZeroError.
        """
        surface = self.system.configuration.states
        every = (*equations, *equations_of(self.system))
        # Where expressions depend on signs, which a prime field picks at random, more states are needed.
        branches = any(surface.graph.marks[surface.graph.node(e)] for e in every)
        known = self._states.get(branches)
        if known is None or not _defined(equations, known):
            known = self._states[branches] = self._drawn(equations, branches)
        return known

    def _drawn(self, equations: Sequence[sp.Expr], branches: bool) -> list[ResidueState]:
        configuration = self.system.configuration
        derived = equations_of(self.system)
        symbols = symbols_of((*equations, *derived))
        unknowns = (*self.system.multipliers, *configuration.slots.accelerations)

        def at(point: Point) -> ResidueState:
            moving = state_of_motion(point, configuration, symbols)
            return ResidueState(moving, unknowns, RowSpace(moving.arithmetic, affine_rows(moving, derived, unknowns)))

        if not branches:
            return configuration.states.sampled(at, STATES)
        own = configuration.states
        return [*own.sampled(at, BRANCHING_STATES), *own.sampled(at, REAL_STATES, real=True)]


def _defined(equations: Sequence[sp.Expr], states: Sequence[ResidueState]) -> bool:
    """Whether all equations have values at these states."""
    return all(state.value(e) is not None for state in states for e in equations)


def equations_of(system: System) -> tuple[sp.Expr, ...]:
    """The constraints, differentiated until accelerations occur, and the equations of a system."""
    return (*system.accelerated_constraints, *system.equations)


def follows(equation: sp.Expr, at: Sequence[ResidueState]) -> bool:
    """Whether an equation follows from the system at all of these states."""
    return all((r := state.residue(equation)) is not None and state.vanishes(r) for state in at)
