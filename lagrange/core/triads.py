"""The triads of textbooks: the unit vectors of curvilinear coordinates, and the axes of rigid bodies.

    polar, cylindrical   e_r = cos φ i + sin φ j,   e_φ = −sin φ i + cos φ j,   ω = φ' k
    spherical            e_r = sin θ (cos φ i + sin φ j) + cos θ k   (θ from +k, φ from i to j),
                         e_θ = ∂e_r/∂θ,   e_φ = −sin φ i + cos φ j,   ω = θ' e_φ + φ' k

The unit vectors are named after the coordinates.

A rigid body is turned by an angle α about k (ω = α' k), by a sequence of three rotations about body axes (`313`: first
about e_3, then about the new e_1, then about the new e_3), or it is given a triad and ω. Its angular momentum is
written in a triad in which the tensor of inertia is constant. The axes of the body always are such a triad; if they are
principal axes and two moments are equal, so is any triad that turns relative to the body about the third axis. After a
sequence of rotations whose last is about that axis, the triad that takes no part in it (n_1, n_2, e_3) is the usual one
for tops and discs: ω then contains ψ' but not ψ. A planar body turns about k and needs no triad but i, j, k.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import sympy as sp

from lagrange.core.inertia import InertiaTensor
from lagrange.core.records import record
from lagrange.core.symbols import Slots
from lagrange.core.vectors import (
    FIXED,
    Axes,
    Rotations,
    Triad,
    Vector,
    spin_in,
    triad_along,
    turned_axes,
    turned_triad,
)

ZERO, ONE = sp.S.Zero, sp.S.One
UnitVectorNames = tuple[str, str, str]


def unit_vector(triad: Triad, index: int) -> Vector:
    """The unit vector e_{index + 1} of a triad."""
    x, y, z = (ONE if n == index else ZERO for n in range(3))
    return Vector((x, y, z), triad)


# -- curvilinear coordinates -------------------------------------------------------------------------------------------


def polar(r: sp.Symbol, phi: sp.Symbol) -> Triad:
    """e_r and e_φ in the plane of i and j, and k."""
    return _turning_about_k((f"e_{r.name}", f"e_{phi.name}", "k"), phi)


def cylindrical(rho: sp.Symbol, phi: sp.Symbol, z: sp.Symbol) -> Triad:
    """e_ρ, e_φ and e_z, which is k and written so."""
    del z
    return polar(rho, phi)


def spherical(r: sp.Symbol, theta: sp.Symbol, phi: sp.Symbol) -> Triad:
    """e_r, e_θ, e_φ."""
    (st, ct), (sf, cf) = (sp.sin(theta), sp.cos(theta)), (sp.sin(phi), sp.cos(phi))
    directions = sp.ImmutableMatrix([[st * cf, st * sf, ct], [ct * cf, ct * sf, -st], [-sf, cf, 0]])
    names = (f"e_{r.name}", f"e_{theta.name}", f"e_{phi.name}")
    return Triad(names, directions, ((theta, (ZERO, ZERO, ONE)), (phi, (ct, -st, ZERO))))


def _turning_about_k(names: UnitVectorNames, phi: sp.Symbol) -> Triad:
    s, c = sp.sin(phi), sp.cos(phi)
    directions = sp.ImmutableMatrix([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return Triad(names, directions, ((phi, (ZERO, ZERO, ONE)),))


# -- rigid bodies ------------------------------------------------------------------------------------------------------


@record
class Orientation:
    """How a rigid body is turned.

    axes              to which the tensor of inertia refers, in i, j, k
    triad             in which the angular momentum is written
    angular_velocity  ω, in components of `triad`
    inertia           the tensor of inertia along the axes of `triad`, constant
    vectors           the axes that the language of a problem file has for this body, by name
    """

    axes: Axes
    triad: Triad
    angular_velocity: Vector
    inertia: InertiaTensor
    vectors: Mapping[str, Vector]


def axis_names(body: str) -> UnitVectorNames:
    """The names of the axes of a body."""
    return f"e1_{body}", f"e2_{body}", f"e3_{body}"


def names_before_last(body: str) -> UnitVectorNames:
    """The names of the axes that take no part in the last rotation."""
    return f"n1_{body}", f"n2_{body}", f"n3_{body}"


def turned_by_angle(body: str, angle: sp.Expr, moment: sp.Expr, slots: Slots) -> Orientation:
    """A planar body turned by an angle about k; `moment` is its moment of inertia about k."""
    rotations = ((3, angle),)
    first, second, third = axis_names(body)
    triad = turned_triad((first, second, "k"), rotations, slots)
    spin = Vector((ZERO, ZERO, slots.time_derivative(angle)))
    vectors = {first: unit_vector(triad, 0), second: unit_vector(triad, 1), third: Vector((ZERO, ZERO, ONE))}
    return Orientation(turned_axes(rotations), FIXED, spin, InertiaTensor((ZERO, ZERO, moment)), vectors)


def turned_by_rotations(body: str, rotations: Rotations, inertia: InertiaTensor, slots: Slots) -> Orientation:
    """A body turned by three rotations, each (number of the body axis, angle)."""
    names, before = axis_names(body), names_before_last(body)
    last = rotations[-1][0] - 1
    own = turned_triad(names, rotations, slots)
    nodal_names = tuple(names[n] if n == last else before[n] for n in range(3))
    nodal = turned_triad((nodal_names[0], nodal_names[1], nodal_names[2]), rotations[:-1], slots)
    one, other = (inertia.moments[n] for n in range(3) if n != last)
    symmetric = inertia.is_principal and one == other
    triad = nodal if symmetric else own
    spin = spin_in(triad, rotations, 2 if symmetric else 3, slots)
    vectors = {name: unit_vector(nodal if symmetric and n == last else own, n) for n, name in enumerate(names)}
    vectors |= {name: unit_vector(triad if n == last else nodal, n) for n, name in enumerate(before)}
    return Orientation(turned_axes(rotations), triad, spin, inertia, vectors)


def turned_with_axes(
    body: str,
    axes: Axes,
    called: UnitVectorNames | None,
    angular_velocity: Vector,
    inertia: InertiaTensor,
    slots: Slots,
    tidy: Callable[[sp.Expr], sp.Expr],
) -> Orientation:
    """A body whose axes of inertia turn as the triad `axes`, and whose angular velocity is given apart from them.

    called  the names of the axes in the problem file, if it has any
    tidy    brings the components of ω into a short form
    """
    first, second, third = axes
    names = axis_names(body)
    triad = triad_along(called or names, axes, slots, tidy)
    vectors = {name: unit_vector(triad, n) for n, name in enumerate(names)}
    fixed = (first.fixed(), second.fixed(), third.fixed())
    return Orientation(fixed, triad, angular_velocity.along(triad).map(tidy), inertia, vectors)
