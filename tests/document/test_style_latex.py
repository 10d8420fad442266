"""What LaTeX needs beside the other styles."""

import pytest
import sympy as sp

from lagrange.core.symbols import (
    Partial,
    Unspecified,
    differential,
    prime,
    t,
    variation,
)
from lagrange.document.math_writer import RUNNING_LATEX, Notation, Writer, latex


def symbols(names):
    return sp.symbols(names, real=True)


x, y, z, r, th, ph = symbols("x y z r theta phi")
m, M, m1, m2, l, l1, l2, g, k, a, b, c = symbols("m M m_1 m_2 l l_1 l_2 g k a b c")
u, s = symbols("u s")
d, delta = differential, variation
f = Unspecified.of("f", ("X", "Y", "Z"), x - u * t, y, z)


def D(symbol, order=1):
    return prime(symbol, order)


def test_a_slope_before_brackets_is_not_taken_there():
    """`\\frac{\\partial f}{\\partial X} (x + y)` would be read as the slope at x + y."""
    rise = Unspecified.of("h", ("x", "y"), x, y).partial(0)
    printed = latex(-rise * (g + rise.partial(0) * D(x) ** 2) / (1 + rise**2))
    assert printed.startswith(r"-\frac{\left( \frac{\partial h}{\partial x} \right) \left( \frac{"), printed
    slope = Unspecified.of("h", ("x",), x).partial(0)
    assert latex(m * slope * (g + y)) == r"m (h') (y + g)"
    assert latex(m * slope * D(x)) == r"m h' \dot{x}"


def test_latex_does_not_stack_fractions_of_slopes():
    slope = f.partial(1) / f.partial(0)
    assert latex(-slope * delta(y)) == r"-\frac{\partial f / \partial Y}{\partial f / \partial X} \, \delta y"
    assert latex(u * slope) == r"\frac{u \frac{\partial f}{\partial Y}}{\partial f / \partial X}"
    assert latex(Partial(f.partial(0), y)) == r"\frac{\partial}{\partial y} \frac{\partial f}{\partial X}"
    assert latex(Partial(x / l - y, y)) == r"\frac{\partial}{\partial y} \left( \frac{x}{l} - y \right)"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("-W*l*sin(theta)/(2*cos(alpha))", r"-l W \sin\theta/(2 \cos\alpha)"),
        ("(m + M)*g/l", "(M + m) g/l"),
        ("m/M*sin(theta)", r"(m/M) \sin\theta"),
        ("pi/2", r"\pi/2"),
        ("m*v^2/2", r"\tfrac{1}{2} m v^{2}"),
        ("sqrt(l/g)", r"\sqrt{l/g}"),
        ("cos(omega*t)", r"\cos\omega t"),
    ],
)
def test_quotients_in_running_text_have_a_slash(text: str, code: str) -> None:
    names = ("W", "l", "theta", "alpha", "m", "M", "g", "v", "omega", "t")
    value = sp.sympify(text, {n: sp.Symbol(n, positive=True) for n in names})
    assert Writer(RUNNING_LATEX, Notation(), on_page=True).plain(value) == code
