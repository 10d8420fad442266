"""Coordinates that bearings or several constraints hold: vectors and laws are written for their values.

Bodies in bearings: vectors and laws written for the values at which constraints hold coordinates.

A shaft has two more angles, so that its bearings have moments; the constraints keep both at zero. Angular momentum and
the laws of motion in all three angles fill a page; with the two at zero they are a line each, and the result needs no
more, since the reactions do work only in the displacements that the constraints exclude.

Coordinates that constraints hold together, as the height and tilt of a car on two axles: their values substituted.

The constraints are stated in general, with their differentials; after that every line is written for the constant
values that they leave: the reactions do work only in the displacements that the constraints exclude.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import CONSTANT
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
    Equation,
    EquationKind,
    Math,
    Mathematics,
    Part,
    Phrase,
    Prose,
    Purpose,
    Rule,
    Step,
    display,
    has_purpose,
    listed,
    math,
    prose,
)
from lagrange.explain.limits import LONGEST_FREE_LAWS
from lagrange.explain.words import capital, constraints_called, plural
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.held_coordinates import HeldTogether, held_together, held_values


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
    return block.map(lambda e: _held_line(rule, e))


def _held_line(rule: dict[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    if len(e.sides) < 2 or e.kind is EquationKind.POSITION:  # positions are shown as the file has them
        return e
    return replace(e, sides=tuple(_held_value(rule, s) for s in e.sides))


def _held_value(rule: dict[sp.Symbol, sp.Expr], side: Mathematics) -> Mathematics:
    if isinstance(side, Vector):
        return side.map(lambda c: c.xreplace(rule))
    return side.xreplace(rule)


# Held together


_BEFORE = (
    Rule.RESULT, Rule.STATEMENT, Rule.CONSTRAINT, Rule.PFAFFIAN_FORM, Rule.INTEGRABILITY, Rule.CLASSIFICATION,
    Rule.DEGREES_OF_FREEDOM, Rule.QUESTION, Rule.CHECKS,
)  # fmt: skip
"""The steps that stay in general, and those that have their own values."""


def with_values_put_in(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps of a page with the values substituted, and a sentence saying so at the end of the constraints."""
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
    """The forces, followed by the statements about contact."""
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
    if e.kind is EquationKind.ENERGY_RATE and isinstance(sides[0], sp.Expr):
        sides = (_without_constants_below(sides[0]), *sides[1:])
    return replace(e, sides=sides, condition=condition if any(map(_says_something, condition)) else ())


def _sides(rule: Mapping[sp.Symbol, sp.Expr], sides: Iterable[Mathematics]) -> tuple[Mathematics, ...]:
    left, *right = (_side(rule, s) for s in sides)
    if right and right[-1] == CONSTANT and isinstance(left, sp.Expr):
        left = _without_constants(left)
    return (left, *right)


def _without_constants(e: sp.Expr) -> sp.Expr:
    """A sum, constant or to be differentiated, without the terms that are themselves constant."""
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
