"""The threshold of a sleeping axis, against the linear equations of the horizontal components in numbers."""

from __future__ import annotations

import pytest

from lagrange.mechanics.consequences.sleeping import sleeping_axis
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("name", "more", "less"),
    [
        ("ball-on-a-ball", "b**2*n**2", "35*a*g"),  # Routh
        ("heavy-top", "C**2*n**2", "4*g*l*m*(A + l**2*m)"),  # Goldstein, section 5.7, with A about the mass centre
    ],
)
def test_what_stands_upright_by_its_spin(name: str, more: str, less: str) -> None:
    solution = solved(name)
    found = sleeping_axis(solution, solution.chosen, "n")
    assert found is not None
    assert (str(found.more), str(found.less)) == (more, less)


@pytest.mark.parametrize("name", ["euler-rigid-body", "suslov-body", "rolling-disc", "gyrocompass"])
def test_what_does_not(name: str) -> None:
    solution = solved(name)
    assert sleeping_axis(solution, solution.chosen, "n") is None
