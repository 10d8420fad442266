"""The state in which a system is drawn satisfies its constraints."""

from __future__ import annotations

import pytest
import sympy as sp

import lagrange
from lagrange.core.symbols import t
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.poses import Pose, general_pose
from tests.support.drawings import DRAWN, evaluated, system_of


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
