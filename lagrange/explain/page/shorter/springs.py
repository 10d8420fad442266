"""The length of a spring by the letter that the statement gives it, where written out it is a long root.

d = √(a² + 2a l (sin θ₂ − sin θ₁) + ...) occurs in the potential energy, in every equation of motion and in those of
rest: all of them are read more easily with d, as the force of a spring is c (d − a).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.document.derivation import Block, Display, Equation, Mathematics, Rule, Step

SHORTEST = 10
"""The fewest operations of a length that is not written out again."""
_RULES = (Rule.STATEMENT, Rule.PRINCIPLE, Rule.EQUATIONS_OF_MOTION, Rule.LINEARIZATION, Rule.CONSERVED, Rule.MEANING,
          Rule.EQUILIBRIUM, Rule.REACTIONS, Rule.SOLVED_REACTIONS)  # fmt: skip


def with_lengths(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, with the letters of long lengths after these have been stated."""
    statement = next((s for s in steps if s.rule is Rule.STATEMENT), None)
    lengths = {} if statement is None else dict(_lengths(statement))
    for step in steps:
        if lengths and step.rule in _RULES and not step.folded:
            step = replace(step, body=tuple(_block(b, lengths) for b in step.body))
        yield step


def _lengths(step: Step) -> Iterator[tuple[sp.Expr, sp.Symbol]]:
    """The radicands of long roots that a letter stands for, with the letter."""
    for block in step.body:
        for e in block.equations if isinstance(block, Display) else ():
            name, value = e.sides[0], e.sides[-1]
            root = isinstance(value, sp.Pow) and value.exp == sp.S.Half
            if (
                isinstance(name, sp.Symbol)
                and isinstance(value, sp.Pow)
                and root
                and count_operations(value) > SHORTEST
            ):
                yield value.base, sp.Symbol(name.name, positive=True)


def _block(block: Block, lengths: dict[sp.Expr, sp.Symbol]) -> Block:
    if not isinstance(block, Display):
        return block
    return replace(block, equations=tuple(_line(e, lengths) for e in block.equations))


def _line(e: Equation, lengths: dict[sp.Expr, sp.Symbol]) -> Equation:
    if isinstance(e.sides[0], sp.Symbol) and e.sides[0].name in {s.name for s in lengths.values()}:
        return e
    return replace(e, sides=tuple(_side(s, lengths) for s in e.sides))


def _side(side: Mathematics, lengths: dict[sp.Expr, sp.Symbol]) -> Mathematics:
    if not isinstance(side, sp.Expr) or not side.has(*lengths):
        return side

    def is_length(e: sp.Basic) -> bool:
        return isinstance(e, sp.Pow) and e.base in lengths and e.exp.is_Rational and e.exp.q == 2

    rule = {p: lengths[p.base] ** (2 * p.exp) for p in side.atoms(sp.Pow) if is_length(p)}
    return side.xreplace(rule)
