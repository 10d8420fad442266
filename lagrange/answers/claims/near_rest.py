"""States of rest and of steady motion in numbers, and the small motions about them.

From the equations of motion E(q, q', q'') = 0 in independent coordinates. At rest, and where cyclic coordinates have
constant rates, all accelerations vanish; near such a state

    M ξ'' + D ξ' + K ξ = 0 ,      M = ∂E/∂q'',  D = ∂E/∂q',  K = ∂E/∂q ,

so that K may have the centrifugal terms of a frame that turns. A prescribed force or motion is constant there. In
statics the conditions of equilibrium take the place of E, and the second variation of the potential energy that of K.
"""

from __future__ import annotations

import random
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cached_property

import mpmath
import sympy as sp

from lagrange.answers.limits import (
    GROWING,
    LASTING,
    LONGEST_LINEARIZED,
    MOST_LINEARIZED,
    STARTS_TO_REST,
)
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, symbols_in, t
from lagrange.mechanics.equilibrium.searched.newton import NoTapeError, Tape, zero_near
from lagrange.mechanics.results import InCoordinates, Solution

Values = Mapping[sp.Symbol, float]


@record
class NearRest:
    """The equations of a system near states of rest.

    balance    E for constant rates and no accelerations; each is zero
    matrices   M, D and K, row by row; D and M are empty in statics
    unknown    coordinates that occur, and what is prescribed
    cyclic     coordinates that do not occur
    """

    view: InCoordinates
    balance: tuple[sp.Expr, ...]
    matrices: tuple[sp.Matrix, ...]
    unknown: tuple[sp.Symbol, ...]
    cyclic: tuple[sp.Symbol, ...]
    statics: bool = False

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """All independent coordinates."""
        return self.view.configuration.slots.coordinates

    @cached_property
    def angles(self) -> frozenset[sp.Symbol]:
        """The coordinates and parameters in sines and cosines alone."""
        every = [f for e in self.balance for f in e.atoms(sp.sin, sp.cos, sp.tan)]
        return frozenset(s for f in every for s in f.args[0].free_symbols)

    def states(self, values: Values, conditions: Sequence[sp.Expr]) -> Iterator[dict[sp.Symbol, float]]:
        """The different states of rest at values of the parameters, in which conditions vanish."""
        known = {s: v for s, v in values.items() if s not in self.unknown}
        rates = {prime(q): known.get(prime(q), 0.0) for q in self.coordinates}
        given = {**dict.fromkeys(self.cyclic, 0.0), **rates, **known}
        symbols = [*self.unknown, *given]
        try:
            tape = Tape([*self.balance, *conditions], symbols)
        except NoTapeError:
            return
        if {s for e in (*self.balance, *conditions) for s in symbols_in(e)} - {*symbols}:
            return
        draw = random.Random(1)
        found: list[dict[sp.Symbol, float]] = []
        for n in range(STARTS_TO_REST):
            start = [self._start(s, draw, n) for s in self.unknown]
            at = zero_near(lambda x: tape.values([*x, *given.values()]), start, 1e3) if self.unknown else []
            if at is None:
                continue
            state = {**given, **dict(zip(self.unknown, at, strict=True))}
            if not any(self._same(state, other) for other in found):
                found.append(state)
                yield state

    def _start(self, s: sp.Symbol, draw: random.Random, n: int) -> float:
        if s in self.angles:
            return (0.1, 3.0)[n] if n < 2 else draw.uniform(-3.1, 3.1)
        return draw.lognormvariate(0, 1) * (1 if n % 2 else -1 if n % 4 else 1)

    def _same(self, a: Values, b: Values) -> bool:
        for s in self.unknown:
            difference = abs(a[s] - b[s])
            if s in self.angles:
                difference = abs((difference + float(sp.pi)) % (2 * float(sp.pi)) - float(sp.pi))
            if difference > 1e-5 * (1 + abs(a[s])):
                return False
        return True

    def exponents(self, state: Values) -> list[complex] | None:
        """The p of the motions exp(p t) about a state; None if they cannot be found."""
        numbers = self._numbers(state)
        if numbers is None or self.statics:
            return None
        mass, damping, stiffness = numbers
        size = mass.rows
        try:
            inverse = mass**-1
            whole = mpmath.zeros(2 * size)
            whole[:size, size:] = mpmath.eye(size)
            whole[size:, :size] = -inverse * stiffness
            whole[size:, size:] = -inverse * damping
            return [complex(p) for p in mpmath.eig(whole, right=False)]
        except (ZeroDivisionError, ValueError, mpmath.NoConvergence):
            return None

    def undamped(self) -> NearRest:
        """The same with the antisymmetric part of D alone."""
        mass, damping, stiffness = self.matrices
        return NearRest(
            self.view, self.balance, (mass, (damping - damping.T) / 2, stiffness), self.unknown, self.cyclic
        )

    def is_stable(self, state: Values) -> bool | None:
        """Whether no small motion about a state grows; None if that is not clear."""
        if self.statics:
            numbers = self._numbers(state)
            if numbers is None:
                return None
            [stiffness] = numbers
            minors = [mpmath.det(stiffness[:n, :n]) for n in range(1, stiffness.rows + 1)]
            return None if any(abs(m) < LASTING for m in minors) else all(m > 0 for m in minors)
        exponents = self.exponents(state)
        largest = max(map(abs, exponents or [0]))
        if not exponents or largest == 0:
            return None
        growth = max(p.real for p in exponents)
        if growth > GROWING * largest:
            return False
        zeros = sum(abs(p) < GROWING * largest for p in exponents)
        return True if growth < LASTING * max(largest, 1) * 10 and zeros <= 2 * len(self.cyclic) else None

    def _numbers(self, state: Values) -> list[mpmath.matrix] | None:
        tape = self._tape
        if tape is None:
            return None
        symbols, of = tape
        try:
            entries = of.values([state.get(s, 0.0) for s in symbols])
        except (ValueError, ArithmeticError):
            return None
        size = self.matrices[0].rows
        blocks = [entries[n : n + size * size] for n in range(0, len(entries), size * size)]
        return [mpmath.matrix([b[i * size : (i + 1) * size] for i in range(size)]) for b in blocks]

    @cached_property
    def _tape(self) -> tuple[list[sp.Symbol], Tape] | None:
        entries = [e for m in self.matrices for e in m]
        symbols = sorted({s for e in entries for s in e.free_symbols}, key=str)
        try:
            return symbols, Tape(entries, symbols)
        except NoTapeError:
            return None


def near_rest(solution: Solution, used: Collection[sp.Symbol] = ()) -> NearRest | None:
    """The equations near rest in the coordinates in which some symbols can be written; None if there are none."""
    for view in solution.views_by_page:
        moving = {*solution.problem.slots.coordinates} & {base(s) for s in used}
        known = {*view.configuration.slots.coordinates, *view.configuration.expressed}
        if view.configuration.rows or not moving <= known:
            continue
        made = _of_motion(view) if view.motion is not None else _of_statics(view)
        if made is not None:
            return made
    return None


def _of_motion(view: InCoordinates) -> NearRest | None:
    assert view.motion is not None
    slots = view.configuration.slots
    q = slots.coordinates
    equations = view.motion.expressions
    size = sum(count_operations(e) for e in equations)
    if len(equations) != len(q) or len(q) > MOST_LINEARIZED or size > LONGEST_LINEARIZED:
        return None
    symbols = {s for e in equations for s in symbols_in(e)}
    if t in symbols:
        return None
    resting = {s: sp.S.Zero for s in symbols if base(s) in slots.prescribed and base(s) != s}
    equations = tuple(e.xreplace(resting) for e in equations)
    still = dict.fromkeys(slots.accelerations, sp.S.Zero)
    cyclic = tuple(s for s in q if not any(s in e.free_symbols for e in equations))
    still |= {prime(s): sp.S.Zero for s in q if s not in cyclic}
    balance = tuple(e.xreplace(still) for e in equations)
    balance = tuple(e for e in balance if e != 0)
    matrices = (
        sp.Matrix([[e.diff(s).xreplace(still) for s in column] for e in equations])
        for column in (slots.accelerations, slots.velocities, q)
    )
    driven = [s for s in slots.prescribed if any(s in e.free_symbols for e in equations)]
    unknown = (*(s for s in q if s not in cyclic), *driven)
    return NearRest(view, balance, tuple(matrices), unknown, cyclic)


def _of_statics(view: InCoordinates) -> NearRest | None:
    if view.equilibrium is None or view.stability is None:
        return None
    conditions = tuple(c.expression for c in view.equilibrium.conditions)
    q = view.configuration.slots.coordinates
    return NearRest(view, conditions, (sp.Matrix(view.stability.matrix),), q, (), statics=True)
