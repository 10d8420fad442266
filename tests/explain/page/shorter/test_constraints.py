"""Constraints that are evidently finite relations share a section; others keep their own.

Virtual displacements have no list of their own where it repeats that of the forms.

A choice of coordinates that leaves a constraint: what is solved, once.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import VectorSymbol, differential, prime, variation
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    prose,
)
from lagrange.explain.page.shorter.constraints import explain_at_sight, in_few_lines, integrates_at_sight, with_one_list
from tests.support.shared import solved


@pytest.mark.parametrize(
    ("name", "at_sight"),
    [
        ("cylinder-on-rough-incline", True),  # exact
        ("cylinder-on-wedge", True),  # exact where h = R
        ("turning-parabola", True),  # two geometric ones, with time
        ("sleigh", False),  # not integrable
        ("ex17-spherical-pendulum", False),  # one with time, whose sections show what it changes
        ("towed-blade", False),  # about nothing but the constraints
    ],
)
def test_which_are_seen(name: str, at_sight: bool) -> None:
    assert integrates_at_sight(solved(name, complete=False)) is at_sight


@pytest.mark.parametrize("name", ["cylinder-on-wedge"])
def test_the_relation_of_rolling_is_in_the_section_and_right(name: str) -> None:
    solution = solved(name, complete=False)
    said = str(explain_at_sight(solution).body)
    assert "Where " in said
    assert "integrates to" in said
    [rolling] = [c for c in solution.classification.constraints if c.row.finite is None]
    slots = solution.problem.slots
    names = {s.name: s for s in rolling.constraint.function.free_symbols | rolling.integral.free_symbols}
    held = {names["h"]: names["R"]}
    rate = slots.time_derivative(rolling.integral)
    assert (rate - rolling.constraint.function.xreplace(held)).expand() == 0


# Displacements


x, y = sp.symbols("x y", real=True)
FORMS = display(Equation((differential(x), sp.S.Zero), label="form-floor"))
VIRTUAL = display(Equation((variation(x), sp.S.Zero), label="virtual-floor", kind=EquationKind.VIRTUAL, about="floor"))
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
    again = display(Equation((x, y), label="delta-choice-P", kind=EquationKind.DELTA))
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


# Choices


x_choices, psi, R, m = sp.symbols("x psi R m", positive=True)
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
    rate = Equation(
        (VectorSymbol("H_disc'"), VectorSymbol("k")), label="momentum-rate-along-disc", kind=EquationKind.MOMENTUM_RATE
    )
    turned = Equation(
        (VectorSymbol("delta(pi_disc)"), VectorSymbol("k")), label="rotation-along-disc", kind=EquationKind.ROTATION
    )
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
    before = Step(
        Rule.REACTIONS,
        "",
        (display(Equation(rate.sides, label="momentum-rate-disc", kind=EquationKind.MOMENTUM_RATE)),),
    )
    words, shown = said(*blocks, before=(before,))
    assert isinstance(words, Prose)
    assert Ref("momentum-rate-disc") in words.parts
    assert isinstance(shown, Display)
    assert shown.equations == (turned,)
