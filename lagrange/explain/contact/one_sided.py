"""One-sided constraints: what they are, and how long they act."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.document.builders import display, listed, math, prose, series
from lagrange.document.derivation import Block, Detail, Emphasis, Equation, Part, Prose, Ref
from lagrange.document.purposes import Phrase, Purpose
from lagrange.explain.words import NORMAL_FORCES, are, capital, constraints_called, plural
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reactions import Reactions


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


def explain_contacts(reactions: Reactions, newton: Newton, place: tuple[Part, ...] = ()) -> list[Block]:
    """As long as what contact lasts: the forces that must not become negative.

    place  where the reactions are written, `at (12)`; empty if there is only one place
    """
    blocks: list[Block] = []
    trivial: list[Reaction] = []
    for r in newton.reactions:
        value = reactions.contacts.get(r.name)
        if value is None:
            continue
        sign = reactions.sign_of_contact(r.name)
        if sign == 1:
            trivial.append(r)
            continue
        is_cord = r.tension is not None and NORMAL_FORCES.isdisjoint(map(str, (r.force, r.symbol)))
        called, verb = constraints_called([r.name]), "pull" if is_cord else "push"
        start = capital(called) if not place else called
        first: tuple[Part, ...] = (*place, ", " if place else "")
        if sign == -1:
            opposite = "pushing" if is_cord else "pulling"
            words = f"{start} could hold contact only by {opposite}, which it cannot: there is no contact."
            blocks.append(prose(*first, words))
            continue
        state = "stays taut" if is_cord else "stays in contact"
        words = f"{start} can only {verb}: it {state} as long as "
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
