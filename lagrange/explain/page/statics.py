"""Statics on the page: equilibrium, its reactions and its stability once, in the coordinates that are chosen.

The principle of virtual work is stated in the file's coordinates. What follows from it there would follow a second time
in the first choice, so it is left to that, unless equilibria might be lost.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from lagrange.document.builders import display, prose
from lagrange.document.derivation import Block, Display, Rule, Step
from lagrange.explain.displacements import solved_displacements
from lagrange.explain.reactions import explain_reactions_at_rest
from lagrange.mechanics.results import InCoordinates, Solution


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
        if lines and n and all((e.label or "").startswith("delta-at-rest") for e in lines):
            one = len(lines) == 1
            where = "the point where a force acts is" if one else "the points where forces act are"
            body[n - 1 : n + 1] = [prose(f"The virtual displacement{'' if one else 's'} of {where}"), display(*lines)]
    return iter(body)


def _reactions(solution: Solution, first: InCoordinates) -> Step | None:
    """The reactions at rest, from the equations in the file's coordinates."""
    if first.reactions_at_rest is None or solution.law is None:
        return None
    return explain_reactions_at_rest(first.reactions_at_rest, solution.law.newton, solution.own.reactions_at_rest)
