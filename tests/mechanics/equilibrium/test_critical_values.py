"""Critical values of the one parameter without a value."""

from __future__ import annotations

import lagrange
from lagrange.explain.report import report
from lagrange.mechanics.equilibrium.critical_values import REVERSED
from lagrange.mechanics.solution import solve
from lagrange.render.json import as_object

COLUMN = """
title: Bar on a spring
parameters: {l: 2 m, c: 30 N m, P: {unit: N}}
coordinates: {theta: {unit: rad}}
particles: {top: {position: l*sin(theta)*i + l*cos(theta)*j}}
forces: {load: {on: top, vector: -P*j}, spring: {potential: c*theta^2/2}}
find: equilibrium
"""


def test_the_critical_load() -> None:
    said = str(as_object(report(lagrange.loads(COLUMN))))
    assert "'critical'" in said
    assert "15" in said  # P = c/l
    assert solve(lagrange.loads(COLUMN), complete=False).holds


def test_reversing_twice_changes_nothing() -> None:
    assert all(REVERSED[REVERSED[r]] == r for r in REVERSED)
