"""Motions integrated by the classical Runge-Kutta method, in floats, from equations of the second route alone."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence

import sympy as sp

from tests.support.second_route import Route, slots

State = dict[str, float]


def function_of(expression: sp.Expr) -> Callable[[Mapping[str, float]], float]:
    """The expression as a function of the values of its symbols."""
    symbols = sorted(expression.free_symbols, key=lambda s: s.name)
    stand_ins = [sp.Symbol(f"v{n}") for n in range(len(symbols))]
    names = [s.name for s in symbols]
    compiled = sp.lambdify(stand_ins, expression.xreplace(dict(zip(symbols, stand_ins, strict=True))), "math")
    return lambda state: float(compiled(*(state[n] for n in names)))


class Motion:
    """The accelerations and multipliers that a route gives, and the trajectories that follow.

    given  values of prescribed motions u, u', u'' at the start; u is a polynomial in time
    """

    def __init__(self, route: Route, prescribed: Sequence[str] = ()) -> None:
        self.route = route
        self.prescribed = tuple(prescribed)
        self.equations = [function_of(slots(sp.sympify(e))) for e in route.system]

    def unknowns(self, state: State) -> State:
        """Accelerations and multipliers, as far as they are determined."""
        names = self.route.unknowns
        zero = {**state, **dict.fromkeys(names, 0.0)}
        rows = []
        for e in self.equations:
            b = e(zero)
            rows.append([*(e({**zero, n: 1.0}) - b for n in names), b])
        return _solved(rows, names)

    def trajectory(self, start: State, step: float, steps: int) -> Iterator[State]:
        """The states at the ends of the steps, the start first, with accelerations and multipliers."""
        state = dict(start)
        yield {**state, **self.unknowns(state)}
        for _ in range(steps):
            state = self._stepped(state, step)
            yield {**state, **self.unknowns(state)}

    def _stepped(self, state: State, h: float) -> State:
        k1 = self._rates(state)
        k2 = self._rates(self._moved(state, k1, h / 2))
        k3 = self._rates(self._moved(state, k2, h / 2))
        k4 = self._rates(self._moved(state, k3, h))
        total = {n: (k1[n] + 2 * k2[n] + 2 * k3[n] + k4[n]) / 6 for n in k1}
        return self._moved(state, total, h)

    def _rates(self, state: State) -> State:
        found = self.unknowns(state)
        rates = {"t": 1.0}
        for q in self.route.coordinates:
            rates |= {q: state[f"{q}'"], f"{q}'": found[f"{q}''"]}
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
