"""Reactions in the form of the file's answers, if these are right and shorter, or by quantities of its equations.

The forces of friction on a ball that rolls on a ball contain products of five angular velocities each; in terms of the
spin ω·out about the line of centres, in which the equations of motion are stated, they have two terms.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import DotProduct
from lagrange.document.derivation import Block, Display, Equation, Rule, Step
from lagrange.explain.limits import SHORTER_AS_STATED
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.stated_names import StatedEquations, by_named_rates


def with_stated_forces(
    solution: Solution, steps: Sequence[Step], forces: StatedEquations, stated: StatedEquations
) -> list[Step]:
    """The steps with the reactions in these forms, as far as they are shorter; what is folded stays.

    forces  as the answers have them
    stated  the equations of motion there
    """
    forms = {name: value for name, value in forces if isinstance(name, sp.Symbol)}
    named = any(side.has(DotProduct) for sides in stated for side in sides)

    def line(e: Equation) -> Equation:
        e = _line(forms, e)
        value = e.sides[-1]
        if not named or len(e.sides) != 2 or not isinstance(value, sp.Expr) or value.has(DotProduct):
            return e
        return replace(e, sides=(e.sides[0], by_named_rates(solution, value, stated)))

    return [
        replace(s, body=tuple(_blocks(line, s.body))) if s.rule is Rule.SOLVED_REACTIONS and not s.folded else s
        for s in steps
    ]


def _blocks(line: Callable[[Equation], Equation], body: Sequence[Block]) -> Iterator[Block]:
    for block in body:
        if isinstance(block, Display) and block.boxed:
            yield replace(block, equations=tuple(map(line, block.equations)))
        else:
            yield block


def _line(forms: Mapping[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    form = forms.get(e.sides[0]) if isinstance(e.sides[0], sp.Symbol) else None
    if form is None or len(e.sides) > 2:  # a chain has its value in more than one set of coordinates
        return e
    short = replace(e, sides=(e.sides[0], form))
    return short if short.operations <= SHORTER_AS_STATED * e.operations else e
