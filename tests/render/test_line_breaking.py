"""Long expressions are broken at their terms, and nothing of them is lost."""

import re

import pytest
import sympy as sp
from rich.cells import cell_len

from lagrange.document.derivation import (
    Derivation,
    Detail,
    Rule,
    Step,
)
from lagrange.document.math_writer import BOLD, UNICODE, Notation, Writer
from lagrange.render import terminal
from lagrange.render.line_breaking import Breaker, outermost
from tests.support.sample_derivations import SAMPLES, driven_pendulum


def one_step(*blocks):
    return Derivation("T", "", (Step(Rule.STATEMENT, "S", blocks),))


def body(width, *blocks, notation=None, detail=Detail.STEPS):
    """The lines below the title of the step, without the margin."""
    printed = terminal.text(one_step(*blocks), notation or Notation(), width, detail)
    return [line[5:] for line in printed.splitlines()[3:]]


@pytest.mark.parametrize("sample", SAMPLES)
@pytest.mark.parametrize("width", [60, 80, 120])
def test_no_term_is_lost_by_breaking(sample, width):
    derivation, notation = sample()
    printed = squeezed(terminal.text(derivation, notation, width))
    writer = Writer(BOLD, notation)
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
        "  𝐫̈_P = (r̈ − r θ̇² − r φ̇² sin²θ) 𝐞_r",
        "        + (r θ̈ + 2ṙ θ̇ − r φ̇² sin θ cos θ) 𝐞_θ",
        "        + (r φ̈ sin θ + 2ṙ φ̇ sin θ",
        "           + 2r θ̇ φ̇ cos θ) 𝐞_φ                     (1)",
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
    quotient = (x - y) * (x + y) / (z * (x + z))
    assert outermost(Writer(UNICODE).marked(quotient)) == ["(x − y) (x + y)/(z (x + z))"]
