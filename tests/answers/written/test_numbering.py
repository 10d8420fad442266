"""Numbers of equations, which are no factors."""

from __future__ import annotations

import pytest

from lagrange.answers.written.numbering import number_at_the_end


@pytest.mark.parametrize(
    ("text", "equation", "number"),
    [
        ("m x'' + k x = 0   (2)", "m x'' + k x = 0", "(2)"),
        (r"m \ddot x = 0\;(2a)", r"m \ddot x = 0", "(2a)"),
        ("x'' = g  [3]", "x'' = g", "[3]"),
        ("x'' = g (Ans.)", "x'' = g", "(Ans.)"),
        ("x'' = -(g)(2)", "x'' = -(g)(2)", ""),  # a factor
        ("x'' = a  (b)", "x'' = a", "(b)"),
        ("x'' = a (b)", "x'' = a (b)", ""),  # a name, unless the space is wide
        ("see (2)", "see (2)", ""),
    ],
)
def test_a_number_ends_an_equation(text: str, equation: str, number: str) -> None:
    end, found = number_at_the_end(text)
    assert (text[:end].rstrip(), found) == (equation, number)
