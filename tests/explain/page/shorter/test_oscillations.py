"""Of a small motion the frequency is boxed, and the linear equation is a step on the way."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import prime
from lagrange.document.builders import display, math, prose
from lagrange.document.derivation import Block, Display, Equation, Prose, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.page.shorter.oscillations import in_one_box

xi, omega, k = sp.symbols("xi omega k", positive=True)
LINEAR = display(Equation((prime(xi, 2) + k * xi, sp.S.Zero), label="linear-1-1"), boxed=True)
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
