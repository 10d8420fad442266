"""Where the characters of a YAML value stand in the file.

A value in quotes, in a block (`|`, `>`) or on several lines is not written as it is read: quotes and backslashes are
undone, line breaks become spaces. What is read and what is written have the same visible characters in the same order,
and that is how they are matched; blanks stand where the character before them ends.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from lagrange.core.diagnostics import Fragment, Span
from lagrange.core.records import record

Place = tuple[str, int, int]
"""A character, and where what stands for it begins and ends."""

_ESCAPE = re.compile(r"\\(?:x([0-9a-fA-F]{2})|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(.))", re.DOTALL)
_NAMED = {
    "0": "\0", "a": "\a", "b": "\b", "t": "\t", "\t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b",
    "N": "\x85", "_": "\xa0", "L": "\u2028", "P": "\u2029", "\n": " ",
}  # fmt: skip


@record
class ScalarText(Fragment):
    """The text of a scalar that is not written as it is read. `style` is YAML's: `'`, `"`, `|`, `>` or empty."""

    style: str = ""

    def span(self, start: int, end: int) -> Span:
        """Where characters `start` to `end` of the text stand in the source; the whole scalar if they are not found."""
        places = _places(self.text, self._written())
        if places is None or not places:
            return self.whole
        first = places[min(start, len(places) - 1)]
        last = places[min(max(end, start + 1), len(places)) - 1]
        at = first[1] if start < len(places) else first[2]  # behind the last character
        return Span(self.whole.source, at, max(last[2], at + 1))

    def _written(self) -> Iterator[Place]:
        """The visible characters as they are written."""
        raw = self.whole.source.text[self.whole.start : self.whole.end]
        match self.style:
            case "'":
                found = _single_quoted(raw)
            case '"':
                found = _double_quoted(raw)
            case "|" | ">":
                head = raw.find("\n")
                found = ((c, n, n + 1) for n, c in enumerate(raw) if n > head >= 0)
            case _:
                found = ((c, n, n + 1) for n, c in enumerate(raw))
        start = self.whole.start
        return ((c, start + a, start + b) for c, a, b in found if not c.isspace())


def _places(text: str, written: Iterator[Place]) -> list[Place] | None:
    """The place of each character of a text; None where it is not what is written."""
    found: list[Place] = []
    for char in text:
        if char.isspace():
            end = found[-1][2] if found else 0
            found.append((char, end, end))
            continue
        place = next(written, None)
        if place is None or place[0] != char:
            return None
        found.append(place)
    return found


def _single_quoted(raw: str) -> Iterator[Place]:
    at = 1
    while at < len(raw) - 1:
        width = 2 if raw.startswith("''", at) else 1
        yield raw[at], at, at + width
        at += width


def _double_quoted(raw: str) -> Iterator[Place]:
    at = 1
    while at < len(raw) - 1:
        escape = _ESCAPE.match(raw, at)
        if escape is None:
            yield raw[at], at, at + 1
            at += 1
        else:
            code = escape[1] or escape[2] or escape[3]
            char = chr(int(code, 16)) if code else _NAMED.get(escape[4], escape[4])
            yield char, at, escape.end()
            at = escape.end()
