"""Mistakes with springs and dampers: where they are fastened, and with which arm they act.

The extension of a spring between a wall at L and a mass at x is that of the length L − x; who counts it from the other
wall has x. Of a door closer whose length d changes with the angle θ the force −b d' acts with the arm ∂d/∂θ, so that
its moment is −b (∂d/∂θ)² θ'; who takes the arm for a length h has −b d' h, or for both −b h² θ', or forgets it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.answers.models.forces import name_of
from lagrange.answers.models.mechanics import AppliedForceKind, Mechanics, Variation, called, written
from lagrange.core.symbols import base, prime
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.springs_dampers import DamperForce, StretchedSpring
from lagrange.mechanics.dynamics.lagrangian import share_of_damper, share_of_spring


def fastened_elsewhere(m: Mechanics) -> Iterator[Variation]:
    """A spring or damper that has one end at a fixed point, as if that were where another one is fastened, or O."""
    fixed = [e for link in m.configuration.links for e in link.ends if isinstance(e, Vector) and _is_fixed(e, m)]
    for link in m.configuration.links:
        own = [e for e in link.ends if isinstance(e, Vector)]
        if len(own) != 1 or not _is_fixed(own[0], m):
            continue
        for other in dict.fromkeys((*fixed, Vector.zero())):
            apart = link.apart.fixed()
            side = 1 if isinstance(link.ends[0], str) else -1  # `apart` leads from the second end to the first
            moved = apart + (own[0].fixed() - other.fixed()) * sp.Integer(side)
            if other.fixed().components == own[0].fixed().components:
                continue
            for distance in _distances(moved):
                shares = _shares(replace(link, apart=moved, distance=distance), m)
                kind, name = _kind(link)
                changed = _with(m, kind, link.name, shares)
                where = "at O" if other.is_zero else f"at {written_vector(other, m)}"
                yield Variation(f"for {name} fastened {where}", f"where {name} is fastened", changed)


def _is_fixed(end: str | Vector, m: Mechanics) -> bool:
    moving = {*m.slots.coordinates, *m.slots.prescribed}
    return isinstance(end, Vector) and not any(
        {base(s) for s in c.free_symbols} & moving for c in end.fixed().components
    )


def written_vector(v: Vector, m: Mechanics) -> str:
    """A fixed position, by its components that are not zero."""
    parts = [(c, n) for c, n in zip(v.fixed().components, "ijk", strict=True) if c != 0]
    return "`" + " + ".join(f"{written(c, m.slots)}*{n}" for c, n in parts) + "`"


def _distances(apart: Vector) -> Iterator[sp.Expr]:
    """The length of a vector: along one axis, the component itself, on either side."""
    own = [c for c in apart.components if c != 0]
    if len(own) == 1:
        yield from (own[0], -own[0])
    elif own:
        yield sp.sqrt(sp.Add(*(c**2 for c in own)))


def _shares(link: StretchedSpring | DamperForce, m: Mechanics) -> tuple[sp.Expr, ...]:
    if isinstance(link, StretchedSpring):
        return tuple(share_of_spring(link, q) for q in m.slots.coordinates)
    return tuple(share_of_damper(link, v, m.slots) for v in m.slots.velocities)


def _kind(link: StretchedSpring | DamperForce) -> tuple[AppliedForceKind, str]:
    if isinstance(link, StretchedSpring):
        return AppliedForceKind.SPRING, f"the spring {called(link.name)}"
    return AppliedForceKind.DAMPER, f"the damper {called(link.name)}"


def _with(m: Mechanics, kind: AppliedForceKind, name: str, shares: tuple[sp.Expr, ...]) -> Mechanics:
    return m.force(lambda f: replace(f, shares=shares) if f.kind is kind and f.name == name else f)


def with_another_arm(m: Mechanics) -> Iterator[Variation]:
    """The moment of a spring or damper with a constant arm, or with none, where its arm changes with an angle."""
    units = dict(m.units)
    lengths = sorted((p for p, unit in units.items() if unit in ("m", "cm", "mm", "ft")), key=str)
    alike: dict[tuple[sp.Symbol, str], list[tuple[AppliedForceKind, str, str, tuple[sp.Expr, ...]]]] = {}
    for link in m.configuration.links:
        kind, name = _kind(link)
        for k, q in enumerate(m.slots.coordinates):
            arm = sp.diff(link.distance, q)
            if arm.is_number or not arm.has(sp.sin, sp.cos, q):
                continue
            for moment, clause in _moments(link, q, arm, lengths, m):
                shares = tuple(moment if j == k else s for j, s in enumerate(_shares(link, m)))
                together = alike.setdefault((q, clause), [])
                if name not in (n for _, n, *_ in together):
                    together.append((kind, name, link.name, shares))
                yield Variation(f"for {name} {clause}", f"the lever arm of {name}", _with(m, kind, link.name, shares))

    for (_, clause), together in alike.items():
        if len(together) > 1:
            system = m
            for kind, _, own, shares in together:
                system = _with(system, kind, own, shares)
            names = " and ".join(name for _, name, *_ in together)
            yield Variation(f"for {names} {clause}", f"the lever arm of {names}", system)


def _moments(
    link: StretchedSpring | DamperForce, q: sp.Symbol, arm: sp.Expr, lengths: list[sp.Symbol], m: Mechanics
) -> Iterator[tuple[sp.Expr, str]]:
    for sign in (sp.S.One, sp.S.NegativeOne):
        if isinstance(link, StretchedSpring):
            force = -link.pull * sign
            with_arm = [(force * p, f"with the constant lever arm {p}") for p in lengths]
            yield from ((force, "with its force for its moment, without the lever arm"), *with_arm)
            continue
        force = -link.coefficient * arm * prime(q) * sign
        yield force, "with its force for its moment, without the lever arm"
        yield from ((force * p, f"with the constant lever arm {p}") for p in lengths)
    if isinstance(link, DamperForce):
        yield (
            -link.coefficient * prime(q),
            f"with {written(link.coefficient * prime(q), m.slots)} as its moment, as if it had no lever arm",
        )
        for p in lengths:
            clause = f"with the constant lever arm {p}, once for its force and once for its velocity"
            yield -link.coefficient * p**2 * prime(q), clause


def of_another_difference(m: Mechanics) -> Iterator[Variation]:
    """A potential of a relative coordinate, as if it were that of the absolute one, or the other way round."""
    coordinates = m.slots.coordinates
    for f in m.of_kind(AppliedForceKind.POTENTIAL, AppliedForceKind.SPRING):
        pulled = [k for k, s in enumerate(f.shares) if s != 0]
        own = [q for q in coordinates if any(q in s.free_symbols for s in f.shares)]
        if len(pulled) != 1 or own != [coordinates[pulled[0]]]:
            continue
        [k], [q] = pulled, own
        for j, p in enumerate(coordinates):
            for sign in (1, -1) if j != k else ():
                meant = q + sign * p
                pull = f.shares[k].xreplace({q: meant})
                shares = tuple(pull if i == k else sign * pull if i == j else s for i, s in enumerate(f.shares))
                changed = m.force(lambda g, f=f, s=shares: replace(g, shares=s) if g is f else g)  # type: ignore[misc]
                clause = f"with {written(meant, m.slots)} in place of {q} in {name_of(f)}"
                yield Variation(clause, f"which angle or length {name_of(f)} depends on", changed)
