"""Hamilton's function, impacts and steady motions in JSON."""

from __future__ import annotations

from lagrange.document.math_writer import text
from lagrange.render.json_momenta import beside_motion
from tests.support.shared import solved


def test_only_what_is_asked_for_has_a_key() -> None:
    assert beside_motion(solved("ex11-ideal-pendulum"), text) == {}
    assert set(beside_motion(solved("bead-in-a-turning-tube"), text)) == {"hamiltonian"}
    impact = beside_motion(solved("rod-caught-at-an-end"), text)["impact"]
    assert {"velocities", "impulses", "energy_lost"} <= set(impact)
