"""Bodies in bearings: vectors for the values at which the bearings hold coordinates."""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Display, Rule
from lagrange.explain.page.shorter.held import with_held_values
from tests.support.shared import reported, solved


@pytest.mark.parametrize("name", ["skewed-disc"])
def test_a_shaft_in_bearings(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    shown = {e.label: e for s in pages if not s.folded for b in s.body if isinstance(b, Display) for e in b.equations}
    held = {"alpha", "gamma", "alpha'", "gamma'", "alpha''", "gamma''"}
    for label in ("spin-disc", "momentum-disc", "turning-disc-1", "turning-disc-2", "turning-disc-3"):
        symbols = {s.name for side in shown[label].sides for s in _symbols(side)}
        assert symbols
        assert not symbols & held


def _symbols(side: object) -> set:  # type: ignore[type-arg]
    components = getattr(side, "components", (side,))
    return {s for c in components for s in c.free_symbols}


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_short_laws_are_for_all_values(name: str) -> None:
    steps = [s for s in reported(name, complete=False).derivation.steps if s.rule is Rule.REACTIONS]
    assert [*with_held_values(solved(name, complete=False), steps)] == steps
