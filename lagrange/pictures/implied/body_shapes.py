"""Shapes of bodies whose file gives none, from what it does give: the moments of inertia about the mass centre.

A uniform disc has m R²/2, a ring m R², a sphere 2/5 m R², a shell 2/3 m R², a rod of length 2a has m a²/3 and one of
length l has m l²/12, across. So the number in front of m times a square tells the shape, and the square its size. A rod
lies along the line from its mass centre to a point at which it is held. A body that the text calls a top, with its mass
centre on its axis of symmetry at a constant distance from O, is a cone with its tip there.

Where the moments leave a choice, or say nothing, the name of the body or the words before it in the text decide how it
is drawn, and nothing else: 2/3 m a² is a shell or a cube of side 2a, and an arm whose moment is I is a rod.
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
from lagrange.pictures.implied.halves import half_disc
from lagrange.pictures.limits import SAME_ON_PAGE
from lagrange.pictures.shapes import coordinates_in_body, plane_rotation
from lagrange.pictures.systems import SystemPicture, is_string
from lagrange.problem.keys import Outline
from lagrange.problem.model import BodyShape, Friction

_ROUND = {sp.Rational(1, 2): Outline.DISC, sp.Rational(2, 5): Outline.SPHERE, sp.Rational(2, 3): Outline.SPHERE}
_HALF_LENGTH = {sp.Rational(1, 3): sp.Integer(1), sp.Rational(1, 12): sp.Rational(1, 2)}
_RING = re.compile(r"hoop|\bring\b|\brim\b|wheel", re.IGNORECASE)
_SHELL = re.compile(r"\b(drum|pipe|tube|cylinder)s?\b", re.IGNORECASE)
_TOP = re.compile(r"\btops?\b|gyroscope|spinning", re.IGNORECASE)
_ROTOR = re.compile(r"disc|disk|wheel|rotor", re.IGNORECASE)
_PULLEY = re.compile(r"\b(pulley|drum|wheel|winch|capstan|cylinder|disc|disk)s?\b", re.IGNORECASE)
_OF_ANGLES = (sp.sin, sp.cos, sp.tan, sp.cot, sp.Abs)
_BAR = re.compile(
    r"\b(rod|bar|arm|beam|lever|plank|stick|pole|ladder|boom|link|crank|rocker|coupler|strut|girder|needle|door)s?\b",
    re.IGNORECASE,
)
_BOX = re.compile(
    r"\b(box|crate|block|cube|brick|chest|cupboard|wardrobe|trunk|plate|slab|raft|drawer)(es|s)?\b", re.IGNORECASE
)
_DISC = re.compile(
    r"\b(disc|disk|wheel|pulley|drum|spool|yo-?yo|reel|bobbin|roller|cylinder|flywheel|coin|winch|capstan)s?\b",
    re.IGNORECASE,
)
_ROUND_WORDS = re.compile(
    r"disc|disk|wheel|cylinder|sphere|\bballs?\b|roller|hoop|\bdrums?\b|\bpipes?\b", re.IGNORECASE
)
_REEL = re.compile(r"\b(spool|yo-?yo|reel|bobbin)s?\b", re.IGNORECASE)
_CONE = re.compile(r"\bcones?\b", re.IGNORECASE)
_WIDE = sp.Rational(9, 20)
"""Radius of a top that is drawn as a cone, as a part of its height."""
_RIM = 2.2
"""The rim of a spool of which only the axle is known, in radii of that."""
_NEUTRAL = 0.8
"""Half the length of a bar, or the radius of a disc, of which no length is known."""


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
    return all(f.is_Symbol or f.is_number or f.func in _OF_ANGLES for f in sp.Mul.make_args(length))


def _plane(system: SystemPicture, p: MassPoint) -> BodyShape | None:
    rotation = plane_rotation(system.configuration, p.name)
    assert rotation is not None
    called = words_for(system, p.name)
    if half_disc(system, p) is not None:
        return None
    if _BOX.search(called):
        return _box(system, p, rotation)
    if system.shapes[p.name].radius and not _REEL.search(called):
        return None  # its contact says so already
    known = ratio(rotation.inertia.moments[2], p.mass)
    if known is None or known[0] not in {*_ROUND, *_HALF_LENGTH, sp.S.One}:
        return _unknown(system, p, rotation, called)
    number, length = known
    if number in _ROUND:
        return BodyShape(_ROUND[number], (length,))
    if number == 1 and (_RING.search(system.text) or _SHELL.search(called)):
        return BodyShape(Outline.RING, (length,))
    if number not in _HALF_LENGTH:
        return None
    way = _along(system, p, rotation)
    if way is None:
        return None
    half = length * _HALF_LENGTH[number]
    return BodyShape(Outline.ROD, (), (p.position.fixed() - way * half, p.position.fixed() + way * half))


def words_for(system: SystemPicture, name: str) -> str:
    """What a body is called: its name, or the words before it ("the beam AC"), or those of the title if it is alone."""
    own = name.replace("_", " ")
    text = f"{system.problem.title} {system.problem.description}"
    if any(words.search(own) for words in (_BAR, _BOX, _DISC, _CONE)):
        return own
    before = re.findall(rf"((?:[\w-]+ )?[\w-]+),? \(?\$?{re.escape(own)}\b", text)
    alone = len(system.configuration.rotations) == 1 and len(system.configuration.points) == 1
    return " ".join([own, *before, *([system.problem.title] if alone else [])])


def is_bar(system: SystemPicture, name: str) -> bool:
    """Whether a body is called a rod, an arm or a lever."""
    return bool(_BAR.search(words_for(system, name)))


def _unknown(system: SystemPicture, p: MassPoint, rotation: Rotation, called: str) -> BodyShape | None:
    """The shape of a body whose moment of inertia tells none: a pulley under its string, or what it is called."""
    radius, touching = _rim(system, rotation), system.shapes[p.name].radius
    if _REEL.search(called) and (radius is not None or touching):
        axle = touching if radius is None else radius
        inner_ = radius is not None or _is_on_string(system, p.name)
        return BodyShape(Outline.DISC, (sp.sympify(axle * _RIM if inner_ else axle, strict=True),))
    if radius is not None:
        return BodyShape(Outline.DISC, (radius,))
    rubbed = _rubbed(system, p)
    if rubbed is not None and _ROUND_WORDS.search(f"{called} {system.text}"):
        return BodyShape(Outline.DISC, (sp.Float(rubbed),))
    if _BAR.search(called):
        return _bar(system, p, rotation)
    if _DISC.search(called) and not any(map(any, system.shapes[p.name].held)):
        return BodyShape(Outline.DISC, (sp.Float(_NEUTRAL),))
    return None


def _rubbed(system: SystemPicture, p: MassPoint) -> float | None:
    """The distance at which a body that is no box is rubbed, the same at every place and in every position."""
    own = [f.at for f in system.problem.forces if isinstance(f, Friction) and f.on == p.name and f.at is not None]
    free = all(math.hypot(*at) < SAME_ON_PAGE for at in system.shapes[p.name].at.values())
    poses = (system.pose, *system.pose.others)
    sizes = [math.dist(x.at(at), x.at(p.position)) for at in own for x in poses]
    same = len(sizes) > 2 and max(sizes) - min(sizes) < SAME_ON_PAGE < sizes[0]
    return sizes[0] if same and free else None


def _is_on_string(system: SystemPicture, name: str) -> bool:
    return any(is_string(r) for r in system.reactions_on(name))


def _bar(system: SystemPicture, p: MassPoint, rotation: Rotation) -> BodyShape | None:
    """A bar along its first axis, as far as what slides on it; as long as any other if nothing holds or meets it."""
    places = (system.joints, system.carried, system.fastened)
    if system.shapes[p.name].held or any(places.get(p.name) for places in places):
        return None  # drawn between these
    reached = [x for o in system.configuration.points if o.name != p.name for x in _slides_on(system, p, rotation, o)]
    fixed = not p.position.fixed().as_sum().free_symbols & {*system.pose.coordinates}
    low, high = min([0.0, *reached]), max([0.0, *reached])
    if not reached:
        low, high = -_NEUTRAL, _NEUTRAL
    else:
        low, high = low - (0.0 if fixed and low == 0 else 0.3), high + 0.5
    at, e1 = p.position.fixed(), rotation.axes[0].fixed()
    return BodyShape(Outline.ROD, (), (at + e1 * sp.Float(low), at + e1 * sp.Float(high)))


def _slides_on(system: SystemPicture, p: MassPoint, rotation: Rotation, o: MassPoint) -> Iterator[float]:
    """Where another point is along the first axis of a body, if it is on that in every position."""
    with suppress(NoValueError):
        seen = [
            coordinates_in_body(x, rotation, p.position, x.at(o.position)) for x in (system.pose, *system.pose.others)
        ]
        if len(seen) > 2 and all(abs(y) < SAME_ON_PAGE for _, y in seen):
            yield seen[0][0]


def _box(system: SystemPicture, p: MassPoint, rotation: Rotation) -> BodyShape | None:
    """A box from the moment m (a² + b²)/12, with the sides that its contacts at corners confirm if they differ."""
    corners = [tuple(map(abs, h)) for h in system.shapes[p.name].held]
    moment = rotation.inertia.moments[2]
    if p.mass == 0 or moment == 0:
        found = {(round(x, 6), round(y, 6)) for x, y in corners if min(x, y) > SAME_ON_PAGE}
        return BodyShape(Outline.BOX, tuple(sp.Float(2 * x) for x in found.pop())) if len(found) == 1 else None
    terms = sp.Add.make_args(sp.expand(12 * moment / p.mass))
    if len(terms) > 2 or not all(_is_product(sp.sqrt(e)) and e.free_symbols for e in terms):
        return None
    sides = [sp.sqrt(e) for e in terms] if len(terms) == 2 else [sp.sqrt(terms[0] / 2)] * 2
    numbers = [system.number(x) for x in sides]
    orders = [sides, sides[::-1]] if abs(numbers[0] - numbers[1]) > SAME_ON_PAGE else [sides]
    if len(orders) > 1 and corners:
        orders = [
            o
            for o in orders
            if all(abs(2 * x - system.number(a)) < SAME_ON_PAGE for x, a in zip(corners[0], o, strict=True))
        ]
    elif len(orders) > 1:
        orders = [o for o in orders if str(o[1].free_symbols).strip("{}").startswith("h")]
    return BodyShape(Outline.BOX, (orders[0][0], orders[0][1])) if orders else None


def _rim(system: SystemPicture, rotation: Rotation) -> sp.Expr | None:
    """The radius R of a pulley, as far as a string says it by x' = R φ'; None for any other body."""
    coordinates = system.configuration.slots.coordinates
    turning = rotation.axes[0].fixed().as_sum().free_symbols & {*coordinates}
    for o in system.configuration.points if len(turning) == 1 and _PULLEY.search(system.text) else ():
        [q] = turning
        way = o.position.fixed().partial(q)
        own = o.position.fixed().as_sum().free_symbols & {*coordinates}
        if o.name != rotation.name and o.mass != 0 and own == {q} and not way.as_sum().has(q) and not way.is_zero:
            return sp.Abs(sp.sqrt(way.dot(way)))
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
    swinging = [j.mark.point for j in system.swinging_joints if j.name == p.name][-1:]
    places = [
        *swinging,
        *system.joints.get(p.name, ()),
        *system.marked.get(p.name, ()),
        *system.fastened.get(p.name, ()),
    ]
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
    thin = [n for n, moment in enumerate(moments) if moment == 0]
    if len(thin) == 1 and known[thin[0] - 1] == known[thin[0] - 2] is not None:
        return _thin_rod(p, rotation, thin[0], known[thin[0] - 1])
    axis = rotation.inertia.symmetry_axis
    own = known[axis]
    if own is not None and own[0] == sp.Rational(1, 2):
        return BodyShape(Outline.DISC, (own[1],))
    if own is not None and own[0] == 1 and _RING.search(system.text):
        return BodyShape(Outline.RING, (own[1],))
    if own is not None and own[0] == sp.Rational(3, 10) and _CONE.search(system.text):
        return _cone(system, p, rotation, axis, own[1])
    distance = _distance_on_axis(system, p, rotation, axis)
    if distance is None or not _TOP.search(system.text):
        return None
    if _ROTOR.search(p.name):
        return BodyShape(Outline.DISC, (sp.Float(_WIDE * distance),))
    height = sp.Rational(4, 3) * sp.Float(distance)
    return BodyShape(Outline.CONE, (_WIDE * height, height))


def _thin_rod(
    p: MassPoint, rotation: Rotation, axis: int, across: tuple[sp.Rational, sp.Expr] | None
) -> BodyShape | None:
    """A rod along the axis about which it has no moment of inertia."""
    if across is None or across[0] not in _HALF_LENGTH:
        return None
    at, along = p.position.fixed(), rotation.axes[axis].fixed() * (across[1] * _HALF_LENGTH[across[0]])
    return BodyShape(Outline.ROD, (), (at - along, at + along))


def _cone(system: SystemPicture, p: MassPoint, rotation: Rotation, axis: int, radius: sp.Expr) -> BodyShape | None:
    """A cone with 3/10 m R² about its axis and 3/80 m (4 R² + h²) across, with its tip where it does not move."""
    across = rotation.inertia.moments[axis - 1]
    height = sp.sqrt(sp.expand(sp.Rational(80, 3) * across / p.mass - 4 * radius**2))
    for sign in (1, -1):
        along = rotation.axes[axis].fixed() * sign
        tip = p.position.fixed() - along * (sp.Rational(3, 4) * height)
        places = [pose.at(tip) for pose in (system.pose, *system.pose.others)]
        if len(places) > 2 and all(math.dist(places[0], place) < SAME_ON_PAGE for place in places):
            return BodyShape(Outline.CONE, (radius, height), (), along)
    return BodyShape(Outline.CONE, (radius, height))


def has_axle(system: SystemPicture, p: MassPoint, rotation: Rotation) -> bool:
    """Whether a disc in space turns about O, from which its axis leads to its centre."""
    if system.view.planar or not system.is_bare:
        return False
    return _distance_on_axis(system, p, rotation, rotation.inertia.symmetry_axis) is not None


_FIFTHS = sp.Rational(2, 5)


def _distance_on_axis(system: SystemPicture, p: MassPoint, rotation: Rotation, axis: int) -> float | None:
    """The distance of the mass centre from O, if its axis leads from O to it in all positions."""
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
