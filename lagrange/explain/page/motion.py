"""The equations of motion as a page derives them: kinematics in one display, coordinates and equations in one step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.symbols import Slots, variation
from lagrange.core.vectors import FIXED, Vector
from lagrange.document.builders import display, has_purpose, index_of, listed, math, paired, prose
from lagrange.document.derivation import Block, Display, Equation, Part, Ref, Rule, Step
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.displacements import of_points, pivot_conditions, solved_displacements
from lagrange.explain.limits import LONGEST_DISPLACEMENT, LONGEST_SUM
from lagrange.explain.motion import accelerations_of
from lagrange.explain.page.system import are_short
from lagrange.explain.words import plural, suffix_of, title_in
from lagrange.mechanics.constraints.displacements import Elimination, virtual_displacement
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import DalembertMotion, EquationsOfMotion, excluding
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.readable_equality import has_plain_accelerations


def displacements_shortly(step: Step) -> Step:
    """The displacements without those of points that are merely δx i + δy j."""
    body = list(step.body)
    for n, block in enumerate(body):
        if n and isinstance(block, Display) and all(_is_plain(e) for e in block.equations):
            body[n - 1 : n + 1] = []
            break
    return replace(step, body=tuple(body)) if body else step


def without_lecture(step: Step) -> Step:
    """Lagrange's equations with no more than the first sentence of why T is not reduced before it is differentiated."""
    return replace(step, body=tuple(map(_without_reasons, step.body)))


def _without_reasons(block: Block) -> Block:
    if not has_purpose(block, Purpose.NOT_SUBSTITUTED):
        return block
    end = index_of(Purpose.REASON, block.parts)
    return block if end is None else prose(*block.parts[: end + 1])


def displacements_of_geometric(configuration: Configuration, elimination: Elimination) -> Step:
    """Where constraints are free of time, virtual displacements satisfy them as possible ones do."""
    slots, rows = configuration.slots, configuration.rows
    lines = (Equation((virtual_displacement(r, slots), sp.S.Zero), label=f"virtual-{r.name}") for r in rows)
    body = (
        prose("Time does not appear in ", *listed(Ref(f"form-{r.name}") for r in rows),
              f": virtual displacements satisfy {plural(len(rows), 'it', 'them')} too,", purpose=Purpose.TIMELESS),
        display(*lines),
        *solved_displacements(elimination, configuration),
        *of_points(configuration, elimination),
    )  # fmt: skip
    return Step(Rule.DISPLACEMENTS, "Virtual displacements", body)


def _is_plain(equation: Equation) -> bool:
    value = equation.sides[-1]
    named = (equation.label or "").startswith("delta")
    return named and isinstance(value, Vector) and all(c == 0 or c.is_Function for c in value.components)


def with_kinematics(step: Step, motion: DalembertMotion) -> Step:
    """Newton's law after the accelerations that occur in it, unless they are linear in ẍ, ÿ, ..."""
    kinematics = accelerations_of(motion)
    lines = [e for b in kinematics if isinstance(b, Display) for e in b.equations]
    if not lines or all(_is_linear(e, motion.configuration.slots) for e in lines):
        return step
    return replace(step, body=(*kinematics, *step.body))


def principle_shortly(step: Step, coordinates: frozenset[object], *, known: bool) -> Step:
    """The principle without accelerations that are merely ẍ i + ÿ j, or `known` from Newton's law."""
    body = list(step.body)
    for n, block in enumerate(body):
        if not n or not isinstance(block, Display):
            continue
        kinematic = all((e.label or "").startswith(("acceleration", "momentum-rate")) for e in block.equations)
        if (known and kinematic) or all(_is_evident(e, coordinates) for e in block.equations):
            body[n - 1 : n + 1] = []
            at = next(k for k, b in enumerate(body) if has_purpose(b, Purpose.WRITTEN_OUT))
            before, after = body[at - 1], body[at + 1]
            if isinstance(before, Display) and isinstance(after, Display):
                body[at - 1 : at + 2] = [display(*before.equations, *after.equations)]
            break
    return replace(step, body=tuple(body))


def _is_evident(equation: Equation, accelerations: frozenset[object]) -> bool:
    value = equation.sides[-1]
    named = (equation.label or "").startswith("acceleration")
    return named and isinstance(value, Vector) and all(c == 0 or c in accelerations for c in value.components)


def _is_linear(equation: Equation, slots: Slots) -> bool:
    """Whether an acceleration has accelerations of coordinates with constant coefficients as components."""
    value = equation.sides[-1]
    if not isinstance(value, Vector) or value.triad != FIXED:
        return False
    return has_plain_accelerations(value, slots)


def with_displacements(step: Step, motion: DalembertMotion) -> Step:
    """The equations in the file's coordinates, after the dependent displacements, where no step before has them."""
    rows, slots = motion.configuration.rows, motion.configuration.slots
    solved = motion.elimination.solved(slots)
    if not rows or not solved:
        return step
    if any(count_operations(value) > LONGEST_DISPLACEMENT for value in solved.values()):
        return replace(step, body=(*solved_displacements(motion.elimination, motion.configuration), *step.body))
    pivots = pivot_conditions(motion.elimination)
    where: tuple[Part, ...] = (Phrase(" where ", Purpose.WHERE), *pivots) if pivots else ()
    by = ("By ", *listed(Ref(f"virtual-{r.name}") for r in rows))
    follows = step.body[1] if len(step.body) > 1 else None
    is_whole = isinstance(follows, Display) and (follows.equations[0].label or "").startswith("reduced")
    after: tuple[Part, ...] = ("and ", Ref("written-out"), " becomes") if is_whole else ("remain.",)
    if len(solved) == 1 and is_whole:
        [(d, e)] = solved.items()
        return replace(step, body=(prose(*by, ", ", math(d, e), *where, ", ", *after), *step.body[1:]))
    lines = display(*(Equation((d, e)) for d, e in solved.items()))
    rest = (prose(*after), *step.body[1:]) if is_whole else step.body
    return replace(step, body=(prose(*by, *(",", *where, ",") if where else ","), lines, *rest))


def without_long_sum(step: Step, motion: DalembertMotion) -> Step:
    """The equations without a long sum over all displacements before them, whose brackets they are."""
    body = list(step.body)
    for n, block in enumerate(body):
        if not isinstance(block, Display) or not (block.equations[0].label or "").startswith("reduced"):
            continue
        if count_operations(motion.reduced) > LONGEST_SUM:
            coordinates = motion.configuration.slots.coordinates
            solved = listed(math(variation(coordinates[d])) for d in motion.elimination.dependent)
            suffix = suffix_of(motion.configuration.name)
            body[n - 1 : n + 1] = [prose("Substitute for ", *solved, " in ", Ref(f"written-out{suffix}"), ".")]
        break
    return replace(step, body=tuple(body))


def with_conditions(step: Step, motion: EquationsOfMotion) -> Step:
    """The boxed equations with what must not vanish for them to determine the motion."""
    excluded = excluding(motion)
    if not excluded:
        return step
    return replace(step, body=tuple(_conditional(b, excluded, motion) for b in step.body))


def _conditional(block: Block, excluded: Sequence[sp.Expr], motion: EquationsOfMotion) -> Block:
    """A boxed display of equations of motion, each condition at its equation; after the last those of several."""
    if not isinstance(block, Display) or not block.boxed:
        return block
    places = [n for n, e in enumerate(block.equations) if (e.label or "").startswith("motion")]
    if not places:
        return block
    at: dict[int, list[sp.Expr]] = {}
    for e in excluded:
        owners = [] if e in motion.elimination.pivots or len(places) != len(motion.final) else [
            n for n, equation in zip(places, motion.final, strict=True) if e in equation.factor.nonzero]  # fmt: skip
        at.setdefault(owners[0] if len(owners) == 1 else places[-1], []).append(e)
    equations = list(block.equations)
    for n, those in at.items():
        where = (Phrase("where ", Purpose.WHERE), *listed(math(e, sp.S.Zero, relation="≠") for e in those))
        equations[n] = replace(equations[n], condition=where)
    return replace(block, equations=tuple(equations))


def in_one_step(coordinates: Step, equations: Step) -> tuple[Step, Step]:
    """Generalized coordinates and the equations in them under one title."""
    choice = title_in("", coordinates.choice)
    first, second = (step.title.removesuffix(choice) for step in (coordinates, equations))
    title = f"{first} and {second[:1].lower()}{second[1:]}{choice}"
    body = tuple(
        replace(b, equations=paired(b.equations)) if isinstance(b, Display) and are_short(b.equations) else b
        for b in coordinates.body
    )
    return replace(coordinates, title=title, body=body), replace(
        equations, title="", body=tuple(_merged(equations.body))
    )


_KINEMATICS = ("acceleration", "delta")


def _merged(body: Sequence[Block]) -> list[Block]:
    """The accelerations and virtual displacements of points in one display."""
    places = [n for n, b in enumerate(body) if isinstance(b, Display) and _is_kinematic(b)]
    if len(places) != 2 or places[1] != places[0] + 2:
        return [*body]
    first, second = (body[n] for n in places)
    assert isinstance(first, Display)
    assert isinstance(second, Display)
    lines = (*first.equations, *second.equations)
    whose = plural(len(first.equations), "The acceleration and the virtual displacement are", "The accelerations and "
                   "the virtual displacements are")  # fmt: skip
    return [*body[: places[0] - 1], prose(whose), display(*lines), *body[places[1] + 1 :]]


def _is_kinematic(block: Display) -> bool:
    return all((e.label or "").startswith(_KINEMATICS) for e in block.equations)


def without_multipliers(step: Step) -> Step:
    """The equations without those with multipliers, where Newton's law has given the same."""
    body = list(step.body)
    at = next((n for n, b in enumerate(body) if has_purpose(b, Purpose.MULTIPLIERS)), None)
    return step if at is None else replace(step, body=tuple(body[:at] + body[at + 2 :]))


def without_detour(solution: Solution, steps: Sequence[Step], is_detour: Callable[[Step], bool]) -> list[Step]:
    """The steps in the file's coordinates without what only the equations of motion there would need.

    These are folded, and take the principle written out with them; the dependent displacements are not needed.
    """
    own = solution.own
    if own.dynamics is None or not any(is_detour(step) for step in steps):
        return [*steps]
    unused: list[Block] = []
    if own.configuration.rows:
        unused = [*solved_displacements(own.elimination, own.configuration),
                  *of_points(own.configuration, own.elimination)]  # fmt: skip
    moved: list[Block] = []
    kept: list[Step] = []
    for step in steps:
        if step.choice:
            kept.append(step)
        elif step.rule is Rule.DISPLACEMENTS:
            body = tuple(b for b in step.body if b not in unused)
            kept += [replace(step, body=body)] if body else []
        elif step.rule is Rule.PRINCIPLE:
            body, moved = _without_coordinates(step.body)
            kept.append(replace(step, body=body))
        elif is_detour(step):
            kept.append(replace(step, body=(*moved, *step.body)))
            moved = []
        else:
            kept.append(step)
    return kept


def _without_coordinates(body: Sequence[Block]) -> tuple[tuple[Block, ...], list[Block]]:
    """The principle in vectors, and the rest of its step."""
    at = next((n for n, b in enumerate(body) if isinstance(b, Display)), None)
    if at is None:
        return tuple(body), []
    shown = body[at]
    assert isinstance(shown, Display)
    vectors = tuple(e for e in shown.equations if e.label == "principle")
    others = tuple(e for e in shown.equations if e.label != "principle")
    if not vectors:
        return tuple(body), []
    rest: list[Block] = [prose("Written out, the principle reads"), replace(shown, equations=others)] if others else []
    return (*body[:at], replace(shown, equations=vectors)), [*rest, *body[at + 1 :]]
