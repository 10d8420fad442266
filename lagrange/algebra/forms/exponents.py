"""The exponents of an integrating factor, by linear algebra at random points of a prime field.

With log μ = Σ e_k log g_k + φ(v), where φ is an unknown function of one variable v, the condition d(μω) = 0 reads

    Σ e_k (θ^k_i a_j - θ^k_j a_i) + φ'(v) (δ_iv a_j - δ_jv a_i) = ∂_j a_i - ∂_i a_j,    θ^k = d(log g_k).

It is linear in the e_k, which are the same at all points, and in φ', which is the same at points with the same v. So
points are drawn in groups that share v, and each group has an unknown of its own. The solutions are rational numbers,
found as residues; or, in a second trial, rational multiples of ratios of parameters (dx - k x dt has the factor
e^{-kt}). Of many solutions those with few factors and whole exponents come first. Nothing here is certain: what comes
out is tried on the form.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import sympy as sp

from lagrange.algebra.exact.exact import InadmissibleError, Point
from lagrange.algebra.exact.linear_algebra import Row
from lagrange.algebra.forms.factor_candidates import Candidate
from lagrange.algebra.forms.one_forms import OneForm, Values
from lagrange.core.records import record

SPARE_ROWS = 5
GROUP = 3
MOST_TRIED = 6
MOST_RATIOS = 8

Exponents = dict[int, sp.Expr]


@record
class _Place:
    """Where the values of one point stand: those of a_i, of the curl, of the θ^k."""

    omega: OneForm
    trials: Sequence[Candidate]

    def expressions(self) -> list[sp.Expr]:
        """a_i; ∂_i a_j - ∂_j a_i for i < j; for each candidate g and ∂_i g, or 1 and ∂_i L."""
        omega = self.omega
        n = omega.size
        found = list(omega.coefficients)
        found += [omega.curl(i, j) for i, j in combinations(range(n), 2)]
        for c in self.trials:
            found.append(sp.S.One if c.exponential else c.function)
            found += [omega.rate(c.function, k) for k in range(n)]
        return found

    def rows(self, values: Sequence[Any], point: Point, direction: int | None) -> list[tuple[Row, Any]]:
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
        found = []
        for j in range(n):
            if j != p:
                right = -curl[p, j] if p < j else curl[j, p]
                row = [arithmetic.reduce(theta[p] * a[j] - theta[j] * a[p]) for theta in thetas]
                slope = a[j] if direction == p else -a[p] if direction == j else 0
                found.append(([*row, arithmetic.reduce(right)], slope))
        return found


def rational_exponents(omega: OneForm, trials: Sequence[Candidate]) -> Iterator[Exponents]:
    """Exponents by the places of their candidates, the simplest first."""
    place = _Place(omega, trials)
    values = Values(place.expressions())
    rows: list[Row] = []
    while len(rows) < len(trials) + SPARE_ROWS:
        rows += values.drawn(lambda found, point: [row for row, _ in place.rows(found, point, None)])[0]
    yield from _simplest(values, values.reduced(rows), 0, trials)


def exponents_beside(omega: OneForm, trials: Sequence[Candidate], direction: int) -> Iterator[Exponents]:
    """The same, beside a function of the variable number `direction`; {} where that function alone will do."""
    v = omega.variables[direction]
    place = _Place(omega, trials)
    values = Values(place.expressions())
    kept = omega.moving - {*omega.variables} | {v, *omega.parameters}
    gain = GROUP * (omega.size - 1) - 1
    groups = -(-(len(trials) + SPARE_ROWS) // gain)
    rows: list[Row] = []

    def use(found: Sequence[Any], point: Point) -> list[tuple[Row, Any]]:
        return place.rows(found, point, direction)

    for n in range(groups):
        here, point = values.drawn(use)
        for _ in range(GROUP - 1):
            here += values.drawn(use, point, kept)[0]
        for row, slope in here:
            unknown = [slope if n == k else 0 for k in range(groups)]
            rows.append([*unknown, *row])
    yield from _simplest(values, values.reduced(rows), groups, trials)


def parametric_exponents(omega: OneForm, trials: Sequence[Candidate]) -> Iterator[Exponents]:
    """Exponents Σ c r with ratios r of parameters and rational c."""
    ratios = _ratios(omega)
    place = _Place(omega, trials)
    values = Values([*place.expressions(), *ratios])
    count = len(ratios)
    rows: list[Row] = []

    def use(found: Sequence[Any], point: Point) -> list[Row]:
        reduce = point.arithmetic.reduce
        scales = found[-count:]
        spread = []
        for (*row, right), _ in place.rows(found[:-count], point, None):
            spread.append([*(reduce(x * s) for x in row for s in scales), right])
        return spread

    while len(rows) < len(trials) * count + SPARE_ROWS:
        rows += values.drawn(use)[0]
    for found in _simplest(values, values.reduced(rows), 0, [c for c in trials for _ in ratios]):
        exponents: Exponents = {}
        for k, c in found.items():
            exponents[k // count] = exponents.get(k // count, sp.S.Zero) + c * ratios[k % count]
        yield exponents


def _ratios(omega: OneForm) -> list[sp.Expr]:
    """1 and the ratios of the parameters' monomials that occur in the form, simple ones first."""
    monomials = {sp.S.One}
    for a in omega.coefficients:
        exponents = [p.exp for p in a.atoms(sp.Pow)] + [e.args[0] for e in a.atoms(sp.exp)]
        for part in (a, *exponents):
            if sp.count_ops(part) <= 60:
                for term in sp.Add.make_args(sp.expand(part)):
                    constant = term.as_independent(*omega.moving, as_Add=False)[0]
                    monomials.add(constant.as_coeff_Mul()[1])
    known = [m for m in monomials if not m.free_symbols & omega.moving and m.free_symbols]
    found = {sp.S.One, *known, *(1 / m for m in known), *(m / n for m in known for n in known)}
    return sorted(found, key=lambda e: (sp.count_ops(e), sp.default_sort_key(e)))[:MOST_RATIOS]


def _simplest(
    values: Values, reduced: tuple[list[Row], list[int]], groups: int, trials: Sequence[Candidate]
) -> Iterator[Exponents]:
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
    found: list[Exponents] = []
    for k, column in enumerate(columns):
        solution = _one(p, column, right)
        if solution is not None:
            found.append(_rational(values, {k: solution}))
    for j, k in combinations(range(width), 2):
        pair = _two(p, columns[j], columns[k], right)
        if pair is not None and all(pair):
            found.append(_rational(values, {j: pair[0], k: pair[1]}))
    pivots = [next(k for k, x in enumerate(row) if x) for row in rows]
    found.append(_rational(values, {k: row[-1] for k, row in zip(pivots, rows, strict=True) if row[-1]}))
    ranked = sorted((e for e in found if e), key=lambda e: _complexity(e, trials))
    seen: list[Exponents] = []
    for e in ranked:
        if e not in seen and len(seen) < MOST_TRIED:
            seen.append(e)
            yield e


def _one(p: Any, column: Row, right: Row) -> Any:
    """e with e · column = right, or None."""
    place = next((n for n, x in enumerate(column) if x), None)
    if place is None or not right[place]:
        return None
    e = p.reduce(right[place] * p.inverse(column[place]))
    return e if all(p.reduce(e * x - b) == 0 for x, b in zip(column, right, strict=True)) else None


def _two(p: Any, first: Row, second: Row, right: Row) -> tuple[Any, Any] | None:
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


def _rational(values: Values, residues: dict[int, Any]) -> Exponents:
    """The exponents as fractions; {} where one is not a small fraction."""
    found: Exponents = {}
    for k, residue in residues.items():
        number = values.number(residue)
        if number is None:
            return {}
        found[k] = number
    return found


def _complexity(exponents: Exponents, trials: Sequence[Candidate]) -> tuple[Any, ...]:
    """Whole exponents first, then few factors, then short ones; e^t has no zero, and costs less than 1/x."""
    weight = sp.S.Zero
    for k, e in exponents.items():
        c = trials[k]
        weight += abs(e) * (1 + sp.count_ops(c.function)) + (2 if e < 0 and not c.exponential else 0)
    return (any(e.q != 1 for e in exponents.values()), len(exponents), weight, sum(exponents))
