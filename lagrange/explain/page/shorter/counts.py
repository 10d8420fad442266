"""Unknowns and equations of bodies in a line: what the directions of the reactions are needed for.

The full derivation counts coordinates and components one by one. On a page whose laws are already written in terms of
the forces that remain, a sentence is enough: so many equations for so many unknowns, and how many unknowns there would
be if the directions were not known.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lagrange.document.builders import has_purpose, prose
from lagrange.document.derivation import Block, Rule, Step
from lagrange.document.purposes import Purpose
from lagrange.explain.words import plural
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.results import Solution


def counted_shortly(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, that on Newton's law with a shorter count."""
    newton = None if solution.law is None else solution.law.newton
    for step in steps:
        if step.rule is Rule.REACTIONS and newton is not None:
            step = replace(step, body=tuple(_shortly(b, newton) for b in step.body))
        yield step


def _shortly(block: Block, newton: Newton) -> Block:
    before, after = newton.before, newton.after
    if before is None or after is None or not has_purpose(block, Purpose.COUNT) or after.unknowns != after.equations:
        return block
    constraints = before.equations - sum(len(b.laws) for b in newton.bodies or ()) - len(newton.idle)
    bound = plural(constraints, "the constraint", f"the {constraints} constraints")
    short = f"With {bound} these are {after.equations} equations for {after.unknowns} unknowns."
    if before.missing > 0:
        short += f" Without the directions of the reactions there would be {before.unknowns}."
    return prose(short)
