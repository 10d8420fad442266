"""Velocities and accelerations by quasi-velocities, squares by constraints, and rates of one sign.

Velocities after an impact by one of them.

Equations in the names that the file gives.
"""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import Slots, prime
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.rewriting.quasi_velocities import (
    Course,
    by_one_velocity,
    in_names,
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


# By one velocity


m, v, M, l, w, h, R = sp.symbols("m v M l w h R", positive=True)
x_by_one_velocity, y_by_one_velocity, turn = sp.symbols("x' y' theta'", real=True)


def test_a_disc_that_meets_a_step() -> None:
    rate = w * (3 * R - 2 * h) / (3 * R)
    values = {
        x_by_one_velocity: w * (h - R) * (2 * h - 3 * R) / (3 * R),
        y_by_one_velocity: rate * sp.sqrt(h * (2 * R - h)),
        turn: rate,
    }
    made = by_one_velocity(values)
    assert next(iter(made)) == turn
    assert made[turn] == rate
    assert sp.expand(made[x_by_one_velocity] - (R - h) * turn) == 0
    assert all(sp.simplify(e.subs(turn, rate) - values[q]) == 0 for q, e in made.items())


def test_short_velocities_stay() -> None:
    e = sp.Symbol("e", positive=True)
    struck = {
        turn: (M - 3 * m * e) * sp.sqrt(3 * v / l) / (M + 3 * m),
        x_by_one_velocity: M * (e + 1) * sp.sqrt(3 * v * l),
    }
    assert by_one_velocity(struck) == struck
    values = {turn: m * v / ((M + m) * l), x_by_one_velocity: m * v / (M + m), y_by_one_velocity: sp.S.Zero}
    assert by_one_velocity(values) == values


# Stated names


def test_a_quasi_velocity_stands_for_its_definition() -> None:
    solution = solved("snakeboard")
    speed = next(u for u in solution.problem.speeds if u.definition.is_Add)
    rate = solution.problem.slots.time_derivative(speed.definition)
    ((left, right),) = in_names(solution, ((speed.definition, rate),))
    assert left == speed.symbol
    assert right == prime(speed.symbol)


def test_without_names_nothing_changes() -> None:
    stated = ((sp.Symbol("x"), sp.S.Zero),)
    assert in_names(solved("ex11-ideal-pendulum"), stated) == stated
