"""Steps that nobody would read: the beginning is shown, and the count of what is left out. JSON has everything."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import lru_cache

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.document.derivation import Block, CheckMark, Display, Equation, Math, Matrices, Part, Prose, Ref, listed

LARGEST_STEP = 2000
"""Operations of the equations of one step that are still shown; eight links of a chain have half as many."""
BEGINNING = 500
"""Operations of what is shown of a larger step."""


def abridged(body: Sequence[Block]) -> tuple[tuple[Block, ...], set[str]]:
    """The blocks of a step; if that is too large to be read, its beginning. With the labels of what is left out."""
    body = tuple(_of_readable_matrices(block) for block in body)
    if sum(_operations(block.equations) for block in body if isinstance(block, Display)) <= LARGEST_STEP:
        return body, set()
    beginning = _Beginning()
    for block in body:
        beginning.add(block)
    return beginning.all(), beginning.labels


def not_referring(block: Block, left: set[str]) -> Block:
    """A block that does not refer to what is left out."""

    def named(parts: Iterable[Part]) -> tuple[Part, ...]:
        return tuple("an equation left out here" if isinstance(p, Ref) and p.label in left else p for p in parts)

    if left and isinstance(block, Prose):
        return replace(block, parts=named(block.parts))
    return replace(block, name=named(block.name)) if left and isinstance(block, CheckMark) else block


class _Beginning:
    """The beginning of a step, block by block, and the labels of the equations that are left out.

    Words that introduce equations wait for these, and stand or fall with them.
    """

    def __init__(self) -> None:
        self.labels: set[str] = set()
        self._kept: list[Block] = []
        self._waiting: list[Block] = []
        self._left: list[Equation] = []
        self._room = BEGINNING

    def add(self, block: Block) -> None:
        """The next block, or as much of it as there is room for."""
        if isinstance(block, Display):
            self._add_equations(block)
        elif _introduces(block):
            self._keep()
            self._waiting.append(block)
        else:
            self._keep(block)

    def all(self) -> tuple[Block, ...]:
        """The blocks that are kept, once all have been added."""
        self._keep()
        self._say_what_is_left()
        return tuple(self._kept)

    def _keep(self, *blocks: Block) -> None:
        """Keeps what waits, and further blocks, after the count of what has been left out before them."""
        if self._waiting or blocks:
            self._say_what_is_left()
        self._kept += (*self._waiting, *blocks)
        self._waiting.clear()

    def _say_what_is_left(self) -> None:
        if self._left:
            self.labels.update(e.label for e in self._left if e.label is not None)
            self._kept.append(_left_out(self._left, more=bool(self._kept) and isinstance(self._kept[-1], Display)))
            self._left.clear()

    def _add_equations(self, block: Display) -> None:
        fit = 0
        while fit < len(block.equations) and _operations(block.equations[: fit + 1]) <= self._room:
            fit += 1
        if fit:
            self._keep(replace(block, equations=block.equations[:fit]))
            self._room -= _operations(block.equations[:fit])
        self._waiting.clear()
        self._left += block.equations[fit:]


def _introduces(block: Block) -> bool:
    """Whether a paragraph goes on in the equations that follow: "The position of P1, of mass m1, is"."""
    last = block.parts[-1] if isinstance(block, Prose) else "."
    return not (isinstance(last, str) and last.endswith("."))


def _left_out(equations: Sequence[Equation], *, more: bool) -> Prose:
    """That there are these equations."""
    count = len(equations)
    those = f"{count} more equations" if more and count > 1 else f"{count} equations"
    if count == 1:
        those = "One more equation" if more else "One equation"
    verb, them = ("is", "it") if count == 1 else ("are", "them")
    total = f"of {_operations(equations):,} operations" + (" in all" if count > 1 else "")
    return Prose((f"{those} {total} {verb} left out here as too long to read; `--format json` has {them}.",))


def _of_readable_matrices(block: Block) -> Block:
    """The block; where it has matrices that nobody would read, that there are these."""
    if not isinstance(block, Matrices):
        return block
    entries = [e for _, rows in block.named for row in rows for e in row]
    operations = sum(map(_count, entries))
    if len(entries) + operations <= LARGEST_STEP:
        return block
    names = listed(Math((name,)) for name, _ in block.named)
    size = f", {len(entries):,} entries of {operations:,} operations, are left out here as too long to read"
    return Prose((*names, f"{size}; `--format json` has them."), block.detail)


def _operations(equations: Iterable[Equation]) -> int:
    """How many operations it takes to write the sides of equations."""
    sides = (side for e in equations for side in e.sides)
    return sum(_count(c) for side in sides for c in (side.components if isinstance(side, Vector) else (side,)))


@lru_cache(maxsize=1 << 12)
def _count(expression: sp.Expr) -> int:
    return int(expression.count_ops())
