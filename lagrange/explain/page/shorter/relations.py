"""Conditions with the quantity that they limit on the left, as a reader expects: μ ≥ ½ tan φ, P ≥ M a/(l r)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.document.derivation import Block, Display, Equation, Rule, Step
from lagrange.mechanics.rewriting.factors import with_factors_in_fraction

_ASKED = (Rule.RESULT, Rule.QUESTION)
_TURNED = {Rule.RESULT: {"≤": "≥", "<": ">"}, Rule.FRICTION_AT_REST: {"≤": "≥", "<": ">", "=": "="}}
"""The relations that are turned round, and what they become: at the head no equations, which may be anything."""


def with_symbol_first(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, the conditions of rest turned round where a single symbol stands on the right."""
    for step in steps:
        if step.rule in _ASKED and not step.folded:
            step = replace(step, body=tuple(_factored(b) for b in step.body))
        relations = _TURNED.get(step.rule, {})
        if relations and not step.folded:
            step = replace(step, body=tuple(_block(b, relations) for b in step.body))
        yield step


def _factored(block: Block) -> Block:
    """Answers with the factors of numerator and denominator in front, where these are sums of several terms."""
    if not isinstance(block, Display) or not block.boxed:
        return block
    return replace(block, equations=tuple(_in_factors(e) for e in block.equations))


def _in_factors(e: Equation) -> Equation:
    value = e.sides[-1]
    if not isinstance(value, sp.Expr):
        return e
    return replace(e, sides=(e.sides[0], with_factors_in_fraction(value))) if len(e.sides) == 2 else e


def _block(block: Block, relations: Mapping[str, str]) -> Block:
    if not isinstance(block, Display) or not block.boxed:
        return block
    return replace(block, equations=tuple(_turned(e, relations) for e in block.equations))


def _turned(e: Equation, relations: Mapping[str, str]) -> Equation:
    if len(e.sides) != 2 or e.relation not in relations:
        return e
    left, right = e.sides
    if (
        not isinstance(right, sp.Symbol)
        or not isinstance(left, sp.Expr)
        or left.is_Symbol
        or right in left.free_symbols
    ):
        return e
    return replace(e, sides=(right, left), relation=relations[e.relation])
