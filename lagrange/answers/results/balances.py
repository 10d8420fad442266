"""Wrong positions of rest that satisfy another balance: of energy, or of moments without the reactions.

    V(q) = V(0)         a body that is let go turns back where its potential energy is that of the start, and its middle
                        position is the equilibrium;
    V(q) = 0            the height of the mass centre itself, and not its derivative;
    Σ (r − r_P) × F = 0   the applied forces alone have no moment about a point P.

The last is right for a body that turns about P; others have reactions whose moments are missing.

Wrong reactions of a system at rest, stated as functions of the position: which letter is wrong, which term missing.

R(q) is compared with the right reaction at the position of equilibrium, where the two differ by R_0 − R(q_0). A letter
p with the opposite sign makes the difference R(q; −p) − R(q; p), and a forgotten term p q/l makes itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import LONGEST_BALANCE
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.lagrangian import is_constant

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.static_reactions import ReactionsAtRest


def potential_energy(configuration: Configuration) -> sp.Expr | None:
    """V of springs, potentials and constant forces; None if other forces act."""
    if configuration.torques or any(f != 0 for f in configuration.generalized):
        return None
    if not all(is_constant(f, configuration) for f in configuration.loads):
        return None
    lost = (f.vector.fixed().dot(_place(f.point, configuration)) for f in configuration.loads)
    return configuration.potential - sp.Add(*lost)


def _place(point: Vector, configuration: Configuration) -> Vector:
    return point.fixed().map(configuration.rewritten)


def of_equal_energy(wrong: Sequence[Sequence[sp.Expr]], configuration: Configuration) -> str:
    """Whether the potential energy at stated positions is that where all coordinates vanish, in a sentence.

    wrong  the stated positions, as expressions that are zero
    """
    V = potential_energy(configuration)
    coordinates = {*configuration.slots.coordinates}
    if V is None or configuration.constrained.rows or len(wrong) != 1:
        return ""
    rule = {q: value for e in wrong[0] for q, value in _position(e, coordinates)}
    if not rule or 0 in rule.values() or not _pulls_at_zero(V, {*rule}):
        return ""
    try:
        # Each coordinate by itself, wherever the others are: then it holds for any masses.
        if any(is_zero(V.xreplace({q: value}) - V.xreplace({q: sp.S.Zero})) is not True for q, value in rule.items()):
            return ""
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        return ""
    names = " and ".join(sorted(map(str, rule)))
    return (
        f"there the potential energy is again that at {names} = 0: let go, the system turns back there, and the "
        "equilibrium lies between"
    )


def _position(equation: sp.Expr, coordinates: set[sp.Symbol]) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The value of the one coordinate in an equation, in which it is linear."""
    own = sorted(coordinates & equation.free_symbols, key=str)
    slope = equation.diff(own[0]) if len(own) == 1 else sp.S.Zero
    if slope != 0 and slope.free_symbols.isdisjoint(coordinates):
        yield own[0], -equation.xreplace({own[0]: sp.S.Zero}) / slope


def _pulls_at_zero(V: sp.Expr, coordinates: set[sp.Symbol]) -> bool:
    """Whether the system is not at rest where all coordinates vanish."""
    start = dict.fromkeys(coordinates, sp.S.Zero)
    return all(V.diff(q).xreplace(start) not in (0, sp.nan, sp.zoo) for q in coordinates)


def of_another_balance(wrong: Sequence[Sequence[sp.Expr]], configuration: Configuration) -> str:
    """Which other balance the one wrong equation is, in a sentence; empty if of none that is known."""
    bound = _bound(configuration)
    free = [q for q in configuration.slots.coordinates if q not in bound]
    if len(wrong) != 1 or len(wrong[0]) != 1 or len(free) != 1:
        return ""
    [[equation]], [q] = wrong, free
    equation = equation.xreplace(bound)
    try:
        for balance, said in ((b.xreplace(bound), said) for b, said in _balances(configuration)):
            if q in balance.free_symbols and sp.count_ops(balance) <= LONGEST_BALANCE and _same(equation, balance, q):
                return said
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        pass
    return ""


def _bound(configuration: Configuration) -> dict[sp.Basic, sp.Expr]:
    """The coordinates that finite constraints give as functions of one other, s = 2 r cos θ."""
    coordinates = [*configuration.slots.coordinates]
    rule: dict[sp.Basic, sp.Expr] = {}
    for f in configuration.finite_constraints:
        for q in coordinates:
            slope = f.diff(q)
            if q not in rule and slope != 0 and slope.free_symbols.isdisjoint(coordinates):
                rule[q] = -f.xreplace({q: sp.S.Zero}) / slope
                break
    kept = {q for q in coordinates if q not in rule}
    return rule if all(v.free_symbols & {*coordinates} <= kept for v in rule.values()) else {}


def _same(equation: sp.Expr, balance: sp.Expr, q: sp.Symbol) -> bool:
    """Whether two expressions have a ratio that does not depend on the position, apart from a cosine or sine."""
    if q not in equation.free_symbols:
        return False
    for factor, power in product((sp.S.One, sp.cos(q), sp.sin(q)), (1, -1)):
        scaled = equation * factor**power
        # (a/b)' = 0, without the division
        if is_zero(scaled.diff(q) * balance - scaled * balance.diff(q)) is True:
            return True
    return False


def _balances(configuration: Configuration) -> Iterator[tuple[sp.Expr, str]]:
    V = potential_energy(configuration)
    if V is not None:
        yield V, "the potential energy itself vanishes there, and not its derivative"
    if configuration.torques or configuration.springs or configuration.potential != 0:
        return
    places = {"O": Vector.zero()} | {f"`{p.name}`": p.position.fixed() for p in configuration.points}
    for name, place in places.items():
        arms = [(_place(f.point, configuration) - place, f.vector.fixed()) for f in configuration.loads]
        for moment in _sum([arm.cross(force) for arm, force in arms]).components:
            yield (
                sp.expand(moment),
                f"the applied forces alone have no moment about {name} there: the moments of reactions are missing",
            )


def _sum(vectors: Sequence[Vector]) -> Vector:
    total = Vector.zero()
    for v in vectors:
        total = total + v
    return total


# Resting reactions


def of_one_letter(
    value: sp.Expr,
    off: sp.Expr,
    letters: Sequence[sp.Expr],
    at_rest: ReactionsAtRest,
    coordinates: Sequence[sp.Symbol],
) -> str:
    """Which letter has a wrong sign in a stated value, or which term is missing, in a sentence; empty if not found.

    off  by how much it is too small at the equilibrium
    """
    if value.free_symbols.isdisjoint(coordinates):
        return ""
    for said, more in _changes_of_reaction(value, letters, coordinates):
        [difference] = next(iter(at_rest.points.values_at([more])))
        if is_zero(difference - off) is True:
            return said
    return ""


def _changes_of_reaction(
    value: sp.Expr, letters: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]
) -> Iterator[tuple[str, sp.Expr]]:
    used = [p for p in letters if p in value.free_symbols]
    for p in used:
        yield f"this is the reaction for {p} with the opposite sign", value.xreplace({p: -p}) - value
    for p, q in product((p for p in letters if p.is_Symbol and p not in used), coordinates):
        yield f"the term {p}*{q} is missing", p * q
        for below in used:
            yield f"the term {p}*{q}/{below} is missing", p * q / below
