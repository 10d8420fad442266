"""Where a long equation is broken: before the signs of its sums, the outermost sum first, continuations aligned.

A line is filled with terms as long as they fit. A term too wide for a line of its own is broken at the signs inside its
bracket; the continuations are aligned below the first term in that bracket, or indented where that is far to the right:

    m l² θ̈
      + (M + m sin²θ) (l θ̈ cos φ
          + g sin φ) = 0

The format supplies the measure: cells of a terminal, or an estimate of ems for TeX. The input is code with the marks
START, BREAK and END of `document.names`; the result is lines with their indentation.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from lagrange.core.records import record
from lagrange.document.names import BREAK, END, START, plain

WidthOf = Callable[[str], float]
_TOKENS = re.compile(f"([{START}{BREAK}{END}])")


@record
class MathLine:
    """A line of mathematics."""

    indent: float
    code: str


@record
class Breaker:
    """Breaks equations to a width.

    measure    the width of a piece of code
    width      of a line
    hang       indentation of the further lines of a sum that begins at the margin
    """

    measure: WidthOf
    width: float
    hang: float = 2

    def equation(self, sides: Sequence[str], relation: str) -> list[MathLine]:
        """a = b = c, from marked sides."""
        on_one_line = f" {relation} ".join(plain(side) for side in sides)
        if self.measure(on_one_line) <= self.width:
            return [MathLine(0, on_one_line)]
        left = plain(sides[0]) + " "
        column = self.measure(left)
        # Behind a longer left side the aligned lines would be too short to be filled well.
        if len(sides) > 1 and column <= 0.35 * self.width:
            return self._aligned(left, column, sides[1:], relation)
        return self._running(sides, relation)

    def _aligned(self, left: str, column: float, sides: Sequence[str], relation: str) -> list[MathLine]:
        """Each further side on its own line, with the relations aligned."""
        lines: list[MathLine] = []
        opening = f"{relation} "
        for n, side in enumerate(sides):
            first, *rest = self.sum(side, column + self.measure(opening))
            code = opening + first.code
            lines.append(MathLine(0, left + code) if n == 0 else MathLine(column, code))
            lines += rest
        return lines

    def _running(self, sides: Sequence[str], relation: str) -> list[MathLine]:
        """A long left side, and the others after its last line."""
        left, *others = sides
        if others and self.measure(plain(others[0])) <= 0.2 * self.width:  # "= 0" stays with the last term
            left = self._with_tail(left, f" {relation} {plain(others.pop(0))}")
        lines = self.sum(left, 0, self.hang)
        for side in others:
            opening = f"{relation} "
            last = lines[-1]
            continued = f"{last.code} {opening}{plain(side)}"
            if last.indent + self.measure(continued) <= self.width:
                lines[-1] = MathLine(last.indent, continued)
                continue
            first, *rest = self.sum(side, self.hang + self.measure(opening))
            lines += [MathLine(self.hang, opening + first.code), *rest]
        return lines

    def _with_tail(self, code: str, tail: str) -> str:
        """A sum with "= 0" after its last term, or on a line of its own where it would force a break in that term."""
        if not code.endswith(END):
            return code + tail
        # Inside the END mark, the tail belongs to the last term: both go to the next line or neither.
        last = f"{outermost(code)[-1]}{tail}"
        fits = self.measure(last) + self.hang <= self.width
        return code.removesuffix(END) + ("" if fits else BREAK) + tail + END

    def sum(self, code: str, start: float, hang: float = 0) -> list[MathLine]:
        """The lines of a marked sum that begins at column `start`; the first line has no indentation of its own.

        One pass over the tokens. `anchors` is a stack with one entry for each open sum: the column at which its further
        lines begin. Each sign begins a new line unless the code up to the next sign of the same sum, inner sums
        included, still fits. So a bracket moves to the next line as a whole if it can, and is broken inside only if it
        is too wide for a line.
        """
        tokens = [token for token in _TOKENS.split(code) if token]
        lines = [MathLine(start, "")]
        anchors: list[float] = []
        column = start
        for n, token in enumerate(tokens):
            if token == START:
                # The outermost sum hangs; a sum in a bracket continues below its own first term.
                outer = anchors[-1] if anchors else start + hang
                anchors.append(outer if not anchors and column == start else self._inner(column, outer))
            elif token == END:
                anchors.pop()
            elif token == BREAK:
                # At the anchor itself nothing is gained by a new line, however wide the segment.
                if column > anchors[-1] and column + self.measure(_segment(tokens[n + 1 :])) > self.width:
                    lines.append(MathLine(anchors[-1], ""))
                    column = anchors[-1]
            else:
                fresh = token if lines[-1].code or len(lines) == 1 else token.lstrip()
                lines[-1] = MathLine(lines[-1].indent, lines[-1].code + fresh)
                column = lines[-1].indent + self.measure(lines[-1].code)
        return lines

    def _inner(self, column: float, outer: float) -> float:
        """The column at which lines in a bracket continue: below its first term, unless that is far to the right."""
        return max(column, outer + self.hang) if column <= self.width / 2 else outer + 2 * self.hang


def outermost(code: str) -> list[str]:
    """The terms of a marked sum, cut before their signs; brackets are not cut, nor is a quotient before its bar."""
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
    pieces: list[str] = []
    for part in parts:
        if pieces and part.startswith("/"):
            pieces[-1] += part.strip()
        else:
            pieces.append(part.strip())
    return pieces


def _segment(tokens: Sequence[str]) -> str:
    """The code from a break up to the next break of the same sum or of one around it, without marks."""
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
