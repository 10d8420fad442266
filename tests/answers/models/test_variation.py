"""The words of a variation."""

from __future__ import annotations

import sympy as sp

from lagrange.answers.models.variation import Variation, called, written
from lagrange.core.symbols import Slots

theta = sp.Symbol("theta", real=True)
SLOTS = Slots((theta,))


def test_as_it_may_be_typed() -> None:
    assert called("rod") == "`rod`"
    assert written(SLOTS.velocities[0] ** 2 * sp.sin(theta), SLOTS) in ("theta'^2*sin(theta)", "sin(theta)*theta'^2")
    assert dict(Variation("c", "p").rule) == {}
