"""Other meanings of the letters of a right result."""

from __future__ import annotations

import sympy as sp

from lagrange.answers.results.meanings import other_meanings, with_waves_exchanged

W, h, b, mu = sp.symbols("W h b mu", positive=True)
alpha = sp.Symbol("alpha", real=True)


def test_one_letter_for_another_and_letters_exchanged() -> None:
    right = W * b / h
    meant = [sp.simplify(right.xreplace(dict(m.rule))) for m in other_meanings([W, b, h], [W, b, h])]
    assert sp.simplify(W * h / b) in meant
    assert all(m.clause for m in other_meanings([W, b, h], [W, b, h]))


def test_sine_for_cosine() -> None:
    [exchanged] = with_waves_exchanged([W * sp.sin(alpha) + mu * sp.cos(alpha)])
    assert (W * sp.sin(alpha)).xreplace(dict(exchanged.rule)) == W * sp.cos(alpha)
