"""The work grows with the length of a text, and any text is read or refused."""

from __future__ import annotations

import contextlib

import pytest
import sympy as sp
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.expressions.latex_layout import piece
from lagrange.expressions.latex_lexer import LatexLexer
from lagrange.expressions.reader import read_value
from tests.support.chance import examples
from tests.support.expression_texts import scope

SCOPE = scope(
    "k", "omega", "omega_0", "I", "alpha", "L", "M", "m_12", "b2", "theta_1_B", "F_C", "ab", "a", "b", "ba", "rho"
)


def latex(text: str) -> Fragment:
    return piece(Fragment.of(text), 0, len(text))


x, theta, phi = (sp.Symbol(n, real=True) for n in ("x", "theta", "phi"))
LONG = (
    "x + ", "{x}", r"\frac{x}{y} + ", r"\sin\theta ", r"\dot x_{1}^2 ", "mgR", "x\\,", "x      ", r"\sin k ", "% c\n", r"\mathrm{m}",
    r"\left(x\right)", "x'", r"\sin\sin", "[x]", "m_", "^", r"\theta^{\prime}", r"\frac{d}{dt} x + ", r"\boxed{x}", "ẍ", "ba", "{", "}",
    r"\frac", "|x|", "1", ".", r"\left(", r"\sin{", r"\frac{\partial x}{\partial x}", r"\delta x ", "\\",
)  # fmt: skip


@pytest.mark.parametrize("text", LONG)
def test_the_work_grows_with_the_length_and_no_faster(text: str) -> None:
    def steps(count: int) -> int:
        many = text * count
        try:
            lexer = LatexLexer(latex(many), SCOPE)
        except ProblemError:
            return 0
        with contextlib.suppress(ProblemError):
            lexer.run()
        return lexer.scanner.steps + len(lexer.tokens)

    assert steps(800) <= 4 * steps(200) + 200


SOUP = st.lists(
    st.sampled_from([
        "\\", "{", "}", "^", "_", "$", "&", "%", "\n", " ", "'", "(", ")", "[", "]", "|", "+", "-", "*", "/", "=", ",", ".", "1", "23",
        "x", "theta", "mg", "q", "θ", "̈", "²", "₁", "\\frac", "\\sin", "\\dot", "\\ddot", "\\theta", "\\left", "\\right", "\\sqrt",
        "\\mathrm", "\\text", "\\mathbf", "\\hat", "\\cdot", "\\,", "\\quad", "\\\\", "\\begin{align}", "\\end{align}", "\\partial",
        "\\frac{d}{dt}", "d", "dt", "\\delta", "\\label{a}", "\\boxed", "\\lvert", "\\rvert", "\\|", "\\{", "\\}", "\\prime", "e",
        "\\operatorname", "{x}", "\\mathrm{d}", "\\vec", "\u200b", "а", "\\nonsense", "\\log", "\\bigl", "\\limits", "√", "½",
    ]),
    max_size=30,
)  # fmt: skip
EXAMPLES = [
    r"\frac{d}{dt}\left(m l^2\dot\theta\right)+mgl\sin\theta", r"\ddot{\theta}_1 + \frac{g}{l}\sin^2 2\theta_1\cos\omega t",
    r"\sqrt[3]{x} + \left|\frac{\dot x^2}{2}\right| + \lambda_{\text{rod}}", r"\mathbf{r}_P + x\,\hat{i} - \mathrm{e}^{-kt}\mathbf{j}",
    r"\frac{\partial^2 (x^3)}{\partial x^2} + \mathrm{d}x\,\operatorname{sgn}(x)",
]  # fmt: skip


@given(SOUP)
@settings(max_examples=examples(400), deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_soup_is_read_or_refused(parts: list[str]) -> None:
    _read_or_refused("".join(parts))


@given(
    st.sampled_from(EXAMPLES),
    st.integers(0, 60),
    st.integers(0, 4),
    st.sampled_from(["", "{", "}", "\\", "^", "_", "x", "'", "("]),
)
@settings(max_examples=examples(400), deadline=None)
def test_mutilated_formulas_are_read_or_refused(text: str, at: int, length: int, put: str) -> None:
    _read_or_refused(text[:at] + put + text[at + length :])


def _read_or_refused(text: str) -> None:
    try:
        notes: list[Diagnostic] = []
        read_value(latex(text), SCOPE, notes, latex=True)
    except ProblemError as error:
        notes += error.diagnostics
    for d in notes:
        assert d.span is None or 0 <= d.span.start <= len(text)
        assert str(d)
