"""A choice of coordinates that leaves a constraint: what is solved, once."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import VectorSymbol, prime, variation
from lagrange.document.builders import display, math, prose
from lagrange.document.derivation import Block, Display, Equation, Prose, Ref, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.page.shorter.choices import in_few_lines

x, psi, R, m = sp.symbols("x psi R m", positive=True)
s, q = sp.symbols("s q", real=True)


def said(*blocks: Block, before: tuple[Step, ...] = ()) -> tuple[Block, ...]:
    *_, step = in_few_lines([*before, Step(Rule.EQUATIONS_OF_MOTION, "", blocks, choice="along")])
    return step.body


def test_the_displacement_that_is_solved_for_is_all_that_is_said() -> None:
    row = display(Equation((variation(s) - R * variation(q), sp.S.Zero)))
    solving = prose("Solving for ", math(variation(q)), " gives", purpose=Purpose.SOLVING)
    begins = prose("In a virtual displacement", purpose=Purpose.VIRTUAL)
    solved = display(Equation((variation(q), variation(s) / R)))
    free = prose(math(variation(s)), " remains free.", purpose=Purpose.FREE)
    assert said(begins, row, solving, solved, free) == (
        prose("In a virtual displacement", " ", math(variation(q), variation(s) / R), "."),
    )
    condition = (Phrase(", where ", Purpose.WHERE), math(R, sp.S.Zero, relation="≠"), ",")
    where = prose("Solving for ", math(variation(q)), *condition, " gives", purpose=Purpose.SOLVING)
    [words] = said(begins, row, where, solved, free)
    assert isinstance(words, Prose)
    assert ", where " in words.parts


def test_velocities_and_accelerations_side_by_side() -> None:
    rates = display(Equation((prime(q), prime(s) / R)), Equation((prime(q, 2), prime(s, 2) / R)))
    solving = prose("Solving ", Ref("rate-along-rolling"), " and differentiating, gives", purpose=Purpose.RATES)
    [words] = said(solving, rates, prose("Substituting these leaves", ":"))
    assert isinstance(words, Prose)
    assert words.parts[:2] == ("By ", Ref("rate-along-rolling"))
    assert words.parts[-2:] == ("Substituting these leaves", ":")


def test_a_long_principle_is_not_written_before_its_brackets() -> None:
    long = sp.Add(*(sp.Symbol(f"a{n}") * s**n for n in range(2, 40)))
    written = display(Equation((long * variation(s), sp.S.Zero), label="written-out-along"))
    reads = prose("and d'Alembert's principle ", Ref("principle"), " reads", purpose=Purpose.PRINCIPLE)
    vanish, box = prose("δs is arbitrary:"), display(Equation((long, sp.S.Zero)), boxed=True)
    assert said(reads, written, vanish, box) == (
        prose("Substitute these in d'Alembert's principle ", Ref("principle"), ". ", "δs is arbitrary:"),
        box,
    )
    use = prose("by ", Ref("written-out-along"))
    assert said(reads, written, vanish, box, use) == (reads, written, vanish, box, use)


def test_what_a_body_needs_in_one_display_and_what_was_shown_by_its_number() -> None:
    rate = Equation((VectorSymbol("H_disc'"), VectorSymbol("k")), label="momentum-rate-along-disc")
    turned = Equation((VectorSymbol("delta(pi_disc)"), VectorSymbol("k")), label="rotation-along-disc")
    rates = "the rate of change of the angular momentum"
    blocks = (
        prose(Phrase("", Purpose.SUBJECT, rates), " is", purpose=Purpose.KINEMATICS),
        display(rate),
        prose("The virtual rotation of the body is"),
        display(turned),
    )
    words, shown = said(*blocks)
    assert isinstance(shown, Display)
    assert shown.equations == (rate, turned)
    assert isinstance(words, Prose)
    assert "The rate of change of the angular momentum and, formed like" in str(words.parts[0])
    before = Step(Rule.REACTIONS, "", (display(Equation(rate.sides, label="momentum-rate-disc")),))
    words, shown = said(*blocks, before=(before,))
    assert isinstance(words, Prose)
    assert Ref("momentum-rate-disc") in words.parts
    assert isinstance(shown, Display)
    assert shown.equations == (turned,)
