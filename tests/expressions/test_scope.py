"""Which names a text may use, and how they are spelt.

Messages about unknown names, and notes on readings that may surprise.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment
from lagrange.core.symbols import t
from lagrange.core.vectors import Vector
from lagrange.expressions.reader import canonical_name, read_scalar, read_vector
from tests.support.expression_texts import a, g, l, m, refused, same, scope, sin, sqrt, theta, x, y


def symbol(name: str) -> sp.Symbol:
    return sp.Symbol(name, positive=True)


@pytest.mark.parametrize(
    "name",
    [
        "e", "E", "I", "S", "N", "Q", "O", "C", "beta", "gamma", "zeta", "lambda", "d", "delta", "D", "Delta", "ln", "re", "im",
        "if", "for", "None", "True", "print", "y_1", "a_b_c", "Gamma", "mu_k", "factorial", "oo", "nan", "zoo", "Sum",
    ],
)  # fmt: skip
def test_free_names(name: str) -> None:
    known, s = scope(name), symbol(name)
    for text, expected in {
        name: s,
        f"{name}*x": s * x,
        f"2 {name} x": 2 * s * x,
        f"{name}^2": s**2,
        f"{name}(x + 1)": s * (x + 1),
        f"x/{name}": x / s,
        f"sin({name})": sin(s),
    }.items():
        assert same(read_scalar(Fragment.of(text), known), expected), text


def test_the_origin_where_nothing_else_is_called_o() -> None:
    assert read_vector(Fragment.of("O + 2*i"), scope()) == Vector((sp.Integer(2), sp.S.Zero, sp.S.Zero))
    assert read_scalar(Fragment.of("2 O"), scope("O")) == 2 * symbol("O")
    assert [d.code for d in refused("m*O", scope())] != ["unknown-symbol"]


def test_a_power_of_ten_is_a_product_where_e_is_declared() -> None:
    e = symbol("e")
    assert read_scalar(Fragment.of("2 e x"), scope("e")) == 2 * e * x
    assert read_scalar(Fragment.of("2e x"), scope("e")) == 2 * e * x
    assert read_scalar(Fragment.of("2e3"), scope()) == 2000
    e3 = symbol("e3")
    assert read_scalar(Fragment.of("2e3"), scope("e", "e3")) == 2 * e3
    found = refused("2e3", scope("e"))
    assert [d.code for d in found] == ["unknown-symbol"]
    assert "10^3" in found[0].help


def test_names_are_greek_letters_and_subscripts() -> None:
    known, omega_0 = scope("omega_0", "μ"), symbol("omega_0")
    assert read_scalar(Fragment.of("ω₀ t"), known) == omega_0 * t
    assert read_scalar(Fragment.of("ω_0t"), scope("omega_0t")) == symbol("omega_0t")
    assert read_scalar(Fragment.of("ωt"), scope("omega")) == symbol("omega") * t
    assert read_scalar(Fragment.of("mẍ"), scope()) == m * a


def test_the_script_ell_is_ell_where_that_is_declared_and_l_otherwise() -> None:
    ell = symbol("ell")
    assert read_scalar(Fragment.of("2ℓ t"), scope("ell")) == 2 * ell * t
    assert read_scalar(Fragment.of("2ell t"), scope("ell")) == 2 * ell * t
    assert read_scalar(Fragment.of("ℓ₁ t"), scope("ell_1")) == symbol("ell_1") * t
    assert read_scalar(Fragment.of("ℓ t"), scope("l")) == symbol("l") * t
    assert canonical_name("ℓ_0") == "ell_0"


def test_canonical_name() -> None:
    assert canonical_name("θ") == "theta"
    assert canonical_name(" phi_1 ") == "phi_1"
    assert canonical_name("e") == "e"
    for bad in ("", "2x", "x y", "x'", "t", "pi", "sin", "dot", "e_x", "a-b", "_x", "x" * 61, "ẋ", "π"):
        assert canonical_name(bad) is None, bad


# Suggestions


v, w, om, om_1 = (sp.Symbol(n, real=True) for n in ("x'", "y'", "theta'", "theta_1'"))


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
