"""Mistakes in the applied forces: gravity, springs, dampers, friction, given forces and potentials."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.models.kinetic import carriers
from lagrange.answers.models.mechanics import (
    AppliedForceKind,
    ForceShare,
    Mechanics,
    Variation,
    called,
    weight_shares,
    written,
)
from lagrange.core.symbols import partial, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Load
from lagrange.mechanics.constraints.springs_dampers import DamperForce, StretchedSpring
from lagrange.mechanics.dynamics.friction import FrictionForce
from lagrange.mechanics.dynamics.lagrangian import is_constant, share_of_damper, share_of_load, share_of_spring

_NAMES = {
    AppliedForceKind.WEIGHT: "the weight of",
    AppliedForceKind.FORCE: "the force",
    AppliedForceKind.MOMENT: "the moment",
    AppliedForceKind.POTENTIAL: "the force of the potential",
    AppliedForceKind.SPRING: "the spring",
    AppliedForceKind.DAMPER: "the damper",
    AppliedForceKind.FRICTION: "the friction",
    AppliedForceKind.REACTIVE: "the reactive force on",
    AppliedForceKind.VELOCITY_POTENTIAL: "the velocity-dependent part of the potential",
    AppliedForceKind.LAGRANGIAN: "the term of the Lagrangian",
}


def name_of(force: ForceShare) -> str:
    """A force in a sentence: the spring `middle`."""
    by_place = force.kind in (AppliedForceKind.WEIGHT, AppliedForceKind.REACTIVE)
    return f"{_NAMES[force.kind]} {called(force.on[0] if by_place else force.name)}"


def gravity_reversed(m: Mechanics) -> Iterator[Variation]:
    """Gravity acts the other way: the sign of V, or a height counted downwards."""
    weights = m.of_kind(AppliedForceKind.WEIGHT)
    if weights:
        reversed_ = m.scaled(weights, sp.S.NegativeOne)
        yield Variation(
            "for gravity that acts the other way",
            "the sign of the weight",
            reversed_,
        )


def gravity_left_out(m: Mechanics) -> Iterator[Variation]:
    """Gravity is omitted."""
    weights = m.of_kind(AppliedForceKind.WEIGHT)
    if weights:
        yield Variation("without gravity", "the forces: there is a weight", m.scaled(weights, sp.S.Zero))


def friction_reversed(m: Mechanics) -> Iterator[Variation]:
    """Friction acts the other way: with the motion."""
    for system in (m, *_with_open_normal_forces(m)):
        forces = system.of_kind(AppliedForceKind.FRICTION)
        yield from _all_and_each(system, forces, sp.S.NegativeOne, "for {} acting the other way", "the sign of {}")


def friction_left_out(m: Mechanics) -> Iterator[Variation]:
    """Friction is omitted."""
    for system in (m, *_with_open_normal_forces(m)):
        forces = system.of_kind(AppliedForceKind.FRICTION)
        yield from _all_and_each(system, forces, sp.S.Zero, "without {}", "the forces: is {} there")


def _with_open_normal_forces(m: Mechanics) -> Iterator[Mechanics]:
    """The system with friction proportional to unknown normal forces: one that is changed changes the others."""
    rows = [row.name for row in m.configuration.rows]
    if len(m.frictions) < 2 or len(rows) != len(m.multipliers):
        return
    shares = {}
    for f in m.frictions:
        if f.also or f.reaction.name not in rows or not f.contact.is_number:
            return
        force = f.share * m.multipliers[rows.index(f.reaction.name)]
        loads = [Load(f.friction.name, f.friction.on, force, f.point)]
        loads += [] if f.beside is None else [Load(f.friction.name, f.opposite, -force, f.beside)]
        for load in loads:
            own = tuple(share_of_load(load, v, m.configuration) for v in m.slots.velocities)
            shares[load.name, load.on] = own
    friction = AppliedForceKind.FRICTION
    if {*shares} == {(g.name, g.on[0]) for g in m.of_kind(friction)}:
        yield m.force(lambda g: replace(g, shares=shares[g.name, g.on[0]]) if g.kind is friction else g)


def potential_reversed(m: Mechanics) -> Iterator[Variation]:
    """L = T + V."""
    forces = [f for f in m.forces if f.conservative]
    if forces:
        yield Variation("for L = T + V", "the sign of the potential energy", m.scaled(forces, sp.S.NegativeOne))


def force_left_out(m: Mechanics) -> Iterator[Variation]:
    """One force is omitted, or all of one kind."""
    yield from _each_kind(m, sp.S.Zero, "without {}", "the forces: is {} there")


def carried_weight_left_out(m: Mechanics) -> Iterator[Variation]:
    """A weight acts on the coordinates of its own body only, and not on those of the bodies that carry it."""
    bound = {p.name: carriers(p, m) for p in m.particles}
    kind = AppliedForceKind.WEIGHT
    if not m.particles and not m.of_kind(kind):  # at rest weights may be given as forces, of points without mass
        kind = AppliedForceKind.FORCE
        moved = {f.on[0]: {k for k, s in enumerate(f.shares) if s != 0} for f in m.of_kind(kind) if f.on}
        bound = {a: {k for other in moved.values() if other < own for k in other} for a, own in moved.items()}
    weights = {f.on[0]: f for f in m.of_kind(kind) if f.on and bound.get(f.on[0])}
    alike: dict[Vector, list[str]] = {}
    for load in m.configuration.loads:
        if load.on in weights and (kind is AppliedForceKind.FORCE or load.name == "weight"):
            alike.setdefault(load.vector, []).append(load.on)
    together = [list(weights), *(names for names in alike.values() if len(names) < len(weights))]
    for names in (*([n] for n in weights), *(names for names in together if len(names) > 1)):
        shares = {n: tuple(sp.S.Zero if k in bound[n] else s for k, s in enumerate(weights[n].shares)) for n in names}
        if any(shares[n] != weights[n].shares for n in names):
            changed = m.force(
                lambda f, s=shares: (
                    replace(f, shares=s[f.on[0]])  # type: ignore[misc]
                    if f.kind is kind and f.on and f.on[0] in s
                    else f
                )
            )
            listed = ", ".join(map(called, names))
            one = "weight" if kind is AppliedForceKind.WEIGHT else "force"
            what, it = (one, "it") if len(names) == 1 else (f"{one}s", "them")
            of = "of" if kind is AppliedForceKind.WEIGHT else "on"
            clause = f"without the {what} {of} {listed} in the equations of what carries {it}"
            yield Variation(clause, f"the {what} {of} {listed}: what carries {it} is pulled too", changed)


def force_reversed(m: Mechanics) -> Iterator[Variation]:
    """One force has the wrong sign, or all of one kind; one of several weights rarely has."""
    weights = m.of_kind(AppliedForceKind.WEIGHT)
    rest = m if len(weights) < 2 else m.force(lambda f: None if f in weights else f)
    for v in _each_kind(rest, sp.S.NegativeOne, "for {} acting the other way", "the sign of {}"):
        assert v.mechanics is not None
        yield v if rest is m else replace(v, mechanics=replace(v.mechanics, forces=(*weights, *v.mechanics.forces)))


def one_weight_reversed(m: Mechanics) -> Iterator[Variation]:
    """One of several weights has the wrong sign."""
    weights = m.of_kind(AppliedForceKind.WEIGHT)
    for f in weights if len(weights) > 1 else ():
        changed = m.scaled([f], sp.S.NegativeOne)
        yield Variation(f"for {name_of(f)} acting the other way", f"the sign of {name_of(f)}", changed)


def energy_doubled(m: Mechanics) -> Iterator[Variation]:
    """The energy of a spring or another potential without its ½."""
    for kind in (AppliedForceKind.SPRING, AppliedForceKind.POTENTIAL):
        clause, place = "for {} twice as large, as from an energy without its 1/2", "the factor of {}"
        yield from _all_and_each(m, m.of_kind(kind), sp.Integer(2), clause, place)


def at_the_end(m: Mechanics) -> Iterator[Variation]:
    """A weight or another constant force acts at the end of a length, and not in its middle."""
    points = {p.name: p.position.fixed() for p in m.configuration.points}
    moved = {}
    for load in (f for f in m.configuration.loads if f.on in points and is_constant(f, m.configuration)):
        position = points[load.on]
        end = position.map(_without_halves)
        kind = AppliedForceKind.WEIGHT if load.name == "weight" else AppliedForceKind.FORCE
        if end.components != position.components and not load.elsewhere:
            moved[kind, load.name, load.on] = weight_shares(load, end, m.slots)
    groups = [[key] for key in moved] + ([list(moved)] if len(moved) > 1 else [])
    for group in groups:
        those = [f for f in m.forces if f.on and (f.kind, f.name, f.on[0]) in group]
        changed = m.force(
            lambda f, g=group: (
                replace(f, shares=moved[f.kind, f.name, f.on[0]])  # type: ignore[misc]
                if f.on and (f.kind, f.name, f.on[0]) in g
                else f
            )
        )
        names = ", ".join(map(name_of, those))
        where = "the end of its length, and not in the middle" if len(those) == 1 else "the ends, and not in the middle"
        yield Variation(f"for {names} acting at {where}", f"where {names} acts", changed)
    yield from _at_the_ends_of_rods(m)


def _at_the_ends_of_rods(m: Mechanics) -> Iterator[Variation]:
    """A constant force in the middle of a rod acts at one of its ends."""
    ends = dict(m.ends)
    for load in m.configuration.loads:
        kind = AppliedForceKind.WEIGHT if load.name == "weight" else AppliedForceKind.FORCE
        own = next((f for f in m.of_kind(kind) if f.name == load.name and f.on == (load.on,)), None)
        if load.elsewhere or own is None or not is_constant(load, m.configuration):
            continue
        for end in ends.get(load.on, ()):
            shares = weight_shares(load, end, m.slots)
            changed = m.force(lambda f, own=own, s=shares: replace(f, shares=s) if f == own else f)  # type: ignore[misc]
            clause = f"for {name_of(own)} acting at an end of {called(load.on)}, and not in its middle"
            yield Variation(clause, f"where {name_of(own)} acts", changed)


def _without_halves(component: sp.Expr) -> sp.Expr:
    """l/2 as l, in every term that has a factor 1/2."""
    terms = sp.Add.make_args(sp.expand(component))
    return sp.Add(*(2 * x if abs(x.as_coeff_Mul()[0]) == sp.Rational(1, 2) else x for x in terms))


def force_doubled(m: Mechanics) -> Iterator[Variation]:
    """A force twice or half as large."""
    yield from _each_kind(m, sp.Integer(2), "for {} twice as large", "the factor of {}")
    yield from _each_kind(m, sp.Rational(1, 2), "for {} half as large", "the factor of {}")
    for kind in (AppliedForceKind.SPRING, AppliedForceKind.POTENTIAL):
        for factor, how in (
            (sp.Integer(4), "four times as large, as for twice"),
            (sp.Rational(1, 4), "a quarter as large, as for half"),
        ):
            clause = f"for {{}} {how} the displacement"
            yield from _all_and_each(m, m.of_kind(kind), factor, clause, "the displacement in {}")


def _each_kind(m: Mechanics, factor: sp.Expr, clause: str, place: str) -> Iterator[Variation]:
    for kind in AppliedForceKind:
        if kind not in (AppliedForceKind.QUASI, AppliedForceKind.FRICTION, AppliedForceKind.LAGRANGIAN):
            yield from _all_and_each(m, m.of_kind(kind), factor, clause, place)


def _all_and_each(
    m: Mechanics, forces: Sequence[ForceShare], factor: sp.Expr, clause: str, place: str
) -> Iterator[Variation]:
    for f in forces:
        name = name_of(f)
        yield Variation(clause.format(name), place.format(name), m.scaled([f], factor))
    if len(forces) > 1:
        *others, last = map(name_of, forces)
        name = f"{', '.join(others)} and {last}"
        yield Variation(clause.format(name), place.format(name), m.scaled(forces, factor))


def spring_by_length(m: Mechanics) -> Iterator[Variation]:
    """A spring pulls with k d and not with k (d − l)."""
    springs = [s for s in m.configuration.springs if s.length != 0]
    for group in (*([s] for s in springs), *([springs] if len(springs) > 1 else ())):
        names = [s.name for s in group]
        listed = ", ".join(map(called, names))
        clause = f"for a force of the spring {listed} proportional to its length and not to its extension"
        shares = {s.name: _spring_shares(replace(s, length=sp.S.Zero), m) for s in group}
        yield Variation(
            clause, f"the extension of the spring {listed}", _with_shares(m, AppliedForceKind.SPRING, shares)
        )
    yield from _potential_by_length(m)


def _potential_by_length(m: Mechanics) -> Iterator[Variation]:
    """The same of a spring given by its energy, k (x − a)²/2: k x²/2."""
    for f in m.of_kind(AppliedForceKind.POTENTIAL):
        pulls = [s for s in f.shares if s != 0]
        letters = sorted({s for p in pulls for s in p.free_symbols} - {*m.slots.coordinates}, key=str)
        for a in letters:
            without = tuple(s.xreplace({a: sp.S.Zero}) for s in f.shares)
            linear = all(p.is_polynomial(a) and sp.degree(sp.expand(p), a) == 1 for p in pulls)
            if (
                linear
                and not any(p.coeff(a).has(t) for p in map(sp.expand, pulls))
                and all(w != 0 for w, s in zip(without, f.shares, strict=True) if s != 0)
            ):
                clause = (
                    f"for a force of {called(f.name)} proportional to the length and not to the extension ({a} missing)"
                )
                yield Variation(
                    clause,
                    f"the extension in {called(f.name)}",
                    _with_shares(m, AppliedForceKind.POTENTIAL, {f.name: without}),
                )


def angle_from_elsewhere(m: Mechanics) -> Iterator[Variation]:
    """The weight's potential as if an angle were measured from another direction."""
    loads = [f for f in m.configuration.loads if f.name == "weight"]
    points = {p.name: p.position.fixed() for p in m.configuration.points}
    waves = {w.args[0] for f in loads for c in points[f.on].components for w in c.atoms(sp.sin, sp.cos)}
    waves |= {w.args[0] for f in loads for c in f.vector.fixed().components for w in c.atoms(sp.sin, sp.cos)}
    angles = sorted((a for a in waves if a.is_Symbol), key=str)
    quarter = sp.pi / 2
    for q in angles:
        for meant, how in (
            (quarter - q, "from the perpendicular direction (sine and cosine)"),
            (q + quarter, "from the perpendicular direction (sine and cosine, with a sign)"),
            (q - quarter, "from the perpendicular direction (sine and cosine, with a sign)"),
            (sp.pi - q, "from the opposite direction"),
            (-q, "the other way"),
        ):
            shares = {}
            for f in loads:
                rule = {q: meant}
                vector = f.vector.fixed().xreplace(rule)
                moved = replace(f, vector=vector)
                shares[f.on] = weight_shares(moved, points[f.on].xreplace(rule), m.slots)
            clause = f"for a weight whose potential has {q} measured {how}"
            changed = m.force(
                lambda f, s=shares: replace(f, shares=s[f.on[0]]) if f.kind is AppliedForceKind.WEIGHT else f  # type: ignore[misc]
            )
            yield Variation(clause, f"how {q} enters the potential energy", changed)


def gravity_turned(m: Mechanics) -> Iterator[Variation]:
    """An angle measured from the perpendicular direction, in the weight and in the normal force of its friction."""
    weights = m.of_kind(AppliedForceKind.WEIGHT)
    frictions = m.of_kind(AppliedForceKind.FRICTION)
    if not frictions or not weights:
        return
    loads = [w.vector.fixed() for w in m.configuration.loads if w.name == "weight"]
    pulls = {s for vector in loads for c in vector.components for s in c.free_symbols}
    heavy = pulls - {s for i in m.inertias for w in i.weights for s in w.free_symbols}
    for sign in (1, -1):
        changed = {w: tuple(sign * _with_waves_exchanged(s) for s in w.shares) for w in weights}
        for f in frictions:
            changed[f] = tuple(_with_heavy_waves_exchanged(s, heavy) for s in f.shares)
        if all(changed[f] == f.shares for f in frictions):
            continue
        system = m.force(lambda f, c=changed: replace(f, shares=c[f]) if f in c else f)  # type: ignore[misc]
        clause = "with sine and cosine exchanged in the weight, in the normal force of the friction as well"
        yield Variation(clause, "from which direction the angle is measured", system)


def _with_heavy_waves_exchanged(share: sp.Expr, heavy: set[sp.Symbol]) -> sp.Expr:
    terms = sp.Add.make_args(sp.expand(share))
    return sp.Add(*(_with_waves_exchanged(x) if x.free_symbols & heavy else x for x in terms))


def components_exchanged(m: Mechanics) -> Iterator[Variation]:
    """Sine and cosine exchanged where forces are resolved into components."""
    for kind in (AppliedForceKind.WEIGHT, AppliedForceKind.FORCE):
        forces = m.of_kind(kind)
        names = {f.name for f in forces}
        loads = [load for load in m.configuration.loads if load.name in names]
        resolved = any(c.has(sp.sin, sp.cos) for load in loads for c in load.vector.fixed().components)
        where = "components" if resolved else "lever arm"
        for group in (forces, *([f] for f in forces if len(forces) > 1)):
            changed = {f: tuple(_with_waves_exchanged(s) for s in f.shares) for f in group}
            if all(shares == f.shares for f, shares in changed.items()):
                continue
            what = "weight" if kind is AppliedForceKind.WEIGHT else "force"
            of = ", ".join(name_of(f) for f in group) if len(forces) > 1 and len(group) == 1 else f"the {what}"
            clause = f"with sine and cosine exchanged in the {where} of {of}"
            system = m.force(lambda f, c=changed: replace(f, shares=c[f]) if f in c else f)  # type: ignore[misc]
            place = f"how {of} is resolved into components" if resolved else f"the lever arm of {of}"
            yield Variation(clause, place, system)


def _with_waves_exchanged(share: sp.Expr) -> sp.Expr:
    waves = share.atoms(sp.sin, sp.cos)
    return share.xreplace({w: (sp.cos if isinstance(w, sp.sin) else sp.sin)(w.args[0]) for w in waves})


def coupling_left_out(m: Mechanics) -> Iterator[Variation]:
    """In the equation of each coordinate springs act as if the other coordinates were zero."""
    coordinates = m.slots.coordinates
    springs = m.of_kind(AppliedForceKind.SPRING, AppliedForceKind.POTENTIAL)
    changed = {}
    for f in springs if len(coordinates) > 1 else ():
        alone = tuple(
            share.xreplace({p: sp.S.Zero for p in coordinates if p != q})
            for q, share in zip(coordinates, f.shares, strict=True)
        )
        if alone != f.shares and not any(s.has(sp.nan, sp.zoo) for s in alone):
            changed[f] = alone
    for group in (*([f] for f in changed), *([[*changed]] if len(changed) > 1 else ())):
        own = {f: changed[f] for f in group}
        names = ", ".join(called(f.name) for f in own)
        clause = f"without the coupling of the coordinates by {names}, each as if the others were zero"
        system = m.force(lambda f, own=own: replace(f, shares=own[f]) if f in own else f)  # type: ignore[misc]
        yield Variation(clause, f"{names}: it couples the coordinates", system)


def on_what_is_carried(m: Mechanics) -> Iterator[Variation]:
    """A spring that is fastened to something, taken as fastened to what that carries."""
    coordinates = m.slots.coordinates
    for f in m.of_kind(AppliedForceKind.POTENTIAL):
        pulled = [k for k, s in enumerate(f.shares) if s != 0]
        if len(pulled) != 1 or f.shares[pulled[0]].free_symbols & ({*coordinates} - {coordinates[pulled[0]]}):
            continue
        [k] = pulled
        q = coordinates[k]
        for point in m.configuration.points:
            for place in point.position.fixed().components:
                rest = sp.expand(place - q)
                if q in rest.free_symbols or rest.free_symbols.isdisjoint(coordinates):
                    continue
                pull = f.shares[k].xreplace({q: place})
                shares = tuple(pull * partial(place, p) for p in coordinates)
                changed = m.force(lambda g, f=f, s=shares: replace(g, shares=s) if g is f else g)  # type: ignore[misc]
                clause = f"for {name_of(f)} acting on {called(point.name)}"
                yield Variation(clause, f"where {name_of(f)} acts", changed)


def direction_kept(m: Mechanics) -> Iterator[Variation]:
    """A force that turns with a body, as if it kept the direction that it has where the coordinates are zero."""
    at_zero: dict[sp.Basic, sp.Basic] = dict.fromkeys(m.slots.coordinates, sp.S.Zero)
    for load in m.configuration.loads:
        vector = load.vector.fixed()
        turning = {w for c in vector.components for w in c.atoms(sp.sin, sp.cos)}
        turning = {w for w in turning if not w.free_symbols.isdisjoint(at_zero)}
        own = [f for f in m.of_kind(AppliedForceKind.FORCE) if (f.name, f.on) == (load.name, (load.on,))]
        if not turning or len(own) != 1:
            continue
        kept = replace(load, vector=vector.xreplace({w: w.xreplace(at_zero) for w in turning}))
        shares = tuple(share_of_load(kept, v, m.configuration) for v in m.slots.velocities)
        changed = m.force(lambda f, own=own, s=shares: replace(f, shares=s) if f is own[0] else f)  # type: ignore[misc]
        clause = f"for {name_of(own[0])} keeping its direction, as if it did not turn"
        yield Variation(clause, f"the direction of {name_of(own[0])}", changed)


def support_at_rest(m: Mechanics) -> Iterator[Variation]:
    """A force of a spring or damper with one end on a support that is shaken, as if the support were fixed."""
    for f in (f for f in m.forces if f.kind is not AppliedForceKind.QUASI):
        moving = {w: sp.S.Zero for s in f.shares for w in s.atoms(sp.sin, sp.cos) if t in w.args[0].free_symbols}
        shares = tuple(s.xreplace(moving) for s in f.shares)
        if moving and any(s != 0 for s in shares) and m.slots.coordinates:
            clause = f"for {name_of(f)} as if the support did not move"
            yield Variation(
                clause,
                f"{name_of(f)}: it depends on the motion relative to the support",
                m.force(lambda g, f=f, s=shares: replace(g, shares=s) if g is f else g),  # type: ignore[misc]
            )


def in_the_wrong_equation(m: Mechanics) -> Iterator[Variation]:
    """Generalized forces in one another's equations."""
    n = len(m.slots.coordinates)
    given = [f for f in m.forces if not f.conservative and f.kind is not AppliedForceKind.QUASI]
    if not given or n > 4:
        return
    for order in permutations(range(n)):
        if sum(a != b for a, b in enumerate(order)) == 2:
            places = [str(m.slots.coordinates[k]) for k, j in enumerate(order) if k != j]
            for group in (given, *([f] for f in given if len(given) > 1)):
                names = ", ".join(map(name_of, group))
                clause = f"with {names} in the wrong equation: those of {' and '.join(places)} are exchanged"
                place = f"the equation in which {names} belongs"
                moved = m.force(
                    lambda f, g=group, o=order: replace(f, shares=tuple(f.shares[k] for k in o)) if f in g else f  # type: ignore[misc]
                )
                yield Variation(clause, place, moved)


def on_one_end(m: Mechanics) -> Iterator[Variation]:
    """A spring or damper that acts on one of its ends only, or all that join two bodies: action without reaction."""
    each = list(_on_one_end(m))
    yield from (v for _, v in each)
    for body in dict.fromkeys(body for body, _ in each):
        own = [v.mechanics for b, v in each if b == body and v.mechanics is not None]
        if len(own) > 1:
            changed = {f.name: f for v in own for f, g in zip(v.forces, m.forces, strict=True) if f != g}
            together = m.force(lambda f, c=changed: c.get(f.name, f))  # type: ignore[misc]
            names = " and ".join(map(called, changed))
            clause = f"with {names} acting on {called(body)} only, and not on their other ends"
            yield Variation(clause, f"both ends of {names}", together)


def _on_one_end(m: Mechanics) -> Iterator[tuple[str, Variation]]:
    points = {p.name: p.position.fixed() for p in m.configuration.points}
    for link in m.configuration.links:
        ends = [e for e in link.ends if isinstance(e, str)]
        if len(ends) < 2:
            continue
        kind = AppliedForceKind.SPRING if isinstance(link, StretchedSpring) else AppliedForceKind.DAMPER
        apart = link.apart.fixed()
        for n, end in enumerate(ends):
            sign = 1 if n == 0 else -1
            shares = tuple(
                sign * _pull(link, m) * apart.dot(points[end].map(lambda c, q=q: sp.diff(c, q)))  # type: ignore[misc]
                for q in m.slots.coordinates
            )
            clause = f"with {_NAMES[kind]} {called(link.name)} acting on {called(end)} only, and not on its other end"
            changed = _with_shares(m, kind, {link.name: shares})
            yield end, Variation(clause, f"both ends of {_NAMES[kind]} {called(link.name)}", changed)


def _pull(link: StretchedSpring | DamperForce, m: Mechanics) -> sp.Expr:
    """The force on the first end over the vector from the second to it."""
    apart = link.apart.fixed()
    if isinstance(link, StretchedSpring):
        return -link.stiffness * (1 if link.length == 0 else 1 - link.length / link.distance)
    return -link.coefficient * apart.dot(apart.time_derivative(m.slots)) / apart.dot(apart)


def against_the_ground(m: Mechanics) -> Iterator[Variation]:
    """A spring or damper between two moving points, as if it were fixed to the ground at one end, or one at each."""
    points = {p.name: p.position.fixed() for p in m.configuration.points}
    for link in m.configuration.links:
        ends = [e for e in link.ends if isinstance(e, str)]
        kind = AppliedForceKind.SPRING if isinstance(link, StretchedSpring) else AppliedForceKind.DAMPER
        name = f"{_NAMES[kind]} {called(link.name)}"
        place = f"{name}: it depends on the motion of one end relative to the other"
        alone = [_grounded(link, points[e], m) for e in ends]
        if len(ends) < 2:
            continue
        for end, shares in zip(ends, alone, strict=True):
            clause = f"for {name} acting between {called(end)} and the ground"
            yield Variation(clause, place, _with_shares(m, kind, {link.name: shares}))
        both = tuple(a + b for a, b in zip(*alone, strict=True))
        yield Variation(
            f"for {name} acting between the ground and each of its ends",
            place,
            _with_shares(m, kind, {link.name: both}),
        )


def _grounded(link: StretchedSpring | DamperForce, position: Vector, m: Mechanics) -> tuple[sp.Expr, ...]:
    if isinstance(link, StretchedSpring):
        return _spring_shares(replace(link, apart=position, length=sp.S.Zero), m)
    alone = replace(link, apart=position)
    return tuple(share_of_damper(alone, v, m.slots) for v in m.slots.velocities)


def other_normal_force(m: Mechanics) -> Iterator[Variation]:
    """Friction μ N with N = m g, with the component of the weight alone, or with N at rest."""
    for f in m.frictions:
        for normal, why in _normal_forces(f, m):
            shares = [sp.S.Zero] * len(m.slots.coordinates)
            for load in f.loads(normal):
                own = [share_of_load(load, v, m.configuration) for v in m.slots.velocities]
                shares = [a + b for a, b in zip(shares, own, strict=True)]
            clause = f"for friction with the normal force {written(normal, m.slots)}{why}"
            others = [g for g in m.of_kind(AppliedForceKind.FRICTION) if g.name != f.friction.name]
            ons = [g.on for g in m.of_kind(AppliedForceKind.FRICTION) if g.name == f.friction.name]
            if not ons:
                continue
            own_force = ForceShare(AppliedForceKind.FRICTION, f.friction.name, tuple(shares), False, ons[0])
            rest = tuple(g for g in m.forces if g.kind is not AppliedForceKind.FRICTION)
            place = "the normal force in the friction"
            yield Variation(clause, place, replace(m, forces=(*rest, *others, own_force)))
    if len(m.frictions) > 1:
        yield from _all_normal_forces(m)


def _all_normal_forces(m: Mechanics) -> Iterator[Variation]:
    """The same for all friction forces together."""
    rest = tuple(g for g in m.forces if g.kind is not AppliedForceKind.FRICTION)
    for kinds in zip(*(list(_normal_forces(f, m)) for f in m.frictions), strict=False):
        forces = []
        for f, (normal, _) in zip(m.frictions, kinds, strict=True):
            for load in f.loads(normal):
                own = tuple(share_of_load(load, v, m.configuration) for v in m.slots.velocities)
                forces.append(ForceShare(AppliedForceKind.FRICTION, load.name, own, False, (load.on,)))
        sizes = " and ".join(dict.fromkeys(written(normal, m.slots) for normal, _ in kinds))
        several = "s" if " and " in sizes else ""
        whole = ", the whole weight" if kinds[0][1] == _WHOLE else f", the component{several} of the weight alone"
        clause = f"for friction with the normal force{several} {sizes}{whole}"
        yield Variation(clause, "the normal force in the friction", replace(m, forces=(*rest, *forces)))


_WHOLE = ", the whole weight"


def _normal_forces(f: FrictionForce, m: Mechanics) -> Iterator[tuple[sp.Expr, str]]:
    configuration = m.configuration
    weight = next((w for w in configuration.loads if w.name == "weight" and w.on == f.friction.on), None)
    if weight is None:
        return
    direction = f.reaction.per_unit(f.friction.on)
    if direction is not None:
        unit = direction.fixed().map(configuration.rewritten)
        size = unit.dot(unit)
        along = weight.vector.fixed().dot(unit) / sp.sqrt(textbook_form(size))
        for sign in (-1, 1):
            yield textbook_form(sign * along), ", the weight's component alone"
    force = weight.vector.fixed()
    size = sp.powdenest(sp.sqrt(textbook_form(sp.Add(*(c**2 for c in force.components)))), force=True)
    yield size, _WHOLE


def _spring_shares(spring: StretchedSpring, m: Mechanics) -> tuple[sp.Expr, ...]:
    return tuple(share_of_spring(spring, q) for q in m.slots.coordinates)


def _with_shares(m: Mechanics, kind: AppliedForceKind, shares: dict[str, tuple[sp.Expr, ...]]) -> Mechanics:
    return m.force(lambda f: replace(f, shares=shares[f.name]) if f.kind is kind and f.name in shares else f)
