"""What a moving figure shows if the file adds nothing: strings from where their coordinates begin, blocks, ground.

What is a string, a block or ground is decided as in the figure on paper (`pictures.inferred`, `pictures.blocks`), in
its position; here the ends of strings and the places of blocks are functions of the state.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import pairwise

import sympy as sp

from lagrange.animation.elements import Elements
from lagrange.animation.limits import GROUND_REACH
from lagrange.core.vectors import Vector
from lagrange.document.scene import PagePoint, StrokeKind
from lagrange.mechanics.constraints.kinematics import MassPoint
from lagrange.pictures.blocks import HIGH, WIDE, Blocks, Way
from lagrange.pictures.floats import NoValueError, inner
from lagrange.pictures.inferred import Inferred
from lagrange.pictures.poses import angle_mark
from lagrange.pictures.sketch import Sketch, left_of, scaled, toward
from lagrange.pictures.systems import is_string


def add_inferred(elements: Elements) -> None:
    """Add strings, blocks and ground to the elements of a figure in a plane."""
    system = elements.system
    if not system.is_bare:
        return
    for places in _strings(elements):
        elements.add("string", p=[elements.at(place) for place in places])
        for a, b in pairwise(places):
            with suppress(NoValueError):
                elements.take(a, b)
    with suppress(NoValueError):
        _arms(elements)
        if system.view.planar:
            _blocks(elements)


def _strings(elements: Elements) -> Iterator[list[Vector]]:
    """From one weight to where its coordinate begins, and down to the other."""
    configuration = elements.configuration
    coordinates = configuration.slots.coordinates
    for reaction in elements.system.newton.reactions:
        row = reaction.row
        if not is_string(reaction) or row.finite is None or len(row.coefficients) != len(coordinates):
            continue
        used = {q: a for q, a in zip(coordinates, row.coefficients, strict=True) if a != 0}
        hung = [[p for p in configuration.points if not p.position.fixed().partial(q).is_zero] for q in used]
        if len({abs(a) for a in used.values()}) != 1 or [len(points) for points in hung] != [1, 1]:
            continue
        ends = [points[0].position.fixed() for points in hung]
        tops = [end.map(lambda c, q=q: c.xreplace({q: sp.S.Zero})) for end, q in zip(ends, used, strict=True)]  # type: ignore[misc]
        if not any(top.as_sum().free_symbols & {*coordinates} for top in tops):
            yield [ends[0], *dict.fromkeys(tops), ends[1]]


def _arms(elements: Elements) -> None:
    """The rods and strings on which particles swing, with their pivots."""
    system, scratch = elements.system, Sketch()
    inferred = Inferred(system, scratch, [*elements.busy])
    for p in inferred.particles():
        drawn = len(scratch.lines)
        inferred.arm(p)
        q = next((q for q in system.pose.coordinates if angle_mark(system.pose, q, p.position) is not None), None)
        if len(scratch.lines) == drawn or q is None:
            continue
        end = p.position.fixed()
        centre = (end + end.map(lambda c, q=q: c.xreplace({q: q + sp.pi}))) * sp.Rational(1, 2)  # type: ignore[misc]
        is_rod = scratch.lines[-1].kind is StrokeKind.ROD
        elements.add("line", p=[elements.at(centre), elements.at(end)], c="rod" if is_rod else "string", l=-1)
        elements.take(centre, end)
        if scratch.lines[-1].points[0] in inferred.pivots:
            elements.mount(centre)


def _blocks(elements: Elements) -> None:
    """The blocks, and a piece of ground under each level on which something slides."""
    system = elements.system
    field = system.problem.gravity
    down = (0.0, -1.0) if field is None else toward((0.0, 0.0), system.page.way(system.pose.at(field)))
    blocks, grounds = Blocks(system, Sketch(), (), down, []), list[Way]()
    for p in system.configuration.points:
        way = blocks.way(p)
        if p.name not in {b.name for b in blocks.particles()}:
            continue
        is_block = blocks.is_block(p)
        if is_block:
            elements.boxed.add(p.name)
            _block(elements, p, blocks.surface(p), way, down)
        if way is not None and blocks.is_carried(way, p) and not any(blocks.same(way, other) for other in grounds):
            grounds.append(way)
            side = left_of(scaled(way.up, -1.0))
            foot = scaled(way.up, -HIGH / 2 if is_block else 0.0)
            ends = [_shifted(elements, way.at, scaled(side, sense * GROUND_REACH), foot) for sense in (-1, 1)]
            elements.add("ground", p=[elements.at(end) for end in ends], far=1)


def _block(elements: Elements, p: MassPoint, kept: Way | None, way: Way | None, down: PagePoint) -> None:
    """A box around its particle, or on the surface that keeps it."""
    on = kept or way
    up = scaled(down, -1.0) if on is None or (kept is None and on.is_upright) else on.up
    lifted = p.position.fixed() + _in_space(elements, scaled(up, HIGH / 2 if kept is not None else 0.0))
    sizes = [elements.cells.scalar(sp.Float(size / elements.system.page.scale)) for size in (WIDE, HIGH)]
    along, upward = _in_space(elements, left_of(up), 1.0), _in_space(elements, up, 1.0)
    elements.add("box", p=elements.at(lifted), a=elements.at(along), b=elements.at(upward), w=sizes, x=0)


def _shifted(elements: Elements, at: PagePoint, *ways: PagePoint) -> Vector:
    return sum((_in_space(elements, way) for way in ways), _in_space(elements, at))


def _in_space(elements: Elements, way: PagePoint, scale: float | None = None) -> Vector:
    """A vector of the plane of the page, which is in centimetres unless a scale is given."""
    view, scale = elements.system.view, scale or elements.system.page.scale
    parts = [inner(way, view.units[n]) / scale if n in view.shown else 0.0 for n in range(3)]
    return Vector(tuple(sp.S.Zero if abs(x) < 1e-12 else sp.Float(x) for x in parts))
