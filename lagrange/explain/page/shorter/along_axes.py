"""Several reactions on a single body as one vector, along unit vectors that turn with it, where that is much shorter.

The couple of the bearings on a disc that is fixed askew, in i and j, has cos φ and sin φ in every term. In the axes of
the disc it is ¼ m R² sin β cos β (φ'' e_1 + φ'² e_2), as in the books.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.builders import display, prose
from lagrange.document.derivation import Block, Display, Equation, Rule, Step
from lagrange.mechanics.dynamics.newton import FreeBody, Reaction
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.turned_reactions import sum_along_axes, turning_axes, where_constant

LABEL = "along-axes"
"""How the labels of these lines begin."""


def with_sums_along_axes(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, with the reactions on the only body as a vector after them."""
    newton = None if solution.law is None else solution.law.newton
    bodies = () if newton is None else newton.bodies or ()
    body = bodies[0] if len(bodies) == 1 else None
    for step in steps:
        if body is None or step.rule is not Rule.SOLVED_REACTIONS or step.folded:
            yield step
            continue
        yield replace(step, body=(*_with_sum(solution, body, step.body),))


def _with_sum(solution: Solution, body: FreeBody, blocks: Sequence[Block]) -> Iterator[Block]:
    values = {e.sides[0]: e.sides[-1] for b in blocks if isinstance(b, Display) and b.boxed for e in b.equations}
    boxes = [n for n, b in enumerate(blocks) if isinstance(b, Display) and b.boxed]
    lines = [*_sums(solution, body, values)] if boxes else []
    for n, block in enumerate(blocks):
        yield block
        if lines and n == boxes[-1]:
            what = " and ".join(called for called, _ in lines)
            yield prose(f"As {'vectors' if len(lines) > 1 else 'a vector'}, along unit vectors that turn, {what}")
            yield display(*(e for _, e in lines), boxed=True)


def _sums(solution: Solution, body: FreeBody, values: Mapping[object, object]) -> Iterator[tuple[str, Equation]]:
    """The force and the couple, each with what it is called; neither unless every share is in the box."""
    kinds = (("R", "their sum is", body.reactions), ("Gamma", "their moment is", body.moments))
    for letter, called, terms in kinds if not (body.reactions and body.moments) else kinds[:1]:
        shares = [(where_constant(solution, g), value) for g, value in _shares(terms, values)]
        if len(shares) == len(terms) > 1 and (total := sum_along_axes(shares, turning_axes(solution))) is not None:
            yield called, Equation((VectorSymbol(f"{letter}_{body.name}"), total), label=f"{LABEL}-{letter}")


def _shares(
    terms: Sequence[tuple[Reaction, Vector]], values: Mapping[object, object]
) -> Iterator[tuple[Vector, sp.Expr]]:
    for reaction, direction in terms:
        value = values.get(reaction.force)
        if isinstance(value, sp.Expr):
            yield direction, value
