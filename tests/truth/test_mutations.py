"""Slips in the equations of every shipped problem of motion are found to be wrong.

A mutation that happens to be right (in an equation of two terms, changing the sign of one is the same as changing that of the other; a
term that the constraints make zero) must be right by a second route: the accelerations that the system gives, solved in
mpmath at a state that satisfies the constraints, satisfy it.
"""

from __future__ import annotations

import math

import mpmath
import pytest
import sympy as sp

from lagrange.answers.diagnosis import diagnosed
from lagrange.answers.slips import Slip
from lagrange.mechanics.dynamics.comparison import Standing, System, compare
from tests.support.chance import times
from tests.support.mutations import best_system, mutations
from tests.support.shared import asking, solved

MOST = times(5)
"""Slips of one problem that are tried, taken from all of its equations; `make bench` tries every one."""


@pytest.mark.parametrize("name", asking("motion"))
def test_mutations_are_wrong(name: str) -> None:
    found = best_system(solved(name))
    assert found is not None
    equations, candidate = found
    explained = total = 0
    everything = list(mutations(equations))
    for mutation in everything[:: math.ceil(len(everything) / MOST)]:
        result = compare([mutation.equation], candidate.system)
        assert result is not None
        if result.standings[0] is not Standing.CONTRADICTS:
            assert holds(mutation.equation, candidate.system)
            continue
        total += 1
        change = diagnosed(mutation.equation, candidate.system)
        explained += change is not None and change.slip is not None
        if mutation.slip is Slip.SIGN:
            assert change is not None
            assert change.slip is Slip.SIGN
    assert explained >= math.floor(0.8 * total)


def holds(equation: sp.Expr, system: System) -> bool:
    """Whether an equation holds for the accelerations of the system, at a state that satisfies the constraints."""
    slots, rows = system.configuration.slots, system.configuration.rows
    [values] = system.configuration.surface.sampled(
        lambda point: {q: mpmath.mpf(point.input(q)) for q in slots.coordinates}, 1, real=True
    )
    expressions = (equation, *system.equations, *system.accelerated_constraints)
    unknowns = (*system.multipliers, *slots.accelerations)
    for k, s in enumerate(sorted({s for e in expressions for s in e.free_symbols} - {*unknowns}, key=str)):
        values.setdefault(s, mpmath.mpf(3 + k) / (5 + 2 * k))
    velocities = dict(zip(slots.velocities, allowed(rows, slots, values), strict=True)) if rows else {}
    values |= velocities
    matrix = [[number(sp.diff(e, u), values) for u in unknowns] for e in expressions[1:]]
    right = [-number(e.xreplace(dict.fromkeys(unknowns, sp.S.Zero)), values) for e in expressions[1:]]
    found = mpmath.lu_solve(mpmath.matrix(matrix), mpmath.matrix(right))
    return bool(abs(number(equation, values | dict(zip(unknowns, found, strict=True)))) < 1e-9)


def allowed(rows, slots, values):  # type: ignore[no-untyped-def]
    """Velocities near given ones that satisfy A q' + a_t = 0."""
    a = mpmath.matrix([[number(c, values) for c in r.coefficients] for r in rows])
    wanted = mpmath.matrix([values.get(v, mpmath.mpf(1)) for v in slots.velocities])
    missing = mpmath.matrix([-number(r.drift, values) for r in rows]) - a * wanted
    return list(wanted + a.T * mpmath.lu_solve(a * a.T, missing))


def number(e: sp.Expr, values: dict[sp.Symbol, mpmath.mpf]) -> mpmath.mpf:
    return mpmath.mpf(sp.sympify(e).xreplace({s: sp.Float(str(v), 20) for s, v in values.items()}).evalf(20))
