""""""

from __future__ import annotations

from lagrange.explain.report import report
from lagrange.render import terminal
from tests.mechanics.test_book_questions import Read

ROLLER = """
title: A cylinder slides in a pipe
axes: {i: right, j: down}
parameters: [m, g, R, r]
coordinates: [x, y]
particles: {c: {mass: m, position: x*i + y*j}}
constraints: {wall: {equation: x^2 + y^2 <= (R - r)^2, reaction: N, by: surface}}
gravity: g*j
generalized_coordinates:
  a: {coordinates: [phi], substitute: {x: (R - r)*sin(phi), y: (R - r)*cos(phi)}}
"""


def test_a_difference_of_radii_is_positive_in_the_sense_of_the_file(problem: Read) -> None:
    solved = report(problem(ROLLER))
    page = terminal.text(solved.derivation, solved.notation, 120)
    assert "N = m (R − r) (ẋ² + ẏ² + g y)/(x² + y²) = m (R − r) φ̇² + m g cos φ" in page
    assert "|R − r|" not in page
    assert "with R − r > 0" in page
