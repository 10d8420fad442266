"""Vectors by unit vectors that have names, or that turn with a body; Newton's law along them.

Vectors as multiples of unit vectors that have names: a force N n, not N sin θ i − N cos θ j.

v = c n + w with c = v_k/n_k, where w lacks the component k, or with c = v·n. It is written so where that is shorter.

Newton's law along the unit vectors that a file names, where its components are shorter there.

Of a block on the face of a wedge, with s down the face and n normal to it, the component along n has the normal force
alone, m (X'' sin α + w'') = N − m g cos α, and that along s none of it. Components along i and j have both.

The sum of several reactions along unit vectors that turn with a body, where that is shorter than each by itself.

The two forces that keep a coin from slipping, along i and j of the plane, are sums of products of sin θ and cos θ.
Along the heading and the axle of the coin each is one term: R = Σ λ_j g_j = Σ (R·e) e for perpendicular unit vectors e.

Results in components compared with their formulas in vectors, before a page is written in vectors.

A particle on a surface f = 0 with ∇f = a: the constraint differentiated twice is a·r'' + D = 0, and

    λ |a|² = −m D − F·a .

Two particles joined by a massless rod of length l, otherwise free, with u = r_2 − r_1:

    T = (m_1 m_2/((m_1 + m_2) l)) (u'² + u·(F_2/m_2 − F_1/m_1)) .
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import UnitVector, VectorSymbol
from lagrange.core.vectors import FIXED, UNITS, Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.conservation import EnergyRate
from lagrange.mechanics.dynamics.newton import FreeBody, LawComponent
from lagrange.mechanics.limits import LONGEST_IN_DIRECTIONS, SHORTER_ALONG_AXES
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.factors import in_factors, with_common_factor
from lagrange.mechanics.rewriting.held_coordinates import held_values
from lagrange.problem.model import Problem

Directions = Mapping[str, Vector]


def unit_directions(problem: Problem) -> Directions:
    """The unit vectors of `let` and of the frame that are not along an axis, in i, j, k, by name."""
    named = {n: v for n, v in problem.abbreviations.items() if isinstance(v, Vector)}
    units = {n: v.fixed() for n, v in named.items() if is_zero(v.dot(v) - 1) is True}
    if problem.frame is not None and problem.frame.directions is not None:
        rows = (problem.frame.directions.row(n) for n in range(3))
        units = {n: Vector((r[0], r[1], r[2])) for n, r in zip(problem.frame.names, rows, strict=True)} | units
    return {n: v for n, v in units.items() if sum(c != 0 for c in v.components) > 1}


def unit_along(vector: Vector, units: Directions) -> sp.Expr | None:
    """e or −e, where a vector is that; None if it is neither."""
    for name, unit in units.items():
        for sign in (1, -1):
            if all(is_zero(c) is True for c in (vector.fixed() - unit * sp.Integer(sign)).components):
                return sign * VectorSymbol(name)
    return None


def in_named_directions(vector: Vector, units: Directions) -> Vector | sp.Expr:
    """The vector as c n + w, as a sum of two such multiples, or by three vectors; unchanged if none is shorter."""
    if sum(c != 0 for c in vector.components) < 2 or _length(vector) > LONGEST_IN_DIRECTIONS:
        return vector
    units = {n: u for n, u in units.items() if n not in vector.triad.names}
    if not units:
        return vector
    forms = [_along(vector, triad) for triad in _triads(units)]
    forms += [e for e in (_by_two(vector, units),) if e is not None]
    best = min(forms, key=count_operations, default=None)
    return vector if best is None or count_operations(best) >= _length(vector) else best


def _by_two(vector: Vector, units: Directions) -> sp.Expr | None:
    """c n + w with one or two named vectors n; None where w would be in two kinds of directions."""
    left, terms = vector.fixed(), sp.S.Zero
    for _ in range(2):
        along = [(factor, name, rest) for name, unit in units.items() for factor, rest in _splits(left, unit)]
        factor, name, rest = min(along, key=lambda split: count_operations(split[0]) + _length(split[2]))
        if factor != 0:
            left, terms = rest, terms + _collected(factor) * VectorSymbol(name)
    beside = [c for c in left.components if c != 0]
    if len(beside) > 1 and any(c.has(sp.sin, sp.cos) for c in beside):
        return None  # in two kinds of directions that turn it would be no clearer
    return terms + left.as_sum() if terms != 0 else None


def _triads(units: Directions) -> Iterator[dict[sp.Symbol, Vector]]:
    """Three perpendicular unit vectors, at least two of them named: with i, j or k the directions of a cylinder."""
    named: dict[sp.Symbol, Vector] = {VectorSymbol(n): u.fixed() for n, u in units.items()}
    axes: dict[sp.Symbol, Vector] = {
        unit: Vector(tuple(sp.Integer(k == n) for k in range(3))) for n, unit in enumerate(FIXED.units)
    }
    for a, b in combinations(named, 2):
        if is_zero(named[a].dot(named[b])) is not True:
            continue
        for c, third in {**named, **axes}.items():
            if c not in (a, b) and all(is_zero(third.dot(named[u])) is True for u in (a, b)):
                yield {a: named[a], b: named[b], c: third}
                break


def _along(vector: Vector, triad: Mapping[sp.Symbol, Vector]) -> sp.Expr:
    """Σ (v·e) e."""
    fixed = vector.fixed()
    return sp.Add(*(textbook_form(fixed.dot(e)) * unit for unit, e in triad.items()))


def _collected(factor: sp.Expr) -> sp.Expr:
    """(R − a) θ'' for R θ'' − a θ'': what all terms share in front, where only parameters are left in brackets."""
    made = with_common_factor(factor)
    sums = [f for f in sp.Mul.make_args(made) if f.is_Add]
    return made if made.is_Mul and all(s.is_positive for f in sums for s in f.free_symbols) else factor


def _length(vector: Vector) -> int:
    return sum(count_operations(c) + (c != 0) for c in vector.components)


def _splits(vector: Vector, unit: Vector) -> Iterator[tuple[sp.Expr, Vector]]:
    """Pairs c, w of a vector c n + w, where w lacks a component: c = v_k/n_k; and none, c = 0."""
    yield sp.S.Zero, vector
    pairs = [(v, n) for v, n in zip(vector.components, unit.components, strict=True) if v != 0 and n != 0]
    factors = [*(sp.cancel(v / n) for v, n in pairs), *(_share(v, n) for v, n in pairs)]
    for factor in dict.fromkeys([*factors, textbook_form(vector.dot(unit))]):
        if not all(s.is_positive for s in sp.fraction(sp.together(factor))[1].free_symbols):
            continue
        rest = (vector - unit * factor).map(lambda c: sp.S.Zero if is_zero(c) is True else textbook_form(c))
        yield factor, rest


def _share(whole: sp.Expr, part: sp.Expr) -> sp.Expr:
    """The coefficient of sin θ in x − b sin θ, over the sign that sin θ has in the unit vector."""
    sign, core = part.as_coeff_Mul()
    return sp.expand(whole).coeff(core) / sign


# Named components


def in_named_components(body: FreeBody, units: Directions) -> FreeBody:
    """The body with the components of Newton's law along two named vectors of their plane, if they are shorter."""
    laws = body.components
    if len(laws) != 2 or sum(map(_length_of_law, laws)) > LONGEST_IN_DIRECTIONS:
        return body
    best = min(_laws_along_pairs(laws, units), key=lambda form: sum(map(_length_of_law, form)), default=laws)
    return replace(body, components=best) if sum(map(_length_of_law, best)) < sum(map(_length_of_law, laws)) else body


def _laws_along_pairs(laws: tuple[LawComponent, ...], units: Directions) -> Iterator[tuple[LawComponent, ...]]:
    """The components along each pair of perpendicular named vectors in the plane of the two that there are."""
    axes = [c.along.fixed() for c in laws]
    if is_zero(axes[0].dot(axes[1])) is not True:
        return
    for pair in combinations(units.values(), 2):
        shares = [[e.fixed().dot(axis) for axis in axes] for e in pair]
        spans = all(is_zero(sp.Add(*(x**2 for x in share)) - 1) is True for share in shares)
        if spans and is_zero(pair[0].dot(pair[1])) is True:
            yield tuple(_law_along(e, share, laws) for e, share in zip(pair, shares, strict=True))


def _law_along(e: Vector, shares: list[sp.Expr], laws: tuple[LawComponent, ...]) -> LawComponent:
    """Σ (e·a) times the component along a; along −e where every term of the inertia would have a minus."""

    def projected(*parts: sp.Expr) -> sp.Expr:
        return textbook_form(sp.Add(*(share * part for share, part in zip(shares, parts, strict=True))))

    inertia = projected(*(c.inertia for c in laws))
    if all(a.could_extract_minus_sign() for a in sp.Add.make_args(sp.expand(inertia))) and inertia != 0:
        return _law_along(e * sp.S.NegativeOne, [-share for share in shares], laws)
    applied, reaction = projected(*(c.applied for c in laws)), projected(*(c.reaction for c in laws))
    return LawComponent(e, with_common_factor(inertia), applied, reaction)


def _length_of_law(law: LawComponent) -> int:
    return count_operations(law.inertia) + count_operations(law.right)


# Turned reactions


Axes = Sequence[tuple[sp.Symbol, Vector]]
"""Unit vectors: the symbol of each, and what it is in i, j, k."""


def turning_axes(solution: Solution) -> Axes:
    """The unit vectors that turn and have names: those of the file and its frame, axes of bodies; and i, j, k."""
    named = {n: (VectorSymbol(n), v) for n, v in unit_directions(solution.problem).items()}
    for rotation in solution.own.configuration.rotations:
        triad = rotation.angular_velocity.triad
        if triad == FIXED or triad.directions is None:
            continue
        for n, unit in enumerate(triad.units):
            row = triad.directions[n, :]
            named.setdefault(unit.name, (unit, Vector((row[0], row[1], row[2]))))
    known = [(symbol, where_constant(solution, v)) for symbol, v in named.values()]
    turning = [(symbol, v) for symbol, v in known if any(c.free_symbols for c in v.components)]
    fixed = [(UnitVector(n), Vector(tuple(sp.Integer(k == m) for m in range(3)))) for k, n in enumerate(UNITS)]
    return (*turning, *fixed) if turning else ()


def where_constant(solution: Solution, v: Vector) -> Vector:
    """A vector in i, j, k, with the coordinates that constraints keep constant."""
    held = held_values(solution.own.configuration)
    return v.fixed().map(lambda c: textbook_form(c.xreplace(held)))


def sum_along_axes(shares: Sequence[tuple[Vector, sp.Expr]], axes: Axes) -> sp.Expr | None:
    """The sum of force times direction along perpendicular unit vectors; None if that is not much shorter.

    shares  of each reaction, its direction for a force 1, and the force
    """
    before = sum(count_operations(value) for _, value in shares)
    if len(shares) < 2 or before > LONGEST_IN_DIRECTIONS:
        return None
    total = sum((direction.fixed() * value for direction, value in shares), Vector.zero())
    return min(
        (form for form in _along_turned_axes(total, axes) if count_operations(form) <= SHORTER_ALONG_AXES * before),
        key=count_operations,
        default=None,
    )


def _along_turned_axes(total: Vector, axes: Axes) -> Iterator[sp.Expr]:
    """The vector along each set of perpendicular axes that it takes; components that vanish are not written."""
    parts = [(symbol, e, _component(total, e)) for symbol, e in axes]
    parts = [(symbol, e, c) for symbol, e, c in parts if c != 0]
    for number in (1, 2, 3):
        for some in combinations(parts, number):
            if all(is_zero(a.dot(b)) is True for (_, a, _), (_, b, _) in combinations(some, 2)):
                rest = total - sum((e * c for _, e, c in some), Vector.zero())
                if all(is_zero(c) is True for c in rest.components):
                    yield sp.Add(*(symbol * c for symbol, _, c in some), evaluate=False)


def _component(total: Vector, e: Vector) -> sp.Expr:
    """The component along a unit vector, in factors."""
    above, below = sp.fraction(sp.together(total.dot(e)))
    quotient = textbook_form(sp.expand(above)) / below
    return sp.S.Zero if is_zero(quotient) is True else in_factors(sp.cancel(quotient) if below.is_Add else quotient)


# Vector laws


def curvature_term(configuration: Configuration) -> sp.Expr:
    """D: the terms without accelerations of the only constraint, differentiated twice."""
    [differentiated] = configuration.constrained.accelerated_constraints
    return differentiated.xreplace(dict.fromkeys(configuration.slots.accelerations, sp.S.Zero))


def is_surface_multiplier(
    multiplier: sp.Expr, configuration: Configuration, mass: sp.Expr, gradient: Sequence[sp.Expr], force: Vector
) -> bool:
    """Whether λ |a|² = −m D − F·a for the only particle."""
    squares = sp.Add(*(c**2 for c in gradient))
    along = _dot(force.components, gradient)
    return is_zero(multiplier * squares + mass * curvature_term(configuration) + along) is True


def is_tension_of_link(
    tension: sp.Expr, configuration: Configuration, forces: tuple[Vector, Vector], length: sp.Expr
) -> bool:
    """Whether this is the tension of the massless rod between the only two particles."""
    first, second = configuration.points
    apart = (second.position + first.position * -1).fixed().components
    speed = (second.velocity + first.velocity * -1).fixed().components
    (m, n), (f, g) = (first.mass, second.mass), forces
    field = (g * (1 / n) + f * (-1 / m)).components
    bracket = sp.Add(*(v**2 for v in speed)) + _dot(apart, field)
    return configuration.states.is_zero(tension * (m + n) * length - m * n * bracket) is True


def is_power(energy: EnergyRate, mass: sp.Expr, force: Vector, velocities: Sequence[sp.Expr], added: sp.Expr) -> bool:
    """Whether the energy is ½ m r'², and its rate F·r' and what is added, for a particle with r' = these velocities."""
    kinetic = mass * sp.Add(*(v**2 for v in velocities)) / 2
    if energy.rate is None or sp.expand(energy.expression - kinetic) != 0:
        return False
    return bool(sp.expand(energy.rate - _dot(force.components, velocities) - added) == 0)


def _dot(a: Sequence[sp.Expr], b: Sequence[sp.Expr]) -> sp.Expr:
    return sp.Add(*(x * y for x, y in zip(a, b, strict=True)))
