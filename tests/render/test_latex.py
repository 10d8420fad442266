"""LaTeX: documents, fragments, labels, breaking, escaping; compiled by a real TeX where there is one."""

import re

import pytest
import sympy as sp

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
from lagrange.render import latex
from tests.support.sample_derivations import SAMPLES, driven_pendulum, pendulum
from tests.support.tex import compiled, needs_tex

PENDULUM = r"""\section*{Ideal pendulum \hfill \textnormal{\normalsize Chapter 6, Ex. 11}}

\subsection*{1\quad Equation of motion}
With $x^{2} + y^{2} - l^{2} = 0$ it becomes
\par\nopagebreak\smallskip\noindent\fbox{\hspace{5pt}\begin{minipage}{\dimexpr\linewidth-16.8pt}\vspace{-\abovedisplayskip}
\begin{align}
  \ddot{\theta} + \frac{g}{l} \sin\theta &= 0 \qquad \text{where $l \neq 0$} \label{ideal-pendulum:motion}
\end{align}
\end{minipage}\hspace{5pt}}\par\smallskip


\subsection*{2\quad Checks}
\begin{itemize}
\item[$\checkmark$] Lagrange's equations give the same --- exact, 20 random points
\item[?] $\ddot{\theta} + (g/l) \sin\theta = 0$ is the textbook's --- not decided within two seconds
\item[$\times$] energy is conserved
\end{itemize}
"""


x, y = sp.symbols("x y", real=True)
ALL = [sample() for sample in SAMPLES]


def one_step(*blocks, title="T", source=""):
    return Derivation(title, source, (Step(Rule.STATEMENT, "S", blocks),))


def body(*blocks, notation=None):
    """What the blocks of a step become."""
    return latex.body(one_step(*blocks), notation or Notation()).split("\\subsection*{1\\quad S}\n")[1].rstrip("\n")


def test_exact_output():
    assert latex.body(*pendulum(), Detail.BRIEF) == PENDULUM


def test_several_results_share_a_box_with_their_numbers_inside():
    text = latex.body(*driven_pendulum())
    box = text.split(r"\fbox{\hspace{5pt}\begin{minipage}{\dimexpr\linewidth-16.8pt}")[1].split(
        r"\end{minipage}\hspace{5pt}}"
    )[0]
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


def test_a_tall_box_is_cut_into_one_for_each_equation():
    a = sp.symbols("a_:90")
    equations = [Equation((sum(a), sp.Integer(n)), f"e{n}") for n in range(4)]
    assert body(display(*equations, boxed=True)).count(r"\fbox") == 4
    assert body(display(*equations[:2], boxed=True)).count(r"\fbox") == 1


def test_tables_are_turned_or_listed_where_they_are_too_wide():
    a = sp.symbols("a_:20")
    wide = Table(("row", *(math(s) for s in a)), (("one", *(math(s**2) for s in a)), ("two", *(math(s) for s in a))))
    assert r"\begin{tabular}{lll}" in body(wide)
    assert r"  row & one & two \\ \hline" in body(wide)
    cells = tuple(math(sum(a)) for _ in range(3))
    assert body(Table(("row", "x", "y", "z"), (("one", *cells),) * 3)).startswith("\\begin{itemize}\n\\item one: x: $")
    narrow = Table(("row", math(x)), (("one", math(y)),))
    assert "\\begin{tabular}{ll}\n  row & $x$ \\\\ \\hline\n  one & $y$\n\\end{tabular}" in body(narrow)


def test_paragraphs_and_checks():
    assert body(prose("a"), prose("b")) == "a\n\nb"
    assert body(CheckMark(("100%",), True, "a_b")) == (
        "\\begin{itemize}\n\\item[$\\checkmark$] 100\\% --- a\\_b\n\\end{itemize}"
    )


# A real TeX


@needs_tex
def test_a_fragment_goes_into_a_document(tmp_path):
    fragment = latex.render(ALL, fragment=True)
    document = (
        "\\documentclass[11pt]{article}\\usepackage[margin=25mm,a4paper]{geometry}\\usepackage{amsmath,amssymb}"
        "\\setlength{\\emergencystretch}{3em}\\begin{document}\n" + fragment + "\\end{document}\n"
    )
    assert "Overfull" not in compiled(document, tmp_path)
