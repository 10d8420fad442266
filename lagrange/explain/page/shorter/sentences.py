"""Sentences of the full derivation that a page says in fewer words, and short equations side by side.

The full derivation explains Newton's law and multipliers wherever they occur. A page explains once what it needs.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.document.builders import has_purpose, index_of, listed, paired, parts_of, prose
from lagrange.document.derivation import Block, Display, Equation, Math, Prose, Ref, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.limits import LONGEST_PLAIN_FORCES
from lagrange.explain.page.system import are_short


def in_fewer_words(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps with shorter sentences, and with displacements and substitutions in pairs."""
    referred = {p.label for s in steps for b in s.body for p in parts_of(b) if isinstance(p, Ref)}
    moves = any(s.rule in (Rule.EQUATIONS_OF_MOTION, Rule.QUASI_VELOCITIES) for s in steps)
    for step in steps:
        kept = step.folded or step.rule is Rule.RESULT
        body = step.body if kept else tuple(_shortly(step.body, referred))
        if moves and not kept and step.rule in (Rule.CLASSIFICATION, Rule.DEGREES_OF_FREEDOM):
            body = tuple(map(_only_velocities, body))  # where constraints are the subject it is said in full
        yield replace(step, body=body)


def _shortly(body: Sequence[Block], referred: Collection[str]) -> Iterator[Block]:
    for n, block in enumerate(body):
        follows = body[n + 1] if n + 1 < len(body) else None
        if isinstance(block, Prose):
            yield _words(block, follows)
        elif isinstance(block, Display) and not block.boxed and _are_steps(block, referred):
            yield replace(block, equations=tuple(_in_pairs(block.equations)))
        else:
            yield block


def _only_velocities(block: Block) -> Block:
    if not isinstance(block, Prose):
        return block
    of = Purpose.REACHED
    parts = (p.instead if isinstance(p, Phrase) and p.purpose is of and p.instead else p for p in block.parts)
    return replace(block, parts=tuple(parts))


def _words(block: Prose, follows: Block | None) -> Prose:
    first = block.parts[0] if block.parts else ""
    if isinstance(first, Phrase) and first.purpose is Purpose.LAW:
        return prose(first.instead, *block.parts[1:])
    if isinstance(first, Phrase) and first.purpose is Purpose.SUM_AND_MOMENT:
        return prose(first.instead)
    if has_purpose(block, Purpose.MULTIPLIERS) and index_of(Purpose.EVERY_COORDINATE, block.parts) is not None:
        letters = [p for p in block.parts if isinstance(p, Math)]
        multipliers = letters[: _count(block)]
        return prose("With ", "a multiplier " if len(multipliers) == 1 else "multipliers ", *listed(multipliers),
                     " of the constraint" if len(multipliers) == 1 else " of the constraints",
                     " instead, nothing is eliminated, and for every coordinate")  # fmt: skip
    too_long = index_of(Purpose.REASON, block.parts[:1]) is not None
    if too_long and isinstance(follows, Display) and follows.operations <= LONGEST_PLAIN_FORCES:
        return replace(block, parts=block.parts[1:])
    return block


def _count(block: Prose) -> int:
    """How many multipliers a paragraph names before it says what becomes of them."""
    end = index_of(Purpose.VERB, block.parts)
    return sum(isinstance(p, Math) for p in block.parts[:end])


def _are_steps(block: Display, referred: Collection[str]) -> bool:
    """Whether it has substitutions of coordinates, or displacements, to none of which anything refers."""
    free = not any(e.label in referred for e in block.equations)
    return free and len(block.equations) > 1 and all(_is_step(e) for e in block.equations)


def _is_step(e: Equation) -> bool:
    name = e.sides[0].name if isinstance(e.sides[0], sp.Symbol) else ""
    plain = len(e.sides) == 2 and not e.condition and e.relation == "="
    return plain and ((e.label or "").startswith("choice-") or (e.label is None and name.startswith(("delta(", "d("))))


def _in_pairs(equations: Sequence[Equation]) -> Iterator[Equation]:
    """Neighbours of one point, x₁ and y₁, side by side where both are short."""
    rest = [*equations]
    while rest:
        pair = rest[:2]
        if len(pair) == 2 and len({_index(e) for e in pair}) == 1 and are_short(pair):
            yield paired(pair)[0]
            rest = rest[2:]
        else:
            yield rest.pop(0)


def _index(e: Equation) -> str:
    """`1` of x₁ and of δx₁."""
    name = e.sides[0].name if isinstance(e.sides[0], sp.Symbol) else ""
    name = name.rpartition("(")[2].rstrip(")")
    return name.partition("_")[2] or name.lstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ")
