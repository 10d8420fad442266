"""Strings, arms, blocks and ground of a moving figure."""

from __future__ import annotations

import pytest

import lagrange
from lagrange.animation.elements import Elements
from lagrange.animation.inferred import add_inferred
from lagrange.mechanics.solution import kinematics_and_law
from lagrange.pictures.systems import system_in_file

CRANE = (
    "title: A load on a trolley, on a rail, by a rope\naxes: {i: right, j: down}\nparameters: [M, m, l, g]\n"
    "coordinates: [x, theta]\nparticles:\n  trolley: {mass: M, position: x*i}\n"
    "  load: {mass: m, position: (x + l*sin(theta))*i + l*cos(theta)*j}\ngravity: g*j\n"
)
WEIGHTS = (
    "title: Two weights\naxes: {i: right, j: down}\nparameters: [m, M, L, d, g]\ncoordinates: [x, y]\nparticles:\n"
    "  A: {mass: m, position: x*j}\n  B: {mass: M, position: d*i + y*j}\n"
    "constraints: {string: {equation: x + y = L, by: string}}\ngravity: g*j\n"
)
PENDULUM = (
    "title: Pendulum\naxes: {i: right, j: down}\nparameters: [m, l, g]\ncoordinates: [q]\n"
    "particles: {P: {mass: m, position: l*sin(q)*i + l*cos(q)*j}}\ngravity: g*j\n"
)


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        (CRANE, {"line": 1, "box": 1, "ground": 1}),
        (WEIGHTS, {"string": 1}),
        (PENDULUM, {"line": 1, "dot": 1, "wall": 1}),
    ],
)
def test_what_is_inferred_moves_too(text: str, kinds: dict[str, int]) -> None:
    system = system_in_file(kinematics_and_law(lagrange.loads(text)))
    assert system is not None
    elements = Elements(system, None)
    add_inferred(elements)
    drawn = [item["k"] for item in elements.items]
    assert {kind: drawn.count(kind) for kind in {*drawn}} == kinds


def test_a_string_over_pulleys_goes_through_where_its_coordinates_begin() -> None:
    system = system_in_file(kinematics_and_law(lagrange.loads(WEIGHTS)))
    assert system is not None
    elements = Elements(system, None)
    add_inferred(elements)
    [string] = elements.items
    x, y = system.configuration.slots.coordinates
    heights = [elements.cells.expressions[place + 1] for place in string["p"]]
    assert heights == [x, 0, 0, y]
