"""A derivation as data.

References under other labels, in prose and beside equations.

Purposes of paragraphs and of words in them.

Short ways to build blocks.
"""

from __future__ import annotations

import pickle

import sympy as sp

from lagrange.document.derivation import (
    Detail,
    Display,
    Equation,
    Math,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    Table,
    display,
    has_purpose,
    index_of,
    labels_in,
    listed,
    math,
    not_referring,
    paired,
    paragraph,
    prose,
    referring_to,
    series,
)
from tests.support.shared import reported

x = sp.Symbol("x")


def test_levels_of_detail_are_in_order() -> None:
    assert Detail.BRIEF < Detail.STEPS
    assert Prose(("a",)).detail is Detail.STEPS
    assert Table(("a",), ()).detail is Detail.STEPS
    assert Equation((x, x)).relation == "="


def test_the_steps_of_a_derivation_are_in_the_order_of_the_rules() -> None:
    order = list(Rule)
    own = [s.rule for s in reported("ex05-ice-skate").derivation.steps]
    assert [order.index(r) for r in own] == sorted(order.index(r) for r in own)


# References


def test_references_are_relabelled_in_prose_and_conditions() -> None:
    x = sp.Symbol("x")
    blocks = [
        prose("By ", Ref("old"), " and ", Ref("kept"), "."),
        display(Equation((x, x), condition=("by ", Ref("old")))),
    ]
    said, shown = referring_to(blocks, {"old": "new"})
    assert isinstance(said, Prose)
    assert said.parts == ("By ", Ref("new"), " and ", Ref("kept"), ".")
    assert isinstance(shown, Display)
    assert shown.equations[0].condition == ("by ", Ref("new"))


def test_references_to_missing_equations_are_words() -> None:
    x = sp.Symbol("x")
    shown = Step(Rule.PRINCIPLE, "Principle", (display(Equation((x, x), label="kept")),))
    assert labels_in([shown]) == {"kept"}
    said = not_referring(prose("By ", Ref("lost"), " and ", Ref("kept"), "."), lambda label: label not in {"kept"})
    assert said == prose("By ", "an equation left out here", " and ", Ref("kept"), ".")


# Purposes


def test_words_with_a_role_are_a_text_like_any_other() -> None:
    words = Phrase("The accelerations are", Purpose.SUBJECT, "the accelerations")
    assert words == "The accelerations are"
    assert f"{words}." == "The accelerations are."
    again = pickle.loads(pickle.dumps(words))
    assert (again, again.purpose, again.instead) == (words, Purpose.SUBJECT, "the accelerations")
    assert Phrase("and").purpose is None


def test_a_role_is_no_part_of_what_a_paragraph_says() -> None:
    said = prose("It remains free.", purpose=Purpose.FREE)
    assert said == prose("It remains free.")
    assert has_purpose(said, Purpose.FREE)
    assert not has_purpose(said, Purpose.SOLVING)
    assert not has_purpose(None, Purpose.FREE)


def test_sentences_joined_have_the_role_of_the_first() -> None:
    assert paragraph(prose("a", purpose=Purpose.TIMELESS), prose("b", purpose=Purpose.FREE)).purpose is Purpose.TIMELESS


def test_words_are_found_by_their_role() -> None:
    parts = ("Solving, ", Phrase("where ", Purpose.WHERE), "x, gives", Phrase("where ", Purpose.WHERE))
    assert index_of(Purpose.WHERE, parts) == 1
    assert index_of(Purpose.VERB, parts) is None


# Builders


x_builders, y = sp.symbols("x y")


def test_lists_in_a_sentence() -> None:
    assert listed(["a"]) == ("a",)
    assert "".join(map(str, listed(["a", "b", "c"]))) == "a, b and c"
    assert "".join(map(str, listed(["a", "b"], last=" or "))) == "a or b"
    assert "".join(map(str, series([["a", " of b"], ["c", " of d"]]))) == "a of b and c of d"


def test_sentences_become_one_paragraph() -> None:
    both = paragraph(prose("One. "), prose("Two ", math(x_builders), "."))
    assert "".join(p if isinstance(p, str) else "#" for p in both.parts).split() == ["One.", "Two", "#."]
    assert math(x_builders, y) == Math((x_builders, y))


def test_two_equations_in_a_line_have_one_number() -> None:
    first, second = Equation((x_builders, y), "one"), Equation((y, x_builders), "two")
    [line] = paired([first, second])
    assert line.label in ("one", "two")
    assert len(display(first, second, boxed=True).equations) == 2


def test_a_change_of_equations_reaches_every_display_and_nothing_else() -> None:
    x, y = sp.symbols("x y")
    words = prose("before ", math(x))
    step = Step(Rule.MEANING, "title", (words, display(Equation((x, y)), boxed=True), display(Equation((y,), "a"))))
    turned = step.map(lambda e: Equation(e.sides[::-1], e.label))
    assert turned == Step(
        Rule.MEANING, "title", (words, display(Equation((y, x)), boxed=True), display(Equation((y,), "a")))
    )
