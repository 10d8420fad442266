"""First-order equations in symbols.

Equations too long to print, as a program.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

import lagrange
from lagrange.animation.figure import MovingFigure
from lagrange.animation.moving import moving_figure
from lagrange.core.expression_size import count_distinct
from lagrange.mechanics.nearby.long_equations import long_equations
from lagrange.programs.first_order import in_coordinates
from lagrange.programs.languages import Target
from lagrange.programs.numerical_system import NumericalSystem
from lagrange.programs.prepared import prepared
from lagrange.programs.source import source_file
from lagrange.programs.state_equations import state_equations
from tests.support.shared import solved


def test_a_pendulum_in_its_angle_and_with_its_rod() -> None:
    solution = solved("ex11-ideal-pendulum")
    angle = solution.choices[0].dynamics
    assert angle is not None
    free = in_coordinates(angle)
    [acceleration] = sp.Matrix(free.mass).LUsolve(sp.Matrix(free.force))
    theta = free.slots.coordinates[0]
    g, length = sp.Symbol("g", positive=True), sp.Symbol("l", positive=True)
    assert sp.simplify(acceleration + g / length * sp.sin(theta)) == 0
    assert solution.own.dynamics is not None
    held = in_coordinates(solution.own.dynamics)
    assert len(held.constraint_matrix) == 1
    assert len(held.state) == 4


# Long motion


def test_equations_too_long_to_print_are_the_same_motion() -> None:
    problem = lagrange.loads(
        "title: sleigh\nparameters: {m: {value: 2}, J: {value: 0.7}, a: {value: 0.4}, k: {value: 3}}\n"
        "coordinates: [x, y, theta]\nlet: {e: cos(theta)*i + sin(theta)*j}\n"
        "bodies: {sleigh: {mass: m, inertia: J, position: x*i + y*j + a*e, angle: theta}}\n"
        "constraints: {blade: \"x'*sin(theta) = y'*cos(theta)\"}\nforces: {spring: {potential: k*x^2/2}}\n"
    )
    made = prepared(problem)
    solution, known = made.solution, made.states
    found = long_equations(solution.problem, solution.own.configuration)
    long = state_equations(replace(solution, long_equations=found))
    assert long.state == known.state
    rng = np.random.default_rng(5)
    for _ in range(3):
        y = NumericalSystem(known, made.start.values).projected(0.0, tuple(rng.uniform(0.2, 1.2, 6)))
        assert y is not None
        one, other = (NumericalSystem(s, made.start.values).rate(0.0, *y) for s in (known, long))
        assert other == pytest.approx(one, rel=1e-9, abs=1e-9)
    flow = NumericalSystem(long, made.start.values).rate(0.0, *y)
    change = [long.conserved["energy"].diff(s) for s in long.state]
    powers = [
        d * NumericalSystem(long, made.start.values).function(e)(0.0, *y) for d, e in zip(flow, change, strict=True)
    ]
    assert sum(powers) == pytest.approx(0, abs=1e-9 * max(map(abs, powers)))
    figure = moving_figure(replace(solution, long_equations=found))
    assert isinstance(figure, MovingFigure)
    assert figure.moves
    assert "lambda" not in source_file(long, made.start, Target.C).split("#include")[1]


def test_common_parts_are_counted_once() -> None:
    e = sp.Symbol("x")
    for k in range(60):
        e = (e + k) * (e - k - 1)  # written out it would have 2^60 operations
    assert count_distinct([e, e]) < 400
