"""The nodes that a problem file consists of: values, lists, mappings, each with its place.

Every scalar is text: `n`, `y`, `no` and `on` stay names, `1e-3` stays what was written, and what it means is decided by
who reads it.
"""

from __future__ import annotations

from collections.abc import Iterator

from lagrange.core.diagnostics import Fragment, Span
from lagrange.core.records import record


@record
class Scalar:
    """A value, as text. `fragment` locates its characters; `quoted` tells `""` from nothing at all."""

    text: str
    span: Span
    fragment: Fragment
    quoted: bool

    @property
    def is_empty(self) -> bool:
        """Whether nothing was written."""
        return not self.quoted and not self.text


@record
class Sequence:
    """A list."""

    items: tuple[Node, ...]
    span: Span


@record
class Mapping:
    """Keys with values, in the order of the file."""

    entries: tuple[tuple[Scalar, Node], ...]
    span: Span


Node = Scalar | Sequence | Mapping


def scalars(node: Node) -> Iterator[Scalar]:
    """All scalars in a node, keys included, in the order of the file."""
    match node:
        case Scalar():
            yield node
        case Sequence(items=items):
            for item in items:
                yield from scalars(item)
        case Mapping(entries=entries):
            for key, value in entries:
                yield key
                yield from scalars(value)
