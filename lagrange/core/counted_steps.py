"""Where the steps of SymPy's own work are counted, as `effort` describes them.

SymPy counts nothing itself, so a handful of its functions are replaced, once, by ones that count and call them. They
were chosen because everything of their kind passes through them, whatever is called from outside:

    walks through expressions    `Basic.args`, a look at the parts of a node
    polynomials as lists         `dup_strip` and `dmp_zero_p` end or begin nearly every routine; products and values,
                                 which take longer than their results are long, by the lengths of what goes into them
    polynomials as dictionaries  products of `PolyElement`, by their terms
    numbers                      `evalf`, which calls itself for every node
    signs                        `_ask`, which calls itself for every assumption that it tries

Nothing of what they return is changed.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any

import sympy.polys.densearith
import sympy.polys.densebasic
import sympy.polys.densetools
from sympy.core.basic import Basic
from sympy.polys.rings import PolyElement

from lagrange.core.limits import BITS_PER_STEP, STEPS_OF_A_NUMBER, STEPS_OF_A_QUESTION

Count = Callable[[int], None]


def count_steps(take: Count) -> None:
    """Has SymPy report its steps to `take`."""
    _count_polynomials(take)
    _count_numbers_and_signs(take)


def _count_polynomials(take: Count) -> None:
    basic, arithmetic, tools = sympy.polys.densebasic, sympy.polys.densearith, sympy.polys.densetools
    _everywhere(basic.dup_strip, lambda f, *_: len(f), take)
    _everywhere(basic.dmp_zero_p, lambda *_: 1, take)
    _everywhere(arithmetic.dup_mul, lambda f, g, *_: len(f) * len(g), take)
    _everywhere(arithmetic.dup_sqr, lambda f, *_: len(f) * len(f), take)
    _everywhere(tools.dup_eval, lambda f, a, *_: _of_value(f, a), take)
    _everywhere(tools._rec_eval_tail, lambda *_: 1, take)
    product = PolyElement.__mul__

    def counted_product(self: Any, other: Any) -> Any:
        take(len(self) * (len(other) if isinstance(other, PolyElement) else 1))
        return product(self, other)

    PolyElement.__mul__ = counted_product


def _of_value(f: list[Any], a: Any) -> int:
    """The steps of a polynomial's value: long numbers take more steps, at each power."""
    bits = int(a).bit_length() if isinstance(a, int) else 0
    return len(f) + len(f) ** 2 * bits // BITS_PER_STEP


def _count_numbers_and_signs(take: Count) -> None:
    # `sympy.core` has functions of the same names as these modules.
    numbers, signs = import_module("sympy.core.evalf"), import_module("sympy.core.assumptions")
    evaluate, ask = numbers.evalf, signs._ask

    def counted_evaluation(x: Any, prec: int, options: Any) -> Any:
        take(STEPS_OF_A_NUMBER + prec // BITS_PER_STEP)
        return evaluate(x, prec, options)

    def counted_question(fact: str, obj: Basic) -> Any:
        take(STEPS_OF_A_QUESTION)
        return ask(fact, obj)

    vars(numbers)["evalf"] = counted_evaluation
    vars(signs)["_ask"] = counted_question


def _everywhere(function: Callable[..., Any], steps: Callable[..., int], take: Count) -> None:
    """Replaces a function of SymPy's polynomials wherever one of their modules has it under its name."""

    def counted(*args: Any) -> Any:
        take(steps(*args))
        return function(*args)

    name = function.__name__
    for module in [m for n, m in sys.modules.items() if n.startswith("sympy.polys.")]:
        if vars(module).get(name) is function:
            setattr(module, name, counted)
