"""Mistakes in how fast a body turns: ω of a body that rolls, or is carried round, in terms of the motion of its centre.

A wheel that rolls in a ring turns by (R/r − 1) φ' and not by R/r φ', since the line of centres turns as well; a body
that is carried by an arm turns with it, and its own angle may be counted from the arm. So a rate q_i' with which its
centre is carried round is added to its angular velocity, or omitted. A wheel that rolls on another moving one turns
twice as fast as if it rolled on the ground. The work of moments on the body changes with its angular velocity.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.answers.models.mechanics import AppliedForceKind, Inertia, Mechanics
from lagrange.answers.models.variation import Variation, called
from lagrange.core.vectors import Components


def other_angular_velocity(m: Mechanics) -> Iterator[Variation]:
    """A body that turns by one angle turns faster or slower, by the rate of the line to its centre or by a factor 2."""
    for r in m.rotations:
        axes = [a for a in range(3) if any(column[a] != 0 for column in r.columns)]
        if len(axes) != 1:
            continue
        [axis] = axes
        place = f"the angular velocity of {called(r.name)}"
        for i in _carried_round_by(r, m):
            v = m.slots.velocities[i]
            for sign, words in ((1, f"{v} added to"), (-1, f"{v} subtracted from")):
                turned = replace(r, columns=_added(r, i, axis, sign))
                clause = f"with {words} the angular velocity of {called(r.name)}, as if its angle were counted from"
                yield Variation(f"{clause} the line to its centre", place, _turning(m, r, turned))
        for i in _carried_round_by(r, m):
            unit = [[sp.S.Zero] * 3 for _ in r.columns]
            unit[i][axis] = sp.S.One
            turned = replace(r, columns=tuple((c[0], c[1], c[2]) for c in unit))
            if turned.columns != r.columns:
                clause = f"for {called(r.name)} turning at the rate {m.slots.velocities[i]} of the line to its centre"
                yield Variation(clause, place, _turning(m, r, turned))
        for factor, how in ((sp.Integer(2), "twice"), (sp.Rational(1, 2), "half")):
            if len(m.rotations) + len(m.particles) > 1:
                scaled = replace(r, columns=tuple(_times(factor, c) for c in r.columns))
                yield Variation(f"for {called(r.name)} turning {how} as fast", place, _turning(m, r, scaled))


def _carried_round_by(r: Inertia, m: Mechanics) -> Iterator[int]:
    """The angles whose change moves the centre of a body."""
    for p in m.particles:
        if p.name == r.name:
            for i in p.moving[: len(m.slots.coordinates)] if p.moving else ():
                q = m.slots.coordinates[i] if i < len(m.slots.coordinates) else None
                if q is not None and any(c.has(sp.sin(q), sp.cos(q)) for c in p.columns[i]):
                    yield i


def _added(r: Inertia, index: int, axis: int, sign: int) -> tuple[Components, ...]:
    columns = [[*c] for c in r.columns]
    columns[index][axis] += sign
    return tuple((c[0], c[1], c[2]) for c in columns)


def _times(factor: sp.Expr, column: Components) -> Components:
    a, b, c = column
    return factor * a, factor * b, factor * c


def _turning(m: Mechanics, old: Inertia, new: Inertia) -> Mechanics:
    """The system with another angular velocity of a body, and the moments on it doing work accordingly."""
    changed = m.inertia(lambda i: new if i == old else i)
    own = next(a for a in range(3) if any(c[a] != 0 for c in old.columns))
    moved = {}
    for f in m.of_kind(AppliedForceKind.MOMENT):
        if f.on != (old.name,):
            continue
        k = next((k for k, c in enumerate(old.columns[:-1]) if c[own] != 0 and f.shares[k] != 0), None)
        if k is not None:
            moment = f.shares[k] / old.columns[k][own]
            moved[f.name] = tuple(moment * c[own] for c in new.columns[:-1])
    return changed.force(
        lambda f: replace(f, shares=moved[f.name]) if f.kind is AppliedForceKind.MOMENT and f.name in moved else f
    )
