"""What a style makes of an expression: pieces of code, with marks where a long one may be broken.

A piece says how tightly it holds together, so that the walker knows where brackets are needed. Sums carry
marks, START, BREAK before each sign, END, from which a layout finds where a long equation can be broken,
and how deep; `plain` takes them out.
"""

from __future__ import annotations

import re
from enum import IntEnum

from lagrange.core.records import record

START, BREAK, END = "\ue000", "\ue001", "\ue002"
_MARKS = re.compile(f"[{START}{BREAK}{END}]")


def plain(code: str) -> str:
    """The code without its marks."""
    return _MARKS.sub("", code)


class Level(IntEnum):
    """How tightly a piece holds together."""

    SUM = 0  # a + b, -a
    DIVISION = 1  # a/b
    PRODUCT = 2  # a b
    APPLICATION = 3  # sin θ, without parentheses
    POWER = 4  # x², √(a + b)
    ATOM = 5  # x, f(x), (a + b)


@record
class Piece:
    """A piece of mathematics, spelled. `tight`: a number can stand before it without a space."""

    code: str
    level: Level = Level.ATOM
    tight: bool = False


def brackets(code: str, brace: str = "{") -> tuple[str, str]:
    """Round brackets; around a sum, or a beginning with a bracket, that has some, square ones, then braces."""
    if not code.startswith((START, "(", "−", "-")) or "(" not in code:
        return "(", ")"
    return ("{", "}") if "[" in code and brace not in code else ("[", "]")
