"""A position of equilibrium of a large system, in numbers, near the one that `initial` gives.

At rest d'Alembert's principle has the coefficients E_k(q), without the accelerations. With the reactions Σ λ a_k, and
the finite relations f = 0,

    E + K ξ = Σ λ (a + ∂a ξ) ,        f + (∂f) ξ = 0

are solved for the change ξ of the coordinates and for λ, from which the next step begins (Newton's iteration). Where
K − Σ λ ∂a is symmetric, its values for the displacements that the constraints admit decide on stability (Lagrange,
Dirichlet): the second variation of the potential energy, with the curvature of the constraints.

Other positions are not looked for. Lagrange's equations with the derivatives of T check the one that is found.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import nullspace, solution
from lagrange.algebra.exact.points_needed import REAL_DIGITS
from lagrange.algebra.exact.real_points import symmetric_eigensystem
from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.nearby.accelerations import NOT_POSSIBLE, has_numbers, shown_number
from lagrange.mechanics.nearby.checks import lagrange_in_numbers
from lagrange.mechanics.nearby.expansions import Expansions
from lagrange.mechanics.nearby.limits import CHECKED_REMAINDER, REST_STEPS
from lagrange.mechanics.nearby.linear_equations import FirstOrderTerms, first_order
from lagrange.mechanics.nearby.reference import reference
from lagrange.problem.model import Problem

CHECK = "the position of rest in numbers satisfies Lagrange's equations"


@record
class RestInNumbers:
    """One position of equilibrium.

    position     coordinates, by symbol
    multipliers  by name of the constraint; without those of redundant ones
    stable       whether the potential energy has a minimum there; None where that does not decide
    agrees       whether Lagrange's equations hold there
    """

    position: Mapping[sp.Symbol, sp.Expr]
    multipliers: Mapping[str, sp.Expr]
    stable: bool | None
    agrees: bool


def rest_in_numbers(problem: Problem, configuration: Configuration) -> RestInNumbers:
    """The position of equilibrium that Newton's iteration reaches from that of `initial`.

    Raises NotCoveredError, ProblemError where no position near that of `initial` satisfies the constraints.
    """
    what = "the equilibrium of a system whose displacements are too long to be solved for,"
    if not has_numbers(problem):
        raise NotCoveredError(
            f"{what} in letters", cure="give every parameter a `value`, and under `initial` a position near it"
        )
    if any(row.finite is None for row in configuration.rows) or configuration.variable_masses:
        raise NotCoveredError(f"{what} with constraints on velocities or masses that vary")
    slots = configuration.slots
    parameters = {p.symbol: p.value for p in problem.parameters if p.value is not None}
    stated = {i.symbol: i.value for i in problem.initial if i.symbol in slots.coordinates}
    near = reference(configuration, stated, parameters)
    try:
        found = _reached(configuration, dict(near.values) | dict.fromkeys(slots.velocities, sp.S.Zero), near.used)
    except NOT_POSSIBLE:
        found = None
    if found is None:
        raise NotCoveredError(
            f"{what} which was not reached from the position of `initial`",
            cure="give under `initial` a position that is nearer to it; `lagsolve simulate` with dampers comes to rest",
        )
    return found


def check_rest_in_numbers(rest: RestInNumbers) -> list[Check]:
    """The route by T and V."""
    return [Check(CHECK, rest.agrees, "in numbers: V differentiated")]


def _reached(
    configuration: Configuration, values: dict[sp.Symbol, sp.Expr], used: Sequence[int]
) -> RestInNumbers | None:
    """Newton's iteration; None where it does not converge, or the position is not determined. `values` are changed."""
    slots, n = configuration.slots, len(configuration.slots.coordinates)
    finite = [f for k in used if (f := configuration.rows[k].finite) is not None]
    pulls: list[Any] | None = None
    for _ in range(REST_STEPS):
        about = Expansions(slots, values)
        zero = about.reals.number(0)
        linear = first_order(configuration, about, [zero] * n)
        jets = [about.jet(f, 1) for f in finite]
        off, slopes = [about.at_state(jet) for jet in jets], [about.gradient(jet) for jet in jets]
        forms = [linear.rows[k] for k in used]
        if pulls is not None:
            slack = [e - sum(p * a[k] for p, a in zip(pulls, forms, strict=True)) for k, e in enumerate(linear.balance)]
            scale = max([1, *map(abs, linear.balance), *map(abs, pulls)])
            if max(map(abs, [*slack, *off])) < CHECKED_REMAINDER * scale:
                return _at_rest(configuration, values, about, linear, used, pulls)
        else:  # the reactions that balance the forces best, by least squares
            normal = [[sum(x * y for x, y in zip(a, b, strict=True)) for b in forms] for a in forms]
            along = [sum(x * e for x, e in zip(a, linear.balance, strict=True)) for a in forms]
            pulls = solution(about.reals, normal, along) if forms else []
            if pulls is None:
                return None
        steep = _stiffness(linear, used, pulls)
        table = [[*steep[k], *(-a[k] for a in forms)] for k in range(n)]
        table += [[*slope, *(zero for _ in forms)] for slope in slopes]
        right = [-e for e in linear.balance] + [-f for f in off]
        step = solution(about.reals, table, right)
        other = solution(about.reals, table, right, [about.reals.number(1)] * len(table))
        if step is None or step != other:
            return None
        pulls = step[n:]
        longest = max([1, *map(abs, step[:n])])  # no coordinate by more than 1 at once: an angle would go astray
        for q, x in zip(slots.coordinates, step[:n], strict=True):
            values[q] = sp.Float(about.number(values[q]) + x / longest, REAL_DIGITS + 5)
    return None


def _stiffness(linear: FirstOrderTerms, used: Sequence[int], pulls: Sequence[Any]) -> list[list[Any]]:
    """K − Σ λ ∂a, shape (n, n)."""
    n = len(linear.balance)
    return [
        [
            linear.stiffness[k][m] - sum(p * linear.slope[j][k][m] for j, p in zip(used, pulls, strict=True))
            for m in range(n)
        ]
        for k in range(n)
    ]


def _at_rest(
    configuration: Configuration,
    values: Mapping[sp.Symbol, sp.Expr],
    about: Expansions,
    linear: FirstOrderTerms,
    used: Sequence[int],
    pulls: Sequence[Any],
) -> RestInNumbers:
    slots, n = configuration.slots, about.size
    zero = about.reals.number(0)
    forms = [linear.rows[k] for k in used]
    left = lagrange_in_numbers(configuration, about, [zero] * n, [zero] * n)
    loads = [sum((p * a[k] for p, a in zip(pulls, forms, strict=True)), zero) for k in range(n)]
    scale = max([1, *map(abs, (*left, *loads))])
    steep = _stiffness(linear, used, pulls)
    basis = nullspace(about.reals, forms, n)
    turned = [[sum(x * y for x, y in zip(row, b, strict=True)) for row in steep] for b in basis]
    reduced = [[sum(x * y for x, y in zip(a, row, strict=True)) for row in turned] for a in basis]
    size = len(basis)
    largest = max([zero, *(abs(e) for row in reduced for e in row)])
    small = CHECKED_REMAINDER * largest
    symmetric = all(abs(reduced[i][k] - reduced[k][i]) < small for i in range(size) for k in range(i))
    stable = None
    if symmetric and size and largest:
        least = min(symmetric_eigensystem(reduced)[0])
        stable = True if least > small else False if least < -small else None
    return RestInNumbers(
        {q: shown_number(about.number(values[q])) for q in slots.coordinates},
        {configuration.rows[j].name: shown_number(p) for j, p in zip(used, pulls, strict=True)},
        stable,
        all(abs(a - b) < CHECKED_REMAINDER * scale for a, b in zip(left, loads, strict=True)),
    )
