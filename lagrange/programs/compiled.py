"""Expressions as Python functions.

The text that is compiled is written by `languages.py` from numbers, a short list of functions, and
names of the program's own: y0, p3, c12. Nothing in it comes from a file. Parts that depend on parameters alone are
evaluated once, when the function is made.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp

from lagrange.core.symbols import t
from lagrange.programs.languages import PYTHON, Argument, GeneratedFunction, Printer
from lagrange.programs.straight_line import StraightLine, straight_line

Compiled = Callable[..., Any]


def _sign(x: float) -> float:
    return float((x > 0) - (x < 0))


_NAMES = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "pow")
_MATH: dict[str, Any] = {**{n: getattr(math, n) for n in _NAMES}, "abs": abs, "sign": _sign, "__builtins__": {}}
"""The functions that compiled code can call, and nothing else."""


def _in_arrays() -> dict[str, Any]:
    """The functions for arrays. Raises ImportError without NumPy."""
    import numpy

    called = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2", "pow": "power"}
    functions = {n: getattr(numpy, called.get(n, n)) for n in (*_NAMES, "abs", "sign")}
    return {**functions, "__builtins__": {}}


def compiled_text(text: str, name: str, namespace: Mapping[str, Any] | None = None) -> Compiled:
    """The function of a name in a text that the program has written."""
    known = dict(_MATH if namespace is None else namespace)
    exec(compile(text, "<equations of motion>", "exec"), known)
    made: Compiled = known[name]
    return made


def compiled(
    state: Sequence[sp.Symbol],
    program: StraightLine | Sequence[sp.Expr],
    values: Mapping[sp.Symbol, float],
    *,
    arrays: bool = False,
) -> Compiled:
    """A function of t and the symbols of a state, one argument for each, that returns the list of the outputs.

    values  the numbers of all other symbols
    arrays  whether the arguments may be arrays of NumPy; then outputs are arrays where they depend on them
    """
    written = program if isinstance(program, StraightLine) else straight_line(program)
    namespace = dict(_in_arrays() if arrays else _MATH)
    constants: dict[sp.Symbol, str] = {}
    for n, (symbol, number) in enumerate(values.items()):
        constants[symbol] = f"p{n}"
        namespace[f"p{n}"] = number
    moving: list[tuple[sp.Symbol, sp.Expr]] = []
    for symbol, value in written.assignments:
        if value.free_symbols <= constants.keys():
            name = f"q{len(constants)}"
            text = "\n".join(("def constant():", f"    return {Printer(PYTHON.syntax, constants)(value)}"))
            namespace[name] = compiled_text(text, "constant", namespace)()
            constants[symbol] = name
        else:
            moving.append((symbol, value))
    arguments: list[Argument] = [("t", t), *((f"y{k}", s) for k, s in enumerate(state))]
    function = GeneratedFunction(
        "f", tuple(arguments), StraightLine(tuple(moving), written.outputs), constants=constants
    )
    return compiled_text("\n".join(PYTHON.function(function)), "f", namespace)
