"""Matrices on a terminal: brackets of pieces, entries in the middle of their columns.

M = ⎛ 2 m l²  m l² ⎞
    ⎝ m l²    m l² ⎠
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rich.cells import cell_len

GAP = 2
LEFT, RIGHT = "⎛⎜⎝", "⎞⎟⎠"


def matrix_lines(name: str, cells: Sequence[Sequence[str]]) -> list[str]:
    """The lines of `name = (cells)`, all of one width."""
    rows = len(cells)
    widths = [max(cell_len(row[c]) for row in cells) for c in range(len(cells[0]))]
    found = []
    for n, row in enumerate(cells):
        left, right = ("(", ")") if rows == 1 else (_piece(LEFT, n, rows), _piece(RIGHT, n, rows))
        inner = (" " * GAP).join(_centred(cell, width) for cell, width in zip(row, widths, strict=True))
        head = f"{name} = " if n == (rows - 1) // 2 else " " * (cell_len(name) + 3)
        found.append(f"{head}{left} {inner} {right}")
    return found


def _piece(pieces: str, n: int, rows: int) -> str:
    return pieces[0] if n == 0 else pieces[2] if n == rows - 1 else pieces[1]


def _centred(cell: str, width: int) -> str:
    left = (width - cell_len(cell)) // 2
    return " " * left + cell + " " * (width - cell_len(cell) - left)


def side_by_side(blocks: Sequence[Sequence[str]], width: int) -> Iterator[str]:
    """Blocks of lines beside each other as far as they fit, the shorter ones in the middle."""
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
