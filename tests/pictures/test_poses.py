"""The state in which a system is drawn satisfies its constraints."""

from __future__ import annotations

import pytest
import sympy as sp

import lagrange
from lagrange.core.symbols import t
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.limits import MOST_UNEQUAL
from lagrange.pictures.poses import Pose, general_pose
from tests.support.drawings import DRAWN, evaluated, system_of
from tests.support.figure_sheet import figures_of


@pytest.mark.parametrize("name", DRAWN)
def test_a_pose_satisfies_the_constraints(name: str) -> None:
    system = system_of(name)
    for f in system.configuration.finite_constraints:
        assert abs(evaluated(f, system)) < 1e-8


ONE = "parameters: [m, k, b, H, l, g]\ncoordinates: [x]\nparticles: {P: {mass: m, position: x*i}}\ngravity: g*j\n"


def pose_of(text: str) -> Pose:
    problem = lagrange.loads(f"title: T\n{text}")
    pose = general_pose(problem, kinematics_and_law(problem).own.configuration)
    assert pose is not None
    return pose


def test_a_support_beyond_a_body_stays_beyond() -> None:
    floor = pose_of(ONE + "forces: {s: {spring: k, between: [P, H*i], length: l}}\n")
    ceiling = pose_of(ONE + "forces: {s: {spring: k, between: [P, -H*i], length: l}}\n")
    driven = pose_of(ONE + "functions: {u: [t]}\nforces: {s: {spring: k, between: [P, u*i], length: l}}\n")
    for pose, beyond in ((floor, True), (ceiling, False), (driven, False)):
        [point] = pose.configuration.points
        [spring] = pose.configuration.springs
        assert (pose.at(spring.ends[1])[0] > pose.at(point.position)[0]) is beyond


def test_what_two_springs_hold_is_between_their_walls() -> None:
    left, right = "{spring: k, between: [-b*i, P], length: 0}", "{spring: k, between: [P, b*i], length: 0}"
    pose = pose_of(ONE + f"forces:\n  left: {left}\n  right: {right}\n")
    values = {str(s): v for s, v in pose.values.items()}
    assert abs(values["x"]) < values["b"]


def test_a_ball_is_small_in_its_bowl() -> None:
    text = (
        "parameters: [m, r, R, g]\ncoordinates: [q]\nparticles: {P: {mass: m, "
        "position: (R - r)*sin(q)*i + (R - r)*cos(q)*j}}\n"
    )
    values = {str(s): v for s, v in pose_of(text).values.items()}
    assert values["R"] - values["r"] >= 1.2 * values["r"]


@pytest.mark.parametrize(
    ("words", "sign"),
    [("It hangs from O.", -1), ("It slides in a bowl.", -1), ("It stands upright, unlike a pendulum.", 1)],
)
def test_what_hangs_is_below(words: str, sign: int) -> None:
    text = (
        f"title: Rod\ndescription: {words}\ngravity: -g*k\nparameters: [m, l, g]\ncoordinates: [x, y, z]\n"
        "particles: {P: {mass: m, position: x*i + y*j + z*k}}\nconstraints: {length: x^2 + y^2 + z^2 = l^2}\n"
    )
    problem = lagrange.loads(text)
    pose = general_pose(problem, kinematics_and_law(problem).own.configuration)
    assert pose is not None
    assert pose.values[sp.Symbol("z", real=True)] * sign > 0


def test_what_turns_with_time_is_seen_from_the_side() -> None:
    text = (
        "title: Governor\ngravity: -g*k\nparameters: [m, l, Omega, g]\ncoordinates: [theta]\nparticles:\n"
        "  P: {mass: m, position: l*sin(theta)*(cos(Omega*t)*i + sin(Omega*t)*j) - l*cos(theta)*k}\n"
    )
    problem = lagrange.loads(text)
    pose = general_pose(problem, kinematics_and_law(problem).own.configuration)
    assert pose is not None
    turned = pose.values[t] * next(v for s, v in pose.values.items() if s.name == "Omega")
    assert turned == pytest.approx(1.25)


@pytest.mark.parametrize(("radius", "pin"), [("150 mm", "60 mm"), ("3 m", "1.2 m")])
def test_lengths_with_values_are_drawn_in_proportion_and_as_large_as_others(radius: str, pin: str) -> None:
    """A disc of 150 mm hung 60 mm from its centre is the picture of one of 3 m hung 1.2 m from it."""
    text = (
        f"title: Disc\ngravity: g*j\naxes: {{j: down}}\nparameters: {{m: 2 kg, R: {radius}, d: {pin}, g: 9.81 m/s^2}}\n"
        "coordinates: [theta]\nbodies:\n  disc: {mass: m, inertia: m*R^2/2, angle: -theta,\n"
        "    position: d*sin(theta)*i + d*cos(theta)*j}\n"
    )
    configuration = kinematics_and_law(lagrange.loads(text)).own.configuration
    pose = general_pose(lagrange.loads(text), configuration)
    assert pose is not None
    values = {s.name: v for s, v in pose.values.items()}
    assert values["R"] == pytest.approx(2.0)
    assert values["d"] == pytest.approx(0.8)


def test_a_thin_axle_under_a_long_string_is_seen() -> None:
    text = (
        "title: Winch\naxes: {j: down}\ngravity: g*j\nparameters: {m: kg, r: 5 mm, L: 2 m, g: 9.81 m/s^2}\n"
        "coordinates: [phi]\nparticles: {P: {mass: m, position: r*i + (L - r*phi)*j}}\n"
    )
    problem = lagrange.loads(text)
    pose = general_pose(problem, kinematics_and_law(problem).own.configuration)
    assert pose is not None
    values = {s.name: v for s, v in pose.values.items()}
    assert values["L"] / values["r"] == pytest.approx(MOST_UNEQUAL)


def test_a_satellite_of_the_earth_is_drawn_though_the_force_has_large_numbers() -> None:
    text = (
        "title: Satellite\nparameters: {m: 500 kg, K: 398600 km^3/s^2}\ncoordinates: [r, phi]\n"
        "frame: {type: polar, coordinates: [r, phi]}\nparticles: {satellite: {mass: m, position: r*e_r}}\n"
        "forces: {earth: {on: satellite, vector: -K*m/r^2*e_r}}\n"
    )
    [scene, *_] = figures_of(kinematics_and_law(lagrange.loads(text)))
    assert scene.dots


def test_what_strikes_is_drawn_where_it_touches() -> None:
    pose = pose_of(
        "axes: {i: right, j: up}\nparameters: {m: positive, l: positive, v: positive, beta: acute}\n"
        "coordinates: [x, y, theta]\nbodies: {rod: {mass: m, inertia: m*l^2/12, position: x*i + y*j, angle: theta}}\n"
        "impact:\n  before: {theta: beta, x': 0, y': -v, theta': 0}\n"
        "  constraints: {floor: {equation: y - l/2*sin(theta) >= 0, reaction: N}}\nfind: impact\n"
    )
    [rod] = pose.configuration.points
    slots = pose.configuration.slots.coordinates
    theta, l = slots[2], next(s for s in pose.values if str(s) == "l")
    assert abs(pose.at(rod.position)[1] - pose.number(l / 2 * sp.sin(theta))) < 1e-8


def test_a_spring_that_turns_has_no_sense_on_a_line() -> None:
    text = (
        "parameters: [m, k, l, g]\ncoordinates: [r, theta]\ngravity: -g*j\nparticles: {P: {mass: m, position: "
        "r*sin(theta)*i - r*cos(theta)*j}}\nforces: {s: {spring: k, between: [O, P], length: l}}\n"
    )
    assert pose_of(text).configuration.springs
