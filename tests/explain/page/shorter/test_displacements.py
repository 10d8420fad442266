"""Virtual displacements have no list of their own where it repeats that of the forms."""

from __future__ import annotations

import sympy as sp

from lagrange.core.symbols import differential, variation
from lagrange.document.builders import display, listed, prose
from lagrange.document.derivation import Display, Equation, Prose, Ref, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.page.shorter.displacements import with_one_list

x, y = sp.symbols("x y", real=True)
FORMS = display(Equation((differential(x), sp.S.Zero), label="form-floor"))
VIRTUAL = display(Equation((variation(x), sp.S.Zero), label="virtual-floor"))
BEGINS = prose("Time does not appear in ", Ref("form-floor"), ": virtual displacements satisfy it too,",
               purpose=Purpose.TIMELESS)  # fmt: skip
CONSTRAINT = Step(Rule.CONSTRAINT, "The constraint", (FORMS, prose("It has one degree of freedom.")))
WORK = Step(Rule.WORKLESS, "", (prose("which is zero by ", *listed([Ref("virtual-floor")]), "."),))


def test_a_sentence_under_the_forms_takes_the_place_of_the_list() -> None:
    said = [*with_one_list([CONSTRAINT, Step(Rule.DISPLACEMENTS, "", (BEGINS, VIRTUAL)), WORK])]
    assert [s.rule for s in said] == [Rule.CONSTRAINT, Rule.WORKLESS]
    last = said[0].body[-1]
    assert isinstance(last, Prose)
    assert last.parts[-3:] == ("Since time does not appear, virtual displacements satisfy ", Ref("form-floor"),
                               " with δ in place of d.")  # fmt: skip
    [by] = said[1].body
    assert isinstance(by, Prose)
    assert Ref("form-floor") in by.parts


def test_the_list_stays_where_displacements_are_solved_and_needed() -> None:
    solved = (prose("Solving for δx gives"), display(Equation((variation(x), variation(y)))))
    steps = [CONSTRAINT, Step(Rule.DISPLACEMENTS, "", (BEGINS, VIRTUAL, *solved)), WORK]
    assert [*with_one_list(steps)] == steps
    again = display(Equation((x, y), label="delta-choice-P"))
    later = Step(Rule.EQUATIONS_OF_MOTION, "", (again,), choice="choice")
    assert len([*with_one_list([*steps, later])]) == len(steps)  # there they follow once more


def test_the_list_stays_where_the_forms_are_not_shown() -> None:
    bare = Step(Rule.CONSTRAINT, "", (Display((Equation((x, sp.S.Zero)),)),))
    steps = [bare, Step(Rule.DISPLACEMENTS, "", (BEGINS, VIRTUAL))]
    assert [*with_one_list(steps)] == steps


def test_a_left_side_that_is_now_one_with_d_is_said_to_be_taken_with_delta() -> None:
    words = prose(
        "The work is ", "N", " times the left side of ", Ref("virtual-floor"), Phrase(":", Purpose.LEFT_SIDES)
    )
    steps = [CONSTRAINT, Step(Rule.DISPLACEMENTS, "", (BEGINS, VIRTUAL)), Step(Rule.WORKLESS, "", (words,))]
    _, work = with_one_list(steps)
    assert work.body == (
        prose("The work is ", "N", " times the left side of ", Ref("form-floor"), ", with δ in place of d:"),
    )
