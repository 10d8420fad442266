"""Rolling without slipping: as long as the friction that it needs is available.

Where constraints keep the point that touches at rest relative to what it touches, friction does no work and is the
reaction of these constraints. It is that of a contact at rest, so that

    |F| ≤ μ_s |N| ,

F being the sum of the reactions at the point of contact except N, the normal one. So it is at rest as well: a
hemisphere on a rough slope is in equilibrium as one that cannot slip, and stays there if |F| ≤ μ_s |N|.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.friction import normal_size, rough_contact
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import RestCondition, bounded_by
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Signs, shortest
from lagrange.mechanics.equilibrium.friction.rough_contacts import keeping_from_slip
from lagrange.mechanics.equilibrium.static_reactions import StaticReactions
from lagrange.problem.model import Friction, Problem


@record
class RollingContact:
    """A contact that does not slip.

    reactions  that keep it from slipping
    size       |F|
    pressed    N, or the multiplier times |g|
    """

    friction: Friction
    normal: Reaction
    reactions: tuple[Reaction, ...]
    size: sp.Expr
    pressed: sp.Expr

    @property
    def symbol(self) -> sp.Symbol:
        """F."""
        return sp.Symbol(f"F_{self.friction.name}", real=True)


@record
class Rolling:
    """The conditions under which nothing slips, in one set of coordinates; no case: it always slips."""

    configuration: Configuration
    contacts: tuple[RollingContact, ...]
    cases: tuple[tuple[RestCondition, ...], ...]
    assumed: tuple[sp.Expr, ...] = ()
    equations: tuple[sp.Expr, ...] = ()
    open: tuple[sp.Symbol, ...] = ()
    forces: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    @property
    def relations(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """The conditions that are equations, as left = right."""
        return tuple((e, sp.S.Zero) for e in self.equations)

    @property
    def friction(self) -> dict[str, tuple[sp.Expr, ...]]:
        """|F|, by the name of the friction."""
        return {c.friction.name: (c.size,) for c in self.contacts}


def nothing_slips(law: NewtonLaw) -> bool:
    """Whether constraints keep every rough contact from slipping, so that friction is their reaction."""
    own = law.configuration
    return not law.frictions and all(keeping_from_slip(f, law.rolling, law.newton, own) for f in law.rolling)


def rolling_at_rest(law: NewtonLaw, resting: StaticReactions | None) -> Rolling:
    """The conditions under which nothing slips at rest.

    Raises NotCoveredError if the equilibria do not share them, or reactions are not determined.
    """
    configuration = law.configuration if resting is None else resting.configuration
    reactions = () if resting is None else (None if there is None else there.reactions for there in resting.at)
    found = [rolling(law.problem, law, r, configuration) for r in reactions]
    first = found[0] if found else None
    if first is None or any(r is None or r.cases != first.cases for r in found):
        what = "friction at rest that is not determined, or differs from one equilibrium to another,"
        raise NotCoveredError(what, law.rolling[0].span)
    return first


def rolling(
    problem: Problem, law: NewtonLaw, reactions: Reactions | None, configuration: Configuration
) -> Rolling | None:
    """The conditions under which the contacts that roll do not slip; None if none rolls, or reactions are omitted."""
    if not law.rolling or reactions is None:
        return None
    signs = Signs({p.symbol for p in problem.parameters})
    contacts, conditions = [], []
    possible = True
    for f in law.rolling:
        normal, keeping = _keeping(f, law)
        values = [reactions.forces.get(r.name, {}).get(f.on) for r in keeping]
        multiplier = reactions.multipliers.get(normal.name)
        if multiplier is None or None in values:
            return None
        direction = normal.on(f.on)
        assert direction is not None
        pressed = reactions.sizes.get(normal.name) if normal.named else None
        if pressed is None:
            pressed = multiplier * normal_size(configuration_vector(direction, configuration), normal, configuration)
        total = sum((v.fixed() for v in values if v is not None), Vector.zero()).map(textbook_form)
        components = [shortest(c) for c in total.components if c != 0]
        side = normal.constraint.side
        sign = f.contact if side is None else 1 if normal.named else side
        assert f.static is not None
        mu = f.static.xreplace(configuration.substitution)
        bound = bounded_by(components or [sp.S.Zero], shortest(pressed * (sign or 1)), mu, sign is not None, signs)
        possible = possible and bound is not None
        conditions += bound or []
        size = components[0] if len(components) == 1 else sp.sqrt(shortest(sp.Add(*(c**2 for c in components))))
        sense = signs.of(size)
        size = size * sense if sense is not None else sp.Abs(size)
        contacts.append(RollingContact(f, normal, keeping, size, pressed))
    cases = (tuple(dict.fromkeys(conditions)),) if possible else ()
    return Rolling(configuration, tuple(contacts), cases, tuple(sorted(signs.used, key=str)))


def configuration_vector(vector: Vector, configuration: Configuration) -> Vector:
    """A vector of the file's coordinates in those of a configuration."""
    return vector.xreplace(configuration.substitution)


def _keeping(friction: Friction, law: NewtonLaw) -> tuple[Reaction, tuple[Reaction, ...]]:
    """The normal reaction, and the reactions that keep the point of contact from slipping."""
    original, frictions = law.configuration, law.all_frictions
    normal, _, _ = rough_contact(friction, frictions, law.newton, original)
    keeping = keeping_from_slip(friction, frictions, law.newton, original)
    if not keeping:
        what = f"the friction `{friction.name}`, whose point does not slip although no constraint holds it,"
        raise NotCoveredError(what, friction.span)
    return normal, keeping
