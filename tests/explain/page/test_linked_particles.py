"""Two particles joined by a rod: the vector equations follow from Newton's laws, and no component is divided by."""

from __future__ import annotations

import numpy as np

from lagrange.core.diagnostics import Source
from lagrange.explain.page.linked_particles import linked
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.support.shared import reported

PULLED = """
title: A dumbbell that is pulled
parameters: [m, M, l, F]
coordinates: [x1, y1, x2, y2]
particles:
  A: {mass: m, position: x1*i + y1*j}
  B: {mass: M, position: x2*i + y2*j}
constraints:
  rod: (x2 - x1)^2 + (y2 - y1)^2 = l^2
forces:
  pull: {on: B, vector: F*i}
"""


def test_the_rod_falls_as_one_and_no_component_is_divided_by() -> None:
    r = reported("ex14-two-particles", complete=False)
    said = terminal.text(r.derivation, r.notation, 80)
    assert "≠" not in said
    assert "(𝐫_P₂ − 𝐫_P₁) × (𝐫̈_P₂ − 𝐫̈_P₁) = 0" in said
    assert "T is never negative" in " ".join(said.split())


def test_a_force_on_one_end_alone_turns_the_rod() -> None:
    r = report(read_problem(Source("pulled.yaml", PULLED)), complete=False)
    said = " ".join(terminal.text(r.derivation, r.notation, 80).split())
    link = linked(r.solution)
    assert link is not None
    assert not link.falls_as_one
    assert "(𝐫_B − 𝐫_A) × (M 𝐫̈_B − 𝐅_B) = 0" in said
    assert "integrates to (𝐫_B − 𝐫_A) ×" not in said


def test_the_tension_is_that_of_numbers() -> None:
    """The two laws and the constraint, differentiated twice, solved as numbers for accelerations and tension."""
    m, big, l, force = 2.0, 3.0, 1.5, 0.7
    u, w = l * np.array([0.6, 0.8]), np.array([-0.8, 0.6]) * 1.1
    # unknown: r1'', r2'', T
    matrix = np.zeros((5, 5))
    matrix[0:2, 0:2], matrix[2:4, 2:4] = m * np.eye(2), big * np.eye(2)
    matrix[0:2, 4], matrix[2:4, 4] = -u / l, u / l
    matrix[4, 0:2], matrix[4, 2:4] = -u, u
    right = np.array([0, 0, force, 0, -w @ w])
    tension = np.linalg.solve(matrix, right)[4]
    closed = m * big / ((m + big) * l) * (w @ w + u @ np.array([force / big, 0]))
    assert abs(tension - closed) < 1e-12


def test_other_systems_are_left_as_they_are() -> None:
    assert linked(reported("ex10-double-pendulum", complete=False).solution) is None
