"""Distance constraints: which geometric constraints keep two points at a distance.

A relation f(q, t) = 0 keeps the points P and Q at a distance just when its gradient is, everywhere on it, parallel to
that of d·d, d = r_P − r_Q: then d·d is constant on it at frozen time. The reaction is then along d,

    R_P = λ κ d = −T d/|d| ,     R_Q = −R_P ,     T = −κ |d| λ :

a tension T where positive, a thrust where negative. Q may be a fixed point (or one that is driven): then nothing in f
tells a rod from a sphere. The relation is recognised by its gradient, never by its name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.exact import Surface
from lagrange.algebra.fourier.linear_systems import tidy_quotient
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Slots
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.coordinates import solved_constraints
from lagrange.mechanics.constraints.kinematics import MassPoint, Row


@record
class Rod:
    """A distance that is kept.

    ends    names of the points; the second is empty where it is no particle
    centre  the second end, where it is no particle
    span    d = r_P − r_Q, or r_P − centre
    length  |d|, as the constraint gives it
    ratio   κ
    factor  T = factor · λ
    """

    ends: tuple[str, str]
    centre: Vector | None
    span: Vector
    length: sp.Expr
    ratio: sp.Expr
    factor: sp.Expr


def recognised_rod(
    row: Row, points: Sequence[MassPoint], directions: dict[str, Vector], slots: Slots, surface: Surface
) -> Rod | None:
    """The distance that a constraint keeps; None where it is no distance constraint, or was not seen to be one.

    points      the particles
    directions  of the constraint's reactions on them, R_P = λ · direction
    """
    if row.finite is None or not 1 <= len(directions) <= 2:
        return None
    for ends, centre, d in _candidates(points, directions, slots):
        squared = textbook_form(d.dot(d))
        slopes = [squared.diff(q) for q in slots.coordinates]
        found = _ratio(row, slopes, surface)
        if found is not None:
            length = _length(row, d, squared, found, slots)
            if length is None:
                continue
            factor = textbook_form(-(found * length).xreplace({squared: length**2}))
            return Rod(ends, centre, d, length, found, factor)
    return None


def _candidates(
    points: Sequence[MassPoint], directions: dict[str, Vector], slots: Slots
) -> Iterator[tuple[tuple[str, str], Vector | None, Vector]]:
    """The pairs of points that may be kept at a distance, with the vector from the second to the first."""
    if len(directions) == 2:
        chosen = [p for p in points if p.name in directions]
        for p, q in combinations(chosen, 2):
            yield (p.name, q.name), None, p.position - q.position
        return
    [name] = directions
    point = next(p for p in points if p.name == name)
    yield (name, ""), Vector.zero(), point.position
    centre = _centre(point, directions[name], slots)
    if centre is not None and not centre.is_zero:
        yield (name, ""), centre, point.position.fixed() - centre


def _centre(point: MassPoint, direction: Vector, slots: Slots) -> Vector | None:
    """The point c with direction = μ (r − c), μ constant: the centre of a circle or sphere given by squares."""
    gradient = direction.fixed()
    for q, partial in zip(slots.coordinates, point.partials, strict=True):
        along = partial.fixed()
        size = textbook_form(along.dot(along))
        if size == 0:
            continue
        rate = textbook_form(gradient.partial(q).dot(along) / size)
        if rate == 0 or rate.free_symbols & {*slots.coordinates}:
            return None
        centre = (point.position.fixed() - gradient / rate).map(textbook_form)
        still = all(c.free_symbols.isdisjoint(slots.coordinates) for c in centre.components)
        return centre if still else None
    return None


def _ratio(row: Row, slopes: Sequence[sp.Expr], surface: Surface) -> sp.Expr | None:
    """κ with ∂f/∂q = κ/2 ∂(d·d)/∂q where the constraint holds; None where there is none, or it is undecided."""
    pivot = next((k for k, s in enumerate(slopes) if s != 0 and surface.is_zero(s) is False), None)
    if pivot is None:
        return None
    a, b = row.coefficients[pivot], slopes[pivot]
    for a_k, b_k in zip(row.coefficients, slopes, strict=True):
        minor = a_k * b - b_k * a
        if minor != 0 and surface.is_zero(minor) is not True:
            return None
    return tidy_quotient(2 * a / b)


def _length(row: Row, d: Vector, squared: sp.Expr, ratio: sp.Expr, slots: Slots) -> sp.Expr | None:
    """|d| as the constraint gives it, free of coordinates; or the one coordinate that it is."""
    assert row.finite is not None
    moving = set(slots.coordinates)
    shown = [c for c in d.components if c != 0]
    if d.triad.directions is not None and len(shown) == 1 and shown[0] in moving:
        return shown[0]
    square = None
    if ratio.free_symbols.isdisjoint(moving):
        square = sp.factor(textbook_form(squared - 2 * row.finite / ratio))
    if square is None or square.free_symbols & moving:
        square = _by_elimination(row, squared, slots) or _of_root(row, squared, moving)
    if square is None or square.free_symbols & moving:
        return None
    return sp.sqrt(square)


def _by_elimination(row: Row, squared: sp.Expr, slots: Slots) -> sp.Expr | None:
    """d·d with one coordinate solved for."""
    used = [q for q in slots.coordinates if q in row.finite.free_symbols]  # type: ignore[union-attr]
    solution = solved_constraints([row], used[-1:])
    if not solution.expressed:
        return None
    return sp.factor(textbook_form(squared.xreplace(dict(solution.expressed))))


def _of_root(row: Row, squared: sp.Expr, moving: set[sp.Symbol]) -> sp.Expr | None:
    """|d|² from a relation that is linear in |d| = sqrt(d·d)."""
    length = sp.Dummy("length", positive=True)
    f = sp.sympify(row.finite, strict=True).xreplace({squared: length**2})
    slope = f.diff(length)
    if f.free_symbols & moving or slope == 0 or length in slope.free_symbols:
        return None
    return (-f.xreplace({length: sp.S.Zero}) / slope) ** 2
