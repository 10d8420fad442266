"""Constants that a picture needs: strings side by side, weights below their pulley."""

from __future__ import annotations

import lagrange
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.implied.side_by_side import DROP
from lagrange.pictures.systems import SystemPicture, system_in_file

ATWOOD = """
title: Weights over a pulley
axes: {i: right, j: down}
parameters: [m_1, m_2, M, R, g]
coordinates: [y_1, y_2, phi]
particles:
  A: {mass: m_1, position: R*i + y_1*j}
  B: {mass: m_2, position: -R*i + y_2*j}
bodies: {pulley: {mass: M, inertia: M*R^2/2, position: 0*i, angle: phi}}
constraints: {cord_A: y_1 = R*phi, cord_B: y_2 = -R*phi}
gravity: g*j
"""
SPRING = """
title: A spring on a string
axes: {j: down}
parameters: [m, M, c, b, L, g]
coordinates: [x, y, s]
particles: {block: {mass: M, position: x*j}, end: {position: y*j}, bob: {mass: m, position: (y + s)*j}}
constraints: {string: {equation: x + y = L, reaction: T}}
gravity: g*j
forces: {spring: {spring: c, between: [end, bob], length: b, sense: positive}}
"""


def system(text: str) -> SystemPicture:
    found = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert found is not None
    return found


def test_both_weights_hang_below_the_axle_of_their_pulley() -> None:
    drawn = system(ATWOOD)
    heights = {p.name: drawn.page(drawn.pose.at(p.position))[1] for p in drawn.configuration.points}
    assert max(heights["A"], heights["B"]) < heights["pulley"] - 0.5
    moved = {p.name: p.position for p in drawn.configuration.points}
    assert moved["A"].components[1].subs({"y_1": 0}) == DROP or str(DROP) in str(moved["A"].components[1])


def test_a_single_weight_on_a_drum_stays_where_its_coordinate_says() -> None:
    one = "\n".join(line for line in ATWOOD.splitlines() if "B:" not in line)
    one = one.replace("y_1, y_2, phi", "y_1, phi").replace(", cord_B: y_2 = -R*phi", "")
    drawn = system(one)
    assert all(str(DROP) not in str(p.position.components[1]) for p in drawn.configuration.points)


def test_what_hangs_on_one_part_of_a_string_is_on_one_side() -> None:
    drawn = system(SPRING)
    sides = {p.name: drawn.page(drawn.pose.at(p.position))[0] for p in drawn.configuration.points}
    assert sides["end"] == sides["bob"]
    assert abs(sides["block"] - sides["bob"]) > 0.3


def test_weights_that_the_angle_of_a_pulley_moves_hang_below_it_on_a_rope() -> None:
    text = """
title: Two weights on a {rope}
parameters: [m_1, m_2, J, R, g]
coordinates: [phi]
bodies: {{pulley: {{inertia: J, position: 0*i, angle: phi}}}}
particles: {{A: {{mass: m_1, position: -R*i - R*phi*j}}, B: {{mass: m_2, position: R*i + R*phi*j}}}}
gravity: -g*j
"""
    for rope, below in (("rope", True), ("wheel", False)):
        drawn = system(text.format(rope=rope))
        heights = [drawn.pose.at(p.position)[1] for p in drawn.configuration.points if p.mass != 0]
        assert (max(heights) < 0) is below
