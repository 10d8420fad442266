"""Text of a stranger, made safe to print."""

from __future__ import annotations

import json

import pytest

from lagrange.core.diagnostics import Diagnostic, Source, Span
from lagrange.core.limits import MOST_IN_A_LINE
from lagrange.core.printable import json_text, one_line, printable, visible

NASTY = {
    "an escape sequence": "\x1b[2J",
    "its C1 form": "\x9b2J",
    "a title of the window": "\x1b]0;x\x07",
    "backspaces": "\x08\x08",
    "delete": "\x7f",
    "a carriage return": "a\rb",
    "a bidi override": "\u202egnorw",
    "an isolate": "\u2066x\u2069",
    "a zero-width space": "a\u200bb",
    "a mark at the beginning": "\ufeffa",
    "a separator of lines": "a\u2028b",
    "half a pair": "\ud800",
    "a byte that is no text": "caf\udce9",
    "private use": "\ue000",
    "a tag": "\U000e0041",
    "no character": "\uffff",
}


@pytest.mark.parametrize("text", NASTY.values(), ids=NASTY)
def test_nothing_that_steers_is_shown(text: str) -> None:
    for shown in (visible(text), one_line(text), printable(text)):
        assert shown.isprintable()
        shown.encode()
    assert len(visible(text)) == len(text)  # so that carets stay where they are
    assert json.loads(json_text(text)) == text
    assert json_text(text)[1:-1].isprintable()


@pytest.mark.parametrize("text", ["Zoë 日本 θ̈ ẋ₁² ≤ √2 ✓", "it’s “so”", "e\u0301", "🙂", "x\u00a0=\u2009y"])
def test_letters_of_every_language_stay(text: str) -> None:
    assert visible(text) == one_line(text) == text
    assert json_text(text) == json.dumps(text, ensure_ascii=False)


def test_lines_stay_lines_in_a_message_and_are_none_in_a_sentence() -> None:
    assert visible("a\n\tb") == "a\n\tb"
    assert one_line("a\r\n  b\tc") == "a b c"
    assert one_line("x" * 10**6) == "x" * MOST_IN_A_LINE + " ..."
    assert json_text({"a": ["\n"]}, indent=1) == '{\n "a": [\n  "\\n"\n ]\n}'


def test_every_part_of_a_finding_is_safe() -> None:
    nasty = "\x1b[31m\nerror[forged]: x"
    source = Source(f"{nasty}.yaml", "a: \x1b[2J\n")
    shown = str(Diagnostic("code", nasty, Span(source, 3, 4), nasty, nasty))
    assert "\x1b" not in shown
    assert not [line for line in shown.splitlines() if line.startswith("error[forged]")]
    lines = shown.splitlines()
    assert lines[4].index("^") == lines[3].index("□")


def test_a_no_break_space_stays_on_a_page() -> None:
    assert printable("6\u00a0− 1\t= 5\n") == "6\u00a0− 1 = 5 "
