"""Equations of motion as first-order equations."""

from __future__ import annotations

import numpy as np
import pytest

from tests.programs.test_simulation import moved, of


def test_all_coordinates_give_one_motion() -> None:
    choice = moved("ex18-double-pendulum", 5.0, "phi1=0.9", "phi2=1.4", "phi1'=0.3", samples=51)
    own = moved("ex18-double-pendulum", 5.0, "phi1=0.9", "phi2=1.4", "phi1'=0.3", choice="", samples=51)
    assert choice.names == ("phi1", "phi2", "phi1'", "phi2'")
    assert len(own.names) == 8
    for name in ("x1", "y1", "x2", "y2", "x2'"):
        assert np.abs(of(choice, name) - of(own, name)).max() < 1e-6
    for name in ("T_upper_rod", "T_lower_rod"):
        tension = choice.along(choice.equations.reactions[name])
        assert np.abs(tension - own.along(own.equations.reactions[name])).max() < 1e-4


def test_constraints_do_not_drift() -> None:
    motion = moved("ex18-double-pendulum", 50.0, "phi1=0.9", choice="", samples=200)
    assert motion.violation < 1e-10
    assert motion.drift["energy"] < 1e-6


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("ex17-spherical-pendulum", ("phi'=2",)),
        ("heavy-top", ("psi'=20",)),
        ("rolling-disc", ()),
        ("cylinder-on-rough-incline", ()),
    ],
)
def test_what_is_conserved_stays(name: str, settings: tuple[str, ...]) -> None:
    motion = moved(name, 20.0, *settings)
    assert motion.drift
    assert max(motion.drift.values()) < 1e-7
    assert motion.is_accurate
