"""What the name of a reaction may stand for in an answer.

In the derivation it is a force, where the reaction is a single one (`reaction_signs`). A textbook may take the opposite
force as positive, and with R = λ ∂f/∂r in mind the name may be that of the multiplier, with either sign in front of it.
So a name N may stand for ρ N of the derivation,

    ρ = 1, −1, 1/factor, −1/factor        (N = factor · λ; the last two where the factor is not ±1),

with one ρ for each name in the whole answer.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import islice, product

import sympy as sp

from lagrange.answers.limits import MOST_MEANINGS
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import text
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reaction_signs import ForceKind, SingleForce


@record
class ForceMeaning:
    """ρ, and in words what the name is taken for; empty for what it is in the derivation."""

    ratio: sp.Expr
    remark: str


def meanings_of_force(reaction: Reaction) -> tuple[ForceMeaning, ...]:
    """What the name of one reaction may stand for, the meaning of the derivation first."""
    name, single = reaction.force.name, reaction.single
    same = ForceMeaning(sp.S.One, "")
    opposite = ForceMeaning(sp.S.NegativeOne, _opposite(name, single))
    if single is None or abs(single.factor) == 1:
        return same, opposite
    what = "tension" if single.kind is ForceKind.TENSION else "force"
    remark = f"`{name}` is taken as the multiplier of the constraint; in the derivation it is the {what}"
    negative = f"`{name}` is taken as minus the multiplier of the constraint; in the derivation it is the {what}"
    per_force = 1 / single.factor
    return same, opposite, ForceMeaning(per_force, remark), ForceMeaning(-per_force, negative)


def _opposite(name: str, single: SingleForce | None) -> str:
    if single is None:
        return f"`{name}` is taken with the opposite sign; in the derivation it is the multiplier λ in R = λ ∂f/∂r"
    if single.kind is ForceKind.TENSION:
        return f"`{name}` is taken as a force that pushes; in the derivation it is a tension, positive if it pulls"
    if single.direction is None:
        return f"`{name}` is taken in the opposite direction"
    along, against = _along(single.direction), _along(-single.direction)
    return f"`{name}` is taken along {against} on `{single.on}`; in the derivation it acts along {along}"


def _along(direction: Vector) -> str:
    return f"`{text(direction.as_sum())}`"


@record
class NameReading:
    """One meaning for each name of reactions in an answer: `ratios` ρ by symbol, and remarks by name."""

    ratios: Mapping[sp.Symbol, sp.Expr]
    remarks: Mapping[str, str]


def other_readings(newton: Newton | None, used: Collection[str]) -> Iterator[NameReading]:
    """All readings of the names that an answer uses, except that of the derivation; `MOST_MEANINGS` at most.

    First those in which all names have the same kind of meaning, then those in which fewer of them differ.
    """
    named = [r for r in newton.reactions if r.given is not None and r.force.name in used] if newton else []
    kinds = [meanings_of_force(r) for r in named]
    choices = sorted(product(*(range(len(k)) for k in kinds)), key=_order)
    for choice in islice((c for c in choices if any(c)), MOST_MEANINGS):
        taken = {r.force: k[n] for r, k, n in zip(named, kinds, choice, strict=True) if n}
        yield NameReading({s: m.ratio for s, m in taken.items()}, {s.name: m.remark for s, m in taken.items()})


def _order(choice: Sequence[int]) -> tuple[bool, int, tuple[int, ...]]:
    return len(set(choice)) > 1, sum(n > 0 for n in choice), tuple(choice)
