"""Stock sentences in fewer words; neighbours side by side.

A bound has what it is about on the left.

A long length of a spring is written by its letter, that of the file if it has one.
"""

from __future__ import annotations

from types import SimpleNamespace

import pytest
import sympy as sp

from lagrange.core.symbols import CONSTANT, variation
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Math,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    math,
    prose,
)
from lagrange.explain.page.shorter.sentences import in_fewer_words, with_lengths, with_symbol_first
from tests.support.shared import reported

x1, y1, x2, y2, l, F, m = sp.symbols("x1 y1 x2 y2 l F m", real=True)


def said(*blocks: Block) -> tuple[Block, ...]:
    [step] = in_fewer_words([Step(Rule.MEANING, "", blocks)])
    return step.body


def placed(*names: sp.Symbol) -> Display:
    return display(*(Equation((q, l), label=f"choice-angle-{q.name}", kind=EquationKind.CHOICE) for q in names))


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


# Relations


mu, alpha, P = sp.symbols("mu alpha P", positive=True)


def turned(e: Equation, rule: Rule) -> Equation:
    [step] = with_symbol_first([Step(rule, "", (display(e, boxed=True),))])
    [box] = step.body
    [line] = box.equations  # type: ignore[union-attr]
    return line


def test_a_bound_is_turned_round() -> None:
    bound = Equation((sp.tan(alpha) / 3, mu), relation="≤")
    for rule in (Rule.RESULT, Rule.FRICTION_AT_REST):
        assert turned(bound, rule) == Equation((mu, sp.tan(alpha) / 3), relation="≥")
    assert turned(bound, Rule.MEANING) == bound


def test_what_stands_well_stays() -> None:
    for e in (
        Equation((mu, sp.tan(alpha)), relation="≤"),
        Equation((mu * P, P), relation="≤"),  # P is on both sides
        Equation((sp.tan(alpha), 2 * mu), relation="≤"),
    ):
        assert turned(e, Rule.FRICTION_AT_REST) == e
    relation = Equation((mu + P, CONSTANT))
    assert turned(relation, Rule.RESULT) == relation  # f(x) = const at the head


def test_an_answer_in_factors() -> None:
    value = (mu * P * alpha + mu * P) / (P**2 * alpha + P * mu)
    line = turned(Equation((alpha, value)), Rule.QUESTION)
    assert line.sides[1] == mu * P * (alpha + 1) / (P * (P * alpha + mu))
    roots = Equation((alpha, (sp.sqrt(mu + P) + P) / (P + mu)))
    assert turned(roots, Rule.QUESTION) == roots


# Springs


a, l_springs, c = sp.symbols("a l c", positive=True)
u, v = sp.symbols("u v", real=True)
RADICAND = a**2 - 2 * a * l_springs * (sp.sin(u) - sp.sin(v)) + 2 * l_springs**2 * (1 - sp.cos(u - v))
NAME = sp.Symbol("d_spring", real=True)
STATEMENT = Step(Rule.STATEMENT, "", (display(Equation((NAME, sp.sqrt(RADICAND)), label="length")),))
MOTION = Step(Rule.EQUATIONS_OF_MOTION, "", (display(Equation((c * (1 - a / sp.sqrt(RADICAND)) * sp.sin(u), 0 * a))),))


def lines(abbreviations: dict[str, sp.Expr], *steps: Step) -> list[Equation]:
    solution = SimpleNamespace(problem=SimpleNamespace(abbreviations=abbreviations))
    made = with_lengths(solution, steps)  # type: ignore[arg-type]
    return [e for s in made for b in s.body if isinstance(b, Display) for e in b.equations]


def test_the_letter_of_the_statement() -> None:
    stated, moving = lines({}, STATEMENT, MOTION)
    assert stated.sides == (NAME, sp.sqrt(RADICAND))
    letter = sp.Symbol("d_spring", positive=True)
    assert moving.sides[0] == c * (1 - a / letter) * sp.sin(u)


def test_the_letter_of_the_file_though_it_is_written_otherwise() -> None:
    own = sp.sqrt(
        (a - l_springs * sp.sin(u) + l_springs * sp.sin(v)) ** 2 + l_springs**2 * (sp.cos(v) - sp.cos(u)) ** 2
    )
    stated, moving = lines({"d": own, "e": sp.sqrt(a * l_springs)}, STATEMENT, MOTION)
    letter = sp.Symbol("d", positive=True)
    assert stated.sides == (letter,)
    assert moving.sides[0] == c * (1 - a / letter) * sp.sin(u)


def test_a_short_length_is_written_out() -> None:
    short = Step(Rule.STATEMENT, "", (display(Equation((NAME, sp.sqrt(a**2 + l_springs**2)))),))
    motion = Step(Rule.EQUATIONS_OF_MOTION, "", (display(Equation((c / sp.sqrt(a**2 + l_springs**2), sp.S.Zero))),))
    assert [e.sides for e in lines({}, short, motion)] == [e.sides for e in lines({}, short)] + [
        (c / sp.sqrt(a**2 + l_springs**2), sp.S.Zero)
    ]


def test_twice_the_radicand_is_the_same_length() -> None:
    double = Step(Rule.EQUATIONS_OF_MOTION, "", (display(Equation((a / sp.sqrt(sp.expand(2 * RADICAND)), sp.S.Zero))),))
    _, moving = lines({}, STATEMENT, double)
    assert moving.sides[0] == a / (sp.sqrt(2) * sp.Symbol("d_spring", positive=True))


def test_the_head_says_what_the_letter_is() -> None:
    head = Step(Rule.RESULT, "", MOTION.body)
    moving, defined, *_ = lines({}, head, STATEMENT)
    letter = sp.Symbol("d_spring", positive=True)
    assert moving.sides[0] == c * (1 - a / letter) * sp.sin(u)
    assert defined.sides == (letter**2, RADICAND)


def test_a_spring_and_a_damper_of_one_length_share_its_letter() -> None:
    oil, rate = sp.Symbol("d_oil", real=True), sp.Symbol("d_oil'", real=True)
    both = Step(
        Rule.STATEMENT, "", (*STATEMENT.body, display(Equation((oil, sp.sqrt(RADICAND))), Equation((c * rate, c))))
    )
    _, second = lines({}, both)
    assert second.sides == (sp.Symbol("d_spring", positive=True),)
    assert second.condition == (Math((c * sp.Symbol("d_spring'", real=True), c)),)
