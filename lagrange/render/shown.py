"""What of a derivation is shown at a level of detail, and how its equations are numbered.

Numbers run through what is shown, so that they have no gaps; a reference to an equation that is not shown
is replaced by the equation itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.records import record
from lagrange.document.derivation import (
    Block,
    CheckMark,
    Derivation,
    Detail,
    Display,
    Equation,
    Math,
    Part,
    Picture,
    Prose,
    Ref,
    Step,
)
from lagrange.render.abridged import abridged, not_referring

SHORTEST_RUN = 4
"""References one after the other that are written as a range."""


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
            body, without = abridged(body)
            left |= without
            steps.append(replace(step, body=tuple(not_referring(block, left) for block in body)))
    labelled = [e for e in _equations(steps) if e.label is not None]
    numbers = {e.label: n for n, e in enumerate(labelled, first) if e.label is not None}
    steps = [replace(s, body=tuple(_condensed(b, numbers) for b in s.body)) for s in steps]
    everything = {e.label: e for e in _equations(derivation.steps) if e.label is not None}
    hidden = {label: e for label, e in everything.items() if label not in numbers}
    return Shown(tuple(steps), numbers, hidden)


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
