"""Integrals of the motion as they are written: without constants, and multiples of one velocity.

*Energy beside Jacobi's integral.* J = Σ q' ∂L/∂q' − L is constant where time occurs in the positions only, and
E = T + V = J + G. Of axes that are turned at the rate Ω the difference G is Ω times the angular momentum, and its rate
the power that turns them.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import partial, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.conservation import Conserved, ConservedQuantity, Integral
from lagrange.mechanics.limits import LONGEST_INTEGRAL_IN_ROOTS
from lagrange.mechanics.rewriting.factors import in_factors


def without_constants(integral: Integral, configuration: Configuration) -> Integral:
    """The integral without terms in which nothing moves, and with its roots in one fraction if that is shorter.

    A rest energy m c² in the potential energy makes E = γ m c² + V a sum in which it would stand twice.
    """
    slots = configuration.slots
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}
    terms = sp.Add.make_args(integral.expression)
    kept = [e for e in terms if e.free_symbols & moving]
    expression = sp.Add(*kept) if len(kept) < len(terms) else integral.expression
    rooted = [e for e in kept if any(p.exp.is_Rational and not p.exp.is_Integer for p in e.atoms(sp.Pow))]
    if rooted and sum(map(count_operations, rooted)) <= LONGEST_INTEGRAL_IN_ROOTS:
        before = sp.Add(*rooted)
        numerator, denominator = sp.fraction(sp.together(before))
        one = textbook_form(sp.expand(numerator) / denominator)
        if count_operations(one) < count_operations(before) and is_zero(one - before) is True:
            expression = sp.Add(one, *(e for e in kept if e not in rooted))
    return integral if expression == integral.expression else replace(integral, expression=expression)


@record
class EnergyExcess:
    """E = J + excess, where J is the integral of this number, counted from 1; `rate`: dE/dt, without accelerations."""

    number: int
    excess: sp.Expr
    rate: sp.Expr | None


def energy_excess(conserved: Conserved) -> EnergyExcess | None:
    """What the energy has in addition to Jacobi's integral; None without either."""
    if conserved.energy is None:
        return None
    slots = conserved.motion.configuration.slots
    for n, i in enumerate(conserved.integrals, start=1):
        if i.quantity is ConservedQuantity.JACOBI:
            excess = in_factors(textbook_form(sp.expand(conserved.energy.expression - i.expression)))
            rate = in_factors(slots.time_derivative(excess))
            return EnergyExcess(n, excess, None if rate.free_symbols & {*slots.accelerations} else rate)
    return None


def is_multiple_of(e: sp.Expr, velocity: sp.Symbol, configuration: Configuration) -> bool:
    """Whether an expression linear in the velocities is c q', with a constant c, by one constraint on velocities."""
    slots = configuration.slots
    moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}
    for row in configuration.rows:
        form = row.velocity_form(slots)
        for v in sorted(form.free_symbols & {*slots.velocities} - {velocity}, key=str):
            factor, share = partial(form, v), partial(e, v)
            if share == 0 or factor.has(v) or share.has(v):
                continue
            rest = sp.cancel(sp.expand(e * factor - share * form) / factor)
            multiple = sp.cancel(rest / velocity)
            if multiple != 0 and not multiple.free_symbols & moving:
                return True
    return False
