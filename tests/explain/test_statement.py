"""The statement of a problem."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Display, Rule
from lagrange.document.math_writer import unicode
from tests.support.derivation_text import words
from tests.support.shared import reported


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("chapter6/ex07-constant-coefficients", "Time appears explicitly in the finite form of the rates constraint"),
        ("constraints/rocking-plane", "Time appears explicitly in the plane constraint"),
        ("constraints/steered-blade", "Time appears explicitly in the blade constraint"),
        ("constraints/rolling-ball", "The no-slip 1 and no-slip 2 constraints"),
    ],
)
def test_how_time_enters(name: str, said: str) -> None:
    steps = reported(name).derivation.steps
    [classification] = [s for s in steps if s.rule is Rule.CLASSIFICATION]
    assert said in words(classification)


def test_the_statement_says_what_the_file_writes_for_short() -> None:
    statement = reported("chapter6/ex05-ice-skate").derivation.steps[0]
    [line] = [e for b in statement.body if isinstance(b, Display) for e in b.equations]
    assert [unicode(s) for s in line.sides] == ["n", "sin θ i − cos θ j"]
    forces = reported("chapter6/ex02-fixed-surface").derivation.steps[0]
    assert "F_x, F_y and F_z are unspecified functions of x, y, z, ẋ, ẏ, ż and t." in words(forces)
