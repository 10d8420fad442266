"""Statics on the page: once, in the chosen coordinates, and nothing lost."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Display, Rule
from tests.support.shared import reported, solved


def labels(name: str, rule: Rule) -> list[str]:
    steps = [s for s in reported(name, complete=False).derivation.page if s.rule is rule and not s.folded]
    return [e.label for s in steps for b in s.body if isinstance(b, Display) for e in b.equations if e.label]


def test_an_equilibrium_comes_once_without_multipliers_that_are_no_forces() -> None:
    r = reported("ex16-rod-on-two-planes", complete=False)
    [forces] = [s for s in r.derivation.page if s.rule is Rule.SOLVED_REACTIONS]
    boxed = [e.label for b in forces.body if isinstance(b, Display) and b.boxed for e in b.equations]
    assert boxed == ["support-size-A"]  # N_A = N_B
    assert len(next(e for b in forces.body if isinstance(b, Display) and b.boxed for e in b.equations).sides) == 3
    assert "lambda" not in repr(forces.body)
    assert [s for s in r.derivation.steps if s.rule is Rule.SOLVED_REACTIONS]
    found = labels("ex16-rod-on-two-planes", Rule.EQUILIBRIUM)
    assert [n for n in found if n.startswith("equilibrium")] == ["equilibrium-inclination-1"]
    assert [n for n in found if n.startswith("delta-at-rest")] == ["delta-at-rest-inclination-G"]


@pytest.mark.parametrize("name", ["ladder", "ex16-rod-on-two-planes", "rod-in-bowl", "beads-on-hoop"])
def test_every_page_of_statics_has_an_equilibrium(name: str) -> None:
    found = labels(name, Rule.EQUILIBRIUM)
    assert any(n.startswith("equilibrium") for n in found)


def test_no_force_balances_at_the_dead_centres() -> None:
    """P x sin θ = Q (x − r cos θ) has no P where sin θ = 0."""
    equilibrium = solved("slider-crank").own.equilibrium
    assert equilibrium is not None
    assert {str(f) for f in equilibrium.presupposed} == {"x", "sin(theta)"}
