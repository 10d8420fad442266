"""The terminal: exact output, every width, breaking at terms, tables, levels of detail, colour."""

import io

import pytest
import sympy as sp
from rich.cells import cell_len
from rich.console import Console

from lagrange.document.derivation import CheckMark, Derivation, Detail, Equation, Ref, Rule, Step, display, math, prose
from lagrange.document.math_writer import Notation
from lagrange.render import terminal
from tests.support.sample_derivations import SAMPLES, pendulum

PENDULUM_AT_64 = """\
 Ideal pendulum                               Chapter 6, Ex. 11
 ──────────────────────────────────────────────────────────────
 1  The system
     A particle P of mass m hangs from a fixed point O by a
     massless rigid rod of length l. Axes: 𝐢 points right,
     𝐣 down.
       𝐫_P = x 𝐢 + y 𝐣
         𝐅 = m g 𝐣

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
       (m 𝐫̈_P − 𝐅)·δ𝐫_P = 0
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
    printed = terminal.text(one_step(*blocks), notation or Notation(), width, detail)
    return [line[5:] for line in printed.splitlines()[3:]]


def test_exact_output():
    assert terminal.text(*pendulum(), 64, Detail.FULL) == PENDULUM_AT_64


def test_brief_output_shows_results_and_puts_the_equation_where_its_number_would_dangle():
    assert terminal.text(*pendulum(), 79, Detail.BRIEF) == PENDULUM_IN_BRIEF


def test_detail_is_cumulative():
    lengths = [len(terminal.text(*pendulum(), 80, detail)) for detail in Detail]
    assert lengths == sorted(set(lengths))


@pytest.mark.parametrize("sample", SAMPLES)
def test_nothing_is_wider_than_the_terminal(sample):
    for width in (*range(20, 60, 3), *range(60, 131, 10)):
        for line in terminal.text(*sample(), width, Detail.FULL).splitlines():
            assert cell_len(line) <= width


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
    printed = terminal.text(derivation, Notation(), 60)
    assert "abcd" in printed.replace("[31m", "")
    assert not set(printed) & set("\x1b\x07\x9b\u202e\u200b")


def shown(**options):
    file = io.StringIO()
    terminal.show(*pendulum(), 80, console=Console(file=file, width=80, legacy_windows=False, _environ={}, **options))
    return file.getvalue()


def test_without_a_terminal_there_is_no_colour():
    assert shown() == terminal.text(*pendulum(), 80)


def test_with_a_terminal_there_is():
    coloured = shown(force_terminal=True, color_system="standard")
    assert "\x1b[1;32m✓" in coloured
    assert "\x1b[1;31m✗" in coloured
    uncoloured = shown(force_terminal=True, color_system="standard", no_color=True)
    assert "✓" in uncoloured
    assert "32m" not in uncoloured
