"""Combinations of forms that are differentials: they add up, and lie among the constraints."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import sympy as sp

from lagrange.core.symbols import t
from lagrange.mechanics.solution import solve
from lagrange.problem.model import Problem
from tests.support.exterior import rank
from tests.support.hidden_systems import (
    SYSTEMS,
    System,
    admissible_motion,
    forms_of,
    plain,
    somewhere,
)

Read = Callable[[str], Problem]


@pytest.mark.parametrize("system", [s for s in SYSTEMS if s.hidden and not s.start], ids=lambda s: s.name)
def test_gradients_are_in_the_row_space(problem: Read, system: System) -> None:
    """At random points, by singular values."""
    read = problem(system.text)
    rows = forms_of(read)
    for relation in solve(read).classification.hidden.found:
        gradient = [sp.diff(plain(relation.function), v) for v in (*read.slots.coordinates, t)]
        point = somewhere([*rows, gradient], system.name)
        assert rank([*rows, gradient], point) == rank(rows, point)


@pytest.mark.parametrize("system", [s for s in SYSTEMS if s.hidden], ids=lambda s: s.name)
def test_combinations_add_up(problem: Read, system: System) -> None:
    read = problem(system.text)
    found = solve(read).classification
    path = admissible_motion(system, read, 3)
    values = {s: sp.Float(v, 30) for s, v in path[0].items()}
    forms = [[plain(a) for a in c.row.form] for c in found.independent]
    for relation in found.hidden.found:
        if relation.combination is None:
            continue
        for k, v in enumerate((*read.slots.coordinates, t)):
            total = sp.Add(*(plain(c) * form[k] for c, form in zip(relation.combination, forms, strict=True)))
            assert abs((total - sp.diff(plain(relation.function), v)).xreplace(values).evalf(20)) < 1e-9
