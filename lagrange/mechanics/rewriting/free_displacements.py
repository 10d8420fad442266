"""The solutions of conditions on virtual displacements by a free parameter, where solving for one would divide by zero.

Of sin θ δx = cos θ δy every solution, whatever θ, is δx = cos θ δs, δy = sin θ δs. That takes in all of them if only
one free displacement has denominators, and if what it is multiplied by to clear them, and the others with it, never
vanish at once: the sum of their squares is a positive number.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import in_sines, shortest_form
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import Sizes
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, free_letter, t, variation
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.limits import LONGEST_CANCELLED, MOST_EXPANDED_TERMS


@record
class FreeDisplacements:
    """All displacements that satisfy the conditions, by the free ones.

    values  of the dependent displacements, and of the one for which the parameter stands, by coordinate
    free    the parameter δs, and the other free displacements
    pivots  what must differ from zero for these to be all solutions
    """

    values: Mapping[sp.Symbol, sp.Expr]
    free: tuple[sp.Symbol, ...]
    pivots: tuple[sp.Expr, ...]


def free_displacements(elimination: Elimination, slots: Slots, taken: Collection[str]) -> FreeDisplacements | None:
    """The displacements by a parameter, whose letter is not `taken`; None where not one of the free ones is divided."""
    sizes = Sizes()
    if any(
        sizes.of(e).size > LONGEST_CANCELLED or _is_fraction_of_many(e, sizes)
        for row in elimination.solution
        for e in row
    ):
        return None
    columns = [[*map(in_sines, column)] for column in zip(*elimination.solution, strict=True)]
    divided = [k for k, column in enumerate(columns) if any(_may_be_infinite(e, elimination) for e in column)]
    if len(divided) != 1:
        return None
    [k] = divided
    below = sp.lcm_list([sp.fraction(sp.together(e))[1] for e in columns[k]])
    factors = {
        slots.coordinates[d]: sp.cancel(e * below) for d, e in zip(elimination.dependent, columns[k], strict=True)
    }
    factors[slots.coordinates[elimination.independent[k]]] = below
    common = _common(list(factors.values()), slots)
    if common is None:
        return None
    factors = {q: _shorter(sp.cancel(e / common)) for q, e in factors.items()}
    moving = {*slots.coordinates, *slots.prescribed, t}
    pivots = [f for f in sp.Mul.make_args(sp.factor(common)) if f.free_symbols & moving]
    s = variation(sp.Symbol(free_letter("s", "u", "sigma", "w", taken=taken), real=True))
    rest = [n for n in range(len(columns)) if n != k]
    values = {}
    for n, q in enumerate(slots.coordinates):
        if q not in factors:
            continue
        values[q] = factors[q] * s
        if n in elimination.dependent:
            row = elimination.solution[elimination.dependent.index(n)]
            values[q] += sp.Add(*(row[m] * variation(slots.coordinates[elimination.independent[m]]) for m in rest))
    free = [slots.coordinates[elimination.independent[m]] for m in rest]
    values, free = _by_headings(values, free, slots)
    return FreeDisplacements(values, (s, *map(variation, free)), tuple(pivots))


def _by_headings(
    values: Mapping[sp.Symbol, sp.Expr], free: Sequence[sp.Symbol], slots: Slots
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Symbol]]:
    """The same with a coordinate that coefficients depend on as the free one: δθ of an axle, not δφ of a wheel."""
    chosen, left = dict(values), list(free)
    headings = {q for e in chosen.values() for q in e.free_symbols & set(slots.coordinates)}
    for n, old in enumerate(left):
        new = next((q for q, e in chosen.items() if q in headings and e.coeff(variation(old)).is_nonzero), None)
        if old in headings or new is None:
            continue
        share = chosen[new].coeff(variation(old))
        if share.free_symbols & {*slots.coordinates, *slots.prescribed, t}:
            continue
        solved = sp.expand((variation(new) - chosen[new]) / share + variation(old))
        rows = {q: e.xreplace({variation(old): solved}) for q, e in chosen.items() if q != new} | {old: solved}
        chosen = {q: textbook_form(sp.expand(rows[q])) for q in slots.coordinates if q in rows}
        left[n] = new
    return chosen, left


def _is_fraction_of_many(e: sp.Expr, sizes: Sizes) -> bool:
    """Whether its denominators have many terms when they are multiplied out: twenty sums of two have a million."""
    return sizes.of(sp.Mul(*(p.base for p in e.atoms(sp.Pow) if p.exp.is_negative))).widest > MOST_EXPANDED_TERMS


def _shorter(e: sp.Expr) -> sp.Expr:
    return min(e, shortest_form(e), key=lambda x: count_operations(x))


def _common(entries: Sequence[sp.Expr], slots: Slots) -> sp.Expr | None:
    """What the entries have to be divided by for those without parameters to have squares that add up to 1."""
    varying = {*slots.coordinates, *slots.prescribed, t}
    for common in (sp.S.One, *(sp.gcd(a, b) for a, b in combinations(entries, 2))):
        divided = [sp.cancel(e / common) for e in entries]
        lengths = [e for e in divided if all(s in varying or e.has(t) for s in e.free_symbols)]
        if len(lengths) > 1 and textbook_form(sp.Add(*(e**2 for e in lengths))) == 1:
            return common
    return None


def _may_be_infinite(e: sp.Expr, elimination: Elimination) -> bool:
    """Whether it has a denominator that one of the pivots makes vanish."""
    below = sp.fraction(sp.together(e))[1]
    return any(sp.fraction(sp.cancel(below / in_sines(p)))[1] == 1 for p in elimination.pivots)
