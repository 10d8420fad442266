"""The contacts with friction at rest: where they touch, along which unit vectors friction acts, what presses.

Where constraints keep the point that touches from slipping, as in rolling, friction is their reaction: one force, not
two.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.symbols import without_known_magnitudes
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.contact.touching import acts_at, relative_partials
from lagrange.mechanics.dynamics.friction import (
    normal_size,
    rolling_contacts,
    rough_contact,
    rough_reaction,
    unit_toward,
)
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.equilibrium.friction.balance import RoughContact
from lagrange.mechanics.equilibrium.friction.linear_inequalities import shortest
from lagrange.mechanics.equilibrium.limits import MOST_ROUGH_CONTACTS
from lagrange.problem.model import Friction, Problem


def rough_contacts(
    problem: Problem, newton: Newton, original: Configuration, configuration: Configuration
) -> tuple[RoughContact, ...]:
    """The contacts with static friction. Raises ProblemError, NotCoveredError."""
    frictions = each_contact_once(f for f in problem.forces if isinstance(f, Friction))
    if len(frictions) > MOST_ROUGH_CONTACTS:
        raise NotCoveredError(f"friction at rest in more than {MOST_ROUGH_CONTACTS} contacts", frictions[-1].span)
    taken = {*problem.scope.names(), *(r.force.name for r in newton.reactions)}
    rolling = rolling_contacts(frictions, newton, original)
    contacts = (_contact(f, frictions, newton, original, configuration, taken) for f in frictions)
    return tuple(_as_reaction(c, frictions, newton, original) if c.friction in rolling else c for c in contacts)


def _as_reaction(
    contact: RoughContact, frictions: Sequence[Friction], newton: Newton, original: Configuration
) -> RoughContact:
    """A contact that constraints keep from slipping: its friction is their reaction, which has perhaps a name."""
    keeping = keeping_from_slip(contact.friction, frictions, newton, original)
    contact = replace(contact, keeping=keeping)
    if len(keeping) != 1 or len(contact.components) != 1 or keeping[0].given is None:
        return contact
    [reaction], [tangent] = keeping, contact.tangents
    unit = reaction.per_unit(contact.friction.on)
    sense = sp.S.Zero if unit is None else shortest(unit.fixed().dot(tangent))
    if sense not in (1, -1):
        return contact
    rows = tuple(tuple(sense * e for e in row) for row in contact.generalized)
    return replace(contact, tangents=(tangent * sense,), components=(reaction.force,), generalized=rows)


def without_keeping(newton: Newton, contacts: Sequence[RoughContact]) -> Newton:
    """The reactions without those for which friction stands."""
    keeping = {r.name for c in contacts for r in c.keeping}
    kept = tuple(r for r in newton.reactions if r.name not in keeping)
    return replace(newton, reactions=kept) if keeping else newton


def each_contact_once(frictions: Iterable[Friction]) -> list[Friction]:
    """The frictions without the opposite ones, where each of the two that touch has an entry of its own."""
    kept: list[Friction] = []
    for f in frictions:
        own = next((k for k in kept if k.constraint == f.constraint and k.on != f.on and k.static == f.static), None)
        if own is None:
            kept.append(f)
    return kept


def _contact(
    friction: Friction,
    frictions: Sequence[Friction],
    newton: Newton,
    original: Configuration,
    configuration: Configuration,
    taken: set[str],
) -> RoughContact:
    rule = configuration.substitution
    reaction, opposite, place = rough_contact(friction, frictions, newton, original)
    others = [f for f in frictions if f is not friction and f.constraint == friction.constraint]
    if others:
        what = f"friction at rest of `{friction.name}` and `{others[0].name}` on one constraint"
        raise NotCoveredError(what, friction.span)
    moved = [p.xreplace(rule) for p in relative_partials(original, friction.on, opposite, place)]
    direction = reaction.on(friction.on)
    assert direction is not None
    normal = direction.xreplace(rule).fixed()
    tangents = _tangents(friction, normal, moved, configuration)
    letters = ("",) if len(tangents) == 1 else ("_x", "_y", "_z")
    components = []
    for letter in letters:
        name = f"F_{friction.name}{letter}"
        while name in taken:
            name += "_"
        components.append(sp.Symbol(name, real=True))
    side = reaction.constraint.side
    sign = friction.contact if side is None else 1 if reaction.named else side
    assert friction.static is not None
    also = tuple(rough_reaction(replace(friction, constraint=name), newton, original) for name in friction.also)
    units = [(r.force, r.per_unit(friction.on)) for r in (reaction, *also)] if also else []
    size = sp.S.One if reaction.named else normal_size(direction.xreplace(rule), reaction, configuration)
    return RoughContact(
        friction,
        reaction,
        opposite,
        place.xreplace(rule),
        friction.static.xreplace(rule),
        size,
        tangents,
        tuple(components),
        tuple(tuple(shortest(t.dot(p)) for p in moved) for t in tangents),
        sign,
        also,
        tuple((force, unit.xreplace(rule)) for force, unit in units if unit is not None),
    )


def _tangents(
    friction: Friction, normal: Vector, moved: Sequence[Vector], configuration: Configuration
) -> tuple[Vector, ...]:
    """The unit vector of the friction if all displacements are in a plane; otherwise i, j, k."""
    if friction.toward is not None:
        against = -unit_toward(friction, normal, configuration)
    units = [Vector(tuple(sp.Integer(n == k) for n in range(3)), normal.triad) for k in range(3)]
    flat = [u for u in units if all(_vanishes(u.dot(p), configuration) for p in (*moved, normal))]
    if not flat:
        return tuple(units)
    if friction.toward is not None:
        return (against,)
    along = normal.cross(flat[-1])
    length = without_known_magnitudes(sp.sqrt(shortest(along.dot(along))))
    return ((along / length).map(shortest),)


def _vanishes(e: sp.Expr, configuration: Configuration) -> bool:
    return e == 0 or configuration.surface.is_zero(e) is True


def keeping_from_slip(
    friction: Friction, frictions: Sequence[Friction], newton: Newton, original: Configuration
) -> tuple[Reaction, ...]:
    """The reactions, apart from the normal one, that act where what a friction is on touches.

    A string or rod there is something else that holds it, beside friction; so is a guide elsewhere whose force passes
    through the point of contact only in the positions that the constraints admit.
    """
    normal, _, place = rough_contact(friction, frictions, newton, original)

    def acts_there(r: Reaction) -> bool | None:
        other = next((n for n in r.acts_on if n != friction.on), "")
        return acts_at(r, friction.on, other, place, original, anywhere=not r.constraint.kinematic)

    return tuple(
        r
        for r in newton.reactions
        if r is not normal
        and r.constraint.side is None
        and r.tension is None
        and r.on(friction.on) is not None
        and acts_there(r)
    )
