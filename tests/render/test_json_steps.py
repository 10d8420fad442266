"""Steps in JSON."""

from __future__ import annotations

import sympy as sp

from lagrange.document.derivation import Equation, display, math, prose
from lagrange.document.math_writer import text
from lagrange.render.json_steps import block, side_as_sum

x, y = sp.symbols("x y")


def test_prose_is_a_sentence_and_equations_are_texts() -> None:
    said = block(prose("With ", math(x, y), "."), text)
    assert "With x = y." in str(said)
    assert "x*y" in str(block(display(Equation((x * y, sp.S.Zero), "one")), text))
    assert side_as_sum(x) == x
