"""A derivation on a terminal. The only module that imports rich.

Every line is laid out here, to the cell: paragraphs are filled without tearing formulas apart, equations are broken at
their terms with the number at the right margin, results are boxed, tables that are too wide are turned or stacked. rich
provides colours and knows the terminal (NO_COLOR, pipes, widths). No line is ever wider than the console, and colour
never carries meaning alone.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from io import StringIO
from typing import TYPE_CHECKING

from rich.cells import cell_len

from lagrange.core.printable import printable
from lagrange.document.derivation import (
    CheckMark,
    Derivation,
    Detail,
    Display,
    Emphasis,
    Equation,
    Math,
    Matrices,
    Part,
    Prose,
    Ref,
    Step,
    Table,
    Task,
)
from lagrange.document.math_writer import BOLD, Notation, Writer
from lagrange.render.limits import ALIGNED_LEFT_SIDE, NARROWEST_BOX, WIDEST_PAGE
from lagrange.render.line_breaking import Breaker
from lagrange.render.selection import Emitter, ShownSteps, block_lines, entry_by_entry, shown
from lagrange.render.terminal_layout import (
    Grid,
    Styled,
    StyledWords,
    fill,
    matrix_lines,
    pad,
    side_by_side,
    table_lines,
)

if TYPE_CHECKING:
    from rich.console import Console

MARGIN = " "
INDENT = "    "
HEIGHT = 25  # lines, which nothing depends on; or rich would read LINES, and stumble over `LINES=²`
COLUMNS = 3  # between a check and how it was done
ASKS_FOR_COLOURS = frozenset({"FORCE_COLOR", "TTY_COMPATIBLE"})  # in a pipe too; rich knows what their values mean
MARKS = {True: ("✓", "bold green"), False: ("✗", "bold red"), None: ("?", "bold magenta")}


def show(
    derivation: Derivation,
    notation: Notation,
    width: int | None = None,
    detail: Detail = Detail.STEPS,
    console: Console | None = None,
) -> None:
    """Print a derivation to standard output, or to another console."""
    from rich.console import Console
    from rich.text import Text

    console = console or Console(width=width)
    shown_lines = printed_lines(derivation, notation, width or console.width, detail)
    page = Text("\n").join(Text.assemble(*line.runs) for line in shown_lines)
    console.print(page, soft_wrap=True, highlight=False)


def coloured(derivation: Derivation, notation: Notation, width: int, detail: Detail = Detail.STEPS) -> str:
    """The derivation for standard output: coloured where that is a terminal, and the environment allows colours."""
    on_terminal = sys.stdout is not None and sys.stdout.isatty()
    if not on_terminal and ASKS_FOR_COLOURS.isdisjoint(os.environ):
        return text(derivation, notation, width, detail)
    from rich.console import Console

    file = StringIO()
    console = Console(file=file, width=width, height=HEIGHT, force_terminal=on_terminal or None)
    show(derivation, notation, width, detail, console)
    return file.getvalue()


def text(derivation: Derivation, notation: Notation, width: int, detail: Detail = Detail.STEPS) -> str:
    """The derivation as it is printed, without colours."""
    return "".join(line.plain + "\n" for line in printed_lines(derivation, notation, width, detail))


def printed_lines(
    derivation: Derivation, notation: Notation, width: int, detail: Detail = Detail.STEPS
) -> Iterator[Styled]:
    """The lines of a derivation, none wider than `width` cells."""
    inner = max(min(width - 1, WIDEST_PAGE) - len(MARGIN), 8)
    page = _Page(Writer(BOLD, notation, on_page=True), shown(derivation, detail, folded=False), inner)
    for line in page.all(derivation):
        line = line.stripped()
        yield Styled.assemble(MARGIN, line) if line else line


class _Page(Emitter[Styled]):
    """One derivation at one width."""

    def __init__(self, writer: Writer, content: ShownSteps, width: int) -> None:
        self.writer = writer
        self.content = content
        self.width = width
        self.room = width - len(INDENT)

    def all(self, derivation: Derivation) -> Iterator[Styled]:
        yield from self.heading(printable(derivation.title), printable(derivation.source))
        number = 0
        for place, step in enumerate(self.content.steps):
            if place and step.title:
                yield Styled()
            number += bool(step.title)
            yield from self.step(number, step)
        if self.content.folded:
            yield Styled()
        for words, choice in self.content.folded.items():
            yield from fill(self.words(("▸ ", *words, f"  (--choice {choice or 'all'})")), self.width)

    def heading(self, title: str, source: str) -> Iterator[Styled]:
        gap = self.width - cell_len(title) - cell_len(source)
        if gap >= 2 or not source:
            yield (Styled.assemble((title, "bold"), " " * gap, (source, "dim")) if source else Styled(title, "bold"))
        else:
            yield from fill(StyledWords().text(title, "bold"), self.width)
            yield from fill(StyledWords().text(source, "dim"), self.width)
        yield Styled("─" * self.width, "dim")

    def step(self, number: int, step: Step) -> Iterator[Styled]:
        if not step.title:
            indent = INDENT if number else ""
            yield from (Styled.assemble(indent, line) for line in block_lines(step.body, self))
            return
        words = StyledWords().text(printable(step.title), "bold")
        label = f"{number:<{len(INDENT) - 2}} "
        for n, line in enumerate(fill(words, self.width - len(label))):
            yield Styled.assemble((label, "bold") if n == 0 else " " * len(label), line)
        yield from (Styled.assemble(INDENT, line) for line in block_lines(step.body, self))

    # Words

    def paragraphs(self, run: Sequence[Prose]) -> Iterator[Styled]:
        return (line for block in run for line in fill(self.words(block.parts), self.room, prose=True))

    def words(self, parts: Iterable[Part]) -> StyledWords:
        words = StyledWords()
        for part in parts:
            match self.content.resolved(part):
                case Math(sides=sides, relation=relation):
                    words.formula([self.writer.marked(s) for s in sides], self.relation(relation))
                case Ref(label=label):
                    words.text(f"({self.content.numbers[label]})")
                case Emphasis(word=word):
                    words.text(printable(word), "bold")
                case str(text):
                    words.text(printable(text))
        return words

    def relation(self, relation: str) -> str:
        return self.writer.style.relation(relation)

    # Equations

    def display(self, block: Display) -> Iterator[Styled]:
        gutter = max((len(self.number(e)) for e in block.equations), default=0)
        if block.boxed and self.room >= NARROWEST_BOX:
            yield from self.boxed(block.equations, gutter)
            return
        for code, number in self.equations(block.equations, self.room - 2 - gutter):
            yield pad(Styled("  ") + code, number, self.room)

    def boxed(self, equations: Sequence[Equation], gutter: int) -> Iterator[Styled]:
        content = list(self.equations(equations, self.room - 6 - gutter))
        inner = max((cell_len(code.plain) for code, _ in content), default=0) + gutter + 4
        yield Styled("╭" + "─" * inner + "╮", "dim")
        for code, number in content:
            yield Styled.assemble(("│", "dim"), pad(Styled("  ") + code, number, inner - 1), " ", ("│", "dim"))
        yield Styled("╰" + "─" * inner + "╯", "dim")

    def number(self, equation: Equation) -> str:
        """The number with the space before it."""
        number = self.content.number(equation)
        return f"    {number}" if number else ""

    def equations(self, equations: Sequence[Equation], width: int) -> Iterator[tuple[Styled, str]]:
        """The lines of equations, each with the number at its right."""
        numbered = [*self.apart(equations, width)]
        equations = [e for e, _ in numbered]
        broken = [self.broken(equation, width) for equation in equations]
        self.align(equations, broken, width)
        for n, ((equation, number), rows) in enumerate(zip(numbered, broken, strict=True)):
            if n and max(len(rows), len(broken[n - 1])) > 1:  # or one could not see where an equation ends
                yield Styled(), ""
            yield from ((line, "") for line in rows[:-1])
            last, *below = self.with_condition(rows[-1], equation, width)
            yield last, number
            yield from ((line, "") for line in below)

    def apart(self, equations: Sequence[Equation], width: int) -> Iterator[tuple[Equation, str]]:
        """The equations with their numbers; two in a line on lines of their own where there is no room."""
        lefts = [cell_len(self.writer.plain(e.sides[0])) for e in equations]
        widest = max(lefts, default=0)
        for e, left in zip(equations, lefts, strict=True):
            number = self.number(e).strip()
            match e.condition:
                case (Math(sides=sides, relation=relation),) if len(equations) > 1:
                    shift = widest - left if widest <= ALIGNED_LEFT_SIDE else 0
                    pair = (self.writer.plain(side) for both in (e.sides, sides) for side in both)
                    room = width - shift - 4 - 3 * (len(e.sides) + len(sides) - 2)
                    if sum(map(cell_len, pair)) > room:
                        yield replace(e, condition=()), ""
                        yield Equation(sides, relation=relation), number
                        continue
            yield e, number

    def broken(self, equation: Equation, width: int) -> list[Styled]:
        """An equation in lines that fit."""
        sides = [self.writer.marked(side) for side in equation.sides]
        broken = Breaker(cell_len, width).equation(sides, self.relation(equation.relation))
        rows = (Styled(" " * round(line.indent) + line.code) for line in broken)
        # A factor without a sign to break at may still be too wide: `fill` tears it at spaces, at worst anywhere.
        return [piece for row in rows for piece in fill(StyledWords().line(row), width, hang=4)]

    def align(self, equations: Sequence[Equation], broken: list[list[Styled]], width: int) -> None:
        """Shift short left sides to the right, so that the relations are aligned."""
        if len(equations) < 2 or any(len(rows) > 1 for rows in broken):
            return
        lefts = [cell_len(self.writer.plain(e.sides[0])) for e in equations]
        widest = max(lefts)
        shifted = [Styled(" " * (widest - left)) + rows[0] for left, rows in zip(lefts, broken, strict=True)]
        if widest <= ALIGNED_LEFT_SIDE and all(cell_len(line.plain) <= width for line in shifted):
            broken[:] = [[line] for line in shifted]

    def with_condition(self, last: Styled, equation: Equation, width: int) -> list[Styled]:
        """The last line of an equation followed by its condition, which goes below where there is no room."""
        if not equation.condition:
            return [last]
        words = self.words(equation.condition)
        room = width - cell_len(last.plain) - 4
        if cell_len(words.plain) <= room:
            return [Styled.assemble(last, " " * 4, *fill(words, room))]
        return [last, *(Styled("  ") + line for line in fill(words, width - 2))]

    # Matrices, tables and checks

    def matrices(self, block: Matrices) -> Iterator[Styled]:
        """Those that fit on a line side by side, the others entry by entry."""
        room = self.room - 2
        drawn = []
        wide = []
        for name, rows in block.named:
            lines = matrix_lines(self.writer.plain(name), [[self.writer.plain(e) for e in row] for row in rows])
            if cell_len(lines[0]) <= room:
                drawn.append(lines)
            else:
                wide.append((name, rows))
        yield from (Styled("  " + line if line else "") for line in side_by_side(drawn, room))
        for name, rows in wide:
            yield from block_lines(entry_by_entry(name, rows), self)

    def task(self, block: Task) -> Iterator[Styled]:
        yield from fill(self.words(block.parts), self.room)
        yield from (Styled() for _ in range(block.lines))

    def table(self, block: Table) -> Iterator[Styled]:
        grid: Grid = [[self.words([part]) for part in row] for row in (block.header, *block.rows)]
        yield from (Styled("  ") + line for line in table_lines(grid, self.room - 2))

    def checks(self, run: Sequence[CheckMark]) -> Iterator[Styled]:
        names = [self.words(check.name) for check in run]
        room = self.room - 2
        longest = max(cell_len(words.plain) for words in names)
        ways = max(cell_len(printable(check.how)) for check in run)
        fits = longest + COLUMNS + ways <= room
        # Three fifths at most, so that both columns hold words; all of it where nothing is said of how.
        left = longest if fits else min(longest, room * 3 // 5) if ways else room
        right = room - left - COLUMNS
        beside = ways > 0 and right >= min(20, ways)
        for check, words in zip(run, names, strict=True):
            mark, style = MARKS[check.passed]
            how = StyledWords().text(printable(check.how), "dim")
            first = [*fill(words, left if beside else room)]
            second = [*fill(how, right)] if beside else []
            rows = max(len(first), len(second))
            for n in range(rows):
                name = first[n] if n < len(first) else Styled()
                way = second[n] if n < len(second) else Styled()
                yield Styled.assemble((mark, style) if n == 0 else " ", " ", _spaced(name, left + COLUMNS, way))
            if not beside:
                yield from (Styled("    ") + line for line in fill(how, room - 2))


def _spaced(name: Styled, column: int, way: Styled) -> Styled:
    return Styled.assemble(name, " " * (column - cell_len(name.plain)), way) if way else name
