"""Expressions as Python functions.

The text that is compiled is written by `printer.py` and `languages.py` from numbers, a short list of functions, and
names of the program's own: y[0], p[3], c12. Nothing in it comes from a file.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp

from lagrange.programs.languages import PYTHON, Argument, Function

Compiled = Callable[..., list[float]]


def _sign(x: float) -> float:
    return float((x > 0) - (x < 0))


_MATH = {n: getattr(math, n) for n in "sin cos tan asin acos atan atan2 sinh cosh tanh exp log sqrt pow".split()}
NUMBERS: dict[str, Any] = {**_MATH, "abs": abs, "sign": _sign, "__builtins__": {}}
"""The functions that compiled code can call, and nothing else."""


def compiled(arguments: Sequence[Argument], outputs: Sequence[sp.Expr]) -> Compiled:
    """A function of the arguments that returns the list of the outputs."""
    return compiled_function(Function.of("f", arguments, outputs))


def compiled_function(function: Function) -> Compiled:
    """A function as Python runs it. Arrays are unpacked at once, which is faster than taking their elements."""
    return compiled_text("\n".join(PYTHON.function(function)), function.name)


def compiled_text(text: str, name: str) -> Compiled:
    """The function of a name in a text that the program has written."""
    namespace = dict(NUMBERS)
    exec(compile(text, "<equations of motion>", "exec"), namespace)
    made: Compiled = namespace[name]
    return made
