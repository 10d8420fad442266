"""Bodies in bearings: vectors and laws written for the values at which constraints hold coordinates.

A shaft has two more angles, so that its bearings have moments; the constraints keep both at zero. Angular momentum and
the laws of motion in all three angles fill a page, and with the two at zero they are a line each, which is all that the
result needs: displacements in which reactions do work are those of the constraints, whatever the rest.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.symbols import prime, t
from lagrange.core.vectors import Vector
from lagrange.document.builders import listed, math, prose
from lagrange.document.derivation import Block, Display, Equation, Mathematics, Rule, Step
from lagrange.explain.limits import LONGEST_FREE_LAWS
from lagrange.explain.words import plural
from lagrange.mechanics.results import Solution


def with_held_values(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, the statement and Newton's law with the values of coordinates that are held, if these are long."""
    values = _held(solution)
    laws = [s for s in steps if s.rule is Rule.REACTIONS and not s.folded]
    if not values or sum(map(_length, laws)) <= LONGEST_FREE_LAWS:
        yield from steps
        return
    rule: dict[sp.Basic, sp.Expr] = {}
    for q, value in values.items():
        rule |= {q: value, prime(q): sp.S.Zero, prime(q, 2): sp.S.Zero}
    said = False
    for step in steps:
        if step.folded or step.rule not in (Rule.STATEMENT, Rule.REACTIONS):
            yield step
            continue
        body = [_at(rule, b) for b in step.body]
        changed = next((n for n, (a, b) in enumerate(zip(step.body, body, strict=True)) if a != b), None)
        if changed is not None and not said:
            said = True
            names, kept = listed(map(math, values)), listed(math(q, e) for q, e in values.items())
            words = prose("The constraints below keep ", *kept, ", and vectors are written for ",
                          plural(len(values), "this value", "these values"), " of ", *names, ".")  # fmt: skip
            body = [*body[: max(changed - 1, 0)], words, *body[max(changed - 1, 0) :]]
        yield replace(step, body=tuple(body))


def _held(solution: Solution) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates of the file that constraints of motion keep constant, where bodies turn; {} if others differ."""
    view = solution.choices[0] if solution.choices else None
    if view is None or solution.own.dynamics is None or not solution.own.configuration.rotations:
        return {}
    slots = view.configuration.slots
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}
    expressed = view.configuration.expressed
    return {} if any(e.free_symbols & moving for e in expressed.values()) else dict(expressed)


def _length(step: Step) -> int:
    equations = [e for b in step.body if isinstance(b, Display) for e in b.equations]
    return sum(count_operations(s) for e in equations for s in e.sides if isinstance(s, sp.Expr))


def _at(rule: dict[sp.Basic, sp.Expr], block: Block) -> Block:
    return (
        replace(block, equations=tuple(_line(rule, e) for e in block.equations))
        if isinstance(block, Display)
        else block
    )


def _line(rule: dict[sp.Basic, sp.Expr], e: Equation) -> Equation:
    if len(e.sides) < 2:
        return e
    if (e.label or "").startswith("position"):
        return e  # the file's own
    return replace(e, sides=tuple(_value(rule, s) for s in e.sides))


def _value(rule: dict[sp.Basic, sp.Expr], side: Mathematics) -> Mathematics:
    if isinstance(side, Vector):
        return side.map(lambda c: c.xreplace(rule))
    return side.xreplace(rule)
