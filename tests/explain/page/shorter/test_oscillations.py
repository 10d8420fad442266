"""Of a small motion the frequency is boxed, and the linear equation is a step on the way.

Forced oscillations of linear systems: no equation twice, and long resonances as roots.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import prime, t
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Phrase,
    Prose,
    Purpose,
    Rule,
    Step,
    display,
    math,
    prose,
)
from lagrange.explain.page.shorter.oscillations import in_one_box
from tests.support.shared import reported

xi, omega, k = sp.symbols("xi omega k", positive=True)
LINEAR = display(Equation((prime(xi, 2) + k * xi, sp.S.Zero), label="linear-1-1", kind=EquationKind.LINEAR), boxed=True)
WAVE = ("cos(", math(omega), ")")
SQUARE = display(Equation((omega**2, k), label="omega-1"), boxed=True)


def said(*blocks: Block, rule: Rule = Rule.LINEARIZATION) -> tuple[Block, ...]:
    [step] = in_one_box([Step(rule, "", blocks)])
    return step.body


def waves(shorter: str) -> Prose:
    begins, ends = (
        Phrase("There are", Purpose.SUBJECT, shorter),
        Phrase(", with constant amplitudes, where", None, " with"),
    )
    return prose(begins, " solutions proportional to ", *WAVE, ends, purpose=Purpose.WAVES)


def words_of(block: Block) -> str:
    return "".join(p for p in block.parts if isinstance(p, str)) if isinstance(block, Prose) else ""


def test_one_box() -> None:
    linear, words, square = said(LINEAR, waves("It has"), SQUARE)
    assert isinstance(linear, Display)
    assert not linear.boxed
    assert words_of(words) == "It has solutions proportional to cos() with"
    assert square == SQUARE


def test_a_linear_equation_without_a_frequency_keeps_its_box() -> None:
    end = prose("The equation for the frequencies is too long to be written out.")
    assert said(LINEAR, end) == (LINEAR, end)


def test_steady_motions_too_and_nothing_else() -> None:
    solved = waves("They have")
    _, words, _ = said(LINEAR, solved, SQUARE, rule=Rule.STEADY)
    assert words_of(words) == "They have solutions proportional to cos() with"
    assert said(LINEAR, solved, SQUARE, rule=Rule.MEANING) == (LINEAR, solved, SQUARE)


# Response


@pytest.mark.parametrize("name", ["dynamic-absorber"])
def test_an_absorber(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.RESPONSE]
    labels = [e.label or "" for b in step.body if isinstance(b, Display) for e in b.equations]
    assert not any(x.startswith(("forced-", "resonance-")) for x in labels)
    words = [p for b in step.body if isinstance(b, Prose) for p in b.parts]
    assert any("linear, and without the drive" in p for p in words if isinstance(p, str))
    assert "frequencies of free oscillations" in words
    assert any(str(p).startswith(". At resonance there is no steady state, and the amplitude grows") for p in words)
    head = pages[0]
    c2, m2, w, F, y = (next(s for e in _box(head) for x in e.sides for s in x.free_symbols if s.name == n)
                       for n in ("c_2", "m_2", "w", "F", "y"))  # fmt: skip
    [still] = [e for e in _box(head) if e.sides[1] == 0 and e.condition]
    balanced = math(y, -F * sp.cos(w * t) / c2)
    assert still.condition == ("and ", balanced, " ", "where ", math(w**2, c2 / m2))


def _box(step: object) -> list:  # type: ignore[type-arg]
    return [e for b in step.body if isinstance(b, Display) for e in b.equations]  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", ["damped-oscillator"])
def test_a_damped_oscillator_keeps_its_amplitude_in_a_box(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    [step] = [s for s in pages if s.rule is Rule.RESPONSE]
    boxed = [e for b in step.body if isinstance(b, Display) and b.boxed for e in b.equations]
    assert any((e.label or "").startswith("amplitude-") for e in boxed)
    assert all(isinstance(s, sp.Expr) for e in boxed for s in e.sides)
