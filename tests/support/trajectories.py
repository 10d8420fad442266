"""Motions integrated by the classical Runge-Kutta method, in floats, from equations of the second route alone."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from tests.support.second_route import Route, once, slots

State = dict[str, float]


def function_of(expression: sp.Expr) -> Callable[[Mapping[str, Any]], float]:
    """The expression as a function of the values of its symbols."""
    values = functions_of([expression])
    return lambda state: float(values(state)[0])


def functions_of(expressions: Sequence[sp.Expr]) -> Callable[[Mapping[str, Any]], list[Any]]:
    """Several expressions as one function of the values of their symbols; what occurs in several is computed once."""
    symbols = sorted({s for e in expressions for s in e.free_symbols}, key=lambda s: s.name)
    stand_ins = [sp.Symbol(f"v{n}") for n in range(len(symbols))]
    names = [s.name for s in symbols]
    renamed = [e.xreplace(dict(zip(symbols, stand_ins, strict=True))) for e in expressions]
    compiled = sp.lambdify(stand_ins, renamed, "math", cse=once)
    return lambda state: compiled(*(state[n] for n in names))


class Motion:
    """The accelerations and multipliers that a route gives, and the trajectories that follow.

    given  values of prescribed motions u, u', u'' at the start; u is a polynomial in time
    """

    def __init__(self, route: Route, prescribed: Sequence[str] = ()) -> None:
        self.route = route
        self.prescribed = tuple(prescribed)
        self.equations = functions_of([slots(sp.sympify(e)) for e in route.system])

    def unknowns(self, state: State) -> State:
        """Accelerations and multipliers, as far as they are determined."""
        names = self.route.unknowns
        # They occur linearly: 0 in all of them gives b, and 1 in one of them a column of A more.
        tried = dict(zip(names, np.eye(len(names) + 1)[1:], strict=True))
        values = np.array([np.broadcast_to(v, len(names) + 1) for v in self.equations({**state, **tried})])
        rows = np.column_stack([values[:, 1:] - values[:, :1], values[:, :1]]).tolist()
        return _solved(rows, names)

    def trajectory(self, start: State, step: float, steps: int) -> Iterator[State]:
        """The states at the ends of the steps, the start first, with accelerations and multipliers."""
        state = {**start, **self.unknowns(dict(start))}
        yield state
        for _ in range(steps):
            state = self._stepped(state, step)
            state |= self.unknowns(state)
            yield state

    def _stepped(self, state: State, h: float) -> State:
        """The state after a step, from one with its accelerations."""
        k1 = self._rates(state)
        k2 = self._rates_at(self._moved(state, k1, h / 2))
        k3 = self._rates_at(self._moved(state, k2, h / 2))
        k4 = self._rates_at(self._moved(state, k3, h))
        total = {n: (k1[n] + 2 * k2[n] + 2 * k3[n] + k4[n]) / 6 for n in k1}
        return self._moved(state, total, h)

    def _rates_at(self, state: State) -> State:
        return self._rates({**state, **self.unknowns(state)})

    def _rates(self, state: State) -> State:
        rates = {"t": 1.0}
        for q in self.route.coordinates:
            rates |= {q: state[f"{q}'"], f"{q}'": state[f"{q}''"]}
        return rates

    def _moved(self, state: State, rates: State, h: float) -> State:
        moved = {n: state.get(n, 0.0) + h * r for n, r in rates.items()}
        for u in self.prescribed:
            a, b, c = (state.get(u + "'" * k, 0.0) for k in range(3))
            moved |= {u: a + b * h + c * h * h / 2, f"{u}'": b + c * h}
        return {**state, **moved}


def _solved(rows: list[list[float]], names: Sequence[str]) -> State:
    """What rows [A | b], A x + b = 0, determine, by elimination with complete pivoting."""
    work = [[x / size for x in row] for row in rows if (size := max(map(abs, row))) > 0]
    columns, pivots = set(range(len(names))), []
    left = list(range(len(work)))
    while left and columns:
        size, r, c = max((abs(work[r][c]), r, c) for r in left for c in columns)
        if size < 1e-9:
            break
        work[r] = [x / work[r][c] for x in work[r]]
        for n, row in enumerate(work):
            if n != r and row[c]:
                work[n] = [a - row[c] * b for a, b in zip(row, work[r], strict=True)]
        left.remove(r)
        columns.remove(c)
        pivots.append((r, c))
    assert all(math.isclose(work[r][-1], 0, abs_tol=1e-6) for r in left), "inconsistent"
    return {names[c]: -work[r][-1] for r, c in pivots if all(abs(work[r][f]) < 1e-9 for f in columns)}
