"""Velocities after an impact by one of them."""

from __future__ import annotations

import sympy as sp

from lagrange.mechanics.rewriting.by_one_velocity import by_one_velocity

m, v, M, l, w, h, R = sp.symbols("m v M l w h R", positive=True)
x, y, turn = sp.symbols("x' y' theta'", real=True)


def test_a_disc_that_meets_a_step() -> None:
    rate = w * (3 * R - 2 * h) / (3 * R)
    values = {x: w * (h - R) * (2 * h - 3 * R) / (3 * R), y: rate * sp.sqrt(h * (2 * R - h)), turn: rate}
    made = by_one_velocity(values)
    assert next(iter(made)) == turn
    assert made[turn] == rate
    assert sp.expand(made[x] - (R - h) * turn) == 0
    assert all(sp.simplify(e.subs(turn, rate) - values[q]) == 0 for q, e in made.items())


def test_short_velocities_stay() -> None:
    values = {turn: m * v / ((M + m) * l), x: m * v / (M + m), y: sp.S.Zero}
    assert by_one_velocity(values) == values
