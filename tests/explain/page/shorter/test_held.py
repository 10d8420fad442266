"""Bodies in bearings: vectors for the values at which the bearings hold coordinates.

The page of a car on two axles: the values are substituted after the constraints.
"""

from __future__ import annotations

import pytest

from lagrange.document.derivation import Display, Rule
from lagrange.explain.page.shorter.held import put_in, with_held_values, with_values_put_in
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


# Together


def test_after_the_constraints_every_line_is_at_the_held_values() -> None:
    pages = [s for s in reported("rear-wheel-drive", complete=False).derivation.page if not s.folded]
    first = next(n for n, s in enumerate(pages) if s.rule is Rule.CONSTRAINT) + 1
    lines = [
        e for s in pages[first:] if s.rule is not Rule.CHECKS for b in s.body if isinstance(b, Display)
        for e in b.equations
    ]  # fmt: skip
    assert not {f for e in lines for side in e.sides for f in _symbols_together(side)} & {"phi", "phi'", "phi''", "y''"}
    boxed = {str(e.sides[0]): e.sides[-1] for s in pages if s.rule is Rule.SOLVED_REACTIONS for b in s.body
             if isinstance(b, Display) for e in b.equations}  # fmt: skip
    assert str(boxed["N_B"]).replace(" ", "") == "(-F*h+b*g*m)/(b+c)"


def _symbols_together(side: object) -> set[str]:
    return {s.name for c in getattr(side, "components", (side,)) for s in getattr(c, "free_symbols", ())}


def test_other_pages_stay() -> None:
    solution = solved("cylinder-on-rough-incline", complete=False)
    steps = reported("cylinder-on-rough-incline", complete=False).derivation.steps
    assert [*with_values_put_in(solution, steps)] == [*steps]
    assert put_in(None, steps[-1]) is steps[-1]
