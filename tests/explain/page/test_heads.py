"""What the head of a page says, and what the page then says once."""

from __future__ import annotations

import pytest

from lagrange.explain.report import report
from lagrange.render import terminal
from tests.support.problem_texts import read
from tests.support.shared import reported


def page(name: str) -> str:
    r = reported(name, complete=False)
    return " ".join(terminal.text(r.derivation, r.notation, 100).split())


@pytest.mark.parametrize(
    ("name", "head"),
    [
        ("ex01-horizontal-surface", "│ 𝐑 = −F_z 𝐤 │"),
        ("ex03-double-pendulum", "by x₁, y₁, x₂ and y₂, with two relations between them, or by θ₁ and θ₂, with none."),
        ("ex06-two-particle-skate", "with three finite relations between them, or by x, y and θ, with none."),
        (
            "ex08-displacements-on-a-surface",
            "virtual and possible displacements are the same: ╭─────────────╮ │ ∇f·δ𝐫 = 0 │",
        ),
        ("ex09-moving-surface", "│ ∇f·δ𝐫 = 0 │ │ d𝐫 = δ𝐫 + u dt 𝐢 │"),
        ("ex11-ideal-pendulum", "│ T = m l θ̇² + m g cos θ │"),
        ("bifilar-suspension", "the equilibrium and the reaction:"),
        ("servo", "│ x = C e^(−κ t) − v/κ + v t │"),
    ],
)
def test_the_head_answers_the_question(name: str, head: str) -> None:
    assert head in page(name).partition(" 1 The system")[0]


def test_a_particle_is_introduced_with_its_letter_and_then_called_by_its_words() -> None:
    text = page("ex18-double-pendulum")
    assert "The upper particle P1 and the lower particle P2 have the masses m₁ and m₂; their positions" in text
    assert "On the upper particle and the lower particle taken separately" in text


def test_an_equation_that_a_limit_does_not_change_is_not_repeated() -> None:
    assert "a simple pendulum (the other equation unchanged), with" in page("ex18-double-pendulum")


def test_the_energy_is_stated_in_the_chosen_coordinates_only() -> None:
    titles = [s.title for s in reported("ex11-ideal-pendulum").derivation.page if not s.folded]
    assert "Conserved quantities" not in titles
    assert "What it says" in titles


FALLING = """
title: A falling particle
axes: {i: horizontal, j: down}
parameters: [m, g]
coordinates: [x, y]
particles: {P: {name: pebble, mass: m, position: x*i + y*j}}
gravity: g*j
find: equilibrium
"""


def test_a_balance_that_nothing_satisfies_is_not_divided_away() -> None:
    r = report(read(FALLING), complete=False)
    text = " ".join(terminal.text(r.derivation, r.notation, 100).split())
    assert "so the coefficient of each must vanish: m g = 0" in text
    assert "1 = 0" not in text
    assert "𝐢 is horizontal and 𝐣 points down." in text
    assert "The pebble P has the mass m; its position and weight are" in text


def test_a_long_force_in_general_gives_way_to_its_value_in_the_state_that_is_asked_for() -> None:
    head = page("rod-cut-loose").partition(" 1 The system")[0]
    assert "the motion and what is asked:" in head
    assert head.count("T =") == 1
    assert "T = ¼ m g when t = 0" in head
