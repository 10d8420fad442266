"""Numbers for parameters have the sign or the range that is declared."""

from __future__ import annotations

from random import Random

import sympy as sp

from lagrange.core.symbols import Bounded, Sign
from lagrange.mechanics.equilibrium.limits import BOX
from lagrange.mechanics.equilibrium.searched.random_starts import random_start, random_value

THETA, X, FORCE = sp.symbols("theta x F", real=True)


def test_parameters() -> None:
    random = Random(1)
    for _ in range(20):
        assert random_value(sp.Symbol("m", positive=True), 2, random) > 0
        assert random_value(sp.Symbol("n", negative=True), 2, random) < 0
        assert random_value(Sign("sigma"), 2, random) in (-1, 1)
        assert 0 < random_value(Bounded("alpha", sp.S.Zero, sp.pi / 2), 2, random) < 1.5708
    assert {random_value(sp.Symbol("c", real=True), 1, random) > 0 for _ in range(20)} == {True, False}


def test_places() -> None:
    random = Random(1)
    assert random_start(FORCE, [THETA, X], [THETA], random) == 0
    assert max(abs(random_start(X, [THETA, X], [THETA], random)) for _ in range(50)) <= BOX
    assert max(abs(random_start(THETA, [THETA, X], [THETA], random)) for _ in range(50)) > BOX
