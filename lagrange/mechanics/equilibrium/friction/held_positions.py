"""What the constraints imply for the position in which a system with rough contacts rests: coordinates that they fix,
and angles that they make equal.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.core.operations import count_operations
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.equilibrium.friction.linear_inequalities import shortest
from lagrange.mechanics.equilibrium.limits import LONGEST_SLACK


def held_coordinates(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates that the constraints hold at a constant, of an angle the value with a positive cosine."""
    finite, coordinates = configuration.finite_constraints, configuration.slots.coordinates
    used = [q for q in coordinates if any(q in f.free_symbols for f in finite)]
    if not used or any(count_operations(f) > LONGEST_SLACK for f in finite):
        return {}
    if len(used) > len(finite):
        return _held_outright(configuration)
    turning = {f.args[0] for e in finite for f in e.atoms(sp.sin, sp.cos, sp.tan)}
    if (upright := _upright(finite, used, turning, _held_outright(configuration))) is not None:
        return upright
    try:
        solved = solutions(finite, used)
    except (NotAlgebraicError, DivisionByZeroError):
        return {}
    held = []
    for b in solved.branches:
        values = {r.lhs: r.rhs for r in b.relations if r.lhs in used and r.rhs.free_symbols.isdisjoint(used)}
        if b.left or b.special or len(values) < len(used):
            return {}
        if all(sign_of(sp.cos(v)) == 1 for q, v in values.items() if q in turning):
            held.append(values)
    return held[0] if len(held) == 1 else {}


def _upright(
    finite: Sequence[sp.Expr],
    used: Sequence[sp.Symbol],
    turning: Collection[sp.Expr],
    outright: Mapping[sp.Symbol, sp.Expr],
) -> dict[sp.Symbol, sp.Expr] | None:
    """The position in which all angles are 0, where the constraints admit it and hold the system there: a bracket on a
    pipe is upright as it is drawn, though it would fit in another position, too.

    Where the constraints are not linear in the other coordinates, these are 0 as well: a file is written in the
    position in which its vectors are simple.
    """
    if not turning or not {*turning} <= {*used}:
        return None
    at = {q: sp.S.Zero for q in used if q in turning} | dict(outright)
    left = [e for e in (shortest(f.xreplace(at)) for f in finite) if e != 0]
    others = [q for q in used if q not in at]
    candidates: Iterable[Sequence[sp.Expr]]
    if any(e.diff(q).free_symbols & {*others} for e in left for q in others):
        candidates = [[sp.S.Zero] * len(others)]
        left_there = [shortest(e.xreplace(dict.fromkeys(others, sp.S.Zero))) for e in left]
        if any(e != 0 for e in left_there):
            return None
    else:
        candidates = sp.linsolve(left, others) if left and others else () if left else ((),)
    for values in candidates:
        place = at | dict(zip(others, values, strict=False))
        slopes = sp.Matrix([[shortest(f.diff(q).xreplace(place)) for q in used] for f in finite])
        fixed = all(v.free_symbols.isdisjoint(used) for v in place.values())
        return place if fixed and len(place) == len(used) and slopes.rank() == len(used) else None
    return None


def _held_outright(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates that a constraint of their own holds: ρ = R."""
    held: dict[sp.Symbol, sp.Expr] = {}
    for f in configuration.finite_constraints:
        own = f.free_symbols & {*configuration.slots.coordinates}
        slope = f.diff(*own) if len(own) == 1 else sp.S.Zero
        if slope.is_number and slope != 0:
            held |= {q: -f.xreplace({q: sp.S.Zero}) / slope for q in own}
    return held


def equal_angles(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The acute angles that the constraints make equal: cos θ_2 = cos θ_1, where two legs stand on one floor.

    Combinations of the constraints in which no other coordinate is left show that.
    """
    finite, coordinates = configuration.finite_constraints, configuration.slots.coordinates
    turning = {q for f in finite for g in f.atoms(sp.sin, sp.cos) for q in g.free_symbols if q in coordinates}
    others = [q for q in coordinates if q not in turning]
    slopes = sp.Matrix([[f.diff(q) for q in others] for f in finite]) if finite and others else sp.Matrix()
    if len(turning) < 2 or slopes.free_symbols or any(count_operations(f) > LONGEST_SLACK for f in finite):
        return {}
    equal: dict[sp.Symbol, sp.Expr] = {}
    for combination in slopes.T.nullspace():
        relation = sp.factor(sp.Add(*(c * f for c, f in zip(combination, finite, strict=True))).xreplace(equal))
        for piece in sp.Mul.make_args(relation):
            waves = sorted(piece.atoms(sp.sin, sp.cos), key=str)
            if len(waves) != 2 or waves[0].func != waves[1].func:
                continue
            first, second = (w.args[0] for w in waves)
            rate = sp.expand(piece).coeff(waves[0])
            if first in turning and second in turning and sp.expand(piece - rate * (waves[0] - waves[1])) == 0:
                equal = {q: e.xreplace({second: first}) for q, e in equal.items()} | {second: first}
    return equal
