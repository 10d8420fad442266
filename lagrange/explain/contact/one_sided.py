"""One-sided constraints: what they are, and how long they act.

The forces that keep bodies where the coordinates can place them: a table under a ball, a floor under a wedge.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.core.expression_size import count_operations
from lagrange.document.derivation import (
    Block,
    Detail,
    Emphasis,
    Equation,
    Part,
    Phrase,
    Prose,
    Purpose,
    Ref,
    display,
    listed,
    math,
    prose,
    series,
)
from lagrange.explain.limits import LONGEST_IN_TEXT, LONGEST_REACTION
from lagrange.explain.words import NORMAL_FORCES, are, capital, constraints_called, plural, sign_conditions, the
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.dynamics.contact.touching import HeldBody, held_bodies
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.rewriting.factors import with_common_factor

if TYPE_CHECKING:
    from lagrange.algebra.closed_forms.signs import SignCondition


def explain_in_contact(constraints: Sequence[ConstraintAnalysis]) -> list[Prose]:
    """That the equation of a one-sided constraint holds in contact, which is what is treated."""
    one_sided = [c for c in constraints if c.constraint.side is not None]
    if not one_sided:
        return []
    refs = listed(Ref(f"constraint-{c.row.name}") for c in one_sided)
    words = plural(len(one_sided), " is ", " are ")
    equality = plural(
        len(one_sided), "the two sides are equal, and the equation", "both sides of each are equal, and the equations"
    )
    then = plural(len(one_sided), "is", "are")
    return [
        prose(*refs, words, Emphasis("one-sided"), f". As long as there is contact, {equality} {then} used below.")
    ]  # fmt: skip


def explain_one_sided(constraints: Sequence[ConstraintAnalysis]) -> list[Prose]:
    """That an inequality is no holonomic constraint in the strict sense."""
    names = [c.row.name for c in constraints if c.constraint.side is not None]
    if not names:
        return []
    called = capital(constraints_called(names))
    words = plural(
        len(names),
        " is an inequality, which, strictly speaking, is not a holonomic constraint; it acts as one while contact "
        "lasts.",
        " are inequalities, which, strictly speaking, are not holonomic constraints; they act as such while contact "
        "lasts.",
    )
    return [prose(called + words)]


def explain_contacts(
    reactions: Reactions,
    newton: Newton,
    place: tuple[Part, ...] = (),
    conditions: Mapping[str, SignCondition] | None = None,
) -> list[Block]:
    """As long as what contact lasts: the forces that must not become negative.

    place       where the reactions are written, `at (12)`; empty if there is only one place
    conditions  at rest, by name of the constraint, what a force that is not negative means: sin θ ≥ 0
    """
    blocks: list[Block] = []
    trivial: list[Reaction] = []
    for r in newton.reactions:
        value = reactions.contacts.get(r.name)
        if value is None or value == 0:
            continue
        sign = reactions.sign_of_contact(r.name)
        if sign == 1 or (sign is None and conditions is not None and r.name not in conditions):
            trivial.append(r)
            continue
        is_normal = not NORMAL_FORCES.isdisjoint(map(str, (r.force, r.symbol)))
        is_cord = r.tension is not None and not is_normal
        # ρ ≤ l of a particle is that of a string, or of a circle round it: only names and `by` tell.
        is_either = not is_cord and not is_normal and r.constraint.by is None and r.constraint.side == -1
        called = constraints_called([r.name])
        verb = "pull" if is_cord else "act to the permitted side" if is_either else "push"
        start = capital(called) if not place else called
        first: tuple[Part, ...] = (*place, ", " if place else "")
        if sign == -1:
            opposite = "pushing" if is_cord else "acting to the other side" if is_either else "pulling"
            words = f"{start} could hold contact only by {opposite}, which it cannot: there is no contact."
            blocks.append(prose(*first, words))
            continue
        state = "stays taut" if is_cord else "acts" if is_either else "stays in contact"
        words = f"{start} can only {verb}: it {state} as long as "
        if conditions and r.name in conditions:
            meant = sign_conditions([conditions[r.name]])
            force = math(_force(r), sp.S.Zero, relation="≥")
            blocks.append(prose(*first, words, force, ", that is, ", *meant, ".", purpose=Purpose.CONTACT))
            continue
        blocks.append(
            prose(
                *(*first, words, math(_force(r), sp.S.Zero, relation="≥"), Phrase(", that is,", Purpose.THAT_IS)),
                purpose=Purpose.CONTACT,
            )
        )
        blocks.append(display(Equation((value, sp.S.Zero), relation="≥", condition=_presumed(r)), detail=Detail.STEPS))
    if trivial:
        names = constraints_called(r.name for r in trivial)
        forces = listed(math(_force(r)) for r in trivial)
        words = f"Contact with {names} lasts, because "
        blocks.append(prose(words, *forces, f"{are(trivial)} positive."))
    return blocks


def _force(r: Reaction) -> sp.Expr:
    """What must not be negative, as it is called."""
    if r.symbol is not None:
        return r.symbol
    assert r.constraint.side is not None
    return sp.Integer(r.constraint.side) * r.force


def _presumed(r: Reaction) -> tuple[Part, ...]:
    if r.single is None or not r.single.presumed:
        return ()
    return ("for ", *series((math(e, sp.S.Zero, relation=">"),) for e in r.single.presumed))


# Held bodies


def explain_held_bodies(newton: Newton, at_rest: bool = False) -> Iterator[Block]:
    """What else acts on the bodies, along which line, and why it is in no equation."""
    for held in held_bodies(newton, at_rest):
        yield from _held(held)


def _held(held: HeldBody) -> Iterator[Block]:
    body, value = the(held.body), held.value
    if held.along is None:
        yield prose(f"The forces that keep {body} on its path are normal to it: they do no virtual work and are not "
                    "shown.")  # fmt: skip
        return
    begin: tuple[Part, ...] = (f"The force that keeps {body} from moving along ", math(held.along))
    if value is None or count_operations(value) > LONGEST_REACTION:
        yield prose(*begin, " does no virtual work and is not shown.")
        return
    value = with_common_factor(value)
    if count_operations(value) <= LONGEST_IN_TEXT:
        idle = " in this direction; it does no virtual work and is in none of the equations above."
        yield prose(*begin, " is ", math(value), idle)
        return
    yield prose(*begin, " is, in this direction,")
    yield display(Equation((value,)))
    yield prose("It does no virtual work and is in none of the equations above.")
