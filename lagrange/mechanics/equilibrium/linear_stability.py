"""Stability of M ξ'' + D ξ' + K ξ = 0, from the signs of expressions in its matrices.

D is symmetric where it damps and antisymmetric where it is gyroscopic. For symmetric K:

    K positive definite, D supplies no energy          stable (Dirichlet, Thomson and Tait); asymptotically if D damps
                                                       every motion
    D = 0 or full damping, K takes negative values     unstable (Thomson, Tait, Chetaev)

and for any K:

    det K < 0, or some ω² < 0                          unstable: there is a real root p > 0
    otherwise                                          Hurwitz' conditions (n ≤ 2), or all ω² positive and different

A sign that the parameters leave open becomes a condition. If the answer depends on a root p = 0, it is undecided: the
neglected terms would have to be examined.

A wedge that is free to slide, two carts joined by a spring: if V does not change in a displacement n of constant
components, Σ n_k ∂V/∂q_k = 0 everywhere, the second variation is singular along n. But if V_kj is positive definite in
the other coordinates, these stay near the equilibrium and all velocities small, by the energy T + V, while the system
may drift along n: it is stable apart from that uniform motion (Routh, Stability of Motion, 1877). In the strict sense
its stability stays undecided.

Reference: N. G. Chetaev, The Stability of Motion, 1961.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from enum import StrEnum

import sympy as sp

from lagrange.algebra.closed_forms.conditions import where_positive
from lagrange.algebra.closed_forms.eigenmodes import Frequency, Matrix
from lagrange.algebra.closed_forms.signs import sign_on
from lagrange.algebra.closed_forms.solution_sets import Branch, known_positive
from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.mechanics.equilibrium.degenerate import UniformMotion
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import LONGEST_SECOND_VARIATION, MOST_MINORS
from lagrange.mechanics.equilibrium.stability import (
    SecondVariation,
    Stability,
    StabilityVerdict,
    by_signs,
    definiteness,
    on_branch,
    second_variation,
    with_critical_loads,
)


class VelocityTerms(StrEnum):
    """The kind of the terms with ξ'."""

    NONE = "none"
    GYROSCOPIC = "gyroscopic"
    DAMPED = "damped"


class Ground(StrEnum):
    """The criterion of the verdict."""

    POTENTIAL = "potential"  # the signs of K
    DETERMINANT = "determinant"  # det K < 0
    HURWITZ = "hurwitz"  # Hurwitz' conditions on the characteristic polynomial
    ROOTS = "roots"  # the signs of the ω²


@record
class StabilityJudgement:
    """The verdict, its criterion (None: undecided), and whether a stable motion dies away."""

    stability: Stability
    ground: Ground | None
    asymptotic: bool = False


@record
class LinearSystem:
    """M, D, K, shape (f, f); `roots`: the coefficients of the characteristic polynomial in ω² or in p, or None."""

    mass: Matrix
    damping: Matrix
    stiffness: Matrix
    kind: VelocityTerms
    symmetric: bool
    roots: Sequence[sp.Expr] | None
    frequencies: tuple[Frequency, ...]


def has_uniform_motion(s: LinearSystem) -> bool | None:
    """Whether ω = 0 belongs to a motion ξ = a t + b, with K a = 0 and K b + D a = 0, and not to displacements alone.

    None if that is undecided.

    A charge at rest in a magnetic field has K = 0, but each of its motions is a circle.
    """
    k, d = ([list(row) for row in rows] for rows in (s.stiffness, s.damping))
    size, surface = len(k), Surface()
    both = [[*row, *[sp.S.Zero] * size] for row in k] + [[*a, *b] for a, b in zip(d, k, strict=True)]
    of_both, of_stiffness = surface.rank(both), surface.rank(k)
    return None if of_both is None or of_stiffness is None else size > of_both - of_stiffness


def judged(s: LinearSystem, b: Branch, resting: Equilibrium) -> StabilityJudgement:
    """The verdict on stability at one equilibrium."""
    judgement = _undecided_in_part(_judged(s, b, resting), s, b)
    if s.kind is VelocityTerms.NONE and s.symmetric:
        judgement = replace(judgement, stability=but_for_uniform_motion(judgement.stability, b, resting))
    return replace(judgement, stability=with_critical_loads(judgement.stability, resting))


def _undecided_in_part(judgement: StabilityJudgement, s: LinearSystem, b: Branch) -> StabilityJudgement:
    """The judgement; if undecided, with the conditions for a negative ω²."""
    if judgement.stability.verdict is not StabilityVerdict.UNDECIDED:
        return judgement
    known = known_positive(b)
    opposite = [-f.square for f in s.frequencies if f.square is not None and not _has_root(f.square)]
    unstable = where_positive([w for w in opposite if sign_on(w, known) is None], known)
    return replace(judgement, stability=replace(judgement.stability, unstable=unstable))


def _judged(s: LinearSystem, b: Branch, resting: Equilibrium) -> StabilityJudgement:
    known = known_positive(b)
    squares = [f.square for f in s.frequencies]
    negative = [w for w in squares if w is not None and sign_on(w, known) == -1]
    if negative:
        return StabilityJudgement(by_signs(negative, b, resting), Ground.ROOTS)
    if s.symmetric:
        by_potential = _by_potential(s, b, resting, known)
        if by_potential is not None:
            return by_potential
    constant = on_branch(b, sp.Matrix(s.stiffness).det(method="berkowitz"), resting)
    if constant is not None and sign_on(constant, known) == -1:
        return StabilityJudgement(by_signs([constant], b, resting), Ground.DETERMINANT)
    if s.roots is None:
        return UNKNOWN
    return (_by_hurwitz if s.kind is VelocityTerms.DAMPED else _by_roots)(s.roots, b, resting)


UNKNOWN = StabilityJudgement(Stability(StabilityVerdict.UNDECIDED), None)


def _by_potential(
    s: LinearSystem, b: Branch, resting: Equilibrium, known: Sequence[sp.Expr]
) -> StabilityJudgement | None:
    """The verdict from the signs of K; None if it depends on D."""
    of_stiffness = definiteness(s.stiffness, b, resting)
    if s.kind is VelocityTerms.NONE:
        squares = [f.square for f in s.frequencies if f.square is not None]
        if of_stiffness.verdict is StabilityVerdict.CONDITIONAL and len(squares) == len(s.frequencies):
            by_roots = by_signs(squares, b, resting) if not any(map(_has_root, squares)) else of_stiffness
            if by_roots.verdict is StabilityVerdict.CONDITIONAL:
                simple = replace(of_stiffness, conditions=by_roots.conditions)
                return StabilityJudgement(simple, Ground.POTENTIAL)
        return StabilityJudgement(of_stiffness, Ground.POTENTIAL)
    size = len(s.damping)
    loss = tuple(tuple((s.damping[i][j] + s.damping[j][i]) / 2 for j in range(size)) for i in range(size))
    full = s.kind is VelocityTerms.DAMPED and definiteness(loss, b, resting).is_always_stable
    if full:
        return StabilityJudgement(of_stiffness, Ground.POTENTIAL, asymptotic=True)
    passive = s.kind is VelocityTerms.GYROSCOPIC or _is_passive(loss, known)
    if passive and of_stiffness.verdict is StabilityVerdict.STABLE:
        reaches = s.kind is VelocityTerms.DAMPED and s.roots is not None
        dies = reaches and _by_hurwitz(s.roots or (), b, resting).stability.is_always_stable
        return StabilityJudgement(of_stiffness, Ground.POTENTIAL, asymptotic=dies)
    return None


def _has_root(e: sp.Expr) -> bool:
    return any(p.exp.is_Rational and not p.exp.is_Integer for p in e.atoms(sp.Pow))


def kind_of(damping: Matrix, symmetric: bool) -> VelocityTerms:
    """The kind of the terms with ξ': none, gyroscopic, or damping; `symmetric`: whether K is.

    An antisymmetric D is gyroscopic only beside a symmetric K: otherwise the characteristic polynomial has odd powers
    of the exponent, as with damping.
    """
    if all(e == 0 for row in damping for e in row):
        return VelocityTerms.NONE
    pairs = ((damping[i][j], damping[j][i]) for i in range(len(damping)) for j in range(i + 1))
    gyroscopic = symmetric and all(is_zero(a + b) is True for a, b in pairs)
    return VelocityTerms.GYROSCOPIC if gyroscopic else VelocityTerms.DAMPED


def _is_passive(loss: Matrix, known: Sequence[sp.Expr]) -> bool:
    """Whether damping supplies no energy: no principal minor is negative, for at most two coordinates."""
    size = len(loss)
    if any(sign_on(loss[n][n], known) not in (0, 1) for n in range(size)) or size > 2:
        return False
    return size == 1 or sign_on(sp.expand(loss[0][0] * loss[1][1] - loss[0][1] ** 2), known) in (0, 1)


def _by_hurwitz(a: Sequence[sp.Expr], b: Branch, resting: Equilibrium) -> StabilityJudgement:
    """All roots p have negative real parts, up to the fourth degree: a_j > 0 and a_1 a_2 a_3 > a_0 a_3² + a_1² a_4."""
    a = _with_positive_leading(a, known_positive(b))
    if len(a) not in (3, 5):
        return UNKNOWN
    expressions = list(a[1:])
    if len(a) == 5:
        expressions.append(sp.expand(a[1] * a[2] * a[3] - a[0] * a[3] ** 2 - a[1] ** 2 * a[4]))
    return _if_positive(expressions, b, resting, Ground.HURWITZ, dies=True)


def _by_roots(a: Sequence[sp.Expr], b: Branch, resting: Equilibrium) -> StabilityJudgement:
    """All ω² real, positive and different, for at most two of them."""
    a = _with_positive_leading(a, known_positive(b))
    if len(a) not in (2, 3):
        return UNKNOWN
    if len(a) == 2:
        return _if_positive([-a[1]], b, resting, Ground.ROOTS, dies=False)
    discriminant = sp.expand(a[1] ** 2 - 4 * a[0] * a[2])
    judgement = _if_positive([a[2], -a[1], discriminant], b, resting, Ground.ROOTS, dies=False)
    return _where_different(judgement)


def _where_different(judgement: StabilityJudgement) -> StabilityJudgement:
    """Stable only if the roots are different: a discriminant (c J − κ m)² is positive unless c J = κ m."""
    stability = judgement.stability
    if stability.verdict is not StabilityVerdict.STABLE or not stability.presupposed:
        return judgement
    conditional = replace(
        stability, verdict=StabilityVerdict.CONDITIONAL, conditions=stability.presupposed, presupposed=()
    )
    return replace(judgement, stability=conditional)


def _with_positive_leading(a: Sequence[sp.Expr], known: Sequence[sp.Expr]) -> list[sp.Expr]:
    """The coefficients with a positive leading one; none if its sign is not known."""
    sign = sign_on(a[0], known) if a else None
    return [] if sign not in (1, -1) else [sign * c for c in a]


def _if_positive(
    expressions: Sequence[sp.Expr], b: Branch, resting: Equilibrium, ground: Ground, dies: bool
) -> StabilityJudgement:
    """Stable where all expressions are positive, unstable where one is negative."""
    stability = by_signs(expressions, b, resting)
    decided = stability.verdict in (StabilityVerdict.STABLE, StabilityVerdict.CONDITIONAL)
    return StabilityJudgement(stability, ground, dies and decided)


def stability_at_rest(e: Equilibrium) -> SecondVariation | None:
    """The second variation; its undecided verdicts with the uniform motion that they leave open, where it is one."""
    second = second_variation(e)
    if second is None or all(s.verdict is not StabilityVerdict.UNDECIDED for s in second.verdicts):
        return second
    verdicts = (but_for_uniform_motion(s, b, e) for b, s in zip(e.branches, second.verdicts, strict=True))
    return replace(second, verdicts=tuple(verdicts))


def but_for_uniform_motion(s: Stability, b: Branch, e: Equilibrium) -> Stability:
    """An undecided verdict; with the motion that it leaves open, where V has a minimum in the other coordinates."""
    if s.verdict is not StabilityVerdict.UNDECIDED or b.left or b.special or e.forces or any(map(any, e.idle)):
        return s
    directions = free_directions(e)
    size = len(e.independent_forces)
    if not directions or len(directions) == size:
        return s
    q = e.configuration.slots.coordinates
    pivots = sp.Matrix(directions).rref()[1]
    others = [k for k in range(size) if k not in pivots]
    second = [[on_branch(b, -e.independent_forces[k].diff(q[j]), e) for j in others] for k in others]
    if any(x is None for row in second for x in row):
        return s
    inner = definiteness([[x for x in row if x is not None] for row in second], b, e)
    if inner.verdict not in (StabilityVerdict.STABLE, StabilityVerdict.CONDITIONAL):
        return s
    inner = with_critical_loads(inner, e)
    moving = tuple(q[k] for k in range(size) if any(n[k] != 0 for n in directions))
    conditions = (*inner.conditions, *inner.presupposed)
    return replace(s, drift=UniformMotion(moving, tuple(q[k] for k in others), conditions, len(directions) > 1))


def free_directions(e: Equilibrium) -> tuple[tuple[sp.Expr, ...], ...]:
    """The displacements n of constant components, shape (f,), in which V does not change; none with constraints."""
    q, forces = e.configuration.slots.coordinates, e.independent_forces
    size = len(forces)
    if e.elimination.dependent or len(q) != size or not 1 < size <= MOST_MINORS:
        return ()
    second = sp.Matrix(size, size, lambda k, j: forces[k].diff(q[j]))
    if sum(count_operations(x) for x in second) > LONGEST_SECOND_VARIATION:
        return ()
    if _vanishes(second - second.T) is not True:
        return ()
    lone = [j for j in range(size) if all(second[k, j] == 0 for k in range(size))]
    if lone:
        candidates = [sp.Matrix([sp.Integer(int(k == j)) for k in range(size)]) for j in lone]
    else:
        candidates = second.nullspace(iszerofunc=lambda x: is_zero(x) is True)
    constant = [sp.Matrix([sp.cancel(x) for x in n]) for n in candidates]
    free = [n for n in constant if not n.free_symbols & {*q}]
    work = [sum((a * f for a, f in zip(n, forces, strict=True)), sp.S.Zero) for n in free]
    zero = all(is_zero(w) is True for w in work) and all(_vanishes(second * n) is True for n in free)
    return tuple(tuple(n) for n in free) if zero and len(free) == len(candidates) else ()


def _vanishes(m: sp.Matrix) -> bool | None:
    """Whether all entries are zero; None if that is undecided."""
    verdicts = [is_zero(x) for x in m]
    return None if None in verdicts else all(verdicts)
