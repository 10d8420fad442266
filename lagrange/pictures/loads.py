"""All that acts on one particle or body, as arrows with labels.

What the free body has as its applied force must be the sum of what is drawn; where something would be missing, there is
no picture.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified
from lagrange.core.vectors import Vector
from lagrange.document.scene import Kind
from lagrange.mechanics.constraints.kinematics import Load
from lagrange.mechanics.constraints.springs_dampers import Damped, Stretched
from lagrange.mechanics.dynamics.newton import FreeBody
from lagrange.pictures.floats import NoValueError, Space, minus, unit
from lagrange.pictures.poses import Pose
from lagrange.pictures.shapes import force_and_moment, is_planar, reaction_point
from lagrange.pictures.systems import System, ends_of, with_other_values

MOST_OPERATIONS = 4
NOWHERE: Space = (0.0, 0.0, 0.0)
_SOMEWHERE = ((0.83, 0.56, 0.0), (0.7, 0.4, 0.6))
"""A direction for a force of which none is known: in the plane, in space."""


@record
class Acting:
    """A force or moment.

    vector     its direction
    offset     from the particle or mass centre to where it acts
    """

    on: str
    label: sp.Expr | str
    vector: Space
    kind: Kind
    offset: Space = NOWHERE
    is_moment: bool = False


def loads_on(system: System, name: str) -> list[Acting]:
    """The applied forces and moments on a particle or body that have names. Raises NoValueError."""
    return [*_loads(system, name), *_pulls(system, name), *_torques(system, name)]


def acting_on(system: System, body: FreeBody) -> list[Acting]:
    """All that acts on a free body. Raises NoValueError, also where something would be missing."""
    found = loads_on(system, body.name)
    found += _rest(system, body)
    for reaction in body.bound:
        found += _reaction(system, body, reaction.name)
    return found


def given_loads(system: System, name: str) -> list[Acting]:
    """The applied forces on a particle or body, without springs and dampers. Raises NoValueError."""
    return [*_loads(system, name)]


def _posed(system: System, *vectors: Vector) -> Pose:
    return with_other_values(system.pose, [c for v in vectors for c in v.fixed().components])


def _loads(system: System, name: str) -> Iterator[Acting]:
    centre = next(p.position for p in system.configuration.points if p.name == name)
    for load in system.configuration.loads:
        if load.on != name:
            continue
        if any(c.has(Unspecified) for c in load.vector.components):
            yield Acting(name, _spoken(load.name), _SOMEWHERE[not system.view.planar], Kind.FORCE)
            continue
        pose = _posed(system, load.vector, load.point - centre)
        vector = pose.at(load.vector)
        if math.hypot(*vector) > 1e-9:
            where = minus(pose.at(load.point), pose.at(centre))
            yield Acting(name, _force_label(load), vector, Kind.FORCE, where)


def _force_label(load: Load) -> sp.Expr | str:
    """Its size where that is short; its name otherwise."""
    parts = [c for c in load.vector.components if c != 0]
    if len(parts) == 1:
        size = -parts[0] if parts[0].could_extract_minus_sign() else parts[0]
    else:
        size = sp.sqrt(textbook_form(load.vector.dot(load.vector)))
    if sp.count_ops(size) <= MOST_OPERATIONS and not size.has(sp.cos, sp.sin) and not size.has(sp.Abs):
        return size
    return _spoken(load.name)


def _pulls(system: System, name: str) -> Iterator[Acting]:
    configuration = system.configuration
    for link in configuration.links:
        for own, sign in zip(link.ends, (-1, 1), strict=True):
            if own == name:
                first, second = ends_of(link, configuration, system.pose)
                away = minus(first, second)
                pull = _pull(link, system.pose)
                label = pull if sp.count_ops(pull) <= MOST_OPERATIONS else _spoken(link.name)
                yield Acting(name, label, (sign * away[0], sign * away[1], sign * away[2]), Kind.FORCE)
            elif not isinstance(own, str) and _moves(system, own):
                raise NoValueError("a spring that is fastened beside a particle")


def _pull(link: Stretched | Damped, pose: Pose) -> sp.Expr:
    """The force with which it pulls its ends together; the distance on a line may be written with the other sign."""
    if isinstance(link, Damped) and pose.number(link.distance) < 0:
        return link.coefficient * sp.expand(-link.rate)
    return link.pull


def _moves(system: System, end: Vector) -> bool:
    moving = set(system.configuration.slots.coordinates)
    return any(c.free_symbols & moving for c in end.fixed().components)


def _torques(system: System, name: str) -> Iterator[Acting]:
    for torque in system.configuration.torques:
        if torque.on == name:
            vector = _posed(system, torque.vector).at(torque.vector)
            parts = [c for c in torque.vector.components if c != 0]
            size = parts[0] if len(parts) == 1 else None
            short = size is not None and sp.count_ops(size) <= MOST_OPERATIONS
            label: sp.Expr | str = size if short and size is not None else _spoken(torque.name)
            if short and size is not None and size.could_extract_minus_sign():
                label = -size
            yield Acting(name, label, vector, Kind.FORCE, is_moment=True)


def _rest(system: System, body: FreeBody) -> list[Acting]:
    """What the applied force is beside the forces that have names: friction, or one field of force."""
    names = {f.name for f in system.configuration.loads if f.on == body.name}
    others = [n for n in body.loads if n and n not in names]
    springs = (s.energy for s in system.configuration.springs)
    field = sp.expand(system.configuration.potential - sp.Add(*springs)) != 0
    if not others and not field:
        return []
    if len(others) + field != 1:
        raise NoValueError("several forces that cannot be told from one another")
    vector = body.applied
    for load in system.configuration.loads:
        if load.on == body.name:
            vector = vector - load.vector
    if any(c.has(Unspecified) for c in vector.fixed().components):
        raise NoValueError("a force without a direction")
    if any(body.name in link.ends for link in system.configuration.links):
        raise NoValueError("a field beside a spring")
    direction = _posed(system, vector).at(vector)
    if math.hypot(*direction) < 1e-9:
        return []
    return [Acting(body.name, _spoken(others[0]) if others else "field", direction, Kind.FORCE)]


def _reaction(system: System, body: FreeBody, name: str) -> Iterator[Acting]:
    reaction = next(r for r in body.bound if r.name == name)
    force, moment = reaction.per_unit(body.name), reaction.moment_per_unit(body.name)
    pose = _posed(system, *(v for v in (force, moment) if v is not None))
    if reaction.rod is not None and reaction.tension is not None:
        span = unit(pose.at(reaction.rod.span))
        sign = -1.0 if body.name == reaction.rod.ends[0] else 1.0
        yield Acting(body.name, reaction.tension, (sign * span[0], sign * span[1], sign * span[2]), Kind.REACTION)
        return
    push, turn = force_and_moment(pose, reaction, body.name)
    rotation = is_planar(system.configuration, body.name)
    if rotation is not None and math.hypot(*push) > 1e-9:
        where = reaction_point(pose, rotation, reaction, system.shapes[body.name])
        yield Acting(body.name, _times_size(reaction.force, force), push, Kind.REACTION, where or NOWHERE)
        return
    if math.hypot(*push) > 1e-9:
        yield Acting(body.name, _times_size(reaction.force, force), push, Kind.REACTION)
    if math.hypot(*turn) > 1e-9:
        yield Acting(body.name, _times_size(reaction.force, moment), turn, Kind.REACTION, is_moment=True)


def _times_size(unknown: sp.Symbol, direction: Vector | None) -> sp.Expr:
    """λ|∇f| where that is short; λ otherwise."""
    assert direction is not None
    size = sp.sqrt(textbook_form(direction.dot(direction)))
    return unknown * size if size.is_Symbol or size.is_Integer else unknown


def _spoken(name: str) -> str:
    return name.replace("_", " ").replace(".", " ")
