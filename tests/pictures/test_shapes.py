"""Lines of action."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.shapes import line_of_action, push_sense
from lagrange.pictures.systems import system_in_file


def test_a_force_along_its_line_has_the_moment() -> None:
    line = line_of_action((0.0, 2.0, 0.0), (0.0, 0.0, 6.0))
    assert line is not None
    assert line.nearest == pytest.approx((3.0, 0.0, 0.0))  # 3 i × 2 j = 6 k
    assert line_of_action((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)) is None


@pytest.mark.parametrize(("relation", "sense"), [("x >= 0", 1), ("x <= 0", 1), ("x = 0", 0)])
def test_a_reaction_of_its_own_name_is_positive_in_contact(relation: str, sense: int) -> None:
    text = "title: T\nparameters: [m]\ncoordinates: [x, y]\nparticles: {P: {mass: m, position: x*i + y*j}}\n"
    named, multiplier = (
        system_in_file(
            kinematics_and_law(lagrange.loads(f"{text}constraints: {{wall: {{equation: {relation}{more}}}}}"))
        )
        for more in (", reaction: N", "")
    )
    assert named is not None
    assert multiplier is not None
    [own], [other] = named.newton.reactions, multiplier.newton.reactions
    assert push_sense(own) == sense
    assert push_sense(other) == (-1 if "<=" in relation else sense)
