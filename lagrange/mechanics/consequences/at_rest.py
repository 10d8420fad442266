"""Forces that hold a system at rest in every position: without dependent coordinates, and for which shape they vanish.

*Without dependent coordinates.* If the force contains a coordinate that a constraint gives by its square,
z² = h(θ), then for z > 0 the force is a function of θ alone.

*For which curve.* If a function f(u) of the file is not specified, the force P is zero in every position if f'(u) has
the value that makes the condition of equilibrium hold with P = 0. With the constraint that is a function of u alone:
the curve of the counterweight of a drawbridge (Bernoulli and L'Hôpital 1695).

*Dead centres.* Where sin θ = 0 a constraint a δθ + b δx = 0 with a = 0 and b ≠ 0 leaves δx = 0. A force that works in
δx alone then does none, and the others, which work in δθ, are in equilibrium with no value of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified
from lagrange.mechanics.limits import LONGEST_CONSEQUENCE
from lagrange.mechanics.results import InCoordinates

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium


@record
class WithoutDependent:
    """force = value, for a positive `dependent`; for a small `coordinate` it is stiffness · coordinate."""

    force: sp.Symbol
    value: sp.Expr
    dependent: sp.Symbol
    coordinate: sp.Symbol | None = None
    stiffness: sp.Expr = sp.S.Zero


@record
class Shape:
    """Without the force, derivative = slope in every position; `whole`: the function itself, up to a constant."""

    force: sp.Symbol
    derivative: sp.Expr
    slope: sp.Expr
    function: sp.Expr
    whole: sp.Expr | None


def without_dependent(view: InCoordinates) -> WithoutDependent | None:
    """The only force as a function of the independent coordinates, where one square root gives it."""
    held = _held_by_one_force(view)
    if held is None:
        return None
    resting, force, value = held
    for relation in resting.configuration.finite_constraints:
        for z in sorted(value.free_symbols & {*resting.configuration.slots.coordinates}, key=str):
            square = _square(relation, z)
            others = {*resting.configuration.slots.coordinates} - {z}
            if square is None or not square.free_symbols & others:
                continue
            alone = sp.cancel(value).subs(z, sp.sqrt(square))
            if alone.has(z, sp.zoo, sp.nan) or count_operations(alone) > LONGEST_CONSEQUENCE:
                continue
            if is_zero(sp.expand(alone**2) - value**2, resting.configuration.surface) is True:
                return WithoutDependent(force, alone, z, *_stiffness(alone, resting))
    return None


def _stiffness(value: sp.Expr, resting: Equilibrium) -> tuple[sp.Symbol | None, sp.Expr]:
    """q and dP/dq at q = 0, where P(0) = 0 and q is the only coordinate in P."""
    coordinates = value.free_symbols & {*resting.configuration.slots.coordinates}
    if len(coordinates) != 1:
        return None, sp.S.Zero
    [q] = coordinates
    there, slope = value.subs(q, 0), sp.powdenest(sp.cancel(value.diff(q).subs(q, 0)), force=True)
    is_rest = there == 0 and slope != 0 and not slope.has(sp.zoo, sp.nan, q)
    return (q, textbook_form(slope)) if is_rest else (None, sp.S.Zero)


def _held_by_one_force(view: InCoordinates) -> tuple[Equilibrium, sp.Symbol, sp.Expr] | None:
    resting = view.equilibrium
    if resting is None or not resting.given or len(resting.forces) != 1 or len(resting.branches) != 1:
        return None
    [force], [branch] = resting.forces, resting.branches
    own = [r for r in branch.relations if r.lhs == force]
    return (resting, force, own[0].rhs) if len(own) == 1 and not branch.left else None


def _square(relation: sp.Expr, z: sp.Symbol) -> sp.Expr | None:
    """h, where the relation is c (z² − h) with a constant c."""
    factor = sp.expand(relation).coeff(z, 2)
    rest = sp.expand(relation - factor * z**2)
    if factor == 0 or rest.has(z) or not factor.is_number:
        return None
    return textbook_form(-rest / factor)


def shape(view: InCoordinates) -> Shape | None:
    """The function for which the only force is zero in every position."""
    held = _held_by_one_force(view)
    if held is None:
        return None
    resting, force, value = held
    derivatives = [d for d in value.atoms(Unspecified) if _of_one_coordinate(d, resting)]
    if len(derivatives) != 1 or len(value.atoms(Unspecified)) != 1:
        return None
    [derivative] = derivatives
    [u] = derivative.free_symbols
    letter = sp.Dummy("s", real=True)
    linear = sp.expand(value.xreplace({derivative: letter}))
    factor = linear.diff(letter)
    if factor == 0 or factor.has(letter):
        return None
    slope = _in_one(-linear.xreplace({letter: sp.S.Zero}) / factor, u, resting)
    if slope is None or count_operations(slope) > LONGEST_CONSEQUENCE:
        return None
    if is_zero(value.xreplace({derivative: slope}), resting.configuration.surface) is not True:
        return None
    function = Unspecified.of(derivative.name, derivative.argument_names, *derivative.arguments)
    polynomial = slope.is_polynomial(u)
    whole = sp.factor(sp.Poly(slope, u).integrate().as_expr()) if polynomial else None
    return Shape(force, derivative, _plainly(slope), function, None if whole is None else _plainly(whole))


def _plainly(e: sp.Expr) -> sp.Expr:
    """The product with its leading minus sign in its sum: W (L − u)/(2 l Q)."""
    sums = [f for f in sp.Mul.make_args(e) if isinstance(f, sp.Add)]
    if not e.could_extract_minus_sign() or len(sums) != 1:
        return e
    return sp.Mul(*(f for f in sp.Mul.make_args(-e) if f != sums[0]), -sums[0])


def _of_one_coordinate(d: Unspecified, resting: Equilibrium) -> bool:
    return (
        d.orders == (1,) and len(d.free_symbols) == 1 and d.free_symbols <= {*resting.configuration.slots.coordinates}
    )


def _in_one(slope: sp.Expr, u: sp.Symbol, resting: Equilibrium) -> sp.Expr | None:
    """The slope as a function of u, with sin kθ or cos kθ from a constraint that is linear in it."""
    coordinates = {*resting.configuration.slots.coordinates}
    if not slope.free_symbols & coordinates - {u}:
        return sp.factor(slope)
    for relation in resting.configuration.finite_constraints:
        for wave in relation.atoms(sp.sin, sp.cos):
            [argument] = wave.args
            angles = argument.free_symbols & coordinates - {u}
            if len(angles) != 1:
                continue
            [theta] = angles
            times = argument.diff(theta)
            if not times.is_number or argument != times * theta or not (1 / times).is_Integer:
                continue
            unit = sp.Dummy("phi", real=True)
            s = sp.Dummy("s", real=True)
            linear = sp.expand(relation.xreplace({wave: s}))
            if linear.has(theta) or linear.diff(s).has(s) or linear.diff(s) == 0:
                continue
            given = -linear.xreplace({s: sp.S.Zero}) / linear.diff(s)
            turned = sp.cancel(sp.expand_trig(slope.subs(theta, unit / times)))
            alone = sp.factor(turned.subs(type(wave)(unit), given))
            if not alone.free_symbols & {unit, theta}:
                return alone
    return None


def dead_centres(e: Equilibrium) -> Iterator[tuple[sp.Expr, sp.Symbol, sp.Symbol]]:
    """sin θ, x and P: where sin θ = 0 the constraint leaves δx = 0, and no force P gives equilibrium."""
    slots, rows = e.configuration.slots, e.configuration.rows
    if len(slots.coordinates) != 2 or len(rows) != 1 or rows[0].finite is None or len(e.forces) != 1 or not e.given:
        return
    [force], [row] = e.forces, rows
    for turning, moved in ((0, 1), (1, 0)):
        q, x = slots.coordinates[turning], slots.coordinates[moved]
        for wave, other in ((sp.sin(q), sp.cos(q)), (sp.cos(q), sp.sin(q))):
            there = {wave: sp.S.Zero, other: sp.Dummy("s", real=True, nonzero=True)}  # s² = 1
            if wave not in e.presupposed or row.coefficients[turning].xreplace(there) != 0:
                continue
            work, works = e.work.forces[turning].xreplace(there), e.work.forces[moved].has(force)
            if work.has(force) or not work.is_nonzero or not works:
                continue
            if _never_vanishes(row.coefficients[moved], row.finite, x, there):
                yield wave, x, force


def _never_vanishes(b: sp.Expr, finite: sp.Expr, x: sp.Symbol, there: dict[sp.Expr, sp.Expr]) -> bool:
    """Whether b, which is linear in x, is not zero on the constraint at a place where one of sin and cos is zero."""
    slope = b.diff(x)
    if slope.free_symbols & {x} or not slope.is_nonzero:
        return False
    at_zero = finite.xreplace({x: sp.cancel(x - b / slope)}).xreplace(there)
    [s] = [v for v in there.values() if v.is_Symbol]
    left = sp.expand(sp.expand(at_zero).subs(s**2, 1))
    return not left.has(s) and sign_of(left) in (1, -1)
