"""Equations in a piece of LaTeX."""

from __future__ import annotations

import pytest

from lagrange.answers.submissions import equations_in_file
from lagrange.core.diagnostics import Fragment, Source
from lagrange.expressions.latex_layout import equations, is_latex

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

LAYOUTS |= {
    r"\begin{align} x &= 0, \label{a} \\ y &= 1. \tag{2} \end{align}": ["x &= 0", "y &= 1"],
    r"\begin{align} x &= 0 & y &= 1 \end{align}": ["x &= 0", "y &= 1"],
    r"\begin{align} x &= 0 & &= 1 + y & + z \end{align}": [r"x &= 0 & &= 1 + y & + z"],
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


def test_sums_of_whole_numbers_stand_beside_the_mathematics() -> None:
    assert found("It is $a = b$. Degrees of freedom: 6 - 1 = 5.", ".txt") == ["a = b"]
    assert found("It is $a$ = 0.", ".txt") == ["It is $a$ = 0"]


def found(text: str, ending: str) -> list[str]:
    source = Source(f"answer{ending}", text)
    fragments = equations_in_file(source, ending)
    for fragment in fragments:
        span = fragment.span(0, len(fragment.text))
        assert text[span.start : span.end] == fragment.text
    return [f.text.strip() for f in fragments]
