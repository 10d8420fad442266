"""The nodes of a problem file: scalars, lists and mappings, each with its place.

Every scalar is text: `n`, `y`, `no` and `on` stay names, `1e-3` stays as written, and its meaning is decided by the
section that reads it.

A scalar in quotes, in a block (`|`, `>`) or on several lines is not read as it is written: quotes and backslashes are
resolved, line breaks become spaces. Both texts have the same visible characters in the same order, which locates each
character in the file; a blank is located at the end of the character before it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from lagrange.core.diagnostics import Fragment, Span
from lagrange.core.records import record


@record
class Scalar:
    """A value, as text. `fragment` locates its characters; `quoted` distinguishes `""` from an absent value."""

    text: str
    span: Span
    fragment: Fragment
    quoted: bool

    @property
    def is_empty(self) -> bool:
        """Whether nothing was written."""
        return not self.quoted and not self.text


@record
class ListNode:
    """A list."""

    items: tuple[Node, ...]
    span: Span


@record
class MappingNode:
    """Keys with values, in the order of the file."""

    entries: tuple[tuple[Scalar, Node], ...]
    span: Span


Node = Scalar | ListNode | MappingNode


def scalars(node: Node) -> Iterator[Scalar]:
    """All scalars in a node, keys included, in the order of the file."""
    match node:
        case Scalar():
            yield node
        case ListNode(items=items):
            for item in items:
                yield from scalars(item)
        case MappingNode(entries=entries):
            for key, value in entries:
                yield key
                yield from scalars(value)


Place = tuple[str, int, int]
"""A character, and where its written form begins and ends."""

_ESCAPE = re.compile(r"\\(?:x([0-9a-fA-F]{2})|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(.))", re.DOTALL)
_NAMED = {
    "0": "\0", "a": "\a", "b": "\b", "t": "\t", "\t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b",
    "N": "\x85", "_": "\xa0", "L": "\u2028", "P": "\u2029", "\n": " ",
}  # fmt: skip


@record
class ScalarText(Fragment):
    """The text of a scalar that is not read as it is written. `style` is YAML's: `'`, `"`, `|`, `>` or empty."""

    style: str = ""

    def span(self, start: int, end: int) -> Span:
        """The place of characters `start` to `end` of the text in the source; the whole scalar if it is not found."""
        places = _places(self.text, self._written())
        if places is None or not places:
            return self.whole
        first = places[min(start, len(places) - 1)]
        last = places[min(max(end, start + 1), len(places)) - 1]
        at = first[1] if start < len(places) else first[2]  # after the last character
        return Span(self.whole.source, at, max(last[2], at + 1))

    def _written(self) -> Iterator[Place]:
        """The visible characters, as written."""
        raw = self.whole.source.text[self.whole.start : self.whole.end]
        match self.style:
            case "'":
                written = _single_quoted(raw)
            case '"':
                written = _double_quoted(raw)
            case "|" | ">":
                head = raw.find("\n")
                written = ((c, n, n + 1) for n, c in enumerate(raw) if n > head >= 0)
            case _:
                written = ((c, n, n + 1) for n, c in enumerate(raw))
        start = self.whole.start
        return ((c, start + a, start + b) for c, a, b in written if not c.isspace())


def _places(text: str, written: Iterator[Place]) -> list[Place] | None:
    """The place of each character of a text; None if the written characters are others."""
    places: list[Place] = []
    for char in text:
        if char.isspace():
            end = places[-1][2] if places else 0
            places.append((char, end, end))
            continue
        place = next(written, None)
        if place is None or place[0] != char:
            return None
        places.append(place)
    return places


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
