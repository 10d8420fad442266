"""Rods whose ends the text names by letters."""

from __future__ import annotations

import pytest

from lagrange.document.scene import StrokeKind
from lagrange.pictures.implied.lettered import lettered, rods_between_letters
from tests.support.drawings import drawing_of, lines_of, sketched

DRIVEN = """
description: The crank OA turns uniformly. {words}
parameters: [r, l, m, w]
coordinates: [x]
let: {{A: r*cos(w*t)*i + r*sin(w*t)*j}}
particles: {{piston: {{mass: m, position: x*i}}}}
constraints: {{rod: norm(r_piston - A) = l}}
"""
TURNED = """
description: The crank OA of length r is turned, and the rod AB of length l moves the slider B.
parameters: [r, l, m, J]
coordinates: [phi, x]
let: {A: r*cos(phi)*i + r*sin(phi)*j}
bodies: {crank: {inertia: J, position: 0*i, angle: phi}}
particles: {slider: {mass: m, position: x*i}}
constraints: {rod: norm(r_slider - A) = l}
"""


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("The connecting rod AB moves the piston B.", [("O", "A", False), ("A", "B", False)]),
        ("A string AB pulls the piston B.", [("O", "A", False), ("A", "B", True)]),
        ("The piston moves in a guide.", [("O", "A", False)]),
        ("The rod OB is the path of the piston B.", [("O", "A", False)]),  # its length changes
    ],
)
def test_rods_between_letters_have_constant_lengths(words: str, expected: list[tuple[str, str, bool]]) -> None:
    system = drawing_of("Crank", DRIVEN.format(words=words))
    assert [*rods_between_letters(system.problem, system.pose)] == expected


def test_a_particle_has_the_letter_that_follows_its_name() -> None:
    system = drawing_of("Crank", DRIVEN.format(words="The piston B moves in a guide of length L = 2 m."))
    assert {*lettered(system.problem, system.configuration)} == {"O", "A", "B"}


def test_a_driven_crank_and_its_rod_are_drawn_with_the_letter_of_their_joint() -> None:
    scene = sketched("Crank", DRIVEN.format(words="The connecting rod AB moves the piston B."))
    crank, rod = (line.points for line in lines_of(scene, StrokeKind.ROD))
    assert crank[1] == rod[0]
    assert "A" in {label.content for label in scene.labels}


def test_a_crank_that_is_a_body_goes_from_its_axis_to_its_joint() -> None:
    scene = sketched("Crank", TURNED)
    [rod] = lines_of(scene, StrokeKind.ROD)
    capsule = max((line for line in lines_of(scene, StrokeKind.BODY) if line.closed), key=lambda c: len(c.points))
    low, high = min(y for _, y in capsule.points), max(y for _, y in capsule.points)
    assert low > -0.3
    assert high == pytest.approx(max(y for _, y in rod.points), abs=0.2)


HEXAGON = """
description: Uniform heavy rods hang from the fixed rod AB; a strut joins C and F.
parameters: [m, a, g]
coordinates: {phi: {range: [0, pi/2]}}
particles:
  BC: {mass: m, position: a*(1 + sin(phi))*i - a*cos(phi)*j}
  CD: {mass: m, position: a*(1 + sin(phi))*i - 3*a*cos(phi)*j}
  DE: {mass: m, position: -4*a*cos(phi)*j}
  EF: {mass: m, position: -a*(1 + sin(phi))*i - 3*a*cos(phi)*j}
  FA: {mass: m, position: -a*(1 + sin(phi))*i - a*cos(phi)*j}
  C: {position: a*(1 + 2*sin(phi))*i - 2*a*cos(phi)*j}
gravity: -g*j
find: equilibrium
"""


def test_rods_that_are_called_by_their_ends_close_a_hexagon() -> None:
    system = drawing_of("Hexagon", HEXAGON)
    pairs = {a + b for a, b, _ in rods_between_letters(system.problem, system.pose)}
    assert pairs == {"AB", "BC", "CD", "DE", "EF", "FA"}
    scene = sketched("Hexagon", HEXAGON)
    assert len(lines_of(scene, StrokeKind.ROD)) == 6
    assert lines_of(scene, StrokeKind.CURVE) == []
    assert {"A", "B", "D", "E", "F"} <= {label.content for label in scene.labels}
