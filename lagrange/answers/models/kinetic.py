"""Mistakes in the kinetic energy and in its derivatives.

A velocity is the sum of those that each coordinate gives, v = Σ J_i q_i' + ∂r/∂t. The one that is forgotten is usually
the carried one: of the cart in the velocity of its pendulum, of the frame in that of what moves in it. Then all
products with it are missing from T. Or T has the squares, and a product is missing. Or T is right, and one of the
three ways is lost in which a product q_i' q_j' enters Lagrange's equations.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from lagrange.answers.models.mechanics import AppliedForceKind as ForceKind
from lagrange.answers.models.mechanics import (
    Inertia,
    Mechanics,
    Pair,
    Variation,
    called,
    particle,
    weight_shares,
    written,
)
from lagrange.core.symbols import base, prime, t
from lagrange.core.vectors import Components

HALF = sp.Rational(1, 2)
LINEAR = (
    "the terms of T that are linear in the velocities (Coriolis terms, or the acceleration of what moves as prescribed)"
)
"""T_1. Of a frame that turns uniformly it gives Coriolis terms, of a support that is shaken its acceleration alone."""


def frame_at_rest(m: Mechanics) -> Iterator[Variation]:
    """The prescribed motion is omitted from T."""
    time = len(m.slots.coordinates)
    moved = [i for i in m.inertias if time in i.moving]
    place = "the velocities: something moves as it is prescribed"
    if moved:
        still = m.inertia(lambda i: replace(i.without(time), explicit=sp.S.Zero))
        yield Variation(
            "for a frame, support or length that does not change: its velocity is missing from T", place, still
        )
        clause = "without the velocity of the frame or support in T"
        yield Variation(clause, place, m.inertia(lambda i: i.without(time)))
    if moved:
        others = m.inertia(lambda i: i.times({(time, time): sp.S.Zero}))
        yield Variation("without the centrifugal terms of the prescribed motion", place, others)
        mixed = m.inertia(lambda i: i.times({p: sp.S.Zero for p in i.products if time in p and p != (time, time)}))
        yield Variation(f"without {LINEAR}", place, mixed)
        for c in (sp.S.NegativeOne, HALF, sp.Integer(2)):
            scaled = m.inertia(lambda i, c=c: i.times({p: c for p in i.products if time in p and p[0] != time}))  # type: ignore[misc]
            how = "the wrong sign of" if c == -1 else f"{c} times"
            yield Variation(f"with {how} {LINEAR}", place, scaled)
        reversed_ = m.inertia(lambda i: i.times({(time, time): sp.S.NegativeOne}))
        yield Variation("with centrifugal terms of the prescribed motion of the wrong sign", place, reversed_)
    for one in moved if len(moved) > 1 else ():
        clause = f"without the velocity of the frame or support in that of {called(one.name)}"
        yield Variation(clause, place, _changed(m, one, one.without(time)))


def velocity_left_out(m: Mechanics) -> Iterator[Variation]:
    """The contribution of one coordinate to the velocity of a particle, or of everything it carries, is omitted."""
    slots = m.slots
    for i, v in enumerate(slots.velocities):
        carried = [p for p in m.particles if i in p.moving and len(p.moving) > 1]
        carriers = [p.name for p in m.particles if p.moving == (i,)]
        base = f", as if {called(carriers[0])} were at rest" if len(carriers) == 1 else ""
        for p in carried:
            place = f"the velocity of {called(p.name)}"
            clause = f"without {v} in the velocity of {called(p.name)}{base}"
            yield Variation(clause, place, _changed(m, p, p.without(i)))
        if len(carried) > 1:
            clause = f"without {v} in the velocities of what it carries along{base}"
            place = f"the velocities of {', '.join(called(p.name) for p in carried)}"
            left = m.inertia(lambda p, i=i, c=carried: p.without(i) if p in c else p)  # type: ignore[misc]
            yield Variation(clause, place, left)
        turned = [r for r in m.rotations if i in r.moving and len(r.moving) > 1]
        for r in turned:
            clause = f"without {v} in the angular velocity of {called(r.name)}"
            yield Variation(clause, f"the angular velocity of {called(r.name)}", _changed(m, r, r.without(i)))
    yield from _all_carried_left_out(m)
    yield from _component_left_out(m)
    for first, second in _index_pairs(m):
        for p in m.particles:
            others = [k for k in p.moving if k not in (first, second)]
            if {first, second} <= {*p.moving} and others:
                clause = f"without {slots.velocities[first]} and {slots.velocities[second]} in the velocity of "
                left = _changed(m, p, p.without(first).times(dict(p.without(second).pairs)))
                yield Variation(clause + called(p.name), f"the velocity of {called(p.name)}", left)


def carriers(part: Inertia, m: Mechanics) -> set[int]:
    """The coordinates that move a particle because they move another one that carries it."""
    return {i for p in m.particles if {*p.moving} < {*part.moving} for i in p.moving}


def _all_carried_left_out(m: Mechanics) -> Iterator[Variation]:
    """Each particle has the velocity of its own coordinate alone."""
    carried = {p.name: carriers(p, m) for p in m.particles}
    if sum(map(bool, carried.values())) > 1:

        def alone(p: Inertia) -> Inertia:
            for i in () if p.turning else carried[p.name]:
                p = p.without(i)
            return p

        names = ", ".join(called(n) for n, c in carried.items() if c)
        clause = f"without the velocities with which {names} are carried along, each moving as if it were alone"
        yield Variation(clause, f"the velocities of {names}", m.inertia(alone))


def _component_left_out(m: Mechanics) -> Iterator[Variation]:
    """One component of a velocity, or what one coordinate adds to one component of an angular velocity, is omitted."""
    for p in m.particles:
        axes = [a for a in range(3) if any(c[a] != 0 for c in p.columns)]
        for a in axes if len(axes) > 1 else ():
            clause = f"without the component along {'ijk'[a]} of the velocity of {called(p.name)}"
            place, lacking = f"the velocity of {called(p.name)}", _changed(m, p, _lacking(p, a, p.moving))
            yield Variation(clause, place, lacking, component=True)
    for r in m.rotations:
        for a, i in ((a, i) for a in range(3) for i in r.moving[: len(m.slots.coordinates)]):
            others = [k for k in r.moving if k != i and r.columns[k][a] != 0]
            if i < len(m.slots.coordinates) and r.columns[i][a] != 0 and others:
                v = m.slots.velocities[i]
                clause = f"without {v} in the angular velocity of {called(r.name)} about its axis {a + 1}"
                place = f"the angular velocity of {called(r.name)}"
                yield Variation(clause, place, _changed(m, r, _lacking(r, a, (i,))))


def _lacking(part: Inertia, axis: int, indices: tuple[int, ...]) -> Inertia:
    """The same without one component of some J_i."""
    columns = [[*c] for c in part.columns]
    for i in indices:
        columns[i][axis] = sp.S.Zero
    return replace(part, columns=tuple((c[0], c[1], c[2]) for c in columns))


def constant_coordinate(m: Mechanics) -> Iterator[Variation]:
    """A variable coordinate is treated as constant: its velocity and acceleration are missing."""
    for i, q in enumerate(m.slots.coordinates if len(m.slots.coordinates) > 1 else ()):
        still = m.inertia(lambda p, i=i: replace(p, still=(i,)))  # type: ignore[misc]
        yield Variation(
            f"for a constant {q}: the terms with {prime(q)} are missing", f"{q}, which changes in time", still
        )


def mass_of_another(m: Mechanics) -> Iterator[Variation]:
    """The mass of another particle, or the sum of all masses, in an energy, in one product of it, or in a weight."""
    total = sp.Add(*(p.weights[0] for p in m.particles))
    masses = {p.name: p.weights[0] for p in m.particles}
    for p in m.particles if len(m.particles) > 1 else ():
        own = masses[p.name]
        for mass in dict.fromkeys([*(other for other in masses.values() if other != own), total]):
            words = f"with the mass {written(mass, m.slots)} in place of {written(own, m.slots)} in"
            changed = _changed(m, p, replace(p, factor=mass / own))
            yield Variation(
                f"{words} the kinetic energy of {called(p.name)}", f"the kinetic energy of {called(p.name)}", changed
            )
            weights = [f for f in m.of_kind(ForceKind.WEIGHT) if f.on == (p.name,)]
            place = f"the weight of {called(p.name)}"
            yield Variation(f"{words} {place}", place, m.scaled(weights, mass / own))
            for pair in p.products if len(p.moving) > 1 else ():
                if len(m.slots.coordinates) not in pair:
                    product = _product_of(pair, m)
                    place = f"the mass that multiplies {product} in the kinetic energy"
                    changed = _changed(m, p, p.times({pair: mass / own}))
                    yield Variation(f"{words} the term with {product} of the kinetic energy", place, changed)


def product_left_out(m: Mechanics) -> Iterator[Variation]:
    """A product of two velocities, or a square, is omitted from T."""
    yield from _products(m, sp.S.Zero)


def product_scaled(m: Mechanics) -> Iterator[Variation]:
    """A product of two velocities has the wrong sign or factor in T."""
    for factor in (sp.S.NegativeOne, HALF, sp.Integer(2)):
        yield from _products(m, factor)


def _products(m: Mechanics, factor: sp.Expr) -> Iterator[Variation]:
    n = len(m.slots.coordinates)
    pairs = sorted({p for i in m.inertias for p in i.products if n not in p}, key=lambda p: (p[0] == p[1], p))
    how = {sp.S.Zero: "without the product", sp.S.NegativeOne: "with the wrong sign of the product"}
    for pair in pairs:
        if factor == -1 and pair[0] == pair[1]:
            continue  # a kinetic energy is never counted as negative: it is the sign of something else
        product = _product_of(pair, m)
        clause = how.get(factor, f"with {factor} times the product").replace(
            "product", "product" if pair[0] != pair[1] else "square"
        )
        those = [i for i in m.inertias if pair in i.products]
        if factor == 0:  # all of T of a part is omitted by other models
            those = [i for i in those if len(i.moving) > 1]
        for i in those:
            what = "the rotation of " if i.turning else ""
            place = f"the kinetic energy of {what}{called(i.name)}"
            yield Variation(f"{clause} {product} in {place}", place, _changed(m, i, i.times({pair: factor})))
        if len(those) > 1:
            place = "the kinetic energy"
            changed = m.inertia(lambda i, pair=pair: i.times({pair: factor}) if pair in i.products else i)  # type: ignore[misc]
            yield Variation(f"{clause} {product} in {place}", place, changed)


def rotation_left_out(m: Mechanics) -> Iterator[Variation]:
    """The energy of a rotation is omitted."""
    turning = m.rotations
    for r in turning:
        clause = f"without the rotational energy of {called(r.name)}"
        yield Variation(clause, f"the kinetic energy of {called(r.name)}: it turns", _changed(m, r, None))
    if len(turning) > 1:
        clause = "without the rotational energy of the bodies"
        yield Variation(clause, "the kinetic energies: the bodies turn", m.inertia(lambda i: None if i.turning else i))


RATIOS = tuple(
    sp.Rational(p, q)
    for p, q in (
        (1, 2), (2, 1), (4, 5), (5, 4), (2, 5), (5, 2), (4, 3), (3, 4), (5, 3), (3, 5), (3, 2), (2, 3), (4, 1), (1, 4),
        (1, 3), (3, 1), (1, 12), (12, 1), (1, 6), (6, 1), (5, 6), (6, 5), (1, 5), (5, 1), (8, 5), (5, 8),
    )
)  # fmt: skip
"""Moments of inertia of one standard body over that of another: 1, 1/2, 2/5, 2/3, 1/3, 1/12, 1/4 of m R²."""
BODIES = {
    sp.S.One: "a hoop",
    HALF: "a disc or solid cylinder",
    sp.Rational(2, 5): "a solid ball",
    sp.Rational(2, 3): "a spherical shell",
}


_STANDARD = frozenset(
    sp.Rational(p, q)
    for p, q in ((1, 1), (1, 2), (2, 5), (2, 3), (1, 3), (1, 12), (1, 4), (3, 2), (7, 5), (5, 3), (4, 3))
)
"""Moments of inertia over m R² or m l², of standard bodies about the centre or a point of the rim, in any length."""


def other_inertia(m: Mechanics) -> Iterator[Variation]:
    """The moment of inertia of another standard body, or about another point."""
    yield from _other_factors(m, standard=True)
    for r in m.rotations:
        yield from _about_another_point(m, r)
        yield from _about_the_end(m, r)
        if len({*r.weights} - {0}) == 2:
            yield from _moments_exchanged(m, r)
    for p in m.particles if not m.rotations else ():
        if p.moving != () and len(p.moving) == 1:
            for ratio, body in (
                (sp.Rational(1, 3), "a uniform rod about its end"),
                (sp.Rational(1, 12), "a uniform rod"),
            ):
                clause = f"with {ratio} of the moment of inertia of {called(p.name)}, as for {body}"
                changed = _changed(m, p, replace(p, factor=ratio))
                yield Variation(clause, f"the kinetic energy of {called(p.name)}", changed)


def odd_inertia(m: Mechanics) -> Iterator[Variation]:
    """A moment of inertia with a factor that no standard body has."""
    yield from _other_factors(m, standard=False)


def _other_factors(m: Mechanics, *, standard: bool) -> Iterator[Variation]:
    for r in m.rotations:
        place = f"the moment of inertia of {called(r.name)}"
        for ratio in RATIOS:
            moments = [w for w in r.weights if w != 0]
            known = not moments[0].is_Symbol and (ratio * moments[0]).as_coeff_Mul()[0] in _STANDARD
            if known is not standard:
                continue
            now = written(ratio * moments[0], m.slots) if len(set(moments)) == 1 else f"{ratio} of the right ones"
            body = BODIES.get((ratio * moments[0]).as_coeff_Mul()[0]) if len(moments[0].free_symbols) == 2 else None
            clause = f"with the moment of inertia {now} for {called(r.name)}" + (f", which {body} has" if body else "")
            yield Variation(clause, place, _changed(m, r, replace(r, factor=ratio)))


def _about_another_point(m: Mechanics, r: Inertia) -> Iterator[Variation]:
    """The moment of inertia about a point of the path instead of the centre: the square of one rate counted twice."""
    for p in (p for p in m.particles if p.name == r.name):
        for i in {*p.moving} & {*r.moving}:
            clause = f"with the moment of inertia of {called(r.name)} about another point than its mass centre"
            yield Variation(
                clause, f"the moment of inertia of {called(r.name)}", _changed(m, p, p.times({(i, i): sp.Integer(2)}))
            )


def _about_the_end(m: Mechanics, r: Inertia) -> Iterator[Variation]:
    """Of a rod that turns about a point of itself the moment of inertia about its end."""
    moments = {*r.weights} - {0}
    mass_centre = [p for p in m.particles if p.name == r.name and p.moving == r.moving and len(p.moving) == 1]
    if len(moments) == 1 and next(iter(moments)).as_coeff_Mul()[0] == sp.Rational(1, 12) and mass_centre:
        end = written(4 * next(iter(moments)), m.slots)
        clause = f"with {end}, the moment of inertia of {called(r.name)} about its end, for that about the axis"
        changed = _changed(m, mass_centre[0], None)
        yield Variation(
            clause, f"the moment of inertia of {called(r.name)}", _changed(changed, r, replace(r, factor=sp.Integer(4)))
        )


def _moments_exchanged(m: Mechanics, r: Inertia) -> Iterator[Variation]:
    first, second = sorted({*r.weights} - {0}, key=str)
    swapped = tuple(second if w == first else first if w == second else w for w in r.weights)
    a, b, c = swapped
    clause = f"with the moments of inertia {first} and {second} exchanged"
    yield Variation(
        clause, f"the moments of inertia of {called(r.name)}", _changed(m, r, replace(r, weights=(a, b, c)))
    )


def gradient_left_out(m: Mechanics) -> Iterator[Variation]:
    """∂T/∂q is forgotten."""
    changed = m.inertia(lambda i: replace(i, gradient=sp.S.Zero))
    yield Variation("without dT/dq", "dT/dq: T depends on the coordinates too", changed)


def gradient_reversed(m: Mechanics) -> Iterator[Variation]:
    """∂T/∂q has the wrong sign, or a conserved momentum was substituted into L."""
    changed = m.inertia(lambda i: replace(i, gradient=sp.S.NegativeOne))
    clause = "with the sign of dT/dq reversed, as if a constant momentum were put into L before differentiating"
    yield Variation(clause, "the sign of dT/dq", changed)


def product_half_done(m: Mechanics) -> Iterator[Variation]:
    """In d/dt ∂T/∂q' only the velocity is differentiated, and not its coefficient; or that only in part."""
    place = "d/dt of dT/dq': its coefficients change in time too"
    clause = "if d/dt of dT/dq' is carried out for the velocities alone, and not for their coefficients"
    yield Variation(clause, place, m.inertia(lambda i: replace(i, product=sp.S.Zero)))
    if len(m.slots.coordinates) == 1:  # J(q) q'' = M, as for a constant J; half of J' q' and -1/2 J' q' are as much
        q = m.slots.coordinates[0]
        clause = f"if J in J*{q}'' = M were constant, as for a fixed axis; it depends on {q}"
        yield Variation(clause, place, m.inertia(lambda i: replace(i, product=sp.S.Zero, gradient=sp.S.Zero)))
    else:
        clause = "if d/dt of the coefficients in dT/dq' is only half of what it is (2*r*r' for r^2)"
        yield Variation(clause, place, m.inertia(lambda i: replace(i, product=HALF)))
    clause = "with the wrong sign of d/dt of the coefficients in dT/dq'"
    yield Variation(clause, place, m.inertia(lambda i: replace(i, product=sp.S.NegativeOne)))
    clause = "if the coefficients in dT/dq' did not depend on time"
    if any(len(m.slots.coordinates) in i.moving for i in m.inertias) or m.slots.prescribed:
        yield Variation(clause, place, m.inertia(lambda i: replace(i, explicit=sp.S.Zero)))


def mixed_terms(m: Mechanics) -> Iterator[Variation]:
    """The terms with products of two velocities are omitted, or have the wrong sign or factor."""
    place = "the terms with products of two velocities"
    for factor, how in _FACTORS:
        changed = m.inertia(lambda i, f=factor: replace(i, mixed=f))  # type: ignore[misc]
        yield Variation(f"{how} the Coriolis terms, those with products of two velocities", place, changed)


def squared_terms(m: Mechanics) -> Iterator[Variation]:
    """The terms with squares of velocities are omitted, or have the wrong sign or factor."""
    place = "the terms with squares of velocities"
    for factor, how in _FACTORS:
        changed = m.inertia(lambda i, f=factor: replace(i, squared=f))  # type: ignore[misc]
        yield Variation(f"{how} the centrifugal terms, those with squares of velocities", place, changed)


_FACTORS = (
    (sp.S.Zero, "without"),
    (sp.S.NegativeOne, "with the wrong sign of"),
    (HALF, "with one half of"),
    (sp.Integer(2), "with twice"),
)


def velocity_terms_left_out(m: Mechanics) -> Iterator[Variation]:
    """Accelerations and forces alone."""
    changed = m.inertia(lambda i: replace(i, product=sp.S.Zero, gradient=sp.S.Zero))
    yield Variation("without all velocity terms, as if T had constant coefficients", "the velocity terms", changed)


def half_left_out(m: Mechanics) -> Iterator[Variation]:
    """T without its ½, or with one too many."""
    size = ("half", "twice") if not m.multipliers else ()
    words = "for a kinetic energy twice as large", "for half of the kinetic energy"
    for n, (factor, clause) in enumerate(zip((sp.Integer(2), HALF), words, strict=True)):
        clause += f", or forces {size[n]} as large" if size else ""
        changed = m.inertia(lambda i, f=factor: replace(i, factor=i.factor * f))  # type: ignore[misc]
        yield Variation(clause, "the factor of the kinetic energy", changed)
        for one in m.inertias if len(m.inertias) > 1 else ():
            what = f"{'rotational' if one.turning else 'kinetic'} energy of {called(one.name)}"
            half = f"for a {what} twice as large" if factor == 2 else f"for half of the {what}"
            yield Variation(
                half, f"the factor of the {what}", _changed(m, one, replace(one, factor=one.factor * factor))
            )


def mass_left_out(m: Mechanics) -> Iterator[Variation]:
    """A particle, or the mass of a body, is omitted altogether: its energy and its weight."""
    if len(m.particles) < 2:
        return
    for p in m.particles:
        rest = _changed(m, p, None)
        weights = [f for f in m.of_kind(ForceKind.WEIGHT) if f.on == (p.name,)]
        if weights:
            yield Variation(
                f"without the mass of {called(p.name)}", f"{called(p.name)}", rest.scaled(weights, sp.S.Zero)
            )
        both = rest.inertia(lambda i, p=p: None if i.name == p.name else i)  # type: ignore[misc]
        if any(r.name == p.name for r in m.rotations):
            yield Variation(f"without {called(p.name)}", f"{called(p.name)}", both.scaled(weights, sp.S.Zero))


def one_alone(m: Mechanics) -> Iterator[Variation]:
    """One particle or body alone is accelerated, as if the others pulled with their whole weights."""
    names = list(dict.fromkeys(i.name for i in m.inertias))
    for name in names if len(names) > 1 else ():
        alone = m.inertia(lambda i, name=name: i if i.name == name else None)  # type: ignore[misc]
        clause = f"with the inertia of {called(name)} alone, as if what is joined to it pulled with its whole weight"
        yield Variation(clause, "the inertia of the others: a string does not pull with the weight", alone)


def translation_left_out(m: Mechanics) -> Iterator[Variation]:
    """The energy of a particle or mass centre is omitted; its weight is not."""
    if len(m.inertias) < 2:
        return
    for p in m.particles:
        motion = "of the motion of the mass centre " if any(r.name == p.name for r in m.rotations) else ""
        clause = f"without the kinetic energy {motion}of {called(p.name)}"
        yield Variation(clause, f"the kinetic energy of {called(p.name)}", _changed(m, p, None))


def sine_for_cosine(m: Mechanics) -> Iterator[Variation]:
    """Sine and cosine of an angle exchanged in the positions: of one particle or of all, in T alone or in V as well."""
    for q in _angles(m):
        rule = {sp.sin(q): sp.cos(q), sp.cos(q): sp.sin(q)}
        words = f"with sin({q}) and cos({q}) exchanged in the position"
        yield from _moved(m, rule, words)


def coordinate_reversed(m: Mechanics) -> Iterator[Variation]:
    """An angle is counted the other way in the position of one particle."""
    for q in _angles(m):
        yield from _moved(m, {q: -q}, f"with {q} counted the other way in the position")


def sum_of_angles(m: Mechanics) -> Iterator[Variation]:
    """a + b for a − b: an angle has the wrong sign in the coefficients of T."""
    for q in _angles(m):
        parts = [p for p in m.particles if any(q in c.free_symbols for column in p.columns for c in column)]
        for group in (*([p] for p in parts), *([parts] if len(parts) > 1 else ())):
            changed = m.inertia(
                lambda i, g=group, q=q: replace(i, columns=_rewritten(i, {q: -q})) if i in g else i  # type: ignore[misc]
            )
            of = ", ".join(called(p.name) for p in group)
            clause = f"with the wrong sign of {q} in the coefficients of the kinetic energy of {of}: a + b for a - b"
            yield Variation(clause, f"the angle in the kinetic energy of {of}", changed)


def angles_small_in_energy(m: Mechanics) -> Iterator[Variation]:
    """The small-angle approximation is made in T alone, whose coefficients are those at zero."""
    rule: dict[sp.Basic, sp.Basic] = dict.fromkeys(_angles(m), sp.S.Zero)
    if any(q in s.free_symbols for i in m.inertias for c in i.columns for s in c for q in rule):
        small = m.inertia(lambda i: replace(i, columns=_rewritten(i, rule)))
        place = "the kinetic energy: its coefficients depend on the angles"
        yield Variation("with cosines in the kinetic energy replaced by 1, as for small angles", place, small)


def radius_for_distance(m: Mechanics) -> Iterator[Variation]:
    """A length is used in velocities instead of the distance from the axis: l for l sin(theta)."""
    found: dict[tuple[int, sp.Expr], list[str]] = {}
    for p in m.particles:
        for i in p.moving:
            factors = [{*sp.Mul.make_args(c)} for c in p.columns[i] if c != 0]
            common = set.intersection(*factors) if len(factors) > 1 else set[sp.Expr]()
            for wave in sorted((w for w in common if isinstance(w, sp.sin | sp.cos)), key=str):
                found.setdefault((i, wave), []).append(p.name)
    for (i, wave), names in found.items():
        for group in ([[n] for n in names] if len(names) > 1 else []) + [names]:
            of = ", ".join(map(called, group))
            changed = m.inertia(lambda p, i=i, w=wave, g=group: _divided(p, i, w) if p.name in g else p)  # type: ignore[misc]
            clause = f"without the factor {written(wave, m.slots)} in the distance of {of} from the axis"
            yield Variation(clause, f"the velocity of {of}", changed)


def _divided(p: Inertia, index: int, factor: sp.Expr) -> Inertia:
    if p.turning:
        return p
    columns = [*p.columns]
    a, b, c = (x / factor for x in columns[index])
    columns[index] = (a, b, c)
    return replace(p, columns=tuple(columns))


def length_left_out(m: Mechanics) -> Iterator[Variation]:
    """A length is omitted from the position of a particle or mass centre."""
    places = {s for p in m.particles for column in p.columns for c in column for s in c.free_symbols}
    moving = {*m.slots.coordinates, *m.slots.prescribed, t}
    for a in sorted((s for s in places if base(s) not in moving), key=str):
        yield from _moved(m, {a: sp.S.Zero}, f"without {a} in the position")


def length_doubled(m: Mechanics) -> Iterator[Variation]:
    """A length is doubled or halved in the position of a particle or mass centre: of the end and not the middle."""
    places = {s for p in m.particles for column in p.columns for c in column for s in c.free_symbols}
    moving = {*m.slots.coordinates, *m.slots.prescribed, t}
    lengths = sorted((s for s in places if base(s) not in moving and s not in _angles(m)), key=str)
    for a in lengths:
        for factor in (sp.Integer(2), HALF):
            yield from _moved(
                m, {a: factor * a}, f"with {written(factor * a, m.slots)} in place of {a} in the position"
            )
        yield from _moved(m, {a: -a}, f"with the wrong sign of {a} in the position")


def _rewritten(part: Inertia, rule: dict[sp.Basic, sp.Basic]) -> tuple[Components, ...]:
    return tuple((a.xreplace(rule), b.xreplace(rule), c.xreplace(rule)) for a, b, c in part.columns)


def _moved(m: Mechanics, rule: dict[sp.Basic, sp.Basic], words: str) -> Iterator[Variation]:
    """Positions rewritten by a rule, for one particle and for all."""
    slots = m.slots
    points = {p.name: p for p in m.configuration.points}
    changed: dict[str, Inertia] = {}
    for p in m.particles:
        position = points[p.name].position.fixed()
        new = position.xreplace(rule)
        if new != position:
            changed[p.name] = replace(particle(p.name, points[p.name].mass, new, slots), name=p.name)
    weights = {
        load.on: weight_shares(load, points[load.on].position.fixed().xreplace(rule), slots)
        for load in m.configuration.loads
        if load.name == "weight" and load.on in changed
    }
    groups = [[name] for name in changed] + ([list(changed)] if len(changed) > 1 else [])
    for names in groups:
        of = f"{words} of {', '.join(map(called, names))}" if len(m.particles) > 1 else words
        place = f"the position of {', '.join(map(called, names))}"
        moved = m.inertia(lambda i, n=names: changed[i.name] if i.name in n and not i.turning else i)  # type: ignore[misc]
        yield Variation(f"{of}, in T", place, moved)
        if any(n in weights for n in names):
            both = moved.force(
                lambda f, n=names: (
                    replace(f, shares=weights[f.on[0]])  # type: ignore[misc]
                    if f.kind is ForceKind.WEIGHT and f.on[0] in n and f.on[0] in weights
                    else f
                )
            )
            yield Variation(of, place, both)


def factor_two(m: Mechanics) -> Iterator[Variation]:
    """All forces twice or half as large."""
    for factor, word in ((sp.Integer(2), "twice"), (HALF, "half")):
        changed = m.scaled(m.forces, factor)
        yield Variation(f"for {word} the applied forces", "the factor between T and the forces", changed)


def _changed(m: Mechanics, old: Inertia, new: Inertia | None) -> Mechanics:
    return m.inertia(lambda i: new if i == old else i)


def _product_of(pair: Pair, m: Mechanics) -> str:
    first, second = (m.slots.velocities[k] for k in pair)
    return f"{first}*{second}" if first != second else f"{first}^2"


def _index_pairs(m: Mechanics) -> Iterator[Pair]:
    n = len(m.slots.coordinates)
    return ((i, j) for i in range(n) for j in range(i + 1, n))


def _angles(m: Mechanics) -> list[sp.Symbol]:
    """The coordinates and parameters whose sines and cosines are in the positions."""
    waves = {
        w.args[0]
        for p in m.configuration.points
        for c in p.position.fixed().components
        for w in c.atoms(sp.sin, sp.cos)
    }
    return sorted((a for a in waves if a.is_Symbol and a != t and a != prime(a)), key=str)
