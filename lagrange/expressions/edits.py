"""Text in another notation, rewritten in the language of expressions; places in it are places in the text as written.

Each edit replaces characters `start` to `end` by a new text, whose characters all come from `start`. The edits of one
pass do not overlap, so that a pass takes a time proportional to the length of the text.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import field

from lagrange.core.diagnostics import Fragment, Span
from lagrange.core.records import record
from lagrange.expressions.latex_layout import OneEquation, is_latex

Edit = tuple[int, int, str]
"""Where something begins and ends (exclusive), and what replaces it."""

_OPENING, _CLOSING = "([{", ")]}"


@record
class Rewritten(OneEquation):
    """A fragment that replaces another, `outer`; its character n comes from position `places[n]` there.

    latex  whether it is in LaTeX even where it has neither a backslash nor a `$`
    """

    outer: Fragment = field(default_factory=lambda: Fragment.of(""))
    places: Sequence[int] = ()
    latex: bool = False

    def span(self, start: int, end: int) -> Span:
        """The source span of the characters from `start` to `end`; both may be the end of the text."""
        first = self.places[min(start, len(self.text))]
        last = self.places[max(min(end, len(self.text)) - 1, 0)] + 1 if end > start else first
        return self.outer.span(first, max(last, first))


class Draft:
    """A fragment that is being rewritten."""

    def __init__(self, fragment: Fragment) -> None:
        self.outer = fragment
        self.text = fragment.text
        self._places: list[int] = list(range(len(fragment.text) + 1))

    def apply(self, edits: Iterable[Edit]) -> bool:
        """Make edits; one that overlaps those before it is omitted. Whether there was any."""
        pieces: list[str] = []
        places: list[int] = []
        at = 0
        for start, end, new in sorted(edits, key=lambda e: e[:2]):
            if start < at:
                continue
            pieces += [self.text[at:start], new]
            places += self._places[at:start]
            places += [self._places[start]] * len(new)
            at = end
        if not pieces:
            return False
        self.text = "".join([*pieces, self.text[at:]])
        self._places = places + self._places[at:]
        return True

    def replace(self, pattern: re.Pattern[str], new: str | Callable[[re.Match[str]], str | None]) -> bool:
        """Replace each match of a pattern, unless None is to replace it. Whether there was any."""
        edits = []
        for match in pattern.finditer(self.text):
            text = match.expand(new) if isinstance(new, str) else new(match)
            if text is not None and text != match[0]:
                edits.append((*match.span(), text))
        return self.apply(edits)

    def keep(self, start: int, end: int) -> None:
        """Leave out all but characters `start` to `end`."""
        self.text = self.text[start:end]
        self._places = self._places[start : end + 1]

    def finished(self, latex: bool = False) -> Fragment:
        """The fragment, with the words beside it; the outer one where nothing was changed."""
        if self.text == self.outer.text and not latex:
            return self.outer
        outer, beside = self.outer, getattr(self.outer, "beside", "")
        return Rewritten(self.text, outer.whole, outer.start, outer, tuple(self._places), latex, beside=beside)


def closings(text: str) -> dict[int, int]:
    """The position of each bracket that is closed -> that of the bracket that closes it."""
    ends: dict[int, int] = {}
    opened: list[int] = []
    for at, char in enumerate(text):
        if char in _OPENING:
            opened.append(at)
        elif char in _CLOSING:
            while opened and _OPENING.index(text[opened[-1]]) != _CLOSING.index(char):
                opened.pop()
            if opened:
                ends[opened.pop()] = at
    return ends


def cuts(text: str, separator: re.Pattern[str]) -> list[tuple[int, int]]:
    """The parts of a text between separators outside all brackets."""
    ends = closings(text)
    parts, start, skipped = [], 0, -1
    inside = sorted(ends.items())
    k = 0
    for match in separator.finditer(text):
        while k < len(inside) and inside[k][0] < match.start():
            skipped, k = max(skipped, inside[k][1]), k + 1
        if match.start() > skipped:
            parts.append((start, match.start()))
            start = match.end()
    return [*parts, (start, len(text))]


def cut(fragment: Fragment, start: int, end: int) -> Fragment:
    """A part of a fragment, with its place; the fragment itself if it is all of it."""
    if (start, end) == (0, len(fragment.text)):
        return fragment
    draft = Draft(fragment)
    draft.keep(start, end)
    return draft.finished(latex=is_latex(fragment))
