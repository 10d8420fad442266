"""Triads that turn with a body, and their angular velocity.

A rotation by an angle α about an axis n turns at the rate α' n. In a sequence of rotations about body axes (`313`:
first about e_3, then about the new e_1, then about the new e_3) the axis n_k of rotation k is where the rotations
before it have turned it, and rotation k itself leaves it there. So with R_k the matrices of the rotations,

    ω = Σ a_k' n_k ,      n_k = R_1 ... R_{k-1} e = R_1 ... R_k e  (in i, j, k) ,

and the components of n_k in the triad after d ≥ k rotations are (R_{k+1} ... R_d)ᵀ e. The columns of R_1 ... R_d are
the axes of that triad. For any other triad ω follows from its axes: ω·e_1 = e_2'·e_3, and so on.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy as sp

from lagrange.core.symbols import Slots, prime, t
from lagrange.core.vectors import Components, Triad, Vector

Rotations = Sequence[tuple[int, sp.Expr]]
"""Rotations, each the number of its axis and its angle."""

Axes = tuple[Vector, Vector, Vector]


def turned_axes(rotations: Rotations) -> Axes:
    """The axes after some rotations, in i, j, k."""
    matrix = sp.eye(3)
    for axis, angle in rotations:
        matrix = matrix * _matrix(axis, angle)
    a, b, c = (Vector(_column(matrix, k)) for k in range(3))
    return a, b, c


def angular_velocity(rotations: Rotations, slots: Slots) -> Vector:
    """ω in i, j, k."""
    spin = Vector.zero()
    for n, (axis, angle) in enumerate(rotations):
        spin = spin + turned_axes(rotations[:n])[axis - 1] * slots.time_derivative(angle)
    return spin


def turned_triad(names: tuple[str, str, str], rotations: Rotations, slots: Slots) -> Triad:
    """The triad that takes part in some rotations."""
    rows = [v.components for v in turned_axes(rotations)]
    turning = _turning(slots, lambda s: _rates(rotations, rotations, lambda angle: angle.diff(s)))
    return Triad(names, sp.ImmutableMatrix(rows), turning)


def spin_in(triad: Triad, rotations: Rotations, depth: int, slots: Slots) -> Vector:
    """ω of all the rotations, in the triad that takes part in the first `depth` of them, at most one less than all."""
    return Vector(_rates(rotations, rotations[:depth], slots.time_derivative), triad)


def triad_along(names: tuple[str, str, str], axes: Axes, slots: Slots, tidy: Callable[[sp.Expr], sp.Expr]) -> Triad:
    """The triad of three perpendicular unit vectors; that of a frame, where they are its unit vectors."""
    own = axes[0].triad
    units = [tuple(sp.S.One if n == m else sp.S.Zero for m in range(3)) for n in range(3)]
    if all(v.triad == own and v.components == unit for v, unit in zip(axes, units, strict=True)):
        return own
    e1, e2, e3 = (v.fixed() for v in axes)

    def rate(s: sp.Symbol) -> Components:
        d1, d2, d3 = (v.map(lambda c: c.diff(s)) for v in (e1, e2, e3))
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
    """The same triad where the coordinates `expressed` are functions of those of `slots`."""
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
    found = ((s, rate(s)) for s in (*slots.coordinates, *slots.prescribed, t))
    return tuple((s, w) for s, w in found if any(c != 0 for c in w))


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
