"""Reactions on a page in fewer lines: along turning axes, by accelerations, as the file states them, by unit vectors.

Several reactions on a single body as one vector, along unit vectors that turn with it, where that is much shorter.

The couple of the bearings on a disc that is fixed askew, in i and j, has cos φ and sin φ in every term. In the axes of
the disc it is ¼ m R² sin β cos β (φ'' e_1 + φ'² e_2), as in the books.

Constant forces in terms of the accelerations, F = m (g + a), where they are long in terms of parameters alone.

Two pulleys with inertia have tensions with a denominator of five products, and accelerations with the same one.
Newton's law gives each tension from the accelerations in a few letters, which is how a book writes it.

Reactions in the form of the file's answers, if these are right and shorter, or by quantities of its equations.

The forces of friction on a ball that rolls on a ball contain products of five angular velocities each; in terms of the
spin ω·out about the line of centres, in which the equations of motion are stated, they have two terms.

Unknowns and equations of bodies in a line: what the directions of the reactions are needed for.

The full derivation counts coordinates and components one by one. On a page whose laws are already written in terms of
the forces that remain, a sentence is enough: so many equations for so many unknowns, and how many unknowns there would
be if the directions were not known.

Vectors by the unit vectors that the file names in `let`, or of its frame: a force N n, not N sin θ i − N cos θ j.

The line that says what n is stays.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import DotProduct, UnitVector, VectorSymbol
from lagrange.core.vectors import Vector
from lagrange.document.derivation import (
    Block,
    Display,
    Equation,
    EquationKind,
    Math,
    Mathematics,
    Part,
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
from lagrange.explain.limits import LONGEST_IN_A_SENTENCE, SHORTER_AS_STATED, SHORTER_IN_ACCELERATIONS
from lagrange.explain.words import plural
from lagrange.mechanics.dynamics.newton import FreeBody, Newton, Reaction
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.mechanics.rewriting.constant_accelerations import constant_accelerations
from lagrange.mechanics.rewriting.projections import projections
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations, by_named_rates
from lagrange.mechanics.rewriting.vectors import (
    Directions,
    in_named_directions,
    sum_along_axes,
    turning_axes,
    unit_directions,
    where_constant,
)


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
            yield (
                called,
                Equation(
                    (VectorSymbol(f"{letter}_{body.name}"), total),
                    label=f"along-axes-{letter}",
                    kind=EquationKind.SUM_ALONG_AXES,
                ),
            )


def _shares(
    terms: Sequence[tuple[Reaction, Vector]], values: Mapping[object, object]
) -> Iterator[tuple[Vector, sp.Expr]]:
    for reaction, direction in terms:
        value = values.get(reaction.force)
        if isinstance(value, sp.Expr):
            yield direction, value


# By the accelerations


def in_accelerations(solution: Solution, step: Step, view: InCoordinates) -> Step:
    """The forces, in terms of the accelerations if these are constant and stated, and the forces much shorter so."""
    at = next((n for n, b in enumerate(step.body) if isinstance(b, Display) and b.boxed), None)
    law = solution.law
    if at is None or law is None or view.motion is None or law.all_frictions or view is not solution.chosen:
        return step
    box = step.body[at]
    assert isinstance(box, Display)
    lines = [e for e in box.equations if e.label]
    accelerations = constant_accelerations(view)
    if len(lines) == len(box.equations) or not accelerations:
        return step  # no denominator has a letter: they are short enough
    from lagrange.mechanics.rewriting.constant_accelerations import forces_in_turn

    forces = forces_in_turn(law, solution.own, view, accelerations)
    if forces is None or any(e.sides[0] not in forces for e in lines):
        return step
    labels = {e.sides[0]: e for e in lines}
    short = [replace(labels[name], sides=(name, value)) for name, value in forces.items() if name in labels]
    if SHORTER_IN_ACCELERATIONS * sum(e.operations for e in short) > box.operations:
        return step
    laws = "Newton's equations" if law.newton.bodies is not None else "the equations with multipliers"
    words = prose(f"In terms of the accelerations, {laws} give one after another")
    before = step.body[:at] if at == 0 or not isinstance(step.body[at - 1], Prose) else step.body[: at - 1]
    return replace(step, body=(*before, words, replace(box, equations=tuple(short)), *step.body[at + 1 :]))


def by_projection(step: Step, view: InCoordinates, newton: Newton) -> Step:
    """The forces as they follow from Newton's law along each of them, where that is short."""
    at = next((n for n, b in enumerate(step.body) if isinstance(b, Display) and b.boxed), None)
    if not at:
        return step
    lines, box = projections(newton, view), step.body[at]
    if not lines or not isinstance(box, Display) or not isinstance(step.body[at - 1], Prose):
        return step
    if {e.sides[0] for e in box.equations} != {p.force for p in lines}:
        return step
    if any(not r.named and r.tension is None for r in newton.reactions):
        return step  # λ is the name of no force
    along = plural(len(lines), "Newton's law along the direction of ", "Newton's law along the directions of ")
    accelerations = dict.fromkeys(a for p in lines for a in p.accelerated)
    follows: tuple[Part, ...] = ("so that",)
    if accelerations:
        bound = plural(len(view.configuration.rows), " and the constraint,", " and the constraints,")
        source = bound if view.configuration.rows else ","
        follows = ("so that, with ", *listed(map(math, accelerations)), f" from the equations of motion{source}")
    words = (along, *listed(math(p.force) for p in lines), " is")
    laws = [Equation((p.inertia, p.right)) for p in lines]
    if len(laws) == 1 and laws[0].operations <= LONGEST_IN_A_SENTENCE:
        [law] = lines
        said: list[Block] = [prose(*words, " ", math(law.inertia, law.right), ", ", *follows)]
    else:
        said = [prose(*words), display(*laws), prose(*follows)]
    return replace(step, body=(*step.body[: at - 1], *said, *step.body[at:]))


# As the file states them


def with_stated_forces(
    solution: Solution, steps: Sequence[Step], forces: StatedEquations, stated: StatedEquations
) -> list[Step]:
    """The steps with the reactions in these forms where they are shorter; folded parts stay unchanged.

    forces  as the answers have them
    stated  the equations of motion there
    """
    forms = {name: value for name, value in forces if isinstance(name, sp.Symbol)}
    named = any(side.has(DotProduct) for sides in stated for side in sides)

    def line(e: Equation) -> Equation:
        e = _as_stated(forms, e)
        value = e.sides[-1]
        if not named or len(e.sides) != 2 or not isinstance(value, sp.Expr) or value.has(DotProduct):
            return e
        return replace(e, sides=(e.sides[0], by_named_rates(solution, value, stated)))

    return [
        replace(s, body=tuple(_blocks(line, s.body))) if s.rule is Rule.SOLVED_REACTIONS and not s.folded else s
        for s in steps
    ]


def _blocks(line: Callable[[Equation], Equation], body: Sequence[Block]) -> Iterator[Block]:
    for block in body:
        if isinstance(block, Display) and block.boxed:
            yield block.map(line)
        else:
            yield block


def _as_stated(forms: Mapping[sp.Symbol, sp.Expr], e: Equation) -> Equation:
    form = forms.get(e.sides[0]) if isinstance(e.sides[0], sp.Symbol) else None
    if form is None or len(e.sides) > 2:  # a chain has its value in more than one set of coordinates
        return e
    short = replace(e, sides=(e.sides[0], form))
    return short if short.operations <= SHORTER_AS_STATED * e.operations else e


# Unknowns and equations


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
    return prose(f"With {bound} these are {after.equations} equations for {after.unknowns} unknowns.")


# By unit vectors of the file


def in_directions(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps with vectors along the unit vectors of the file written as their multiples."""
    units = unit_directions(solution.problem)
    for step in steps:
        yield replace(step, body=tuple(_block(b, units) for b in step.body)) if units else step


def _block(block: Block, units: Directions) -> Block:
    if isinstance(block, Prose):
        return replace(block, parts=tuple(_part(p, units) for p in block.parts))
    if isinstance(block, Display):
        return block.map(lambda e: _by_directions(e, units))
    return block


def _part(part: Part, units: Directions) -> Part:
    return replace(part, sides=tuple(_side(s, units) for s in part.sides)) if isinstance(part, Math) else part


def _by_directions(line: Equation, units: Directions) -> Equation:
    if isinstance(line.sides[0], VectorSymbol | UnitVector) and line.sides[0].name in units:
        return line
    return replace(line, sides=tuple(_side(s, units) for s in line.sides))


def _side(side: Mathematics, units: Directions) -> Mathematics:
    return in_named_directions(side, units) if isinstance(side, Vector) else side
