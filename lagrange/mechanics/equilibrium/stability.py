"""Stability of an equilibrium, from the second variation of the potential energy.

If the virtual work is the variation of a potential, δW = −δV, an equilibrium at a strict minimum of V is stable
(Lagrange, Dirichlet), and one at which the second variation takes negative values is unstable. With the displacements
that the constraints leave free,

    V_kj = −D_j Q_k ,      D_j = ∂/∂q_j + Σ_d B_dj ∂/∂q_d ,      Q_k the generalized force of the free δq_k ,

and there is a potential if V_kj = V_jk. The signs of the principal minors decide (`definiteness`). A sign that the
parameters leave open becomes a condition. If V'' of a single coordinate vanishes, the first derivative of V that does
not vanish decides, and with several the lowest terms of V in the directions in which V'' vanishes (`degenerate`).

At a pole of the coordinates V_kj is that in other coordinates (`admissible_positions`).

Where a pivot of the displacements vanishes at an equilibrium (a bead at the lowest point of x² + y² = l²), other
displacements are free there, and V_kj is that of V − Σ λ f with the multipliers λ of the equilibrium, for A δq = 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from enum import StrEnum
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.conditions import (
    NeverPositiveError,
    conditions_for,
    further_conditions,
    only_excludes_equality,
    positive_part,
    where_positive,
)
from lagrange.algebra.closed_forms.limits import LARGEST_FACTORED
from lagrange.algebra.closed_forms.polynomial_roots import can_be_factored
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import (
    SignCondition,
    bases,
    different_from_zero,
    more_than_zero,
    sign_of,
    sign_on,
)
from lagrange.algebra.closed_forms.solution_sets import Branch, at_numbers, known_positive, resolved
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.core.effort import within
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.displacements import Elimination, eliminate
from lagrange.mechanics.equilibrium.admissible_positions import QUARTER, radius_at, slope, without_pole
from lagrange.mechanics.equilibrium.degenerate import (
    LowestForm,
    Neighbourhood,
    UniformMotion,
    along_free,
    chart_of,
    is_definite,
    lowest_form,
    rises_in_even_powers,
    sign_of_form,
)
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import HIGHEST_ORDER, LONGEST_UNSOLVED, MOST_MINORS, UNITS_OF_LOWEST_FORM
from lagrange.mechanics.equilibrium.loads import for_loads


class StabilityVerdict(StrEnum):
    """The verdict of the second variation."""

    STABLE = "stable"
    UNSTABLE = "unstable"
    CONDITIONAL = "conditional"
    UNDECIDED = "undecided"


@record
class Stability:
    """The verdict on one branch.

    minors      the leading minors of V_kj on the branch; the first is V'' if there is one coordinate
    conditions  stable where these hold
    presupposed if stable or unstable: what must hold for the signs to be strict; otherwise nothing is decided
    unstable    if undecided: unstable where one of these holds
    principal   a negative principal minor, if it decides and is not among the leading ones
    order       of the first nonzero derivative of V in one coordinate; `minors` contains it
    free        the coordinates of the free δq, if they differ from those elsewhere and multipliers are used
    valley      the coordinate along a valley of V (`degenerate`), if the derivative of that order is one along it
    lowest      the lowest terms of V along a valley of several coordinates, which decide
    even_powers whether V is a sum of even powers with positive coefficients (`degenerate`), which decides
    pole        θ and φ, if V_kj is that with respect to θ cos φ, θ sin φ and the others
    at_limit    if conditional, in one coordinate: the verdict where the condition is an equality and V'' vanishes
    drift       if undecided: the uniform motion that alone keeps it from being stable
    """

    verdict: StabilityVerdict
    minors: tuple[sp.Expr, ...] = ()
    conditions: tuple[SignCondition, ...] = ()
    presupposed: tuple[SignCondition, ...] = ()
    unstable: tuple[SignCondition, ...] = ()
    principal: sp.Expr | None = None
    order: int = 2
    free: tuple[sp.Symbol, ...] = ()
    valley: sp.Symbol | None = None
    lowest: LowestForm | None = None
    even_powers: bool = False
    pole: tuple[sp.Symbol, ...] = ()
    at_limit: Stability | None = None
    drift: UniformMotion | None = None

    @property
    def is_always_stable(self) -> bool:
        """Whether it is stable for all values of the parameters."""
        return self.verdict is StabilityVerdict.STABLE and not self.presupposed


UNKNOWN = Stability(StabilityVerdict.UNDECIDED)


@record
class SecondVariation:
    """V_kj, shape (f, f), in the coordinates with free displacements, and the verdict on each branch.

    jumps  arguments of signs and moduli in the forces: the V_kj hold where none of them is zero
    """

    coordinates: tuple[sp.Symbol, ...]
    matrix: tuple[tuple[sp.Expr, ...], ...]
    verdicts: tuple[Stability, ...]
    jumps: tuple[sp.Expr, ...] = ()


def second_variation(e: Equilibrium) -> SecondVariation | None:
    """The stability of all branches; None without a potential, free displacements or equilibria.

    None as well if there are unknown forces: away from the equilibrium they have no law.
    """
    free = e.elimination.independent
    if e.forces or not 0 < len(free) <= MOST_MINORS or not e.branches:
        return None
    q = e.configuration.slots.coordinates
    matrix = [
        tuple(e.work.textbook.form(-along_free(force, column, e)) for column in range(len(free)))
        for force in e.independent_forces
    ]
    if not _is_symmetric(matrix, e):
        return None
    verdicts = tuple(with_critical_loads(_verdict(b, matrix, e), e) for b in e.branches)
    jumps = {jump for row in matrix for v in row for jump in v.atoms(sp.DiracDelta)}
    smooth = dict.fromkeys(jumps, sp.S.Zero)
    table = tuple(tuple(e.work.textbook.form(v.xreplace(smooth)) if jumps else v for v in row) for row in matrix)
    arguments = tuple(sorted({jump.args[0] for jump in jumps}, key=str))
    return SecondVariation(tuple(q[k] for k in free), table, verdicts, arguments)


def with_critical_loads(s: Stability, e: Equilibrium) -> Stability:
    """The verdict with its conditions solved for loads."""
    stated, presupposed, unstable = (for_loads(c, e.configuration) for c in (s.conditions, s.presupposed, s.unstable))
    return replace(s, conditions=stated, presupposed=presupposed, unstable=unstable)


def _is_symmetric(matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> bool:
    """Whether V_kj = V_jk: everywhere, or with constraints at each equilibrium."""
    for k, row in enumerate(matrix):
        for j in range(k):
            difference = row[j] - matrix[j][k]
            if e.configuration.surface.is_zero(difference):
                continue
            for b in e.branches:
                value = None if b.left or b.special else on_branch(b, difference, e)
                if value is None or not is_zero(value):
                    return False
    return True


def on_branch(b: Branch, expression: sp.Expr, e: Equilibrium, in_parameters: bool = False) -> sp.Expr | None:
    """An expression on a branch, in factors; None if it cannot be written in closed form.

    in_parameters  whether to prefer a form without coordinates, ω² − g²/(R² ω²) and not ω² sin² θ; otherwise one with a
                   known sign
    """
    letters = e.solution.letters
    for jump in expression.atoms(sp.DiracDelta):
        argument = on_branch(b, jump.args[0], e)
        if argument is None or sign_on(argument, known_positive(b)) not in (1, -1):
            return None
        expression = expression.xreplace({jump: sp.S.Zero})  # the derivative of a sign, away from its jump
    try:
        value = resolved(letters.read(expression), b.common)
    except NotAlgebraicError:
        if not b.relations and not b.common:  # on it all positions are alike: r^n stays what it is
            return sp.factor_terms(sp.powsimp(sp.expand(expression)))
        return at_numbers(b, expression, e.solution.unknowns)
    for root in letters.roots:
        if root in value.free_symbols:
            value = value.xreplace({root: resolved(letters.roots[root], b.common) ** sp.S.Half})
    if value.has(sp.zoo, sp.nan) or count_operations(value) > 4 * LARGEST_FACTORED:
        return None
    numerator, denominator = sp.fraction(sp.cancel(sp.together(value)))
    try:
        reduced = [letters.reduced(numerator, keep) for keep in ("cosine", "sine")]
        numerators = [numerator, reduced[0], *(resolved(p, b.common) for p in reduced)]  # sin θ may have a value
    except sp.PolynomialError:  # a root of roots, such as the rate of a body drawn to two centres
        numerators = [numerator]
    divisor = letters.write(sp.factor(denominator))
    forms = []
    for p in dict.fromkeys(numerators):
        product = sp.factor(p) if can_be_factored(p) else p
        forms.append(letters.write(product) / divisor)
    if in_parameters:
        unknowns = {*e.solution.unknowns}
        return min(forms, key=lambda f: (bool(f.free_symbols & unknowns), count_operations(f)))
    positive = known_positive(b)
    return min(forms, key=lambda f: (sign_on(f, positive) is None, count_operations(f)))


def _verdict(b: Branch, matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> Stability:
    if b.special or (b.left and e.elimination.pivots):
        return UNKNOWN
    if b.left:
        return within(UNITS_OF_LOWEST_FORM, lambda: _where_it_is_definite(b, matrix, e)) or UNKNOWN
    judged = _on_solved_branch(b, matrix, e)
    if judged.verdict is StabilityVerdict.CONDITIONAL and len(matrix) == 1 and not judged.free:
        return _with_limit(judged, matrix[0][0], b, e)
    if judged.verdict is StabilityVerdict.UNDECIDED and not judged.unstable:
        lowest = within(UNITS_OF_LOWEST_FORM, lambda: _by_lowest_form(b, matrix, e))
        if lowest is not None:
            return replace(lowest, free=judged.free, minors=lowest.minors or judged.minors)
        if _rises(b, matrix, e):
            return Stability(StabilityVerdict.STABLE, judged.minors, even_powers=True)
        verdict = by_numbers(matrix, e, b)
        minors = judged.minors or tuple(_in_coordinates(matrix, n, e) for n in range(1, len(matrix) + 1))
        judged = replace(judged, verdict=verdict, minors=minors if verdict is not judged.verdict else judged.minors)
    return judged


def _in_coordinates(matrix: Sequence[Sequence[sp.Expr]], rows: int, e: Equilibrium) -> sp.Expr:
    """A leading minor before the values at an equilibrium are substituted."""
    return e.work.textbook.form(sp.Matrix([[matrix[i][j] for j in range(rows)] for i in range(rows)]).det())


def _on_solved_branch(b: Branch, matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> Stability:
    if any(_vanishes(p, b, e) for p in e.elimination.pivots):
        return _with_multipliers(b, e)
    entries = [on_branch(b, x, e) for row in matrix for x in row]
    if any(x is None for x in entries):
        return UNKNOWN
    width = len(matrix)
    if any(idle and o is b for o, idle in zip(e.branches, e.idle, strict=False)):
        return _at_pole([entries[n * width : (n + 1) * width] for n in range(width)], b, e)
    if width == 1 and entries[0] is not None and is_zero(entries[0]):
        return _by_higher_derivatives(matrix[0][0], b, e)
    shorter = _of_first_harmonic(matrix[0][0], entries[0], b, e) if width == 1 else None
    if shorter is not None:
        judged = definiteness([[shorter]], b, e)  # cos θ ≠ 0 where tan θ has a value
        return judged if sign_of(sp.fraction(shorter)[0]) is None else replace(judged, presupposed=())
    return definiteness(
        [[x for x in entries[n * width : (n + 1) * width] if x is not None] for n in range(width)], b, e
    )


def _of_first_harmonic(second: sp.Expr, value: sp.Expr | None, b: Branch, e: Equilibrium) -> sp.Expr | None:
    """V'' = B/cos θ − V' tan θ for V' = A cos θ + B sin θ, where V' = 0 at a given tan θ; None if it is not shorter.

    second  V''
    value   what it is on the branch, in the form found before
    """
    [k], [force] = e.elimination.independent, e.independent_forces
    q = e.configuration.slots.coordinates[k]
    if value is None or not value.has(q) or not any(r.lhs == sp.tan(q) for r in b.relations):
        return None
    constant = -force.xreplace({q: sp.pi / 2})
    if constant.has(q) or is_zero(second * sp.cos(q) - force * sp.sin(q) - constant) is not True:
        return None
    forms = (constant, e.work.textbook.form(constant), sp.factor(sp.expand_trig(constant)))
    shorter = min(map(shortest_form, forms), key=lambda x: count_operations(x)) / sp.cos(q)
    return shorter if count_operations(shorter) < count_operations(value) else None


def _at_pole(values: Sequence[Sequence[sp.Expr]], b: Branch, e: Equilibrium) -> Stability:
    """The verdict where a coordinate φ moves nothing: in coordinates that are regular there, if φ is an angle."""
    [idle] = (idle for o, idle in zip(e.branches, e.idle, strict=False) if o is b)
    free = [e.configuration.slots.coordinates[k] for k in e.elimination.independent]
    phi = idle[0]
    theta = radius_at(e.configuration, e.solution, b, phi) if len(idle) == 1 else None
    if {phi, theta} <= {*free} and not any(r.residual.has(phi) for r in b.equations):
        regular = without_pole(values, free.index(theta), free.index(phi), phi)
        if regular:
            return replace(definiteness(regular, b, e), pole=(theta, phi))
    return definiteness(values, b, e)


def by_numbers(matrix: Sequence[Sequence[sp.Expr]], e: Equilibrium, b: Branch) -> StabilityVerdict:
    """The verdict at points that are numbers, if it is the same at all of them."""
    verdicts = {is_definite(matrix, e, p) for p in b.points}
    if verdicts == {True}:
        return StabilityVerdict.STABLE
    return StabilityVerdict.UNSTABLE if verdicts == {False} else StabilityVerdict.UNDECIDED


def _where_it_is_definite(b: Branch, matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> Stability:
    """The verdict at equations that are not solved: the conditions are in the coordinates, if they are short."""
    if b.occupied and len(matrix) == 1 and e.configuration.ranges.get(e.solution.unknowns[0]) == QUARTER:
        rise = slope(-e.independent_forces[0], e.solution.unknowns[0])
        if rise is not None:
            verdict = StabilityVerdict.STABLE if rise[1] == 1 else StabilityVerdict.UNSTABLE
            return Stability(verdict, (rise[0],))
    if any(x.has(sp.DiracDelta) for row in matrix for x in row):
        return UNKNOWN
    minors = [_minor(matrix, range(n), b, e) for n in range(1, len(matrix) + 1)]
    known = [m for m in minors if m is not None and not is_zero(m)]
    if len(known) < len(minors):
        return UNKNOWN
    judged = by_signs(known, b, e)
    if len(minors) == 1 and judged.verdict is not StabilityVerdict.STABLE:
        second = matrix[0][0]
        return Stability(StabilityVerdict.CONDITIONAL, (second,), (SignCondition(second, ">", sp.S.Zero),))
    if sum(count_operations(c.lhs - c.rhs) for c in judged.conditions) > LONGEST_UNSOLVED:
        return UNKNOWN
    return replace(judged, minors=tuple(min(m, shortest_form(m), key=lambda x: count_operations(x)) for m in known))


def _with_limit(judged: Stability, second: sp.Expr, b: Branch, e: Equilibrium) -> Stability:
    """A verdict for one coordinate, k > m g l, with that where V'' vanishes, k = m g l."""
    [c, *others] = judged.conditions or (None,)
    if c is None or others or not c.lhs.is_Symbol or c.rhs.has(c.lhs) or c.relation not in "><" or b.conditions:
        return judged
    if judged.order > 2 or sign_of(c.rhs) != 1 or {c.lhs, *c.rhs.free_symbols} & {*e.solution.unknowns}:
        return judged
    there = _by_higher_derivatives(second, b, e, {c.lhs: c.rhs})
    return judged if there.verdict is StabilityVerdict.UNDECIDED else replace(judged, at_limit=there)


def _by_higher_derivatives(
    second: sp.Expr, b: Branch, e: Equilibrium, critical: Mapping[sp.Symbol, sp.Expr] | None = None
) -> Stability:
    """The verdict in one coordinate with V'' = 0: stable if the first nonzero derivative is even and positive.

    critical  the value of a parameter for which V'' is 0
    """
    undecided = Stability(StabilityVerdict.UNDECIDED, (sp.S.Zero,))
    derivative, known = second, known_positive(b)
    for order in range(3, HIGHEST_ORDER + 1):
        derivative = e.work.textbook.form(along_free(derivative, 0, e))
        value = on_branch(b, derivative, e)
        value = sp.factor(value.xreplace(dict(critical))) if value is not None and critical else value
        sign = None if value is None else sign_on(value, known)
        if value is None or sign is None:
            return undecided
        if sign != 0:
            verdict = StabilityVerdict.STABLE if order % 2 == 0 and sign == 1 else StabilityVerdict.UNSTABLE
            presupposed = not_vanishing([value], b, e)
            return Stability(verdict, (shortest_form(value),), presupposed=presupposed, order=order)
    return undecided


def _by_lowest_form(b: Branch, matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> Stability | None:
    """The verdict by the lowest terms of V where V'' vanishes in some directions, and is positive in the others."""
    if any(map(any, e.idle)) or any(r.finite is None for r in e.binding):
        return None  # the free displacements are those of no surface
    vanish = any(_vanishes(p, b, e) for p in e.elimination.pivots)
    there = (
        _eliminated([[on_branch(b, a, e) for a in r.coefficients] for r in e.binding], e) if vanish else e.elimination
    )
    chart = chart_of(there, e, () if vanish else matrix) if there else None
    values = [[on_branch(b, x, e) for x in row] for row in chart.matrix] if chart else []
    if chart is None or any(x is None for row in values for x in row):
        return None
    size, known = len(values), known_positive(b)
    for valley in (v for number in range(1, size + 1) for v in combinations(range(size), number)):
        others = [k for k in range(size) if k not in valley]
        inner = definiteness([[values[i][j] for j in others] for i in others], b, e) if others else None
        if inner is not None and (inner.verdict is not StabilityVerdict.STABLE or inner.presupposed):
            continue
        lowest = lowest_form(chart.matrix, valley, chart.along, lambda f: on_branch(b, f, e))
        if lowest is None:
            continue
        judged = sign_of_form(lowest, lambda c: sign_on(c, known))
        if judged is None:
            return None
        return _of_lowest(lowest, *judged, chart, valley, b, e)
    return None


def _of_lowest(
    lowest: LowestForm, sign: int, positive: Sequence[sp.Expr], chart: Neighbourhood, valley: Sequence[int], b: Branch,
    e: Equilibrium,
) -> Stability | None:  # fmt: skip
    """The verdict of a form that is positive definite where some expressions are positive, or takes negative values."""
    verdict = StabilityVerdict.STABLE if sign == 1 else StabilityVerdict.UNSTABLE
    along = tuple(chart.free[k] for k in valley)
    if len(along) == 1:
        value = lowest.derivative
        presupposed = not_vanishing([value], b, e)
        only = along[0] if len(chart.free) > 1 else None
        return Stability(verdict, (shortest_form(value),), presupposed=presupposed, order=lowest.order, valley=only)
    named = lowest.in_coordinates(along)
    conditions = conditions_for(positive, known_positive(b)) if positive else ()
    if conditions is None:
        return None
    verdict = StabilityVerdict.CONDITIONAL if conditions else verdict
    presupposed = () if conditions else not_vanishing(sp.Poly(named.form, *along).coeffs(), b, e)
    return Stability(verdict, conditions=conditions, presupposed=presupposed, order=lowest.order, lowest=named)


def _eliminated(rows: Sequence[Sequence[sp.Expr | None]], e: Equilibrium) -> Elimination | None:
    """The displacements that are free on a branch, `rows` being A there; None if there are not as many."""
    known = [tuple(a for a in row if a is not None) for row in rows]
    n = len(e.configuration.slots.coordinates)
    if any(len(row) < n for row in known):
        return None
    named = [Row(r.name, row, sp.S.Zero) for r, row in zip(e.binding, known, strict=True)]
    free = eliminate(named, n, Surface())
    return free if len(free.independent) == len(e.elimination.independent) else None


def _rises(b: Branch, matrix: list[tuple[sp.Expr, ...]], e: Equilibrium) -> bool:
    """Whether V is a sum of even powers with positive coefficients, there being no constraints."""
    q = e.configuration.slots.coordinates
    if e.binding or len(matrix) < len(q) or len(q) < 2:
        return False
    place = [(x, v) for x in q if (v := on_branch(b, x, e)) is not None and not v.free_symbols & {*q}]
    return len(place) == len(q) and rises_in_even_powers([-f for f in e.independent_forces], place)


def _with_multipliers(b: Branch, e: Equilibrium) -> Stability:
    """The verdict from the second variation of V − Σ λ f, in the displacements that are free on the branch.

    The eliminated V_kj is degenerate there: a pivot that vanishes makes B infinite. The multipliers need no pivot, and
    the displacements with A δq = 0 are solved for once more with the values of A on the branch.
    """
    if any(r.finite is None for r in e.binding):
        return UNKNOWN
    q = e.configuration.slots.coordinates
    rows = [[on_branch(b, a, e) for a in r.coefficients] for r in e.binding]
    second = [[on_branch(b, -f.diff(x), e, in_parameters=True) for x in q] for f in e.balance(e.multipliers)]
    entries = [x for row in (*rows, *second) for x in row]
    if any(x is None or x.free_symbols & {*e.multipliers} for x in entries):
        return UNKNOWN
    free = _eliminated(rows, e)
    if free is None:
        return UNKNOWN
    shape = sp.Matrix(free.shape(len(q)))
    reduced = (shape.T * sp.Matrix(second) * shape).tolist()
    return replace(definiteness(reduced, b, e), free=tuple(q[k] for k in free.independent))


def definiteness(matrix: Sequence[Sequence[sp.Expr]], b: Branch, e: Equilibrium) -> Stability:
    """Whether a symmetric matrix K, shape (f, f), rewritten for a branch, is positive definite.

    Stable: it is; unstable: it takes negative values; conditional: it is where the conditions hold.

    K is positive definite if and only if all leading minors are positive (Sylvester), and K ≥ 0 if and only if no
    principal minor is negative, since a principal minor is the product of the eigenvalues of K on some of the axes. So

    * one negative principal minor, leading or not, and K takes negative values: 0, −1 for the saddle x y;
    * a leading minor that is zero, and det K ≠ 0: K takes negative values, since a regular K ≥ 0 would be definite;
    * leading minors of open sign, and no other that is zero or negative: definite just where the open ones are
      positive, and K takes negative values where one of them is negative.
    """
    minors = []
    for n in range(1, len(matrix) + 1):
        minor = _minor(matrix, range(n), b, e)
        if minor is None:
            return UNKNOWN
        minors.append(minor)
    known = known_positive(b)
    judged = by_signs(minors, b, e)
    written = tuple(min(m, shortest_form(m), key=lambda x: count_operations(x)) for m in minors)
    is_negative = any(sign_on(m, known) == -1 for m in minors)
    if judged.verdict is StabilityVerdict.STABLE or (is_negative and not judged.presupposed):
        return replace(judged, minors=written)
    others = [m for rows in _not_leading(len(matrix)) if (m := _minor(matrix, rows, b, e)) is not None]
    negative = [(not_vanishing([m], b, e), m) for m in others if sign_on(m, known) == -1]
    presupposed, deciding = min(negative, key=lambda pair: len(pair[0]), default=((), None))
    if deciding is not None and (not is_negative or len(presupposed) < len(judged.presupposed)):
        verdict = StabilityVerdict.UNSTABLE
        return Stability(verdict, written, presupposed=presupposed, principal=shortest_form(deciding))
    if is_negative:
        return replace(judged, minors=written)
    if any(sign_on(m, known) == 0 for m in minors):
        return replace(_never_definite(minors[-1], [*minors, *others], b, e), minors=written)
    return replace(judged, minors=written)


def _minor(matrix: Sequence[Sequence[sp.Expr]], rows: Sequence[int], b: Branch, e: Equilibrium) -> sp.Expr | None:
    """The principal minor of some rows on a branch; None if it cannot be written in closed form."""
    return on_branch(b, sp.Matrix([[matrix[i][j] for j in rows] for i in rows]).det(method="berkowitz"), e)


def _not_leading(size: int) -> Iterator[tuple[int, ...]]:
    """The rows of each principal minor that is not a leading one, smaller ones first; of large matrices only those."""
    for n in range(1, size if size <= MOST_MINORS else 3):
        yield from (rows for rows in combinations(range(size), n) if rows != tuple(range(n)))


def _never_definite(det: sp.Expr, minors: Iterable[sp.Expr], b: Branch, e: Equilibrium) -> Stability:
    """The verdict where a leading minor is zero, and none of the principal minors is known to be negative."""
    known = known_positive(b)
    sign = sign_on(det, known)
    if sign == 1:
        return Stability(StabilityVerdict.UNSTABLE, presupposed=not_vanishing([det], b, e))
    if sign is None:
        return Stability(StabilityVerdict.UNDECIDED, unstable=different_from_zero(det))
    opposite = [-m for m in minors if sign_on(m, known) is None]
    return Stability(StabilityVerdict.UNDECIDED, unstable=where_positive(opposite, known))


def by_signs(expressions: Sequence[sp.Expr], b: Branch, e: Equilibrium) -> Stability:
    """The verdict where all of some expressions must be positive, and one that is negative means instability."""
    known = known_positive(b)
    signs = [sign_on(x, known) for x in expressions]
    values = tuple(expressions)
    if -1 in signs:
        negative = [x for x, sign in zip(expressions, signs, strict=True) if sign == -1]
        presupposed = min((not_vanishing([x], b, e) for x in negative), key=len)
        return Stability(StabilityVerdict.UNSTABLE, values, presupposed=presupposed)
    if 0 in signs:
        return Stability(StabilityVerdict.UNDECIDED, values)
    if None not in signs:
        return Stability(StabilityVerdict.STABLE, values, presupposed=not_vanishing(expressions, b, e))
    try:
        conditions = conditions_for(expressions, known)
    except NeverPositiveError:
        return Stability(StabilityVerdict.UNSTABLE, values)
    if conditions is None:
        return Stability(StabilityVerdict.UNDECIDED, values)
    presupposed = not_vanishing(expressions, b, e, [sp.factor(positive_part(c)) for c in conditions])
    return _shortest(Stability(StabilityVerdict.CONDITIONAL, values, (*conditions, *presupposed)), b)


def _shortest(s: Stability, b: Branch) -> Stability:
    """A conditional verdict with its conditions in the shortest form, given those for the existence of the branch."""
    shorter = further_conditions(s.conditions, b.conditions)
    if shorter is None:
        return _nowhere_stable(s, b)
    if only_excludes_equality(shorter, b.conditions):
        return replace(s, verdict=StabilityVerdict.STABLE, conditions=(), presupposed=shorter)
    lost = [c for c in s.conditions if c.relation == "≠" and c not in shorter]
    # With one condition its opposite is stated as well, and there a minor may vanish.
    return s if lost and len(shorter) == 1 else replace(s, conditions=shorter)


def _nowhere_stable(s: Stability, b: Branch) -> Stability:
    """The verdict where the branch exists only where one minor fails to be positive: where it is negative, unstable."""
    known = known_positive(b)
    for m in (m for m in s.minors if sign_on(m, known) is None):
        own, opposite = conditions_for([m], known), conditions_for([-m], known)
        if own and opposite and further_conditions(own, b.conditions) is None:
            presupposed = further_conditions(opposite, b.conditions)
            if presupposed is not None:
                return replace(s, verdict=StabilityVerdict.UNSTABLE, conditions=(), presupposed=presupposed)
    return s


def not_vanishing(
    expressions: Iterable[sp.Expr], b: Branch, e: Equilibrium, positive: Sequence[sp.Expr] = ()
) -> tuple[SignCondition, ...]:
    """What keeps the factors of known sign different from zero: a > b of √(a² − b²), where b ≤ a on the branch.

    A condition a ≥ b for the existence of the branch, a root and an even power give a sign that is not strict.

    positive  what is known to be positive besides
    """
    known, strict = [*known_positive(b), *positive], [*known_positive(b, strict=True), *positive]
    conditions: list[SignCondition] = []
    for x in expressions:
        for base, odd in bases(x):
            sign_is_open = odd and sign_of(base, known) is None  # then it is a condition already
            if sign_is_open or sign_of(base, strict) is not None:
                continue
            square = _square_in_parameters(base, b, e)
            if square is None:
                conditions += different_from_zero(base)
                continue
            for f in (f for f, _ in bases(square) if sign_of(f, strict) is None):
                sign, different = sign_of(f, known), different_from_zero(f)
                brief = all(count_operations(c.lhs - c.rhs) < count_operations(f) for c in different)
                conditions += different if sign is None or brief else [more_than_zero(sign * f)]
    conditions = list(dict.fromkeys(conditions))
    shorter = further_conditions(conditions, b.conditions)
    return tuple(conditions) if shorter is None else shorter


def _square_in_parameters(x: sp.Expr, b: Branch, e: Equilibrium) -> sp.Expr | None:
    """x² without coordinates, if it is the same at all points of a branch: cos² θ where tan θ = a."""
    squares = {on_branch(replace(b, common=at), x**2, e, in_parameters=True) for at in (b.common, *b.points)}
    known = sorted((s for s in squares if s is not None and not s.free_symbols & {*e.solution.unknowns}), key=str)
    return known[0] if known and all(is_zero(s - known[0]) is True for s in known[1:]) else None


def _vanishes(pivot: sp.Expr, b: Branch, e: Equilibrium) -> bool:
    """Whether a pivot is zero, or may be, on a branch: then other δq are the free ones there."""
    value = on_branch(b, pivot, e)
    return value is None or is_zero(value) is not False
