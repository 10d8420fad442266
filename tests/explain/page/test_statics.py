"""Statics on the page: once, in the chosen coordinates, and nothing lost."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Display, Rule
from tests.support.shared import reported


def labels(name: str, rule: Rule) -> list[str]:
    steps = [s for s in reported(name, complete=False).derivation.page if s.rule is rule and not s.folded]
    return [e.label for s in steps for b in s.body if isinstance(b, Display) for e in b.equations if e.label]


def test_an_equilibrium_and_its_reactions_come_once() -> None:
    page = reported("ex16-rod-on-two-planes", complete=False).derivation.page
    assert len([s for s in page if s.rule is Rule.SOLVED_REACTIONS]) == 1
    found = labels("ex16-rod-on-two-planes", Rule.EQUILIBRIUM)
    assert [n for n in found if n.startswith("equilibrium")] == ["equilibrium-inclination-1"]
    assert "balance-theta" in labels("ex16-rod-on-two-planes", Rule.SOLVED_REACTIONS)


@pytest.mark.parametrize("name", ["ladder", "ex16-rod-on-two-planes", "rod-in-bowl", "beads-on-hoop"])
def test_every_page_of_statics_has_an_equilibrium(name: str) -> None:
    found = labels(name, Rule.EQUILIBRIUM)
    assert any(n.startswith("equilibrium") for n in found)
