"""How names are written: Greek letters, indices, dots, and how a declaration changes them."""

import pytest
import sympy as sp

from lagrange.core.symbols import (
    prime,
)
from lagrange.document.math_writer import latex, text, unicode
from lagrange.document.names import GREEK, WrittenName, latex_name, unicode_name


def symbols(names):
    return sp.symbols(names, real=True)


x, y, z, r, th, ph = symbols("x y z r theta phi")


def D(symbol, order=1):
    return prime(symbol, order)


@pytest.mark.parametrize("name", GREEK)
def test_greek_letters(name):
    letter, command = GREEK[name]
    symbol = symbols(name)
    assert text(symbol) == name
    assert unicode(symbol) == letter
    assert latex(symbol) == command
    assert unicode(symbols(f"{name}_1''")) == unicode_name(WrittenName("", name, ("1",), 2))
    assert latex(symbols(f"{name}_1''")) == rf"\ddot{{{command}}}_{{1}}"


def test_greek_letters_are_different():
    assert len({letter for letter, _ in GREEK.values()}) == len(GREEK)
    assert len({command for _, command in GREEK.values()}) == len(GREEK)


# name: Unicode, LaTeX
NAMES = [
    ("x", "x", "x"),
    ("x'", "ẋ", r"\dot{x}"),
    ("x''", "ẍ", r"\ddot{x}"),
    ("x'''", "x‴", r"\dddot{x}"),
    ("x''''", "x′′′′", "x^{(4)}"),
    ("theta'", "θ̇", r"\dot{\theta}"),
    ("theta_1''", "θ̈₁", r"\ddot{\theta}_{1}"),
    ("theta1", "θ₁", r"\theta_{1}"),
    ("x_12", "x₁₂", "x_{12}"),
    ("x_C", "x_C", "x_{C}"),
    ("x_C'", "ẋ_C", r"\dot{x}_{C}"),
    ("a_theta", "a_θ", r"a_{\theta}"),
    ("a_x1", "a_x₁", r"a_{x_{1}}"),
    ("e1_B", "e₁_B", "e_{1,B}"),
    ("lambda_rod", "λ_rod", r"\lambda_{\text{rod}}"),
    ("lambda_no_slip.2", "λ_no_slip.2", r"\lambda_{\text{no slip},2}"),
    ("pos", "pos", r"\mathit{pos}"),
    ("pos''", "pos″", r"\ddot{\mathit{pos}}"),
    ("pos_1'", "pos₁′", r"\dot{\mathit{pos}}_{1}"),
    ("θ", "θ", r"\theta"),
    ("d(x)", "dx", r"\mathrm{d}x"),
    ("d(theta_1)", "dθ₁", r"\mathrm{d}\theta_{1}"),
    ("delta(x)", "δx", r"\delta x"),
    ("delta(theta)", "δθ", r"\delta \theta"),
]


@pytest.mark.parametrize(("name", "terminal", "tex"), NAMES, ids=[n for n, _, _ in NAMES])
def test_names(name, terminal, tex):
    assert text(symbols(name)) == name
    assert unicode_name(WrittenName.of(name)) == terminal
    assert latex_name(WrittenName.of(name)) == tex


def test_dotted_letters_are_composed():
    assert unicode(D(x, 2)) == "\u1e8d"
    assert unicode(D(th, 2)) == "θ\u0308"


def test_an_index_of_a_number_and_a_letter_is_written_as_one():
    assert unicode(sp.Symbol("a_1t")) == "a₁ₜ"
    assert latex(sp.Symbol("a_1t")) == "a_{1t}"
    assert unicode(sp.Symbol("a_1q")) == "a_1q"  # there is no small q below the line
