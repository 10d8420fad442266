"""The words about reactions: what is a rod, what a contact."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from lagrange.document.derivation import Rule
from lagrange.explain.report import report
from lagrange.problem.model import Problem
from lagrange.render import terminal
from tests.support.derivation_text import said_in

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
    free = page(problem("title: Free\nparameters: [m]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\n"))
    assert "there are no reactions" in free


KEPT = """title: Kept
parameters: [m, g, l, R, I, L]
coordinates: [x, y, p, q, a, b]
particles: {A: {mass: m, position: x*i + y*j}, C: {mass: m, position: a*j}, D: {mass: m, position: b*j}}
bodies: {W: {mass: m, inertia: I, position: p*i + R*j, angle: q}}
constraints:
  held: {equation: EQUATION, reaction: N, by: KEEPER}
  wheel: {equation: "p' + R*q' = 0", reaction: F, by: rolling}
  cord: {equation: a + b = L, reaction: S, by: string}
gravity: -g*j
"""


@pytest.mark.parametrize(
    ("equation", "keeper", "words"),
    [
        ("y = x^2", "wire", "The held constraint keeps A on a wire, and its reaction is normal to it"),
        ("y = x^2", "surface", "The held constraint keeps A on a surface, and its reaction is normal to it"),
        ("x^2 + y^2 = l^2", "wire", "The held constraint keeps A on a wire, and its reaction is normal to it"),
        ("x^2 + y^2 = l^2", "string", "along the line joining them, as that of a string."),
        ("x^2 + y^2 = l^2", "rod", "along the line joining them, as that of a rod."),
        ("x^2 + y^2 = l^2", "hinge", "The held constraint is maintained by a hinge."),
        ("x = 2*a", "gear", "The held constraint is maintained by gears in mesh."),
    ],
)
def test_what_keeps_a_constraint_is_named(problem: Read, equation: str, keeper: str, words: str) -> None:
    found = report(problem(KEPT.replace("EQUATION", equation).replace("KEEPER", keeper)), complete=False)
    shown = " ".join(terminal.text(found.derivation, found.notation, 100).split())
    assert words in shown
    assert "on a surface or curve" not in shown
    assert "The wheel constraint is maintained by rolling without slipping." in shown
    assert "The cord constraint, a string, keeps a length constant" in shown


# -- Reactions that are too long as functions of position and velocity -------------------------------------------------


@pytest.mark.parametrize(
    ("name", "rule", "said"),
    [
        ("four-bar-linkage", Rule.SOLVED_REACTIONS, " too long to be written as functions of position and velocity."),
        ("four-bar-linkage", Rule.SOLVED_REACTIONS, " In terms of the accelerations, Newton's equations give"),
    ],
)
def test_they_are_given_by_the_accelerations(name: str, rule: Rule, said: str) -> None:
    assert said in said_in(name, rule)


def test_a_string_only_pulls(problem: Read) -> None:
    """For a string through a ring, nothing is said about a support that can only push."""
    words = page(
        problem(
            """title: A ring on a string between a peg and a rail
parameters: [m, g, c]
coordinates: [x, y]
particles: {P: {mass: m, position: x*i + y*j}}
gravity: g*j
constraints: {c: {equation: norm(r_P) + y = 2*c, reaction: T, by: string}}
"""
        )
    )
    assert "A string can only pull, and stays taut as long as T ≥ 0." in words
    assert "can only push" not in words


def test_reactions_that_are_the_same_at_several_equilibria_are_listed_once(problem: Read) -> None:
    """A beam on two supports, upright or turned over: N_A + N_B = W at both, and at the head."""
    read = problem(
        """title: Beam on two supports
parameters: {W: positive, l: positive}
coordinates: [x, y, theta]
bodies: {beam: {mass: 0, inertia: 0, position: x*i + y*j, angle: theta}}
forces: {weight: {on: beam, vector: -W*j}}
constraints:
  left: {equation: "dot(r_beam - l*e1_beam, j) = 0", reaction: N_A}
  right: {equation: "dot(r_beam + l*e1_beam, j) = 0", reaction: N_B}
  side: x = 0
find: equilibrium
"""
    )
    words = page(read)
    assert words.count("N_A = W/2") + words.count("N_A = ½ W") == 2
    assert any(f"At ({n}) and ({n + 1}) they are" in words for n in range(10, 40))


def test_the_balance_is_written_in_the_named_force(problem: Read) -> None:
    text = """
title: A pendulum
parameters: {m: positive, g: positive, l: positive}
coordinates: [x, y]
particles: {B: {mass: m, position: x*i + y*j}}
gravity: -g*j
constraints: {rod: {equation: norm(r_B) = l, reaction: T}}
find: [motion, equilibrium]
"""
    explained = report(problem(text))
    page = " ".join(terminal.text(explained.derivation, explained.notation, 100).split())
    assert "With the reactions, the generalized forces add up to zero" in page
    assert "−m g − (y/l) T = 0" in page
