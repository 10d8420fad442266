"""Mistakes in kinematics: what coordinates, quasi-velocities and angular velocities are.

Mistakes in the meaning of letters: the right equations of the problem, with something else meant by a letter.

Quasi-velocities mistaken for velocities of coordinates.

In quasi-velocities u_s, with q_k' = Σ B_ks u_s + b_k, the equations of motion are not Lagrange's in the u_s but

    d/dt ∂T*/∂u_s − Σ_k B_ks ∂T*/∂q_k + (terms with products of the u)  =  Σ_k B_ks Q_k ,

with T* = T in terms of the u (Boltzmann, Hamel). What is usually lost are the terms with products, Euler's
(C − B) q r among them and the centripetal a ω² of a sleigh: they are what Σ_k B_ks (d/dt ∂T/∂q_k' − ∂T/∂q_k) has beyond
the first two terms, and are never written out here.

Mistakes in how fast a body turns: ω of a body that rolls, or is carried round, in terms of the motion of its centre.

A wheel that rolls in a ring turns by (R/r − 1) φ' and not by R/r φ', since the line of centres turns as well; a body
that is carried by an arm turns with it, and its own angle may be counted from the arm. So a rate q_i' with which its
centre is carried round is added to its angular velocity, or omitted. A wheel that rolls on another moving one turns
twice as fast as if it rolled on the ground. The work of moments on the body changes with its angular velocity.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations, pairwise, permutations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.limits import MOST_MULTIPLIED
from lagrange.answers.models.mechanics import (
    AppliedForceKind,
    Inertia,
    Mechanics,
    Variation,
    VariedQuasiEquations,
    called,
    written,
)
from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import Bounded, Unspecified, base, partial, prime, t
from lagrange.core.vectors import Components, Vector
from lagrange.mechanics.dynamics.quasi_velocities import QuasiVelocities, quasi_velocities


def measured_from_elsewhere(m: Mechanics) -> Iterator[Variation]:
    """A coordinate is measured the other way, or an angle from another direction, throughout."""
    waves = {
        s
        for i in m.inertias
        for column in i.columns
        for c in column
        for w in c.atoms(sp.sin, sp.cos)
        for s in w.free_symbols
    }
    waves |= {s for f in m.forces for e in f.shares for w in e.atoms(sp.sin, sp.cos) for s in w.free_symbols}
    quarter = sp.pi / 2
    for q in m.slots.coordinates:
        place = f"from where {q} is measured, and which way"
        turned = (
            (q + sp.pi, 1),
            (sp.pi - q, -1),
            (q + quarter, 1),
            (q - quarter, 1),
            (quarter - q, -1),
            (-quarter - q, -1),
        )
        for meant, sign in ((-q, -1), *(turned if q in waves else ())):
            rule = {q: meant, prime(q): sign * prime(q), prime(q, 2): sign * prime(q, 2)}
            yield Variation(f"for {q} measured from elsewhere, {meant} in place of {q}", place, rule=rule)


def relative_for_absolute(m: Mechanics) -> Iterator[Variation]:
    """One coordinate is counted from another, or from the fixed frame where the problem counts it from another."""
    for q, p in permutations(m.slots.coordinates, 2):
        for sign, clause in (
            (-1, f"for {q} measured relative to {p}, which the problem measures from a fixed direction or point"),
            (1, f"for {q} measured from a fixed direction or point, which the problem measures relative to {p}"),
        ):
            rule = {
                q: q + sign * p,
                prime(q): prime(q) + sign * prime(p),
                prime(q, 2): prime(q, 2) + sign * prime(p, 2),
            }
            yield Variation(clause, f"from where {q} is measured", rule=rule)
    angles = [q for q in m.slots.coordinates if _turns(q, m)]
    if len(angles) > 2:
        rule = {}
        for p, q in pairwise(angles):
            rule |= {q: q - p} | {prime(q, order): prime(q, order) - prime(p, order) for order in (1, 2)}
        names = ", ".join(map(str, angles[1:]))
        clause = f"for each of {names} measured relative to the one before it, and not from a fixed direction"
        yield Variation(clause, f"from where {names} are measured", rule=rule)


def _turns(q: sp.Symbol, m: Mechanics) -> bool:
    """Whether the position of something depends on a sine or cosine of a coordinate."""
    return any(q in w.free_symbols for p in m.configuration.points for w in _waves(p.position.fixed()))


def _waves(position: Vector) -> set[sp.Basic]:
    return {w for c in position.components for w in c.atoms(sp.sin, sp.cos)}


def relative_velocities(m: Mechanics) -> Iterator[Variation]:
    """In a velocity, a direction at the angle theta + psi taken to turn with psi' alone."""
    slots = m.slots
    places = {p.name: p.position.fixed() for p in m.configuration.points}
    for i, q in enumerate(slots.coordinates):
        changed = []
        for part in m.particles:
            position = places.get(part.name)
            sums = [w for w in _waves(position) if _is_sum_with(w, q, m)] if position is not None else []
            if position is None or not sums:
                continue
            held = sp.Dummy()
            frozen = position.xreplace({w: w.xreplace({q: held}) for w in sums})
            column = frozen.map(lambda c, q=q: partial(c, q)).xreplace({held: q})  # type: ignore[misc]
            changed.append(
                (part, replace(part, columns=(*part.columns[:i], column.components, *part.columns[i + 1 :])))
            )
        for group in (*([one] for one in changed), *([changed] if len(changed) > 1 else ())):
            names = ", ".join(called(part.name) for part, _ in group)
            rule = dict(group)
            yield Variation(
                f"with relative for absolute angular velocities, without {prime(q)}, in the velocity of {names}",
                f"the velocity of {names}",
                m.inertia(lambda part, rule=rule: rule.get(part, part)),  # type: ignore[misc]
            )


def _is_sum_with(wave: sp.Basic, q: sp.Symbol, m: Mechanics) -> bool:
    """Whether the argument of a sine or cosine is a sum of q and other coordinates."""
    return q in wave.free_symbols and len(wave.free_symbols & {*m.slots.coordinates}) > 1


def complement(m: Mechanics) -> Iterator[Variation]:
    """A constant angle for its complement."""
    angles = [a for a in _parameters(m) if _is_angle(a, m)]
    for a in angles:
        yield Variation(f"with 90° - {a} in place of {a} throughout", f"the angle {a}", rule={a: sp.pi / 2 - a})
    if len(angles) > 1:
        names = " and ".join(map(str, angles))
        clause = f"with sine and cosine of {names} exchanged throughout"
        yield Variation(clause, f"the angles {names}", rule={a: sp.pi / 2 - a for a in angles})


def exchanged(m: Mechanics) -> Iterator[Variation]:
    """Two parameters or two coordinates exchanged throughout, or all with the indices 1 and 2."""
    parameters = _parameters(m)
    for a, b in combinations(parameters, 2):
        if not m.may_be_exchanged(a, b):
            continue
        yield Variation(f"with {a} and {b} exchanged", f"where {a} and {b} belong", rule={a: b, b: a})
    angles = _in_waves(m)
    for q, p in combinations(m.slots.coordinates, 2):
        if (q in angles) != (p in angles):
            continue  # an angle and a length are not taken for one another
        rule = {q: p, p: q}
        for order in (1, 2):
            rule |= {prime(q, order): prime(p, order), prime(p, order): prime(q, order)}
        yield Variation(f"with {q} and {p} exchanged", f"where {q} and {p} belong", rule=rule)
    for first, second in (("1", "2"), ("2", "3"), ("1", "3")):
        by_name = {s.name: s for s in parameters}
        rule = {}
        for name, s in by_name.items():
            if first in name and name.replace(first, second) in by_name:
                other = by_name[name.replace(first, second)]
                rule |= {s: other, other: s}
        if len(rule) > 2:
            clause = f"with the indices {first} and {second} of the parameters exchanged"
            yield Variation(clause, f"the indices {first} and {second}", rule=rule)


def _in_waves(m: Mechanics) -> set[sp.Symbol]:
    """The symbols in sines and cosines."""
    columns = [c for i in m.inertias for column in i.columns for c in column]
    shares = [s for f in m.forces for s in f.shares]
    rows = [a for row in m.configuration.rows for a in row.coefficients]
    return {s for e in (*columns, *shares, *rows) for w in e.atoms(sp.sin, sp.cos) for s in w.free_symbols}


def left_out(m: Mechanics) -> Iterator[Variation]:
    """A parameter or prescribed motion is missing: these are the equations of the special case in which it is zero."""
    for u in m.slots.prescribed:
        rates = {prime(u): sp.S.Zero, prime(u, 2): sp.S.Zero}
        yield Variation(f"for a constant {u}: {u}' is zero in them", f"{u}, which changes in time", values=rates)
        yield Variation(f"without {u}", f"{u}", values={u: sp.S.Zero, **rates})
    for a in _parameters(m):
        yield Variation(f"without {a}, as if {a} = 0", f"{a}", values={a: sp.S.Zero})


def doubled(m: Mechanics) -> Iterator[Variation]:
    """A parameter is taken twice or half as large throughout: the diameter for the radius, the whole for the half."""
    for a in _parameters(m):
        for factor, stands in ((sp.Rational(1, 2), f"2*{a}"), (sp.Integer(2), f"{a}/2")):
            yield Variation(f"with {stands} in place of {a} throughout", f"what {a} is", rule={a: factor * a})


def multiplied(m: Mechanics) -> Iterator[Variation]:
    """A parameter multiplied or divided by another throughout, as where an inner derivative is forgotten."""
    parameters = _parameters(m)
    for a, b in permutations(parameters, 2) if len(parameters) <= MOST_MULTIPLIED else ():
        if not _is_angle(a, m) and not _is_angle(b, m):
            for factor, stands in ((b, f"{a}/{b}"), (1 / b, f"{a}*{b}")):
                yield Variation(f"with {stands} in place of {a} throughout", f"what {a} is", rule={a: factor * a})


def surface_at_rest(m: Mechanics) -> Iterator[Variation]:
    """A moving surface, f(x − u t, y, z) = c, is treated as fixed: f(x, y, z)."""
    entries = [e for row in m.configuration.rows for e in row.coefficients]
    moved = sorted({f for e in entries for f in e.atoms(Unspecified) if any(a.has(t) for a in f.arguments)}, key=str)
    rule: dict[sp.Basic, sp.Basic] = {}
    for f in moved:
        held = [a.xreplace({t: sp.S.Zero}) for a in f.arguments]
        rule[f.func(*f.args[:3], *held)] = f
    if rule:
        changes = [(a.xreplace({t: sp.S.Zero}), a) for a in moved[0].arguments if a.has(t)]
        words = ", ".join(f"{written(a, m.slots)} for {written(b, m.slots)}" for a, b in changes)
        clause = f"for a surface that does not move ({words} in {moved[0].name})"
        yield Variation(clause, f"the arguments of {moved[0].name}: the surface moves", rule=rule)


def sum_of_lengths(m: Mechanics) -> Iterator[Variation]:
    """R + r for R - r throughout: a parameter has the wrong sign in positions and rolling conditions."""
    places = {s for i in m.inertias for column in i.columns for c in column for s in c.free_symbols}
    for a in _parameters(m):
        if a in places:
            clause = f"with the wrong sign of {a} throughout, a sum for a difference"
            yield Variation(clause, f"the sign of {a}", rule={a: -a})


def one_for_another(m: Mechanics) -> Iterator[Variation]:
    """One parameter is used for another throughout."""
    for a, b in permutations(_parameters(m), 2):
        if not m.may_be_exchanged(a, b):
            continue
        yield Variation(f"with {b} in place of {a} throughout", f"where {a} and {b} belong", values={a: b})


def length_for_coordinate(m: Mechanics) -> Iterator[Variation]:
    """A variable length, such as that of a spring, is treated as given in one of the equations."""
    units = dict(m.units)
    lengths = [p for p in _parameters(m) if units.get(p) in ("m", "cm", "mm", "ft")]
    for q in m.slots.coordinates:
        rates = {prime(q): sp.S.Zero, prime(q, 2): sp.S.Zero}
        for p in lengths if q in _scales(m) else ():
            yield Variation(f"with {p} in place of {q}, as if that did not change", f"{q}", values={q: p, **rates})


def _scales(m: Mechanics) -> set[sp.Symbol]:
    """The coordinates that multiply a velocity in T, as a radius does."""
    columns = [c for i in m.inertias for column in i.columns for c in column]
    waves = {s for c in columns for w in c.atoms(sp.sin, sp.cos) for s in w.free_symbols}
    return {*m.slots.coordinates} & {s for c in columns for s in c.free_symbols} - waves


def _parameters(m: Mechanics) -> list[sp.Symbol]:
    moving = {*m.slots.coordinates, *m.slots.prescribed, t}
    weights = [w for i in m.inertias for w in i.weights]
    columns = [c for i in m.inertias for column in i.columns for c in column]
    shares = [s for f in m.forces for s in f.shares]
    used = set().union(*(e.free_symbols for e in (*weights, *columns, *shares)))
    return sorted((s for s in used if base(s) not in moving), key=str)


def _is_angle(a: sp.Symbol, m: Mechanics) -> bool:
    """Whether a parameter occurs in a sine or cosine."""
    places = [c for p in m.configuration.points for c in p.position.fixed().components]
    vectors = [c for f in m.configuration.loads for c in f.vector.fixed().components]
    turning = [c for r in m.rotations for column in r.columns for c in column]
    return isinstance(a, Bounded) or any(
        a in w.free_symbols for e in (*places, *vectors, *turning) for w in e.atoms(sp.sin, sp.cos, sp.tan)
    )


# Quasi-velocities


def products_left_out(m: Mechanics) -> Iterator[Variation]:
    """The terms with products of quasi-velocities are omitted, or have the wrong sign or factor."""
    if not m.speeds or m.of_kind(AppliedForceKind.QUASI):
        return
    try:
        speeds = quasi_velocities(m.speeds, m.configuration)
    except ProblemError:
        return
    names = ", ".join(u.name for u in speeds.definitions)
    place = f"the terms with products of {names}, which are no velocities of coordinates"
    groups = [(m.inertias, "")]
    if m.particles and m.rotations:
        groups += [
            (m.rotations, " in the equations of the rotation"),
            (m.particles, " in the equations of the mass centres"),
        ]
    equations = [(parts, where, _kinetic(m, parts, speeds)) for parts, where in groups]
    for factor, how in _FACTORS:
        for parts, where, kinetic in equations:
            clause = f"{how} the terms with products of {names}{where}"
            if factor == 0:
                clause += ": Lagrange's equations do not hold in quasi-velocities as they do in velocities"
            yield Variation(clause, place, m, quasi=VariedQuasiEquations(parts, kinetic, speeds.partials, factor))


_FACTORS = (
    (sp.S.Zero, "without"),
    (sp.S.NegativeOne, "with the wrong sign of"),
    (sp.Rational(1, 2), "with one half of"),
    (sp.Integer(2), "with twice"),
)


def _kinetic(m: Mechanics, parts: Sequence[Inertia], speeds: QuasiVelocities) -> tuple[sp.Expr, ...]:
    """d/dt ∂T*/∂u_s − Σ_k B_ks ∂T*/∂q_k in the velocities and accelerations of the coordinates."""
    slots, own = m.slots, speeds.slots.velocities
    rates = [speeds.rates[v] for v in slots.velocities] + [sp.S.One]
    energy = sp.S.Zero
    for part in parts:
        for a, weight in enumerate(part.weights):
            along = sp.Add(*(c[a] * rate for c, rate in zip(part.columns, rates, strict=True)))
            energy += part.factor * weight * along**2 / 2
    meant = {prime(u): e for u, e in speeds.definitions.items()}
    slopes = [partial(energy, q).xreplace(meant) for q in slots.coordinates]
    equations = []
    for s, u in enumerate(own):
        momentum = sp.diff(energy, u).xreplace(meant)
        gradient = sp.Add(*(row[s] * slope for row, slope in zip(speeds.partials, slopes, strict=True)))
        equations.append(slots.time_derivative(momentum) - gradient)
    return tuple(equations)


# Rolling and being carried round


def turning_otherwise(m: Mechanics) -> Iterator[Variation]:
    """The angle of a body that is carried round is counted from the line to its centre, or that rate is omitted."""
    for r, axis in _about_one_axis(m):
        place = f"the angular velocity of {called(r.name)}"
        for i in carried_round_by(r, m):
            v = m.slots.velocities[i]
            for sign, words in ((1, f"{v} added to"), (-1, f"{v} subtracted from")):
                turned = replace(r, columns=added(r, i, axis, sign))
                clause = f"with {words} the angular velocity of {called(r.name)}, as if its angle were counted from"
                clause = f"{clause} the line to its centre"
                if is_zero(turned.columns[i][axis]) is True:
                    clause = f"without {v} in the angular velocity of {called(r.name)}"
                yield Variation(clause, place, turning(m, r, turned))


def _about_one_axis(m: Mechanics) -> Iterator[tuple[Inertia, int]]:
    for r in m.rotations:
        axes = [a for a in range(3) if any(column[a] != 0 for column in r.columns)]
        if len(axes) == 1:
            yield r, axes[0]


def other_angular_velocity(m: Mechanics) -> Iterator[Variation]:
    """A body that turns by one angle turns faster or slower, by the rate of the line to its centre or by a factor 2."""
    yield from turning_otherwise(m)
    for r, axis in _about_one_axis(m):
        place = f"the angular velocity of {called(r.name)}"
        for i in carried_round_by(r, m):
            unit = [[sp.S.Zero] * 3 for _ in r.columns]
            unit[i][axis] = sp.S.One
            turned = replace(r, columns=tuple((c[0], c[1], c[2]) for c in unit))
            if turned.columns != r.columns:
                clause = f"for {called(r.name)} turning at the rate {m.slots.velocities[i]} of the line to its centre"
                yield Variation(clause, place, turning(m, r, turned))
        for factor, how in ((sp.Integer(2), "twice"), (sp.Rational(1, 2), "half")):
            if len(m.rotations) + len(m.particles) > 1:
                scaled = replace(r, columns=tuple(_times(factor, c) for c in r.columns))
                yield Variation(f"for {called(r.name)} turning {how} as fast", place, turning(m, r, scaled))


def moved_at_another_rate(m: Mechanics) -> Iterator[Variation]:
    """A motion prescribed by a constraint is too fast or too slow by a factor, as with a movable pulley."""
    rotating = {r.name for r in m.rotations}
    for p in m.particles if len(m.inertias) > 1 and m.configuration.expressed else ():
        attached = [f for f in m.forces if p.name in f.on]
        if p.name in rotating or any(f.kind not in OF_A_PLACE or f.on != (p.name,) for f in attached):
            continue
        for factor, how in TRANSMISSIONS:
            changed = m.inertia(lambda i, p=p, c=factor: replace(i, factor=i.factor * c**2) if i == p else i)  # type: ignore[misc]
            clause = f"for {called(p.name)} moving {how} as fast (a factor in a constraint)"
            yield Variation(clause, f"how fast {called(p.name)} moves", changed.scaled(attached, factor))


def other_transmission(m: Mechanics) -> Iterator[Variation]:
    """A constraint between two velocities with another factor or radius: what turns rolls as if on that."""
    yield from _other_constraints(m)
    for r in m.rotations:
        used = {s for column in r.columns for c in column for s in sp.denom(sp.together(c)).free_symbols}
        letters = _parameters(m)
        for lost, taken in ((a, b) for a in letters if a in used for b in letters if b != a):
            if m.may_be_exchanged(lost, taken):
                columns = tuple(_replaced(column, lost, taken) for column in r.columns)
                clause = f"with {taken} in place of {lost} in the angular velocity of {called(r.name)}"
                turned = turning(m, r, replace(r, columns=columns))
                yield Variation(clause, f"the angular velocity of {called(r.name)}", turned)


def _other_constraints(m: Mechanics) -> Iterator[Variation]:
    """q_1' = ρ q_2' with another constant ρ: a factor, or another radius.

    The velocities at a state satisfy the right constraints, so that no other equation may depend on them.
    """
    rows = m.configuration.rows
    simple = all(r.drift == 0 and r.nonlinear is None for r in rows)
    constant = all(m.slots.coordinates and not a.free_symbols & {*_moving(m)} for r in rows for a in r.coefficients)
    for j, row in enumerate(rows) if simple and constant else ():
        bound = [k for k, a in enumerate(row.coefficients) if a != 0]
        if len(bound) != 2 or not all(is_accelerated_only(k, m) for k in bound):
            continue
        k, other = bound
        a, b = (row.coefficients[i] for i in bound)
        first, second = (m.slots.velocities[i] for i in bound)
        if sp.count_ops(b / a) > sp.count_ops(a / b):
            k, other, a, b, first, second = other, k, b, a, second, first
        letters = sorted((a / b).free_symbols, key=str)
        swaps = [(p, q) for p in letters for q in _parameters(m) if p != q and m.may_be_exchanged(p, q)]
        ratios = [c * b for c, _ in TRANSMISSIONS] + [b.xreplace({p: q}) for p, q in swaps]
        for changed in dict.fromkeys(r for r in ratios if r != b):
            said = written(-changed / a * second, m.slots)
            coefficients = tuple(changed if i == other else x for i, x in enumerate(row.coefficients))
            moved = (*rows[:j], replace(row, coefficients=coefficients), *rows[j + 1 :])
            constrained = replace(m.configuration.constrained, rows=moved)
            system = replace(m, configuration=replace(m.configuration, constrained=constrained))
            yield Variation(
                f"for {first} = {said} as the constraint `{row.name}`", f"the constraint `{row.name}`", system
            )


def _moving(m: Mechanics) -> tuple[sp.Symbol, ...]:
    return (*m.slots.coordinates, *m.slots.velocities, *m.slots.prescribed, t)


def is_accelerated_only(k: int, m: Mechanics) -> bool:
    """Whether a coordinate occurs by its acceleration alone."""
    q, v = m.slots.coordinates[k], m.slots.velocities[k]
    columns = [c for i in m.inertias for column in i.columns for c in column]
    own = [c for i in m.inertias for c in i.columns[k]]
    shares = [s for f in m.forces for s in f.shares]
    still = (q, *(x for x in _moving(m) if x != q)) if any(c.free_symbols & {*_moving(m)} for c in own) else ()
    return (
        all(is_zero(s.diff(x)) is True for s in shares for x in (q, v) if x in s.free_symbols)
        and all(is_zero(c.diff(q)) is True for c in columns if q in c.free_symbols)
        and all(is_zero(c.diff(x)) is True for c in own for x in still if x in c.free_symbols)
    )


OF_A_PLACE = (AppliedForceKind.WEIGHT, AppliedForceKind.FORCE, AppliedForceKind.FRICTION)
TRANSMISSIONS = (
    (sp.Rational(1, 2), "half"),
    (sp.Integer(2), "twice"),
    (sp.Rational(1, 4), "a quarter"),
    (sp.Integer(4), "four times"),
)


def _replaced(column: Components, lost: sp.Symbol, taken: sp.Symbol) -> Components:
    a, b, c = (x.xreplace({lost: taken}) for x in column)
    return a, b, c


def carried_round_by(r: Inertia, m: Mechanics) -> Iterator[int]:
    """The angles whose change moves the centre of a body."""
    for p in m.particles:
        if p.name == r.name:
            for i in p.moving[: len(m.slots.coordinates)] if p.moving else ():
                q = m.slots.coordinates[i] if i < len(m.slots.coordinates) else None
                if q is not None and any(c.has(sp.sin(q), sp.cos(q)) for c in p.columns[i]):
                    yield i


def added(r: Inertia, index: int, axis: int, sign: int) -> tuple[Components, ...]:
    """The columns of a rotation with a rate added to, or subtracted from, the angular velocity about an axis."""
    columns = [[*c] for c in r.columns]
    columns[index][axis] += sign
    return tuple((c[0], c[1], c[2]) for c in columns)


def _times(factor: sp.Expr, column: Components) -> Components:
    a, b, c = column
    return factor * a, factor * b, factor * c


def turning(m: Mechanics, old: Inertia, new: Inertia) -> Mechanics:
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
