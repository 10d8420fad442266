"""What holds a point of a plane body: pins and rollers under beams, walls that clamp beams, slots of yokes."""

from __future__ import annotations

import math
from contextlib import suppress

from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.pictures.floats import NoValueError, inner, minus, outer, plus
from lagrange.pictures.inferred import BEARING, fulcrum, roller
from lagrange.pictures.limits import SAME_ON_PAGE
from lagrange.pictures.shapes import common_point, force_and_moment, in_space, line_of_action, plane_rotation, turns
from lagrange.pictures.sketch import Sketch, apart, beyond, left_of, scaled, toward
from lagrange.pictures.systems import BEAM, SystemPicture

_SLOT = 0.11
"""Half the width of a slot, in centimetres: a pin fits in."""
_CORNERS = ((1, 1), (-1, 1), (-1, -1), (1, -1))


def bearing(
    system: SystemPicture, sketch: Sketch, p: MassPoint, reaction: Reaction, at: PagePoint, down: PagePoint
) -> None:
    """What holds a point that cannot move: of a beam a wall where it cannot turn, a pin where two reactions act, a
    roller where one does; of anything else a hinge.
    """
    known = system.shapes[p.name].at
    here = [name for name, point in known.items() if math.dist(point, known[reaction.name]) < SAME_ON_PAGE]
    if not BEAM.search(system.text):
        sketch.hinge(at)
        return
    if len(here) > 1 and _is_clamped(system, p):
        along = _along_beam(system, p, at)
        if here[0] == reaction.name and along is not None:
            sketch.wall(at, along, 0.55)
        return
    if len(here) > 1 and here[0] == reaction.name:
        fulcrum(sketch, at, down, BEARING)
    elif len(here) == 1:
        force, _ = force_and_moment(system.pose, reaction, p.name)
        way = toward((0, 0), system.page.way(force))
        tilt = inner(way, down)
        roller(sketch, at, scaled(way, math.copysign(1.0, tilt)) if abs(tilt) > SAME_ON_PAGE else way)
    sketch.hinge(at)


def _is_clamped(system: SystemPicture, p: MassPoint) -> bool:
    """Whether a moment alone keeps a body from turning."""
    for reaction in system.reactions_on(p.name):
        try:
            force, moment = force_and_moment(system.pose, reaction, p.name)
        except NoValueError:
            continue
        if math.hypot(*force) < SAME_ON_PAGE < math.hypot(*moment):
            return True
    return False


def _along_beam(system: SystemPicture, p: MassPoint, at: PagePoint) -> PagePoint | None:
    """The direction from a place to the farther end of a rod."""
    shape = system.problem.figure.shapes.get(p.name)
    ends = [system.page(system.at(end)) for end in shape.ends] if shape is not None else []
    far = max(ends, key=lambda end: apart(end, at), default=at)
    return toward(at, far) if apart(at, far) > SAME_ON_PAGE else None


def slots(system: SystemPicture, sketch: Sketch) -> tuple[str, ...]:
    """Draw the slots of particles in which pins of bodies slide, as of a yoke; return the constraints that they are."""
    found = []
    for reaction in system.newton.reactions if system.view.planar and system.is_bare else ():
        particles = [p for p in system.configuration.points if p.name in (reaction.directions or ())]
        bodies = [*reaction.moments]
        particles = [p for p in particles if p.name not in bodies]
        if len(particles) != 1 or len(bodies) != 1 or reaction.row.finite is None:
            continue
        with suppress(NoValueError):
            if _slot(system, sketch, particles[0], bodies[0], reaction):
                found.append(reaction.name)
    return tuple(found)


def _slot(system: SystemPicture, sketch: Sketch, p: MassPoint, body: str, reaction: Reaction) -> bool:
    """The slot of one particle, across the force on it, where this acts on one point of the body: whether it does.

    The force on the body is the opposite one, also where its mass centre cannot move and only the moment is seen.
    """
    rotation, force, moment = (
        plane_rotation(system.configuration, body),
        reaction.per_unit(p.name),
        reaction.moment_per_unit(body),
    )
    if rotation is None or force is None or moment is None:
        return False
    lines, ways = [], []
    for pose in (system.pose, *system.pose.others):
        ways.append(pose.at(force))
        line = line_of_action(minus((0.0, 0.0, 0.0), ways[-1]), pose.at(moment))
        axes = [pose.at(a) for a in rotation.axes[:2]]
        if line is None:
            return False
        (dx, dy), (px, py) = ([inner(v, a) for a in axes] for v in (line.direction, line.nearest))
        lines.append(((dx, dy), (px, py)))
    point = common_point(lines) if len(lines) > 2 and turns(lines) else None
    if point is None or any(math.hypot(*outer(ways[0], w)) > SAME_ON_PAGE for w in ways):
        return False
    centre = next(q for q in system.configuration.points if q.name == body)
    pin = system.page(plus(system.pose.at(centre.position), in_space(system.pose, rotation, point)))
    held = system.page(system.pose.at(p.position))
    across = toward((0, 0), system.page.way(ways[0]))
    along = left_of(across)
    reach = inner((pin[0] - held[0], pin[1] - held[1]), along)
    if apart(beyond(held, along, reach), pin) > SAME_ON_PAGE or abs(reach) < SAME_ON_PAGE:
        return False  # it pushes a face elsewhere
    half = abs(reach) + 3 * _SLOT
    corners = [beyond(beyond(held, along, a * half), across, b * _SLOT) for a, b in _CORNERS]
    sketch.line(corners, StrokeKind.BODY, closed=True)
    sketch.hinge(pin)
    return True
