"""The part of a derivation that is shown at a level of detail, and the numbers of its equations.

Numbers count the equations that are shown, so that they have no gaps; a reference to an equation that is not shown is
replaced by the equation itself. A step too large to be read is cut after its beginning and says how many equations are
omitted; JSON has everything.

The walk over the blocks of a step, the same in every format for readers.

A format is an `Emitter`: it writes one block of each kind, and the walk calls it in the order of the step. Two kinds
come in runs of neighbours, because formats join them: paragraphs in LaTeX have an empty line between them, and checks
make one list. What a line is (text, a paragraph, coloured cells) is the format's own affair.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property, lru_cache
from itertools import groupby
from typing import Protocol, TypeVar

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.vectors import Vector
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
    Picture,
    Prose,
    Ref,
    Step,
    Table,
    Task,
    listed,
    not_referring,
)
from lagrange.render.limits import BEGINNING, LARGEST_STEP, SHORTEST_RUN


def abridged(body: Sequence[Block]) -> tuple[tuple[Block, ...], set[str]]:
    """The blocks of a step, or its beginning if it is too large to be read, and the labels of what is omitted."""
    body = tuple(_of_readable_matrices(block) for block in body)
    if sum(_operations(block.equations) for block in body if isinstance(block, Display)) <= LARGEST_STEP:
        return body, set()
    beginning = _Beginning()
    for block in body:
        beginning.add(block)
    return beginning.all(), beginning.labels


class _Beginning:
    """The beginning of a step, block by block, and the labels of the equations that are omitted.

    A paragraph that introduces equations waits for them, and is dropped if none of them is kept.
    """

    def __init__(self) -> None:
        self.labels: set[str] = set()
        self._kept: list[Block] = []
        self._waiting: list[Block] = []
        self._left: list[Equation] = []
        self._room = BEGINNING

    def add(self, block: Block) -> None:
        """Take the next block, or as much of it as there is room for."""
        if isinstance(block, Display):
            self._add_equations(block)
        elif _introduces(block):
            self._keep()
            self._waiting.append(block)
        else:
            self._keep(block)

    def all(self) -> tuple[Block, ...]:
        """The blocks kept, after all have been added."""
        self._keep()
        self._say_what_is_left()
        return tuple(self._kept)

    def _keep(self, *blocks: Block) -> None:
        """Keep the waiting blocks and these, after a count of the equations omitted before them."""
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
    """Whether a paragraph continues into the equations that follow: "The position of P1, of mass m1, is"."""
    last = block.parts[-1] if isinstance(block, Prose) else "."
    return not (isinstance(last, str) and last.endswith("."))


def _left_out(equations: Sequence[Equation], *, more: bool) -> Prose:
    """A sentence that replaces equations: how many there are, and of how many operations."""
    count = len(equations)
    those = f"{count} more equations" if more and count > 1 else f"{count} equations"
    if count == 1:
        those = "One more equation" if more else "One equation"
    verb, them = ("is", "it") if count == 1 else ("are", "them")
    total = f"of {_operations(equations):,} operations" + (" in all" if count > 1 else "")
    return Prose((f"{those} {total} {verb} left out here as too long to read; `--format json` has {them}.",))


def _of_readable_matrices(block: Block) -> Block:
    """The block; for matrices too large to be read, a sentence with their size."""
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
    return count_operations(expression)


@record
class ShownSteps:
    """The steps that are shown.

    steps    with the blocks that are shown
    numbers  of the equations, by label
    sources  the lists of steps in which an equation is looked up that is referred to and not shown, the best last
    folded   what stands in the place of steps that are not shown, with the choice of coordinates that they belong to
    """

    steps: tuple[Step, ...]
    numbers: dict[str, int]
    sources: tuple[Sequence[Step], ...]
    folded: Mapping[tuple[Part, ...], str] = field(default_factory=dict)

    @cached_property
    def _labelled(self) -> dict[str | None, Equation]:
        return {e.label: e for steps in self.sources for e in _equations(steps)}

    def equation(self, label: str) -> Equation | None:
        """The equation with this label, shown or not."""
        return self._labelled.get(label)

    def number(self, equation: Equation) -> str:
        """The number of an equation in parentheses; empty if it has none."""
        number = self.numbers.get(equation.label or "")
        return f"({number})" if number else ""

    def resolved(self, part: Part) -> Part:
        """The part itself; for a reference to an equation that is not shown, that equation. A `Ref` has a number."""
        if not isinstance(part, Ref) or part.label in self.numbers:
            return part
        equation = self._labelled.get(part.label)
        return "(?)" if equation is None else Math(equation.sides, equation.relation)


def shown(
    derivation: Derivation, detail: Detail, first: int = 1, *, pictures: bool = False, folded: bool = True
) -> ShownSteps:
    """The blocks shown at a level of detail, their equations numbered from `first`.

    pictures  whether they are kept and drawn
    folded    whether the steps that the page folds are kept
    """
    steps = []
    left: set[str] = set()
    title = ""  # of a step that is not shown, for the one that continues it
    for step in derivation.at(detail):
        title = step.title or title
        body = tuple(block for block in step.body if block.detail <= detail and _has_place(block, pictures))
        if detail is Detail.BRIEF:
            body = tuple(_shortened(body))
        if body and (folded or not step.folded):
            body, without = abridged(body)
            left |= without
            steps.append(
                replace(step, title=title, body=tuple(not_referring(block, left.__contains__) for block in body))
            )
            title = ""
    labelled = [e for e in _equations(steps) if e.label is not None]
    numbers = {e.label: n for n, e in enumerate(labelled, first) if e.label is not None}
    numbers |= {e.second: numbers[e.label] for e in labelled if e.label is not None and e.second is not None}
    steps = [replace(s, body=tuple(_condensed(b, numbers) for b in s.body)) for s in steps]
    left_folded = {} if folded else {s.folded: s.choice for s in derivation.at(detail) if s.folded}
    return ShownSteps(tuple(steps), numbers, (derivation.steps, derivation.at(detail)), left_folded)


def _condensed(block: Block, numbers: Mapping[str, int]) -> Block:
    """A paragraph in which (3), (4), (5) and (6) are (3) to (6), and (7) and (7), of two in a line, is (7)."""
    if not isinstance(block, Prose):
        return block
    parts = _each_once(block.parts, numbers)
    n = 0
    while n < len(parts):
        end = n  # the last reference of a run of consecutive numbers that begins at n
        while end + 2 < len(parts) and parts[end + 1] in (", ", " and ") and _next(parts[end], parts[end + 2], numbers):
            end += 2
        if (end - n) // 2 + 1 >= SHORTEST_RUN:
            parts[n + 1 : end] = [" to "]
            # The "and" of the list may have gone into the range: (1), (3) to (6) becomes (1) and (3) to (6).
            if n > 1 and parts[n - 1] == ", " and parts[n + 2 : n + 3] not in ([", "], [" and "]):
                parts[n - 1] = " and "
        n += 1
    return replace(block, parts=tuple(parts))


def _each_once(parts: Sequence[Part], numbers: Mapping[str, int]) -> list[Part]:
    """The parts without a reference to the number that the one before it in the same list has."""
    kept: list[Part] = []
    for part in parts:
        before, between = kept[-2:] if len(kept) > 1 else ("", "")
        if isinstance(part, Ref) and between in (", ", " and ") and isinstance(before, Ref):
            number = numbers.get(part.label)
            if number is not None and numbers.get(before.label) == number:
                kept.pop()
                if between == " and " and len(kept) > 2 and kept[-2] == ", ":
                    kept[-2] = between
                continue
        kept.append(part)
    return kept


def _next(a: Part, b: Part, numbers: Mapping[str, int]) -> bool:
    """Whether both are references, the second to the equation numbered next after the first."""
    known = isinstance(a, Ref) and isinstance(b, Ref) and a.label in numbers
    return known and numbers.get(b.label) == numbers[a.label] + 1  # type: ignore[union-attr]


def _has_place(block: Block, pictures: bool) -> bool:
    return not isinstance(block, Picture) or (pictures and block.draw() is not None)


def _shortened(body: Sequence[Block]) -> Iterator[Block]:
    """Paragraphs in their short form, and one line for all checks that held."""
    held = [b for b in body if isinstance(b, CheckMark) and b.passed]
    for block in body:
        if isinstance(block, Prose) and block.short:
            yield Prose(block.short, block.detail)
        elif block not in held:
            yield block
        elif block is held[0]:
            many = len(held)
            yield block if many == 1 else CheckMark((f"{many} checks held",), True, "")


def _equations(steps: Sequence[Step]) -> list[Equation]:
    return [
        equation for step in steps for block in step.body if isinstance(block, Display) for equation in block.equations
    ]


def entry_by_entry(name: sp.Symbol, rows: Sequence[Sequence[sp.Expr]]) -> tuple[Block, ...]:
    """A matrix too wide for a line, entry by entry: M_12 = ... for each that is not zero; f_1 = ... for a column."""
    column = len(rows[0]) == 1 and len(rows) > 1
    entries = tuple(
        Equation((type(name)(f"{name.name}_{j}{'' if column else k}", real=True), e))
        for j, row in enumerate(rows, start=1)
        for k, e in enumerate(row, start=1)
        if e != 0
    )
    others = (Prose(("The other entries of ", Math((name,)), " are zero.")),)
    return (Display(entries), *(others if any(e == 0 for row in rows for e in row) else ()))


# Walk


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
