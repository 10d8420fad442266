"""The syntax tree of an expression. Every node knows its place in the text: characters `start` to `end`
(exclusive)."""

from __future__ import annotations

from collections.abc import Iterator

from lagrange.core.records import record


@record
class Number:
    """A number as it was written."""

    text: str
    start: int
    end: int


@record
class Name:
    """A name."""

    text: str
    start: int
    end: int


@record
class Primed:
    """A time derivative, `order` times."""

    operand: Tree
    order: int
    start: int
    end: int


@record
class Sum:
    """Terms with their signs."""

    terms: tuple[tuple[int, Tree], ...]
    start: int
    end: int


@record
class Product:
    """Factors, each multiplied or divided by."""

    factors: tuple[tuple[str, Tree], ...]
    start: int
    end: int


@record
class Power:
    """base ^ exponent."""

    base: Tree
    exponent: Tree
    start: int
    end: int


@record
class Call:
    """A name, which ends at `name_end`, applied to arguments in parentheses or to what follows it."""

    name: str
    arguments: tuple[Tree, ...]
    start: int
    end: int
    name_end: int


@record
class Components:
    """A list in brackets: the components of a vector."""

    items: tuple[Tree, ...]
    start: int
    end: int


@record
class Bars:
    """|x|: the absolute value of a scalar, the length of a vector."""

    operand: Tree
    start: int
    end: int


Tree = Number | Name | Primed | Sum | Product | Power | Call | Components | Bars


def parts(tree: Tree) -> tuple[Tree, ...]:
    """What a node is made of, in the order of the text."""
    match tree:
        case Number() | Name():
            return ()
        case Primed(operand=inner) | Bars(operand=inner):
            return (inner,)
        case Sum(terms=terms):
            return tuple(term for _, term in terms)
        case Product(factors=factors):
            return tuple(factor for _, factor in factors)
        case Power(base=base, exponent=exponent):
            return (base, exponent)
        case Call(arguments=items) | Components(items=items):
            return items


def walk(tree: Tree) -> Iterator[Tree]:
    """The tree and all that it is made of."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        yield node
        waiting.extend(reversed(parts(node)))
