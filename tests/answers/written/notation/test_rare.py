"""Notations that are rare in equations of motion and common in values.

D and d/dt before what they differentiate.

Proportions, tuples, and the greatest of several values, as equations.
"""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.rare import (
    extremes,
    integrals_over_time,
    name_of_extreme,
    ratios_of,
    signs_as_indices,
    tuples_of,
    with_indices,
    with_operators,
)
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.edits import Draft
from tests.support.scopes import scope


@pytest.mark.parametrize(
    ("text", "written"),
    [("omega_+ = 2", "omega_plus = 2"), ("T_1/2 = 3", "T_half = 3"), ("x = omega_+", "x = omega_plus")],
)
def test_a_sign_is_an_index_on_the_left(text: str, written: str) -> None:
    draft = Draft(Fragment.of(text))
    signs_as_indices(draft)
    assert draft.text == written


def test_a_number_after_a_name_is_its_index_where_that_is_declared() -> None:
    declared = scope("x_1 x_2", "m")
    assert with_indices(Fragment.of("x1 = m"), declared).text.strip() == "x_1 = m"
    assert with_indices(Fragment.of("x3 = m"), declared).text == "x3 = m"


# Operators


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("m D^2 r - m r (D phi)^2", "m diff(diff(r, t), t) - m r (diff(phi, t))^2"),
        ("2 D r D phi", "2 diff(r, t) diff(phi, t)"),
        ("Dx + D²θ", "diff(x, t) + diff(diff(θ, t), t)"),
        ("D(m r^2 D phi)", "diff((m r^2 diff(phi, t)), t)"),
        ("(m D^2 + b D + c) x", "(m diff(diff(x, t), t) + b diff(x, t) + c x)"),
    ],
)
def test_the_operator_d(text: str, written: str) -> None:
    draft = Draft(Fragment.of(text))
    with_operators(draft, frozenset({"x"}))
    assert draft.text == written


# Ratios


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("h : R = 5 : 2", ["(h)/(R) = (5)/(2)"]),
        ("ratio: x : y = -1 : 1", ["(x)/(y) = (-1)/(1)"]),
        ("A:B:C = 1:2:1", ["(A)/(B) = (1)/(2)", "(B)/(C) = (2)/(1)"]),
        ("P/W = 3 : tan(theta)", ["P/W = (3)/(tan(theta))"]),
        ("theta = 0: omega = 3", []),
        ("Equation: x = 2", []),
    ],
)
def test_ratios(text: str, equations: list[str]) -> None:
    assert ratios_of(text) == equations


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("(x, y) = (1, 2)", ["x = 1", "y = 2"]),
        ("(x, y) = (0, 0), (0, pi)", ["[x, y] = [0, 0]", "[x, y] = [0, pi]"]),
        ("(x, y) = (0, 0, 1)", []),
        ("(x + y) = (a)", []),
    ],
)
def test_tuples(text: str, equations: list[str]) -> None:
    assert tuples_of(text) == equations


def test_the_greatest_of_several_values() -> None:
    draft = Draft(Fragment.of("min(a, b)"))
    draft.apply(extremes(draft.text))
    assert draft.text == "(((a)+( b)-abs((a)-( b)))/2)"
    assert name_of_extreme("max(T) = 3 m g") == "T_max = 3 m g"


@pytest.mark.parametrize(
    ("texts", "made"),
    [
        (["L di/dt + 1/C ∫ i dt = 0", "i = q'"], ["L di/dt + 1/C  q  = 0", "i = q'"]),
        ([r"L\frac{di}{dt} + \frac1C\int i\,\mathrm{d}t = 0"], [r"L\frac{di}{dt} + \frac1C q  = 0"]),
        (["x = ∫ x' dt"], ["x =  x "]),
        (["∫ v dt = a", "v = s'"], ["∫ v dt = a", "v = s'"]),
    ],
)
def test_integrals_over_time(texts: list[str], made: list[str]) -> None:
    coordinates = ["q"] if any("i" in text for text in texts) else ["x", "y"]
    assert integrals_over_time(texts, coordinates) == made
