"""What a page leaves out that nothing on it uses: sections on freedom and displacements.

Without constraints the number of degrees of freedom is that of the coordinates, one sentence at the end of the
statement; the virtual displacements of the points stand where the principle uses them. Where forces are balanced, or
the Lagrangian is given outright, nobody uses them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from lagrange.document.derivation import Block, Prose, Rule, Step, paragraph
from lagrange.explain.displacements import of_points
from lagrange.mechanics.results import Solution

_USED_BY = (Rule.PRINCIPLE, Rule.EQUILIBRIUM, Rule.WORKLESS, Rule.EQUATIONS_OF_MOTION, Rule.IMPACT)
"""What virtual displacements are used by."""


def without_unused_sections(solution: Solution, steps: Sequence[Step]) -> Iterator[Step]:
    """The steps of the page, those on freedom and displacements joined to others, or left out."""
    own = solution.own
    free = not solution.classification.constraints
    balanced = any(v.at_rest is not None or v.impending is not None for v in solution.views)
    used = {s.rule for s in steps if not s.folded and s.rule in _USED_BY}
    idle = (balanced and not used) or (free and own.configuration.is_outright)
    joins = free and (own.dynamics is not None or own.equilibrium is not None)
    freedom = next((s for s in steps if free and s.rule is Rule.DEGREES_OF_FREEDOM and not s.folded), None)
    waiting: tuple[Block, ...] = ()
    for step in steps:
        if step is freedom:
            continue
        if step.rule is Rule.STATEMENT and freedom is not None:
            step = replace(step, body=(*step.body, *freedom.body))
        elif step.rule is Rule.DISPLACEMENTS and not step.choice and not step.folded:
            if idle:
                continue
            if joins and {Rule.PRINCIPLE, Rule.EQUILIBRIUM} & used:
                waiting = tuple(of_points(own.configuration, own.elimination, at_once=True))
                continue
        elif waiting and step.rule in (Rule.PRINCIPLE, Rule.EQUILIBRIUM):
            step, waiting = replace(step, body=_before(waiting, step.body)), ()
        yield step


def _before(displacements: tuple[Block, ...], body: tuple[Block, ...]) -> tuple[Block, ...]:
    """The displacements before the law that is multiplied by them."""
    first, *rest = body
    last = displacements[-1]
    if isinstance(first, Prose) and isinstance(last, Prose):
        return (*displacements[:-1], paragraph(last, first), *rest)
    return (*displacements, first, *rest)
