r"""Where equations are found: in pieces of LaTeX, and in files with prose around them."""

from __future__ import annotations

import contextlib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.answers.answer_files import equations_in_file
from lagrange.core.diagnostics import Fragment, ProblemError, Source
from lagrange.expressions.latex_layout import equations, is_latex

# -- LaTeX -----------------------------------------------------------------------------------------------------------

LAYOUTS: dict[str, list[str]] = {
    r"\ddot x = 0": [r"\ddot x = 0"],
    r"$\ddot x = 0$": [r"\ddot x = 0"],
    r"$$\ddot x = 0$$": [r"\ddot x = 0"],
    r"\(\ddot x = 0\)": [r"\ddot x = 0"],
    r"\[\ddot x = 0\]": [r"\ddot x = 0"],
    r"\[ \ddot x = 0. \]": [r"\ddot x = 0"],
    r"\[ \ddot x = 0 \,, \]": [r"\ddot x = 0"],
    r"\ddot x = 0 \\ \ddot y = 0": [r"\ddot x = 0", r"\ddot y = 0"],
    r"\ddot x = 0 \\[4pt] \ddot y = 0 \\": [r"\ddot x = 0", r"\ddot y = 0"],
    r"\ddot x = 0 \\* \ddot y = 0 \newline x = 0": [r"\ddot x = 0", r"\ddot y = 0", "x = 0"],
    r"$\ddot x = 0$, $\ddot y = 0$": [r"\ddot x = 0", r"\ddot y = 0"],
    r"we find $\ddot x = 0$ and $y = 1$.": [r"\ddot x = 0", "y = 1"],
    r"$\ddot x$ = 0": [r"$\ddot x$ = 0"],
    r"$\ddot x$ = $0$": [r"$\ddot x$ = $0$"],
    r"x = 0, \quad y = 1": ["x = 0", "y = 1"],
    r"x = 0 \quad y = 1": ["x = 0", "y = 1"],
    r"x = 0 \text{ and } y = 1": ["x = 0", "y = 1"],
    r"\theta = 0 \text{ or } \theta = \pi": [r"\theta = 0 \text{ or } \theta = \pi"],
    r"\theta = 0 \quad\text{or}\quad \theta = \pi": [r"\theta = 0 \quad\text{or}\quad \theta = \pi"],
    r"\operatorname{atan2}(y, x) = 0": [r"\operatorname{atan2}(y, x) = 0"],
    r"x = 0 \quad\text{sowie}\quad y = 1": ["x = 0", "y = 1"],
    r"\text{Zuerst}\quad x = 0 \quad\text{fertig}": ["x = 0"],
    r"\quad \text{m} y = \text{m}": [r"\text{m} y = \text{m}"],
    r"m \ddot x \quad = F": [r"m \ddot x \quad = F"],
    r"x = \quad y": [r"x = \quad y"],
    r"x^2 = l^2 \qquad \text{(rod)}": ["x^2 = l^2"],
    r"x^2 = l^2 \qquad (3)": ["x^2 = l^2"],
    r"x^2 = l^2 \quad (2a)": ["x^2 = l^2"],
    r"x^2 = l^2\,(3)": [r"x^2 = l^2\,(3)"],
    r"x = \text{ma}": [r"x = \text{ma}"],
    r"x = 0 \text{, where $\mathbf{v_{\mathrm{P}}} = 0$ at {{\em all}} times}": ["x = 0"],
    r"x = 0 \text{ at the brace \} } \\ y = 1": ["x = 0", "y = 1"],
    r"x = 0 \label{eq:one} \tag{1}": ["x = 0"],
    r"\label{eq=one} x = 0 \nonumber": ["x = 0"],
    r"\boxed{\ddot x = 0}": [r"\ddot x = 0"],
    r"\boxed{x} = 0": [r"\boxed{x} = 0"],
    r"\boxed{\frac{x}{2} = 0}.": [r"\frac{x}{2} = 0"],
    r"\frac{x}{2} = \sqrt{y} \\ x = {y \\ z}": [r"\frac{x}{2} = \sqrt{y}", r"x = {y \\ z}"],
    "x = 0 % = 1 \\\\ y = 2\n": ["x = 0"],
    "% nothing\n\\ddot x = 0": [r"\ddot x = 0"],
    "\\theta": [r"\theta"],
}  # fmt: skip
for _name in (
    "equation",
    "align",
    "gather",
    "cases",
    "aligned",
    "split",
    "multline",
    "flalign",
    "eqnarray",
    "gathered",
    "dcases",
):
    for _star in ("", "*"):
        LAYOUTS[rf"\begin{{{_name}{_star}}} \ddot x = 0 \end{{{_name}{_star}}}"] = [r"\ddot x = 0"]
    LAYOUTS[rf"\begin{{{_name}}} \ddot x &= 0 \\ \ddot y &= 0 \end{{{_name}}}"] = [r"\ddot x &= 0", r"\ddot y &= 0"]
LAYOUTS |= {
    r"\begin{align} x &= 0, \label{a} \\ y &= 1. \tag{2} \end{align}": ["x &= 0", "y &= 1"],
    r"\begin{align} x &= 0 & y &= 1 \end{align}": [r"x &= 0 & y &= 1"],
    r"\begin{align} m\ddot x &= -kx \\ &\quad + c \\ y &= 0 \end{align}": [r"m\ddot x &= -kx \\ &\quad + c", "y &= 0"],
    r"\begin{multline} m\ddot x + k x \\ = c \end{multline}": [r"m\ddot x + k x \\ = c"],
    r"\begin{equation}\begin{split} x &= 0 \\ y &= 1 \end{split}\end{equation}": ["x &= 0", "y &= 1"],
    r"\[\begin{cases} x = 0 \\ y = 1 \end{cases}\]": ["x = 0", "y = 1"],
    r"$\begin{cases} x = 0 \\ y = 1 \end{cases}$": ["x = 0", "y = 1"],
    r"\left\{\begin{aligned} x &= 0 \\ y &= 1 \end{aligned}\right.": ["x &= 0", "y &= 1"],
    r"\left\{ \begin{array}{rcl} x &=& 0 \\ y &=& 1 \end{array} \right.": ["x &=& 0", "y &=& 1"],
    r"\begin{alignat}{2} x &= 0 \\ y &= 1 \end{alignat}": ["x &= 0", "y &= 1"],
    r"\begin{aligned}[t] x &= 0 \end{aligned}": ["x &= 0"],
    r"\boxed{\begin{aligned} x &= 0 \\ y &= 1 \end{aligned}}": ["x &= 0", "y &= 1"],
    r"\begin{align} x &= 0 \\ \intertext{and so} y &= 1 \end{align}": ["x &= 0", "y &= 1"],
    r"\begin{align} x &= 0 && \text{(I)} \\ y &= 1 && \text{(II)} \end{align}": ["x &= 0", "y &= 1"],
}  # fmt: skip


@pytest.mark.parametrize("text", LAYOUTS)
def test_the_equations_in_a_piece_of_latex(text: str) -> None:
    whole = Fragment.of(text)
    found = equations(whole)
    assert [f.text for f in found] == LAYOUTS[text]
    for fragment in found:
        assert is_latex(fragment)
        span = fragment.span(0, len(fragment.text))
        assert text[span.start : span.end] == fragment.text
        assert text[fragment.span(1, 2).start] == fragment.text[1]
        assert equations(fragment) == (fragment,)


def test_plain_text_is_left_as_it_is() -> None:
    whole = Fragment.of("x'' = 0, y = 1")
    assert equations(whole) == (whole,)


# -- files -----------------------------------------------------------------------------------------------------------


def found(text: str, ending: str) -> list[str]:
    source = Source(f"answer{ending}", text)
    fragments = equations_in_file(source, ending)
    for fragment in fragments:
        span = fragment.span(0, len(fragment.text))
        assert text[span.start : span.end] == fragment.text
    return [f.text.strip() for f in fragments]


LINES = {
    "x'' = 0\ny'' = 0\n": ["x'' = 0", "y'' = 0"],
    "# my answer = good\n\nx'' = 0\n": ["x'' = 0"],
    "% a comment = here\nx'' = 0\n": ["x'' = 0"],
    "The equation of motion is\nx'' = 0\nwhich is simple.\n": ["x'' = 0"],
    "1) x'' = 0\n2) y'' = 0": ["x'' = 0", "y'' = 0"],
    "(1) x'' = 0\n(2) y'' = 0": ["x'' = 0", "y'' = 0"],
    "1. x'' = 0\n2. y'' = 0": ["x'' = 0", "y'' = 0"],
    "(2) x'' = 0": ["(2) x'' = 0"],
    "2.5 x'' = 0": ["2.5 x'' = 0"],
    "a) x'' = 0\nb) y'' = 0": ["x'' = 0", "y'' = 0"],
    "(a) x'' = 0": ["(a) x'' = 0"],
    "Eq. 1: x'' = 0": ["x'' = 0"],
    "theta-equation: x'' = 0": ["x'' = 0"],
    "1) in the direction of x: x'' = 0": ["x'' = 0"],
    "* x'' = 0\n• y'' = 0": ["x'' = 0", "y'' = 0"],
    "- x'' = 0": ["- x'' = 0"],
    "(x + y)'' = 0": ["(x + y)'' = 0"],
    "x := 3": ["x := 3"],
    "x'' = 0\r\ny'' = 0\r\n": ["x'' = 0", "y'' = 0"],
    "$\\ddot x = 0$\nso $y = 1$": [r"\ddot x = 0", "y = 1"],
    "\\ddot x = 0 \\\\\n\\ddot y = 0\n": [r"\ddot x = 0", r"\ddot y = 0"],
    "\\begin{align}\n x &= 0 \\\\\n y &= 1\n\\end{align}\nz = 2": ["x &= 0", "y &= 1", "z = 2"],
    "1: $$\nx = 0\n$$\n(2) y = 1": ["x = 0", "y = 1"],
    "x'' = 0\n\n- a remark\n": ["x'' = 0"],
    "x'' = 0\n- this is because nothing acts\n": ["x'' = 0"],
    "": [],
    "nothing\n": [],
}


@pytest.mark.parametrize("text", LINES)
@pytest.mark.parametrize("ending", [".txt", "", ".TXT"])
def test_lines(text: str, ending: str) -> None:
    assert found(text, ending) == LINES[text]


LATEX = {
    "\\ddot x = 0 % = 1\n\\ddot y = 0": [r"\ddot x = 0", r"\ddot y = 0"],
    "% $z = 1$\nWe find $x = 0$ where $y$ is free.\n\\[ y = 1 \\]\n": ["x = 0", "y = 1"],
    "\\documentclass{article}\n\\newcommand{\\a}{$q = 1$}\n\\begin{document}\nThe answer, a = b, is\n\\begin{equation}\n  x = 0\n"
    "\\end{equation}\n\\end{document}\n $z = 2$": ["x = 0"],
    "\\begin{document}\nnothing = here\n\\end{document}": [],
    "\\begin{verbatim}\n$z = 1$\n\\end{verbatim} $x = 0$": ["x = 0"],
    "\\begin{align}\n  m\\ddot x &= 0, \\label{eq:1}\\\\\n  % y &= 2 \\\\\n  \\ddot y &= 0.\n\\end{align}\n": [r"m\ddot x &= 0", r"\ddot y &= 0"],
    "Costs 5\\$ and 6\\$. $x = 0$": ["x = 0"],
    "\\section{x = 1}\n$$ x = 0 $$": ["x = 0"],
}  # fmt: skip


@pytest.mark.parametrize("text", LATEX)
def test_latex(text: str) -> None:
    assert found(text, ".tex") == LATEX[text]


MARKDOWN = {
    "# Answer\n\nWe find $x = 0$ and so on: a = b.\n": ["x = 0"],
    "## x = 1\n\n- $\\ddot x = 0$\n- $\\ddot y = 0$\n": [r"\ddot x = 0", r"\ddot y = 0"],
    "$$\n\\ddot x = 0\n$$\n": [r"\ddot x = 0"],
    "```\nx'' = 0\n# no = comment\ny'' = 0\n```\nwhere a = b\n": ["x'' = 0", "y'' = 0"],
    "```latex\n\\begin{aligned}\nx &= 0 \\\\\ny &= 1\n\\end{aligned}\n```": ["x &= 0", "y &= 1"],
    "~~~\nx'' = 0\n~~~\n": ["x'' = 0"],
    "```\nx'' = 0": ["x'' = 0"],
    "The first is `x'' = 0`, the second `y'' = 0`; `code` is no equation.": ["x'' = 0", "y'' = 0"],
    "$y = 1$ comes before `x'' = 0`.": ["y = 1", "x'' = 0"],
    "- x'' = 0\n- y'' = 0\n": ["x'' = 0", "y'' = 0"],
    "1. x'' = 0\n2. y'' = 0\n": ["x'' = 0", "y'' = 0"],
    "> x'' = 0": ["x'' = 0"],
    "It costs $5 and not $6.\n\nx'' = 0": ["x'' = 0"],
    "nothing": [],
}


@pytest.mark.parametrize("text", MARKDOWN)
def test_markdown(text: str) -> None:
    assert found(text, ".md") == MARKDOWN[text]


@pytest.mark.parametrize(
    ("text", "ending", "code", "column"),
    [
        ("We find $x = 0", ".tex", "not-closed", 8),
        ("We find $x = 0\n\nand more", ".md", "not-closed", 8),
        ("\\begin{align} x &= 0", ".txt", "not-closed", 0),
        ("\\[ x = 0", ".tex", "not-closed", 0),
        ("x'' = a\n + b", ".txt", "continued-line", 8),
        ("x'' = a\n- b x", ".txt", "continued-line", 8),
    ],
)
def test_what_is_refused(text: str, ending: str, code: str, column: int) -> None:
    with pytest.raises(ProblemError) as caught:
        found(text, ending)
    [finding] = caught.value.diagnostics
    assert finding.span is not None
    assert (finding.code, finding.span.start) == (code, column)


@given(
    st.lists(
        st.sampled_from([
            "$", "$$", "\\(", "\\)", "\\[", "\\]", "\\begin{align}", "\\end{align}", "\\\\", "&", "=", "x", "\n", "\n\n", "{", "}", "```\n", "`",
            "% ", "# ", "(1) ", "a: ", "\\text{and}", ",", "\\quad", "\\boxed{", "\\label{a}", "\\begin{document}", "\\end{document}", "- ", " ",
        ]),
        max_size=40,
    ),
    st.sampled_from([".txt", ".md", ".tex"]),
)  # fmt: skip
@settings(max_examples=500, deadline=None)
def test_any_file_is_taken_apart_or_refused(parts: list[str], ending: str) -> None:
    text = "".join(parts)
    try:
        pieces = equations_in_file(Source("answer", text), ending)
    except ProblemError as error:
        error.show()
        return
    ends = 0
    for fragment in pieces:
        span = fragment.span(0, len(fragment.text))
        assert text[span.start : span.end] == fragment.text
        if ending != ".md":
            assert span.start >= ends
            ends = span.end


@pytest.mark.parametrize(
    "text",
    [
        "x = 0\n",
        "$",
        "$$",
        "\\\\",
        "{",
        "\\boxed{x = ",
        "x = 0, \\quad ",
        "`x = ",
        "```\n",
        "(1) ",
        "%\n",
        "\\text{and} = ",
        "\\text{",
        "\\text{{{{}",
    ],
)
@pytest.mark.parametrize("ending", [".txt", ".md", ".tex"])
def test_long_files_take_no_longer_than_their_length(text: str, ending: str) -> None:
    """A fifth of a megabyte, each in a moment; what grew with the square of the length would not come back."""
    with contextlib.suppress(ProblemError):
        equations_in_file(Source("answer", text * (200_000 // len(text))), ending)
