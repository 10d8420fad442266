"""The equations of one line."""

from __future__ import annotations

import pytest

from lagrange.answers.written.one_line import lines_of
from lagrange.core.diagnostics import Fragment


@pytest.mark.parametrize(
    ("text", "equations"),
    [
        ("m x'' = -k x   (2)", ["m x'' = -k x"]),
        ("N = m g = 4", ["N = m g", "N  =  4"]),
        (r"\text{radial: } m x'' = F", ["m x'' = F"]),
        ("[x'' = g]", ["x'' = g"]),
        ("(a) x'' = g", ["x'' = g"]),
        ("cos(theta) = 2/3 ≈ 0.67", ["cos(theta) = 2/3"]),
        ("theta = 0 or theta = pi", ["theta = 0 or theta = pi"]),
    ],
)
def test_what_stands_around_equations_is_left_out(text: str, equations: list[str]) -> None:
    assert [line.fragment.text.strip() for line in lines_of(Fragment.of(text), ())] == equations
