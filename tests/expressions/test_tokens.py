"""Texts as tokens, each at its place."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.tokens import TokenKind, tokens


def kinds(text: str, scientific: bool = True) -> list[tuple[TokenKind, str]]:
    found, _ = tokens(Fragment.of(text), scientific)
    assert found[-1].kind is TokenKind.END
    return [(t.kind, t.text) for t in found[:-1]]


def test_names_numbers_and_signs() -> None:
    assert [text for _, text in kinds("m1*x'' + 2.5 k_a (x - l)^2 = 0")] == [
        "m1", "*", "x", "''", "+", "2.5", "k_a", "(", "x", "-", "l", ")", "^", "2", "=", "0"
    ]  # fmt: skip


@pytest.mark.parametrize("text", ["m*x'' + k*x", "sin(theta)/2 - 3", "[x, y, 1]"])
def test_a_token_is_where_it_stands(text: str) -> None:
    found, _ = tokens(Fragment.of(text))
    for token in found[:-1]:
        assert text[token.start : token.end] == token.text
    assert [t.start for t in found] == sorted(t.start for t in found)
    assert "".join(t.text for t in found) == text.replace(" ", "")


def test_the_mass_of_an_electron_and_that_of_the_sun_are_numbers() -> None:
    """Few digits, and powers of ten for which 30 digits would not do."""
    for text in ("9.109e-31", "1.989e30"):
        assert kinds(text) == [(TokenKind.NUMBER, text)]


def test_a_power_of_ten_is_one_number_unless_e_is_declared() -> None:
    assert len(kinds("2e3")) == 1
    assert len(kinds("2e3", scientific=False)) > 1


@pytest.mark.parametrize("text", ["x $ y", "x;y", "{x}", "x\u200by"])
def test_what_has_no_meaning_is_refused(text: str) -> None:
    with pytest.raises(ProblemError) as refused:
        tokens(Fragment.of(text))
    [diagnostic] = refused.value.diagnostics
    assert diagnostic.help
    assert diagnostic.span is not None
    assert diagnostic.span.start in (1, 2, 0)
