"""Vectors as components in an orthonormal triad, the fixed i, j, k or a rotating one, and the rotations of triads.

A triad is given by its directions (rows: the unit vectors in i, j, k) and by its angular velocity ω = Σ ω_k q_k',
linear in the velocities, in its own components. With these

    ∂a/∂q_k = (∂a_n/∂q_k) e_n + ω_k × a ,      da/dt = (da_n/dt) e_n + ω × a ,

so that vectors in a rotating triad stay as short as on paper: a = (r'' - r φ'^2) e_r + (r φ'' + 2 r' φ') e_phi.
Two vectors of one triad are combined in it. For a fixed and a rotating one, a dot or cross product is taken in the
rotating triad, a sum in the fixed one.

A rotation by an angle α about an axis n has the angular velocity α' n. In a sequence of rotations about body axes
(`313`: first about e_3, then about the new e_1, then about the new e_3) the earlier rotations carry the axis n_k of
rotation k along, and rotation k leaves it invariant. So with R_k the matrices of the rotations,

    ω = Σ a_k' n_k ,      n_k = R_1 ... R_{k-1} e = R_1 ... R_k e  (in i, j, k) ,

and the components of n_k in the triad after d ≥ k rotations are (R_{k+1} ... R_d)ᵀ e. The columns of R_1 ... R_d are
the axes of that triad. For any other triad ω follows from its axes: ω·e_1 = e_2'·e_3, and so on.

The triads of textbooks: the unit vectors of curvilinear coordinates, and the axes of rigid bodies.

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

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import takewhile

import sympy as sp

from lagrange.core.inertia import InertiaTensor
from lagrange.core.records import record
from lagrange.core.symbols import Slots, UnitVector, derivative, partial, prime, t

Components = tuple[sp.Expr, sp.Expr, sp.Expr]


@record
class Triad:
    """Three orthonormal right-handed unit vectors.

    names       names of e_1, e_2, e_3
    directions  shape (3, 3); row n is e_n in i, j, k; None for the fixed triad itself
    turning     pairs (q_k, ω_k): the angular velocity is Σ ω_k q_k', each ω_k in components of this triad; q_k may
                be t, for a driven triad
    """

    names: tuple[str, str, str]
    directions: sp.ImmutableMatrix | None = None
    turning: tuple[tuple[sp.Symbol, Components], ...] = ()

    @property
    def units(self) -> tuple[UnitVector, UnitVector, UnitVector]:
        """The unit vectors as symbols."""
        a, b, c = (UnitVector(n) for n in self.names)
        return a, b, c


FIXED = Triad(("i", "j", "k"))
"""The inertial triad i, j, k."""

UNITS = {unit.name: unit for unit in FIXED.units}
"""i, j, k as symbols, by name."""


@record
class Vector:
    """Components in a triad."""

    components: Components
    triad: Triad = FIXED

    @classmethod
    def zero(cls, triad: Triad = FIXED) -> Vector:
        """The vector 0."""
        return cls((sp.S.Zero, sp.S.Zero, sp.S.Zero), triad)

    @classmethod
    def total(cls, vectors: Iterable[Vector], triad: Triad = FIXED) -> Vector:
        """The sum of any number of vectors, each component put together once; 0 in `triad` if there are none."""
        terms = [v for v in vectors if not v.is_zero]
        if not terms:
            return cls.zero(triad)
        own = terms[0].triad
        along = list(takewhile(lambda v: v.triad == own, terms))  # in their own triad as long as that is possible
        sums = cls(_three(sp.Add(*parts) for parts in zip(*(v.components for v in along), strict=True)), own)
        rest = terms[len(along) :]
        return cls.total(v.fixed() for v in (sums, *rest)) if rest else sums

    @property
    def is_zero(self) -> bool:
        """Whether all components are literally 0."""
        return all(c == 0 for c in self.components)

    def __add__(self, other: Vector) -> Vector:
        if other.is_zero:
            return self
        if self.is_zero:
            return other
        a, b = (self, other) if self.triad == other.triad else (self.fixed(), other.fixed())
        return Vector(_three(x + y for x, y in zip(a.components, b.components, strict=True)), a.triad)

    def __neg__(self) -> Vector:
        return self.map(lambda c: -c)

    def __sub__(self, other: Vector) -> Vector:
        return self + (-other)

    def __mul__(self, factor: sp.Expr) -> Vector:
        return self.map(lambda c: _times(factor, c))

    __rmul__ = __mul__

    def __truediv__(self, divisor: sp.Expr) -> Vector:
        return self.map(lambda c: c / divisor)

    def map(self, function: Callable[[sp.Expr], sp.Expr]) -> Vector:
        """The vector with `function` applied to each component."""
        return Vector(_three(function(c) for c in self.components), self.triad)

    def fixed(self) -> Vector:
        """The same vector in i, j, k."""
        if self.triad.directions is None:
            return Vector(self.components, FIXED)
        rows = self.triad.directions
        return Vector(
            _three(sum((_times(c, rows[n, m]) for n, c in enumerate(self.components)), sp.S.Zero) for m in range(3))
        )

    def along(self, triad: Triad) -> Vector:
        """The same vector in components of another triad."""
        if triad == self.triad:
            return self
        inertial = self.fixed()
        if triad.directions is None:
            return inertial
        rows = triad.directions
        parts = (sum((rows[n, m] * inertial.components[m] for m in range(3)), sp.S.Zero) for n in range(3))
        return Vector(_three(parts), triad)

    def dot(self, other: Vector) -> sp.Expr:
        """The scalar product."""
        a, b = _common(self, other)
        return sp.Add(*(_times(x, y) for x, y in zip(a.components, b.components, strict=True)))

    def cross(self, other: Vector) -> Vector:
        """The vector product."""
        a, b = _common(self, other)
        return Vector(_cross(a.components, b.components), a.triad)

    def norm(self) -> sp.Expr:
        """The length, sqrt(a·a)."""
        return sp.sqrt(self.dot(self))

    def partial(self, symbol: sp.Symbol) -> Vector:
        """The partial derivative with respect to a coordinate: the components change, and the triad rotates."""
        changed = self.map(lambda c: partial(c, symbol))
        for q, w in self.triad.turning:
            if q == symbol:
                changed = changed + Vector(_cross(w, self.components), self.triad)
        return changed

    def time_derivative(self, slots: Slots) -> Vector:
        """The total time derivative."""
        return self._derivative(slots.time_derivative, {*slots.coordinates, *slots.prescribed, t})

    def frozen_derivative(self, slots: Slots) -> Vector:
        """∂/∂t with configuration and velocities frozen."""
        return self._derivative(slots.frozen_derivative, {*slots.prescribed, t})

    def _derivative(self, scalar: Callable[[sp.Expr], sp.Expr], moving: set[sp.Symbol]) -> Vector:
        changed = self.map(scalar)
        for q, w in self.triad.turning:
            if q in moving:
                rate = sp.S.One if q == t else prime(q)
                changed = changed + Vector(_cross(w, self.components), self.triad) * rate
        return changed

    def change(self, rate: Callable[[sp.Symbol], sp.Expr]) -> Vector:
        """Σ (∂a_n/∂s) rate(s) e_n + Σ rate(q_k) ω_k × a, the change of the vector where s changes by rate(s)."""
        changed = self.map(lambda c: derivative(c, rate))
        for q, w in self.triad.turning:
            if rate(q) != 0:
                changed = changed + Vector(_cross(w, self.components), self.triad) * rate(q)
        return changed

    def xreplace(self, rule: dict[sp.Basic, sp.Basic]) -> Vector:
        """The vector with symbols replaced; in i, j, k if that changes its triad."""
        return self.rewritten(lambda c: c.xreplace(rule))

    def rewritten(self, write: Callable[[sp.Expr], sp.Expr]) -> Vector:
        """The vector with `write` applied to its components; in i, j, k if that changes its triad."""
        directions = self.triad.directions
        if directions is None or directions.applyfunc(write) == directions:
            return self.map(write)
        return self.fixed().map(write)

    def as_sum(self) -> sp.Expr:
        """Σ component · unit vector, for printing."""
        return sp.Add(*(c * e for c, e in zip(self.components, self.triad.units, strict=True)))


def _times(a: sp.Expr, b: sp.Expr) -> sp.Expr:
    """The product; of 0 and another factor SymPy asks first whether that is infinite, which takes a tenth of a ms."""
    return sp.S.Zero if a is sp.S.Zero or b is sp.S.Zero else a * b


def _three(parts: Iterable[sp.Expr]) -> Components:
    a, b, c = parts
    return a, b, c


def _cross(a: Components, b: Components) -> Components:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _common(a: Vector, b: Vector) -> tuple[Vector, Vector]:
    """Both vectors in a common triad: the rotating one if the other is fixed."""
    if a.triad == b.triad:
        return a, b
    if a.triad.directions is None:
        return a.along(b.triad), b
    if b.triad.directions is None:
        return a, b.along(a.triad)
    return a.fixed(), b.fixed()


Rotations = Sequence[tuple[int, sp.Expr]]
"""Rotations, each given by the number of its axis, 1 to 3, and its angle."""

Axes = tuple[Vector, Vector, Vector]


def turned_axes(rotations: Rotations) -> Axes:
    """The axes after a sequence of rotations, in i, j, k."""
    matrix = sp.eye(3)
    for axis, angle in rotations:
        matrix = matrix * _matrix(axis, angle)
    a, b, c = (Vector(_column(matrix, k)) for k in range(3))
    return a, b, c


def angular_velocity(rotations: Rotations, slots: Slots) -> Vector:
    """The angular velocity ω of a sequence of rotations, in i, j, k."""
    spin = Vector.zero()
    for n, (axis, angle) in enumerate(rotations):
        spin = spin + turned_axes(rotations[:n])[axis - 1] * slots.time_derivative(angle)
    return spin


def turned_triad(names: tuple[str, str, str], rotations: Rotations, slots: Slots) -> Triad:
    """The triad obtained by a sequence of rotations."""
    rows = [v.components for v in turned_axes(rotations)]
    turning = _turning(slots, lambda s: _rates(rotations, rotations, lambda angle: angle.diff(s)))
    return Triad(names, sp.ImmutableMatrix(rows), turning)


def spin_in(triad: Triad, rotations: Rotations, depth: int, slots: Slots) -> Vector:
    """ω of all the rotations, in the triad after the first `depth` of them; `depth` is less than their number."""
    return Vector(_rates(rotations, rotations[:depth], slots.time_derivative), triad)


def triad_along(names: tuple[str, str, str], axes: Axes, slots: Slots, tidy: Callable[[sp.Expr], sp.Expr]) -> Triad:
    """The triad of three perpendicular unit vectors; that of a frame if they are its unit vectors."""
    own = axes[0].triad
    units = [tuple(sp.S.One if n == m else sp.S.Zero for m in range(3)) for n in range(3)]
    if all(v.triad == own and v.components == unit for v, unit in zip(axes, units, strict=True)):
        return own
    e1, e2, e3 = (v.fixed() for v in axes)
    turning = {s for v in (e1, e2, e3) for c in v.components for s in c.free_symbols}

    def rate(s: sp.Symbol) -> Components:
        if s not in turning:
            return sp.S.Zero, sp.S.Zero, sp.S.Zero
        d1, d2, d3 = (v.map(lambda c: partial(c, s)) for v in (e1, e2, e3))
        return tidy(d2.dot(e3)), tidy(d3.dot(e1)), tidy(d1.dot(e2))

    return Triad(names, sp.ImmutableMatrix([v.components for v in (e1, e2, e3)]), _turning(slots, rate))


def turning_rate(triad: Triad, slots: Slots) -> Vector:
    """The angular velocity of a triad itself, in its own components."""
    total = Vector.zero(triad)
    moving = {*slots.coordinates, *slots.prescribed}
    for s, w in triad.turning:
        if s == t or s in moving:
            total = total + Vector(w, triad) * (sp.S.One if s == t else prime(s))
    return total


def triad_in(triad: Triad, expressed: Mapping[sp.Symbol, sp.Expr], slots: Slots) -> Triad:
    """The same triad after the coordinates `expressed` are substituted by functions of those of `slots`."""
    if triad.directions is None or not expressed:
        return triad
    rule = dict(expressed)
    parts = [(s, Vector(w, triad).map(lambda c: c.xreplace(rule)).components) for s, w in triad.turning]

    def rate(new: sp.Symbol) -> Components:
        total = [sp.S.Zero] * 3
        for s, w in parts:
            factor = expressed[s].diff(new) if s in expressed else sp.Integer(int(s == new))
            total = [a + factor * b for a, b in zip(total, w, strict=True)]
        return total[0], total[1], total[2]

    return Triad(triad.names, sp.ImmutableMatrix(triad.directions.xreplace(rule)), _turning(slots, rate))


def _turning(slots: Slots, rate: Callable[[sp.Symbol], Components]) -> tuple[tuple[sp.Symbol, Components], ...]:
    rates = ((s, rate(s)) for s in (*slots.coordinates, *slots.prescribed, t))
    return tuple((s, w) for s, w in rates if any(c != 0 for c in w))


def _rates(rotations: Rotations, taken: Rotations, rate: Callable[[sp.Expr], sp.Expr]) -> Components:
    """Σ rate(a_k) n_k over all rotations, in components of the triad after the rotations `taken`."""
    total = sp.zeros(3, 1)
    for n, (axis, angle) in enumerate(rotations):
        after = sp.eye(3)
        for later in taken[n + 1 :]:
            after = after * _matrix(*later)
        total = total + after.T[:, axis - 1] * rate(angle)
    return _column(total, 0)


def _matrix(axis: int, angle: sp.Expr) -> sp.Matrix:
    """The rotation by `angle` about coordinate axis 1, 2 or 3; columns are the turned axes."""
    s, c = sp.sin(angle), sp.cos(angle)
    a, b = {1: (1, 2), 2: (2, 0), 3: (0, 1)}[axis]
    matrix = sp.eye(3)
    matrix[a, a] = matrix[b, b] = c
    matrix[a, b], matrix[b, a] = -s, s
    return matrix


def _column(matrix: sp.Matrix, k: int) -> Components:
    return matrix[0, k], matrix[1, k], matrix[2, k]


# Triads


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
