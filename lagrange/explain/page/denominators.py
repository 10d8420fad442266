"""A long denominator that several results share gets a letter: F_1 = .../Δ, F_2 = .../Δ, with Δ in the same box."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.symbols import free_letter
from lagrange.document.derivation import Block, Display, Equation, Step
from lagrange.explain.limits import SHORTEST_NAMED, SHORTEST_OF_MANY
from lagrange.mechanics.rewriting.factors import letter_for


def with_named_denominators(step: Step, taken: Collection[str]) -> Step:
    """The step with a letter for the denominator that lines of a box share."""
    return replace(step, body=tuple(_named(b, taken) for b in step.body))


def _named(block: Block, taken: Collection[str]) -> Block:
    if not isinstance(block, Display) or not block.boxed or len(block.equations) < 2:
        return block
    counts = Counter(base for e in block.equations for base in {*_below(e)})
    shared = [
        b
        for b, n in counts.items()
        if n > 1 and count_operations(b) >= (SHORTEST_NAMED if n == 2 else SHORTEST_OF_MANY)
    ]
    if len(shared) != 1:
        return block
    [base] = shared
    name = free_letter("Delta", "D", "D_0", taken=taken)
    letter = letter_for(base, name)
    lines = tuple(replace(e, sides=tuple(_with_letter(s, base, letter) for s in e.sides)) for e in block.equations)
    return replace(block, equations=(*lines, Equation((letter, base))))


def _below(equation: Equation) -> Iterator[sp.Expr]:
    """The sums in the denominators of its sides."""
    for side in equation.sides:
        if isinstance(side, sp.Expr):
            bases = (f.base for f in sp.Mul.make_args(side) if f.is_Pow and f.exp == -1)
            inside = (b.args[0] if isinstance(b, sp.Abs) else b for b in bases)
            yield from (b for b in inside if b.is_Add)


def _with_letter(side: object, base: sp.Expr, letter: sp.Symbol) -> object:
    if not isinstance(side, sp.Expr) or not side.is_Mul:
        return side
    short = {base: letter, sp.Abs(base): sp.Abs(letter)}
    factors = [1 / short[f.base] if f.is_Pow and f.exp == -1 and f.base in short else f for f in side.args]
    return sp.Mul(*factors, evaluate=False) if factors != list(side.args) else side
