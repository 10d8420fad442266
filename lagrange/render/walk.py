"""The walk over the blocks of a step, the same in every format for readers.

A format is an `Emitter`: it writes one block of each kind, and the walk calls it in the order of the step. Two kinds
come in runs of neighbours, because formats join them: paragraphs in LaTeX have an empty line between them, and checks
make one list. What a line is (text, a paragraph, coloured cells) is the format's own affair.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import Protocol, TypeVar

from lagrange.document.derivation import Block, CheckMark, Display, Matrices, Picture, Prose, Table, Task

Line = TypeVar("Line", covariant=True)


class Emitter(Protocol[Line]):
    """One format: how each kind of block is written, as lines."""

    def paragraphs(self, run: Sequence[Prose]) -> Iterable[Line]:
        """Paragraphs that follow one another."""

    def display(self, block: Display) -> Iterable[Line]:
        """Equations."""

    def table(self, block: Table) -> Iterable[Line]:
        """A table."""

    def matrices(self, block: Matrices) -> Iterable[Line]:
        """Matrices; one that is too wide is written entry by entry."""

    def checks(self, run: Sequence[CheckMark]) -> Iterable[Line]:
        """Checks that follow one another."""

    def picture(self, block: Picture) -> Iterable[Line]:
        """A picture; nothing in a format that has none."""
        del block
        return ()

    def task(self, block: Task) -> Iterable[Line]:
        """A task on a worksheet; without room in a format that is not written on."""
        return self.paragraphs((Prose(block.parts),))


def block_lines(blocks: Iterable[Block], emitter: Emitter[Line]) -> Iterator[Line]:
    """The lines of some blocks in one format."""
    for kind, run in groupby(blocks, key=type):
        if kind is Prose:
            yield from emitter.paragraphs([b for b in run if isinstance(b, Prose)])
        elif kind is CheckMark:
            yield from emitter.checks([b for b in run if isinstance(b, CheckMark)])
        else:
            for block in run:
                yield from _block(block, emitter)


def _block(block: Block, emitter: Emitter[Line]) -> Iterable[Line]:
    match block:
        case Display():
            return emitter.display(block)
        case Table():
            return emitter.table(block)
        case Matrices():
            return emitter.matrices(block)
        case Picture():
            return emitter.picture(block)
        case Task():
            return emitter.task(block)
        case Prose() | CheckMark():
            raise AssertionError("these come in runs")
