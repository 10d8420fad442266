"""Paragraphs and tables on a terminal."""

from __future__ import annotations

import pytest
import sympy as sp
from rich.cells import cell_len

from lagrange.document.derivation import Derivation, Detail, Equation, Rule, Step, Table, display, math, prose
from lagrange.document.math_writer import Notation
from lagrange.document.names import BREAK, END, START
from lagrange.render import terminal
from lagrange.render.terminal_layout import Styled, StyledWords, fill


def one_step(*blocks):
    return Derivation("T", "", (Step(Rule.STATEMENT, "S", blocks),))


def body(width, *blocks, notation=None, detail=Detail.STEPS):
    """The lines below the title of the step, without the margin."""
    printed = terminal.text(one_step(*blocks), notation or Notation(), width, detail)
    return [line[5:] for line in printed.splitlines()[3:]]


def test_prose_holds_short_formulas_together():
    theta = sp.Symbol("theta")
    words = StyledWords().text("the angle ").formula(["sin θ cos θ"], "=").text(", small")
    assert [line.plain for line in fill(words, 16)] == ["the angle", "sin θ cos θ,", "small"]
    assert body(30, prose("Let ", math(sp.sin(theta), theta), "."))[0].endswith("Let sin θ = θ.")


def test_prose_breaks_long_formulas_at_terms():
    a = sp.symbols("a_:12")
    lines = body(60, prose("Here ", math(sp.Symbol("Q"), sum(a)), "."))
    assert lines == ["Here Q = a₀ + a₁ + a₂ + a₃ + a₄ + a₅ + a₆ + a₇ + a₈", "+ a₉ + a₁₀ + a₁₁."]


def test_a_long_word_is_cut_as_the_last_resort():
    for line in body(30, prose("x" * 70), display(Equation((sp.Symbol("q" * 70), sp.S.Zero)))):
        assert cell_len(line) <= 25


def test_a_letter_keeps_its_dots_when_a_word_is_cut():
    words = StyledWords().text("θ̈" * 9)
    assert [line.plain for line in fill(words, 4)] == ["θ̈" * 4, "θ̈" * 4, "θ̈"]


@pytest.mark.parametrize("letter", ["θ̈", "ẍ", "φ̇₁", "x₁", "∂", "√", "∧", "½", "″", "−", "✓", "✗"])
def test_combining_characters_have_no_width(letter):
    assert cell_len(letter) == len([c for c in letter if c not in "\u0307\u0308"])


def coefficients(count):
    names = [math(sp.Symbol(f"a_q{n}")) for n in range(count)]
    cells = [math(sp.Symbol(f"q_{n}") - sp.Symbol(f"q_{n + 1}")) for n in range(count)]
    return Table(("constraint", *names), (("length", *cells), ("heading", *cells)))


def test_a_table_that_is_too_wide_is_turned():
    wide, narrow = body(120, coefficients(7)), body(60, coefficients(7))
    assert len(wide) == 4
    assert narrow[0] == "  constraint │ length  │ heading"
    assert narrow[2] == "  a_q₀       │ q₀ − q₁ │ q₀ − q₁"
    assert len(narrow) == 9


def test_a_table_that_fits_neither_way_is_wrapped_or_stacked():
    long = Table(("what", "why"), (("this", "because " * 12), ("that", "since " * 12)))
    assert body(60, long)[2] == "  this │ because because because because because"
    x = sp.symbols("x_:8")
    cell = math(sp.sin(sum(x)))
    grid = Table(("row", *(math(s) for s in x)), tuple((f"r{n}", *[cell] * 8) for n in range(8)))
    lines = body(60, grid)
    assert lines[:2] == ["  r0", "    x₀: sin(x₀ + x₁ + x₂ + x₃ + x₄ + x₅ + x₆ + x₇)"]


def test_a_wide_table_is_parted_before_it_is_stacked() -> None:
    columns = [math(s) for s in sp.symbols("x_:4")]
    cells = [math(sp.sin(sum(sp.symbols("x_:3")))), "–"]
    grid = Table(
        ("row", *columns), tuple((f"r{n}", *cells, *cells) if n < 2 else (f"r{n}", *["–"] * 4) for n in range(4))
    )
    lines = body(60, grid)
    assert [line for line in lines if "row" in line] == ["  row │ r0                │ r1", "  row │ r2 │ r3"]
    assert [line.split()[0] for line in lines if line.strip()][2:4] == ["x₀", "x₂"]


def test_no_short_word_stands_alone_at_the_end_of_a_paragraph() -> None:
    words = StyledWords().text("This is the principle of virtual work:")
    assert [line.plain for line in fill(words, 34)] == ["This is the principle of virtual", "work:"]
    assert [line.plain for line in fill(words, 34, prose=True)] == ["This is the principle of", "virtual work:"]


def test_a_short_side_stays_with_the_next_one() -> None:
    words = StyledWords().formula(["y", "a long first side of some formula", "const"], "=")
    assert [w.plain for w in words.words] == ["y", "= a long first side of some formula", "= const"]
    words = StyledWords().formula([f"{START}a + b{BREAK} + c cos t{BREAK} + a much longer term{END}", "const"], "=")
    assert [w.plain for w in words.words] == ["a + b", "+ c cos t", "+ a much longer term = const"]


# -- Lines in runs of one style each -----------------------------------------------------------------------------------


LINE = Styled.assemble("two ", ("bold", "bold"), " words  ")


def test_a_part_keeps_the_styles_of_its_runs() -> None:
    assert LINE.plain == "two bold words  "
    assert LINE[2:6].runs == (("o ", ""), ("bo", "bold"))
    assert LINE[6:].runs == (("ld", "bold"), (" words  ", ""))
    assert LINE[:] is LINE
    assert not LINE[3:3]


def test_lines_are_joined_stripped_and_added() -> None:
    assert LINE.stripped().plain == "two bold words"
    comma = Styled(", ", "dim")
    assert comma.joined([Styled("a"), Styled("b")]).runs == (("a", ""), (", ", "dim"), ("b", ""))
    assert comma.joined([]).runs == ()
    assert (Styled("a") + Styled() + Styled("b", "bold")).runs == (("a", ""), ("b", "bold"))
