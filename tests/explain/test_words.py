"""Numbers and lists in words."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.document.derivation import Math
from lagrange.explain.words import (
    at_start,
    bare,
    constraints_called,
    in_decimals,
    in_words,
    introduced,
    qualified,
    spoken,
    the,
)
from lagrange.mechanics.questions.forms import given_state
from lagrange.problem.load_context import SpokenName
from lagrange.problem.model import Problem


def test_numbers_and_names_in_words() -> None:
    assert [in_words(n, "relation") for n in (0, 1, 2, 13)] == [
        "no relation", "one relation", "two relations", "13 relations",
    ]  # fmt: skip
    assert spoken("upper_rod") == "upper rod"
    assert spoken("no_slip.2") == "no slip 2"
    both = constraints_called(["no_slip.1", "no_slip.2", "upper_rod"])
    assert both == "the first and second no-slip and upper-rod constraints"
    assert constraints_called(["plane1", "S1"]) == "the plane 1 and S1 constraints"


@pytest.mark.parametrize(
    ("noun", "name", "called"),
    [
        ("spring", "left", "left spring"),
        ("spring", "upper_spring", "upper spring"),
        ("force", "wind", "wind force"),
        ("force", "load", "load"),
        ("force", "P", "force P"),
        ("force", "push2", "force push2"),
        ("moment", "twist", "twist moment"),
        ("friction", "below", "friction below"),
    ],
)
def test_a_word_of_the_file_stands_before_its_noun(noun: str, name: str, called: str) -> None:
    assert qualified(noun, name) == called


@pytest.mark.parametrize(
    ("name", "words", "noun", "first"),
    [
        ("P1", "upper particle", "the upper particle", "the upper particle P1"),
        ("w", "a driving wheel", "the driving wheel", "the driving wheel w"),
        ("left", "left wheel", "the left wheel", "the left wheel"),
        ("T", "T-shaped rod", "the T-shaped rod", "the T-shaped rod T"),
        ("E", "Earth", "Earth", "Earth"),
        ("E", "the Earth", "the Earth", "the Earth E"),
        ("B", "Foucault's bob", "Foucault's bob", "Foucault's bob"),
        ("A", "body A", "body A", "body A"),
        ("P", "", "P", "P"),
    ],
)
def test_the_words_for_a_body_with_their_article(name: str, words: str, noun: str, first: str) -> None:
    called = SpokenName(name, words)
    assert (the(called), introduced(called), bare(called)) == (noun, first, words or name)


@pytest.mark.parametrize(
    ("value", "shown"), [("40 deg", "40*°"), ("0.7 rad", "0.7*rad"), ("2/9*pi", "2*pi/9"), ("theta_0", "theta_0")]
)
def test_an_initial_value_is_printed_as_the_file_gives_it(
    value: str, shown: str, problem: Callable[[str], Problem]
) -> None:
    text = f"""title: Pendulum let go
parameters: {{m: 2 kg, g: 9.81 m/s^2, l: 1.2 m, theta_0: positive}}
coordinates: [theta]
particles: {{P: {{mass: m, position: l*sin(theta)*i - l*cos(theta)*j}}}}
gravity: -g*j
initial: {{theta: {value}, theta': 0}}
"""
    [first, *_] = [p for p in at_start(given_state(problem(text))) if isinstance(p, Math)]
    assert str(first.sides[-1]) == shown


@pytest.mark.parametrize(
    ("value", "shown"), [("7/10", "0.7"), ("1/2", "1/2"), ("2/3", "2/3"), ("-9/4", "-9/4"), ("3", "3")]
)
def test_decimals_of_an_initial_state(value: str, shown: str) -> None:
    assert str(in_decimals(sp.Rational(value))) == shown
