"""Words and lines on a terminal: filling a paragraph whose formulas should not be torn apart.

A short formula counts as one word; a long one may be broken before a relation or before a sign of its
outermost sum. What is wider than the line is broken at its spaces, and at last anywhere.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from rich.cells import cell_len, set_cell_size
from rich.text import Text

from lagrange.document.pieces import plain
from lagrange.render.line_breaking import outermost

SHORT = 28  # cells of a formula that is never broken if it fits on a line


class Words:
    """A paragraph being collected, as words with their styles."""

    def __init__(self) -> None:
        self.words: list[Text] = []
        self._open = False  # whether the next text continues the last word

    @property
    def plain(self) -> str:
        """The paragraph on one line."""
        return " ".join(word.plain for word in self.words)

    def text(self, text: str, style: str = "") -> Words:
        """Adds running text. A no-break space is no place to break a line."""
        for piece in re.split(r"([^\S\u00a0]+)", text):
            if piece and not piece.isspace():
                self._add(Text(piece.replace("\u00a0", " "), style))
            elif piece:
                self._open = False
        return self

    def formula(self, sides: Sequence[str], relation: str) -> Words:
        """Adds a formula a = b = c, from marked sides."""
        whole = f" {relation} ".join(plain(side) for side in sides)
        if cell_len(whole) <= SHORT:
            self._add(Text(whole))
            return self
        for n, side in enumerate(sides):
            for k, part in enumerate(outermost(side)):
                self._open = self._open and n == k == 0
                self._add(Text(f"{relation} {part}" if n and not k else part))
        return self

    def line(self, line: Text) -> Words:
        """Adds a whole line as one word."""
        self.words.append(line)
        return self

    def _add(self, word: Text) -> None:
        if self._open and self.words:
            self.words[-1] = self.words[-1] + word
        else:
            self.words.append(word)
        self._open = True


def fill(words: Words, width: int, hang: int = 0) -> Iterator[Text]:
    """The lines of a paragraph; `hang`: the indentation of all but the first."""
    line: list[Text] = []
    room = 0
    for word in words.words:
        cells = cell_len(word.plain)
        if line and cells < room:
            line.append(word)
            room -= cells + 1
            continue
        if line:
            yield Text(" ").join(line)
        *full, last = _torn(word, width, hang)
        yield from full
        line = [last]
        room = width - cell_len(last.plain)
    if line:
        yield Text(" ").join(line)


def pad(line: Text, right: str, width: int) -> Text:
    """A line filled with spaces to the width, `right` at its end."""
    gap = width - cell_len(line.plain) - cell_len(right)
    return Text.assemble(line, " " * max(gap, 0), (right, "dim"))


def _torn(word: Text, width: int, hang: int) -> list[Text]:
    """A word in pieces that fit: cut at spaces, else anywhere."""
    if cell_len(word.plain) <= width:
        return [word]
    width = max(width, 2)
    leading = len(word.plain) - len(word.plain.lstrip())
    indent, hang = min(leading, width // 4), min(hang, width // 4)
    word = word[leading:]
    pieces: list[Text] = []
    while cell_len(word.plain) > width - indent:
        room = max(width - indent, 2)
        cut = len(set_cell_size(word.plain[: 4 * width], room).rstrip())
        while cut > 1 and cell_len(word.plain[:cut]) > room:
            cut -= 1
        space = word.plain.rfind(" ", 1, cut + 1)
        at = space if space > 0 else _whole_character(word.plain, max(cut, 1))
        pieces.append(Text(" " * indent) + word[:at])
        word = word[at + 1 :] if space > 0 else word[at:]
        indent = min(leading, width // 4) + hang if leading + hang < width // 4 else width // 4 if hang else 0
    return [*pieces, Text(" " * indent) + word]


def _whole_character(text: str, cut: int) -> int:
    """A place to cut that does not separate a letter from its dots."""
    while cut < len(text) and cell_len(text[cut]) == 0:
        cut += 1
    return cut
