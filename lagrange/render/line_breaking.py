"""Where a long equation is broken: before the signs of a sum, aligned, the outermost sum first.

A line is filled with terms as long as they fit. A term that is too wide for a line of its own is broken at
the signs inside its bracket, which stand below the first term in that bracket. Widths are measured by
whoever prints: cells of a terminal, or an estimate of ems for TeX. What is returned are lines with their
indentation.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from lagrange.core.records import record
from lagrange.document.pieces import BREAK, END, START, plain

Measure = Callable[[str], float]
_TOKENS = re.compile(f"([{START}{BREAK}{END}])")


@record
class Line:
    """A line of mathematics."""

    indent: float
    code: str


@record
class Breaker:
    """Breaks equations to a width.

    measure    the width of a piece of code
    width      of a line
    hang       how far the second line of a sum is indented that begins at the margin
    """

    measure: Measure
    width: float
    hang: float = 2

    def equation(self, sides: Sequence[str], relation: str) -> list[Line]:
        """a = b = c, from marked sides."""
        whole = f" {relation} ".join(plain(side) for side in sides)
        if self.measure(whole) <= self.width:
            return [Line(0, whole)]
        left = plain(sides[0]) + " "
        column = self.measure(left)
        if len(sides) > 1 and column <= 0.35 * self.width:
            return self._aligned(left, column, sides[1:], relation)
        return self._running(sides, relation)

    def _aligned(self, left: str, column: float, sides: Sequence[str], relation: str) -> list[Line]:
        """Each further side on its own line, the relations below each other."""
        lines: list[Line] = []
        opening = f"{relation} "
        for n, side in enumerate(sides):
            first, *rest = self.sum(side, column + self.measure(opening))
            code = opening + first.code
            lines.append(Line(0, left + code) if n == 0 else Line(column, code))
            lines += rest
        return lines

    def _running(self, sides: Sequence[str], relation: str) -> list[Line]:
        """A long left side, and the rest behind its last line."""
        left, *others = sides
        if others and self.measure(plain(others[0])) <= 0.2 * self.width:  # "= 0" stays with the last term
            left = self._with_tail(left, f" {relation} {plain(others.pop(0))}")
        lines = self.sum(left, 0, self.hang)
        for side in others:
            opening = f"{relation} "
            last = lines[-1]
            together = f"{last.code} {opening}{plain(side)}"
            if last.indent + self.measure(together) <= self.width:
                lines[-1] = Line(last.indent, together)
                continue
            first, *rest = self.sum(side, self.hang + self.measure(opening))
            lines += [Line(self.hang, opening + first.code), *rest]
        return lines

    def _with_tail(self, code: str, tail: str) -> str:
        """A sum with "= 0" behind its last term, or on a line of its own where it would tear that term."""
        if not code.endswith(END):
            return code + tail
        last = f"{outermost(code)[-1]}{tail}"
        fits = self.measure(last) + self.hang <= self.width
        return code.removesuffix(END) + ("" if fits else BREAK) + tail + END

    def sum(self, code: str, start: float, hang: float = 0) -> list[Line]:
        """A marked sum that begins at column `start`, which its first line does not contain."""
        tokens = [token for token in _TOKENS.split(code) if token]
        lines = [Line(start, "")]
        anchors: list[float] = []
        column = start
        for n, token in enumerate(tokens):
            if token == START:
                outer = anchors[-1] if anchors else start + hang
                anchors.append(outer if not anchors and column == start else self._inner(column, outer))
            elif token == END:
                anchors.pop()
            elif token == BREAK:
                if column > anchors[-1] and column + self.measure(_segment(tokens[n + 1 :])) > self.width:
                    lines.append(Line(anchors[-1], ""))
                    column = anchors[-1]
            else:
                fresh = token if lines[-1].code or len(lines) == 1 else token.lstrip()
                lines[-1] = Line(lines[-1].indent, lines[-1].code + fresh)
                column = lines[-1].indent + self.measure(lines[-1].code)
        return lines

    def _inner(self, column: float, outer: float) -> float:
        """Where the lines in a bracket continue: below its first term, unless that is far to the right."""
        return max(column, outer + self.hang) if column <= self.width / 2 else outer + 2 * self.hang


def outermost(code: str) -> list[str]:
    """A marked sum, cut before the signs of its outermost terms."""
    if not code.startswith(START):
        return [plain(code)]
    parts = [""]
    depth = 0
    for token in _TOKENS.split(code):
        if token == START:
            depth += 1
        elif token == END:
            depth -= 1
        elif token == BREAK:
            if depth == 1:
                parts.append("")
        else:
            parts[-1] += token
    return [part.strip() for part in parts]


def _segment(tokens: Sequence[str]) -> str:
    """What stands between a break and the next one that is not inside it."""
    depth = 0
    kept = []
    for token in tokens:
        if token == START:
            depth += 1
        elif token == END:
            depth -= 1
        elif token == BREAK:
            if depth <= 0:
                break
        else:
            kept.append(token)
    return "".join(kept)
