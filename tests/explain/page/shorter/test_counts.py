"""Unknowns and equations of bodies, in a line that agrees with the full count."""

from __future__ import annotations

import pytest

from lagrange.document.builders import prose
from lagrange.document.derivation import Prose, Rule, Step
from lagrange.explain.page.shorter.counts import counted_shortly
from tests.support.shared import reported, solved


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_the_count_of_a_cylinder(name: str) -> None:
    solution = solved(name, complete=False)
    full = next(s for s in reported(name, complete=False).derivation.steps
                if s.rule is Rule.REACTIONS)  # fmt: skip
    [step] = counted_shortly(solution, [full])
    before, after = full.body[-1], step.body[-1]
    assert isinstance(before, Prose)
    assert "5 equations for 6 unknowns" in str(before.parts[0])
    assert after == prose("With the 2 constraints these are 5 equations for 5 unknowns. Without the directions of the "
                          "reactions there would be 6.")  # fmt: skip


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_other_paragraphs_stay(name: str) -> None:
    step = Step(Rule.REACTIONS, "", (prose("The directions are known."),))
    assert [*counted_shortly(solved(name, complete=False), [step])] == [step]
