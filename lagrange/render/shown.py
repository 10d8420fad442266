"""What of a derivation is shown at a level of detail, and how its equations are numbered.

Numbers run through what is shown, so that they have no gaps; a reference to an equation that is not shown
is replaced by the equation itself. Of steps that nobody would read, the beginning is shown, with the count of what is
left out: JSON has everything.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

import sympy as sp

from lagrange.derivation import (
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
    listed,
)
from lagrange.records import record
from lagrange.vectors import Vector

LARGEST_STEP = 2000
"""Operations of the equations of one step that are still shown; eight links of a chain have half as many."""
SHORTEST_RUN = 4
"""References one after the other that are written as a range."""
BEGINNING = 500
"""Operations of what is shown of a larger step."""


@record
class Shown:
    """The steps with what is shown of them, the numbers of the equations, and the equations left out."""

    steps: tuple[Step, ...]
    numbers: dict[str, int]
    hidden: dict[str, Equation]


def shown(derivation: Derivation, detail: Detail, first: int = 1, *, pictures: bool = False) -> Shown:
    """Selects the blocks of a derivation; numbers begin with `first`. Pictures are drawn only where they are wanted."""
    steps = []
    left: set[str] = set()
    for step in derivation.steps:
        body = tuple(block for block in step.body if block.detail <= detail and _has_place(block, pictures))
        if detail is Detail.BRIEF:
            body = tuple(_shortened(body))
        if body:
            body, without = _readable(body)
            left |= without
            steps.append(replace(step, body=tuple(_not_referring(block, left) for block in body)))
    labelled = [e for e in _equations(steps) if e.label is not None]
    numbers = {e.label: n for n, e in enumerate(labelled, first) if e.label is not None}
    steps = [replace(s, body=tuple(_condensed(b, numbers) for b in s.body)) for s in steps]
    everything = {e.label: e for e in _equations(derivation.steps) if e.label is not None}
    hidden = {label: e for label, e in everything.items() if label not in numbers}
    return Shown(tuple(steps), numbers, hidden)


def _readable(body: tuple[Block, ...]) -> tuple[tuple[Block, ...], set[str]]:
    """The blocks of a step; if that is too large to be read, its beginning. With the labels of what is left out."""
    body = tuple(_of_readable_matrices(block) for block in body)
    if sum(_operations(e) for block in body if isinstance(block, Display) for e in block.equations) <= LARGEST_STEP:
        return body, set()
    room = BEGINNING
    kept: list[Block] = []
    left: list[Equation] = []
    labels: set[str] = set()

    def say_what_is_left() -> None:
        if left:
            labels.update(e.label for e in left if e.label is not None)
            kept.append(_left_out(left, more=isinstance(kept[-1], Display) if kept else False))
            left.clear()

    for block in body:
        if not isinstance(block, Display):
            if not (left and _introduces(block)):
                say_what_is_left()
                kept.append(block)
            continue
        first = next((n for n, e in enumerate(block.equations) if not _fits(block.equations[: n + 1], room)), None)
        shown_here = block.equations if first is None else block.equations[:first]
        if shown_here:
            say_what_is_left()
            kept.append(replace(block, equations=shown_here))
            room -= sum(map(_operations, shown_here))
        elif not left and kept and _introduces(kept[-1]):
            kept.pop()
        left += block.equations[len(shown_here) :]
    say_what_is_left()
    return tuple(kept), labels


def _of_readable_matrices(block: Block) -> Block:
    """The block; where it has matrices that nobody would read, that there are these."""
    if not isinstance(block, Matrices):
        return block
    entries = [e for _, rows in block.named for row in rows for e in row]
    operations = len(entries) + sum(map(_count, entries))
    if operations <= LARGEST_STEP:
        return block
    names = listed(Math((name,)) for name, _ in block.named)
    kept = (
        f", {len(entries):,} entries of {operations - len(entries):,} operations, are left out here as too long to read"
    )
    return Prose((*names, f"{kept}; `--format json` has them."), block.detail)


def _fits(equations: Sequence[Equation], room: int) -> bool:
    return sum(map(_operations, equations)) <= room


def _introduces(block: Block) -> bool:
    """Whether a paragraph goes on in the equations that follow: "The position of P1, of mass m1, is"."""
    last = block.parts[-1] if isinstance(block, Prose) else "."
    return not (isinstance(last, str) and last.endswith("."))


def _left_out(equations: Sequence[Equation], *, more: bool) -> Prose:
    """That there are these equations."""
    count, operations = len(equations), sum(map(_operations, equations))
    those = f"{count} more equations" if more and count > 1 else f"{count} equations"
    if count == 1:
        those = "One more equation" if more else "One equation"
    verb, them = ("is", "it") if count == 1 else ("are", "them")
    total = f"of {operations:,} operations" + (" in all" if count > 1 else "")
    return Prose((f"{those} {total} {verb} left out here as too long to read; `--format json` has {them}.",))


def _operations(equation: Equation) -> int:
    """How many operations it takes to write the sides of an equation."""
    parts = (c for side in equation.sides for c in (side.components if isinstance(side, Vector) else (side,)))
    return sum(_count(c) for c in parts)


@lru_cache(maxsize=1 << 12)
def _count(expression: sp.Expr) -> int:
    return int(expression.count_ops())


def _condensed(block: Block, numbers: Mapping[str, int]) -> Block:
    """A paragraph in which (3), (4), (5) and (6) are (3) to (6)."""
    if not isinstance(block, Prose):
        return block
    parts = list(block.parts)
    n = 0
    while n < len(parts):
        end = n
        while end + 2 < len(parts) and parts[end + 1] in (", ", " and ") and _next(parts[end], parts[end + 2], numbers):
            end += 2
        if (end - n) // 2 + 1 >= SHORTEST_RUN:
            parts[n + 1 : end] = [" to "]
            if n > 1 and parts[n - 1] == ", " and parts[n + 2 : n + 3] not in ([", "], [" and "]):
                parts[n - 1] = " and "
        n += 1
    return replace(block, parts=tuple(parts))


def _next(a: Part, b: Part, numbers: Mapping[str, int]) -> bool:
    """Whether these are references, the second to the equation after the first."""
    known = isinstance(a, Ref) and isinstance(b, Ref) and a.label in numbers
    return known and numbers.get(b.label) == numbers[a.label] + 1  # type: ignore[union-attr]


def _not_referring(block: Block, left: set[str]) -> Block:
    """A block that does not refer to what is left out."""

    def named(parts: Iterable[Part]) -> tuple[Part, ...]:
        return tuple("an equation left out here" if isinstance(p, Ref) and p.label in left else p for p in parts)

    if left and isinstance(block, Prose):
        return replace(block, parts=named(block.parts))
    return replace(block, name=named(block.name)) if left and isinstance(block, CheckMark) else block


def _has_place(block: Block, pictures: bool) -> bool:
    return not isinstance(block, Picture) or (pictures and block.draw() is not None)


def _shortened(body: Sequence[Block]) -> Iterator[Block]:
    """Paragraphs in their short form, the checks that held in one line."""
    held = [b for b in body if isinstance(b, CheckMark) and b.passed]
    for block in body:
        if isinstance(block, Prose) and block.short:
            yield Prose(block.short, block.detail)
        elif block not in held:
            yield block
        elif block is held[0]:
            many = len(held)
            yield block if many == 1 else CheckMark((f"{many} checks held",), True, "")


def _equations(steps: tuple[Step, ...] | list[Step]) -> list[Equation]:
    return [
        equation for step in steps for block in step.body if isinstance(block, Display) for equation in block.equations
    ]


def written_out(name: sp.Symbol, rows: Sequence[Sequence[sp.Expr]]) -> tuple[Block, ...]:
    """A matrix that is too wide, entry by entry: M_12 = ... for each that is not zero, f_1 = ... of a column."""
    column = len(rows[0]) == 1 and len(rows) > 1
    found = tuple(
        Equation((type(name)(f"{name.name}_{j}{'' if column else k}", real=True), e))
        for j, row in enumerate(rows, start=1)
        for k, e in enumerate(row, start=1)
        if e != 0
    )
    others = (Prose(("The other entries of ", Math((name,)), " are zero.")),)
    return (Display(found), *(others if any(e == 0 for row in rows for e in row) else ()))
