"""One state of a large system in numbers: its accelerations and reactions, and a position of equilibrium near it.

Accelerations and reactions at one state, in numbers, where they would be too long in symbols.

With the coefficients E of d'Alembert's principle at the state, and d/dt (a·q' + a_t) = a·q'' + c,

    M q'' + E_0 = Σ λ a ,        a·q'' = −c

are linear equations for q'' and λ. Lagrange's equations, with the derivatives of T at the same state, check them.

A position of equilibrium of a large system, in numbers, near the one that `initial` gives.

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
from lagrange.algebra.exact.prime_field import InadmissibleError, ZeroDivisorError
from lagrange.algebra.exact.real_points import symmetric_eigensystem
from lagrange.algebra.forms.jets import NoExpansionError, WorkLimitError
from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.limits import CHECKED_REMAINDER, REST_STEPS, SHOWN_DIGITS
from lagrange.mechanics.nearby.checks import lagrange_in_numbers
from lagrange.mechanics.nearby.linear_equations import (
    Expansions,
    FirstOrderTerms,
    ReferenceState,
    first_order,
    reference,
)
from lagrange.problem.model import Problem

NOT_POSSIBLE = (ProblemError, NoExpansionError, WorkLimitError, ZeroDivisorError, InadmissibleError)
"""What is raised where a state does not exist, or an expression has no derivatives there."""


@record
class StateInNumbers:
    """What happens at one state.

    state          coordinates and velocities, by symbol
    accelerations  by symbol
    multipliers    by name of the constraint; without those of redundant ones
    agrees         whether Lagrange's equations hold with these
    """

    state: Mapping[sp.Symbol, sp.Expr]
    accelerations: Mapping[sp.Symbol, sp.Expr]
    multipliers: Mapping[str, sp.Expr]
    agrees: bool


def at_state(configuration: Configuration, near: ReferenceState) -> StateInNumbers | None:
    """Accelerations and multipliers at a state; None if they are not determined. Raises NotCoveredError."""
    slots = configuration.slots
    rows = [configuration.rows[k] for k in near.used]
    in_rows = {s for row in rows for a in (*row.coefficients, row.drift) for s in a.free_symbols}
    if t in in_rows or configuration.variable_masses or not configuration.constrained.is_pfaffian:
        return None
    about = Expansions(slots, near.values)
    n, zero = about.size, about.reals.number(0)
    linear = first_order(configuration, about, [about.number(v) for v in slots.velocities])
    forms = [linear.rows[k] for k in near.used]
    table = [[*linear.mass[k], *(-form[k] for form in forms)] for k in range(n)]
    table += [[*form, *(zero for _ in forms)] for form in forms]
    right = [-e for e in linear.balance] + [-linear.misfit[k] for k in near.used]
    accelerations = solution(about.reals, table, right)
    other = solution(about.reals, table, right, [about.reals.number(1)] * len(table))
    if accelerations is None or other is None or accelerations != other:  # what stays free would differ
        return None
    left = lagrange_in_numbers(configuration, about, [about.number(v) for v in slots.velocities], accelerations[:n])
    loads = [sum((m * form[k] for m, form in zip(accelerations[n:], forms, strict=True)), zero) for k in range(n)]
    scale = max([1, *map(abs, (*left, *loads))])
    agrees = all(abs(a - b) < CHECKED_REMAINDER * scale for a, b in zip(left, loads, strict=True))
    names = [row.name for row in rows]
    return StateInNumbers(
        {s: near.values[s] for s in (*slots.coordinates, *slots.velocities)},
        {s: shown_number(x) for s, x in zip(slots.accelerations, accelerations[:n], strict=True)},
        {name: shown_number(x) for name, x in zip(names, accelerations[n:], strict=True)},
        agrees,
    )


def has_numbers(problem: Problem) -> bool:
    """Whether all parameters have values, and no function is left open."""
    return all(p.value is not None for p in problem.parameters) and not problem.functions


def start_in_numbers(problem: Problem, configuration: Configuration) -> StateInNumbers | None:
    """What happens at t = 0; None where parameters have no value, or `initial` does not determine the state."""
    if not problem.initial or not has_numbers(problem):
        return None
    slots = configuration.slots
    parameters = problem.given_values
    known = {*slots.coordinates, *slots.velocities}
    stated = {i.symbol: i.value for i in problem.initial if i.symbol in known}
    try:
        near = reference(configuration, stated, parameters)
        left_open = [slots.coordinates[k] for k in near.placed if slots.coordinates[k] not in stated]
        left_open += [slots.velocities[k] for k in near.independent if slots.velocities[k] not in stated]
        return None if left_open else at_state(configuration, near)
    except NOT_POSSIBLE:
        return None


def check_state(state: StateInNumbers, what: str) -> Check:
    """Lagrange's equations at the state, with the derivatives of T in numbers."""
    return Check(f"the {what} in numbers satisfy Lagrange's equations", state.agrees, "in numbers: T differentiated")


def shown_number(x: Any) -> sp.Expr:
    """A number with as many digits as are shown; one that is a remainder of rounding is zero."""
    return sp.S.Zero if abs(x) < CHECKED_REMAINDER else sp.Float(x, SHOWN_DIGITS)


# Rest


CHECK = "the position of rest in numbers satisfies Lagrange's equations"


@record
class RestInNumbers:
    """One position of equilibrium.

    position     coordinates, by symbol
    multipliers  by name of the constraint; without those of redundant ones
    stable       whether the potential energy has a minimum there; None if that does not decide
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
    parameters = problem.given_values
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
    """Newton's iteration; None if it does not converge, or the position is not determined. `values` are changed."""
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
