"""The constant rate of a steady motion, found from its conditions where they are easier to solve for it than for
coordinates.

A condition linear in a rate, or in its square, gives ψ' = F(θ, φ') or φ'² = F(r, θ); one in which no coordinate occurs,
a φ'² = g in a paraboloid, gives one rate for all positions.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.shortest_form import reading_length
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.symbols import partial
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

ZERO = sp.S.Zero


def condition_for_rate(
    conditions: Sequence[sp.Expr], rates: Sequence[sp.Symbol], complete: bool
) -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr] | None]:
    """A condition that a constant rate is found from, and this rate; None if there is none.

    complete  whether the conditions are solved for the coordinates; otherwise the rate may be given by its square, and
              by one of several conditions if no other one contains it: the orbit of a satellite, φ'² = F(r, θ), where
              sin θ cos θ = 0 says how it points
    """
    if len(conditions) == 1:
        return conditions[0], _rate_from(conditions[0], rates, 1 if complete else 2)
    for n, condition in enumerate(() if complete else conditions):
        others = {s for m, e in enumerate(conditions) if m != n for s in e.free_symbols}
        solved = _rate_from(condition, [v for v in rates if v not in others], 2)
        if solved is not None:
            return condition, solved
    return ZERO, None


def _rate_from(condition: sp.Expr, rates: Sequence[sp.Symbol], degree: int) -> dict[sp.Symbol, sp.Expr] | None:
    """A constant rate from a condition that is linear in it, or, of degree 2, in its square."""
    for rate in rates:
        slope = partial(condition, rate)
        if slope != 0 and rate not in slope.free_symbols:
            return {rate: _quotient(-condition.xreplace({rate: ZERO}), slope)}
    for rate in rates if degree == 2 else ():
        of_square = sp.cancel(partial(condition, rate) / (2 * rate))
        if of_square != 0 and rate not in of_square.free_symbols:
            return {rate: sp.sqrt(_quotient(-condition.xreplace({rate: ZERO}), of_square))}
    return None


def _quotient(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """A quotient without fractions within fractions: K (r + a)/(m a r³) for K (1/r + 1/a)/(m r²)."""
    value = textbook_form(above / below)
    return min((value, factored_quotient(value)), key=reading_length)


def rate_at_position(
    conditions: Sequence[sp.Expr], rates: Sequence[sp.Symbol], general: Equilibrium, radius: sp.Symbol | None
) -> dict[sp.Symbol, sp.Expr] | None:
    """The rate at which a coordinate keeps a value, φ'² = F(r), where the value is r = G(φ'²), or r³, and no angle."""
    if len(conditions) != 1 or len(rates) != 1 or any(b.left for b in general.branches):
        return None
    placed = [r for b in general.branches for r in b.relations]
    if not all(r.lhs.as_base_exp()[0].is_Symbol and sp.fraction(sp.together(r.rhs))[1].has(*rates) for r in placed):
        return None
    [condition] = conditions
    solved = _rate_from(condition, rates, 2) if placed else None
    return solved if solved is not None and determines(condition, rates[0], general, radius) else None


def determines(condition: sp.Expr, rate: sp.Symbol, general: Equilibrium, radius: sp.Symbol | None) -> bool:
    """Whether a condition a φ'² = b has no other solutions than φ'² = b/a, because a and b nowhere vanish together.

    radius  a coordinate that is positive: a = m r² exp(r/b) does not vanish
    """
    slope = sp.cancel(partial(condition, rate) / (2 * rate))
    if rate in slope.free_symbols:
        return False
    if radius is not None and sign_of(slope.xreplace({radius: sp.Dummy(positive=True)})) in (1, -1):
        return True
    both = solutions([slope, condition.xreplace({rate: ZERO})], general.configuration.slots.coordinates)
    return both.solved and not both.branches


def rate_at_any_position(b: Branch, rates: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr] | None:
    """A constant rate that a branch in which no coordinate occurs determines: a φ'² = g or m φ' = −q B."""
    if not b.special or b.left or len(b.relations) != 1:
        return None
    [relation] = b.relations
    balance = relation.lhs - relation.rhs
    for rate in rates:
        if not balance.is_polynomial(rate):
            continue
        match sp.Poly(balance, rate).all_coeffs():
            case [slope, rest]:
                return {rate: textbook_form(-rest / slope)}
            case [slope, middle, rest] if middle == 0 and (square := textbook_form(-rest / slope)).is_positive:
                return {rate: sp.sqrt(square)}
    return None


def have_several(conditions: Sequence[sp.Expr], rates: Sequence[sp.Symbol]) -> bool:
    """Whether conditions contain several constant rates: they are shorter for a rate than for a coordinate."""
    return len({v for e in conditions for v in e.free_symbols} & {*rates}) > 1
