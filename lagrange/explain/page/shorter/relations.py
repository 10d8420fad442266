"""Conditions with what they are about on the left: μ ≥ ½ tan φ, P ≥ M a/(l r), as a reader asks for them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.document.derivation import Block, Display, Equation, Rule, Step

_RULES = (Rule.RESULT, Rule.FRICTION_AT_REST)
_TURNED = {"≤": "≥", "=": "="}


def with_symbol_first(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, the conditions of rest turned round where a single symbol stands on the right."""
    for step in steps:
        if step.rule in _RULES and not step.folded:
            step = replace(step, body=tuple(map(_block, step.body)))
        yield step


def _block(block: Block) -> Block:
    if not isinstance(block, Display) or not block.boxed:
        return block
    return replace(block, equations=tuple(map(_turned, block.equations)))


def _turned(e: Equation) -> Equation:
    if len(e.sides) != 2 or e.relation not in _TURNED:
        return e
    left, right = e.sides
    if (
        not isinstance(right, sp.Symbol)
        or not isinstance(left, sp.Expr)
        or left.is_Symbol
        or right in left.free_symbols
    ):
        return e
    return replace(e, sides=(right, left), relation=_TURNED[e.relation])
