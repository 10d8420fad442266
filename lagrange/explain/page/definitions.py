"""Definitions on a page: one name for equal unit vectors, each defined before it is used, none that is not used.

The derivation is written as if each of its steps stood alone. Nothing is computed here; equal unit vectors are those
with equal components.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.symbols import UnitVector
from lagrange.core.vectors import FIXED, UNITS, Triad, Vector, unit_vector
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    Math,
    Mathematics,
    Part,
    Phrase,
    Prose,
    Purpose,
    Step,
    Table,
    has_purpose,
)
from lagrange.explain.bodies import stated_triads, unit_vectors
from lagrange.explain.words import capital
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.readable_forms import multiplied_out

if TYPE_CHECKING:
    pass

# -- one name for one unit vector ------------------------------------------------------------------------------------


def in_one_name(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with one name for equal unit vectors: that of the file, or i, j, k, or the first of those of bodies."""
    names = _names_of_units(solution)
    if not names:
        return iter(steps)
    rule: dict[sp.Basic, sp.Basic] = {UnitVector(old): UnitVector(new) for old, new in names.items()}
    return (replace(s, body=tuple(_renamed(b, rule, names) for b in s.body)) for s in steps)


def _names_of_units(solution: Solution) -> dict[str, str]:
    """The unit vectors of bodies that have another name too, by name."""
    problem, frame = solution.problem, solution.problem.frame
    known = {multiplied_out(v): name for name, v in problem.abbreviations.items() if isinstance(v, Vector)}
    known |= {multiplied_out(unit_vector(FIXED, n)): name for n, name in enumerate(UNITS)}
    named = {*UNITS, *problem.abbreviations, *(frame.names if frame is not None else ())}
    names: dict[str, str] = {}
    for triad in _triads(solution):
        if triad.directions is None or triad == frame:
            continue
        for symbol, direction in unit_vectors(triad):
            name = symbol.name if symbol.name in named else known.setdefault(multiplied_out(direction), symbol.name)
            if name != symbol.name:
                names[symbol.name] = name
    return names


def _triads(solution: Solution) -> tuple[Triad, ...]:
    """The triads in which the page has vectors."""
    triads = [*stated_triads(solution.own.configuration)]
    form = solution.own.in_speeds
    if form is not None and form.equations is not None:
        vectors = (*form.equations.velocities.values(), *form.equations.spins.values())
        triads += [v.triad for v in vectors]
    return tuple(dict.fromkeys(triads))


def _renamed(block: Block, rule: dict[sp.Basic, sp.Basic], names: Mapping[str, str]) -> Block:
    def inside(e: Mathematics) -> Mathematics:
        if not isinstance(e, Vector):
            return e.xreplace(rule)
        a, b, c = (names.get(n, n) for n in e.triad.names)
        return e if (a, b, c) == e.triad.names else Vector(e.components, replace(e.triad, names=(a, b, c)))

    def part(p: Part) -> Part:
        return replace(p, sides=tuple(map(inside, p.sides))) if isinstance(p, Math) else p

    if isinstance(block, Prose):
        return replace(block, parts=tuple(map(part, block.parts)))
    if isinstance(block, Display):
        lines = (
            replace(e, sides=tuple(map(inside, e.sides)), condition=tuple(map(part, e.condition)))
            for e in block.equations
        )
        return replace(block, equations=tuple(lines))
    return block


# -- what is not used ------------------------------------------------------------------------------------------------


def without_unused(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps without abbreviations and unit vectors that are stated and do not occur, or are stated again."""
    units = (u.name for t in _triads(solution) for u in t.units)
    stated = {*map(str, solution.problem.abbreviations), *units} - {*UNITS}
    used = {name for step in steps for block in step.body for name in _names_in(block, stated)}
    defined: set[str] = {*UNITS}
    for step in steps:
        body: list[Block] = []
        begins = False
        for block in step.body:
            before = body[-1] if body else None
            if begins and isinstance(block, Prose):  # the words before it, `With the unit vectors`, are omitted
                block, begins = _beginning(block), False
            if not isinstance(block, Display) or not has_purpose(before, Purpose.DEFINITIONS):
                body.append(block)
                continue
            kept = []
            for e in block.equations:
                name = _defined(e)
                if name in defined or (name in stated and name not in used):
                    continue
                defined.add(name)
                kept.append(e)
            if kept:
                if len(kept) == 1:
                    body[-1] = replace(before, parts=tuple(map(_in_singular, before.parts)))
                body.append(replace(block, equations=tuple(kept)))
            else:
                body.pop()
                begins = True
        if body or not step.body:
            yield replace(step, body=tuple(body))


def _beginning(block: Prose) -> Prose:
    """The paragraph as the beginning of a sentence."""
    first, *rest = block.parts or ("",)
    return replace(block, parts=(capital(first), *rest)) if isinstance(first, str) and first[:1].islower() else block


def _in_singular(part: Part) -> Part:
    return part.instead or part if isinstance(part, Phrase) else part


def _defined(e: Equation) -> str:
    left = e.sides[0]
    return left.name if isinstance(left, sp.Symbol) else ""


def _names_in(block: Block, stated: Collection[str]) -> Iterator[str]:
    """The names of symbols in a block; for a definition only those on the right."""
    if isinstance(block, Prose):
        yield from _names_of_parts(block.parts)
    elif isinstance(block, Display):
        for e in block.equations:
            sides = e.sides[1:] if _defined(e) in stated else e.sides
            yield from (n for s in sides for n in _names_of(s))
            yield from _names_of_parts(e.condition)
    elif isinstance(block, Table):
        for row in block.rows:
            yield from _names_of_parts(row)


def _names_of_parts(parts: Iterable[Part]) -> Iterator[str]:
    yield from (n for p in parts if isinstance(p, Math) for s in p.sides for n in _names_of(s))


def _names_of(e: Mathematics) -> Iterator[str]:
    if isinstance(e, Vector):
        yield from (n for n, c in zip(e.triad.names, e.components, strict=True) if c != 0)
    symbols = e.free_symbols if isinstance(e, sp.Basic) else {s for c in e.components for s in c.free_symbols}
    yield from (s.name.rstrip("'") for s in symbols if isinstance(s, sp.Symbol))


# -- definitions in their order --------------------------------------------------------------------------------------


def defined_in_order(steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with lists of definitions in the order in which one uses another."""
    for step in steps:
        body = list(step.body)
        places = [
            n for n in range(len(body) - 1)
            if has_purpose(body[n], Purpose.DEFINITIONS) and isinstance(body[n + 1], Display)
        ]  # fmt: skip
        for first, second in pairwise(places):
            if second == first + 2 and _uses(body[first + 1], body[second + 1]):
                body[first : second + 2] = [*body[second : second + 2], *body[first:second]]
        yield replace(step, body=tuple(body))


def _uses(block: Block, definitions: Block) -> bool:
    """Whether a list of definitions has a name in it that the other list defines."""
    assert isinstance(block, Display)
    assert isinstance(definitions, Display)
    names = {n for e in block.equations for side in e.sides[1:] for n in _names_of(side)}
    return not names.isdisjoint(_defined(e) for e in definitions.equations)
