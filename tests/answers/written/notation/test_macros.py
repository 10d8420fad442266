"""Macros that a LaTeX answer defines, written out."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.macros import macros_of, with_macros
from lagrange.core.diagnostics import Fragment


@pytest.mark.parametrize(
    ("written", "body", "read"),
    [
        (r"\newcommand{\tdd}{\ddot\theta}", r"\tdd = 0", r"\ddot\theta  = 0"),
        (r"\newcommand{\diff}[2]{\frac{d #1}{d #2}}", r"\diff{x}{t} = 0", r"\frac{d x}{d t}  = 0"),
        (r"\def\a{m}\def\b{\a x}", r"\b^2", "{m  x}^2"),
        (r"\newcommand{\a}{\a\a}", r"\a", r"\a\a "),
    ],
)
def test_macros_are_written_out_once(written: str, body: str, read: str) -> None:
    assert with_macros(Fragment.of(body), macros_of(written)).text == read
