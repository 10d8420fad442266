"""The first-order equations of a system whose equations of motion are too long to print, such as a bicycle.

D'Alembert's principle for each coordinate, without multiplying out, is affine in the accelerations:

    E(q, q', q'', t) = Aᵀ λ ,     M = ∂E/∂q'' ,     f = −E at q'' = 0 ,     A q'' = b = −d/dt (A q' + a_t) at q'' = 0 .

In letters that fills pages; as numbers, with its common parts evaluated once, it takes a fraction of a millisecond.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping

import sympy as sp

from lagrange.core.symbols import partial, t
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.dynamics.energies import potential_energy
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.results import Solution
from lagrange.programs.first_order import FirstOrderEquations


def long_first_order(solution: Solution) -> FirstOrderEquations:
    """The equations of `long_equations`, with the multipliers of the constraints that are independent."""
    assert solution.long_equations is not None
    slots, whole = solution.own.configuration.slots, solution.long_equations.whole
    rows = _independent_rows(solution)
    parts = _Affine(slots.accelerations)
    forms = tuple(row.velocity_form(slots) for row in rows)
    return FirstOrderEquations(
        slots=slots,
        speeds=slots.velocities,
        rates=slots.velocities,
        mass=tuple(tuple(parts.of(e)[1].get(a, sp.S.Zero) for a in slots.accelerations) for e in whole),
        force=tuple(-parts.of(e)[0] for e in whole),
        constraint_matrix=tuple(tuple(partial(f, v) for v in slots.velocities) for f in forms),
        bias=tuple(-parts.of(slots.time_derivative(f))[0] for f in forms),
        multipliers=tuple(row.multiplier for row in rows),
        finite=tuple(row.finite for row in rows if row.finite is not None),
        velocity_forms=forms,
    )


def long_energy(solution: Solution) -> sp.Expr | None:
    """T + V, where it is conserved: the reactions do no work and every force that does has a potential."""
    configuration = solution.own.configuration
    loads = {load.name for load in configuration.loads} - {"weight"}
    working = loads or configuration.dampers or configuration.generalized or configuration.variable_masses
    moving = (r for r in configuration.rows if r.drift != 0 or r.nonlinear is not None)
    if working or configuration.slots.prescribed or any(moving):
        return None
    energy = kinetic_energy(configuration) + potential_energy(configuration)
    return None if t in energy.free_symbols else energy


class _Affine:
    """Expressions that are affine in some symbols, taken apart, each common part once."""

    def __init__(self, symbols: Iterable[sp.Symbol]) -> None:
        self._symbols = frozenset(symbols)
        self._known: dict[sp.Expr, tuple[sp.Expr, Mapping[sp.Symbol, sp.Expr]]] = {}

    def of(self, e: sp.Expr) -> tuple[sp.Expr, Mapping[sp.Symbol, sp.Expr]]:
        """What is left at 0, and the coefficient of each symbol that occurs."""
        if e not in self._known:
            self._known[e] = self._taken_apart(e)
        return self._known[e]

    def _taken_apart(self, e: sp.Expr) -> tuple[sp.Expr, Mapping[sp.Symbol, sp.Expr]]:
        if e in self._symbols:
            return sp.S.Zero, {e: sp.S.One}
        parts = [self.of(a) for a in e.args]
        if not any(slopes for _, slopes in parts):
            return e, {}
        if e.is_Add:
            terms: dict[sp.Symbol, list[sp.Expr]] = defaultdict(list)
            for _, slopes in parts:
                for s, c in slopes.items():
                    terms[s].append(c)
            return sp.Add(*(rest for rest, _ in parts)), {s: sp.Add(*c) for s, c in terms.items()}
        [k, *others] = [k for k, (_, slopes) in enumerate(parts) if slopes]
        if not e.is_Mul or others:
            raise ValueError("not affine")
        factor = sp.Mul(*(a for n, a in enumerate(e.args) if n != k))
        rest, slopes = parts[k]
        return factor * rest, {s: factor * c for s, c in slopes.items()}


def _independent_rows(solution: Solution) -> list[Row]:
    redundant = solution.classification.redundant
    return [r for r in solution.own.configuration.rows if r.name not in redundant and not r.is_identity]
