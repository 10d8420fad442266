"""The words about reactions: what is a rod, what a contact."""

from __future__ import annotations

from collections.abc import Callable

from lagrange.explain.report import report
from lagrange.problem.model import Problem
from lagrange.render import terminal

Read = Callable[[str], Problem]

HOOP = """title: Hoop on a cylinder
parameters: [m, a, R, g]
coordinates: [r, theta, phi]
frame: {type: polar, coordinates: [r, theta]}
bodies: {hoop: {mass: m, inertia: m*a^2, position: r*e_r, angle: phi}}
constraints: {contact: {equation: r = R + a, reaction: N}, rolling: "(R + a)*theta' = a*phi'"}
gravity: -g*j
"""

PENDULUM = """title: Pendulum in its angle
parameters: [m, l, g]
coordinates: [theta]
particles: {P: {mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}
gravity: -g*j
"""


def page(problem: Problem) -> str:
    found = report(problem, complete=False)
    return " ".join(terminal.text(found.derivation, found.notation, 100).split())


def test_a_hoop_is_held_by_a_contact_and_by_no_rod(problem: Read) -> None:
    words = page(problem(HOOP))
    assert "rod" not in words
    assert "the particle" not in words
    assert "contact from outside requires N ≤ 0" in words


def test_reactions_that_the_coordinates_take_into_account_are_not_denied(problem: Read) -> None:
    words = page(problem(PENDULUM))
    assert "The coordinates satisfy the constraints by themselves" in words
    assert "satisfy the constraints already" in words
    free = page(problem("title: Free\nparameters: [m]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"))
    assert "there are no reactions" in free
