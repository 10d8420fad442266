"""What a page evaluates: each expression once."""

from __future__ import annotations

from collections import Counter

import sympy as sp

from lagrange.animation.elements import Cells
from lagrange.animation.figure import MovingFigure
from lagrange.animation.moving import moving_figure
from lagrange.core.diagnostics import Source
from lagrange.core.vectors import Vector
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem

x, y = sp.symbols("x y", real=True)


def test_each_expression_has_one_place() -> None:
    cells = Cells()
    first = cells.scalar(x * y)
    assert cells.scalar(x * y) == first
    place = cells.vector(Vector((x, y, sp.S.Zero)))
    assert cells.vector(Vector((x, y, sp.S.Zero))) == place
    assert cells.expressions[first] == x * y
    assert cells.expressions[place : place + 3] == [x, y, 0]


# -- What holds a body -------------------------------------------------------------------------------------------------

GATE = """
title: Gate
parameters: [m, l, g]
coordinates: [x, y, theta]
bodies: {gate: {mass: m, inertia: m*l^2/12, position: x*i + y*j, angle: -theta}}
constraints: {hinge_x: x = l/2*cos(theta), hinge_y: %s}
gravity: -g*j
"""


def kinds(text: str) -> Counter[str]:
    figure = moving_figure(report(read_problem(Source("gate", text))).solution)
    assert isinstance(figure, MovingFigure)
    return Counter(item["k"] for item in figure.data["items"])


def test_two_reactions_at_a_point_that_stays_are_a_hinge() -> None:
    """And no wall and floor that cross there; an end that slides down a wall rests on it."""
    pinned = kinds(GATE % "y = -l/2*sin(theta)")
    assert (pinned["rest"], pinned["wall"]) == (0, 1)
    sliding = kinds(GATE.replace("hinge_y: %s", "").replace(", }", "}"))
    assert (sliding["rest"], sliding["wall"]) == (1, 0)
