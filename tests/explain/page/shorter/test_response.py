"""Forced oscillations of linear systems: no equation twice, and long resonances as roots."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.document.builders import math
from lagrange.document.derivation import Display, Prose, Rule
from tests.support.shared import reported


@pytest.mark.parametrize("name", ["dynamic-absorber"])
def test_an_absorber(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.RESPONSE]
    labels = [e.label or "" for b in step.body if isinstance(b, Display) for e in b.equations]
    assert not any(x.startswith(("forced-", "resonance-")) for x in labels)
    words = [p for b in step.body if isinstance(b, Prose) for p in b.parts]
    assert " are linear, and about " in words
    assert "frequencies of free oscillations" in words
    assert any(str(p).startswith(". At resonance there is no steady state, and the amplitude grows") for p in words)
    head = pages[0]
    c2, m2, w = (next(s for e in _box(head) for x in e.sides for s in x.free_symbols if s.name == n)
                 for n in ("c_2", "m_2", "w"))  # fmt: skip
    still = [e for e in _box(head) if e.sides[1] == 0 and e.condition]
    assert [e.condition for e in still] == [("where ", math(w**2, c2 / m2))]


def _box(step: object) -> list:  # type: ignore[type-arg]
    return [e for b in step.body if isinstance(b, Display) for e in b.equations]  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", ["damped-oscillator"])
def test_a_damped_oscillator_keeps_its_amplitude_in_a_box(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.RESPONSE]
    boxed = [e for b in step.body if isinstance(b, Display) and b.boxed for e in b.equations]
    assert any((e.label or "").startswith("amplitude-") for e in boxed)
    assert all(isinstance(s, sp.Expr) for e in boxed for s in e.sides)
