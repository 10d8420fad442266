"""Reactions in the form of the file's answers, where these are right and shorter: N = m g (3 cos θ − 2).

A ball that rolls on a ball has forces of friction that are products of five angular velocities each; by the spin ω·out
about the line of centres they are two terms. Which form is a good one, the author of a problem knows.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.document.derivation import Block, Display, Equation, Rule, Step
from lagrange.explain.limits import SHORTER_AS_STATED
from lagrange.mechanics.rewriting.stated_names import StatedEquations


def with_stated_forces(steps: Sequence[Step], stated: StatedEquations) -> list[Step]:
    """The steps with the reactions in these forms, as far as they are shorter; what is folded stays."""
    forms = {name: value for name, value in stated if isinstance(name, sp.Symbol)}
    return [
        replace(s, body=tuple(_blocks(forms, s.body))) if s.rule is Rule.SOLVED_REACTIONS and not s.folded else s
        for s in steps
    ]


def _blocks(forms: Mapping[sp.Symbol, sp.Expr], body: Sequence[Block]) -> Iterator[Block]:
    for block in body:
        if isinstance(block, Display) and block.boxed:
            yield replace(block, equations=tuple(_line(forms, e) for e in block.equations))
        else:
            yield block


def _line(forms: Mapping[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    form = forms.get(e.sides[0]) if isinstance(e.sides[0], sp.Symbol) else None
    if form is None or len(e.sides) > 2:  # a chain has its value in more than one set of coordinates
        return e
    short = replace(e, sides=(e.sides[0], form))
    return short if short.operations <= SHORTER_AS_STATED * e.operations else e
