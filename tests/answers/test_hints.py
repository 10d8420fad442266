"""How much is said of a wrong equation."""

from __future__ import annotations

import json
import re

import pytest
from click.testing import CliRunner

from lagsolve.main import main


def said(*arguments: str) -> str:
    """What is printed, its long lines put together again."""
    shown = CliRunner().invoke(main, ["check", "ex11-ideal-pendulum", *arguments], env={"COLUMNS": "200"}).stdout
    return re.sub(r"\n {6}(?! )", " ", shown)


def test_hints_go_from_the_vague_to_the_frank() -> None:
    one, two, three = (said("-e", "theta'' = 0", "--hint", str(n)) for n in (1, 2, 3))
    assert "force" not in one
    assert "A force term" in two
    assert "sin(" not in two
    assert "g*sin(theta)/l is missing" in three
    assert three == said("-e", "theta'' = 0")


@pytest.mark.parametrize("arguments", [("--hint", "1"), ("--hint", "2"), (), ("--format", "json")])
@pytest.mark.parametrize("equation", ["theta'' = 0", "theta''^2 = 3", "x'' = 0", "theta'' = g*sin(theta)", "1 = 0"])
def test_the_equation_asked_for_is_never_shown_unasked(equation: str, arguments: tuple[str, ...]) -> None:
    shown = said("-e", equation, *arguments)
    assert "l*theta'' + g*sin(theta)" not in shown
    assert "x*y''" not in shown


def test_it_is_shown_when_asked_for() -> None:
    assert "the derived equations:\n  l*theta'' + g*sin(theta) = 0\n" in said("-e", "theta'' = 0", "--reveal")
    assert '"reference": [\n  "l*theta\'\' + g*sin(theta) = 0"\n ]' in said(
        "-e", "theta'' = 0", "--reveal", "--format", "json"
    )


def test_json_names_the_cause_only_where_all_may_be_said() -> None:
    def first(*more: str) -> dict[str, str]:
        found = json.loads(said("-e", "theta'' = 0", "--format", "json", *more))
        equation: dict[str, str] = found["equations"][0]
        return equation

    assert first()["model"] == "gravity left out"
    assert first()["cause"] == "without gravity"
    assert not {"cause", "model"} & first("--hint", "2").keys()
    right = json.loads(said("-e", "l*theta'' + g*sin(theta) = 0", "--format", "json"))
    assert right["equations"][0].keys() == {"text", "verdict", "diagnosis", "remarks"}


@pytest.mark.parametrize(
    ("equation", "sentences"),
    [
        (
            "theta'' = g/l*sin(theta)",
            "This is the equation for gravity that acts the other way, or for theta measured from the opposite "
            "direction. One change makes it right: the sign of the term g*sin(theta)/l.",
        ),
        (
            "theta'' = 0",
            "This is the equation without gravity. One change makes it right: g*sin(theta)/l is missing on its left "
            "side.",
        ),
    ],
)
def test_at_most_the_cause_and_the_place_are_said(equation: str, sentences: str) -> None:
    assert said("-e", equation).endswith(f" {sentences}\n")
