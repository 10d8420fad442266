"""Motions derived by Lagrange's equations."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import prime
from lagrange.explain.report import Report
from lagrange.mechanics.dynamics.equations import LagrangeMotion
from lagrange.mechanics.dynamics.motion import Method
from tests.support.shared import reported


def by_lagrange(name: str) -> Report:
    return reported(name, Method.LAGRANGE)


def motions(found: Report) -> list[LagrangeMotion]:
    """Those that are written down, in the file's coordinates and in the choices."""
    solution = found.solution
    several = [solution.own.dynamics, *(c.dynamics for c in solution.choices)]
    written = [m.written for m in several if m is not None]
    assert written
    assert all(isinstance(m, LagrangeMotion) for m in written)
    return [m for m in written if isinstance(m, LagrangeMotion)]


def euler_lagrange(function: sp.Expr, coordinates: list[sp.Symbol], motion: LagrangeMotion) -> list[sp.Expr]:
    """d/dt ∂L/∂q' − ∂L/∂q, without multipliers."""
    own = motion.configuration.slots
    return [own.time_derivative(function.diff(prime(q))) - function.diff(q) for q in coordinates]


TAKEN = """
title: Pendulum with a spring, whose names are taken
parameters: [m, L, T, V, p_x, v_P, g, Q_y]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
constraints: {rod: x^2 + y^2 = L^2}
gravity: g*j
forces:
  spring: {spring: T, between: [P, V*i]}
  wind: {on: P, vector: p_x*i + v_P*Q_y*j}
"""
