"""Statics on the page: equilibrium, its reactions and its stability once, in the coordinates that are chosen.

The principle of virtual work is stated in the file's coordinates. What follows from it would be repeated in the first
choice, so it is given there only, unless equilibria might be lost.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.symbols import DotProduct, VectorSymbol, free_letter
from lagrange.document.derivation import (
    Block,
    Detail,
    Display,
    Equation,
    EquationKind,
    Part,
    Purpose,
    Ref,
    Rule,
    Step,
    display,
    listed,
    math,
    prose,
)
from lagrange.explain.displacements import solved_displacements
from lagrange.explain.illustrations import of_supported_rod
from lagrange.explain.reactions import explain_reactions_at_rest
from lagrange.explain.words import joined, plural, suffix_of
from lagrange.mechanics.results import InCoordinates, Solution

if TYPE_CHECKING:
    from lagrange.mechanics.supports import Supports

ZERO = sp.S.Zero


def said_once(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps, without those on statics in the file's coordinates where the first choice has them all."""
    first = _deciding(solution)
    if first is None:
        yield from steps
        return
    for step in steps:
        if step.rule is Rule.EQUILIBRIUM and not step.choice:
            yield replace(step, body=tuple(_principle(step)))
        elif step.rule is Rule.EQUILIBRIUM and step.choice == first.name:
            yield replace(step, body=tuple(_of_loads(first, step)))
        elif step.rule is Rule.SOLVED_REACTIONS and not step.choice:
            continue
        elif step.rule is Rule.DISPLACEMENTS and not step.choice:
            unused = solved_displacements(solution.own.elimination, solution.own.configuration)
            yield replace(step, body=tuple(b for b in step.body if b not in unused))
        elif step.rule is Rule.SOLVED_REACTIONS and step.choice == first.name and says_nothing(solution):
            continue
        elif step.rule is Rule.SOLVED_REACTIONS and step.choice == first.name:
            yield replace(_reactions(solution, first) or step, choice=first.name)
        else:
            yield step


def says_nothing(solution: Solution) -> bool:
    """Whether all reactions are multipliers that are no single forces, and have no name in the file."""
    reactions = solution.law.newton.reactions if solution.law is not None else ()
    return bool(reactions) and all(r.single is None and r.given is None for r in reactions)


def _deciding(solution: Solution) -> InCoordinates | None:
    """The first choice, if it has every equilibrium, with reactions wherever the file's coordinates have them."""
    own = solution.own
    if own.equilibrium is None or own.dynamics is not None or not solution.choices:
        return None
    first = solution.choices[0]
    chosen = first.equilibrium
    if chosen is None or first.coordinates.radicands or len(chosen.branches) < len(own.equilibrium.branches):
        return None
    complete = own.reactions_at_rest is None or first.reactions_at_rest is not None
    return first if complete else None


def _principle(step: Step) -> Iterator[Block]:
    """The principle, and the virtual work written out."""
    for block in step.body:
        yield block
        if isinstance(block, Display) and any(e.label == "work-written-out" for e in block.equations):
            return


def _of_loads(first: InCoordinates, step: Step) -> Iterator[Block]:
    """The blocks, with the virtual displacements of those points only at which forces act."""
    configuration = first.configuration
    loaded = {f.on for f in configuration.loads if not f.elsewhere}
    idle = {f"delta-at-rest-{first.name}-{p.name}" for p in configuration.points if p.name not in loaded}
    body = list(step.body)
    for n, block in enumerate(body):
        if not isinstance(block, Display) or not idle & {e.label for e in block.equations}:
            continue
        lines = tuple(e for e in block.equations if e.label not in idle)
        if lines and n and all(e.kind is EquationKind.DELTA for e in lines):
            one = len(lines) == 1
            where = "the point where a force acts is" if one else "the points where forces act are"
            body[n - 1 : n + 1] = [prose(f"The virtual displacement{'' if one else 's'} of {where}"), display(*lines)]
    return iter(body)


def _reactions(solution: Solution, first: InCoordinates) -> Step | None:
    """The reactions at rest, from the equations in the file's coordinates."""
    if first.reactions_at_rest is None or solution.law is None:
        return None
    return explain_reactions_at_rest(first.reactions_at_rest, solution.law.newton, solution.own.reactions_at_rest)


# -- two smooth supports of a rod --------------------------------------------------------------------------------------


def with_supports(solution: Solution, steps: Iterable[Step]) -> Iterator[Step]:
    """The steps, with the forces of two supports of a rod where the coordinates leave them out."""
    forces = None
    if solution.chosen.equilibrium is not None:
        from lagrange.mechanics.supports import supports

        forces = supports(solution)
    if forces is None:
        yield from steps
        return
    names = {*solution.problem.scope.names(), *(q.name for c in solution.problem.choices for q in c.coordinates)}
    letter = free_letter("N", "R", "Q", taken=names, of=[s.point for s in forces.at])
    sizes = {s.point: sp.Symbol(f"{letter}_{s.point}", real=True) for s in forces.at}
    choice = solution.choices[0].name if solution.choices else ""
    for step in steps:
        if step.rule is Rule.REACTIONS or step.rule is Rule.SOLVED_REACTIONS:
            continue
        if step.rule is Rule.WORKLESS:
            step = replace(step, body=(*_forces(forces, sizes), of_supported_rod(solution, forces, sizes)))
        yield step
        if step.rule is Rule.EQUILIBRIUM and step.choice == choice:
            yield Step(Rule.SOLVED_REACTIONS, "The reactions", tuple(_sizes(solution, forces, sizes)), choice=choice)


def _forces(supports: Supports, sizes: dict[str, sp.Symbol]) -> Iterator[Block]:
    """R n of each support, and that neither works."""
    points = [s.point for s in supports.at]
    names, others, apart = (
        joined(points),
        joined(supports.rigid),
        plural(len(supports.rigid) - 1, "distance", "distances"),
    )
    yield prose(
        f"The supports at {names} are smooth: they exert normal forces of magnitude ",
        *listed(math(size) for size in sizes.values()), ",",
    )  # fmt: skip
    yield display(
        *(Equation((VectorSymbol(f"R_{s.point}"), s.normal * sizes[s.point]), label=f"support-{s.point}")
          for s in supports.at)
    )  # fmt: skip
    moved = (Ref(f"delta-{p}") for p in points)
    yield prose(
        f"{names} move along the supports, by ", *listed(moved), ". So the reactions do no work in a virtual "
        f"displacement; nor do the forces within the rod, since {others} keep their {apart}:",
    )  # fmt: skip
    works = (DotProduct(VectorSymbol(f"R_{p}"), VectorSymbol(f"delta(r_{p})")) for p in points)
    yield display(*(Equation((w, ZERO), label=f"support-work-{p}") for w, p in zip(works, points, strict=True)))


def _sizes(solution: Solution, supports: Supports, sizes: dict[str, sp.Symbol]) -> Iterator[Block]:
    """The sizes from the balance of forces, and up to where the rod is on both supports."""
    loads = dict.fromkeys(f.on for f in solution.own.configuration.loads)
    terms = [VectorSymbol(f"R_{s.point}") for s in supports.at] + [VectorSymbol(f"F_{name}") for name in loads]
    yield prose("The forces on the rod as a whole balance:")
    yield display(Equation((sp.Add(*terms, evaluate=False), ZERO), label="support-balance"))
    gives: tuple[Part, ...] = (" this gives", " (and the moments then balance as well, in the position found)")
    yield prose("With ", *listed(Ref(f"support-{s.point}") for s in supports.at), *gives)
    first, *others = supports.at
    if all(s.size == first.size for s in others):
        names = [sizes[s.point] for s in supports.at]
        yield display(Equation((*names, first.size), label=f"support-size-{first.point}"), boxed=True,
                      detail=Detail.BRIEF)  # fmt: skip
        yield from _independent(solution, names, first.size)
    else:
        lines = (Equation((sizes[s.point], s.size), label=f"support-size-{s.point}") for s in supports.at)
        yield display(*lines, boxed=True, detail=Detail.BRIEF)
    yield from _ends(solution, supports)


def _independent(solution: Solution, names: list[sp.Symbol], size: sp.Expr) -> Iterator[Block]:
    """`N_A and N_B do not depend on k`, on which the position does."""
    rest = solution.chosen.equilibrium
    numbers = {p.symbol for p in solution.problem.parameters if p.range is not None}
    inside = {s for b in rest.branches for r in b.relations for s in r.rhs.free_symbols} if rest is not None else set()
    missing = sorted(inside & numbers - size.free_symbols, key=str)
    if missing:
        yield prose(*listed(map(math, names)), " do not depend on ", *listed(map(math, missing)), ".")


def _ends(solution: Solution, supports: Supports) -> Iterator[Block]:
    """`A and B are on the supports, z_A ≥ 0 and z_B ≥ 0, where −α ≤ θ ≤ α`, where the supports end in one point."""
    own = solution.own.configuration
    where = {p.name: p.position.fixed().components for p in own.points}
    corner = [tuple(x.xreplace({s.coordinate: ZERO}) for x in where[s.point]) for s in supports.at]
    if corner[0] != corner[1] or not solution.choices:
        return
    chosen = solution.choices[0]
    if len(chosen.configuration.slots.coordinates) != 1:
        return
    [q] = chosen.configuration.slots.coordinates
    from lagrange.mechanics.supports import angle_bound, angle_condition

    limits = [angle_bound(s, q, solution) for s in supports.at]
    low = [e for e, upper in filter(None, limits) if not upper]
    high = [e for e, upper in filter(None, limits) if upper]
    if len(low) != 1 or len(high) != 1:
        return
    inside = listed(math(s.coordinate, ZERO, relation="≥") for s in supports.at)
    words: tuple[Part, ...] = ("Both ends are on the supports, ", *inside, ", as long as ")
    yield prose(*words, math(low[0], q, high[0], relation="≤"), ".", detail=Detail.BRIEF)
    bounds = angle_condition(chosen, q, low[0], high[0])
    if bounds is not None:
        suffix = suffix_of(chosen.name)
        place = (Ref(f"equilibrium{suffix}-1"), ", such a position exists if ")
        low, middle, high = bounds
        within = (sp.Abs(middle), high) if low == -high else bounds
        yield prose("By ", *place, math(*within, relation="≤"), ".", detail=Detail.BRIEF, purpose=Purpose.EXISTS)
