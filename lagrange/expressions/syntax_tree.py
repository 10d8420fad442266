"""The syntax tree of an expression, and the roles of names in the grammar.

Every node knows its place in the text: characters `start` to `end` (exclusive). The grammar depends on declarations
where a name precedes a parenthesis: x(t) is the coordinate x, m(t) a product, f(t) an undefined function; `Lexicon`
supplies the role of a name.
"""

from __future__ import annotations

from enum import Enum, auto
from typing import Protocol

from lagrange.core.records import record

FUNCTIONS = (
    "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp",
    "log", "sqrt", "abs", "sign",
)  # fmt: skip
"""The scalar functions of the language."""

INVERSE_HYPERBOLIC = {f"{a}{kind}": kind for kind in ("sinh", "cosh", "tanh") for a in ("a", "ar", "arc")}
"""`acosh`, `arcosh` and `arccosh` for cosh, and so on; in results they are logarithms."""

OPERATIONS = ("dot", "cross", "norm", "diff")
"""Operations with the syntax of functions."""


class Role(Enum):
    """The grammatical role of a name."""

    UNDECLARED = auto()  # before a parenthesis: d(x), delta(x), or a missing function
    SCALAR = auto()
    COORDINATE = auto()  # x(t) is x
    PRESCRIBED = auto()  # u(t) is u
    VECTOR = auto()
    FUNCTION = auto()  # an undefined function, applied to the parenthesis that follows


class Lexicon(Protocol):
    """The roles of the declared names."""

    def role(self, name: str) -> Role:
        """The role of a name."""


DEGREES = frozenset({"deg", "degrees", "°"})
"""After a number, and not declared: `30 deg` is 30 pi/180."""


@record
class NumberLiteral:
    """A number, as it was written."""

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
    """The time derivative of order `order`."""

    operand: Tree
    order: int
    start: int
    end: int


@record
class Sum:
    """A sum of terms, each with its sign."""

    terms: tuple[tuple[int, Tree], ...]
    start: int
    end: int


@record
class Product:
    """A product of factors, each with its operator: `*`, `/`, and in LaTeX `⋅`, `⨯`."""

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
    """A name, which ends at `name_end`, applied to arguments in parentheses, or without them to a product."""

    name: str
    arguments: tuple[Tree, ...]
    start: int
    end: int
    name_end: int


@record
class BracketedList:
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


Tree = NumberLiteral | Name | Primed | Sum | Product | Power | Call | BracketedList | Bars


def parts(tree: Tree) -> tuple[Tree, ...]:
    """The children of a node, in the order of the text."""
    match tree:
        case NumberLiteral() | Name():
            return ()
        case Primed(operand=inner) | Bars(operand=inner):
            return (inner,)
        case Sum(terms=terms):
            return tuple(term for _, term in terms)
        case Product(factors=factors):
            return tuple(factor for _, factor in factors)
        case Power(base=base, exponent=exponent):
            return (base, exponent)
        case Call(arguments=items) | BracketedList(items=items):
            return items
