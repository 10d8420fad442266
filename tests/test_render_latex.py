"""LaTeX: documents, fragments, labels, breaking, escaping; compiled by a real TeX where there is one."""

import re
import shutil
import subprocess

import pytest
import sympy as sp
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
from lagrange.document.math_writer import Notation
from lagrange.document.names import GREEK
from lagrange.render import latex
from lagrange.render.ems import ems
from lagrange.render.escape import _KNOWN, escape

PENDULUM = r"""\section*{Ideal pendulum \hfill \textnormal{\normalsize Chapter 6, Ex. 11}}

\subsection*{1\quad Equation of motion}
With $x^{2} + y^{2} - l^{2} = 0$ it becomes
\begin{equation}\label{ideal-pendulum:motion}
  \boxed{\ddot{\theta} + \frac{g}{l} \sin\theta = 0 \qquad \text{where $l \neq 0$}}
\end{equation}

\subsection*{2\quad Checks}
\begin{itemize}
\item[$\checkmark$] Lagrange's equations give the same --- exact, 20 random points
\item[?] $\ddot{\theta} + \frac{g}{l} \sin\theta = 0$ is the textbook's --- not decided within two seconds
\item[$\times$] energy is conserved
\end{itemize}
"""

# a newline before a sign is not in the output
ACCELERATION = r"""\begin{align}
  \ddot{\mathbf{r}}_{P} &= (\ddot{r} - r \dot{\theta}^{2} - r \dot{\phi}^{2} \sin^{2}\theta) \, \mathbf{e}_{r}
 + (r \ddot{\theta} + 2\dot{r} \dot{\theta} - r \dot{\phi}^{2} \sin\theta \cos\theta) \, \mathbf{e}_{\theta}
 \notag \\
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


def test_exact_output():
    assert latex.body(*pendulum(), Detail.BRIEF) == PENDULUM


def test_a_long_equation_is_broken_at_its_terms_and_aligned():
    assert re.sub(r"\n (?=[+\\])", " ", ACCELERATION) in latex.body(*driven_pendulum())


def test_several_results_share_a_box_with_their_numbers_inside():
    text = latex.body(*driven_pendulum())
    box = text.split(r"\fbox{\begin{minipage}{0.97\linewidth}")[1].split(r"\end{minipage}}")[0]
    assert box.count(r"\label{") == 2
    assert r"\qquad \text{with $r = a + b \cos\omega t$, $\dot{r} = -b \omega \sin\omega t$} \notag" in box


def test_a_document_and_a_fragment_have_the_same_body():
    document, fragment = latex.render(ALL), latex.render(ALL, fragment=True)
    assert document.startswith(r"\documentclass[11pt,a4paper]{article}")
    assert document.endswith("\\end{document}\n")
    assert fragment.startswith("% lagsolve: needs \\usepackage{amsmath,amssymb}")
    assert "\\begin{document}" not in fragment
    assert "\\usepackage" not in fragment.split("\n\\section", 1)[-1]
    assert fragment[fragment.index("\\section") :] in document
    assert "tikz" not in fragment.split("\\section", 1)[0] or "\\begin{tikzpicture}" in fragment


def test_the_header_of_a_fragment_asks_for_tikz_where_there_are_pictures():
    described = latex.render([pendulum()], fragment=True, detail=Detail.BRIEF)
    assert "tikz" not in described
    assert described.startswith("% lagsolve: needs \\usepackage{amsmath,amssymb}, a text width of about 160 mm")


def test_two_derivations_with_one_title_have_labels_of_their_own():
    twice = latex.render([pendulum(), pendulum()])
    labels = re.findall(r"\\label{(.+?)}", twice)
    assert labels
    assert len(set(labels)) == len(labels)
    assert set(re.findall(r"\\eqref{(.+?)}", twice)) <= set(labels)
    assert latex.render([pendulum()]).count(r"\label") * 2 == len(labels)


@pytest.mark.parametrize("detail", Detail)
def test_every_reference_has_its_label(detail):
    text = latex.render(ALL, detail=detail)
    labels = re.findall(r"\\label\{(.*?)\}", text)
    assert len(labels) == len(set(labels))
    assert set(re.findall(r"\\eqref\{(.*?)\}", text)) <= set(labels)
    assert "(?)" not in text


def test_labels_are_stable_slugs():
    assert latex.slug("Ideal pendulum, “Ex. 11”") == "ideal-pendulum-ex-11"
    assert latex.slug("中") == "derivation"
    equation = Equation((x, y), "no slip_1")
    assert r"\label{t:no-slip-1}" in body(display(equation), prose("by ", Ref("no slip_1")))
    assert r"\eqref{t:no-slip-1}" in body(display(equation), prose("by ", Ref("no slip_1")))


@pytest.mark.parametrize(("derivation", "notation"), ALL)
def test_lines_fit_by_the_estimate(derivation, notation):
    rows = re.findall(r"^  (.*?)(?: \\notag| \\label\{.*?\})?(?: \\\\.*)?$", latex.body(derivation, notation), re.M)
    assert rows
    assert max(ems(row.replace("&", "")) for row in rows) <= latex.LINE + 1


@pytest.mark.parametrize(("derivation", "notation"), ALL)
def test_braces_and_growing_brackets_are_closed_in_their_row(derivation, notation):
    text = latex.body(derivation, notation, Detail.FULL)
    assert text.count("{") - text.count(r"\{") == text.count("}") - text.count(r"\}")
    for line in text.splitlines():
        assert line.count(r"\left") == line.count(r"\right")
    assert not any("\ue000" <= c <= "\uf8ff" for c in text)


def test_relations_are_aligned_where_left_sides_are_short():
    assert body(display(Equation((x, y)), Equation((x + y, y)))) == (
        "\\begin{align*}\n  x &= y \\\\\n  x + y &= y\n\\end{align*}"
    )
    long = sum(sp.symbols("a_:9"))
    assert "  &x = y \\\\" in body(display(Equation((x, y)), Equation((long, y))))


def test_a_fraction_that_is_too_wide_is_written_on_the_line():
    a = sp.symbols("a_:24")
    assert r"\frac{1}{x} (a_{0} + a_{1}" in body(display(Equation((y, sum(a) / x))))
    assert r"y &= x / (a_{0} + a_{1}" in body(display(Equation((y, x / sum(a)))))
    assert "a_{23}) \\\\\n  &\\quad / (a_{0}" in body(display(Equation((y, (x + sum(a)) / sum(a)))))
    assert r")^{1/2}" in body(display(Equation((y, sp.sqrt(sum(a))))))
    assert r"\frac{x + a_{0}}{x + a_{1}}" in body(display(Equation((y, (x + a[0]) / (x + a[1]) + sum(a)))))


def test_brackets_that_are_broken_have_a_fixed_size():
    a = sp.symbols("a_:24")
    text = body(display(Equation((y, x * (sum(a) + x / y)))))
    assert r"\biggl(" in text
    assert r"\biggr)" in text
    assert r"\left" not in text


def test_a_tall_box_is_cut_into_one_for_each_equation():
    a = sp.symbols("a_:90")
    equations = [Equation((sum(a), sp.Integer(n)), f"e{n}") for n in range(4)]
    assert body(display(*equations, boxed=True)).count(r"\fbox") == 4
    assert body(display(*equations[:2], boxed=True)).count(r"\fbox") == 1


def test_tables_are_turned_or_listed_where_they_are_too_wide():
    a = sp.symbols("a_:20")
    wide = Table(("row", *(math(s) for s in a)), (("one", *(math(s**2) for s in a)), ("two", *(math(s) for s in a))))
    assert r"\begin{tabular}{l|ll}" in body(wide)
    assert r"  row & one & two \\ \hline" in body(wide)
    cells = tuple(math(sum(a)) for _ in range(3))
    assert body(Table(("row", "x", "y", "z"), (("one", *cells),) * 3)).startswith("\\begin{itemize}\n\\item one: x: $")
    narrow = Table(("row", math(x)), (("one", math(y)),))
    assert "\\begin{tabular}{l|l}\n  row & $x$ \\\\ \\hline\n  one & $y$\n\\end{tabular}" in body(narrow)


def test_paragraphs_and_checks():
    assert body(prose("a"), prose("b")) == "a\n\nb"
    assert body(CheckMark(("100%",), True, "a_b")) == (
        "\\begin{itemize}\n\\item[$\\checkmark$] 100\\% --- a\\_b\n\\end{itemize}"
    )


@pytest.mark.parametrize("character", _KNOWN)
def test_characters_that_tex_would_take_for_something_else(character):
    assert escape(f"a{character}b") == f"a{_KNOWN[character]}b"


@pytest.mark.parametrize("letter", [letter for letter, _ in GREEK.values()])
def test_greek_letters_in_text(letter):
    assert re.fullmatch(r"\$(\\[A-Za-z]+(\{[A-Z]\})?|o)\$", escape(letter))


ESCAPED = [
    ("50% of $5 & #1_a", r"50\% of \$5 \& \#1\_a"),
    (r"\input{x}", r"\textbackslash{}input\{x\}"),
    ("x^2 ~ y", r"x\textasciicircum{}2 \textasciitilde{} y"),
    ('the "rod"', "the ``rod''"),
    ("d’Alembert", "d'Alembert"),
    ("Größe, façade", "Größe, façade"),
    ("θ̈ and ẋ₁²", r"$\ddot{\theta}$ and $\dot{x}$$_1$$^2$"),
    ("中", "[U+4E2D]"),
    ("ﬁ", "fi"),
    ("a\x00b\u200bc\nd", "abc d"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "tex"), ESCAPED)
def test_text_stands_for_itself(text, tex):
    assert escape(text) == tex


# A real TeX

needs_tex = pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")


def compiled(text, folder):
    """The log of two runs."""
    (folder / "a.tex").write_text(text, encoding="utf-8")
    for _ in range(2):
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
        run = subprocess.run(command, cwd=folder, capture_output=True, check=False)
        log = run.stdout.decode("latin-1")
        assert run.returncode == 0, log[-2000:]
    return log


def chain(links):
    """The n-link pendulum: equations of any length."""
    m, l, q = (sp.symbols(f"{name}_1:{links + 1}", real=True) for name in ("m", "l", "theta"))
    equations = []
    for i in range(links):
        terms = [
            sp.Add(*m[max(i, j) :]) * l[i] * l[j] * sp.Symbol(f"{q[j]}''") * sp.cos(q[i] - q[j]) for j in range(links)
        ]
        equations.append(Equation((sp.Add(*terms), sp.S.Zero), f"q{i}"))
    work = sp.Add(*(e.sides[0] * sp.Symbol(f"delta({s})") for e, s in zip(equations, q, strict=True)))
    fraction = sp.sqrt(sp.Add(*l)) * equations[0].sides[0] / sp.Add(*m)
    cells = [[math(l[i] * sp.cos(q[i] - q[j])) for j in range(links)] for i in range(links)]
    table = Table(("rod", *(math(s) for s in q)), tuple((f"{n}", *row) for n, row in enumerate(cells)))
    blocks = (
        display(Equation((work, sp.S.Zero), "work", condition=("where ", math(l[0], sp.S.Zero, relation="≠")))),
        display(*equations, boxed=True),
        display(Equation((sp.Symbol("Q"), fraction, fraction**2), "Q")),
        table,
        prose("In the text, ", math(work, sp.S.Zero), " and ", math(fraction), ", by ", Ref("work"), "."),
    )
    return one_step(*blocks, title=f"{links} links & more", source="50% of θ̈, “中”"), Notation(coordinates=q)


@needs_tex
def test_tex_is_content(tmp_path):
    log = compiled(latex.render([*ALL, chain(2), chain(4), chain(7)], detail=Detail.FULL), tmp_path)
    assert "Overfull" not in log
    assert "Warning" not in log


@needs_tex
def test_a_fragment_goes_into_a_document(tmp_path):
    fragment = latex.render(ALL, fragment=True)
    document = (
        "\\documentclass[11pt]{article}\\usepackage[margin=25mm,a4paper]{geometry}\\usepackage{amsmath,amssymb}"
        "\\setlength{\\emergencystretch}{3em}\\begin{document}\n" + fragment + "\\end{document}\n"
    )
    assert "Overfull" not in compiled(document, tmp_path)


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
