"""Text of a file that TeX would take for something else."""

import re

import pytest

from lagrange.document.derivation import (
    Detail,
)
from lagrange.document.names import GREEK
from lagrange.render import latex
from lagrange.render.escape import _KNOWN, escape
from tests.support.sample_derivations import SAMPLES, chain
from tests.support.tex import compiled, needs_tex

ALL = [sample() for sample in SAMPLES]


@pytest.mark.parametrize("character", _KNOWN)
def test_characters_that_tex_would_take_for_something_else(character):
    assert escape(f"a{character}b") == f"a{_KNOWN[character]}b"


@pytest.mark.parametrize("letter", [letter for letter, _ in GREEK.values()])
def test_greek_letters_in_text(letter):
    assert re.fullmatch(r"\$(\\[A-Za-z]+(\{[A-Z]\})?|o)\$", escape(letter))


ESCAPED = [
    ("50% of $5 & #1_a", r"50\% of \$5 \& \#1\_a"),
    (r"\input{x}", r"\textbackslash{}input\{x\}"),
    ("x^2 ~ y", r"x\textasciicircum{}2 \textasciitilde{} y"),
    ('the "rod"', "the ``rod''"),
    ("d’Alembert", "d'Alembert"),
    ("Größe, façade", "Größe, façade"),
    ("θ̈ and ẋ₁²", r"$\ddot{\theta}$ and $\dot{x}$$_1$$^2$"),
    ("√(2/7) of √3", r"$\sqrt{2/7}$ of $\sqrt{3}$"),
    ("`--format json` has it", r"\texttt{-{}-format json} has it"),
    ("中", "[U+4E2D]"),
    ("ﬁ", "fi"),
    ("a\x00b\u200bc\nd", "abc d"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "tex"), ESCAPED)
def test_text_stands_for_itself(text, tex):
    assert escape(text) == tex


@needs_tex
def test_tex_is_content(tmp_path):
    log = compiled(latex.render([*ALL, chain(2), chain(4), chain(7)], detail=Detail.FULL), tmp_path)
    assert "Overfull" not in log
    assert "Warning" not in log
