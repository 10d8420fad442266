"""Coordinates that constraints hold together, as the height and tilt of a car on two axles: their values substituted.

The constraints are stated in general, with their differentials; after that every line is written for the constant
values that they leave: the reactions do work only in the displacements that the constraints exclude.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import CONSTANT
from lagrange.core.vectors import Vector
from lagrange.document.builders import display, has_purpose, listed, math, prose
from lagrange.document.derivation import Block, Detail, Display, Equation, Math, Mathematics, Part, Prose, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.words import capital, constraints_called, plural
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.held_together import HeldTogether, held_together

_BEFORE = (
    Rule.RESULT, Rule.STATEMENT, Rule.CONSTRAINT, Rule.PFAFFIAN_FORM, Rule.INTEGRABILITY, Rule.CLASSIFICATION,
    Rule.DEGREES_OF_FREEDOM, Rule.QUESTION, Rule.CHECKS,
)  # fmt: skip
"""The steps that stay in general, and those that have their own values."""


def with_values_put_in(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps of a page with the values, and a sentence that says so at the end of the constraints."""
    held = held_together(solution)
    about = [n for n, s in enumerate(steps) if s.rule is Rule.CONSTRAINT and not s.folded]
    if held is None or not about:
        yield from steps
        return
    last = max(n for n, s in enumerate(steps) if s.rule in _BEFORE[2:7] and not s.folded)
    for n, step in enumerate(steps):
        if n == last:
            yield replace(step, body=(*step.body, _announced(held)))
        elif step.rule is Rule.SOLVED_REACTIONS and not step.folded:
            yield replace(step, body=tuple(_forces(held, step, solution)))
        else:
            yield put_in(held, step)


def put_in(held: HeldTogether | None, step: Step) -> Step:
    """A step with the values; without lines that say nothing then."""
    if held is None or step.folded or step.rule in _BEFORE:
        return step
    return replace(step, body=tuple(b for block in step.body for b in _block(held.rule, block)))


def _announced(held: HeldTogether) -> Prose:
    values = listed(math(q, e) for q, e in held.values.items())
    words = plural(len(held.values), " constant. From here on its value is substituted: ",
                   " constant. From here on their values are substituted: ")  # fmt: skip
    return prose("Together the constraints keep ", *listed(map(math, held.values)), words, *values, ".")


def _forces(held: HeldTogether, step: Step, solution: Solution) -> Iterator[Block]:
    """The forces, and what is said of contact after them."""
    yield prose("With these values, Newton's law and the law of angular momentum give")
    lines = [e for b in step.body if isinstance(b, Display) and b.boxed for e in b.equations]
    labels = {e.sides[0]: e.label for e in lines}
    shown = [Equation((name, value), label=labels.get(name) or f"force-{name}") for name, value in held.forces.items()]
    yield display(*shown, boxed=True, detail=Detail.STEPS)
    said = [b for b in step.body if has_purpose(b, Purpose.ONLY_PUSHES) or has_purpose(b, Purpose.CONTACT)]
    yield from said or _contacts(held, solution)


def _contacts(held: HeldTogether, solution: Solution) -> Iterator[Prose]:
    """How long one-sided constraints act whose forces may change sign."""
    reactions = solution.law.newton.reactions if solution.law is not None else ()
    for r in reactions:
        value = held.forces.get(r.force)
        if r.constraint.side is not None and value is not None and not value.is_positive:
            called = capital(constraints_called([r.name]))
            force = math(r.force, sp.S.Zero, relation="≥")
            yield prose(f"{called} can only push: it stays in contact as long as ", force, ".", purpose=Purpose.CONTACT)


def _block(rule: Mapping[sp.Symbol, sp.Expr], block: Block) -> Iterator[Block]:
    if isinstance(block, Prose):
        yield replace(block, parts=_without_trivial([_part(rule, p) for p in block.parts]))
    elif isinstance(block, Display):
        lines = [e for line in block.equations if len({*(e := _line(rule, line)).sides}) > 1 or len(line.sides) < 2]
        yield from [replace(block, equations=tuple(lines))] if lines else []
    else:
        yield block


def _line(rule: Mapping[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    condition = _without_trivial([_part(rule, p) for p in e.condition])
    sides = _sides(rule, e.sides)
    if (e.label or "").startswith("energy-rate") and isinstance(sides[0], sp.Expr):
        sides = (_without_constants_below(sides[0]), *sides[1:])
    return replace(e, sides=sides, condition=condition if any(map(_says_something, condition)) else ())


def _sides(rule: Mapping[sp.Symbol, sp.Expr], sides: Iterable[Mathematics]) -> tuple[Mathematics, ...]:
    left, *right = (_side(rule, s) for s in sides)
    if right and right[-1] == CONSTANT and isinstance(left, sp.Expr):
        left = _without_constants(left)
    return (left, *right)


def _without_constants(e: sp.Expr) -> sp.Expr:
    """A sum that is constant, or whose rate is meant, without the terms that are so by themselves."""
    terms = [a for a in sp.Add.make_args(e) if any(not s.is_positive for s in a.free_symbols)]
    return sp.Add(*terms, evaluate=False) if 0 < len(terms) < len(sp.Add.make_args(e)) else e


def _without_constants_below(e: sp.Expr) -> sp.Expr:
    return e.func(*(_without_constants(a) for a in e.args)) if e.args and not e.is_Add else e


def _side(rule: Mapping[sp.Symbol, sp.Expr], side: Mathematics) -> Mathematics:
    if isinstance(side, Vector):
        return side.map(lambda c: _value(rule, c))
    return _value(rule, side)


def _value(rule: Mapping[sp.Symbol, sp.Expr], e: sp.Expr) -> sp.Expr:
    return e.xreplace(dict(rule))


def _part(rule: Mapping[sp.Symbol, sp.Expr], part: Part) -> Part:
    return replace(part, sides=_sides(rule, part.sides)) if isinstance(part, Math) else part


def _says_something(part: Part) -> bool:
    return bool(part) and not (isinstance(part, Phrase) and part.purpose is Purpose.WHERE)


def _without_trivial(parts: Sequence[Part]) -> tuple[Part, ...]:
    """A sentence without `where 1 ≠ 0`."""
    kept: list[Part] = []
    dropped = False
    for p in parts:
        if isinstance(p, Math) and p.relation == "≠" and all(s.is_number for s in p.sides if isinstance(s, sp.Expr)):
            if kept and isinstance(kept[-1], Phrase) and kept[-1].purpose is Purpose.WHERE:
                kept.pop()
            dropped = True
        elif dropped and isinstance(p, str):
            kept.append(p.removeprefix(","))
            dropped = False
        else:
            kept.append(p)
    return tuple(p for p in kept if p != "")
