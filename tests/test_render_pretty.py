"""The terminal: exact output, every width, breaking at terms, tables, levels of detail, colour."""

import io
import re

import pytest
import sympy as sp
from rich.cells import cell_len
from rich.console import Console
from sample_derivations import SAMPLES, driven_pendulum, pendulum

from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Equation,
    Ref,
    Rule,
    Step,
    Table,
    display,
    math,
    prose,
)
from lagrange.document.math_writer import UNICODE, Notation, Writer
from lagrange.render import terminal as pretty
from lagrange.render.line_breaking import Breaker, outermost
from lagrange.render.paragraphs import Words, fill

PENDULUM_AT_64 = """\
 Ideal pendulum                               Chapter 6, Ex. 11
 ──────────────────────────────────────────────────────────────
 1  The system
     A particle P of mass m hangs from a fixed point O by a
     massless rigid rod of length l. Axes: i points right, j
     down.
       r_P = x i + y j
         F = m g j

 2  Constraint
     rod: no velocity occurs, so the constraint is geometric.
       x² + y² − l² = 0                                     (1)

 3  Differential form
       2x dx + 2y dy = 0                                    (2)
       constraint │ a_x │ a_y │ a_t
       ───────────┼─────┼─────┼────
       rod        │ 2x  │ 2y  │ 0
     ∂(2x)/∂y = 0 = ∂(2y)/∂x: exact. The constraint is the
     finite relation x² + y² = l².

 4  D'Alembert's principle
       (m r̈_P − F)·δr_P = 0
       m ẍ δx + m (ÿ − g) δy = 0                            (3)

 5  Equation of motion
     With (1) it becomes
     ╭─────────────────────────────────────────────╮
     │  θ̈ + (g/l) sin θ = 0    where l ≠ 0     (4) │
     ╰─────────────────────────────────────────────╯

 6  Checks
     ✓ Lagrange's equations give the       exact, 20 random
       same                                points
     ? θ̈ + (g/l) sin θ = 0 is the          not decided within
       textbook's                          two seconds
     ✗ energy is conserved
"""

PENDULUM_IN_BRIEF = """\
 Ideal pendulum                                              Chapter 6, Ex. 11
 ─────────────────────────────────────────────────────────────────────────────
 1  Equation of motion
     With x² + y² − l² = 0 it becomes
     ╭─────────────────────────────────────────────╮
     │  θ̈ + (g/l) sin θ = 0    where l ≠ 0     (1) │
     ╰─────────────────────────────────────────────╯

 2  Checks
     ✓ Lagrange's equations give the same      exact, 20 random points
     ? θ̈ + (g/l) sin θ = 0 is the textbook's   not decided within two seconds
     ✗ energy is conserved
"""


def one_step(*blocks):
    return Derivation("T", "", (Step(Rule.STATEMENT, "S", blocks),))


def body(width, *blocks, notation=None, detail=Detail.STEPS):
    """The lines below the title of the step, without the margin."""
    printed = pretty.text(one_step(*blocks), notation or Notation(), width, detail)
    return [line[5:] for line in printed.splitlines()[3:]]


def test_exact_output():
    assert pretty.text(*pendulum(), 64, Detail.FULL) == PENDULUM_AT_64


def test_brief_output_shows_results_and_puts_the_equation_where_its_number_would_dangle():
    assert pretty.text(*pendulum(), 79, Detail.BRIEF) == PENDULUM_IN_BRIEF


def test_detail_is_cumulative():
    lengths = [len(pretty.text(*pendulum(), 80, detail)) for detail in Detail]
    assert lengths == sorted(set(lengths))


@pytest.mark.parametrize("sample", SAMPLES)
def test_nothing_is_wider_than_the_terminal(sample):
    for width in (*range(20, 60, 3), *range(60, 131, 10)):
        for line in pretty.text(*sample(), width, Detail.FULL).splitlines():
            assert cell_len(line) <= width


@pytest.mark.parametrize("sample", SAMPLES)
@pytest.mark.parametrize("width", [60, 80, 120])
def test_no_term_is_lost_by_breaking(sample, width):
    derivation, notation = sample()
    printed = squeezed(pretty.text(derivation, notation, width))
    writer = Writer(UNICODE, notation)
    for step in derivation.steps:
        for block in step.body:
            for equation in getattr(block, "equations", ()):
                for side in equation.sides:
                    assert squeezed(writer.plain(side)) in printed


def squeezed(text):
    """Without spaces, frames and the numbers at the margin."""
    kept = re.sub(r" \(\d+\)( │)?$", "", text, flags=re.MULTILINE)
    return "".join(c for c in kept if c not in " │╭╮╰╯─\n")


@pytest.mark.parametrize("width", range(60, 121, 6))
def test_lines_break_before_the_signs_of_terms(width):
    derivation, notation = driven_pendulum()
    step = derivation.steps[1]
    lines = body(width, step.body[3], notation=notation)
    assert len(lines) > 1
    for line in lines[1:]:
        assert line.lstrip()[0] in "+−="


def test_terms_are_aligned_below_each_other():
    derivation, notation = driven_pendulum()
    lines = body(60, derivation.steps[1].body[1], notation=notation)
    assert lines == [
        "  r̈_P = (r̈ − r θ̇² − r φ̇² sin²θ) e_r",
        "        + (r θ̈ + 2ṙ θ̇ − r φ̇² sin θ cos θ) e_θ",
        "        + (r φ̈ sin θ + 2ṙ φ̇ sin θ",
        "           + 2r θ̇ φ̇ cos θ) e_φ                     (1)",
    ]


def test_a_bracket_is_broken_only_where_its_term_is_too_wide():
    x, y = sp.symbols("x y")
    code = Writer(UNICODE).marked(x**3 * (y + 1) + y * (x**2 + x * y + y**2 + x + y + 1))
    lines = Breaker(cell_len, 30).equation([code, "0"], "=")
    assert [" " * round(line.indent) + line.code for line in lines] == [
        "x³ (y + 1)",
        "  + y (x² + x y + y² + x + y",
        "       + 1) = 0",
    ]


def test_equal_sides_stand_below_each_other():
    a = sp.symbols("a_:9")
    sides = [Writer(UNICODE).marked(s) for s in (sp.Symbol("Q"), sum(a), 2 * a[0])]
    lines = Breaker(cell_len, 24).equation(sides, "=")
    assert [" " * round(line.indent) + line.code for line in lines] == [
        "Q = a₀ + a₁ + a₂ + a₃",
        "    + a₄ + a₅ + a₆ + a₇",
        "    + a₈",
        "  = 2a₀",
    ]


def test_a_long_fraction_is_broken_before_its_line():
    a = sp.symbols("a_:9")
    code = Writer(UNICODE).marked(sum(a) / (a[0] + a[1]))
    assert [line.code for line in Breaker(cell_len, 48).equation([code], "=")] == [
        "(a₀ + a₁ + a₂ + a₃ + a₄ + a₅ + a₆ + a₇ + a₈)",
        "/(a₀ + a₁)",
    ]


def test_outermost_terms():
    x, y, z = sp.symbols("x y z")
    assert outermost(Writer(UNICODE).marked(x * (y + z) - y)) == ["x (y + z)", "− y"]


def test_prose_holds_short_formulas_together():
    theta = sp.Symbol("theta")
    words = Words().text("the angle ").formula(["sin θ cos θ"], "=").text(", small")
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
    words = Words().text("θ̈" * 9)
    assert [line.plain for line in fill(words, 4)] == ["θ̈" * 4, "θ̈" * 4, "θ̈"]


@pytest.mark.parametrize("letter", ["θ̈", "ẍ", "φ̇₁", "x₁", "∂", "√", "∧", "½", "″", "−", "✓", "✗"])
def test_combining_characters_have_no_width(letter):
    assert cell_len(letter) == len([c for c in letter if c not in "\u0307\u0308"])


def test_numbers_stand_at_the_right_margin():
    x = sp.Symbol("x")
    lines = body(50, display(Equation((x, sp.S.One), "a"), Equation((x, sp.Integer(22)), "b")))
    assert [cell_len(line) for line in lines] == [44, 44]
    assert [line[-3:] for line in lines] == ["(1)", "(2)"]


def test_relations_of_short_equations_are_aligned():
    x, y = sp.symbols("x y")
    assert body(50, display(Equation((x, y)), Equation((x + y, y)))) == ["      x = y", "  x + y = y"]


def test_a_condition_stands_behind_or_below_its_equation():
    x = sp.Symbol("x")
    equation = Equation((x, sp.S.One), "a", condition=("if ", math(x, sp.S.Zero, relation=">")))
    assert body(50, display(equation)) == ["  x = 1    if x > 0" + " " * 22 + "(1)"]
    assert body(25, display(equation)) == ["  x = 1         (1)", "    if x > 0"]


def test_a_reference_that_nobody_labelled_shows():
    assert body(50, prose("By ", Ref("nowhere"), ".")) == ["By (?)."]


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


def test_checks_have_their_how_beside_or_below():
    check = CheckMark(("the constraint ", Ref("a"), " does no work"), True, "exact")
    labelled = display(Equation((sp.Symbol("x"), sp.S.Zero), "a"))
    assert body(60, labelled, check)[1] == "✓ the constraint (1) does no work   exact"
    long = CheckMark(("a name that takes some room in a narrow window",), None, "a way that takes some, too")
    assert body(40, long) == [
        "? a name that takes some room in a",
        "  narrow window",
        "    a way that takes some, too",
    ]


def test_nothing_steers_the_terminal():
    derivation = Derivation(
        "a\x1b[31mb\u202ec\u200bd", "e\x07f", (Step(Rule.STATEMENT, "g\x9bh", (prose("i\x1b]0;j"),)),)
    )
    printed = pretty.text(derivation, Notation(), 60)
    assert "abcd" in printed.replace("[31m", "")
    assert not set(printed) & set("\x1b\x07\x9b\u202e\u200b")


def shown(**options):
    file = io.StringIO()
    pretty.show(*pendulum(), 80, console=Console(file=file, width=80, legacy_windows=False, _environ={}, **options))
    return file.getvalue()


def test_without_a_terminal_there_is_no_colour():
    assert shown() == pretty.text(*pendulum(), 80)


def test_with_a_terminal_there_is():
    coloured = shown(force_terminal=True, color_system="standard")
    assert "\x1b[1;32m✓" in coloured
    assert "\x1b[1;31m✗" in coloured
    uncoloured = shown(force_terminal=True, color_system="standard", no_color=True)
    assert "✓" in uncoloured
    assert "32m" not in uncoloured
