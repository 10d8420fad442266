"""Formulas of Typst, LibreOffice and AsciiMath in plain text."""

from __future__ import annotations

import pytest

from lagrange.answers.written.notation.typesetters import in_plain_formulas

FORMULAS = {
    "$ m dot.double(x) = - c dot(x) $": "m ddot(x) = - c dot(x)",
    "$ dot.double(x)_1 = frac(frac(c, 2), m) x_(2) $": "ddot(x_1) = ((((c)/(2)))/(m)) x_2",
    "$ dot.double(phi.alt) = 1, quad dot.double(s) = 2 $": "ddot(phi) = 1, ddot(s) = 2",
    "$ dot.double(x) = 0 \\\n dot.double(y) = -g $": "ddot(x) = 0 ddot(y) = -g",
    "$ cases(dot.double(x) = 0, dot.double(y) = -g) $": "ddot(x) = 0 ddot(y) = -g",
    '$ dot.double(x) = 0 quad "and" quad y plus.minus 1 = 0 $': "ddot(x) = 0 ; and ; y ± 1 = 0",
    "ddot %theta + {g over l} sin %theta = 0": "theta'' + ((g/l)) sin theta = 0",
    "{d} over {dt} left( m dot x right) = {c x} over {l^2 - x^2}": "d/dt ( m x' ) = ((c x)/(l^2 - x^2))",
    "m ddot x_1 = 0 newline ddot {%phi}_2 = 1": "m x_1'' = 0 phi_2'' = 1",
    "ddot theta + (g)/(l) sin theta = 0": "theta'' + (g)/(l) sin theta = 0",
}


@pytest.mark.parametrize("text", FORMULAS)
def test_formulas_in_plain_text(text: str) -> None:
    assert in_plain_formulas(text).split() == FORMULAS[text].split()


@pytest.mark.parametrize(
    "text",
    [
        "theta double dot = -g/l sin(theta)",
        "ddot(x) = -g",
        "dot(a, b) = 0",
        r"\ddot\theta + \frac{g}{l}\sin\theta = 0",
        "the mass slides over the edge: m x'' = F",
        "m x'' = F % over the edge",
    ],
)
def test_other_texts_are_left_alone(text: str) -> None:
    assert in_plain_formulas(text) == text


def test_what_is_not_closed_ends() -> None:
    for text in ("$ frac( = dot.double(x) $", "{a over %b = ", "$ cases( dot.double(x) $", "x over { over { over {"):
        assert in_plain_formulas(text * 50)
