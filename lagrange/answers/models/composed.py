"""Mistakes in velocities that are composed: of a translation and a rotation, of what rolls and what carries it.

In the coordinates of a choice, a velocity has parts that are no longer seen in them: the centre of a rocking half
cylinder moves with x' = R θ' along the table and turns about the middle of its flat side, and T contains θ'² alone. So
positions are taken in the coordinates of the file, q_i = f_i(p), and the velocity is the sum of

    Σ_a (∂r/∂q_i) (∂f_i/∂p_a) p_a'     over i .

One of these parts may be omitted, or the product of one with the rest, as if they were at right angles.

A body that rolls on another moving one turns by the relative velocity of the two. With ω = w_s s' for the one
coordinate s that moves it along the surface, the rate w_s (J_i·J_s)/(J_s·J_s) of another coordinate q_i is what its
absolute velocity would give.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.models.kinematics import (
    OF_A_PLACE,
    TRANSMISSIONS,
    added,
    carried_round_by,
    is_accelerated_only,
    turning,
    turning_otherwise,
)
from lagrange.answers.models.kinetic import length_left_out
from lagrange.answers.models.mechanics import AppliedForceKind, Inertia, Mechanics, Variation, called
from lagrange.core.symbols import partial, prime
from lagrange.core.vectors import Components
from lagrange.mechanics.constraints.displacements import virtual_displacements

_Columns = tuple[Components, ...]


def part_left_out(m: Mechanics) -> Iterator[Variation]:
    """What one coordinate of the file contributes to a velocity is omitted, where a choice has eliminated it."""
    for p, q, own, rest in _parts(m):
        clause = f"without what {prime(q)} contributes to the velocity of {called(p.name)}"
        changed = m.inertia(lambda i, p=p, rest=rest: replace(i, columns=rest) if i == p else i)  # type: ignore[misc]
        if any(is_zero(c) is not True for column in rest for c in column) and _differ(own, rest):
            yield Variation(clause, f"the velocity of {called(p.name)}", changed)


def product_of_parts_left_out(m: Mechanics) -> Iterator[Variation]:
    """The product of two parts of a velocity is omitted, as if they were at right angles."""
    for p, q, own, rest in _parts(m):
        if not _are_oblique(own, rest):
            continue
        apart = tuple(j for i in m.inertias for j in ((_with(p, own), _with(p, rest)) if i == p else (i,)))
        clause = (
            f"as if the part of the velocity of {called(p.name)} that comes from {prime(q)} were at right angles to "
            "the rest: in its square, twice their product is missing"
        )
        yield Variation(clause, f"the square of the velocity of {called(p.name)}", replace(m, inertias=apart))


def rolling_of_absolute_velocity(m: Mechanics) -> Iterator[Variation]:
    """A body that rolls on a moving one turns as if by its velocity relative to the ground."""
    for r in m.rotations:
        axes = [a for a in range(3) if any(column[a] != 0 for column in r.columns)]
        centre = next((p for p in m.particles if p.name == r.name), None)
        if len(axes) != 1 or centre is None:
            continue
        [axis] = axes
        place = f"the angular velocity of {called(r.name)}"
        rates = [column[axis] for column in r.columns[:-1]]
        added = _by_absolute_velocity(rates, centre, r.moving)
        if added:
            columns = [[*c] for c in r.columns]
            for i, rate in added.items():
                columns[i][axis] = rate
            new = replace(r, columns=tuple((a, b, c) for a, b, c in columns))
            yield Variation(_absolutely(r.name, added, m), place, turning(m, r, new))
        yield from _by_absolute_constraint(r, centre, m)


def _by_absolute_constraint(r: Inertia, centre: Inertia, m: Mechanics) -> Iterator[Variation]:
    """The same where the angle is tied to other coordinates by a constraint that remains."""
    rows = m.configuration.rows
    for j, row in enumerate(rows):
        own = [k for k in r.moving if k < len(row.coefficients) and row.coefficients[k] != 0]
        moving = {*m.slots.coordinates, *m.slots.velocities, *m.slots.prescribed}
        constant = (
            row.drift == 0 and row.nonlinear is None and not any(a.free_symbols & moving for a in row.coefficients)
        )
        if len(own) != 1 or not constant or not is_accelerated_only(own[0], m):
            continue
        others = [i for i, a in enumerate(row.coefficients) if a != 0 and i != own[0]]
        added = _by_absolute_velocity(row.coefficients, centre, others)
        if added and not any(e.free_symbols & moving for e in added.values()):
            coefficients = tuple(added.get(i, a) for i, a in enumerate(row.coefficients))
            changed = (*rows[:j], replace(row, coefficients=coefficients), *rows[j + 1 :])
            constrained = replace(m.configuration.constrained, rows=changed)
            system = replace(m, configuration=replace(m.configuration, constrained=constrained))
            yield Variation(_absolutely(r.name, added, m), f"the angular velocity of {called(r.name)}", system)


def _by_absolute_velocity(rates: Sequence[sp.Expr], centre: Inertia, along: Sequence[int]) -> dict[int, sp.Expr]:
    """The rates that an absolute velocity adds to those of a relative one, by coordinates."""
    for s in along:
        if s >= len(rates) or not any(c != 0 for c in centre.columns[s]):
            continue
        square = _dot(centre.columns[s], centre.columns[s])
        added = {
            i: sp.cancel(rates[s] * _dot(centre.columns[i], centre.columns[s]) / square)
            for i in centre.moving
            if i < len(rates) and i != s and rates[i] == 0
        }
        return {i: rate for i, rate in added.items() if rate != 0}
    return {}


def _absolutely(name: str, added: Mapping[int, sp.Expr], m: Mechanics) -> str:
    names = " and ".join(str(m.slots.velocities[i]) for i in added)
    return (
        f"for {called(name)} turning according to its absolute velocity, {names} included, and not to its velocity "
        "relative to what it rolls on"
    )


def turning_relative_to_carrier(m: Mechanics) -> Iterator[Variation]:
    """The angle of a wheel that drives what is carried round, as if it were counted from what carries it."""
    carried = dict.fromkeys(i for r in m.rotations for i in carried_round_by(r, m))
    for r in m.rotations:
        axes = [a for a in range(3) if any(column[a] != 0 for column in r.columns)]
        own = [*carried_round_by(r, m)]
        for i in carried if len(axes) == 1 else ():
            rate = r.columns[i][axes[0]]
            if i in own or (rate == 0 and not m.configuration.rows) or is_zero(rate - 1) is True:
                continue
            v = m.slots.velocities[i]
            turned = replace(r, columns=added(r, i, axes[0], -1))
            clause = f"with {v} subtracted from the angular velocity of {called(r.name)}, as if its angle were counted"
            clause = f"{clause} from what turns at the rate {v}"
            yield Variation(clause, f"the angular velocity of {called(r.name)}", turning(m, r, turned))


def several_moved_at_another_rate(m: Mechanics) -> Iterator[Variation]:
    """What a constraint moves is too fast or too slow by a factor, with all that it carries: a movable pulley."""
    if not m.configuration.expressed:
        return
    for k, v in enumerate(m.slots.velocities):
        alike: dict[Components, list[Inertia]] = {}
        for p in m.particles:
            if any(c != 0 for c in p.columns[k]):
                alike.setdefault(p.columns[k], []).append(p)
        for group in alike.values():
            names = [p.name for p in group]
            attached = [f for f in m.forces if {*names} & {*f.on} and f.kind is not AppliedForceKind.MOMENT]
            plain = all(f.kind in OF_A_PLACE and len(f.on) == 1 for f in attached)
            if len(group) < 2 or len(group) == len(m.inertias) or not plain:
                continue
            for factor, how in TRANSMISSIONS:
                column = [tuple(factor * c for c in p.columns[k]) for p in group]
                moved = {
                    p: replace(p, columns=(*p.columns[:k], _three(iter(c)), *p.columns[k + 1 :]))
                    for p, c in zip(group, column, strict=True)
                }
                pulled = {f: _scaled_at(f.shares, k, factor) for f in attached}
                system = m.inertia(lambda i, moved=moved: moved.get(i, i))  # type: ignore[misc]
                system = system.force(lambda f, s=pulled: replace(f, shares=s[f]) if f in s else f)  # type: ignore[misc]
                listed = f"{', '.join(map(called, names[:-1]))} and {called(names[-1])}"
                clause = f"for {listed} moving {how} as fast with {v} (a factor in a constraint)"
                yield Variation(clause, f"how fast {listed} move with {v}", system)


def _scaled_at(shares: Sequence[sp.Expr], k: int, factor: sp.Expr) -> tuple[sp.Expr, ...]:
    return tuple(factor * s if i == k else s for i, s in enumerate(shares))


def offset_left_out(m: Mechanics) -> Iterator[Variation]:
    """A centre beside the line that carries it is taken to lie on it, and the body turns accordingly."""
    if not m.rotations:
        return
    for moved in length_left_out(m):
        if moved.mechanics is None:
            continue
        for turned in turning_otherwise(moved.mechanics):
            yield replace(turned, clause=f"{moved.clause}, and {turned.clause}", place=moved.place)


def _parts(m: Mechanics) -> Iterator[tuple[Inertia, sp.Symbol, _Columns, _Columns]]:
    """Each part of a velocity that an eliminated coordinate of the file contributes, and the rest."""
    expressed, slots = m.configuration.expressed, m.slots
    places = dict(m.places)
    for p in m.particles:
        position = places.get(p.name)
        if position is None:
            continue
        fixed = position.fixed()
        used = {s for c in fixed.components for s in c.free_symbols}
        for q in sorted((s for s in used if s in expressed), key=str):
            slope = fixed.map(lambda c, q=q: partial(c, q)).xreplace(dict(expressed))  # type: ignore[misc]
            rates = [*(partial(expressed[q], a) for a in slots.coordinates), slots.frozen_derivative(expressed[q])]
            own = tuple((rate * slope).components for rate in rates)
            rest = tuple(
                _three(sp.expand(a - b) for a, b in zip(whole, part, strict=True))
                for whole, part in zip(p.columns, own, strict=True)
            )
            if any(c != 0 for column in own for c in column):
                yield p, q, own, rest


def _with(p: Inertia, columns: _Columns) -> Inertia:
    return replace(p, columns=columns)


def _are_oblique(own: _Columns, rest: _Columns) -> bool:
    """Whether two parts of a velocity have products."""
    return any(is_zero(_dot(a, b)) is not True for a in own for b in rest)


def _differ(own: _Columns, rest: _Columns) -> bool:
    """Whether a part is not the whole contribution of coordinates, which other models omit."""
    return any(any(c != 0 for c in a) and any(c != 0 for c in b) for a, b in zip(own, rest, strict=True))


def _dot(a: Components, b: Components) -> sp.Expr:
    return textbook_form(sp.Add(*(x * y for x, y in zip(a, b, strict=True))))


def _three(parts: Iterator[sp.Expr]) -> Components:
    a, b, c = parts
    return a, b, c


def constraint_in_energy(m: Mechanics) -> Iterator[Variation]:
    """A constraint on velocities is substituted into T before T is differentiated."""
    configuration = m.configuration
    rows = configuration.rows
    moving = {*m.slots.coordinates}
    turning = [r for r in rows if r.finite is None and any(a.free_symbols & moving for a in r.coefficients)]
    if not turning or not configuration.constrained.is_pfaffian:
        return  # with constant coefficients it may be put into T
    elimination = virtual_displacements(configuration.constrained)
    dependent = elimination.dependent
    place = "the constraint: T must contain every velocity when it is differentiated"
    time = len(m.slots.coordinates)

    def reduced(i: Inertia) -> Inertia:
        columns = [[*c] for c in i.columns]
        for d, shares, drift in zip(dependent, elimination.solution, elimination.drift, strict=True):
            for k, share in (*zip(elimination.independent, shares, strict=True), (time, drift)):
                columns[k] = [a + share * b for a, b in zip(columns[k], i.columns[d], strict=True)]
        new = [(sp.S.Zero,) * 3 if k in dependent else (c[0], c[1], c[2]) for k, c in enumerate(columns)]
        return replace(i, columns=tuple(new))

    projected = []
    for f in m.forces:
        shares = [*f.shares]
        for d, own in zip(dependent, elimination.solution, strict=True):
            for k, share in zip(elimination.independent, own, strict=True):
                shares[k] += share * f.shares[d]
        projected.append(replace(f, shares=tuple(shares)))
    system = replace(m.inertia(reduced), forces=tuple(projected), kept=elimination.independent)
    yield Variation("if the constraint is put into T before T is differentiated", place, system)


def gradient_of_one_product_left_out(m: Mechanics) -> Iterator[Variation]:
    """What one product of velocities in T contributes to dT/dq is omitted."""
    n = len(m.slots.coordinates)
    rates = (*map(str, m.slots.velocities), "")
    products = dict.fromkeys(pair for i in m.inertias for pair in i.products)
    for a, b in products if len(products) > 1 else ():
        apart = tuple(j for i in m.inertias for j in _split(i, (a, b)))
        if b < n:
            what = f"{rates[a]}^2" if a == b else f"{rates[a]}*{rates[b]}"
            clause = f"without what the product {what} in T contributes to dT/dq"
            yield Variation(clause, f"dT/dq: T has {what}", replace(m, inertias=apart))


def _split(i: Inertia, pair: tuple[int, int]) -> tuple[Inertia, ...]:
    """A kinetic energy as its product `pair`, without dT/dq, and its others."""
    if pair not in [*i.products]:
        return (i,)
    alone = i.times({p: sp.S.Zero for p in i.products if p != pair})
    return replace(alone, gradient=sp.S.Zero), i.times({pair: sp.S.Zero})


def constraint_of_constant_direction(m: Mechanics) -> Iterator[Variation]:
    """A constraint Σ a_i q_i' = 0 is differentiated as Σ a_i q_i'' = 0, as if the a_i were constant."""
    moving = {*m.slots.coordinates}
    turning = [r for r in m.configuration.rows if any(not a.free_symbols.isdisjoint(moving) for a in r.coefficients)]
    if turning and all(r.nonlinear is None for r in m.configuration.rows):
        names = ", ".join(called(r.name) for r in turning)
        clause = (
            f"if d/dt of the constraint {names} is carried out for the velocities alone, not for their coefficients"
        )
        yield Variation(clause, f"the derivative of the constraint {names}", replace(m, is_steady=True))


def square_differentiated_without_its_two(m: Mechanics) -> Iterator[Variation]:
    """λ x in place of 2 λ x for the constraint x² + y² = l², where the equations keep the multiplier."""
    rows = m.configuration.rows
    for j, row in enumerate(rows) if m.multipliers and len(rows) == len(m.multipliers) else ():
        entries = [a for a in row.coefficients if a != 0]
        if not all(sp.factor_terms(a).as_coeff_Mul()[0] % 2 == 0 for a in entries) or row.nonlinear is not None:
            continue
        halved = replace(row, coefficients=tuple(a / 2 for a in row.coefficients), drift=row.drift / 2)
        constrained = replace(m.configuration.constrained, rows=(*rows[:j], halved, *rows[j + 1 :]))
        what = f"the reaction of {called(row.name)}"
        clause = f"with only half of {what}, as if its squares were differentiated without the 2"
        yield Variation(clause, what, replace(m, configuration=replace(m.configuration, constrained=constrained)))
