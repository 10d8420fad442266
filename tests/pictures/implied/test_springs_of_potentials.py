"""Springs of which a file gives the energy alone: the walls, the places of rest, the order."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.springs_dampers import StretchedSpring
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.systems import SystemPicture, system_in_file

TWO = """
title: Two masses on {words}
parameters: [m, k, K, l]
coordinates: [x_1, x_2]
particles: {{A: {{mass: m, position: {a}}}, B: {{mass: m, position: {b}}}}}
forces: {{springs: {{potential: "{energy}"}}}}
"""
CHAIN = "k/2*(x_1^2 + (x_2 - x_1)^2 + x_2^2)"


def system(energy: str, words: str = "springs", a: str = "x_1*i", b: str = "x_2*i") -> SystemPicture:
    text = TWO.format(energy=energy, words=words, a=a, b=b)
    found = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert found is not None
    return found


def ends(drawn: SystemPicture, spring: StretchedSpring) -> list[tuple[float, ...]]:
    places = {p.name: p.position for p in drawn.configuration.points}
    return [drawn.page(drawn.pose.at(e if isinstance(e, Vector) else places[e])) for e in spring.ends]


def test_a_chain_of_springs_runs_from_wall_to_wall() -> None:
    drawn = system(CHAIN)
    springs = drawn.springs
    assert [str(s.stiffness) for s in springs] == ["k", "k", "k"]
    along = [x for s in springs for x, _ in ends(drawn, s)]
    assert along == sorted(along)
    assert min(b - a for a, b in zip(along[::2], along[1::2], strict=True)) > 0.5


def test_what_hangs_does_so_downwards_from_the_ceiling() -> None:
    drawn = system("k*x_1^2/2 + K*(x_2 - x_1)^2/2", "springs that hang from a ceiling", "-x_1*j", "-x_2*j")
    first, second = drawn.springs
    heights = [y for s in (first, second) for _, y in ends(drawn, s)]
    assert heights == sorted(heights, reverse=True)
    assert isinstance(first.ends[0], Vector)
    assert not isinstance(second.ends[1], Vector)


def test_distances_with_a_natural_length_stay_as_they_are() -> None:
    drawn = system("k*(x_2 - x_1 - l)^2/2")
    [spring] = drawn.springs
    assert spring.ends == ("A", "B")
    assert [str(p.position.components[0]) for p in drawn.configuration.points] == ["x_1", "x_2"]


@pytest.mark.parametrize(
    ("energy", "words"),
    [
        (CHAIN, "a rail"),  # no springs
        ("k*x_1*x_2", "springs"),  # not the energy of springs
        ("k*x_1^4/4", "springs"),
        ("k/2*(x_1 + x_2)^2", "springs"),
    ],
)
def test_what_is_no_chain_of_springs_is_not_drawn_as_one(energy: str, words: str) -> None:
    assert system(energy, words).springs == ()


ONE = """
title: Block {words}
parameters: [m, k, K]
coordinates: [x]
particles: {{P: {{mass: m, position: x*i}}}}
forces: {{s: {{potential: k*x^2/2 + K*x^2/2}}}}
"""


def test_a_block_between_two_springs_has_one_on_either_side() -> None:
    for words, number in (("on a spring", 1), ("between two springs", 2)):
        found = system_in_file(kinematics_and_law(lagrange.loads(ONE.format(words=words))))
        assert found is not None
        assert len(found.springs) == number


PENDULUM = """
title: Elastic pendulum on a spring
parameters: [m, k, l, g]
coordinates: [r, theta]
particles: {bob: {mass: m, position: r*sin(theta)*i - r*cos(theta)*j}}
gravity: -g*j
forces: {s: {potential: k*(r - l)^2/2}}
"""


def test_a_spring_may_turn() -> None:
    found = system_in_file(kinematics_and_law(lagrange.loads(PENDULUM)))
    assert found is not None
    [spring] = found.springs
    assert spring.ends == (Vector.zero(), "bob")
