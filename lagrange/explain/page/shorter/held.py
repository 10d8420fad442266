"""Bodies in bearings: vectors and laws written for the values at which constraints hold coordinates.

A shaft has two more angles, so that its bearings have moments; the constraints keep both at zero. Angular momentum and
the laws of motion in all three angles fill a page; with the two at zero they are a line each, and the result needs no
more, since the reactions do work only in the displacements that the constraints exclude.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.document.builders import listed, math, prose
from lagrange.document.derivation import Block, Display, Equation, Mathematics, Rule, Step
from lagrange.explain.limits import LONGEST_FREE_LAWS
from lagrange.explain.words import plural
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.held_coordinates import held_values


def with_held_values(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, the statement and Newton's law with the values of coordinates that are held, if these are long."""
    rule = _held(solution)
    laws = [b for s in steps if s.rule is Rule.REACTIONS and not s.folded for b in s.body if isinstance(b, Display)]
    if not rule or sum(b.operations for b in laws) <= LONGEST_FREE_LAWS:
        yield from steps
        return
    values = {q: rule[q] for q in solution.problem.slots.coordinates if q in rule}
    announced = False
    for step in steps:
        if step.folded or step.rule not in (Rule.STATEMENT, Rule.REACTIONS):
            yield step
            continue
        body = [_at(rule, b) for b in step.body]
        changed = next((n for n, (a, b) in enumerate(zip(step.body, body, strict=True)) if a != b), None)
        if changed is not None and not announced:
            announced = True
            names, kept = listed(map(math, values)), listed(math(q, e) for q, e in values.items())
            words = prose("The constraints below keep ", *kept, ", and vectors are written for ",
                          plural(len(values), "this value", "these values"), " of ", *names, ".")  # fmt: skip
            body = [*body[: max(changed - 1, 0)], words, *body[max(changed - 1, 0) :]]
        yield replace(step, body=tuple(body))


def _held(solution: Solution) -> dict[sp.Symbol, sp.Expr]:
    """`held_values`, where bodies turn and nothing else is eliminated by the choice of coordinates."""
    own = solution.own
    if not solution.choices or own.dynamics is None or not own.configuration.rotations:
        return {}
    held = held_values(own.configuration)
    return held if {*solution.choices[0].configuration.expressed} <= {*held} else {}


def _at(rule: dict[sp.Symbol, sp.Expr], block: Block) -> Block:
    if not isinstance(block, Display):
        return block
    return replace(block, equations=tuple(_line(rule, e) for e in block.equations))


def _line(rule: dict[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    if len(e.sides) < 2 or (e.label or "").startswith("position"):  # positions are shown as the file has them
        return e
    return replace(e, sides=tuple(_value(rule, s) for s in e.sides))


def _value(rule: dict[sp.Symbol, sp.Expr], side: Mathematics) -> Mathematics:
    if isinstance(side, Vector):
        return side.map(lambda c: c.xreplace(rule))
    return side.xreplace(rule)
