"""Sines and cosines as letters: what is read has its value, and is written as it was."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError, TrigLetters, with_square

theta, phi = sp.symbols("theta phi", real=True)
alpha, a, b = sp.symbols("alpha a b", positive=True)
sin, cos, tan, sqrt = sp.sin, sp.cos, sp.tan, sp.sqrt
NUMBERS = {theta: sp.Rational(7, 10), phi: sp.Rational(-13, 10), alpha: sp.Rational(3, 10), a: 2, b: 3}

EXPRESSIONS = [
    sin(theta), cos(2 * theta), sin(3 * theta), tan(theta), cos(theta - alpha), sin(theta + 2 * phi), cos(theta / 2),
    sin(theta) * cos(theta / 3), a * sin(theta + sp.pi / 6), theta - a * sin(theta), sqrt(a**2 + b**2 * sin(theta) ** 2),
    sp.cot(theta) + sp.sec(theta) - sp.csc(phi), sp.Abs(sin(theta)), a * sp.sign(cos(theta)),
]  # fmt: skip


@pytest.mark.parametrize("expression", EXPRESSIONS, ids=str)
def test_writing_undoes_reading(expression: sp.Expr) -> None:
    letters = TrigLetters([expression], [theta, phi])
    read = letters.read(expression)
    assert not read.has(sp.tan)
    assert not {f for f in read.atoms(sin, cos) if f.free_symbols}
    difference = letters.write(read) - expression
    assert abs(sp.N(difference.xreplace(NUMBERS), 30)) < 1e-25


@pytest.mark.parametrize("keep", ["cosine", "sine"])
def test_reducing_keeps_the_value_and_finds_zero(keep: str) -> None:
    letters = TrigLetters([sin(theta), cos(theta)], [theta])
    angle = letters.angle_of(theta)
    assert angle is not None
    c, s = angle.letters
    assert letters.reduced(c**2 + s**2 - 1, keep) == 0
    assert letters.reduced((c + s) ** 4 - (1 + 2 * c * s) ** 2, keep) == 0
    e = a * c**3 * s - b * s**3 + c**2 * s**2
    value = sp.N(letters.write(letters.reduced(e, keep) - e).xreplace(NUMBERS), 30)
    assert abs(value) < 1e-25


def test_the_shortest_form_has_no_sum_of_squares() -> None:
    letters = TrigLetters([sin(theta), cos(theta)], [theta])
    c, s = letters.angle_of(theta).letters  # type: ignore[union-attr]
    assert letters.shortest(a**2 * c**2 + a**2 * s**2) == a**2


def test_which_unknowns_occur() -> None:
    root = sqrt(a + sin(phi))
    letters = TrigLetters([sin(theta), root], [theta, phi])
    assert letters.unknowns_in(letters.read(a * cos(theta))) == {theta}
    assert letters.unknowns_in(letters.read(root)) == {phi}
    assert letters.unknowns_in(letters.read(a * sin(alpha))) == set()


@pytest.mark.parametrize(
    "expression", [sin(theta * phi), sin(sqrt(theta)), sp.exp(theta), sin(13 * theta) * cos(theta)]
)
def test_what_is_not_algebraic_is_refused(expression: sp.Expr) -> None:
    letters = TrigLetters([expression], [theta, phi])
    with pytest.raises(NotAlgebraicError):
        letters.read(expression)


def test_a_square_is_replaced_to_every_power() -> None:
    x, y = sp.symbols("x y")
    assert sp.expand(with_square(x**5 + y * x**2 + x + 1, x, 1 - y) - ((1 - y) ** 2 * x + y * (1 - y) + x + 1)) == 0
