"""What constraints that are not linear in the velocities can hide: finite relations, or none.

At one position and time the velocities that φ(q, q', t) = 0 admits form a surface V. A finite relation f(q, t) = 0
would confine them to a plane, Σ (∂f/∂q) q' + ∂f/∂t = 0. Where V bends, no plane holds it: of a curve in V, with the
parameter s, the tangent v and the second derivative w,

    a·v = 0 ,      a·w = −Σ (∂²φ/∂q_i'∂q_k') v_i v_k ,      a = ∂φ/∂q' .

So the span of V has at least the dimension n − rank a of the tangent plane, and the rank of the numbers on the right,
taken for all pairs of tangents (the second fundamental form). When that is as much as the linear constraints leave, the
others add no linear condition, and the finite relations are those of the linear ones alone. The converse does not hold:
with less bending the question is undecided. Reference: Kobayashi and Nomizu, Foundations of Differential Geometry II.

Shapes: a (m, n).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, combinations_with_replacement

import sympy as sp

from lagrange.algebra.exact.exact import DivisionByZeroError, NoPointError, Point, Surface, UnsupportedError
from lagrange.algebra.fourier.textbook import textbook_form
from lagrange.core.records import record
from lagrange.core.symbols import Slots
from lagrange.mechanics.constraints.kinematics import Row


@record
class Bending:
    """Σ (∂²φ/∂q_i'∂q_k') v_i v_k = `value`, not zero, in a direction v in which φ does not change to first order.

    velocities  the two that change
    direction   v, which is (∂φ/∂q_k', −∂φ/∂q_i')
    """

    velocities: tuple[sp.Symbol, sp.Symbol]
    direction: tuple[sp.Expr, sp.Expr]
    value: sp.Expr


def bending_rank(rows: Sequence[Row], slots: Slots, states: Surface) -> int | None:
    """The rank of the second fundamental form of the admitted velocities, at generic states. None: undecided."""
    gradients = [r.coefficients for r in rows]
    curved = [r for r in rows if r.nonlinear is not None]
    hessians = [[[a.diff(v) for v in slots.velocities] for a in r.coefficients] for r in curved]

    def at(point: Point) -> int:
        tangents = point.nullspace(point.matrix(gradients), len(slots.velocities))
        values = [point.matrix(h) for h in hessians]
        pairs = combinations_with_replacement(tangents, 2)
        second = [[_form(point, h, v, w) for h in values] for v, w in pairs]
        return point.rank(second) if second else 0

    try:
        found = states.sampled(at, 3)
    except (NoPointError, UnsupportedError, DivisionByZeroError):
        return None
    return found[0] if len(set(found)) == 1 else None


def _form(point: Point, matrix: list[list[object]], v: list[object], w: list[object]) -> object:
    """Σ M_ik v_i w_k."""
    terms = (x * a * y for x, row in zip(v, matrix, strict=True) for a, y in zip(row, w, strict=True))  # type: ignore[operator]
    return point.arithmetic.reduce(sum(terms))


def bending(row: Row, slots: Slots, states: Surface) -> Bending | None:
    """A direction in which a constraint bends, if one of two velocities does: to be shown."""
    phi = row.coefficients
    for i, k in combinations(range(len(phi)), 2):
        if phi[i] == 0 or phi[k] == 0:
            continue
        v, w = slots.velocities[i], slots.velocities[k]
        value = phi[k] ** 2 * phi[i].diff(v) - 2 * phi[i] * phi[k] * phi[i].diff(w) + phi[i] ** 2 * phi[k].diff(w)
        if states.is_zero(value) is False:
            return Bending((v, w), (phi[k], -phi[i]), textbook_form(value))
    return None
