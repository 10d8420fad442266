"""References to equations: under other labels, where another step displays them; in words, where none does."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace

from lagrange.document.derivation import Block, CheckMark, Display, Part, Prose, Ref, Step


def referring_to(blocks: Iterable[Block], labels: Mapping[str, str]) -> Iterator[Block]:
    """The blocks with other labels in their references, also in conditions beside equations."""

    def part(p: Part) -> Part:
        return Ref(labels[p.label]) if isinstance(p, Ref) and p.label in labels else p

    for b in blocks:
        if isinstance(b, Prose):
            yield replace(b, parts=tuple(map(part, b.parts)), short=tuple(map(part, b.short)))
        elif isinstance(b, Display):
            equations = (replace(e, condition=tuple(map(part, e.condition))) for e in b.equations)
            yield replace(b, equations=tuple(equations))
        else:
            yield b


def labels_in(steps: Iterable[Step]) -> set[str]:
    """The labels of all equations that are displayed."""
    return {e.label for s in steps for b in s.body if isinstance(b, Display) for e in b.equations if e.label}


def not_referring(block: Block, is_missing: Callable[[str], bool]) -> Block:
    """A block whose references to equations that are omitted are words."""

    def named(parts: Iterable[Part]) -> tuple[Part, ...]:
        return tuple("an equation left out here" if isinstance(p, Ref) and is_missing(p.label) else p for p in parts)

    if isinstance(block, Prose):
        return replace(block, parts=named(block.parts), short=named(block.short))
    return replace(block, name=named(block.name)) if isinstance(block, CheckMark) else block
