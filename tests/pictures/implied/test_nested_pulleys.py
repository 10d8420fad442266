"""Atwood's double machine: what hangs where, and when it is one."""

from __future__ import annotations

import pytest

from lagrange.document.names import Notation
from lagrange.document.scene import StrokeKind
from lagrange.pictures.implied.nested_pulleys import nested_pulleys
from lagrange.pictures.system_drawing import configuration_scene
from lagrange.pictures.systems import is_string
from tests.support.drawings import drawing_of

MACHINE = """
parameters: [m_1, m_2, m_3, g, L_1, L_2]
coordinates: [x, z, y_2, y_3]
particles:
  first: {mass: m_1, position: -x*j}
  second: {mass: m_2, position: -y_2*j}
  third: {mass: m_3, position: -y_3*j}
constraints:
  rope: x + z = L_1
  cord: y_2 - z + y_3 - z = L_2
gravity: -g*j
"""


def test_everything_hangs_beside_each_other_below_its_pulley() -> None:
    drawn = drawing_of("Machine with two ropes", MACHINE)
    places = {p.name: drawn.page(drawn.pose.at(p.position)) for p in drawn.configuration.points}
    first, second, third = (places[n] for n in ("first", "second", "third"))
    assert first[0] < second[0] - 0.5 < third[0] - 1.0 or first[0] > second[0] + 0.5 > third[0] + 1.0
    values = {q.name: x for q, x in drawn.pose.values.items()}
    assert 0 < values["z"] < min(values["y_2"], values["y_3"])
    scene = configuration_scene(drawn, Notation(), with_loads=False)
    assert scene is not None
    strings = [line for line in scene.lines if line.kind is StrokeKind.STRING]
    assert len(strings) == 4
    for line in strings:  # all of them straight down
        assert abs(line.points[0][0] - line.points[-1][0]) < 1e-6
    assert sum(d.open for d in scene.dots) == 2  # the axles


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("y_2 - z + y_3 - z = L_2", "y_2 - z + 2*(y_3 - z) = L_2"),
        ("x + z = L_1", "x + 2*z = L_1"),
        ("x + z = L_1", "x + y_2 = L_1"),
        ("-y_3*j", "-(y_3 + z)*j"),
    ],
)
def test_nothing_else_is_one(old: str, new: str) -> None:
    for text, found in ((MACHINE, True), (MACHINE.replace(old, new), False)):
        drawn = drawing_of("Machine with two ropes", text)
        strings = [r for r in drawn.newton.reactions if is_string(r)]
        assert (nested_pulleys(drawn.configuration, strings) is not None) is found
