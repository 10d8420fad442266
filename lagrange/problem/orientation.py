"""How a rigid body is turned: its axes, its angular velocity, and the triad in which its angular momentum is short.

The moments of inertia must be constant in that triad. The axes of the body will always do; where two moments are equal,
so will any triad that turns relative to the body about the third axis. After a sequence of rotations the last of which
is about that axis, the triad that does not take part in it (n_1, n_2, e_3) is the one that books take for tops and
discs: ω has no ψ in it, only ψ'. A planar body turns about k, and needs no other triad than i, j, k.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.rotation import Axes, Rotations, spin_in, triad_along, turned_axes, turned_triad
from lagrange.core.symbols import Slots
from lagrange.core.vectors import FIXED, Components, Triad, Vector
from lagrange.problem.model import Body


@record
class Orientation:
    """How one body is turned.

    axes              to which the moments of inertia refer, in i, j, k
    triad             in which the angular momentum is written
    angular_velocity  ω, in components of `triad`
    inertia           the moments about the axes of `triad`, constant
    vectors           what the body adds to the language, by name
    """

    axes: Axes
    triad: Triad
    angular_velocity: Vector
    inertia: Components
    vectors: Mapping[str, Vector]


def orientation(body: Body, slots: Slots) -> Orientation:
    """The orientation that a body has been given."""
    if body.angle is not None:
        return _planar(body, body.angle, slots)
    if body.angular_velocity is not None:
        return _given(body, body.angular_velocity, slots)
    return _by_rotations(body, slots)


def axis_names(body: str) -> tuple[str, str, str]:
    """What the axes of a body are called."""
    return f"e1_{body}", f"e2_{body}", f"e3_{body}"


def names_before_last(body: str) -> tuple[str, str, str]:
    """What the axes that do not take part in the last rotation are called."""
    return f"n1_{body}", f"n2_{body}", f"n3_{body}"


def _planar(body: Body, angle: sp.Expr, slots: Slots) -> Orientation:
    rotations = ((3, angle),)
    first, second, third = axis_names(body.name)
    triad = turned_triad((first, second, "k"), rotations, slots)
    spin = Vector((sp.S.Zero, sp.S.Zero, slots.time_derivative(angle)))
    k = Vector((sp.S.Zero, sp.S.Zero, sp.S.One))
    vectors = {first: _unit(triad, 0), second: _unit(triad, 1), third: k}
    inertia = (sp.S.Zero, sp.S.Zero, body.inertia[0])
    return Orientation(turned_axes(rotations), FIXED, spin, inertia, vectors)


def _by_rotations(body: Body, slots: Slots) -> Orientation:
    rotations: Rotations = tuple(zip(map(int, body.sequence), body.angles, strict=True))
    names, before = axis_names(body.name), names_before_last(body.name)
    last = rotations[-1][0] - 1
    own = turned_triad(names, rotations, slots)
    nodal_names = tuple(names[n] if n == last else before[n] for n in range(3))
    nodal = turned_triad((nodal_names[0], nodal_names[1], nodal_names[2]), rotations[:-1], slots)
    a, b, c = body.inertia
    inertia = (a, b, c)
    one, other = (inertia[n] for n in range(3) if n != last)
    symmetric = one == other
    triad = nodal if symmetric else own
    spin = spin_in(triad, rotations, 2 if symmetric else 3, slots)
    vectors = {name: _unit(nodal if symmetric and n == last else own, n) for n, name in enumerate(names)}
    vectors |= {name: _unit(triad if n == last else nodal, n) for n, name in enumerate(before)}
    return Orientation(turned_axes(rotations), triad, spin, inertia, vectors)


def _given(body: Body, spin: Vector, slots: Slots) -> Orientation:
    first, second, third = body.axes
    names = axis_names(body.name)
    one, two, three = body.axes_called or names
    triad = triad_along((one, two, three), (first, second, third), slots, textbook_form)
    a, b, c = body.inertia
    vectors = {name: _unit(triad, n) for n, name in enumerate(names)}
    fixed = (first.fixed(), second.fixed(), third.fixed())
    return Orientation(fixed, triad, spin.along(triad).map(textbook_form), (a, b, c), vectors)


def _unit(triad: Triad, index: int) -> Vector:
    x, y, z = (sp.S.One if n == index else sp.S.Zero for n in range(3))
    return Vector((x, y, z), triad)
