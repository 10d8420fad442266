"""Newton's law along the direction of one reaction: the equation that gives this reaction.

A reaction R = N u on a body of mass m, and no unknown one besides with a share along u: m r''·u = F·u + N. In
coordinates that satisfy the constraint of a particle the left side contains no acceleration, because u is normal to
every way in which the particle can still move: m R θ'² = N − m g cos θ on a hoop.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.dynamics.newton import FreeBody, Newton, Reaction
from lagrange.mechanics.limits import LONGEST_PROJECTION
from lagrange.mechanics.results import InCoordinates


@record
class Projection:
    """inertia = right along a reaction of the size `force`; `accelerated`: the accelerations that occur."""

    force: sp.Symbol
    inertia: sp.Expr
    right: sp.Expr
    accelerated: tuple[sp.Symbol, ...] = ()


def projections(newton: Newton, view: InCoordinates) -> tuple[Projection, ...]:
    """One for each reaction that has a size; empty if one of them has none that is short."""
    dynamics = view.dynamics
    if dynamics is None or dynamics.reactions is None or not isinstance(dynamics.written, DalembertMotion):
        return ()
    sizes = {r.symbol_of_force: dynamics.reactions.sizes.get(r.name) for r in newton.reactions}
    if None in sizes or None in sizes.values():
        return ()
    found: dict[sp.Symbol, Projection] = {}
    for _ in newton.reactions:  # the force of the lower rod is one of those along the upper one
        for body in newton.bodies or ():
            for p in _of_body(body, view, dynamics.written, {*found}):
                found.setdefault(p.force, p)
    made = tuple(p for force, p in found.items() if force in sizes)
    values = {force: size for force, size in sizes.items() if force is not None and size is not None}
    for p in made:
        difference = p.inertia - p.right.xreplace(values)
        if not p.accelerated and is_zero(difference, view.configuration.surface) is not True:
            return ()
    return made if len(made) == len(sizes) else ()


def _of_body(
    body: FreeBody, view: InCoordinates, motion: DalembertMotion, known: Collection[sp.Symbol]
) -> Iterator[Projection]:
    """Along each reaction on a body that is alone there, or with forces that are known."""
    acceleration = motion.principle.accelerations.get(body.name)
    configuration = view.configuration
    for reaction, _ in body.reactions if acceleration is not None else ():
        force, along = reaction.symbol_of_force, _direction(reaction, body, view)
        if force is None or along is None or acceleration is None or not _is_free(body, along, view):
            continue
        others = {r.symbol_of_force: _dot(_here(d, view), along) for r, d in body.reactions if r is not reaction}
        shared = {f: share for f, share in others.items() if is_zero(share, configuration.surface) is not True}
        if not {*shared} <= {*known}:
            continue
        inertia, applied = _dot(acceleration * body.particle.mass, along), _dot(_here(body.applied, view), along)
        right = sp.Add(applied, force, *(f * share for f, share in shared.items() if f is not None))
        if max(map(count_operations, (inertia, right))) <= LONGEST_PROJECTION:
            accelerated = tuple(a for a in configuration.slots.accelerations if a in inertia.free_symbols)
            yield Projection(force, inertia, right, accelerated)


def _direction(reaction: Reaction, body: FreeBody, view: InCoordinates) -> Vector | None:
    """The unit vector of the force on this body."""
    single = reaction.single
    if single is None or single.direction is None or body.name not in (single.on, single.opposite):
        return None
    along = _here(single.direction, view)
    return along if single.on == body.name else -along


def _is_free(body: FreeBody, along: Vector, view: InCoordinates) -> bool:
    """Whether the file's coordinates can place the body along a direction.

    Otherwise something holds it there, as a table holds a wedge, with a force that is none of the reactions.
    """
    shares = (_dot(_here(c.along, view), along) ** 2 for c in body.components)
    return is_zero(1 - sp.Add(*shares), view.configuration.surface) is True


def _dot(a: Vector, b: Vector) -> sp.Expr:
    return textbook_form(sp.expand(a.fixed().dot(b.fixed())))


def _here(vector: Vector, view: InCoordinates) -> Vector:
    """A vector in the coordinates of the view."""
    return vector.map(view.configuration.rewritten)
