"""Shapes of bodies whose file gives none, from what it does give: the moments of inertia about the mass centre.

A uniform disc has m R²/2, a ring m R², a sphere 2/5 m R², a shell 2/3 m R², a rod of length 2a has m a²/3 and one of
length l has m l²/12, across. So the number in front of m times a square tells the shape, and the square its size. A rod
lies along the line from its mass centre to a point at which it is held. A body that the text calls a top, with its mass
centre on its axis of symmetry at a constant distance from O, is a cone with its tip there.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import sympy as sp

from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.constraints.rigid_bodies import Rotation
from lagrange.pictures.floats import NoValueError, inner, outer
from lagrange.pictures.limits import SAME_ON_PAGE
from lagrange.pictures.shapes import coordinates_in_body, plane_rotation
from lagrange.pictures.systems import SystemPicture, is_string
from lagrange.problem.model import BodyShape, Outline

_ROUND = {sp.Rational(1, 2): Outline.DISC, sp.Rational(2, 5): Outline.SPHERE, sp.Rational(2, 3): Outline.SPHERE}
_HALF_LENGTH = {sp.Rational(1, 3): sp.Integer(1), sp.Rational(1, 12): sp.Rational(1, 2)}
_RING = re.compile(r"hoop|\bring\b|\brim\b|wheel", re.IGNORECASE)
_TOP = re.compile(r"\btops?\b|gyroscope|spinning", re.IGNORECASE)
_PULLEY = re.compile(r"\b(pulley|drum|wheel|winch|capstan|cylinder|disc|disk)s?\b", re.IGNORECASE)
_WIDE = sp.Rational(9, 20)
"""Radius of a top that is drawn as a cone, as a part of its height."""


def with_implied_shapes(system: SystemPicture) -> SystemPicture:
    """The system with a shape for every body whose moments of inertia tell one; not where the file draws lines."""
    if not system.is_bare:
        return system
    figure = system.problem.figure
    implied = dict(figure.shapes)
    for p in system.configuration.points:
        rotation = next((r for r in system.configuration.rotations if r.name == p.name), None)
        if rotation is None or p.name in implied:
            continue
        with suppress(NoValueError):
            shape = _plane(system, p) if plane_rotation(system.configuration, p.name) else _space(system, p, rotation)
            if shape is not None:
                implied[p.name] = shape
    if len(implied) == len(figure.shapes):
        return system
    return replace(system, problem=replace(system.problem, figure=replace(figure, shapes=implied)))


def ratio(moment: sp.Expr, mass: sp.Expr) -> tuple[sp.Rational, sp.Expr] | None:
    """A moment of inertia as number · mass · length²; None if it is no such product."""
    if mass == 0 or moment == 0:
        return None
    number, rest = sp.cancel(moment / mass).as_coeff_Mul()
    length = sp.sqrt(rest)
    if not isinstance(number, sp.Rational) or not rest.free_symbols or not _is_product(length):
        return None
    return number, length


def _is_product(length: sp.Expr) -> bool:
    return all(f.is_Symbol or f.is_number for f in sp.Mul.make_args(length))


def _plane(system: SystemPicture, p: MassPoint) -> BodyShape | None:
    rotation = plane_rotation(system.configuration, p.name)
    assert rotation is not None
    if system.shapes[p.name].radius:
        return None  # its contact says so already
    known = ratio(rotation.inertia.moments[2], p.mass)
    if known is None or known[0] not in {*_ROUND, *_HALF_LENGTH, sp.S.One}:
        radius = _rim(system, rotation)
        return None if radius is None else BodyShape(Outline.DISC, (radius,))
    number, length = known
    if number in _ROUND:
        return BodyShape(_ROUND[number], (length,))
    if number == 1 and _RING.search(system.text):
        return BodyShape(Outline.RING, (length,))
    if number not in _HALF_LENGTH:
        return None
    way = _along(system, p, rotation)
    if way is None:
        return None
    half = length * _HALF_LENGTH[number]
    return BodyShape(Outline.ROD, (), (p.position.fixed() - way * half, p.position.fixed() + way * half))


def _rim(system: SystemPicture, rotation: Rotation) -> sp.Expr | None:
    """The radius R of a pulley, as far as a string says it by x' = R φ'; None for any other body."""
    coordinates = system.configuration.slots.coordinates
    turning = rotation.axes[0].fixed().as_sum().free_symbols & {*coordinates}
    for reaction in system.newton.reactions if _PULLEY.search(system.text) else ():
        if not is_string(reaction) or len(reaction.row.coefficients) != len(coordinates):
            continue
        used = {q: a for q, a in zip(coordinates, reaction.row.coefficients, strict=True) if a != 0}
        angle = turning & {*used}
        if len(used) == 2 and len(angle) == 1:
            [q] = angle
            [other] = {*used} - angle
            return sp.Abs(sp.cancel(used[q] / used[other]))
    return None


def _along(system: SystemPicture, p: MassPoint, rotation: Rotation) -> Vector | None:
    """The unit vector along a rod: towards the points at which it is held, or else its first axis."""
    held = list(system.shapes[p.name].held)
    places = [*system.joints.get(p.name, ()), *system.marked.get(p.name, ()), *system.fastened.get(p.name, ())]
    held += [coordinates_in_body(system.pose, rotation, p.position, place) for place in places]
    held = [h for h in held if math.hypot(*h) > SAME_ON_PAGE]
    e1, e2 = rotation.axes[0].fixed(), rotation.axes[1].fixed()
    if not held:
        return e1
    x, y = max(held, key=lambda h: math.hypot(*h))
    if any(abs(x * b - y * a) > SAME_ON_PAGE for a, b in held):
        return None  # they are on no line
    size = math.hypot(x, y)
    parts = [sp.Integer(round(c)) if abs(c - round(c)) < SAME_ON_PAGE else sp.Float(c) for c in (x / size, y / size)]
    along: Vector = e1 * parts[0] + e2 * parts[1]
    return along


def _space(system: SystemPicture, p: MassPoint, rotation: Rotation) -> BodyShape | None:
    moments = rotation.inertia.moments
    known = [ratio(moment, p.mass) for moment in moments]
    if all(known) and len({*known}) == 1 and known[0] is not None and known[0][0] in (_FIFTHS, sp.Rational(2, 3)):
        return BodyShape(Outline.SPHERE, (known[0][1],))
    axis = rotation.inertia.symmetry_axis
    own = known[axis]
    if own is not None and own[0] == sp.Rational(1, 2):
        return BodyShape(Outline.DISC, (own[1],))
    if own is not None and own[0] == 1 and _RING.search(system.text):
        return BodyShape(Outline.RING, (own[1],))
    distance = _distance_on_axis(system, p, rotation, axis)
    if distance is None or not _TOP.search(system.text):
        return None
    height = sp.Rational(4, 3) * sp.Float(distance)
    return BodyShape(Outline.CONE, (_WIDE * height, height))


_FIFTHS = sp.Rational(2, 5)


def _distance_on_axis(system: SystemPicture, p: MassPoint, rotation: Rotation, axis: int) -> float | None:
    """The distance of the mass centre from O, if O is behind it on its axis in all positions."""
    distances = [*_distances(system, p, rotation, axis)]
    if len(distances) < 3 or max(distances) - min(distances) > SAME_ON_PAGE or distances[0] < SAME_ON_PAGE:
        return None
    return distances[0]


def _distances(system: SystemPicture, p: MassPoint, rotation: Rotation, axis: int) -> Iterator[float]:
    for pose in (system.pose, *system.pose.others):
        at, e = pose.at(p.position), pose.at(rotation.axes[axis])
        if math.hypot(*outer(at, e)) > SAME_ON_PAGE or inner(at, e) < 0:
            return
        yield inner(at, e)
