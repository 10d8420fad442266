"""How characters are shown, and their positions."""

from __future__ import annotations

import pytest

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.characters import normalized


@pytest.mark.parametrize("text", ["m*x'' + k*x = 0", "θ + φ", "a\u00a0b"])
def test_a_character_keeps_its_place(text: str) -> None:
    found = normalized(Fragment.of(text))
    assert len(found.text) == len(text)
    assert [*found.places] == [*range(len(text) + 1)]


def test_dots_over_a_letter_stand_behind_it() -> None:
    for written in ("\u1e8b", "x\u0307"):  # one character and two
        found = normalized(Fragment.of(f"a{written}b"))
        assert found.text[:2] == "ax"
        assert found.text[-1] == "b"
        assert found.written(1, 2)[0] == 1
    assert normalized(Fragment.of("\u1e8b")).text == normalized(Fragment.of("x\u0307")).text


@pytest.mark.parametrize("char", ["\u200b", "\u2060", "\ufeff", "\u202e"])
def test_an_invisible_character_is_refused_at_its_place(char: str) -> None:
    with pytest.raises(ProblemError) as refused:
        normalized(Fragment.of(f"x{char}y"))
    [diagnostic] = refused.value.diagnostics
    assert diagnostic.code == "invisible-character"
    assert diagnostic.span is not None
    assert (diagnostic.span.start, diagnostic.span.end) == (1, 2)
