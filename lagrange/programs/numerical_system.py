"""A motion in numbers: dy/dt, the constraints, and any other function of the state.

    M s' − Aᵀ λ = f ,     A s' = b

is eliminated in symbols where there are few speeds and no multipliers, and solved by NumPy at each call otherwise.
States are brought back to the constraints by the shortest change, positions first:

    δq = −Gᵀ (G Gᵀ)⁻¹ g   until g(q, t) = 0 ,     δs = −Aᵀ (A Aᵀ)⁻¹ φ   until φ = A s + a_t = 0 .

Dry friction depends on signs, of the slip and of reactions. While the motion is integrated each of them is a constant,
+1 or −1, and a step ends where its argument vanishes: f is smooth within a step.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from itertools import chain
from typing import Any

import sympy as sp

from lagrange.core.expression_size import distinct_parts
from lagrange.core.symbols import partial, t
from lagrange.programs.compiled import Compiled, compiled
from lagrange.programs.integrator import RateFunction, State
from lagrange.programs.limits import MOST_PROJECTIONS, NEGLIGIBLE, ROUNDING
from lagrange.programs.state_equations import StateEquations
from lagrange.programs.straight_line import can_be_eliminated, solved_in_line

FloatValues = Mapping[sp.Symbol, float]


class NumericalSystem:
    """The equations of a motion with numbers for their parameters.

    values   a number for each parameter
    signs    the sign of each expression on which dry friction depends
    """

    def __init__(self, states: StateEquations, values: FloatValues, signs: Mapping[sp.Expr, int] | None = None) -> None:
        self.states, self.values = states, values
        self.signs = dict.fromkeys(indicators(states), 1) if signs is None else dict(signs)
        self._rule: dict[sp.Basic, sp.Basic] = {sp.sign(e): sp.Integer(s) for e, s in self.signs.items()}
        self._rule |= {s: sp.Integer(self.signs[e]) for s, e in states.signs.items() if e in self.signs}

    @property
    def slips(self) -> tuple[sp.Expr, ...]:
        """The signed expressions that are not reactions: slip speeds."""
        return tuple(e for e in self.signs if e not in self.states.signs.values())

    def with_signs(self, signs: Mapping[sp.Expr, int]) -> NumericalSystem:
        """The same motion with other signs."""
        return self if signs == self.signs else NumericalSystem(self.states, self.values, signs)

    def _compiled(self, expressions: Sequence[sp.Expr], **more: Any) -> Compiled:
        return compiled(self.states.state, [self._signed(e) for e in expressions], self.values, **more)

    def _signed(self, e: sp.Expr) -> sp.Expr:
        return e.xreplace(self._rule) if self._rule else e

    @cached_property
    def rate(self) -> RateFunction:
        """dy/dt, called with t and the components of y. Raises ArithmeticError if it does not exist."""
        e = self.states.equations
        rates, right = [*map(self._signed, e.rates)], [*map(self._signed, e.right)]
        matrix = [[*map(self._signed, row)] for row in e.matrix]
        if can_be_eliminated(len(right), len(e.multipliers)):
            made: RateFunction = compiled(e.state, solved_in_line(rates, matrix, right), self.values)
            return made
        solved, speeds, n = self.solved, len(e.speeds), len(e.rates)
        first = compiled(e.state, rates, self.values) if tuple(rates) != e.slots.velocities else None

        def rate(time: float, *y: float) -> list[float]:
            accelerations = solved(time, *y)[:speeds]
            return [*(y[n:] if first is None else first(time, *y)), *accelerations]

        return rate

    @cached_property
    def solved(self) -> RateFunction:
        """s', then λ."""
        import numpy

        e = self.states.equations
        size, speeds = len(e.unknowns), len(e.speeds)
        run = self._compiled([*chain.from_iterable(e.matrix), *e.right])

        def solved(time: float, *y: float) -> list[float]:
            numbers = run(time, *y)
            matrix = numpy.array(numbers[: size * size]).reshape(size, size)
            right = numpy.array(numbers[size * size :])
            try:
                x: list[float] = numpy.linalg.solve(matrix, right).tolist()
            except numpy.linalg.LinAlgError:
                x = _shortest(matrix, right, speeds)
            return x

        return solved

    @cached_property
    def matrix(self) -> RateFunction:
        """The rows of the linear equations for s' and λ, one after another."""
        made: RateFunction = self._compiled([*chain.from_iterable(self.states.equations.matrix)])
        return made

    def function_of(self, expressions: Sequence[sp.Expr]) -> Callable[..., list[float]]:
        """Several expressions of the state alone."""
        made: Callable[..., list[float]] = self._compiled(expressions)
        return made

    def function(self, expression: sp.Expr) -> Callable[..., float]:
        """An expression of state, rates of speeds and multipliers as a function of t and the components of y."""
        e = self.states.equations
        unknown = [s for s in e.unknowns if s in expression.free_symbols]
        if not unknown:
            run = self._compiled([expression])
            return lambda time, *y: float(run(time, *y)[0])
        places = [e.unknowns.index(s) for s in unknown]
        written = self._signed(expression)
        with_unknowns = compiled((*e.state, *unknown), [written], self.values)
        solved = self.solved

        def value(time: float, *y: float) -> float:
            x = solved(time, *y)
            return float(with_unknowns(time, *y, *(x[k] for k in places))[0])

        return value

    def along(self, expression: sp.Expr, times: Any, states: Any) -> Any:
        """The values of an expression along a motion: an array for arrays of times (N,) and states (n + p, N)."""
        import numpy

        if not self.signs and expression.free_symbols.isdisjoint(self.states.equations.unknowns):
            with numpy.errstate(all="ignore"):
                rows = self._compiled([expression], arrays=True)(times, *states)[0]
            return numpy.broadcast_to(numpy.asarray(rows, dtype=float), numpy.shape(times)).copy()
        values: dict[tuple[int, ...], Callable[..., float]] = {}
        rows = []
        for time, y in zip(times.tolist(), states.T.tolist(), strict=True):
            signs = self._signs_at(time, y)
            if signs not in values:
                there = self.with_signs(dict(zip(self.signs, signs, strict=True)))
                values[signs] = there.function(expression)
            rows.append(value_or_nan(values[signs], time, y))
        return numpy.array(rows)

    def _signs_at(self, time: float, state: Sequence[float]) -> tuple[int, ...]:
        """The signs that a state has; where an expression is zero, the present one."""
        at = (value_or_nan(indicator, time, state) for indicator in self._indicators)
        return tuple(1 if x > 0 else -1 if x < 0 else s for x, s in zip(at, self.signs.values(), strict=True))

    @cached_property
    def _indicators(self) -> list[Callable[..., float]]:
        return [self.function(e) for e in self.signs]

    # -- constraints ---------------------------------------------------------------------------------------------------

    @cached_property
    def violation(self) -> Callable[..., list[float]]:
        """All that vanishes along the motion, as a function of t and the components of y."""
        return self._compiled(self.states.equations.kept)

    def projected(self, time: float, state: State) -> State | None:
        """The state on the constraints next to a state; None if it is there already. Raises ArithmeticError."""
        e = self.states.equations
        if not e.kept:
            return None
        errors = self.violation(time, *state)
        n, size = len(e.slots.coordinates), [abs(y) for y in state]
        limit = NEGLIGIBLE * (1 + max(size, default=0.0))
        if max(map(abs, errors)) < limit:
            return None
        state = self._shifted(time, state, self._positions, range(n), limit)
        if e.velocity_forms:
            state = self._shifted(time, state, self._speeds, range(n, len(state)), limit)
        return state

    @cached_property
    def _positions(self) -> tuple[Compiled, Compiled, int]:
        e = self.states.equations
        return self._compiled(e.finite), self._compiled([*chain.from_iterable(e.finite_slopes)]), len(e.finite)

    @cached_property
    def _speeds(self) -> tuple[Compiled, Compiled, int]:
        e = self.states.equations
        slopes = [*chain.from_iterable(e.constraint_matrix)]
        return self._compiled(e.velocity_forms), self._compiled(slopes), len(e.velocity_forms)

    def _shifted(
        self, time: float, state: State, forms: tuple[Compiled, Compiled, int], moving: range, limit: float
    ) -> State:
        import numpy

        values, slopes, count = forms
        if not count:
            return state
        y = list(state)
        for _ in range(MOST_PROJECTIONS):
            errors = numpy.array(values(time, *y))
            if float(abs(errors).max()) < limit:
                break
            matrix = numpy.array(slopes(time, *y)).reshape(count, len(moving))
            change = numpy.linalg.lstsq(matrix, errors, rcond=None)[0]
            for k, c in zip(moving, change.tolist(), strict=True):
                y[k] -= c
            if float(abs(change).max()) <= ROUNDING * (1 + max(map(abs, y))):
                break
        else:
            raise ArithmeticError("the constraints cannot be met")
        return tuple(y)


def _shortest(matrix: Any, right: Any, speeds: int) -> list[float]:
    """The shortest solution where constraints depend on each other in this position: multipliers are then not unique.

    Raises ZeroDivisionError if there is none, or the accelerations are not unique either.
    """
    import numpy

    left, sizes, directions = numpy.linalg.svd(matrix)
    regular = sizes > 1e-12 * sizes[0]
    free = directions[~regular, :speeds]
    x = directions[regular].T @ ((left.T @ right)[regular] / sizes[regular])
    if abs(free).max(initial=0.0) > 1e-9 or abs(matrix @ x - right).max() > 1e-9 * (1 + abs(right).max()):
        raise ZeroDivisionError
    shortest: list[float] = x.tolist()
    return shortest


def value_or_nan(value: Callable[..., float], time: float, state: Sequence[float]) -> float:
    """A function of the state; NaN where it has no value."""
    try:
        return value(time, *state)
    except (ArithmeticError, ValueError):
        return math.nan


def indicators(states: StateEquations) -> tuple[sp.Expr, ...]:
    """The expressions of the state on whose signs the equations depend."""
    moving = {t, *states.state}
    more = (*states.reactions.values(), *(c.value for c in states.contacts))
    signs = (s for s in distinct_parts((*states.expressions, *more)) if isinstance(s, sp.sign))
    arguments = {s.args[0]: None for s in sorted(signs, key=str) if not s.free_symbols.isdisjoint(moving)}
    return (*arguments, *states.signs.values())


def solved_near(
    residuals: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    guess: Sequence[float],
    values: FloatValues,
) -> tuple[list[float], float]:
    """Values near a guess for which residuals vanish, by the shortest steps of Gauss and Newton, and the error left."""
    x = [float(g) for g in guess]
    if not residuals:
        return x, 0.0
    import numpy

    f = compiled(unknowns, list(residuals), values)
    slopes = compiled(unknowns, [partial(e, s) for e in residuals for s in unknowns], values)
    error = math.inf
    for _ in range(MOST_PROJECTIONS):
        try:
            errors = numpy.array(f(0.0, *x), dtype=float)
            error = float(abs(errors).max())
            if error < NEGLIGIBLE:
                break
            matrix = numpy.array(slopes(0.0, *x), dtype=float).reshape(len(residuals), len(unknowns))
            step = numpy.linalg.lstsq(matrix, errors, rcond=1e-10)[0].tolist()
        except (ArithmeticError, ValueError, numpy.linalg.LinAlgError):
            return x, math.inf
        x = [a - b for a, b in zip(x, step, strict=True)]
        if max(map(abs, step)) <= ROUNDING * (1 + max(map(abs, x))):
            break
    return x, error
