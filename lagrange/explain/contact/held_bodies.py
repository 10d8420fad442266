"""The forces that keep bodies where the coordinates can place them: a table under a ball, a floor under a wedge."""

from __future__ import annotations

from collections.abc import Iterator

from lagrange.core.operations import count_operations
from lagrange.document.builders import display, math, prose
from lagrange.document.derivation import Block, Equation, Part
from lagrange.explain.limits import LONGEST_IN_TEXT, LONGEST_REACTION
from lagrange.explain.words import the
from lagrange.mechanics.dynamics.contact.held_bodies import HeldBody, held_bodies
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.rewriting.factors import has_one_sign, with_common_factor


def explain_held_bodies(newton: Newton, at_rest: bool = False) -> Iterator[Block]:
    """What else acts on the bodies, along which line, and why it is in no equation."""
    bodies = [*held_bodies(newton, at_rest)]
    last = max((n for n, held in enumerate(bodies) if _may_change_sign(held)), default=None)
    for n, held in enumerate(bodies):
        yield from _held(held, says_contact=n == last)


def _may_change_sign(held: HeldBody) -> bool:
    shown = held.along is not None and held.value is not None and count_operations(held.value) <= LONGEST_REACTION
    return shown and not has_one_sign(with_common_factor(held.value))


def _held(held: HeldBody, says_contact: bool) -> Iterator[Block]:
    body, value = the(held.body), held.value
    if held.along is None:
        yield prose(f"The forces that keep {body} on its path are normal to it: they do no virtual work and are not "
                    "shown.")  # fmt: skip
        return
    begin: tuple[Part, ...] = (
        f"The coordinates allow no motion of {body} along ",
        math(held.along),
        ". The force that ",
    )
    if value is None or count_operations(value) > LONGEST_REACTION:
        yield prose(*begin, "prevents it does no virtual work and is not shown.")
        return
    value = with_common_factor(value)
    idle = "; it does no virtual work and is in none of the equations above."
    contact = " If it is that of a surface, contact lasts as long as the surface pushes."
    pushes = (contact,) if says_contact else ()
    if count_operations(value) <= LONGEST_IN_TEXT:
        yield prose(*begin, "prevents it is ", math(value), " in this direction", idle, *pushes)
        return
    yield prose(*begin, "prevents it is, in this direction,")
    yield display(Equation((value,)))
    yield prose("It does no virtual work and is in none of the equations above.", *pushes)
