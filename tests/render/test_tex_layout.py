"""Where a long equation is broken in LaTeX, and what is aligned; the estimate of widths against a real TeX."""

import re

import pytest
import sympy as sp

from lagrange.document.derivation import Derivation, Detail, Equation, Rule, Step, display
from lagrange.document.math_writer import Notation
from lagrange.render import latex
from lagrange.render.limits import LATEX_LINE
from lagrange.render.tex_layout import ems, unbroken
from tests.support.sample_derivations import SAMPLES, chain, driven_pendulum
from tests.support.tex import compiled, needs_tex

# a newline before a sign is not in the output
ACCELERATION = r"""\begin{align}
  \ddot{\mathbf{r}}_{P} &= (\ddot{r} - r \dot{\theta}^{2} - r \dot{\phi}^{2} \sin^{2}\theta) \, \mathbf{e}_{r}
 + (r \ddot{\theta} + 2\dot{r} \dot{\theta} - r \dot{\phi}^{2} \sin\theta \cos\theta) \, \mathbf{e}_{\theta}
 \notag \\*
  &\quad + (r \ddot{\phi} \sin\theta + 2\dot{r} \dot{\phi} \sin\theta
 + 2r \dot{\theta} \dot{\phi} \cos\theta) \, \mathbf{e}_{\phi}
 \label{a-pendulum-whose-length-is-varied:acceleration}
\end{align}"""
x, y = sp.symbols("x y", real=True)
ALL = [sample() for sample in SAMPLES]


def one_step(*blocks, title="T", source=""):
    return Derivation(title, source, (Step(Rule.STATEMENT, "S", blocks),))


def body(*blocks, notation=None):
    """What the blocks of a step become."""
    return latex.body(one_step(*blocks), notation or Notation()).split("\\subsection*{1\\quad S}\n")[1].rstrip("\n")


def test_a_long_equation_is_broken_at_its_terms_and_aligned():
    assert re.sub(r"\n (?=[+\\])", " ", ACCELERATION) in latex.body(*driven_pendulum())


@pytest.mark.parametrize(("derivation", "notation"), ALL)
def test_lines_fit_by_the_estimate(derivation, notation):
    rows = re.findall(r"^  (.*?)(?: \\notag| \\label\{.*?\})?(?: \\\\.*)?$", latex.body(derivation, notation), re.M)
    assert rows
    assert max(ems(row.replace("&", "")) for row in rows) <= LATEX_LINE + 1


@pytest.mark.parametrize(("derivation", "notation"), ALL)
def test_braces_and_growing_brackets_are_closed_in_their_row(derivation, notation):
    text = latex.body(derivation, notation, Detail.FULL)
    assert text.count("{") - text.count(r"\{") == text.count("}") - text.count(r"\}")
    for line in text.splitlines():
        assert line.count(r"\left") == line.count(r"\right")
    assert not any("\ue000" <= c <= "\uf8ff" for c in text)


def test_relations_are_aligned_where_left_sides_are_short():
    assert body(display(Equation((x, y)), Equation((x + y, y)))) == (
        "\\vspace{-\\baselineskip}\n\\begin{align*}\n  x &= y \\\\*\n  x + y &= y\n\\end{align*}"
    )
    long = sum(sp.symbols("a_:9"))
    assert "  &x = y \\\\" in body(display(Equation((x, y)), Equation((long, y))))


def test_a_fraction_that_is_too_wide_is_written_on_the_line():
    a = sp.symbols("a_:24")
    assert r"\frac{1}{x} (a_{0} + a_{1}" in body(display(Equation((y, sum(a) / x))))
    assert r"y &= x / (a_{0} + a_{1}" in body(display(Equation((y, x / sum(a)))))
    assert "a_{23}) \\\\*\n  &\\quad / (a_{0}" in body(display(Equation((y, (x + sum(a)) / sum(a)))))
    assert r")^{1/2}" in body(display(Equation((y, sp.sqrt(sum(a))))))
    assert r"\frac{x + a_{0}}{x + a_{1}}" in body(display(Equation((y, (x + a[0]) / (x + a[1]) + sum(a)))))


def test_brackets_that_are_broken_have_a_fixed_size():
    a = sp.symbols("a_:24")
    text = body(display(Equation((y, x * (sum(a) + x / y)))))
    assert r"\biggl(" in text
    assert r"\biggr)" in text
    assert r"\left" not in text


@needs_tex
def test_the_estimate_of_widths_is_good(tmp_path):
    """Not more than a tenth too small for what is as wide as half a line."""
    derivations = [*ALL, chain(3)]
    rows = [
        row.replace("&", "")
        for derivation, notation in derivations
        for row in re.findall(r"^  (.*?)(?: \\notag| \\label.*)?(?: \\\\.*)?$", latex.body(derivation, notation), re.M)
        if r"\hline" not in row
        and r"\text" not in row
        and "biggl" not in row
        and "hspace" not in row
        and "$" not in row
    ]
    measure = "".join(
        rf"\settowidth{{\w}}{{$\displaystyle {row}$}}\typeout{{WIDTH {n} \the\w}}" + "\n" for n, row in enumerate(rows)
    )
    document = latex.PREAMBLE + "\\newlength{\\w}\\begin{document}\n" + measure + "a\\end{document}\n"
    log = compiled(document, tmp_path)
    widths = {int(n): float(points) / 10.95 for n, points in re.findall(r"WIDTH (\d+) ([\d.]+)pt", log)}
    assert len(widths) == len(rows)
    for n, row in enumerate(rows):
        assert abs(ems(row) - widths[n]) < max(0.1 * widths[n], 1.8), row


def test_a_line_of_text_does_not_end_inside_a_bracket() -> None:
    long = r"m l^{2} \dot{\theta}_{1} \cos(\theta_{1} - \theta_{2}) + \left( a - b \right) \sin(\alpha + \beta) + m g l = 0"
    assert unbroken(long) == (
        r"m l^{2} \dot{\theta}_{1} \cos({\theta_{1} - \theta_{2}}) + \left( a - b \right) \sin({\alpha + \beta}) + m g l"
        r" = \nobreak 0"
    )
    assert unbroken(r"\theta = 0") == r"\theta = 0"  # as one types it
