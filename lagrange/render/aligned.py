r"""Equations in rows of TeX, broken to a width and aligned at their relations.

What LaTeX and Markdown share: the one sets the rows in `align`, the other in `aligned`. Widths are estimated in ems.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.document.derivation import Block, Equation, Mathematics
from lagrange.document.math_writer import Writer
from lagrange.render.ems import ems
from lagrange.render.line_breaking import Breaker, Line
from lagrange.render.shown import written_out

SHORT = 8.0  # ems of a left side behind which relations are aligned
ALIGN = "\ue003"
"""Where a row is aligned: the place of `&`."""


@record
class Typesetter:
    """Mathematics as rows of TeX.

    writer  for what fits
    wide    for what does not: long fractions and roots can be broken
    """

    writer: Writer
    wide: Writer

    def inline(self, sides: Sequence[Mathematics], relation: str, width: float) -> str:
        """a = b = c in running text."""
        code = self.writer.relation(sides, relation)
        return code if ems(code) <= width else self.wide.relation(sides, relation)

    def rows(self, equation: Equation, width: float, condition: str = "") -> tuple[list[str], list[str]]:
        """The rows of an equation with the condition behind it, or in rows of its own below."""
        relation = self.writer.style.relation(equation.relation)
        for writer in (self.writer, self.wide):
            breaker = Breaker(ems, width, 1)
            lines = breaker.equation([writer.marked(side) for side in equation.sides], relation)
            if all(line.indent + ems(line.code) <= width for line in lines):
                break
        codes = _aligned(lines, relation)
        if condition and lines[-1].indent + ems(lines[-1].code) + 2 + ems(condition) <= width:
            codes[-1] += rf" \qquad {condition}"
            condition = ""
        return codes, [rf"{ALIGN}\qquad {condition}"] if condition else []

    def matrix(self, name: sp.Symbol, rows: Sequence[Sequence[sp.Expr]]) -> tuple[str, float]:
        """M = (a b; c d), and its width."""
        cells = [[self.writer.plain(e) for e in row] for row in rows]
        width = sum(max(ems(row[k]) for row in cells) + 1 for k in range(len(cells[0]))) + 4
        inner = r" \\ ".join(" & ".join(row) for row in cells)
        return rf"{self.writer.plain(name)} = \begin{{pmatrix}} {inner} \end{{pmatrix}}", width

    def matrices(
        self, named: Sequence[tuple[sp.Symbol, Sequence[Sequence[sp.Expr]]]], width: float
    ) -> Iterator[str | tuple[Block, ...]]:
        """Lines of matrices side by side; what stands for one that is too wide."""
        line: list[str] = []
        used = 0.0
        for name, rows in named:
            code, own = self.matrix(name, rows)
            if line and used + own > width:
                yield r" ,\qquad ".join(line)
                line, used = [], 0.0
            if own > width:
                yield written_out(name, rows)
                continue
            line.append(code)
            used += own + 2
        if line:
            yield r" ,\qquad ".join(line)


def at_relations(systems: Sequence[Sequence[str]]) -> bool:
    """Whether several equations can be aligned at their relations: all of them have short left sides."""
    return all(system[0].find(ALIGN) > 0 for system in systems)


def with_ampersand(code: str, at_relation: bool) -> str:
    """A row with the `&` at which it is aligned."""
    return code.replace(ALIGN, "&") if at_relation else "&" + code.replace(ALIGN, "")


def _aligned(lines: Sequence[Line], relation: str) -> list[str]:
    """The lines as rows of `align`, with the place to align before the relation behind a short left side."""
    head, sign, tail = lines[0].code.partition(f" {relation} ")
    if not sign or ems(head) > SHORT:
        return [ALIGN + _growing(_space(line.indent) + line.code, len(lines)) for line in lines]
    rows = [_growing(f"{head} {ALIGN}{relation} {tail}", len(lines))]
    for line in lines[1:]:
        continues = not line.code.startswith(f"{relation} ")
        indent = _space(max(line.indent - ems(head), 1)) if continues else ""
        rows.append(ALIGN + _growing(indent + line.code, len(lines)))
    return rows


def _space(indent: float) -> str:
    if indent < 0.5:
        return ""
    if indent < 1.5:
        return r"\quad "
    return r"\qquad " if indent < 2.5 else rf"\hspace{{{indent:.0f}em}} "


def _growing(code: str, rows: int) -> str:
    r"""Brackets of a fixed size in an equation of several rows: `\left` and `\right` have to be in one."""
    if rows == 1:
        return code
    return re.sub(r"\\left(\\.|.)", r"\\biggl\1", re.sub(r"\\right(\\.|.)", r"\\biggr\1", code))
