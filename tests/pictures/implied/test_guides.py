"""What guides systems that coordinates alone keep: hoops, surfaces, cylinders, couplers, struts."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.implied.body_shapes import with_implied_shapes
from lagrange.pictures.implied.guides import couplers, cylinders_touched, hoops, struts, surface_of_coordinates
from lagrange.pictures.systems import SystemPicture, system_in_file

RINGS = """
title: Two rings joined by a rod on a {hoop}
axes: {{i: right, j: up}}
parameters: {{W: positive, R: positive, b: acute}}
coordinates: [theta]
particles:
  A: {{position: R*sin(theta - b)*i - R*cos(theta - b)*j}}
  B: {{position: R*sin(theta + b)*i - R*cos(theta + b)*j}}
forces: {{w: {{on: A, vector: -W*j}}}}
find: equilibrium
"""
CONE = """
title: Particle in a {cone}
axes: {{k: up}}
parameters: {{m: positive, g: positive, alpha: acute}}
coordinates: [r, phi]
particles: {{P: {{mass: m, position: "r*sin(alpha)*(cos(phi)*i + sin(phi)*j) + r*cos(alpha)*k"}}}}
gravity: -g*k
"""
PLANK = """
title: Plank that rocks on a {cylinder}
axes: {{i: right, j: up}}
parameters: {{m: positive, l: positive, R: positive, g: positive}}
coordinates: {{theta: {{range: [-60 deg, 60 deg]}}}}
let: {{n: sin(theta)*i + cos(theta)*j, s: cos(theta)*i - sin(theta)*j}}
bodies: {{plank: {{mass: m, inertia: m*l^2/12, position: R*n - {along}*s, angle: -theta}}}}
gravity: -g*j
"""
LINKS = """
title: Two bars
axes: {i: right, j: up}
parameters: {P: positive, l: positive}
unknowns: [M]
coordinates: {theta: {range: [0, 90 deg]}}
bodies: {AB: {position: l/2*cos(theta)*i + l/2*sin(theta)*j, angle: theta, shape: {rod: [O, l*cos(theta)*i + l*sin(theta)*j]}}}
particles: {D: {position: 2*l*cos(theta)*i}}
forces: {push: {on: D, vector: -P*i}, couple: {on: AB, moment: -M*k}}
find: equilibrium
"""
RHOMBUS = """
title: Rhombus of rods with a strut
axes: {i: right, j: down}
parameters: [W, l, b]
coordinates: {theta: {range: [0, 90 deg]}}
particles:
  B: {position: "[-l*sin(theta), l*cos(theta)]"}
  D: {position: "[l*sin(theta), l*cos(theta)]"}
  C: {position: "[0, 2*l*cos(theta)]"}
constraints: {strut: {equation: "norm(r_D - r_B) = b", reaction: S, by: rod}}
forces: {w: {on: C, vector: W*e_y}}
find: equilibrium
"""


def system(text: str) -> SystemPicture:
    found = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert found is not None
    return with_implied_shapes(found)


def test_a_hoop_is_the_circle_on_which_several_particles_move_if_the_text_has_one() -> None:
    drawn = system(RINGS.format(hoop="hoop"))
    [(centre, radius)] = hoops(drawn)
    for p in drawn.configuration.points:
        assert math.dist(drawn.pose.at(p.position), centre) == pytest.approx(radius)
    assert not hoops(system(RINGS.format(hoop="frame")))


def test_a_cone_is_made_of_the_places_that_its_coordinates_reach() -> None:
    drawn = system(CONE.format(cone="smooth cone"))
    [p] = drawn.configuration.points
    grid = surface_of_coordinates(drawn, p)
    slope = drawn.pose.number(next(s.symbol for s in drawn.problem.parameters if str(s.symbol) == "alpha"))
    assert all(math.hypot(x, y) == pytest.approx(z * math.tan(slope), abs=1e-9) for row in grid for x, y, z in row)
    assert max(z for row in grid for _, _, z in row) > drawn.pose.at(p.position)[2]
    assert not surface_of_coordinates(system(CONE.format(cone="plane that turns")), p)


def test_a_plank_that_rolls_touches_a_cylinder_and_one_that_does_not_touches_none() -> None:
    drawn = system(PLANK.format(cylinder="cylinder", along="R*theta"))
    [(centre, radius)] = cylinders_touched(drawn)
    assert centre == pytest.approx((0.0, 0.0, 0.0), abs=1e-6)
    size = next(s.symbol for s in drawn.problem.parameters if str(s.symbol) == "R")
    assert radius == pytest.approx(drawn.pose.number(size))
    assert not [*cylinders_touched(system(PLANK.format(cylinder="table", along="R*theta")))]


def test_a_coupler_leads_from_the_end_of_a_bar_to_what_stays_at_a_distance_from_it() -> None:
    drawn = system(LINKS)
    [(end, other)] = couplers(drawn)
    assert other == drawn.pose.at(drawn.configuration.points[-1].position) or other[1] == pytest.approx(0.0)
    assert math.dist(end, other) == pytest.approx(math.dist(end, (0.0, 0.0, 0.0)))


def test_a_strut_that_keeps_the_only_coordinate_is_drawn_and_the_rods_beside_it_are_found() -> None:
    drawn = system(RHOMBUS)
    [(first, second, string)] = struts(drawn)
    places = {p.name: drawn.pose.at(p.position) for p in drawn.configuration.points}
    assert {first, second} == {places["B"], places["D"]}
    assert not string
    assert {frozenset(pair[:2]) for pair in drawn.kept_distances} == {frozenset("BC"), frozenset("CD")}


def test_a_plank_leans_on_the_pipe_of_its_constraint() -> None:
    text = """
title: Plank on a {pipe}
parameters: [W, L, R]
coordinates: {{x: {{}}, y: {{}}, theta: {{range: [0, pi/2]}}}}
bodies:
  plank: {{position: x*i + y*j, angle: theta, shape: {{rod: [r_plank - L/2*e1_plank, r_plank + L/2*e1_plank]}}}}
constraints:
  floor: {{equation: "dot(r_plank - L/2*e1_plank, j) >= 0"}}
  prop: {{equation: "dot(r_plank - R*j, e2_plank) >= R"}}
forces: {{weight: {{on: plank, vector: -W*j}}}}
find: equilibrium
"""
    for pipe, number in (("pipe", 1), ("block", 0)):
        found = system_in_file(kinematics_and_law(lagrange.loads(text.format(pipe=pipe))))
        assert found is not None
        assert len([*cylinders_touched(with_implied_shapes(found))]) == number
