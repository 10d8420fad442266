"""Small motions about an equilibrium or a steady motion, one box each: that of the frequency.

The linear equation is a step on the way to it, as a book prints it; a line states its solutions.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lagrange.document.builders import has_purpose, prose
from lagrange.document.derivation import Block, Display, Rule, Step
from lagrange.document.purposes import Phrase, Purpose

_RULES = (Rule.LINEARIZATION, Rule.STEADY)


def in_one_box(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, those on small motions with a box only around the frequencies."""
    for step in steps:
        if step.rule in _RULES and not step.folded:
            step = replace(step, body=tuple(_with_alternatives([*_in_one_box(step.body)])))
        yield step


def _in_one_box(body: Sequence[Block]) -> Iterator[Block]:
    for n, block in enumerate(body):
        follows = body[n + 1 : n + 3]
        if _is_linear(block) and len(follows) == 2 and has_purpose(follows[0], Purpose.WAVES) and _is_box(follows[1]):
            assert isinstance(block, Display)
            yield replace(block, boxed=False)
        elif has_purpose(block, Purpose.WAVES):
            parts = (p.instead if isinstance(p, Phrase) else p for p in block.parts)
            yield prose(*parts, detail=block.detail)
        else:
            yield block


def _with_alternatives(body: Sequence[Block]) -> Iterator[Block]:
    """Steady motions in one box, with `or` between them, instead of one below the other."""
    waiting: Display | None = None
    for block in body:
        if waiting is not None and isinstance(block, Display) and _is_box(block):
            *lines, last = waiting.equations
            either = replace(last, condition=(*last.condition, ", or" if last.condition else "or"))
            waiting = replace(waiting, equations=(*lines, either, *block.equations))
            continue
        if waiting is not None:
            yield waiting
        waiting = block if isinstance(block, Display) and _is_box(block) else None
        if waiting is None:
            yield block
    if waiting is not None:
        yield waiting


def _is_linear(block: Block) -> bool:
    """Whether it has the linear equations about one place."""
    return isinstance(block, Display) and all((e.label or "").startswith("linear-") for e in block.equations)


def _is_box(block: Block) -> bool:
    return isinstance(block, Display) and block.boxed
