"""What the result says: quasi-velocities that can change in one sense only."""

from __future__ import annotations

from pathlib import Path

import pytest

from lagrange.document.derivation import Detail
from lagrange.explain.report import report
from lagrange.problem.loader import load
from lagrange.render import terminal
from tests.support.shared import SHIPPED

SLEIGH = SHIPPED["sleigh"].read_text()


def page(text: str, folder: Path) -> str:
    file = folder / "sleigh.yaml"
    file.write_text(text)
    r = report(load(str(file)), complete=False)
    return " ".join(terminal.text(r.derivation, r.notation, 400, Detail.STEPS).split())


@pytest.mark.parametrize(
    ("centre", "said"),
    [
        ("+ a*e1_sleigh", "u̇ = a ω², which is never negative: u only grows, or is constant while ω = 0."),
        ("- a*e1_sleigh", "u̇ = −a ω², which is never positive: u only falls, or is constant while ω = 0."),
    ],
)
def test_a_rate_of_one_sign(centre: str, said: str, tmp_path: Path) -> None:
    """The mass centre before the blade, and behind it."""
    text = SLEIGH.split("figure:")[0].replace("+ a*e1_sleigh", centre)
    assert said in page(text, tmp_path)


def test_nothing_is_said_of_a_rate_of_either_sign(tmp_path: Path) -> None:
    text = SLEIGH.split("figure:")[0].replace("a: {assume: positive, ", "a: {assume: real, ")
    assert "One way" not in page(text, tmp_path)
