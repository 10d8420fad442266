"""Short ways to build the blocks of a derivation: `prose("With ", math(x), ", ", Ref("motion"), " becomes")`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TypeGuard

from lagrange.document.derivation import Block, Detail, Display, Equation, Math, Mathematics, Part, Prose
from lagrange.document.purposes import Phrase, Purpose


def prose(*parts: Part, detail: Detail = Detail.STEPS, purpose: Purpose | None = None) -> Prose:
    """A paragraph from text and mathematics."""
    return Prose(parts, detail, purpose=purpose)


def has_purpose(block: Block | None, purpose: Purpose) -> TypeGuard[Prose]:
    """Whether it is a paragraph of that purpose."""
    return isinstance(block, Prose) and block.purpose is purpose


def parts_of(block: Block) -> Iterator[Part]:
    """What a paragraph, or the conditions of displayed equations, are made of."""
    if isinstance(block, Prose):
        yield from block.parts
    elif isinstance(block, Display):
        yield from (p for e in block.equations for p in e.condition)


def index_of(purpose: Purpose, parts: Sequence[Part]) -> int | None:
    """Where the first words of that purpose are; None if there are none."""
    return next((n for n, part in enumerate(parts) if isinstance(part, Phrase) and part.purpose is purpose), None)


def math(*sides: Mathematics, relation: str = "=") -> Math:
    """Inline mathematics a = b = c."""
    return Math(sides, relation)


def paragraph(*sentences: Prose) -> Prose:
    """Sentences as one paragraph, with the purpose of the first."""
    parts: list[Part] = []
    for n, sentence in enumerate(sentences):
        parts += [" ", *sentence.parts] if n else sentence.parts
    return Prose(tuple(parts), min(s.detail for s in sentences), purpose=sentences[0].purpose)


def display(*equations: Equation, boxed: bool = False, detail: Detail = Detail.STEPS) -> Display:
    """Displayed equations."""
    return Display(equations, boxed, detail)


def paired(equations: Sequence[Equation]) -> tuple[Equation, ...]:
    """Equations two in a line, the second as what follows the first, which has the number."""
    pairs = [equations[n : n + 2] for n in range(0, len(equations), 2)]
    return tuple(replace(pair[0], condition=(Math(pair[1].sides),)) if len(pair) == 2 else pair[0] for pair in pairs)


def listed(parts: Iterable[Part], last: str = " and ") -> tuple[Part, ...]:
    """`a, b and c`, as parts of a paragraph."""
    return series(((part,) for part in parts), last)


def series(items: Iterable[Sequence[Part]], last: str = " and ") -> tuple[Part, ...]:
    """`a of b, c of d and e of f`: a list of which each item has several parts."""
    clauses = list(items)
    parts: list[Part] = []
    for n, clause in enumerate(clauses):
        if n:
            parts.append(last if n == len(clauses) - 1 else ", ")
        parts += clause
    return tuple(parts)
