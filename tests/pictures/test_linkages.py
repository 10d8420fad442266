"""The links of mechanisms that give no shapes."""

from __future__ import annotations

import math

import pytest

import lagrange
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.linkages import Links, links
from lagrange.pictures.systems import SystemPicture, system_in_file

FOUR_BAR = """
title: Linkage
axes: {i: right, j: up}
parameters: [a, b, c, d, m, J_1, J_2, J_3]
coordinates: [alpha, beta, gamma]
bodies:
  crank: {inertia: J_1, position: 0*i, angle: alpha}
  coupler: {mass: m, inertia: J_2, position: a*e1_crank + b/2*e1_coupler, angle: beta}
  rocker: {inertia: J_3, position: d*i, angle: SIGN*gamma}
constraints: {closure: a*e1_crank + b*e1_coupler = d*i + c*e1_rocker}
"""
CRANK = """
title: Crank and piston
axes: {i: right, j: up}
parameters: [J, r, l, m]
coordinates: [phi, x]
bodies: {crank: {inertia: J, position: 0*i, angle: phi}}
particles: {piston: {mass: m, position: x*i}}
constraints: {rod: CONSTRAINT}
"""


def found(text: str) -> tuple[SystemPicture, Links]:
    system = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert system is not None
    return system, links(system)


@pytest.mark.parametrize("sign", ["1", "-1"])
def test_each_link_of_a_closed_chain_has_its_length_and_meets_the_next(sign: str) -> None:
    system, chain = found(FOUR_BAR.replace("SIGN", sign))
    number = {s.name: v for s, v in system.pose.values.items()}
    for name, length in (("crank", "a"), ("coupler", "b"), ("rocker", "c")):
        start, end = chain.held[name]
        assert math.dist(start, end) == pytest.approx(number[length])
    assert chain.held["crank"][0] == pytest.approx((0, 0, 0))
    assert chain.held["crank"][1] == pytest.approx(chain.held["coupler"][0])
    assert chain.held["coupler"][1] == pytest.approx(chain.held["rocker"][1])
    assert chain.held["rocker"][0] == pytest.approx((number["d"], 0, 0))


def test_a_connecting_rod_leads_to_the_pin_of_the_crank() -> None:
    system, mechanism = found(CRANK.replace("CONSTRAINT", "(x - r*cos(phi))^2 + r^2*sin(phi)^2 = l^2"))
    number = {s.name: v for s, v in system.pose.values.items()}
    [(pin, piston)] = mechanism.rods
    r, phi = number["r"], number["phi"]
    assert pin == pytest.approx((r * math.cos(phi), r * math.sin(phi), 0))
    assert piston == pytest.approx((number["x"], 0, 0))
    assert mechanism.held["crank"] == (pin,)


@pytest.mark.parametrize("constraint", ["x = r*cos(phi)", "x = r*phi", "x = r*cos(phi) + l"])
def test_no_rod_is_seen_where_there_is_none(constraint: str) -> None:
    _, mechanism = found(CRANK.replace("CONSTRAINT", constraint))  # x = r cos φ is at r/2 from the middle of the crank
    assert mechanism.rods == ()
