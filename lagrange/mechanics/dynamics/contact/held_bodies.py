"""The forces that keep bodies where the coordinates can place them.

Where coordinates by themselves keep a particle or mass centre on a surface or a curve, as x and y do with a ball on a
table and X with a wedge on a floor, Newton's law is written along the directions in which it can be placed. Along a
unit vector n perpendicular to all ∂r/∂q_k a force acts too, that of the table or of the floor: it does no virtual work,
no multiplier stands for it, and

    S = m r''·n − F·n − R·n ,     R being the sum of the reactions that have multipliers.

No second derivative of a coordinate occurs in it, because n·∂r/∂q_k = 0.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.dynamics.newton import FreeBody, Newton


@record
class HeldBody:
    """A direction in which the coordinates cannot place a body, although a force has to act along it.

    along  the unit vector n; None if there are several such directions
    value  S, positive along n; None if a field may have a component there that the coordinates do not tell
    """

    body: str
    along: Vector | None
    value: sp.Expr | None


def held_bodies(newton: Newton, at_rest: bool = False) -> tuple[HeldBody, ...]:
    """The bodies of Newton's laws on which forces act that have no multiplier."""
    return tuple(held for body in newton.bodies or () for held in _held(body, at_rest))


def _held(body: FreeBody, at_rest: bool) -> Iterator[HeldBody]:
    placed = [c.along.fixed() for c in body.components]
    if not placed or len(placed) > 2:
        return
    point = body.particle
    mass = sp.S.Zero if at_rest else point.mass
    force = point.acceleration.fixed() * mass - body.applied.fixed()
    for reaction, direction in body.reactions:
        force = force - direction.fixed() * reaction.force
    known = "" not in body.loads
    directions = _across(placed)
    values = [textbook_form(force.dot(n)) for n in directions]
    acting = [(n, value) for n, value in zip(directions, values, strict=True) if is_zero(value) is not True]
    if len(acting) == 1:
        [(n, value)] = acting
        yield HeldBody(body.name, n, value if known else None)
    elif acting:
        yield HeldBody(body.name, None, None)


def _across(placed: list[Vector]) -> list[Vector]:
    """Unit vectors perpendicular to one or two directions."""
    if len(placed) == 2:
        normal = placed[0].cross(placed[1]).map(textbook_form)
        size = textbook_form(normal.dot(normal))
        return [normal if size == 1 else (normal / sp.sqrt(size)).map(textbook_form)]
    [along] = placed
    axes = [Vector(tuple(sp.S.One if n == m else sp.S.Zero for m in range(3))) for n in range(3)]
    first = next((e for e in reversed(axes) if textbook_form(e.dot(along)) == 0), None)
    if first is None:
        return []
    return [first, first.cross(along).map(textbook_form)]
