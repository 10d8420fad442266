"""A line of text in runs of one style each, as a terminal shows them.

rich has the same and much more; a page that goes to a pipe has no colours, and importing rich and its texts would take
as long as laying out the page. Styles are rich's words: `bold`, `dim`, `bold green`; without a style a run is as it is.
"""

from __future__ import annotations

from collections.abc import Iterable


class Styled:
    """An immutable line of runs (text, style)."""

    __slots__ = ("plain", "runs")

    def __init__(self, text: str = "", style: str = "") -> None:
        self.plain = text
        self.runs: tuple[tuple[str, str], ...] = ((text, style),) if text else ()

    @classmethod
    def assemble(cls, *parts: str | tuple[str, str] | Styled) -> Styled:
        """The parts one after another."""
        runs: list[tuple[str, str]] = []
        for part in parts:
            if isinstance(part, Styled):
                runs += part.runs
            else:
                run = (part, "") if isinstance(part, str) else part
                runs += [run] if run[0] else []
        made = cls()
        made.runs = tuple(runs)
        made.plain = "".join([text for text, _ in runs])
        return made

    def joined(self, lines: Iterable[Styled]) -> Styled:
        """The lines with this one between each two of them."""
        return Styled.assemble(*[part for n, line in enumerate(lines) for part in ((self, line) if n else (line,))])

    def stripped(self) -> Styled:
        """Without the spaces at its end."""
        return self[: len(self.plain.rstrip())]

    def __add__(self, other: Styled) -> Styled:
        return Styled.assemble(self, other)

    def __bool__(self) -> bool:
        return bool(self.plain)

    def __getitem__(self, part: slice) -> Styled:
        start, stop, _ = part.indices(len(self.plain))
        if start == 0 and stop == len(self.plain):
            return self
        pieces: list[tuple[str, str]] = []
        before = 0
        for text, style in self.runs:
            pieces.append((text[max(start - before, 0) : max(stop - before, 0)], style))
            before += len(text)
        return Styled.assemble(*pieces)
