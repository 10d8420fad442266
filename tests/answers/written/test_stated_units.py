"""Values with units in a problem whose parameters have values."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

import lagrange
from lagrange.answers.references import reference_of_solution
from lagrange.answers.written.stated_units import is_force, with_value_in_si
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Answers
from tests.answers.questions.test_statics import examiner, verdict

WEIGHT = """
title: Weight on a spring
parameters: {m: 2 kg, k: 400 N/m, g: 9.81 m/s^2}
coordinates: {x: {unit: m}}
particles: {P: {mass: m, position: x*j}}
gravity: -g*j
forces: {spring: {potential: k*x^2/2}}
find: [equilibrium]
"""


def test_a_length_in_centimetres() -> None:
    reference = reference_of_solution(solve(lagrange.loads(WEIGHT), complete=False))
    assert with_value_in_si(Fragment.of("x = 4.9 cm"), reference).text == "x = (4.9e-2)"
    assert with_value_in_si(Fragment.of("x = m*g/k"), reference).text == "x = m*g/k"
    with pytest.raises(ProblemError, match="kg"):
        with_value_in_si(Fragment.of("x = 4.9 kg"), reference)
    assert not is_force(reference.scope.scalar("x"), reference)


BLOCK = """title: Block on an incline
coordinates: {x: {meaning: along, unit: m}, y: {meaning: across, unit: m}}
parameters: {m: {value: 10 kg}, g: {value: 9.81 m/s^2}, alpha: {value: 30 deg}}
particles: {P: {mass: m, position: "x*(cos(alpha)*i - sin(alpha)*j) + y*(sin(alpha)*i + cos(alpha)*j)"}}
gravity: -g*j
constraints: {plane: {equation: y >= 0, reaction: N}}
"""


@pytest.mark.parametrize(
    ("stated", "expected"),
    [
        ("84.96 N", "equivalent"),
        ("85.0 N", "equivalent"),
        ("0.08496 kN", "equivalent"),
        ("0.0800 kN", "wrong"),
        ("85.96 N", "wrong"),
        ("N = 84.96 N", "equivalent"),
        ("m*g*cos(alpha)", "equivalent"),
    ],
)
def test_a_reaction_in_newtons(stated: str, expected: str) -> None:
    reactions: Mapping[str, Fragment] = {"plane": Fragment.of(stated)}
    assert examiner(BLOCK).check_answers(Answers(reactions=reactions)).verdict.value == expected


def test_reactions_with_units_in_a_text() -> None:
    assert verdict(BLOCK, "x'' = 4.905 m/s^2", "N = 84.96 N") == "equivalent"
    assert verdict(BLOCK, r"N = 84.96\,\mathrm{N}", r"\ddot x = 4.905\,\mathrm{m/s^2}") == "equivalent"
    assert verdict(BLOCK, "x'' = 4.905 m/s^2", "N = 0.0800 kN") == "wrong"


def test_a_reaction_is_no_mass() -> None:
    judged = examiner(BLOCK).check_answers(Answers(reactions={"plane": Fragment.of("84.96 kg")}))
    assert [m.code for m in judged.others[0].unreadable] == ["unit-mismatch"]
