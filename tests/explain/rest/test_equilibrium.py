"""The prose about equilibria that are not solved, and about conditions."""

from __future__ import annotations

from lagrange.core.diagnostics import Source
from lagrange.explain.report import report
from lagrange.problem.loader import read_problem
from lagrange.render import terminal
from tests.mechanics.equilibrium.test_degenerate import BAR

RING = """
title: A bead on a vertical ring with a spring from its top
parameters: [m, g, k, R]
coordinates: [theta]
particles: {P: {mass: m, position: R*sin(theta)*i - R*cos(theta)*j}}
gravity: -g*j
forces: {spring: {spring: k, between: [R*j, P], length: R}}
find: equilibrium
"""


def page(text: str) -> str:
    found = report(read_problem(Source("problem.yaml", text)))
    return " ".join(terminal.text(found.derivation, found.notation, 100).split())


def test_what_is_not_solved_is_not_said_to_exist() -> None:
    words = page(BAR)
    assert "Any real solution of (9) is an equilibrium; whether there is one is left open." in words
    assert "stable where P < c/l + k l, unstable where the opposite inequality holds" in words
    assert "At (9) its sign decides: positive means stable, negative unstable." in words


def test_a_condition_is_stated_once_and_shortly() -> None:
    words = page(RING)
    assert "where k R ≥ 2m g" in words
    assert "positive where k R > 2m g: stable" in words
    assert "8m g k R" not in words


TIED = """
title: Slider tied to a point
parameters: [m, a, k, c]
coordinates: [theta]
particles: {P: {mass: m, position: a*cos(theta)*i}}
forces: {tie: {spring: k, between: [P, O], length: c}}
find: [equilibrium, linearization]
"""


def test_places_alike_are_in_one_sentence_and_in_one_section() -> None:
    said = " ".join(page(TIED).split())
    assert said.count("the tie spring has length 0") == 1
    assert "Where θ = π/2 or θ = −π/2, the tie spring has" in said
