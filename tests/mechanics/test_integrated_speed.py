"""Motions by two integrals over time."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import t
from lagrange.mechanics.integrated_speed import integral_over_time, integrated_speed
from tests.support.shared import solved

C, g, w = sp.Symbol("C", real=True), *sp.symbols("g omega", positive=True)


@pytest.mark.parametrize("rate", [g * sp.cos(w * t), g * sp.sin(w * t) * sp.cos(w * t) + 2, sp.cos(w * t) ** 2 * g])
def test_the_integral_has_the_rate_as_its_derivative(rate: sp.Expr) -> None:
    found = integral_over_time(rate, C)
    assert found is not None
    assert sp.simplify(found.diff(t) - rate) == 0
    assert found.coeff(C) == 1


@pytest.mark.parametrize("rate", [sp.exp(t), t * sp.cos(w * t), 1 / (1 + t), g * sp.Symbol("x'", real=True)])
def test_other_rates_are_not_integrated(rate: sp.Expr) -> None:
    assert integral_over_time(rate, C) is None


def test_a_skate_that_turns_evenly_runs_as_its_equations_say() -> None:
    """v' = g sin α cos Ωt, x' = v cos Ωt, y' = v sin Ωt; the constants are all there."""
    solution = solved("clockwork-skate")
    assert solution.own.in_speeds is not None
    motion = integrated_speed(solution.own.in_speeds, solution.problem.scope.names())
    assert motion is not None
    v, x, y = motion.values.values()
    turn, slope, gravity = (s for s in sorted(v.free_symbols - {t, *motion.constants}, key=str))
    assert [s.name for s in (turn, slope, gravity)] == ["Omega", "alpha", "g"]
    assert sp.simplify(v.diff(t) - gravity * sp.sin(slope) * sp.cos(turn * t)) == 0
    assert sp.simplify(x.diff(t) - v * sp.cos(turn * t)) == 0
    assert sp.simplify(y.diff(t) - v * sp.sin(turn * t)) == 0
    assert [c.name for c in motion.constants] == ["C_1", "C_2", "C_3"]


def test_a_rate_that_depends_on_the_state_is_left_alone() -> None:
    solution = solved("sleigh")
    assert solution.own.in_speeds is not None
    assert integrated_speed(solution.own.in_speeds, solution.problem.scope.names()) is None
