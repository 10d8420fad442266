"""Rods at rest, given by their centre and lettered ends: what they lie on."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.document.scene import StrokeKind
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.implied.rods_at_rest import Kind, contacts, rods_at_rest
from lagrange.pictures.systems import SystemPicture, system_in_file
from tests.support.figure_sheet import figures_of

ROD = """
title: {title}
description: A uniform rod AB of length 2l and weight W rests in equilibrium.
parameters: {{W: positive, l: positive, a: positive, R: positive, alpha: acute, beta: acute}}
coordinates: {{theta: {{range: [0, pi/2]}}}}
let:
  A: {start}
  B: A + 2*l*(cos(theta)*i + sin(theta)*j)
particles: {{centre: {{position: A + l*(cos(theta)*i + sin(theta)*j)}}}}
forces: {{weight: {{on: centre, vector: -W*j}}}}
find: equilibrium
"""
WALL = "-a*tan(theta)*j"
BOWL = "-R*cos(2*theta)*i - R*sin(2*theta)*j"
PLANES = "-2*l*sin(beta - theta)/sin(alpha + beta)*(cos(alpha)*i - sin(alpha)*j)"


def system(title: str, start: str) -> SystemPicture:
    found = system_in_file(kinematics_and_law(lagrange.loads(ROD.format(title=title, start=start))))
    assert found is not None
    return found


def kinds(title: str, start: str) -> list[Kind]:
    drawn = system(title, start)
    return [c.kind for c in contacts(drawn.problem, drawn.pose, drawn.rods_at_rest)]


@pytest.mark.parametrize(
    ("title", "start", "expected"),
    [
        ("Rod at a wall over a peg", WALL, [Kind.PLANE, Kind.PEG]),
        ("Rod at a wall", WALL, [Kind.PLANE]),
        ("Rod in a bowl", BOWL, [Kind.ROUND]),
        ("Rod between two planes", PLANES, [Kind.PLANE, Kind.PLANE]),
        ("Rod hinged at A", "a*i", [Kind.HINGE]),
        ("Rod in equilibrium", WALL, []),
    ],
)
def test_what_the_text_speaks_of_and_the_positions_show_is_drawn(title: str, start: str, expected: list[Kind]) -> None:
    assert kinds(title, start) == expected


def test_a_peg_is_on_its_rod_and_a_plane_below_its_end() -> None:
    drawn = system("Rod at a wall over a peg", WALL)
    wall, peg = contacts(drawn.problem, drawn.pose, drawn.rods_at_rest)
    first, second = (drawn.pose.at(end) for end in drawn.rods_at_rest[0].ends)
    assert math.dist(first, peg.at) + math.dist(peg.at, second) == pytest.approx(math.dist(first, second))
    assert peg.at[0] == pytest.approx(drawn.pose.values[next(s for s in drawn.pose.values if s.name == "a")])
    assert wall.inward == pytest.approx((1.0, 0.0, 0.0))


def test_the_rim_of_a_bowl_is_no_peg_and_the_rod_leans_over_it() -> None:
    drawn = system("Rod over the rim of a bowl", BOWL)
    [bowl] = contacts(drawn.problem, drawn.pose, drawn.rods_at_rest)
    radius = drawn.pose.values[next(s for s in drawn.pose.values if s.name == "R")]
    high = max((drawn.pose.at(end) for end in drawn.rods_at_rest[0].ends), key=lambda p: p[1])
    assert (bowl.kind, bowl.centre) == (Kind.ROUND, pytest.approx((0.0, 0.0, 0.0)))
    assert high[1] > 0
    assert math.hypot(*high) > radius


def test_the_ends_have_their_letters_and_the_angle_is_at_the_lower_one() -> None:
    solution = kinematics_and_law(lagrange.loads(ROD.format(title="Rod at a wall over a peg", start=WALL)))
    scene, *_ = figures_of(solution)
    labels = {str(label.content): label.at for label in scene.labels}
    assert {"A", "B", "theta"} <= {*labels}
    assert math.dist(labels["theta"], labels["A"]) < math.dist(labels["theta"], labels["B"])
    assert any(line.kind is StrokeKind.GROUND for line in scene.lines)


def test_a_joint_of_a_frame_is_the_middle_of_no_rod() -> None:
    text = ROD.format(title="Rods", start=WALL).replace("A + l*(cos(theta)*i + sin(theta)*j)", "B")
    problem = lagrange.loads(text)
    drawn = system_in_file(kinematics_and_law(problem))
    assert drawn is not None
    assert rods_at_rest(problem, drawn.pose) == ()
