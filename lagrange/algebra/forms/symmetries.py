"""Integrating factors from symmetries.

If a vector field X maps the surfaces on which an integrable form ω vanishes to one another, L_X ω ∧ ω = 0, and is not
tangent to them, then

    μ = 1/ω(X)

makes ω exact (Lie). The fields tried are the affine ones, X = Σ (c_j + Σ c_jm q_m) ∂_j with rational c: translations,
rotations, scalings with any weights (homogeneous equations among them). What is asked of c is linear, and rows are
taken at random points of a prime field. Reference: Olver, Applications of Lie Groups to Differential Equations, 2.5.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from lagrange.algebra.exact.exact import InadmissibleError, Point
from lagrange.algebra.exact.linear_algebra import Row, nullspace
from lagrange.algebra.forms.one_forms import OneForm, Values

MOST_VARIABLES = 5
SPARE_ROWS = 4


def symmetries(omega: OneForm) -> Iterator[list[sp.Expr]]:
    """Affine fields X, shape (k,), that are likely to be symmetries, not tangent; simple ones first."""
    n = omega.size
    if n > MOST_VARIABLES:
        return
    generators = [(j, None) for j in range(n)] + [(j, m) for m in range(n) for j in range(n)]
    flat = [omega.rates[i][j] for i in range(n) for j in range(n)]
    values = Values([*omega.coefficients, *flat, *omega.variables])
    rows: list[Row] = []

    def use(found: Sequence[Any], point: Point) -> list[Row]:
        a, q = found[:n], found[-n:]
        rates = [found[n * (i + 1) : n * (i + 2)] for i in range(n)]
        return _rows(a, rates, q, generators, point)

    while len(rows) < len(generators) + SPARE_ROWS:
        rows += values.drawn(use)[0]
    fields = []
    for vector in nullspace(values.point.arithmetic, rows, len(generators)):
        numbers = [values.number(c) for c in vector]
        known = [c for c in numbers if c is not None]
        if len(known) == len(numbers):
            fields.append(_field(known, generators, omega))
    yield from sorted(fields, key=lambda field: sum(sp.count_ops(x) for x in field))


def _rows(
    a: Sequence[Any], rates: Sequence[Sequence[Any]], q: Sequence[Any], generators: Sequence[Any], point: Point
) -> list[Row]:
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
