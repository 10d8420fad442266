"""Frobenius' condition: which single constraints are finite relations in disguise.

A form ω = Σ a_i dq_i + a_t dt (t counts as a coordinate here) is exact if ∂a_i/∂q_k = ∂a_k/∂q_i for all pairs, and then
ω = df. It is integrable if ω = μ df; by Frobenius' theorem this holds if and only if

    ω ∧ dω = Σ_{i<j<k} c_ijk dq_i ∧ dq_j ∧ dq_k = 0,
    c_ijk = a_i (∂_j a_k − ∂_k a_j) + a_j (∂_k a_i − ∂_i a_k) + a_k (∂_i a_j − ∂_j a_i).

Exact implies integrable; y dx − x dy shows that the converse fails. `is_integrable` decides at generic points of a
prime field, on the surface of the geometric constraints (`charts`); `frobenius_form` has the components as a page shows
them. Several constraints together may imply finite relations that none of them shows: the derived flag counts them
(`derived_flag`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations
from typing import Any

import sympy as sp

from lagrange.algebra.exact.zero_test import Point, Surface
from lagrange.algebra.forms.charts import (
    agreed_on_surface,
    chart,
    pulled_back,
    surface_of,
)
from lagrange.algebra.forms.exact_forms import compared, differentiated
from lagrange.algebra.forms.jets import (
    BITS,
    Jet,
    JetRing,
    constant_term,
)
from lagrange.algebra.forms.limits import (
    FLAG_WORK,
    LONGEST_TIDIED_COMPONENT,
    LONGEST_TIDIED_FORM,
)
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots


@record
class WedgeComponent:
    """One component of ω ∧ dω: the coefficient of da ∧ db ∧ dc; `nonzero` is None if it is undecided."""

    variables: tuple[sp.Symbol, sp.Symbol, sp.Symbol]
    coefficient: sp.Expr
    nonzero: bool | None


def frobenius_form(form: Sequence[sp.Expr], variables: Sequence[sp.Symbol], slots: Slots) -> tuple[WedgeComponent, ...]:
    """The components of ω ∧ dω, in the order of the variables; those written as 0 are omitted."""
    components = []
    write = component_writer(form)
    indices = range(len(form))
    d = {(i, j): differentiated(form[j], variables[i], slots) for i in indices for j in indices if i != j}
    for i, j, k in combinations(indices, 3):
        cyclic = ((i, j, k), (j, k, i), (k, i, j))
        coefficient = write(sp.Add(*(form[a] * (d[b, c] - d[c, b]) for a, b, c in cyclic)))
        if coefficient != 0:
            zero = compared(coefficient)
            triple = (variables[i], variables[j], variables[k])
            components.append(WedgeComponent(triple, coefficient, None if zero is None else not zero))
    return tuple(components)


def component_writer(form: Sequence[sp.Expr]) -> Callable[[sp.Expr], sp.Expr]:
    """How components of ω ∧ dω are written: in textbook form, unless that would be too long to read."""
    if sum(count_operations(a) for a in form) > LONGEST_TIDIED_FORM:
        return lambda coefficient: coefficient
    return lambda coefficient: (
        textbook_form(coefficient) if count_operations(coefficient) <= LONGEST_TIDIED_COMPONENT else coefficient
    )


def is_integrable(form: Sequence[sp.Expr], slots: Slots, geometric: Sequence[sp.Expr] | Surface = ()) -> bool | None:
    """Whether one form has an integrating factor on the geometric constraints: ω ∧ dω ∧ df_1 ∧ ... = 0.

    form       (n + 1,) coefficients of dq_1 ... dq_n, dt
    geometric  functions f(q, t) whose vanishing is the geometric constraints, or their surface
    """
    surface = surface_of(geometric, slots)
    omega = [sp.sympify(a, strict=True) for a in form]

    def at(point: Point, finite: Sequence[sp.Expr]) -> bool | None:
        ring = JetRing(point.arithmetic, FLAG_WORK)
        local = chart(ring, point, finite, slots, 2 if finite else 1)
        (row,) = pulled_back(ring, local, [omega])
        return _is_frobenius(ring, row, local.free)

    return agreed_on_surface(at, omega, surface, slots, lambda _: None)


def _is_frobenius(ring: JetRing, row: Sequence[Jet], free: Sequence[int]) -> bool:
    """Whether ω ∧ dω = 0 at the point, from the first-order jets of ω."""
    a = [constant_term(jet) for jet in row]
    rates = [[jet[1].get(1 << BITS * k, 0) for jet in row] for k in free]

    def curl(i: int, j: int) -> Any:
        return rates[i][j] - rates[j][i]

    return all(
        ring.arithmetic.vanishes(a[i] * curl(j, k) + a[j] * curl(k, i) + a[k] * curl(i, j))
        for i, j, k in combinations(range(len(a)), 3)
    )
