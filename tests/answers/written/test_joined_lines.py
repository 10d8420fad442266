"""Lines of an answer that belong together."""

from __future__ import annotations

import pytest

from lagrange.answers.written.joined_lines import has_sign_of_equality, is_mathematics, joined_lines


def joined(text: str) -> list[str]:
    lines, at = [], 0
    for line in text.split("\n"):
        lines.append((at, at + len(line), line))
        at += len(line) + 1
    return [text[start:end] for start, end in joined_lines(lines)]


def test_a_list_of_equations_goes_on_to_its_last_brace() -> None:
    assert len(joined("{a'' == -b,\n b'' == a}")) == 1
    assert joined("M = m_1 + m_2\neqs = {\n a'' == M,\n b'' == 0\n}")[0] == "M = m_1 + m_2"
    assert len(joined("M = m_1 + m_2\neqs = {\n a'' == M,\n b'' == 0\n}")) == 2


@pytest.mark.parametrize("text", ["a = [b\nc = d", "a = b}\nc = {d", "a = b\nc = d"])
def test_lines_with_equations_of_their_own_stay_apart(text: str) -> None:
    assert joined(text) == text.split("\n")


@pytest.mark.parametrize("text", ["m x'' =\n-k*x\n  + F", "m x'' =\n- k x + F", "m x''\n= - k x\n- mg"])
def test_a_line_goes_on_after_its_sign(text: str) -> None:
    assert joined(f"{text}\n\n- so far") == [text, "", "- so far"]


def test_what_is_mathematics() -> None:
    assert is_mathematics("- k x + F")
    assert not is_mathematics("where the spring is slack")
    assert has_sign_of_equality("theta ≈ 48.2°")
    assert not has_sign_of_equality("theta")
