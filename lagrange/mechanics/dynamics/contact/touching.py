"""Where bodies touch: the point of contact as a point of each of the two, and the normal force there.

A body touches at r_A; that point of the body has, with the arm s = r_A − r_G,

    v_A = v_G + ω × s ,     δr_A = Σ (∂r_G/∂q_k + ω_k × s) δq_k .

The normal force acts at r_A if and only if the reaction λ a_k of its constraint is the work of one force there, and of
its opposite on the other body:

    a_k = g·(∂r_A/∂q_k − ∂r_A'/∂q_k)     for every coordinate,

A' being the point of the other body at the same place.

The forces that keep bodies where the coordinates can place them.

Where coordinates by themselves keep a particle or mass centre on a surface or a curve, as x and y do with a ball on a
table and X with a wedge on a floor, Newton's law is written along the directions in which it can be placed. Along a
unit vector n perpendicular to all ∂r/∂q_k a force acts too, that of the table or of the floor: it does no virtual work,
no multiplier stands for it, and

    S = m r''·n − F·n − R·n ,     R being the sum of the reactions that have multipliers.

No second derivative of a coordinate occurs in it, because n·∂r/∂q_k = 0.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.newton import FreeBody, Newton, Reaction
from lagrange.problem.model import Constraint


def centre_of(configuration: Configuration, name: str) -> Vector:
    """The position of a particle or mass centre."""
    return next(p.position for p in configuration.points if p.name == name)


def point_on(configuration: Configuration, name: str, place: Vector) -> Vector:
    """Where a force at a place of a body acts; on a particle, which has one point only, that point."""
    return place if any(r.name == name for r in configuration.rotations) else centre_of(configuration, name)


def velocity_at(configuration: Configuration, name: str, place: Vector) -> Vector:
    """The velocity of the point of a body at a place; for a particle its own."""
    point = next(p for p in configuration.points if p.name == name)
    rotation = next((r for r in configuration.rotations if r.name == name), None)
    if rotation is None:
        return point.velocity
    return point.velocity + rotation.angular_velocity.cross(place - point.position)


def partials_at(configuration: Configuration, name: str, place: Vector) -> list[Vector]:
    """∂r_A/∂q_k, shape (n,), in i, j, k, of the point of a body at a place; for a particle its own."""
    point = next(p for p in configuration.points if p.name == name)
    rotation = next((r for r in configuration.rotations if r.name == name), None)
    moved = [p.fixed() for p in point.partials]
    if rotation is None:
        return moved
    arm = (place - point.position).fixed()
    return [p + w.fixed().cross(arm) for p, w in zip(moved, rotation.partials, strict=True)]


def relative_partials(configuration: Configuration, on: str, opposite: str, place: Vector) -> list[Vector]:
    """The derivatives for one body relative to the other; `opposite` is empty for what does not move."""
    own = partials_at(configuration, on, place)
    if not opposite:
        return own
    return [a - b for a, b in zip(own, partials_at(configuration, opposite, place), strict=True)]


def named_beside(constraint: Constraint, name: str, configuration: Configuration) -> list[str]:
    """What else a constraint mentions besides a body and what moves, though the constraint does no work on it: a
    plank that only slides, in dot(r_ball - r_plank, j) >= R, or a wheel that only turns about its fixed axle.
    """
    span = constraint.span
    positions = set(re.findall(r"(?<!\w)r_(\w+)", span.source.text[span.start : span.end]))
    partials = [(m.name, m.partials) for m in configuration.points]
    partials += [(m.name, m.partials) for m in configuration.rotations]
    moving = dict.fromkeys(m for m, moved in partials if not all(v.is_zero for v in moved))
    return [other for other in moving if other != name and other in positions]


def acts_at(
    reaction: Reaction, on: str, opposite: str, place: Vector, original: Configuration, *, anywhere: bool = False
) -> bool | None:
    """Whether a reaction is one force at a place of one body, and its opposite on the other; None: undecided.

    original  the file's coordinates
    anywhere  in any position at all, and not only in those that the constraints admit
    """
    direction = reaction.on(on)
    if direction is None:
        return False
    vanishes = is_zero if anywhere else original.states.is_zero
    force = direction.fixed()
    coefficients = without_root(reaction.row, original.slots).coefficients
    undecided = False
    for a, moved in zip(coefficients, relative_partials(original, on, opposite, place), strict=True):
        same = vanishes(a - force.dot(moved))
        if same is False:
            return False
        undecided = undecided or same is None
    return None if undecided else True


# Held bodies


@record
class HeldBody:
    """A direction in which the coordinates cannot place a body, although a force has to act along it.

    along  the unit vector n; None if there are several such directions
    value  S, positive along n; None if a field or a reaction may have a component there that is not known
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
    known = "" not in body.loads and not any(reaction.is_partial for reaction, _ in body.reactions)
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
