"""Three methods for an integrating factor: exponents of given functions, affine symmetries, one variable.

Exponents. With log μ = Σ e_k log g_k + φ(v), φ an unknown function of one variable, d(μω) = 0 reads

    Σ e_k (θ^k_i a_j − θ^k_j a_i) + φ'(v) (δ_iv a_j − δ_jv a_i) = ∂_j a_i − ∂_i a_j,    θ^k = d(log g_k).

It is linear in the e_k, the same at all points, and in φ', the same at points with the same v; so points are drawn in
groups that share v. Solutions are rational, or rational multiples of ratios of parameters (dx − k x dt has e^{−kt}).

Symmetries. If X maps the surfaces on which ω vanishes to one another, L_X ω ∧ ω = 0, and is not tangent to them, then
μ = 1/ω(X) (Lie; Olver, Applications of Lie Groups to Differential Equations, 2.5). The fields tried are affine,
X = Σ (c_j + Σ c_jm q_m) ∂_j with rational c: translations, rotations, scalings with any weights.

One variable. With d(log μ) = h ds any pair gives h = (∂_j a_i − ∂_i a_j)/(s_i a_j − s_j a_i), and μ = exp ∫ h ds if h
depends on s alone: a coordinate, beside known powers (Bernoulli's equation), or x + y, x − y, x y, x/y, x² + y².

Exponents and symmetries from random points are only proposals: what comes out is proved on the form.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import NumberRow, nullspace
from lagrange.algebra.exact.zero_test import DivisionByZeroError, InadmissibleError, Point, is_zero
from lagrange.algebra.forms.exact_forms import at_some_value, potential_of
from lagrange.algebra.forms.factor_candidates import (
    FactorCandidate,
    OneForm,
    SampledValues,
    factored,
    is_quick_to_factor,
)
from lagrange.algebra.forms.limits import (
    LARGEST_INTEGRAND,
    MOST_COMBINATION_VARIABLES,
    MOST_EXPONENT_SETS,
    MOST_PARAMETER_RATIOS,
    MOST_SYMMETRY_VARIABLES,
    POINTS_PER_GROUP,
    SPARE_EXPONENT_ROWS,
    SPARE_SYMMETRY_ROWS,
)
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record

FactorExponents = dict[int, sp.Expr]


@record
class _Layout:
    """The layout of the values at one point: a_i, then the curl, then the θ^k."""

    omega: OneForm
    trials: Sequence[FactorCandidate]

    def expressions(self) -> list[sp.Expr]:
        """a_i; ∂_i a_j - ∂_j a_i for i < j; for each candidate g and ∂_i g, or 1 and ∂_i L."""
        omega = self.omega
        n = omega.size
        expressions = list(omega.coefficients)
        expressions += [omega.curl(i, j) for i, j in combinations(range(n), 2)]
        for c in self.trials:
            expressions.append(sp.S.One if c.in_exponent else c.function)
            expressions += [omega.rate(c.function, k) for k in range(n)]
        return expressions

    def rows(self, values: Sequence[Any], point: Point, direction: int | None) -> list[tuple[NumberRow, Any]]:
        """n - 1 rows: the e_k, then the right side; with the coefficient of φ' beside each."""
        arithmetic = point.arithmetic
        n = self.omega.size
        a = values[:n]
        curl = dict(zip(combinations(range(n), 2), values[n:], strict=False))
        start = n + len(curl)
        thetas = []
        for k in range(len(self.trials)):
            g, *rates = values[start + k * (n + 1) : start + (k + 1) * (n + 1)]
            inverse = arithmetic.inverse(g)
            thetas.append([arithmetic.reduce(r * inverse) for r in rates])
        p = next((i for i, x in enumerate(a) if not arithmetic.vanishes(x)), None)
        if p is None:
            raise InadmissibleError
        rows = []
        for j in range(n):
            if j != p:
                right = -curl[p, j] if p < j else curl[j, p]
                row = [arithmetic.reduce(theta[p] * a[j] - theta[j] * a[p]) for theta in thetas]
                slope = a[j] if direction == p else -a[p] if direction == j else 0
                rows.append(([*row, arithmetic.reduce(right)], slope))
        return rows


def rational_exponents(omega: OneForm, trials: Sequence[FactorCandidate]) -> Iterator[FactorExponents]:
    """Exponents by the places of their candidates, the simplest first."""
    layout = _Layout(omega, trials)
    values = SampledValues(layout.expressions())
    rows: list[NumberRow] = []
    while len(rows) < len(trials) + SPARE_EXPONENT_ROWS:
        rows += values.drawn(lambda sampled, point: [row for row, _ in layout.rows(sampled, point, None)])[0]
    yield from _simplest(values, values.reduced(rows), 0, trials)


def exponents_beside(omega: OneForm, trials: Sequence[FactorCandidate], direction: int) -> Iterator[FactorExponents]:
    """The same, beside a function of the variable number `direction`; {} where that function alone suffices."""
    v = omega.variables[direction]
    layout = _Layout(omega, trials)
    values = SampledValues(layout.expressions())
    kept = omega.moving - {*omega.variables} | {v, *omega.parameters}
    gain = POINTS_PER_GROUP * (omega.size - 1) - 1
    groups = -(-(len(trials) + SPARE_EXPONENT_ROWS) // gain)
    rows: list[NumberRow] = []

    def use(sampled: Sequence[Any], point: Point) -> list[tuple[NumberRow, Any]]:
        return layout.rows(sampled, point, direction)

    # Each group adds its equations and one unknown, the value of φ' at its v.
    for n in range(groups):
        group, point = values.drawn(use)
        for _ in range(POINTS_PER_GROUP - 1):
            group += values.drawn(use, point, kept)[0]
        for row, slope in group:
            unknown = [slope if n == k else 0 for k in range(groups)]
            rows.append([*unknown, *row])
    yield from _simplest(values, values.reduced(rows), groups, trials)


def parametric_exponents(omega: OneForm, trials: Sequence[FactorCandidate]) -> Iterator[FactorExponents]:
    """Exponents Σ c r with ratios r of parameters and rational c."""
    ratios = _ratios(omega)
    layout = _Layout(omega, trials)
    values = SampledValues([*layout.expressions(), *ratios])
    count = len(ratios)
    rows: list[NumberRow] = []

    def use(sampled: Sequence[Any], point: Point) -> list[NumberRow]:
        reduce = point.arithmetic.reduce
        scales = sampled[-count:]
        spread = []
        for (*row, right), _ in layout.rows(sampled[:-count], point, None):
            spread.append([*(reduce(x * s) for x in row for s in scales), right])
        return spread

    while len(rows) < len(trials) * count + SPARE_EXPONENT_ROWS:
        rows += values.drawn(use)[0]
    for multiples in _simplest(values, values.reduced(rows), 0, [c for c in trials for _ in ratios]):
        exponents: FactorExponents = {}
        for k, c in multiples.items():
            exponents[k // count] = exponents.get(k // count, sp.S.Zero) + c * ratios[k % count]
        yield exponents


def _ratios(omega: OneForm) -> list[sp.Expr]:
    """1 and the ratios of the parameters' monomials that occur in the form, simple ones first."""
    monomials = {sp.S.One}
    for a in omega.coefficients:
        exponents = [p.exp for p in a.atoms(sp.Pow)] + [e.args[0] for e in a.atoms(sp.exp)]
        for part in (a, *exponents):
            if count_operations(part) <= 60:
                for term in sp.Add.make_args(sp.expand(part)):
                    constant = term.as_independent(*omega.moving, as_Add=False)[0]
                    monomials.add(constant.as_coeff_Mul()[1])
    known = [m for m in monomials if not m.free_symbols & omega.moving and m.free_symbols]
    ratios = {sp.S.One, *known, *(1 / m for m in known), *(m / n for m in known for n in known)}
    return sorted(ratios, key=lambda e: (count_operations(e), sp.default_sort_key(e)))[:MOST_PARAMETER_RATIOS]


def _simplest(
    values: SampledValues, reduced: tuple[list[NumberRow], list[int]], groups: int, trials: Sequence[FactorCandidate]
) -> Iterator[FactorExponents]:
    """Solutions of the reduced rows beyond the first `groups` columns: of no, one, two unknowns, then any."""
    rows = [row[groups:] for row, pivot in zip(*reduced, strict=True) if pivot >= groups]
    width = len(rows[0]) - 1 if rows else 0
    if any(all(x == 0 for x in row[:-1]) for row in rows):
        return
    right = [row[-1] for row in rows]
    if not any(right):
        yield {}
        return
    p = values.point.arithmetic
    columns = [[row[k] for row in rows] for k in range(width)]
    solutions: list[FactorExponents] = []
    for k, column in enumerate(columns):
        solution = _one(p, column, right)
        if solution is not None:
            solutions.append(_rational(values, {k: solution}))
    for j, k in combinations(range(width), 2):
        pair = _two(p, columns[j], columns[k], right)
        if pair is not None and all(pair):
            solutions.append(_rational(values, {j: pair[0], k: pair[1]}))
    # The solution with all free exponents zero, when one or two factors do not suffice.
    pivots = [next(k for k, x in enumerate(row) if x) for row in rows]
    solutions.append(_rational(values, {k: row[-1] for k, row in zip(pivots, rows, strict=True) if row[-1]}))
    ranked = sorted((e for e in solutions if e), key=lambda e: _complexity(e, trials))
    seen: list[FactorExponents] = []
    for e in ranked:
        if e not in seen and len(seen) < MOST_EXPONENT_SETS:
            seen.append(e)
            yield e


def _one(p: Any, column: NumberRow, right: NumberRow) -> Any:
    """e with e · column = right, or None."""
    place = next((n for n, x in enumerate(column) if x), None)
    if place is None or not right[place]:
        return None
    e = p.reduce(right[place] * p.inverse(column[place]))
    return e if all(p.reduce(e * x - b) == 0 for x, b in zip(column, right, strict=True)) else None


def _two(p: Any, first: NumberRow, second: NumberRow, right: NumberRow) -> tuple[Any, Any] | None:
    """(e, f) with e · first + f · second = right, or None; None too where the columns are proportional."""
    if any(b and not x and not y for x, y, b in zip(first, second, right, strict=True)):
        return None
    m = next((n for n, x in enumerate(first) if x), None)
    if m is None:
        return None
    n = next((n for n, y in enumerate(second) if p.reduce(first[m] * y - first[n] * second[m])), None)
    if n is None:
        return None
    scale = p.inverse(p.reduce(first[m] * second[n] - first[n] * second[m]))
    e = p.reduce((right[m] * second[n] - right[n] * second[m]) * scale)
    f = p.reduce((first[m] * right[n] - first[n] * right[m]) * scale)
    holds = all(p.reduce(e * x + f * y - b) == 0 for x, y, b in zip(first, second, right, strict=True))
    return (e, f) if holds else None


def _rational(values: SampledValues, residues: dict[int, Any]) -> FactorExponents:
    """The exponents as fractions; {} where one is not a small fraction."""
    exponents: FactorExponents = {}
    for k, residue in residues.items():
        number = values.number(residue)
        if number is None:
            return {}
        exponents[k] = number
    return exponents


def _complexity(exponents: FactorExponents, trials: Sequence[FactorCandidate]) -> tuple[Any, ...]:
    """Whole exponents first, then few factors, then short ones; e^t has no zero, and costs less than 1/x."""
    weight = sp.S.Zero
    for k, e in exponents.items():
        c = trials[k]
        weight += abs(e) * (1 + count_operations(c.function)) + (2 if e < 0 and not c.in_exponent else 0)
    return (any(e.q != 1 for e in exponents.values()), len(exponents), weight, sum(exponents))


def symmetry_fields(omega: OneForm) -> Iterator[list[sp.Expr]]:
    """Affine fields X, shape (k,), that are likely to be symmetries, not tangent; simple ones first."""
    n = omega.size
    if n > MOST_SYMMETRY_VARIABLES:
        return
    generators = [(j, None) for j in range(n)] + [(j, m) for m in range(n) for j in range(n)]
    flat = [omega.rates[i][j] for i in range(n) for j in range(n)]
    values = SampledValues([*omega.coefficients, *flat, *omega.variables])
    rows: list[NumberRow] = []

    def use(sampled: Sequence[Any], point: Point) -> list[NumberRow]:
        a, q = sampled[:n], sampled[-n:]
        rates = [sampled[n * (i + 1) : n * (i + 2)] for i in range(n)]
        return _rows(a, rates, q, generators, point)

    while len(rows) < len(generators) + SPARE_SYMMETRY_ROWS:
        rows += values.drawn(use)[0]
    fields = []
    for vector in nullspace(values.point.arithmetic, rows, len(generators)):
        numbers = [values.number(c) for c in vector]
        known = [c for c in numbers if c is not None]
        if len(known) == len(numbers):
            fields.append(_field(known, generators, omega))
    yield from sorted(fields, key=lambda field: sum(count_operations(x) for x in field))


def _rows(
    a: Sequence[Any], rates: Sequence[Sequence[Any]], q: Sequence[Any], generators: Sequence[Any], point: Point
) -> list[NumberRow]:
    """(L_X ω)_p a_k - (L_X ω)_k a_p = 0 for all k and one p, the coefficients of each generator's c."""
    arithmetic = point.arithmetic
    n = len(a)
    p = next((i for i, x in enumerate(a) if not arithmetic.vanishes(x)), None)
    if p is None:
        raise InadmissibleError
    derivatives = []
    for j, m in generators:
        if m is None:
            derivatives.append([rates[i][j] for i in range(n)])
        else:
            derivatives.append([q[m] * rates[i][j] + (a[j] if i == m else 0) for i in range(n)])
    return [[arithmetic.reduce(d[p] * a[k] - d[k] * a[p]) for d in derivatives] for k in range(n) if k != p]


def _field(c: Sequence[sp.Rational], generators: Sequence[Any], omega: OneForm) -> list[sp.Expr]:
    field = [sp.S.Zero] * omega.size
    for number, (j, m) in zip(c, generators, strict=True):
        field[j] += number * (sp.S.One if m is None else omega.variables[m])
    return field


SymmetryCombination = tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]


def factor_beside(omega: OneForm, known: sp.Expr, direction: int) -> sp.Expr | None:
    """μ = g exp ∫ h dv for a known g and the variable number `direction`, or None."""
    v = omega.variables[direction]
    inner = OneForm(omega.times(known), omega.variables, omega.slots)
    others = [j for j in range(omega.size) if j != direction and inner.coefficients[j] != 0]
    if not others:
        return None
    j = min(others, key=lambda k: count_operations(inner.coefficients[k]))
    h: sp.Expr | None = shortened(-inner.curl(direction, j) / inner.coefficients[j])
    for other in omega.variables:
        if h is not None and other != v:
            h = at_some_value(h, other) if other in h.free_symbols else h
    phi = None if h is None or count_operations(h) > LARGEST_INTEGRAND else potential_of([h], [v], omega.slots)
    return None if phi is None else known * exp_of(phi)


def factors_of_combinations(omega: OneForm) -> Iterator[sp.Expr]:
    """Factors of x + y, x - y, x y, x/y, x² + y² for two of at most three variables."""
    if omega.size > MOST_COMBINATION_VARIABLES:
        return
    s = sp.Dummy("s", real=True)
    for i, j in combinations(range(omega.size), 2):
        for combined, solved in _combinations(omega.variables[i], omega.variables[j], s):
            factor = _of_combination(omega, i, j, combined, solved, s)
            if factor is not None:
                yield factor


def _combinations(p: sp.Symbol, q: sp.Symbol, s: sp.Symbol) -> Iterator[SymmetryCombination]:
    """s, and p in terms of s and q."""
    yield p + q, {p: s - q}
    yield p - q, {p: s + q}
    yield p * q, {p: s / q}
    yield p / q, {p: s * q}
    yield p**2 + q**2, {p: sp.sqrt(s - q**2)}


def _of_combination(
    omega: OneForm, i: int, j: int, combined: sp.Expr, solved: dict[sp.Symbol, sp.Expr], s: sp.Symbol
) -> sp.Expr | None:
    a, b = omega.coefficients[i], omega.coefficients[j]
    across = shortened(omega.rate(combined, i) * b - omega.rate(combined, j) * a)
    if _vanishes(across):
        return None
    h = shortened(-omega.curl(i, j) / across)
    if not _vanishes(omega.rate(h, i) * omega.rate(combined, j) - omega.rate(h, j) * omega.rate(combined, i)):
        return None
    in_s: sp.Expr | None = h.xreplace(solved)
    for v in omega.variables:
        in_s = None if in_s is None else at_some_value(in_s, v) if v in in_s.free_symbols else in_s
    if in_s is None or count_operations(in_s) > LARGEST_INTEGRAND:
        return None
    phi = potential_of([shortened(in_s)], [s], omega.slots)
    return None if phi is None else exp_of(phi).xreplace({s: combined})


def _vanishes(e: sp.Expr) -> bool:
    """Whether an expression is zero, or divides by zero."""
    try:
        return is_zero(e) is True
    except DivisionByZeroError:
        return True


def unbarred(e: sp.Expr) -> sp.Expr:
    """±g for |g|: signs do not change where nothing vanishes. A factor that is never positive, cos ψ − 1, has the other
    sign, because a power of it that is not whole would be real nowhere.
    """
    g = e.args[0] if isinstance(e, sp.Abs) else e
    factors = (f.as_base_exp() for f in sp.Mul.make_args(g))
    return sp.Mul(*((-f if is_never_positive(f) else f) ** n for f, n in factors))


def is_never_positive(e: sp.Expr) -> bool:
    """Whether c + Σ a_k sin or cos has c + Σ |a_k| ≤ 0, with numbers a_k and c."""
    largest = sp.S.Zero
    for term in sp.Add.make_args(e):
        a, wave = term.as_coeff_Mul()
        if not (wave is sp.S.One or isinstance(wave, sp.sin | sp.cos)):
            return False
        largest += a if wave is sp.S.One else abs(a)
    return bool(largest <= 0)


def exp_of(phi: sp.Expr) -> sp.Expr:
    """e^φ, with its logarithms as powers and without bars."""
    powers, rest = [], []
    for term in sp.Add.make_args(sp.expand(phi) if is_quick_to_factor(phi) else phi):
        logs = [f for f in sp.Mul.make_args(term) if isinstance(f, sp.log)]
        if len(logs) == 1:
            powers.append(unbarred(logs[0].args[0]) ** (term / logs[0]))
        else:
            rest.append(term)
    return sp.Mul(*powers) * sp.exp(sp.Add(*rest))


def shortened(e: sp.Expr) -> sp.Expr:
    """The shortest of some equal forms: as it is, cancelled, in factors, sines and cosines put together."""
    forms = [e]
    if is_quick_to_factor(e):
        forms.append(factored(e))
        if e.has(sp.sin, sp.cos, sp.tan):
            forms += [textbook_form(sp.cancel(e)), factored(textbook_form(sp.cancel(e)))]
        if e.has(sp.exp) or any(not p.exp.is_Integer for p in e.atoms(sp.Pow)):
            forms += [sp.powsimp(f) for f in forms]
    return min(forms, key=count_operations)


def in_shortest_forms(expressions: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """Each of several expressions in its shortest form."""
    return tuple(shortened(e) for e in expressions)
