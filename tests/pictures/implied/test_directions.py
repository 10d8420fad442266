"""The unit vectors that a file names, in its figure."""

from __future__ import annotations

from lagrange.core.symbols import UnitVector
from tests.support.drawings import sketched

PENDULUM = """
parameters: [m, l, g]
coordinates: [theta]
axes: {i: right, j: up}
let: {e: sin(theta)*i - cos(theta)*j, n: cos(theta)*i + sin(theta)*j, twice: 2*sin(theta)*i - 2*cos(theta)*j, up: 1*j}
particles: {P: {mass: m, position: l*e}}
gravity: -g*j
"""


def test_unit_vectors_that_turn_stand_at_their_particle() -> None:
    scene = sketched("Pendulum", PENDULUM)
    at = {w.content.name: w.at for w in scene.labels if isinstance(w.content, UnitVector)}
    assert {"e", "n"} <= {*at}
    assert not {"twice", "up"} & {*at}  # not of length 1; always the same direction
    x, y = next(w.at for w in scene.labels if w.content == "P")
    for name in ("e", "n"):
        assert abs(at[name][0] - x) + abs(at[name][1] - y) < 2.5
