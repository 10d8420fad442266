"""Equations of motion in quasi-velocities, of shipped problems and of a sled."""

from __future__ import annotations

from lagrange.document.math_writer import text
from lagrange.explain.report import notation_of
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations, QuasiVelocityForm
from lagrange.mechanics.results import Solution

SLED = """
title: A sled
parameters: [m, I, a]
coordinates: [x, y, theta]
bodies: {B: {mass: m, inertia: I, position: x*i + y*j + a*e1_B, angle: theta}}
constraints: {blade: "y'*cos(theta) = x'*sin(theta)"}
"""


def speeds_of(solution: Solution) -> QuasiVelocityForm:
    assert solution.own.in_speeds is not None
    return solution.own.in_speeds


def equations_of(solution: Solution) -> QuasiEquations:
    found = speeds_of(solution).equations
    assert found is not None
    return found


def written(solution: Solution) -> list[str]:
    notation = notation_of(solution)
    return [f"{text(e, notation)} = 0" for e in equations_of(solution).expressions]
