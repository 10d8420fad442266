"""Reactions that are too long as functions of position and velocity: by the accelerations, and in numbers."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.core.operations import count_operations
from lagrange.core.symbols import t
from lagrange.document.builders import display, listed, math, prose
from lagrange.document.derivation import Block, Detail, Equation, Part
from lagrange.document.roles import Phrase, Role
from lagrange.explain.limits import LONGEST_REACTIONS
from lagrange.explain.words import constraints_called, plural
from lagrange.mechanics.nearby.long_reactions import LongReactions
from lagrange.values.quantities import rounded_in

ZERO = sp.S.Zero


def explain_long_reactions(reactions: LongReactions) -> Iterator[Block]:
    """What is too long, where it is, what it is in terms of accelerations, and the numbers at one state."""
    names = [r.name for r in reactions.lost]
    words = plural(len(names), "The reaction of ", "The reactions of ") + constraints_called(names)
    words += plural(len(names), " is", " are") + " too long to be written as functions of position and velocity."
    values = [reactions.by_accelerations.get(name) for name in names]
    if all(e is not None and not any(s.name.endswith("''") for s in e.free_symbols) for e in values):
        yield prose("Newton's equations alone give")
        yield display(
            *(Equation((r.force, reactions.by_accelerations[r.name]), label=f"by-accelerations-{r.name}")
              for r in reactions.lost),
            boxed=True,
        )  # fmt: skip
    elif reactions.by_accelerations:
        detail = (
            Detail.FULL
            if sum(count_operations(e) for e in reactions.by_accelerations.values()) > LONGEST_REACTIONS
            else Detail.STEPS
        )
        if detail is Detail.FULL:
            yield prose(f"{words} In terms of the accelerations, Newton's equations give them in fewer: "
                        "--detail full shows these.")  # fmt: skip
            yield prose("They are", detail=detail)
        else:
            reason = Phrase(f"{words} ", Role.REASON)
            yield prose(reason, "In terms of the accelerations, Newton's equations give")
        yield display(
            *(
                Equation((r.force, reactions.by_accelerations[r.name]), label=f"by-accelerations-{r.name}")
                for r in reactions.lost
                if r.name in reactions.by_accelerations
            ),
            boxed=True,
            detail=detail,
        )
    else:
        yield prose(words)
    if reactions.at is not None:
        state: tuple[Part, ...] = ("At the start, ", math(t, ZERO), ", they are, in SI units,")
        if not reactions.from_initial:
            shown = [math(s, rounded_in(e)) for s, e in reactions.at.state.items()]
            state = ("In the position and with the velocities ", *listed(shown), " they are, in SI units,")
        yield prose(*state)
        yield display(
            *(
                Equation((r.force, rounded_in(reactions.numbers[r.name])))
                for r in reactions.lost
                if r.name in reactions.numbers
            )
        )
