"""Paragraphs, matrices and tables in cells of a terminal.

In a paragraph a short formula counts as one word; a long one may be broken before a relation or before a sign of its
outermost sum. A word wider than the line is split at spaces, or anywhere if it has none. Matrices have brackets made of
pieces, and entries centred in their columns:

    M = ⎛ 2 m l²  m l² ⎞
        ⎝ m l²    m l² ⎠

A table stays as it is if it fits. Otherwise it is turned, then squeezed so that cells wrap between words, then stacked
entry by entry: the first of these that fits. Widths are counted in cells, of which a letter such as 力 takes two and a
combining dot none.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from rich.cells import cell_len, set_cell_size

from lagrange.document.names import plain
from lagrange.render.limits import ALONE, SHORT_SIDE, UNBROKEN_FORMULA
from lagrange.render.line_breaking import outermost

MATRIX_GAP = 2
LEFT, RIGHT = "⎛⎜⎝", "⎞⎟⎠"


def matrix_lines(name: str, cells: Sequence[Sequence[str]]) -> list[str]:
    """The lines of `name = (cells)`, all of one width."""
    rows = len(cells)
    widths = [max(cell_len(row[c]) for row in cells) for c in range(len(cells[0]))]
    lines = []
    for n, row in enumerate(cells):
        left, right = ("(", ")") if rows == 1 else (_piece(LEFT, n, rows), _piece(RIGHT, n, rows))
        inner = (" " * MATRIX_GAP).join(_centred(cell, width) for cell, width in zip(row, widths, strict=True))
        head = f"{name} = " if n == (rows - 1) // 2 else " " * (cell_len(name) + 3)
        lines.append(f"{head}{left} {inner} {right}")
    return lines


def _piece(pieces: str, n: int, rows: int) -> str:
    return pieces[0] if n == 0 else pieces[2] if n == rows - 1 else pieces[1]


def _centred(cell: str, width: int) -> str:
    left = (width - cell_len(cell)) // 2
    return " " * left + cell + " " * (width - cell_len(cell) - left)


def side_by_side(blocks: Sequence[Sequence[str]], width: int) -> Iterator[str]:
    """Blocks of lines next to each other as far as they fit, shorter ones centred vertically."""
    row: list[Sequence[str]] = []
    for block in blocks:
        if row and sum(cell_len(b[0]) + 4 for b in row) + cell_len(block[0]) > width:
            yield from _row(row)
            yield ""
            row = []
        row.append(block)
    if row:
        yield from _row(row)


def _row(blocks: Sequence[Sequence[str]]) -> Iterator[str]:
    height = max(map(len, blocks))
    padded = []
    for block in blocks:
        above = (height - len(block)) // 2
        blank = " " * cell_len(block[0])
        padded.append([*[blank] * above, *block, *[blank] * (height - len(block) - above)])
    yield from ("    ".join(lines).rstrip() for lines in zip(*padded, strict=True))


class StyledWords:
    """A paragraph being built: words with their styles."""

    def __init__(self) -> None:
        self.words: list[Styled] = []
        self._open = False  # whether the next text continues the last word

    @property
    def plain(self) -> str:
        """The paragraph on one line."""
        return " ".join(word.plain for word in self.words)

    def text(self, text: str, style: str = "") -> StyledWords:
        """Add running text. A line is never broken at a no-break space."""
        for piece in re.split(r"([^\S\u00a0]+)", text):
            if piece and not piece.isspace():
                self._add(Styled(piece.replace("\u00a0", " "), style))
            elif piece:
                self._open = False
        return self

    def formula(self, sides: Sequence[str], relation: str) -> StyledWords:
        """Add a formula a = b = c, from marked sides."""
        on_one_line = f" {relation} ".join(plain(side) for side in sides)
        if cell_len(on_one_line) <= UNBROKEN_FORMULA:
            self._add(Styled(on_one_line))
            return self
        pieces: list[str] = []
        for n, side in enumerate(sides):
            for k, part in enumerate(outermost(side)):
                piece = f"{relation} {part}" if n and not k else part
                # "y = ..." keeps its first term, and "... = const" stays with the last one.
                together = f"{pieces[-1]} {piece}" if n and not k else ""
                short = bool(together) and min(cell_len(pieces[-1]), cell_len(piece)) <= SHORT_SIDE
                if short and cell_len(together) <= UNBROKEN_FORMULA:
                    pieces[-1] = together
                else:
                    pieces.append(piece)
        for n, piece in enumerate(pieces):
            self._open = self._open and n == 0  # a bracket before the formula sticks to its first piece only
            self._add(Styled(piece))
        return self

    def line(self, line: Styled) -> StyledWords:
        """Add a line as one word."""
        self.words.append(line)
        return self

    def _add(self, word: Styled) -> None:
        if self._open and self.words:
            self.words[-1] = self.words[-1] + word
        else:
            self.words.append(word)
        self._open = True


def fill(words: StyledWords, width: int, hang: int = 0, *, prose: bool = False) -> Iterator[Styled]:
    """The lines of a paragraph. `hang` indents all lines of a torn word but its first.

    prose  whether no short word stands alone on the last line
    """
    rows: list[list[Styled]] = []
    room = 0
    for word in words.words:
        cells = cell_len(word.plain)
        if rows and cells < room:
            rows[-1].append(word)
            room -= cells + 1
            continue
        rows += ([piece] for piece in _torn(word, width, hang))
        room = width - cell_len(rows[-1][0].plain)
    if prose and len(rows) > 1 and len(rows[-1]) == 1 and len(rows[-2]) > 2:
        [last] = rows[-1]
        if cell_len(last.plain) <= ALONE and cell_len(last.plain) + cell_len(rows[-2][-1].plain) < width:
            rows[-1].insert(0, rows[-2].pop())
    yield from (Styled(" ").joined(row) for row in rows)


def pad(line: Styled, right: str, width: int) -> Styled:
    """A line padded to the width, with `right` at its end."""
    gap = width - cell_len(line.plain) - cell_len(right)
    return Styled.assemble(line, " " * max(gap, 0), (right, "dim"))


def _torn(word: Styled, width: int, hang: int) -> list[Styled]:
    """A word in pieces that fit: cut at spaces, or anywhere if there are none."""
    if cell_len(word.plain) <= width:
        return [word]
    width = max(width, 2)
    leading = len(word.plain) - len(word.plain.lstrip())
    indent, hang = min(leading, width // 4), min(hang, width // 4)
    word = word[leading:]
    pieces: list[Styled] = []
    while cell_len(word.plain) > width - indent:
        room = max(width - indent, 2)
        # About as many characters as fill `room` cells: wide letters and combining dots make it a guess.
        cut = len(set_cell_size(word.plain[: 4 * width], room).rstrip())
        while cut > 1 and cell_len(word.plain[:cut]) > room:
            cut -= 1
        space = word.plain.rfind(" ", 1, cut + 1)
        at = space if space > 0 else _whole_character(word.plain, max(cut, 1))
        pieces.append(Styled(" " * indent) + word[:at])
        word = word[at + 1 :] if space > 0 else word[at:]
        indent = min(leading, width // 4) + hang if leading + hang < width // 4 else width // 4 if hang else 0
    return [*pieces, Styled(" " * indent) + word]


def _whole_character(text: str, cut: int) -> int:
    """A place to cut that does not separate a letter from its dots."""
    while cut < len(text) and cell_len(text[cut]) == 0:
        cut += 1
    return cut


Grid = list[list[StyledWords]]  # the first row is the header, the first column names the rows
COLUMN_GAP = 3
NOTHING = "–"  # the cell of what a row does not have


def table_lines(grid: Grid, width: int) -> Iterator[Styled]:
    """The lines of a table, none wider than `width`."""
    turned = [list(column) for column in zip(*grid, strict=True)]
    for candidate in (grid, turned):
        widths = _natural(candidate)
        if _total(widths) <= width:
            return _ruled(candidate, widths)
    for candidate in (grid, turned):
        squeezed = _squeezed(candidate, width)
        if squeezed is not None:
            return _ruled(candidate, squeezed)
    return _in_parts(turned, width) or _stacked(grid, width)


def _natural(grid: Grid) -> list[int]:
    return [max(cell_len(row[k].plain) for row in grid) for k in range(len(grid[0]))]


def _total(widths: Sequence[int]) -> int:
    return sum(widths) + COLUMN_GAP * (len(widths) - 1)


def _squeezed(grid: Grid, width: int) -> list[int] | None:
    """Widths after narrowing the widest columns until all fit; None if that would tear words or formulas."""
    widths = _natural(grid)
    least = [
        max(cell_len(word.plain) for row in grid for word in row[k].words or [Styled()]) for k in range(len(widths))
    ]
    while _total(widths) > width:
        slack = [k for k in range(len(widths)) if widths[k] > least[k]]
        if not slack:
            return None
        widths[max(slack, key=widths.__getitem__)] -= 1
    return widths


def _in_parts(grid: Grid, width: int) -> Iterator[Styled] | None:
    """Several tables with about as many columns each; None where not even two columns fit beside the first."""
    count = len(grid[0]) - 1
    for columns in sorted({-(-count // parts) for parts in range(2, count)}, reverse=True):
        if columns < 2:
            break
        parts = [[[row[0], *row[k : k + columns]] for row in grid] for k in range(1, count + 1, columns)]
        parts = [[row for row in part if any(cell.plain != NOTHING for cell in row[1:])] for part in parts]
        if all(_total(_natural(part)) <= width for part in parts):
            return _one_below_another(parts)
    return None


def _one_below_another(parts: Sequence[Grid]) -> Iterator[Styled]:
    for n, part in enumerate(parts):
        if n > 0:
            yield Styled()
        yield from _ruled(part, _natural(part))


def _ruled(grid: Grid, widths: Sequence[int]) -> Iterator[Styled]:
    """Columns with a thin line between them and below the header."""
    for n, row in enumerate(grid):
        cells = [list(fill(words, room)) for words, room in zip(row, widths, strict=True)]
        for k in range(max(1, *(len(cell) for cell in cells))):
            parts: list[str | tuple[str, str] | Styled] = []
            for column, (cell, room) in enumerate(zip(cells, widths, strict=True)):
                content = cell[k] if k < len(cell) else Styled()
                parts += [(" │ ", "dim")] if column else []
                parts += [content, " " * (room - cell_len(content.plain))]
            yield Styled.assemble(*parts)
        if n == 0:
            yield Styled("─┼─".join("─" * room for room in widths), "dim")


def _stacked(grid: Grid, width: int) -> Iterator[Styled]:
    """One entry below another: the name of the row, then a line for each column."""
    header, *rows = grid
    for row in rows:
        yield from fill(row[0], width)
        for title, cell in zip(header[1:], row[1:], strict=True):
            if cell.plain == NOTHING:
                continue
            entry = StyledWords()
            entry.words = [*title.words[:-1], *(Styled.assemble(w, ":") for w in title.words[-1:]), *cell.words]
            yield from (Styled("  ") + line for line in fill(entry, width - 2, hang=2))


# -- A line of text in runs of one style each, as a terminal shows them ------------------------------------------------
#
# rich has the same and much more; a page that goes to a pipe has no colours, and importing rich and its texts would
# take
# as long as laying out the page. Styles are rich's words: `bold`, `dim`, `bold green`; without a style a run is as it
# is.


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
