"""A derivation on a terminal. The only module that imports rich.

Every line is laid out here, to the cell: prose is filled with formulas held together, equations are broken
at their terms with the number at the right margin, results stand in a box, tables are turned or stacked
where they are too wide. rich is used for colours and for the terminal's manners (NO_COLOR, pipes, widths).
Nothing is ever wider than the console, and nothing is said by colour alone.
"""

from __future__ import annotations

import sys
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from io import StringIO
from itertools import groupby

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from lagrange.document.derivation import (
    Block,
    CheckMark,
    Derivation,
    Detail,
    Display,
    Equation,
    Math,
    Matrices,
    Part,
    Prose,
    Ref,
    Step,
    Table,
    Term,
)
from lagrange.document.math_writer import UNICODE, Notation, Writer
from lagrange.render.line_breaking import Breaker
from lagrange.render.matrices import matrix_lines, side_by_side
from lagrange.render.paragraphs import Words, fill, pad
from lagrange.render.shown import Shown, shown, written_out
from lagrange.render.tables import Grid, table_lines

WIDEST = 100  # a longer line is hard to read
NARROW = 24  # there is no room for a box
MARGIN = " "
INDENT = "    "
COLUMNS = 3  # between a check and how it was done
MARKS = {True: ("✓", "bold green"), False: ("✗", "bold red"), None: ("?", "bold magenta")}


def show(
    derivation: Derivation,
    notation: Notation,
    width: int | None = None,
    detail: Detail = Detail.STEPS,
    console: Console | None = None,
) -> None:
    """Prints a derivation to standard output, or to another console."""
    console = console or Console(width=width)
    page = Text("\n").join(lines(derivation, notation, width or console.width, detail))
    console.print(page, soft_wrap=True, highlight=False)


def coloured(derivation: Derivation, notation: Notation, width: int, detail: Detail = Detail.STEPS) -> str:
    """The derivation for standard output: coloured where that is a terminal, and the environment wants colours."""
    file = StringIO()
    on_terminal = sys.stdout is not None and sys.stdout.isatty()
    console = Console(file=file, width=width, force_terminal=on_terminal or None)
    show(derivation, notation, width, detail, console)
    return file.getvalue()


def text(derivation: Derivation, notation: Notation, width: int, detail: Detail = Detail.STEPS) -> str:
    """The derivation as it is printed, without colours."""
    return "".join(line.plain + "\n" for line in lines(derivation, notation, width, detail))


def lines(derivation: Derivation, notation: Notation, width: int, detail: Detail = Detail.STEPS) -> Iterator[Text]:
    """The lines of a derivation, none wider than `width` cells."""
    inner = max(min(width - 1, WIDEST) - len(MARGIN), 8)
    page = _Page(Writer(UNICODE, notation), shown(derivation, detail), inner)
    for line in page.all(derivation):
        line.rstrip()
        yield Text.assemble(MARGIN, line) if line else line


class _Page:
    """One derivation at one width."""

    def __init__(self, writer: Writer, content: Shown, width: int) -> None:
        self.writer = writer
        self.content = content
        self.width = width

    def all(self, derivation: Derivation) -> Iterator[Text]:
        yield from self.heading(clean(derivation.title), clean(derivation.source))
        for number, step in enumerate(self.content.steps, 1):
            if number > 1:
                yield Text()
            yield from self.step(number, step)

    def heading(self, title: str, source: str) -> Iterator[Text]:
        gap = self.width - cell_len(title) - cell_len(source)
        if gap >= 2 or not source:
            yield (Text.assemble((title, "bold"), " " * gap, (source, "dim")) if source else Text(title, "bold"))
        else:
            yield from fill(Words().text(title, "bold"), self.width)
            yield from fill(Words().text(source, "dim"), self.width)
        yield Text("─" * self.width, "dim")

    def step(self, number: int, step: Step) -> Iterator[Text]:
        words = Words().text(clean(step.title), "bold")
        label = f"{number:<{len(INDENT) - 2}} "
        for n, line in enumerate(fill(words, self.width - len(label))):
            yield Text.assemble((label, "bold") if n == 0 else " " * len(label), line)
        inner = self.width - len(INDENT)
        for kind, blocks in groupby(step.body, key=type):
            if kind is CheckMark:
                content = self.checks([b for b in blocks if isinstance(b, CheckMark)], inner)
            else:
                content = (line for block in blocks for line in self.block(block, inner))
            yield from (Text.assemble(INDENT, line) for line in content)

    def block(self, block: Block, width: int) -> Iterator[Text]:
        match block:
            case Prose():
                yield from fill(self.words(block.parts), width)
            case Display():
                boxed = block.boxed and width >= NARROW
                yield from self.boxed(block, width) if boxed else self.display(block, width)
            case Table():
                yield from self.table(block, width)
            case Matrices():
                yield from self.matrices(block, width)

    # Prose

    def words(self, parts: Iterable[Part]) -> Words:
        words = Words()
        for part in parts:
            match part:
                case Math():
                    words.formula([self.writer.marked(s) for s in part.sides], self.relation(part.relation))
                case Ref() if part.label in self.content.numbers:
                    words.text(f"({self.content.numbers[part.label]})")
                case Ref() if part.label in self.content.hidden:
                    hidden = self.content.hidden[part.label]
                    words.formula([self.writer.marked(s) for s in hidden.sides], self.relation(hidden.relation))
                case Ref():
                    words.text("(?)")
                case Term():
                    words.text(clean(part.word), "bold")
                case _:
                    words.text(clean(part))
        return words

    def relation(self, relation: str) -> str:
        return self.writer.style.relation(relation)

    # Equations

    def display(self, block: Display, width: int) -> Iterator[Text]:
        gutter = max((len(self.number(e)) for e in block.equations), default=0)
        for code, number in self.equations(block.equations, width - 2 - gutter):
            yield pad(Text("  ") + code, number, width)

    def boxed(self, block: Display, width: int) -> Iterator[Text]:
        gutter = max((len(self.number(e)) for e in block.equations), default=0)
        content = list(self.equations(block.equations, width - 6 - gutter))
        inner = max((cell_len(code.plain) for code, _ in content), default=0) + gutter + 4
        yield Text("╭" + "─" * inner + "╮", "dim")
        for code, number in content:
            yield Text.assemble(("│", "dim"), pad(Text("  ") + code, number, inner - 1), " ", ("│", "dim"))
        yield Text("╰" + "─" * inner + "╯", "dim")

    def number(self, equation: Equation) -> str:
        """The number with the space before it."""
        number = self.content.numbers.get(equation.label or "")
        return f"    ({number})" if number else ""

    def equations(self, equations: Sequence[Equation], width: int) -> Iterator[tuple[Text, str]]:
        """The lines of equations, each with the number that stands behind it."""
        broken = [self.broken(equation, width) for equation in equations]
        self.align(equations, broken, width)
        for n, (equation, found) in enumerate(zip(equations, broken, strict=True)):
            if n and max(len(found), len(broken[n - 1])) > 1:
                yield Text(), ""
            yield from ((line, "") for line in found[:-1])
            last, *below = self.with_condition(found[-1], equation, width)
            yield last, self.number(equation).strip()
            yield from ((line, "") for line in below)

    def broken(self, equation: Equation, width: int) -> list[Text]:
        """An equation in lines that fit."""
        sides = [self.writer.marked(side) for side in equation.sides]
        found = Breaker(cell_len, width).equation(sides, self.relation(equation.relation))
        whole = (Text(" " * round(line.indent) + line.code) for line in found)
        return [part for line in whole for part in fill(Words().line(line), width, hang=4)]

    def align(self, equations: Sequence[Equation], broken: list[list[Text]], width: int) -> None:
        """Shifts short left sides so that the relations stand below each other."""
        if len(equations) < 2 or any(len(found) > 1 for found in broken):
            return
        lefts = [cell_len(self.writer.plain(e.sides[0])) for e in equations]
        most = max(lefts)
        shifted = [Text(" " * (most - left)) + found[0] for left, found in zip(lefts, broken, strict=True)]
        if most <= 12 and all(cell_len(line.plain) <= width for line in shifted):
            broken[:] = [[line] for line in shifted]

    def with_condition(self, last: Text, equation: Equation, width: int) -> list[Text]:
        """The last line of an equation with its condition behind it, or below where there is no room."""
        if not equation.condition:
            return [last]
        words = self.words(equation.condition)
        room = width - cell_len(last.plain) - 4
        if cell_len(words.plain) <= room:
            return [Text.assemble(last, " " * 4, *fill(words, room))]
        return [last, *(Text("  ") + line for line in fill(words, width - 2))]

    # Matrices, tables and checks

    def matrices(self, block: Matrices, width: int) -> Iterator[Text]:
        """Those that fit side by side, the others entry by entry."""
        drawn = []
        wide = []
        for name, rows in block.named:
            lines = matrix_lines(self.writer.plain(name), [[self.writer.plain(e) for e in row] for row in rows])
            if cell_len(lines[0]) <= width - 2:
                drawn.append(lines)
            else:
                wide.append((name, rows))
        yield from (Text("  " + line if line else "") for line in side_by_side(drawn, width - 2))
        for name, rows in wide:
            for part in written_out(name, rows):
                yield from self.block(part, width)

    def table(self, block: Table, width: int) -> Iterator[Text]:
        grid: Grid = [[self.words([part]) for part in row] for row in (block.header, *block.rows)]
        yield from (Text("  ") + line for line in table_lines(grid, width - 2))

    def checks(self, checks: Sequence[CheckMark], width: int) -> Iterator[Text]:
        names = [self.words(check.name) for check in checks]
        room = width - 2
        longest = max(cell_len(words.plain) for words in names)
        ways = max(cell_len(clean(check.how)) for check in checks)
        fits = longest + COLUMNS + ways <= room
        left = longest if fits else min(longest, room * 3 // 5)
        right = room - left - COLUMNS
        beside = right >= min(20, ways)
        for check, words in zip(checks, names, strict=True):
            mark, style = MARKS[check.passed]
            how = Words().text(clean(check.how), "dim")
            first = [*fill(words, left if beside else room)]
            second = [*fill(how, right)] if beside else []
            rows = max(len(first), len(second))
            for n in range(rows):
                name = first[n] if n < len(first) else Text()
                way = second[n] if n < len(second) else Text()
                yield Text.assemble((mark, style) if n == 0 else " ", " ", _spaced(name, left + COLUMNS, way))
            if not beside:
                yield from (Text("    ") + line for line in fill(how, room - 2))


def _spaced(name: Text, column: int, way: Text) -> Text:
    return Text.assemble(name, " " * (column - cell_len(name.plain)), way) if way else name


def clean(words: str) -> str:
    """Text without characters that steer a terminal."""
    spaced = (" " if c.isspace() else c for c in words)
    return "".join(c for c in spaced if unicodedata.category(c) not in ("Cc", "Cf"))
