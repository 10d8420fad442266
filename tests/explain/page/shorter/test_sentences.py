"""Stock sentences in fewer words; neighbours side by side."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import variation
from lagrange.document.builders import display, math, prose
from lagrange.document.derivation import Block, Display, Equation, Prose, Ref, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.page.shorter.sentences import in_fewer_words
from tests.support.shared import reported

x1, y1, x2, y2, l, F, m = sp.symbols("x1 y1 x2 y2 l F m", real=True)


def said(*blocks: Block) -> tuple[Block, ...]:
    [step] = in_fewer_words([Step(Rule.MEANING, "", blocks)])
    return step.body


def placed(*names: sp.Symbol) -> Display:
    return display(*(Equation((q, l), label=f"choice-angle-{q.name}") for q in names))


def test_coordinates_of_one_point_stand_side_by_side() -> None:
    [shown] = said(placed(x1, y1, x2, y2))
    assert isinstance(shown, Display)
    assert [e.sides[0] for e in shown.equations] == [x1, x2]
    assert [e.condition for e in shown.equations] == [(math(y1, l),), (math(y2, l),)]
    [alone] = said(placed(x1, x2))
    assert alone == placed(x1, x2)  # of two points
    [moved] = said(display(Equation((variation(x1), l)), Equation((variation(y1), l))))
    assert isinstance(moved, Display)
    assert len(moved.equations) == 1


def test_a_number_that_is_referred_to_stays() -> None:
    block, words = placed(x1, y1), prose("By ", Ref("choice-angle-y1"), ".")
    assert said(block, words) == (block, words)


def test_multipliers() -> None:
    words = prose("With multipliers instead, nothing is eliminated. The ", "constraint on the displacements, times a "
                  "multiplier ", math(F), Phrase(", is", Purpose.VERB), " subtracted from ", Ref("a"), ", the multiplier being chosen so that "
                  "the ", "coefficient of ", math(variation(x1)), " vanishes",
                  Phrase(". The other displacements are free, so for every coordinate", Purpose.EVERY_COORDINATE),
                  purpose=Purpose.MULTIPLIERS)  # fmt: skip
    assert said(words) == (
        prose("With ", "a multiplier ", math(F), " of the constraint",
              " instead, nothing is eliminated, and for every coordinate"),
    )  # fmt: skip


def test_that_reactions_are_long_is_not_said_of_short_ones() -> None:
    reason = Phrase("The reaction of the rod is too long. ", Purpose.REASON)
    words = prose(reason, "In terms of the accelerations, Newton's equations give")
    short = display(Equation((F, m * x1)), boxed=True)
    assert said(words, short)[0] == prose("In terms of the accelerations, Newton's equations give")
    long = display(Equation((F, sp.Add(*(sp.Symbol(f"q{n}") * x1**n for n in range(2, 30))))), boxed=True)
    assert said(words, long) == (words, long)


@pytest.mark.parametrize("name", ["cylinder-on-rough-incline"])
def test_the_laws_of_bodies_are_named_in_a_line(name: str) -> None:
    pages = reported(name, complete=False).derivation.page
    words = [b.parts[0] for s in pages for b in s.body if isinstance(b, Prose)]
    assert "Newton's law and the law of angular momentum about the mass centre have the components" in words
