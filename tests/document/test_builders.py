"""Short ways to build blocks."""

from __future__ import annotations

import sympy as sp

from lagrange.document.builders import display, listed, math, paired, paragraph, prose, series
from lagrange.document.derivation import Equation, Math

x, y = sp.symbols("x y")


def test_lists_in_a_sentence() -> None:
    assert listed(["a"]) == ("a",)
    assert "".join(map(str, listed(["a", "b", "c"]))) == "a, b and c"
    assert "".join(map(str, listed(["a", "b"], last=" or "))) == "a or b"
    assert "".join(map(str, series([["a", " of b"], ["c", " of d"]]))) == "a of b and c of d"


def test_sentences_become_one_paragraph() -> None:
    both = paragraph(prose("One. "), prose("Two ", math(x), "."))
    assert "".join(p if isinstance(p, str) else "#" for p in both.parts).split() == ["One.", "Two", "#."]
    assert math(x, y) == Math((x, y))


def test_two_equations_in_a_line_have_one_number() -> None:
    first, second = Equation((x, y), "one"), Equation((y, x), "two")
    [line] = paired([first, second])
    assert line.label in ("one", "two")
    assert len(display(first, second, boxed=True).equations) == 2
