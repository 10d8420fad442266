"""References to equations under other labels, where a step uses what another one has displayed already."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from lagrange.document.derivation import Block, Display, Part, Prose, Ref


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
