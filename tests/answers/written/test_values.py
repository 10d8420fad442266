"""Values with units in a problem whose parameters have values.

Values that an answer states for parameters.

Several values of one quantity in one line.

Text beside a result: its unit, and its rounded value.

Words on stability, and conditions, beside an equation.
"""

from __future__ import annotations

from collections.abc import Mapping

import pytest
import sympy as sp

import lagrange
from lagrange.answers.references import reference_of_solution
from lagrange.answers.written.values import (
    CONDITIONAL,
    NUMBER,
    STABILITY,
    exact_results,
    is_force,
    is_unit,
    value_of,
    with_listed_values,
    with_value_in_si,
)
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
    assert with_value_in_si(Fragment.of("x = 4.9 cm"), reference).text == "x = (4.9)/10^2"
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


# Stated values


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        (" 9.81 m/s^2", sp.Rational("9.81"), " m/s^2"),
        ("2,5", sp.Rational(5, 2), ""),
        (r" 6.67 \cdot 10^{-11} N m^2/kg^2", sp.Rational("6.67e-11"), " N m^2/kg^2"),
        ("3e4 N", sp.Integer(30000), " N"),
    ],
)
def test_a_number_with_what_follows_it(text: str, value: sp.Expr, unit: str) -> None:
    match = NUMBER.match(text)
    assert match is not None
    assert (value_of(match), match["unit"]) == (value, unit)


@pytest.mark.parametrize(
    ("text", "bare", "is_one"),
    [
        (" m/s^2", False, True),
        (" m", False, True),
        ("m", False, False),
        (" x", False, False),
        ("", True, True),
        ("", False, False),
    ],
)
def test_a_letter_after_a_number_is_a_unit_only_after_a_space(text: str, bare: bool, is_one: bool) -> None:
    assert is_unit(text, {"m"}, bare) is is_one


# Listed values


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("theta = 0, pi", "theta = 0 or theta = pi"),
        ("θ = 0 or π, or cos θ = W/c", "θ = 0 or θ = π or cos θ = W/c"),
        ("theta = ±acos(W/c)", "theta = +acos(W/c) or theta = -acos(W/c)"),
        ("theta = {0, pi}", "theta = 0 or theta = pi"),
        ("x = 0, y = l", "x = 0, y = l"),
        ("theta = 0, as expected", "theta = 0, as expected"),
    ],
)
def test_listed_values(text: str, read: str) -> None:
    assert with_listed_values(Fragment.of(text)).text == read


# Approximations


@pytest.mark.parametrize(
    ("lines", "kept"),
    [
        (["cos θ = 2/3, i.e. θ ≈ 48.19°"], ["cos θ = 2/3"]),
        (["(a) v = 1", "(b) T = 2"], ["v = 1", "T = 2"]),
        (["(a) x'' = 1"], ["(a) x'' = 1"]),
        ([r"\cos\theta=\frac23\Rightarrow\theta\approx 48"], [r"\cos\theta=\frac23"]),
        ([r"\omega_+ = 1"], [r"\omega_{plus} = 1"]),
    ],
)
def test_what_stands_beside_a_result(lines: list[str], kept: list[str]) -> None:
    assert [f.text.strip() for f in exact_results([Fragment.of(line) for line in lines])] == kept


# Remarks


@pytest.mark.parametrize(
    ("text", "remark"),
    [
        ("theta = 0, stable for W < c h", ", stable for W < c h"),
        ("theta = pi is unstable", " is unstable"),
        ("theta = 0 (stable if c b^2 > W l)", "(stable if c b^2 > W l)"),
        ("x = a unstabled", None),  # another word
        ("x = 2 a", None),
    ],
)
def test_words_on_stability(text: str, remark: str | None) -> None:
    match = STABILITY.search(text)
    assert (match and match[0].rstrip()) == remark


def test_a_condition_of_existence() -> None:
    match = CONDITIONAL.search("cos(theta) = W/(c b) (only if W < c b)")
    assert match is not None
    assert match[0] == "(only if W < c b)"
    assert CONDITIONAL.search("x = (a + b) (c - d)") is None
