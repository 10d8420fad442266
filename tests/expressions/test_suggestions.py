"""What is said of unknown names, and of readings that may surprise."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment
from lagrange.core.symbols import t
from lagrange.expressions.reader import (
    read_scalar,
)
from tests.support.expression_texts import (
    g,
    l,
    m,
    refused,
    same,
    scope,
    sin,
    sqrt,
    theta,
    x,
    y,
)

v, w, om, om_1 = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'", "theta_1'"))


def symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, positive=True)


# has another unit vector; otherwise the unit vector, with a note
k, i = symbol("k"), symbol("i")


def test_every_unknown_name_of_a_text_is_reported_once() -> None:
    found = refused("ml + q + sin(ml) + w(q)")
    assert [(d.code, d.span.start) for d in found if d.span] == [
        ("unknown-symbol", 0),
        ("unknown-symbol", 5),
        ("unknown-function", 19),
    ]


ECHOED: dict[str, tuple[sp.Expr, str]] = {
    "1/2m": (m / 2, "(1/2)*m"),
    "g/l sin(theta)": (g / l * sin(theta), "(g/l)*sin(theta)"),
    "sin theta/2": (sin(theta) / 2, "before the `/`"),
    "sin theta^2": (sin(theta**2), "sin(theta^2)"),
    "sin m x": (sin(m * x), "sin(m x)"),
    "sin theta'": (sin(om), "sin(theta')"),
    "sin -x": (sin(-x), "sin(-x)"),
    "sin^2 m x": (sin(m * x) ** 2, "sin^2(m x)"),
    "√-x": (sqrt(-x), "sqrt(-x)"),
    "sqrt 2 x": (sqrt(2 * x), "sqrt(2 x)"),
    "sin m*t": (sin(m) * t, "before the `*`"),
    "sin 2*x": (sin(2) * x, "before the `*`"),
    "√2 x": (sqrt(2) * x, "before the `x`"),
    "sin x(y + 1)": (sin(x) * (y + 1), "before the `(`"),
    "sin theta x": (sin(theta) * x, "before the `x`"),
    "sqrt x y": (sqrt(x * y), "sqrt(x y)"),
    "x^1/2": (x / 2, "before the `/`"),
    "m(t)": (m * t, "m*t"),
    "x(2)": (2 * x, "x*2"),
    "√x y": (sqrt(x) * y, "before"),
    "|x| y |x|": (sp.Abs(x) * y * sp.Abs(x), "pairs"),
}


@pytest.mark.parametrize("text", ECHOED)
def test_a_surprising_reading_is_echoed(text: str) -> None:
    notes: list[Diagnostic] = []
    value, said = ECHOED[text]
    assert same(read_scalar(Fragment.of(text), scope(), notes), value)
    assert len(notes) == 1
    assert (notes[0].code, notes[0].level, notes[0].span is not None) == ("read-as", "note", True)
    assert said in notes[0].message
    assert notes[0].help


@pytest.mark.parametrize(
    "text",
    [
        "1/2 m", "2 m g l", "m(x + y)", "sin theta cos theta", "sin 2 theta", "sin theta x'", "g/l*sin(theta)", "-x^2", "theta''(t)", "sin^2 theta",
        "2e3", "x(y + 1)", "m g sin theta", "exp(-t) x", "sin omega t", "sin theta*x", "sin(2)*x", "1/2 m x'^2 + 1/2 k x^2", "|x|", "x^(1/2)",
    ],
)  # fmt: skip
def test_a_plain_reading_is_not_echoed(text: str) -> None:
    notes: list[Diagnostic] = []
    read_scalar(Fragment.of(text), scope("omega", "k"), notes)
    assert notes == []
