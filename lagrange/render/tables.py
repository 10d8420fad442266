"""Tables on a terminal: as they are where they fit; turned, wrapped or stacked where they do not."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.cells import cell_len
from rich.text import Text

from lagrange.render.paragraphs import Words, fill

Grid = list[list[Words]]  # the header is the first row, and names of rows are the first column
GAP = 3


def table_lines(grid: Grid, width: int) -> Iterator[Text]:
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
    return _stacked(grid, width)


def _natural(grid: Grid) -> list[int]:
    return [max(cell_len(row[k].plain) for row in grid) for k in range(len(grid[0]))]


def _total(widths: Sequence[int]) -> int:
    return sum(widths) + GAP * (len(widths) - 1)


def _squeezed(grid: Grid, width: int) -> list[int] | None:
    """Takes from the widest columns what is too much; None if that would tear words or formulas."""
    widths = _natural(grid)
    least = [max(cell_len(word.plain) for row in grid for word in row[k].words or [Text()]) for k in range(len(widths))]
    while _total(widths) > width:
        slack = [k for k in range(len(widths)) if widths[k] > least[k]]
        if not slack:
            return None
        widths[max(slack, key=widths.__getitem__)] -= 1
    return widths


def _ruled(grid: Grid, widths: Sequence[int]) -> Iterator[Text]:
    """Columns with a thin line between them and below the header."""
    for n, row in enumerate(grid):
        cells = [list(fill(words, room)) for words, room in zip(row, widths, strict=True)]
        for k in range(max(1, *(len(cell) for cell in cells))):
            line = Text()
            for column, (cell, room) in enumerate(zip(cells, widths, strict=True)):
                content = cell[k] if k < len(cell) else Text()
                line.append_text(Text(" │ ", "dim") if column else Text())
                line.append_text(content)
                line.append(" " * (room - cell_len(content.plain)))
            yield line
        if n == 0:
            yield Text("─┼─".join("─" * room for room in widths), "dim")


def _stacked(grid: Grid, width: int) -> Iterator[Text]:
    """One entry below the other: the name of the row, then a line for each column."""
    header, *rows = grid
    for row in rows:
        yield from fill(row[0], width)
        for title, cell in zip(header[1:], row[1:], strict=True):
            entry = Words()
            entry.words = [*title.words[:-1], *(Text.assemble(w, ":") for w in title.words[-1:]), *cell.words]
            yield from (Text("  ") + line for line in fill(entry, width - 2, hang=2))
