"""The groups of terms of one physical origin in the derived equations.

In E_k they are: what each applied force contributes, and all of a kind together; what each particle and each rotation
contributes, and each product of velocities; the velocity terms, those of a frame's motion, and the coupling with one
other acceleration. A group that is missing, has the wrong sign or a factor is named in the words of mechanics.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.linear_algebra import NumberRow
from lagrange.answers.models.forces import name_of
from lagrange.answers.models.mechanics import AppliedForceKind, Inertia, Mechanics
from lagrange.answers.models.states import ModelState
from lagrange.answers.models.variation import called
from lagrange.core.records import record

_ZERO, _SIGN, _TWICE, _HALF = sp.S.Zero, sp.S.NegativeOne, sp.Integer(2), sp.Rational(1, 2)


@record
class TermGroup:
    """A group of terms.

    name     of the mistake
    what     the group in a sentence
    rows     its share of each E_k at a state; a zero row where it has none
    factors  those that people give it by mistake
    """

    name: str
    what: str
    rows: Callable[[ModelState], list[NumberRow]]
    factors: tuple[sp.Expr, ...] = (_ZERO, _SIGN, _TWICE, _HALF)

    def said(self, factor: sp.Expr, coordinate: sp.Symbol) -> tuple[str, str]:
        """What to say of it in the equation of a coordinate, and where to look."""
        how = {
            _ZERO: f"{self.what} is left out",
            _SIGN: f"the sign of {self.what} is wrong",
            _TWICE: f"{self.what} is counted twice",
            _HALF: f"only half of {self.what} is there",
        }[factor]
        return f"{how} in the equation of {coordinate}", self.what


def term_groups(m: Mechanics) -> Iterator[TermGroup]:
    """The groups of a system, the smallest and likeliest first."""

    def share(*parts: object) -> Callable[[ModelState], list[NumberRow]]:
        return lambda at: _sum(at, parts)

    for f in m.forces:
        if f.kind is not AppliedForceKind.QUASI:
            yield TermGroup("force in one equation", name_of(f), share(f))
    for j, row in enumerate(m.configuration.rows):
        yield TermGroup("reaction in one equation", f"the reaction of {called(row.name)}", _reaction(j))
    weights = m.of_kind(AppliedForceKind.WEIGHT)
    if len(weights) > 1:
        yield TermGroup("weight in one equation", "the weight", share(*weights))
    for kind in (AppliedForceKind.SPRING, AppliedForceKind.DAMPER, AppliedForceKind.FRICTION):
        several = m.of_kind(kind)
        if len(several) > 1:
            word = {
                AppliedForceKind.SPRING: "springs",
                AppliedForceKind.DAMPER: "dampers",
                AppliedForceKind.FRICTION: "friction forces",
            }[kind]
            yield TermGroup("forces in one equation", f"the force of the {word}", share(*several))
    n = len(m.slots.coordinates)
    frame = [_with_velocity(i, n) for i in m.inertias if n in i.moving]
    if frame:
        what = "what the motion of the frame or support contributes"
        yield TermGroup("frame in one equation", what, share(*frame))
    moving = m.inertias
    velocity = _without_accelerations(moving)
    mixed = tuple(replace(i, squared=_ZERO) for i in moving)
    squared = tuple(replace(i, mixed=_ZERO) for i in moving)
    what = "the Coriolis term, with a product of two velocities,"
    yield TermGroup("Coriolis term in one equation", what, _without_accelerations(mixed))
    what = "the centrifugal term, with the square of a velocity,"
    yield TermGroup("centrifugal term in one equation", what, _without_accelerations(squared))
    yield TermGroup("velocity terms in one equation", "the sum of the velocity terms", velocity, (_ZERO, _SIGN))
    gradient = tuple(replace(i, gradient=_ZERO) for i in moving)
    yield TermGroup("dT/dq in one equation", "the term dT/dq", _difference(moving, gradient))
    product = tuple(replace(i, product=_ZERO) for i in moving)
    what = "the part of d/dt of dT/dq' with the rate of the coefficients"
    yield TermGroup("d/dt in one equation", what, _difference(moving, product))
    for i in m.rotations:
        yield TermGroup("rotation in one equation", f"the rotational inertia of {called(i.name)}", share(i), (_ZERO,))
    for p in m.particles if len(m.inertias) > 1 else ():
        yield TermGroup("inertia in one equation", f"the inertia of {called(p.name)}", share(p), (_ZERO, _SIGN))
    for j, v in enumerate(m.slots.velocities):
        for p in m.particles:
            if j in p.moving and len(p.moving) > 1:
                what = f"what {v} contributes to the velocity of {called(p.name)}"
                own = share(_with_velocity(p, j))
                yield TermGroup("velocity in one equation", what, own, (_ZERO, _SIGN))
        if len(m.slots.coordinates) > 1:
            what = f"the inertia that {v}' has"
            yield TermGroup("acceleration in one equation", what, _coupling(moving, j), (_ZERO, _SIGN))


def _sum(at: ModelState, parts: tuple[object, ...]) -> list[NumberRow]:
    reduce = at.point.arithmetic.reduce
    shares = [at.share(p) for p in parts]  # type: ignore[arg-type]
    return [[reduce(sum(x)) for x in zip(*rows, strict=True)] for rows in zip(*shares, strict=True)]


def _reaction(j: int) -> Callable[[ModelState], list[NumberRow]]:
    """The share of the multiplier of one constraint."""

    def rows(at: ModelState) -> list[NumberRow]:
        n, width = len(at.slots.coordinates), len(at.unknowns) + 1
        shares = [[at.point.number(0)] * width for _ in range(n)]
        for k, coefficient in enumerate(at.system.configuration.rows[j].coefficients):
            shares[k][j] = at.point.arithmetic.reduce(-at.point.value(coefficient))
        return shares

    return rows


def _with_velocity(i: Inertia, index: int) -> Inertia:
    """The products of T with one velocity, alone."""
    return i.times({p: _ZERO for p in i.products if index not in p})


def _difference(all_: tuple[Inertia, ...], rest: tuple[Inertia, ...]) -> Callable[[ModelState], list[NumberRow]]:
    def rows(at: ModelState) -> list[NumberRow]:
        reduce = at.point.arithmetic.reduce
        pairs = zip(_sum(at, all_), _sum(at, rest), strict=True)
        return [[reduce(a - b) for a, b in zip(x, y, strict=True)] for x, y in pairs]

    return rows


def _without_accelerations(moving: tuple[Inertia, ...]) -> Callable[[ModelState], list[NumberRow]]:
    def rows(at: ModelState) -> list[NumberRow]:
        blank = [at.point.number(0)] * len(at.unknowns)
        return [[*blank, row[-1]] for row in _sum(at, moving)]

    return rows


def _coupling(moving: tuple[Inertia, ...], j: int) -> Callable[[ModelState], list[NumberRow]]:
    """The term with q_j'' in the equations of the other coordinates."""

    def rows(at: ModelState) -> list[NumberRow]:
        offset = len(at.unknowns) - len(at.slots.coordinates)
        shown = []
        for k, row in enumerate(_sum(at, moving)):
            blank = [at.point.number(0)] * len(row)
            if k != j:
                blank[offset + j] = row[offset + j]
            shown.append(blank)
        return shown

    return rows
