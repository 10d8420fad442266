"""Mistakes in the meaning of letters: the right equations of the problem, with something else meant by a letter."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, permutations

import sympy as sp

from lagrange.answers.models.mechanics import Mechanics
from lagrange.answers.models.variation import Variation, written
from lagrange.core.symbols import Bounded, Unspecified, base, prime, t


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


def complement(m: Mechanics) -> Iterator[Variation]:
    """A constant angle for its complement."""
    for a in _parameters(m):
        if _is_angle(a, m):
            yield Variation(f"with 90° - {a} in place of {a} throughout", f"the angle {a}", rule={a: sp.pi / 2 - a})


def exchanged(m: Mechanics) -> Iterator[Variation]:
    """Two parameters or two coordinates exchanged throughout, or all with the indices 1 and 2."""
    parameters = _parameters(m)
    for a, b in combinations(parameters, 2):
        if not m.may_be_exchanged(a, b):
            continue
        yield Variation(f"with {a} and {b} exchanged", f"where {a} and {b} belong", rule={a: b, b: a})
    for q, p in combinations(m.slots.coordinates, 2):
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


def left_out(m: Mechanics) -> Iterator[Variation]:
    """A parameter, or a prescribed motion, is missing: the equations of the special case in which it is zero."""
    for u in m.slots.prescribed:
        rates = {prime(u): sp.S.Zero, prime(u, 2): sp.S.Zero}
        yield Variation(f"for a constant {u}: {u}' is zero in them", f"{u}, which changes in time", values=rates)
        yield Variation(f"without {u}", f"{u}", values={u: sp.S.Zero, **rates})
    for a in _parameters(m):
        yield Variation(f"without {a}, as if {a} = 0", f"{a}", values={a: sp.S.Zero})


def surface_at_rest(m: Mechanics) -> Iterator[Variation]:
    """A surface that moves, f(x − u t, y, z) = c, is taken as fixed: f(x, y, z)."""
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
    """A length that changes, such as that of a spring, is taken for a given one in one of the equations."""
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
    return isinstance(a, Bounded) or any(
        a in w.free_symbols for e in (*places, *vectors) for w in e.atoms(sp.sin, sp.cos, sp.tan)
    )
