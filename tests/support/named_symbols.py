"""Which symbols of a page are used before anything says what they are.

The statement lists coordinates and parameters; a paragraph names what it has in it; a line defines its left side. Of
q', δq, dq and δr it is q and r that have to be known.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

import sympy as sp

from lagrange.core.symbols import CONSTANT, t
from lagrange.core.vectors import UNITS, Vector
from lagrange.document.derivation import Block, Display, Math, Matrices, Part, Prose, Rule, Table
from lagrange.explain.report import Report

_OF = re.compile(r"(?:delta|d|nabla)\((.*)\)")


def unnamed_symbols(report: Report) -> list[str]:
    """`ω_3 in section 6`; those of the head that nothing below it names, as `head: ω_3`."""
    problem = report.solution.problem
    known = {s.name for s in (t, CONSTANT)} | {*UNITS}
    known |= {q.name for q in problem.slots.coordinates} | {p.symbol.name for p in problem.parameters}
    known |= {f.name for f in problem.slots.prescribed} | {*problem.scope.functions}
    found: list[str] = []
    head: set[str] = set()
    families: set[str] = set()  # R, where the reactions R are said to be R_A and R_B
    number = 0
    for step in report.derivation.page:
        if step.rule is Rule.RESULT:
            head |= {n for b in step.body for n in (*_defined(b), *_used(b))}
            continue
        if step.folded or step.rule is Rule.CHECKS:
            continue
        number += 1
        for n, block in enumerate(step.body):
            known |= {name for b in _at_once(step.body[n:]) for name in _defined(b)}
            new = dict.fromkeys(n for n in _used(block) if n not in known and n.partition("_")[0] not in families)
            found += [f"{n} in section {number}" for n in new]
            known |= {*new}
            families |= {n for n in _defined(block) if n.isalpha() and isinstance(block, Prose)}
    return found + [f"head: {n}" for n in sorted(head - known - {"Delta"})]  # a denominator: its line defines it


def _at_once(blocks: Sequence[Block]) -> Iterator[Block]:
    """A block, and what says in the same breath what it contains: `with`, and lines; `The friction contains N`."""
    block, *after = blocks
    yield block
    if isinstance(block, Display) and after and isinstance(after[0], Prose):
        yield after[0]
        if after[0].parts == ("with",):
            yield from after[1:2]


def _defined(block: Block) -> Iterator[str]:
    """What a block names."""
    if isinstance(block, Prose):
        yield from _in_parts(block.parts)
    elif isinstance(block, Display):
        for e in block.equations:
            left = e.sides[0]
            yield from _names(left) if isinstance(left, sp.Symbol) or len(_symbols(left)) == 1 else ()
            yield from _in_parts(e.condition)
    elif isinstance(block, Table):
        yield from (n for row in block.rows for n in _in_parts(row))
    elif isinstance(block, Matrices):
        yield from (letter.name for letter, _ in block.named)


def _used(block: Block) -> Iterator[str]:
    if isinstance(block, Display):
        yield from (n for e in block.equations for side in e.sides for n in _names(side))


def _in_parts(parts: Iterable[Part]) -> Iterator[str]:
    yield from (n for p in parts if isinstance(p, Math) for side in p.sides for n in _names(side))


def _names(side: object) -> Iterator[str]:
    if isinstance(side, Vector):
        yield from (_stem(n) for n, c in zip(side.triad.names, side.components, strict=True) if c != 0)
    yield from (_stem(s.name) for s in _symbols(side))


def _symbols(side: object) -> set[sp.Symbol]:
    parts = side.components if isinstance(side, Vector) else (side,)
    return {s for e in parts if isinstance(e, sp.Basic) for s in e.free_symbols if isinstance(s, sp.Symbol)}


def _stem(name: str) -> str:
    """q of q'', δq and d(q)."""
    while (match := _OF.fullmatch(name.rstrip("'"))) is not None:
        name = match.group(1)
    return name.rstrip("'")
