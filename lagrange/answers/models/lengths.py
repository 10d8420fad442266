"""Mistakes in lengths: one of two that make up a distance, R where it is R − r, throughout.

The centre of a cylinder that rolls in a hollow one of radius R moves on a circle of radius R − r. Who takes R for it
does so in the velocity of the centre, in the rolling condition and in the potential energy alike. So a factor R − r of
any J_i and any Q_k is replaced, in numerators alone: the r in ω = (R − r) φ'/r stays.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.answers.limits import LONGEST_SUM_OF_LENGTHS
from lagrange.answers.models.mechanics import AppliedForceKind, Inertia, Mechanics, Variation, written
from lagrange.core.symbols import base, t


def one_of_two_lengths(m: Mechanics) -> Iterator[Variation]:
    """One of the two parameters of a sum or difference, in place of it, wherever it is a factor."""
    units = dict(m.units)
    tied = [a for row in m.configuration.rows for a in row.coefficients]
    for whole in _sums(m):
        for part in sorted(whole.free_symbols, key=str):
            if units.get(part, "m") not in _LENGTHS or any(whole.free_symbols <= a.free_symbols for a in tied):
                continue  # a constraint has it as well, and would be another one
            taken = replaced(m, whole, part)
            clause = f"with {written(part, m.slots)} in place of {written(whole, m.slots)} throughout"
            yield Variation(clause, f"the distance {written(whole, m.slots)}", taken)


_LENGTHS = ("", "m", "cm", "mm", "ft")


def replaced(m: Mechanics, whole: sp.Expr, part: sp.Expr) -> Mechanics:
    """The system with `part` in place of a sum `whole` that is a factor of velocities and forces."""

    @cache
    def changed(e: sp.Expr) -> sp.Expr:
        if len(whole.free_symbols & e.free_symbols) < 2:
            return e
        above, below = _factored(e)
        return above.xreplace({whole: part, -whole: -part}) / below

    def moved(i: Inertia) -> Inertia:
        columns = tuple((changed(a), changed(b), changed(c)) for a, b, c in i.columns)
        return replace(i, columns=columns)

    return m.inertia(moved).force(lambda f: replace(f, shares=tuple(map(changed, f.shares))))


@cache
def _factored(e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Numerator, as a product, and denominator."""
    if sp.count_ops(e) > LONGEST_SUM_OF_LENGTHS:
        return e, sp.S.One
    above, below = sp.fraction(sp.together(textbook_form(e)))
    return sp.factor(above), below


def _sums(m: Mechanics) -> list[sp.Add]:
    """The sums and differences of two parameters that are factors, in numerators, of velocities."""
    moving = {*m.slots.coordinates, *m.slots.velocities, *m.slots.prescribed, t}
    columns = [c for i in m.inertias for column in i.columns for c in column if len(c.free_symbols) > 1]
    shares = [s for f in m.forces if f.kind is AppliedForceKind.WEIGHT for s in f.shares]
    found: dict[sp.Add, None] = {}
    for e in (*columns, *shares):
        for factor in sp.Mul.make_args(_factored(e)[0]):
            whole = factor.as_base_exp()[0]
            terms = whole.args if whole.is_Add else ()
            of_two = len(terms) == 2 and all(x.is_Symbol or (-x).is_Symbol for x in terms)
            if of_two and not {base(s) for s in whole.free_symbols} & moving:
                found[-whole if whole.could_extract_minus_sign() else whole] = None
    return list(found)
