"""First-order equations in symbols: M s' − Aᵀ λ = f, A s' = b, and q' as a function of q, s and t.

In independent coordinates, and in quasi-velocities, there is no A. `state_equations.py` adds what is calculated along
the motion.

The first-order equations of a system whose equations of motion are too long to print, such as a bicycle.

D'Alembert's principle for each coordinate, without multiplying out, is affine in the accelerations:

    E(q, q', q'', t) = Aᵀ λ ,     M = ∂E/∂q'' ,     f = −E at q'' = 0 ,     A q'' = b = −d/dt (A q' + a_t) at q'' = 0 .

In letters that fills pages; as numbers, with its common parts evaluated once, it takes a fraction of a millisecond.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from functools import cached_property

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Slots, partial, prime, t
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.dynamics.energies import potential_energy
from lagrange.mechanics.dynamics.lagrangian import kinetic_energy
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations
from lagrange.mechanics.results import Solution


@record
class FirstOrderEquations:
    """First-order equations, in symbols.

    slots        the coordinates, and the prescribed motions u(t)
    speeds       s: velocities or quasi-velocities, shape (p,)
    rates        q' in q, s and t, shape (n,)
    mass         M; in quasi-velocities each row is divided by a common factor, so that M need not be symmetric
    force        f
    constraint_matrix  A, without rows that follow from others
    bias         b
    multipliers  λ, shape (m,)
    finite       g of the finite relations g = 0
    velocity_forms     A s + a_t of each row, zero along the motion; empty in quasi-velocities. A constraint that is not
                 linear in the velocities is φ = 0, with A = ∂φ/∂s
    """

    slots: Slots
    speeds: tuple[sp.Symbol, ...]
    rates: tuple[sp.Expr, ...]
    mass: tuple[tuple[sp.Expr, ...], ...]
    force: tuple[sp.Expr, ...]
    constraint_matrix: tuple[tuple[sp.Expr, ...], ...] = ()
    bias: tuple[sp.Expr, ...] = ()
    multipliers: tuple[sp.Symbol, ...] = ()
    finite: tuple[sp.Expr, ...] = ()
    velocity_forms: tuple[sp.Expr, ...] = ()

    @property
    def state(self) -> tuple[sp.Symbol, ...]:
        """The components of y, shape (n + p,)."""
        return (*self.slots.coordinates, *self.speeds)

    @property
    def speed_rates(self) -> tuple[sp.Symbol, ...]:
        """s', shape (p,)."""
        return tuple(prime(s) for s in self.speeds)

    @property
    def unknowns(self) -> tuple[sp.Symbol, ...]:
        """What the linear equations determine: s', then λ, shape (p + m,)."""
        return (*self.speed_rates, *self.multipliers)

    @property
    def matrix(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The rows M, −Aᵀ and A, 0 of the linear equations, shape (p + m, p + m)."""
        a = self.constraint_matrix
        upper = [(*row, *(-each[k] for each in a)) for k, row in enumerate(self.mass)]
        return (*upper, *((*row, *(sp.S.Zero for _ in a)) for row in a))

    @property
    def right(self) -> tuple[sp.Expr, ...]:
        """Their right sides f, b, shape (p + m,)."""
        return (*self.force, *self.bias)

    @cached_property
    def finite_slopes(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """∂g/∂q of each finite relation, with which positions are brought back to it."""
        return tuple(tuple(partial(g, q) for q in self.slots.coordinates) for g in self.finite)

    @property
    def kept(self) -> tuple[sp.Expr, ...]:
        """All that vanishes along the motion: finite relations, then constraints on speeds."""
        return (*self.finite, *self.velocity_forms)


def in_coordinates(dynamics: Motion) -> FirstOrderEquations:
    """The equations in coordinates and velocities."""
    form = dynamics.matrices
    slots, rows = form.configuration.slots, form.configuration.rows
    used = [n for n in range(len(rows)) if n not in dynamics.equations.elimination.unused]
    return FirstOrderEquations(
        slots=slots,
        speeds=slots.velocities,
        rates=slots.velocities,
        mass=form.mass,
        force=form.force,
        constraint_matrix=tuple(form.constraint_matrix[n] for n in used),
        bias=tuple(form.constraint_vector[n] for n in used),
        multipliers=tuple(dynamics.multipliers[rows[n].name] for n in used),
        finite=tuple(rows[n].finite for n in used if rows[n].finite is not None),
        velocity_forms=tuple(rows[n].velocity_form(slots) for n in used),
    )


def in_speeds(equations: QuasiEquations) -> FirstOrderEquations:
    """The equations in coordinates and quasi-velocities, which satisfy the constraints on velocities identically."""
    quasi = equations.quasi
    slots = quasi.configuration.slots
    unknowns = tuple(prime(s) for s in quasi.symbols)
    at_rest = dict.fromkeys(unknowns, sp.S.Zero)
    return FirstOrderEquations(
        slots=slots,
        speeds=quasi.symbols,
        rates=tuple(quasi.shown(quasi.rates[v]) for v in slots.velocities),
        mass=tuple(tuple(e.diff(a) for a in unknowns) for e in equations.expressions),
        force=tuple(-e.xreplace(at_rest) for e in equations.expressions),
        finite=quasi.configuration.finite_constraints,
    )


# Long motion


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
        """The value of an expression at 0, and the coefficient of each symbol that occurs."""
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
