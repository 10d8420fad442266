"""How much is said of a wrong equation."""

from __future__ import annotations

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
    assert "a force term" in two
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
