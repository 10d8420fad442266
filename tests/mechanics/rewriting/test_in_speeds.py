"""Velocities and accelerations by quasi-velocities, squares by constraints, and rates of one sign."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import Slots, prime
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.rewriting.in_speeds import (
    Course,
    one_way,
    rates_by_speeds,
    squares_by_constraints,
    substituted,
    with_squares,
)
from tests.support.shared import solved

x, y = sp.symbols("x y", real=True)


def test_accelerations_are_the_derivatives_of_velocities() -> None:
    solution = solved("sleigh")
    form, slots = solution.own.in_speeds, solution.problem.slots
    assert form is not None
    rule = rates_by_speeds(slots, form)
    for v, a in zip(slots.velocities, slots.accelerations, strict=True):
        if v in form.velocities.kinematic:
            along = {w: rule.get(w, w) for w in slots.velocities}
            rate = slots.time_derivative(form.velocities.kinematic[v]).xreplace(along)
            rate += sp.Add(*(form.velocities.kinematic[v].diff(u) * prime(u) for u in form.velocities.symbols))
            assert sp.expand(rule[a] - rate) == 0
    assert substituted(slots.velocities[0] - rule[slots.velocities[0]], rule) == 0


def test_the_square_of_a_velocity_by_its_constraint_is_taken_where_it_is_shorter() -> None:
    slots, v = Slots((x, y)), sp.Symbol("v", positive=True)
    vx, vy = slots.velocities
    row = Row("speed", (sp.S.Zero, sp.S.Zero), sp.S.Zero, nonlinear=vx**2 + vy**2 - v**2)
    squares = squares_by_constraints([row], slots)
    assert squares == [(vx, v**2 - vy**2)]
    assert with_squares(vx**2 + vy**2, squares) == v**2
    assert with_squares(vx**2, squares) == vx**2


def test_a_sleigh_goes_one_way() -> None:
    """u' = a ω² of the sleigh with its mass centre before the blade, a > 0: u only grows."""
    own = solved("sleigh").own
    assert own.in_speeds is not None
    [way] = one_way(own.in_speeds, own.configuration.slots, 60)
    assert way.course is Course.GROWS
    assert way.still in own.in_speeds.velocities.symbols
    assert sp.expand(way.rate.subs(way.still, 0)) == 0
    assert [*one_way(own.in_speeds, own.configuration.slots, 0)] == []
