"""Markdown: what GitHub, Jupyter, Quarto and pandoc agree on; read by a real pandoc where there is one.

Worksheets as blocks of MyST and Quarto: closed, without headings inside, the solution bound to its exercise.
"""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest
import sympy as sp

from lagrange.core.symbols import variation
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Emphasis,
    Equation,
    Ref,
    Rule,
    Step,
    Table,
    display,
    math,
    prose,
)
from lagrange.document.names import Notation
from lagrange.explain.page.worksheets import worked_solution, worksheet
from lagrange.render import markdown
from lagrange.render.flavours import Flavour
from lagrange.render.svg import Figures
from lagrange.render.tex_layout import Vectors
from tests.support.paths import PROBLEMS
from tests.support.processes import PATIENCE
from tests.support.sample_derivations import SAMPLES, pendulum
from tests.support.shared import reported

PENDULUM = r"""# Ideal pendulum

*Chapter 6, Ex. 11*

## 1. Equation of motion

With $x^{2} + y^{2} - l^{2} = 0$ it becomes

$$
\boxed{\ddot{\theta} + \frac{g}{l} \sin\theta = 0 \qquad \text{where } l \neq 0 \qquad (1)}
$$

## 2. Checks

- ✓ Lagrange's equations give the same — exact, 20 random points
- ? $\ddot{\theta} + (g/l) \sin\theta = 0$ is the textbook's — not decided within two seconds
- ✗ energy is conserved
"""
x, y, f = sp.symbols("x y f", real=True)
ALL = [sample() for sample in SAMPLES]
SHIPPED = sorted(PROBLEMS.glob("*/*.yaml"))
FORMULA = re.compile(r"\$\$\n(.*?)\n\$\$|\$([^$]+)\$", re.DOTALL)


def body(*blocks, title="T", source=""):
    derivation = Derivation(title, source, (Step(Rule.STATEMENT, "S", blocks),))
    return markdown.body(derivation, Notation()).split("## 1. S\n\n")[1].rstrip("\n")


def formulas(text):
    return [a or b for a, b in FORMULA.findall(text)]


def test_an_emphasized_word_before_a_formula_has_its_space_outside_the_asterisks():
    assert "*Without* $x$" in body(prose(Emphasis("Without "), math(x)))


def test_exact_output():
    assert markdown.body(*pendulum(), Detail.BRIEF) == PENDULUM


def test_several_equations_are_aligned_and_numbered():
    written = body(display(Equation((x, y), "a"), Equation((y, sp.S.Zero))), prose("By ", Ref("a"), "."))
    assert written == "$$\n\\begin{aligned}\nx &= y \\qquad (1) \\\\\ny &= 0\n\\end{aligned}\n$$\n\nBy (1)."


def test_a_table():
    table = Table(("of", math(x)), (("a|b", math(x / y)), ("c", "")))
    assert body(table) == "| of | $x$ |\n|---|---|\n| a\\|b | $x/y$ |\n| c |   |"


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("a*b_c", r"a\*b\_c"),
        ("[x](y)", r"\[x\](y)"),
        ("<b>", r"\<b\>"),
        ("5 $ and ~", r"5 \$ and \~"),
        ("`a` \\ |", r"\`a\` \\ \|"),
        ("a\x1b[31m\u200bb\nc", r"a\[31mb c"),
    ],
)
def test_text_stands_for_itself(text, written):
    assert body(prose(text)) == written


@pytest.mark.parametrize("text", ["# no heading", "- no item", "1. no list", "+ no item", "2) no list"])
def test_a_paragraph_is_no_heading_and_no_list(text):
    place = re.search(r"[-#+.)]", text).start()
    assert body(prose(text)) == f"{text[:place]}\\{text[place:]}"


@pytest.mark.parametrize(
    ("code", "written"),
    [
        (r"\dot{x}_{1}", r"\dot{x} _{1}"),
        (r"a \, \mathrm{d}x", r"a \mathrm{d}x"),
        (r"\left\{ a \right\}", r"\left\lbrace a \right\rbrace"),
        (r"\biggl\{ a \biggr\}", r"\biggl\lbrace a \biggr\rbrace"),
        (r"\{a\}", r"\lbrace a\rbrace "),
        ("a < b > c", r"a \lt  b \gt  c"),
        ("[a](b)", "[a] (b)"),
    ],
)
def test_the_dialect(code, written):
    assert markdown.dialect(code) == written


def test_a_vector_and_a_variation():
    written = body(display(Equation((variation(x), Vector((x, y, sp.S.Zero))))))
    assert written == "$$\n\\delta x = x \\mathbf{i} + y \\mathbf{j}\n$$"


@pytest.mark.parametrize(("derivation", "notation"), ALL, ids=lambda v: getattr(v, "title", ""))
def test_formulas_have_nothing_that_markdown_would_take(derivation, notation):
    found = formulas(markdown.body(derivation, notation, Detail.FULL))
    assert found
    for code in found:
        assert "$" not in code
        assert not re.search(r"\\[^A-Za-z]", code.replace("\\\\\n", "\n")), code
        assert "}_" not in code
        assert not re.search("[<>]", code)


@pytest.mark.parametrize("name", ["coupled-pendulums", "bead-on-rotating-hoop"])
def test_formulas_in_a_line_do_not_touch(name):
    """`$a$$b$` is read as the beginning of a displayed formula."""
    found = reported(name)
    lines = markdown.render([(found.derivation, found.notation)], Detail.FULL).splitlines()
    assert not [line for line in lines if "$$" in line and line.strip() != "$$"]


def test_a_long_condition_has_no_dollars():
    condition = ("where ", math(x, y, relation="<"), " holds")
    assert body(display(Equation((x, y), condition=condition))) == "\n".join(
        ["$$", r"x = y \qquad \text{where } x \lt  y \text{ holds}", "$$"]
    )


def test_marks_of_checks():
    text = body(CheckMark(("a",), True, "h"), CheckMark(("b",), False, ""), CheckMark(("c",), None, ""))
    assert text == "- ✓ a — h\n- ✗ b\n- ? c"


@pytest.mark.skipif(shutil.which("pandoc") is None, reason="there is no pandoc")
@pytest.mark.parametrize("reader", ["markdown", "gfm+tex_math_dollars"])
def test_pandoc_reads_every_formula(reader):
    pages = markdown.render([*ALL, *((r.derivation, r.notation) for r in map(solved, SHIPPED[::9]))], Detail.FULL)
    call = ["pandoc", "-f", reader, "-t", "html", "--mathml"]
    done = subprocess.run(call, input=pages, capture_output=True, text=True, timeout=120, check=True)
    assert done.stderr == ""
    assert done.stdout.count("<math") == len(formulas(pages))


def solved(path):
    return reported(path, complete=False)


# Exercises


def text(flavour: Flavour, *, exercise: bool = True, solution: bool = True, figures: Figures | None = None) -> str:
    found = reported("ex11-ideal-pendulum", complete=False)
    both = found.solution, found.derivation
    sheet = markdown.Sheet(
        worksheet(*both) if exercise else None, worked_solution(*both) if solution else None, found.notation
    )
    return markdown.with_exercises([sheet, sheet], Vectors.BOLD, flavour, figures)


def test_myst() -> None:
    figures = Figures("page")
    page = text(Flavour.MYST, figures=figures)
    assert re.findall(r"^`{5}\{(\w+)\} (.*)\n:label: (.*)$", page, re.MULTILINE) == [
        ("exercise", "Ideal pendulum", "ideal-pendulum"),
        ("solution", "ideal-pendulum", "ideal-pendulum-solution"),
        ("exercise", "Ideal pendulum", "ideal-pendulum-2"),
        ("solution", "ideal-pendulum-2", "ideal-pendulum-2-solution"),
    ]
    assert len(re.findall("^`{5}$", page, re.MULTILINE)) == 4
    assert not re.search("^#", page, re.MULTILINE)
    labels = re.findall(r"^\$\$ \((\S+)\)$", page, re.MULTILINE)
    assert len(set(labels)) == len(labels) > 20
    assert set(re.findall(r"\{eq\}`(\S+?)`", page)) <= set(labels)
    assert [*figures.files] == ["page.svg", "page-2.svg", "page-3.svg"]


def test_parts_have_the_same_numbers() -> None:
    sheet, solution = (
        re.findall(r"^\*\*\d+.*\*\*$", text(Flavour.MYST, exercise=e, solution=not e), re.MULTILINE)
        for e in (True, False)
    )
    assert sheet == solution
    assert sheet[0] == r"**1\. The constraint and the degrees of freedom**"


def test_quarto() -> None:
    page = text(Flavour.QUARTO)
    assert page.count(":::: {#exr-ideal-pendulum}\n\n## Ideal pendulum\n") == 1
    assert page.count(":::: {.solution}\n") == 2
    assert len(re.findall("^::::$", page, re.MULTILINE)) == 4
    assert len(re.findall("^#", page, re.MULTILINE)) == 2


@pytest.mark.skipif(shutil.which("pandoc") is None, reason="there is no pandoc")
def test_pandoc_sees_the_divs() -> None:
    done = subprocess.run(
        ["pandoc", "-f", "markdown", "-t", "html", "--mathml"],
        input=text(Flavour.QUARTO), capture_output=True, text=True, timeout=PATIENCE, check=True,
    )  # fmt: skip
    assert done.stderr == ""
    assert done.stdout.count('<div class="solution">') == 2
    assert 'id="exr-ideal-pendulum-2"' in done.stdout
