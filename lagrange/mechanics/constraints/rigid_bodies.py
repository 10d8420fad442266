"""Rotation of a rigid body in a configuration: ω, the virtual rotation δπ, the angular momentum H and dH/dt.

    ω = Σ ω_k q_k' + ω_t ,    δπ = Σ ω_k δq_k ,    H = J ω = A ω_1 e_1 + B ω_2 e_2 + C ω_3 e_3 in principal axes ,

about the mass centre, in a triad e_1, e_2, e_3 in which the tensor of inertia J is constant. The triad turns with an
angular velocity Ω of its own, Ω = ω where it is fixed in the body, and

    dH/dt = J ω' + Ω × H          (ω' with its components differentiated).

δπ is not the variation of any function: the ω_k need not be derivatives, and the q_k may be quasi-coordinates.
Reference: Whittaker, Analytical Dynamics, §§ 62-64.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.inertia import InertiaTensor
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime
from lagrange.core.vectors import Axes, Vector, triad_in, turning_rate
from lagrange.problem.model import Body


@record
class Rotation:
    """The rotation of one body.

    axes              the axes that the tensor of inertia refers to, in i, j, k
    inertia           J along the axes of the triad in which the vectors here have their components
    angular_velocity  ω
    partials          shape (n,): ω_k
    momentum          H, about the mass centre
    momentum_rate     dH/dt
    given             whether the file gives ω and the axes separately
    """

    name: str
    axes: Axes
    inertia: InertiaTensor
    angular_velocity: Vector
    partials: tuple[Vector, ...]
    momentum: Vector
    momentum_rate: Vector
    given: bool

    @property
    def has_inertia(self) -> bool:
        """Whether any moment of inertia is not 0."""
        return not self.inertia.is_zero

    def virtual(self, steps: Sequence[sp.Expr]) -> Vector:
        """Σ ω_k s_k, for s of shape (n,)."""
        total = Vector.zero(self.angular_velocity.triad)
        for partial, step in zip(self.partials, steps, strict=True):
            total = total + partial * step
        return total


def rotation_of(body: Body, slots: Slots) -> Rotation:
    """The rotation of a body in the coordinates of the file."""
    oriented = body.orientation(slots)
    given = body.angular_velocity is not None
    return _rotation(body.name, oriented.axes, oriented.inertia, oriented.angular_velocity, given, slots)


def rotation_in(
    rotation: Rotation, expressed: dict[sp.Symbol, sp.Expr], rule: dict[sp.Basic, sp.Basic], slots: Slots
) -> Rotation:
    """The rotation in other coordinates; `expressed` gives each replaced coordinate, `rule` its derivatives as well."""
    triad = triad_in(rotation.angular_velocity.triad, expressed, slots)
    spin = Vector(rotation.angular_velocity.components, triad).map(lambda c: c.xreplace(rule))
    first, second, third = (axis.xreplace(rule) for axis in rotation.axes)
    return _rotation(rotation.name, (first, second, third), rotation.inertia, spin, rotation.given, slots)


def _rotation(name: str, axes: Axes, inertia: InertiaTensor, spin: Vector, given: bool, slots: Slots) -> Rotation:
    partials = tuple(spin.map(lambda c, q=q: c.diff(prime(q))) for q in slots.coordinates)  # type: ignore[misc]
    momentum = Vector(inertia.times(spin.components), spin.triad)
    return Rotation(name, axes, inertia, spin, partials, momentum, momentum.time_derivative(slots), given)


def relative_to_triad(rotation: Rotation, slots: Slots) -> tuple[sp.Expr, ...]:
    """The expressions that vanish if the tensor of inertia is constant in the triad: (A − B) (ω − Ω)·e_3, and so on.

    There are none unless the file gives ω and the axes separately.
    """
    if not rotation.given:
        return ()
    spin = rotation.angular_velocity
    relative = (spin - turning_rate(spin.triad, slots)).components
    if not rotation.inertia.is_principal:
        return tuple(e for e in rotation.inertia.turned_with(relative) if e != 0)
    a, b, c = rotation.inertia.moments
    pairs = ((b - c, relative[0]), (c - a, relative[1]), (a - b, relative[2]))
    return tuple(difference * w for difference, w in pairs if difference != 0 and w != 0)
