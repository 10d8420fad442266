"""Small motions and forced oscillations in fewer lines: a box for each frequency, resonances that are roots.

Small motions about an equilibrium or a steady motion, one box each: that of the frequency.

The linear equation is a step on the way to it, as a book prints it; a line states its solutions.

Forced oscillations of systems that are linear by themselves, and resonances that are roots of a quadratic.

About x = 0 the linear equations of a system with linear springs are its equations of motion: they are not printed
again. Squares of frequencies that would fill two lines each are given as the roots of the denominator.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import prime
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Math,
    Mathematics,
    Phrase,
    Prose,
    Purpose,
    Ref,
    Rule,
    Step,
    has_purpose,
    listed,
    math,
    parts_of,
    prose,
)
from lagrange.explain.limits import LONGEST_RESONANCE
from lagrange.explain.words import plural
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.readable_forms import are_same_equations

_RULES = (Rule.LINEARIZATION, Rule.STEADY)


def in_one_box(steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, those on small motions with a box only around the frequencies."""
    for step in steps:
        if step.rule in _RULES and not step.folded:
            step = replace(step, body=tuple(_with_alternatives([*_in_one_box(step.body)])))
        yield step


def _in_one_box(body: Sequence[Block]) -> Iterator[Block]:
    for n, block in enumerate(body):
        follows = body[n + 1 : n + 3]
        if _is_linear(block) and len(follows) == 2 and has_purpose(follows[0], Purpose.WAVES) and _is_box(follows[1]):
            assert isinstance(block, Display)
            yield replace(block, boxed=False)
        elif has_purpose(block, Purpose.WAVES):
            parts = (p.instead if isinstance(p, Phrase) else p for p in block.parts)
            yield prose(*parts, detail=block.detail)
        else:
            yield block


def _with_alternatives(body: Sequence[Block]) -> Iterator[Block]:
    """Steady motions in one box, with `or` between them, instead of one below the other."""
    waiting: Display | None = None
    for block in body:
        if waiting is not None and isinstance(block, Display) and _is_box(block):
            *lines, last = waiting.equations
            either = replace(last, condition=(*last.condition, ", or" if last.condition else "or"))
            waiting = replace(waiting, equations=(*lines, either, *block.equations))
            continue
        if waiting is not None:
            yield waiting
        waiting = block if isinstance(block, Display) and _is_box(block) else None
        if waiting is None:
            yield block
    if waiting is not None:
        yield waiting


def _is_linear(block: Block) -> bool:
    """Whether it has the linear equations about one place."""
    return isinstance(block, Display) and block.is_of(EquationKind.LINEAR)


def _is_box(block: Block) -> bool:
    return isinstance(block, Display) and block.boxed


# Response


def response_shortly(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps, that on forced oscillations shorter."""
    for step in steps:
        if step.rule is Rule.RESPONSE and not step.folded:
            body = _with_own_equations(solution, [*step.body], steps)
            step = replace(step, body=tuple(_with_roots(body)))
        yield step


def _with_own_equations(solution: Solution, body: list[Block], steps: Sequence[Step]) -> list[Block]:
    """No linear equations that are the equations of motion, with ξ for x where the equilibrium is x = 0."""
    view = solution.chosen
    if view.forced is None or view.motion is None:
        return body
    linear, branch = view.forced.linearization, view.forced.branch
    coordinates = linear.configuration.slots.coordinates
    at_zero = {r.lhs: r.rhs for r in branch.equations} == dict.fromkeys(coordinates, sp.S.Zero)
    moved = dict(zip(linear.displacements, coordinates, strict=True))
    at = next((n for n, b in enumerate(body) if isinstance(b, Display) and b.is_of(EquationKind.FORCED)), None)
    if at is None or not at_zero or len(linear.branches) != 1 or not _are_those(solution, body[at], moved):
        return body
    labels = [e.label for s in steps if s.rule is Rule.EQUATIONS_OF_MOTION for e in _boxed(s) if e.label]
    small = listed(math(x, q) for x, q in moved.items())
    rest = next(e.label for b in body[:at] if isinstance(b, Display) for e in b.equations if e.label)
    after = [_moved(b, moved) for b in body[at + 1 :]]
    if labels and not any(isinstance(p, Ref) and p.label == rest for b in after for p in parts_of(b)):
        which = plural(len(labels), "The equation of motion ", "The equations of motion ")
        verb = plural(len(labels), " is linear", " are linear")
        words = prose(which, *listed(map(Ref, labels)), f"{verb}, and without the drive the system can rest at ",
                      *listed(math(q, sp.S.Zero) for q in coordinates), ".")  # fmt: skip
        return [words, *after]
    words = prose("The equations of motion ", *listed(map(Ref, labels)), " are linear, and about ", Ref(rest),
                  " they are those of the small changes ", *small, ".")  # fmt: skip
    return [*body[: at - 1], words, *body[at + 1 :]] if labels else body


def _moved(block: Block, moved: Mapping[sp.Symbol, sp.Symbol]) -> Block:
    """A block with the coordinates in place of their small changes from zero."""

    def side(e: Mathematics) -> Mathematics:
        return e.xreplace(dict(moved)) if isinstance(e, sp.Basic) else e

    if isinstance(block, Display):
        return block.map(lambda e: replace(e, sides=tuple(map(side, e.sides))))
    if isinstance(block, Prose):
        parts = (replace(p, sides=tuple(map(side, p.sides))) if isinstance(p, Math) else p for p in block.parts)
        return replace(block, parts=tuple(parts))
    return block


def _are_those(solution: Solution, block: Block, moved: dict[sp.Symbol, sp.Symbol]) -> bool:
    """Whether the linear equations are the equations of motion."""
    motion = solution.chosen.motion
    assert motion is not None
    assert isinstance(block, Display)
    rule = {prime(x, n): prime(q, n) for x, q in moved.items() for n in range(3)} | moved
    linear = [tuple(s.xreplace(rule) for s in e.sides if isinstance(s, sp.Expr)) for e in block.equations]
    return len(linear) == len(motion.final) and are_same_equations(linear, motion.expressions)


def _boxed(step: Step) -> Iterator[Equation]:
    yield from (e for b in step.body if isinstance(b, Display) and b.boxed for e in b.equations)


def _with_roots(body: list[Block]) -> list[Block]:
    """`The denominator Δ vanishes at ..., at the roots of Δ = 0` instead of long roots."""
    at = next((n for n, b in enumerate(body) if isinstance(b, Display) and b.is_of(EquationKind.RESONANCE)), None)
    letter = next((e.sides[0] for b in body[:at] if isinstance(b, Display) and b.boxed
                   for e in b.equations if e.label is None and isinstance(e.sides[0], sp.Symbol)), None)  # fmt: skip
    before = body[at - 1] if at else None
    if at is None or letter is None or not has_purpose(before, Purpose.RESONANCE):
        return body
    shown = body[at]
    assert isinstance(shown, Display)
    if max(e.operations for e in shown.equations) <= LONGEST_RESONANCE:
        return body
    frequencies = (p for p in before.parts if isinstance(p, Phrase))
    roots = prose("The roots of ", math(letter, sp.S.Zero), " are the ", *(p.instead or p for p in frequencies))
    return [*body[: at - 1], roots, *body[at + 1 :]]
