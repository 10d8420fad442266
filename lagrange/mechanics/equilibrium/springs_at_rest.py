"""The forces of springs at the equilibria: k (d − l) at every point of a branch, positive where the spring pulls.

A branch such as cos θ = a is a set of points. The force is stated where it is the same at all of them, which is decided
exactly; otherwise the branch says too little.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.limits import LARGEST_FACTORED
from lagrange.algebra.closed_forms.polynomial_roots import without_squares
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.core.operations import count_operations
from lagrange.mechanics.constraints.springs_dampers import StretchedSpring
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium


def with_spring_forces(e: Equilibrium) -> Equilibrium:
    """The equilibria with the force of each spring at each branch, by its name; of those that have one value there."""
    springs = e.configuration.springs
    if e.given or not springs:
        return e
    pulls = tuple({s.name: f for s in springs if (f := _force(s, b, e)) is not None} for b in e.branches)
    return replace(e, pulls=pulls)


def _force(spring: StretchedSpring, b: Branch, e: Equilibrium) -> sp.Expr | None:
    """k (d − l) at all points of a branch; None if it is not the same, or cannot be written out."""
    if b.left or b.special or not b.points:
        return None
    try:
        values = [without_squares(e.solution.at(p, spring.pull)) for p in b.points]
        first, *others = values
        if any(v.has(sp.zoo, sp.nan, sp.oo) for v in values) or not all(is_zero(v - first) for v in others):
            return None
    except (NotAlgebraicError, DivisionByZeroError):
        return None
    quotient = sp.cancel(sp.together(first)) if count_operations(first) <= LARGEST_FACTORED else first
    return min(map(shortest_form, (first, quotient)), key=count_operations)
