"""Quasi-velocities: linear combinations of the velocities in which the equations of motion are to be written.

    u_s = Σ S_sk q_k' + s_s ,     together with the constraints     Σ a_jk q_k' + a_jt = 0 ,

are linear equations for the velocities. As many u as there are degrees of freedom, independent of one another and of
the constraints, determine them by the kinematic equations

    q_k' = Σ B_ks u_s + b_k ,     and     δq_k = Σ B_ks δπ_s ,     δπ_s = Σ S_sk δq_k .

δπ_s is not the variation of any function: it denotes u_s dt with time frozen. The δπ_s are free in every virtual
displacement. Fewer u are completed by velocities q_k' that they do not yet determine.

Within the derivation each u_s is the velocity of a quasi-coordinate of the same name: its slots are u_s' and u_s'', so
that functions of velocities and accelerations apply to these. `shown` turns them into u_s and u_s'.
Reference: Neimark and Fufaev, Dynamics of Nonholonomic Systems, chapter III.

Shapes: S (p, n), B (n, p), b (n,), for n coordinates and p quasi-velocities.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TypeVar

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.algebra.fourier.vector_cleanup import with_cotangents
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError, UndecidedError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime, variation
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.displacements import Elimination, TooLongError, eliminate
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.limits import LONGEST_ELIMINATION, LONGEST_KINEMATIC
from lagrange.mechanics.dynamics.reactions import over_one_denominator
from lagrange.problem.model import Speed

Shown = TypeVar("Shown", sp.Expr, Vector)


@record
class QuasiVelocities:
    """The quasi-velocities in the coordinates of a configuration.

    definitions  u_s, by name, in the velocities of the configuration
    completing   coordinates whose velocities complete them
    partials     B, shape (n, p)
    drift        b, shape (n,)
    pivots       expressions that must not vanish
    """

    configuration: Configuration
    definitions: Mapping[sp.Symbol, sp.Expr]
    completing: tuple[sp.Symbol, ...]
    partials: tuple[tuple[sp.Expr, ...], ...]
    drift: tuple[sp.Expr, ...]
    pivots: tuple[sp.Expr, ...]

    @property
    def slots(self) -> Slots:
        """The quasi-coordinates, coordinates that complete them last."""
        return Slots((*self.definitions, *self.completing))

    @cached_property
    def rates(self) -> dict[sp.Symbol, sp.Expr]:
        """q' -> B u + b, in the slots of the quasi-coordinates."""
        speeds = self.slots.velocities
        return {
            v: _in_groups(textbook_form(sp.Add(*(c * u for c, u in zip(row, speeds, strict=True)), b)))
            for v, row, b in zip(self.configuration.slots.velocities, self.partials, self.drift, strict=True)
        }

    @property
    def kinematic(self) -> dict[sp.Symbol, sp.Expr]:
        """The kinematic equations q' -> B u + b, as shown; without the velocities that complete the u."""
        known = {prime(q) for q in self.completing}
        return {v: self.shown(rate) for v, rate in self.rates.items() if v not in known}

    @property
    def virtual(self) -> dict[sp.Symbol, sp.Expr]:
        """δπ_s -> Σ S_sk δq_k."""
        coordinates = self.configuration.slots.coordinates
        return {
            quasi_variation(u): over_one_denominator(sp.Add(*(e.diff(prime(q)) * variation(q) for q in coordinates)))
            for u, e in self.definitions.items()
        }

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The u, and the velocities that complete them."""
        return (*self.definitions, *(prime(q) for q in self.completing))

    def shown(self, expression: Shown) -> Shown:
        """u' and u'' of the quasi-coordinates as u and u'; δu as δπ_u; cos w/sin w as cot w."""
        named = expression.xreplace(self._names)
        return named.map(with_cotangents) if isinstance(named, Vector) else with_cotangents(named)

    def defined(self, expression: sp.Expr) -> sp.Expr:
        """An expression as shown, after substituting the definitions: in q, q' and q''."""
        slots = self.configuration.slots
        rule: dict[sp.Basic, sp.Basic] = dict(self.definitions)
        rule |= {prime(u): slots.time_derivative(e) for u, e in self.definitions.items()}
        return expression.xreplace(rule)

    @cached_property
    def _names(self) -> dict[sp.Basic, sp.Basic]:
        names: dict[sp.Basic, sp.Basic] = {}
        for u in self.definitions:
            names |= {prime(u): u, prime(u, 2): prime(u), variation(u): quasi_variation(u)}
        return names


def quasi_variation(u: sp.Symbol) -> sp.Symbol:
    """δπ_u of a quasi-velocity u."""
    return variation(sp.Symbol(f"pi_{u.name}", real=True))


def quasi_velocities(speeds: Sequence[Speed], configuration: Configuration) -> QuasiVelocities:
    """The velocities of a configuration in terms of its quasi-velocities.

    Raises ProblemError if these depend on one another or on the constraints, UndecidedError if that cannot be decided,
    NotCoveredError if a constraint is not linear in the velocities.
    """
    if not configuration.constrained.is_pfaffian:
        message = "quasi-velocities (`speeds`) beside a constraint that is not linear in the velocities"
        raise NotCoveredError(message, speeds[0].span)
    slots = configuration.slots
    size, count = len(slots.coordinates), len(speeds)
    zeros = (sp.S.Zero,) * count
    definitions = {s.symbol: _shorter(configuration.rewritten(s.definition)) for s in speeds}
    rows = [Row(r.name, (*r.coefficients, *zeros), r.drift) for r in configuration.rows]
    for n, (u, e) in enumerate(definitions.items()):
        own = tuple(sp.S.NegativeOne if m == n else sp.S.Zero for m in range(count))
        at_rest = dict.fromkeys(slots.velocities, sp.S.Zero)
        rows.append(Row(u.name, (*(textbook_form(e.diff(v)) for v in slots.velocities), *own), e.xreplace(at_rest)))
    _check_independent(speeds, rows, configuration)
    # The rows u_s − Σ S_sk q_k' − s_s = 0 are appended to the constraints, and the q' eliminated first: the u are left.
    solved = _eliminated(speeds, rows, configuration)
    if any(size + n not in solved.independent for n in range(count)):  # some pivot could not be shown to be nonzero
        raise UndecidedError("the velocities in terms of the quasi-velocities", speeds[0].span)
    table: list[list[sp.Expr]] = [[sp.S.Zero] * len(solved.independent) for _ in range(size)]
    drift = [sp.S.Zero] * size
    for k, row, b in zip(solved.dependent, solved.solution, solved.drift, strict=True):
        table[k], drift[k] = list(row), b
    completing = [k for k in solved.independent if k < size]
    for k in completing:
        table[k][solved.independent.index(k)] = sp.S.One
    order = [solved.independent.index(size + n) for n in range(count)]
    order += [solved.independent.index(k) for k in completing]
    return QuasiVelocities(
        configuration=configuration,
        definitions=definitions,
        completing=tuple(slots.coordinates[k] for k in completing),
        partials=tuple(tuple(row[n] for n in order) for row in table),
        drift=tuple(drift),
        pivots=solved.pivots,
    )


def _eliminated(speeds: Sequence[Speed], rows: Sequence[Row], configuration: Configuration) -> Elimination:
    """The rows solved for the velocities."""
    size = len(configuration.slots.coordinates)
    too_long = NotCoveredError("quasi-velocities that give kinematic equations of many pages", speeds[0].span)
    try:
        solved = eliminate(rows, size + len(speeds), configuration.surface, range(size), LONGEST_ELIMINATION)
    except TooLongError:
        raise too_long from None
    if sum(count_operations(e) for row in solved.solution for e in row) > LONGEST_KINEMATIC:
        raise too_long
    return solved


def _shorter(definition: sp.Expr) -> sp.Expr:
    """The definition as written in the file, unless its textbook form is shorter: dot(omega_B, e1_B), expanded."""
    tidied = textbook_form(definition)
    return tidied if count_operations(tidied) < count_operations(definition) else definition


def _in_groups(rate: sp.Expr) -> sp.Expr:
    """Terms with the same denominator as one quotient: (p sin ψ + q cos ψ)/sin θ."""
    groups: dict[sp.Expr, list[sp.Expr]] = {}
    for term in sp.Add.make_args(rate):
        groups.setdefault(sp.fraction(term)[1], []).append(term)
    return sp.Add(*(over_one_denominator(sp.Add(*terms)) for terms in groups.values()))


def _check_independent(speeds: Sequence[Speed], rows: Sequence[Row], configuration: Configuration) -> None:
    """Refuse a quasi-velocity that follows from earlier ones and the constraints, and name it.

    The rows are those of the constraints, then those of the quasi-velocities.
    """
    size = len(configuration.slots.coordinates)
    table = [list(r.coefficients[:size]) for r in rows]
    constraints = len(rows) - len(speeds)

    def rank(matrix: list[list[sp.Expr]]) -> int:
        value = configuration.surface.rank(matrix) if matrix else 0
        if value is None:
            raise UndecidedError("whether the quasi-velocities are independent", speeds[0].span)
        return value

    alone = rank(table[:constraints])
    if rank(table) == alone + len(speeds):
        return
    ranks = [alone, *(rank(table[: constraints + n + 1]) for n in range(len(speeds)))]
    dependent = [s for s, before, after in zip(speeds, ranks, ranks[1:], strict=False) if after == before]
    [row] = (table[constraints + n] for n, s in enumerate(speeds) if s == dependent[0])
    fixed = rank([*table[:constraints], row]) == alone
    freedom = size - alone
    listed = ", ".join(f"`{s.symbol}`" for s in dependent)
    one = len(dependent) == 1
    message = f"{listed} {'follows' if one else 'follow'} from the other quasi-velocities and the constraints"
    if one and fixed:
        message = f"{listed} is fixed by the constraints"
    many = f"{len(speeds)} quasi-velocities, and {freedom} degree{'s' * (freedom != 1)} of freedom: "
    help_ = f"{many if len(speeds) > freedom else ''}leave {'it' if one else 'them'} out, or choose others"
    raise ProblemError(Diagnostic("dependent-speeds", message, dependent[0].span, help=help_))
