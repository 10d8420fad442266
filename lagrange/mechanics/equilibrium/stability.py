"""Stability of an equilibrium, from the second variation of the potential energy.

Where the virtual work is the variation of a potential, δW = −δV, an equilibrium at which V has a strict minimum is
stable (Lagrange, Dirichlet), and one at which the second variation takes negative values is unstable. With the
displacements that the constraints leave free,

    V_kj = −D_j Q_k ,      D_j = ∂/∂q_j + Σ_d B_dj ∂/∂q_d ,      Q_k the generalized force of the free δq_k ,

and there is a potential where V_kj = V_jk. The signs of the leading minors decide. A sign that the parameters leave
open becomes a condition. Where V'' of one coordinate vanishes, the first derivative of V that does not decides; a minor
that vanishes leaves the question undecided.

Where a pivot of the displacements vanishes at an equilibrium (a bead at the lowest point of x² + y² = l²), others are
free there, and V_kj is that of V − Σ λ f with the multipliers λ of the equilibrium, in displacements with A δq = 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import StrEnum

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import MOST_OPERATIONS, factors
from lagrange.algebra.closed_forms.presentation import shown
from lagrange.algebra.closed_forms.signs import Condition, more_than_zero, sign_of
from lagrange.algebra.closed_forms.solution_sets import Branch, resolved
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.exact import Surface, is_zero
from lagrange.core.records import record
from lagrange.mechanics.constraints.displacements import eliminate
from lagrange.mechanics.constraints.kinematics import Row
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

MOST_COORDINATES = 4
HIGHEST_ORDER = 6
"""Of the derivatives of V that are looked at."""


class Verdict(StrEnum):
    """What the second variation says."""

    STABLE = "stable"
    UNSTABLE = "unstable"
    CONDITIONAL = "conditional"
    UNDECIDED = "undecided"


@record
class Stability:
    """The verdict on one branch.

    minors      the leading minors of V_kj on the branch; the first is V'' where there is one coordinate
    conditions  stable where these hold
    unstable    of what is undecided: unstable where one of these holds
    order       of the first derivative of V that is not zero, in one coordinate; `minors` has it
    free        the coordinates of the free δq where they are others than elsewhere, and multipliers are used
    """

    verdict: Verdict
    minors: tuple[sp.Expr, ...] = ()
    conditions: tuple[Condition, ...] = ()
    unstable: tuple[Condition, ...] = ()
    order: int = 2
    free: tuple[sp.Symbol, ...] = ()


@record
class SecondVariation:
    """V_kj, shape (f, f), by the coordinates whose displacements are free, and what it says of each branch."""

    coordinates: tuple[sp.Symbol, ...]
    matrix: tuple[tuple[sp.Expr, ...], ...]
    verdicts: tuple[Stability, ...]


def second_variation(e: Equilibrium) -> SecondVariation | None:
    """The stability of all branches; None where there is no potential or nothing to say.

    Forces that are to be found have no law, so that nothing is said where there are any.
    """
    free = e.elimination.independent
    if e.forces or not 0 < len(free) <= MOST_COORDINATES or not e.branches:
        return None
    q = e.configuration.slots.coordinates
    matrix = []
    for force in e.independent_forces:
        row = []
        for column in range(len(free)):
            row.append(e.work.textbook.form(-_along(force, column, e)))
        matrix.append(tuple(row))
    if not _is_symmetric(matrix, e):
        return None
    return SecondVariation(tuple(q[k] for k in free), tuple(matrix), tuple(_verdict(b, matrix, e) for b in e.branches))


def _along(expression: sp.Expr, column: int, e: Equilibrium) -> sp.Expr:
    """D_j of an expression, j being the coordinate of a free displacement."""
    q = e.configuration.slots.coordinates
    found = expression.diff(q[e.elimination.independent[column]])
    for d, solved in zip(e.elimination.dependent, e.elimination.solution, strict=True):
        found += solved[column] * expression.diff(q[d])
    return found


def _is_symmetric(matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> bool:
    """Whether V_kj = V_jk: everywhere, or with constraints at each equilibrium."""
    for k, row in enumerate(matrix):
        for j in range(k):
            difference = row[j] - matrix[j][k]
            if e.configuration.surface.is_zero(difference):
                continue
            for b in e.branches:
                on_it = None if b.left or b.special else on_branch(b, difference, e)
                if on_it is None or not is_zero(on_it):
                    return False
    return True


def on_branch(b: Branch, expression: sp.Expr, e: Equilibrium, in_parameters: bool = False) -> sp.Expr | None:
    """An expression on a branch, in factors; None where it cannot be written down.

    in_parameters  whether a form without coordinates is wanted, ω² − g²/(R² ω²) and not ω² sin² θ; else one whose sign
                   is known
    """
    letters = e.solution.letters
    for jump in expression.atoms(sp.DiracDelta):
        at = on_branch(b, jump.args[0], e)
        if at is None or sign_on(at, known_positive(b)) not in (1, -1):
            return None
        expression = expression.xreplace({jump: sp.S.Zero})  # the derivative of a sign, beside its jump
    try:
        there = resolved(letters.read(expression), b.common)
    except NotAlgebraicError:
        return None
    for root in letters.roots:
        if root in there.free_symbols:
            there = there.xreplace({root: resolved(letters.roots[root], b.common) ** sp.S.Half})
    if there.has(sp.zoo, sp.nan) or there.count_ops() > 4 * MOST_OPERATIONS:
        return None
    above, below = sp.fraction(sp.cancel(sp.together(there)))
    numerators = [above, letters.reduced(above)]
    if in_parameters:
        numerators.append(resolved(numerators[1], b.common))
    forms = []
    for p in numerators:
        product = sp.factor(p) if factors(p) is not None else p
        forms.append(letters.write(product) / letters.write(sp.factor(below)))
    if in_parameters:
        unknowns = {*e.solution.unknowns}
        return min(forms, key=lambda f: (bool(f.free_symbols & unknowns), f.count_ops()))
    return min(forms, key=lambda f: (sign_of(f) is None, f.count_ops()))


def _verdict(b: Branch, matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> Stability:
    if b.left or b.special:
        return Stability(Verdict.UNDECIDED)
    if any(_vanishes(p, b, e) for p in e.elimination.pivots):
        return _with_multipliers(b, e)
    entries = [on_branch(b, x, e) for row in matrix for x in row]
    if any(x is None for x in entries):
        return Stability(Verdict.UNDECIDED)
    width = len(matrix)
    if width == 1 and entries[0] is not None and is_zero(entries[0]):
        return _by_higher_derivatives(matrix[0][0], b, e)
    return definiteness(
        [[x for x in entries[n * width : (n + 1) * width] if x is not None] for n in range(width)], b, e
    )


def _by_higher_derivatives(second: sp.Expr, b: Branch, e: Equilibrium) -> Stability:
    """The verdict in one coordinate where V'' is zero: the first derivative that is not decides, of even order."""
    undecided = Stability(Verdict.UNDECIDED, (sp.S.Zero,))
    derivative, known = second, known_positive(b)
    for order in range(3, HIGHEST_ORDER + 1):
        derivative = e.work.textbook.form(_along(derivative, 0, e))
        there = on_branch(b, derivative, e)
        sign = None if there is None else sign_on(there, known)
        if there is None or sign is None:
            return undecided
        if sign != 0:
            stable = order % 2 == 0 and sign == 1
            return Stability(Verdict.STABLE if stable else Verdict.UNSTABLE, (shown(there),), order=order)
    return undecided


def _with_multipliers(b: Branch, e: Equilibrium) -> Stability:
    """The verdict from the second variation of V − Σ λ f, in the displacements that are free on the branch."""
    undecided = Stability(Verdict.UNDECIDED)
    if any(r.finite is None for r in e.binding):
        return undecided
    q = e.configuration.slots.coordinates
    rows = [[on_branch(b, a, e) for a in r.coefficients] for r in e.binding]
    second = [[on_branch(b, -f.diff(x), e, in_parameters=True) for x in q] for f in e.balance(e.multipliers)]
    found = [x for row in (*rows, *second) for x in row]
    if any(x is None or x.free_symbols & {*e.multipliers} for x in found):
        return undecided
    there = eliminate(
        [Row(r.name, tuple(row), sp.S.Zero) for r, row in zip(e.binding, rows, strict=True)], len(q), Surface()
    )
    if len(there.independent) != len(e.elimination.independent):
        return undecided
    shape = sp.Matrix(there.shape(len(q)))
    reduced = (shape.T * sp.Matrix(second) * shape).tolist()
    return replace(definiteness(reduced, b, e), free=tuple(q[k] for k in there.independent))


def definiteness(matrix: Sequence[Sequence[sp.Expr]], b: Branch, e: Equilibrium) -> Stability:
    """Whether a symmetric matrix, shape (f, f), written as it is on a branch, is positive definite.

    Stable: it is; unstable: it takes negative values; conditional: it is where the conditions hold.
    """
    minors = []
    for n in range(1, len(matrix) + 1):
        minor = on_branch(b, sp.Matrix([list(row[:n]) for row in matrix[:n]]).det(method="berkowitz"), e)
        if minor is None:
            return Stability(Verdict.UNDECIDED)
        minors.append(minor)
    known = known_positive(b)
    signs = [sign_on(m, known) for m in minors]
    written = tuple(min(m, shown(m), key=lambda x: int(x.count_ops())) for m in minors)
    diagonal = [sign_on(matrix[n][n], known) for n in range(len(matrix))]
    if -1 in diagonal or _is_indefinite(signs):
        return Stability(Verdict.UNSTABLE, written)
    if 0 in signs:
        open_ = [-matrix[n][n] for n, sign in enumerate(diagonal) if sign is None]
        return Stability(Verdict.UNDECIDED, written, unstable=where_positive(open_, known))
    if None not in signs:
        return Stability(Verdict.STABLE, written)
    conditions = conditions_for(minors, known)
    return (
        Stability(Verdict.UNDECIDED, written)
        if conditions is None
        else Stability(Verdict.CONDITIONAL, written, conditions)
    )


def known_positive(b: Branch) -> list[sp.Expr]:
    """What is positive on a branch, by the conditions under which it exists."""
    known = [c.lhs - c.rhs for c in b.conditions if c.relation in ("≥", ">")]
    known += [c.rhs - c.lhs for c in b.conditions if c.relation in ("≤", "<")]
    return [sp.factor(p) for p in known]


def conditions_for(expressions: Iterable[sp.Expr], known: Sequence[sp.Expr]) -> tuple[Condition, ...] | None:
    """The conditions under which all of them are positive; None where they are too long to be of use."""
    known = list(known)
    wanted = []
    for e in expressions:
        if sign_on(e, known) is None:
            wanted.append(more_than_zero(e, known))
            known.append(sp.factor(wanted[-1].lhs - wanted[-1].rhs) * (-1 if wanted[-1].relation == "<" else 1))
    if any((c.lhs - c.rhs).count_ops() > MOST_OPERATIONS for c in wanted):
        return None
    return tuple(Condition(shown(c.lhs), c.relation, shown(c.rhs)) for c in _without_weaker(wanted))


def _without_weaker(conditions: Sequence[Condition]) -> list[Condition]:
    """Without those that another one implies: of e > 2a and e > 4a, with a > 0, the second."""
    above = [(c.lhs - c.rhs) * (-1 if c.relation == "<" else 1) for c in conditions]
    kept = list(range(len(conditions)))
    for n in range(len(conditions)):
        others = [k for k in kept if k != n]
        if any(sign_of(sp.expand(above[n] - above[k])) in (0, 1) for k in others):
            kept = others
    return [conditions[k] for k in kept]


def where_positive(expressions: Iterable[sp.Expr], known: Sequence[sp.Expr]) -> tuple[Condition, ...]:
    """The condition that each of them is positive, one by one; without those that are too long to be of use."""
    found = (conditions_for([e], known) for e in expressions)
    return tuple(dict.fromkeys(c for conditions in found for c in conditions or ()))


def _vanishes(pivot: sp.Expr, b: Branch, e: Equilibrium) -> bool:
    """Whether what was divided by is zero, or may be, on a branch: then other δq would have to be the free ones."""
    there = on_branch(b, pivot, e)
    return there is None or is_zero(there) is not False


def _is_indefinite(signs: list[int | None]) -> bool:
    """Whether the leading minors, of known signs as far as this, exclude a minimum: a negative one of them."""
    for s in signs:
        if s == -1:
            return True
        if s != 1:
            return False
    return False


def sign_on(e: sp.Expr, known: Sequence[sp.Expr]) -> int | None:
    """The sign of an expression where others are known to be positive; None where it may be either."""
    if e == 0 or is_zero(e):
        return 0
    return sign_of(e, known)
