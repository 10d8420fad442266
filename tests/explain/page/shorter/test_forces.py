"""Constant forces by the accelerations where they are long by parameters alone."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.document.derivation import Display, Rule
from lagrange.explain.page.shorter.forces import in_accelerations
from tests.support.shared import reported, solved


@pytest.mark.parametrize("name", ["double-atwood"])
def test_the_tensions_of_two_pulleys(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.SOLVED_REACTIONS and not s.folded]
    [box] = [b for b in step.body if isinstance(b, Display) and b.boxed]
    said = {str(e.sides[0]): e.sides[1] for e in box.equations}
    names = {s.name: s for e in said.values() for s in e.free_symbols}
    assert sp.expand(said["F1"] - names["m1"] * (names["g"] - names["R"] * names["alpha''"])) == 0
    pulled = said["F2"] - names["m2"] * (names["g"] + names["R"] * names["alpha''"] + names["r"] * names["beta''"])
    assert sp.expand(pulled) == 0


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_short_forces_stay(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.SOLVED_REACTIONS and not s.folded]
    solution = solved(name, complete=False)
    assert in_accelerations(solution, step, solution.chosen) is step
