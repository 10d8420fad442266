"""What the grammar must know of names: the functions of the language, and what a declared name is."""

from __future__ import annotations

from enum import Enum, auto
from typing import Protocol

FUNCTIONS = (
    "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp",
    "log", "sqrt", "abs", "sign",
)  # fmt: skip
"""The scalar functions of the language."""

OPERATIONS = ("dot", "cross", "norm", "diff")
"""Operations that are written like functions."""


class Role(Enum):
    """What a name is declared as, so far as the grammar depends on it."""

    UNDECLARED = auto()  # before a parenthesis: d(x), delta(x), or a function that is missing
    SCALAR = auto()
    COORDINATE = auto()  # x(t) is x
    PRESCRIBED = auto()  # u(t) is u
    VECTOR = auto()
    FUNCTION = auto()  # an undefined function, applied to what stands in parentheses


class Lexicon(Protocol):
    """What the declared names are."""

    def role(self, name: str) -> Role:
        """What a name is declared as."""
