"""The result at the head of the page: degrees of freedom, equations of motion or of equilibrium, reactions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.document.builders import display, prose
from lagrange.document.derivation import Block, Detail, Display, Equation, Part, Rule, Step
from lagrange.explain.page.meaning import Stated, operations
from lagrange.explain.words import in_words
from lagrange.mechanics.results import Solution

LONGEST = 120
"""The most operations of the equations in the result at the head."""
MOST = 6
"""The most equations there."""


def explain_result(solution: Solution, steps: list[Step], stated: Stated = ()) -> Iterator[Step]:
    """The boxed results of the steps together, at the head; nothing where there are none.

    steps   of the page, without those that are folded
    stated  the equations of motion in another form, known to be right, for where they are shorter so
    """
    rules = (Rule.EQUATIONS_OF_MOTION, Rule.SOLVED_REACTIONS, Rule.EQUILIBRIUM)
    kept: dict[Rule, Display] = {}
    for step in steps:
        if step.rule in rules:
            # The last is in the coordinates that are chosen, and shorter.
            boxed = [b for b in step.body if isinstance(b, Display) and b.boxed and b.detail < Detail.FULL]
            kept |= {step.rule: boxed[-1]} if boxed else {}
    kept = {rule: kept[rule] for rule in rules if rule in kept}
    written = [Equation(sides) for sides in stated]
    derived = kept.get(Rule.EQUATIONS_OF_MOTION)
    if derived is not None and written and operations(stated) < sum(map(_operations, derived.equations)):
        kept[Rule.EQUATIONS_OF_MOTION] = display(*written)
    while kept and not _is_short(kept.values()):
        kept.pop(Rule.SOLVED_REACTIONS if Rule.SOLVED_REACTIONS in kept else next(iter(kept)))
    if not kept:
        return
    lines = [replace(e, label=None) for b in kept.values() for e in b.equations]
    freedom = solution.classification.degrees_of_freedom
    words: list[Part] = [f"{in_words(freedom, 'degree').capitalize()} of freedom"]
    words.append(f"; {_called([*kept])}:")
    body: tuple[Block, ...] = (prose(*words), display(*lines, boxed=True, detail=Detail.BRIEF))
    yield Step(Rule.RESULT, "", body)


def _is_short(displays: Iterable[Display]) -> bool:
    lines = [e for b in displays for e in b.equations]
    return len(lines) <= MOST and sum(map(_operations, lines)) <= LONGEST


def _operations(equation: Equation) -> int:
    return sum(int(s.count_ops()) for s in equation.sides if isinstance(s, sp.Expr))


def _called(rules: list[Rule]) -> str:
    """What the box contains."""
    named = {
        Rule.EQUATIONS_OF_MOTION: "the motion",
        Rule.SOLVED_REACTIONS: "the reactions",
        Rule.EQUILIBRIUM: "the equilibrium",
    }
    return " and ".join(named[r] for r in rules)
