"""Which displacements and shifts of time leave a system as it is (E. Noether, Invariante Variationsprobleme, 1918).

With Lagrange's expressions Λ_k = p_k' − ∂L/∂q_k − Q'_k = Σ_j λ_j a_jk, multipliers μ_k(q, q', t) give

    δq = ξ:   Σ ξ_k Λ_k  = d/dt (Σ ξ_k p_k) − R ,   R = Σ ξ_k (∂L/∂q_k + Q'_k) + Σ ξ_k' p_k
    δt:       Σ q_k' Λ_k = dh/dt − R ,              R = Σ Q'_k q_k' − ∂L/∂t .

So Σ c I is conserved where Σ c R = 0 and Σ c Σ_k a_jk μ_k = 0 for every constraint j: the reactions then have no power
in the displacement. Candidates are translations along one coordinate, rotations q_i δq_j, virtual displacements that
satisfy constraints on velocities, and δt (R may also be a rate dG/dt, which joins I: `gauges`). Their constant
coefficients c are the null space of these conditions at random states with the parameters kept; what they are as
functions of the parameters is guessed from two trials and to be verified (`conservation`). A cyclic coordinate alone is
not enough: in a nonholonomic system its reaction may work.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from itertools import combinations_with_replacement

import sympy as sp

from lagrange.algebra.exact.exact import FieldPoint, InadmissibleError, Point
from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.triangular import DRAWS
from lagrange.core.records import record
from lagrange.core.symbols import Sign, base, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import ContradictionError, agreed_in_motion, state
from lagrange.mechanics.dynamics.energy_functions import EnergyFunctions

MOST_ROTATIONS = 24
MOST_PARAMETERS = 12
LARGEST_NUMBER = 64
TRIALS = 24
"""Sets of parameters that are tried: with some, the constraints have no solution in the field."""
FIRST_DRAWS = 40
"""Draws after which a set of parameters that has not yet had a state is given up."""
FAILURES = 40


class Kind(StrEnum):
    """What a candidate is the symmetry of."""

    TRANSLATION = "translation"
    ROTATION = "rotation"
    ADMITTED = "admitted"
    GAUGE = "gauge"
    TIME = "time"


@record
class Candidate:
    """One displacement, or the shift of time.

    multipliers  shape (n,): μ
    conditions   shape (m + 1,): Σ_k a_jk μ_k of each constraint, and R
    gauge        G, where R is dG/dt and has been taken to the left side: R is 0 then
    """

    kind: Kind
    multipliers: tuple[sp.Expr, ...]
    conditions: tuple[sp.Expr, ...]
    gauge: sp.Expr = sp.S.Zero


@record
class Symmetry:
    """Σ c · candidate: `terms` are the candidates with c, shape of `multipliers` (n,)."""

    kind: Kind
    terms: tuple[tuple[Candidate, sp.Expr], ...]

    @property
    def multipliers(self) -> tuple[sp.Expr, ...]:
        """Σ c μ, shape (n,)."""
        each = ([c * m for m in candidate.multipliers] for candidate, c in self.terms)
        return tuple(sp.Add(*column) for column in zip(*each, strict=True))

    @property
    def displacement(self) -> tuple[sp.Expr, ...]:
        """Σ c ξ of the displacements among the candidates, shape (n,)."""
        each = [[c * m for m in k.multipliers] for k, c in self.terms if k.kind is not Kind.TIME]
        return tuple(sp.Add(*column) for column in zip(*each, strict=True))


def candidates(energies: EnergyFunctions, columns: Sequence[Sequence[sp.Expr]]) -> list[Candidate]:
    """What may be a symmetry; `columns` are virtual displacements that satisfy the constraints on velocities, (., n).

    With quasi-coordinates, which Lagrange's equations do not hold for, the shift of time is the only one.
    """
    configuration, slots = energies.configuration, energies.slots
    n = len(slots.coordinates)
    rows = configuration.rows
    quasi = energies.are_quasi
    forces = [f.to_sympy() for f in energies.lagrangian_forces]

    def displaced(kind: Kind, xi: Sequence[sp.Expr]) -> Candidate:
        r = sp.Add(*(x * f for x, f in zip(xi, forces, strict=True) if x != 0))
        if kind is not Kind.TRANSLATION:
            rates = [slots.time_derivative(x) for x in xi]
            r += sp.Add(*(x * p.to_sympy() for x, p in zip(rates, energies.momenta, strict=True) if x != 0))
        powers = (sp.Add(*(a * x for a, x in zip(row.coefficients, xi, strict=True))) for row in rows)
        return Candidate(kind, tuple(xi), (*powers, r))

    found = []
    if not quasi:
        found += [displaced(Kind.TRANSLATION, _unit(n, {k: sp.S.One})) for k in range(n)]
        for i, j in _planes(energies):
            found.append(displaced(Kind.ROTATION, _unit(n, {i: slots.coordinates[j]})))
            found.append(displaced(Kind.ROTATION, _unit(n, {j: slots.coordinates[i]})))
        found += [displaced(Kind.ADMITTED, xi) for xi in columns]
    if not quasi or not energies.has_motion_of_its_own:
        powers = (-row.drift for row in rows)
        found.append(Candidate(Kind.TIME, slots.velocities, (*powers, energies.jacobi_rate.to_sympy())))
    return found


def _unit(n: int, entries: Mapping[int, sp.Expr]) -> tuple[sp.Expr, ...]:
    return tuple(entries.get(k, sp.S.Zero) for k in range(n))


def _planes(energies: EnergyFunctions) -> list[tuple[int, int]]:
    """Pairs of coordinates that are Cartesian ones of one point, in axes that may turn with time."""
    coordinates = energies.slots.coordinates
    found = [
        (i, j)
        for j in range(len(coordinates))
        for i in range(j)
        if any(_are_cartesian(p.partials[i], p.partials[j], energies) for p in energies.configuration.points)
    ]
    return sorted(found) if len(found) <= MOST_ROTATIONS else []


def _are_cartesian(a: Vector, b: Vector, energies: EnergyFunctions) -> bool:
    """Whether two derivatives of a position are of one length and perpendicular, and the same in all positions."""
    if a.is_zero or b.is_zero:
        return False
    ring, coordinates = energies.ring, energies.slots.coordinates
    x, y = ([ring.from_sympy(c) for c in v.fixed().components] for v in (a, b))
    if any(not ring.free_symbols(c).isdisjoint(coordinates) for c in (*x, *y)):
        return False
    return not ring.dot(x, y) and not (ring.dot(x, x) - ring.dot(y, y))


def symmetries(found: Sequence[Candidate], configuration: Configuration) -> list[Symmetry]:
    """The combinations with constant coefficients that satisfy the conditions, those of fewest terms first.

    Where the constraints cannot be solved exactly, each candidate is tried by itself.
    """
    if not configuration.states.exact:
        return [s for s in _alone(found) if _is_symmetry(s, configuration)]
    combinations: list[Symmetry] = []
    for group in _groups(found):
        combinations += _combined(group, configuration)
    return sorted(combinations, key=lambda s: (s.kind is Kind.TIME, len(s.terms)))


def _groups(found: Sequence[Candidate]) -> Iterator[list[Candidate]]:
    """Rotations with translations; admitted displacements; those that change L by a rate; δt with all displacements."""
    plain = [c for c in found if c.kind in (Kind.TRANSLATION, Kind.ROTATION)]
    admitted = [c for c in found if c.kind is Kind.ADMITTED]
    gauged = [c for c in found if c.kind is Kind.GAUGE]
    yield from (group for group in (plain, admitted, gauged) if group)
    for c in found:
        if c.kind is Kind.TIME:
            yield [*plain, c]


def _alone(found: Sequence[Candidate]) -> Iterator[Symmetry]:
    for c in found:
        if c.kind is not Kind.ROTATION:
            yield Symmetry(c.kind, ((c, sp.S.One),))
    turns = [c for c in found if c.kind is Kind.ROTATION]
    for a, b in zip(turns[::2], turns[1::2], strict=True):
        yield Symmetry(Kind.ROTATION, ((a, sp.S.NegativeOne), (b, sp.S.One)))


def _is_symmetry(symmetry: Symmetry, configuration: Configuration) -> bool:
    width = len(symmetry.terms[0][0].conditions)
    conditions = [sp.Add(*(c * k.conditions[n] for k, c in symmetry.terms)) for n in range(width)]

    def holds(moving: Point) -> bool:
        return all(moving.is_zero(e) for e in conditions)

    return agreed_in_motion(configuration, holds, conditions) is True


def _combined(group: Sequence[Candidate], configuration: Configuration) -> list[Symmetry]:
    time = [n for n, c in enumerate(group) if c.kind is Kind.TIME]
    first = _null_space(group, configuration, 0)
    if time:
        first = {free: v for free, v in first.items() if free in time}
    if not first:
        return []
    second: Mapping[int, Values] | None = None
    found = []
    for free, values in first.items():
        if set(values) == {free}:
            found.append({free: sp.S.One})
            continue
        second = _null_space(group, configuration, 1) if second is None else second
        numbers = _constants(values, second.get(free), group, configuration)
        if numbers is not None:
            found.append(numbers)
    kept = []
    for numbers in found:
        kinds = {group[k].kind for k in numbers}
        kind = next((k for k in (Kind.TIME, Kind.ROTATION) if k in kinds), group[next(iter(numbers))].kind)
        turned = [c for k, c in numbers.items() if group[k].kind is Kind.ROTATION]
        if kind is Kind.TIME or all(c.is_number for c in turned):
            kept.append(Symmetry(kind, tuple((group[k], numbers[k]) for k in sorted(numbers))))
    return kept


@record
class Values:
    """The values of the coefficients in one trial, by candidate, and the point that has the parameters."""

    point: FieldPoint
    residues: Mapping[int, int]

    def __iter__(self) -> Iterator[int]:
        return iter(self.residues)


def _null_space(group: Sequence[Candidate], configuration: Configuration, number: int) -> dict[int, Values]:
    """The null space of the conditions at states with one set of parameters, by the last candidate of each vector."""
    for attempt in range(TRIALS):
        states = _states(group, configuration, number + 2 * attempt)
        if states is None:
            continue
        point, rows = states
        reduced, pivots = row_reduced(point.arithmetic, rows)
        found = {}
        for free in (k for k in range(len(group)) if k not in pivots):
            others = {p: point.arithmetic.reduce(-row[free]) for p, row in zip(pivots, reduced, strict=True)}
            found[free] = Values(point, {k: v for k, v in others.items() if v} | {free: 1})
        return found
    return {}


def _states(
    group: Sequence[Candidate], configuration: Configuration, number: int
) -> tuple[FieldPoint, list[list[int]]] | None:
    """The conditions at enough states that share the parameters; None where there are no such states."""
    surface = configuration.states
    graph, order = surface.graph, surface.order
    for c in group:
        for e in c.conditions:
            graph.node(e)
    moving = {*configuration.slots.coordinates, *configuration.slots.prescribed, t}
    symbols = list(graph.bits)
    varied = [s for s in symbols if base(s) in moving]
    field = surface.fields.field(number % 8, graph.squares)
    blank = FieldPoint(graph, field, surface.fields.random.getrandbits(16))
    assert order is not None
    rows: list[list[int]] = []
    needed = len(group) // max(len(group[0].conditions) - 1, 1) + 3
    try:
        start = blank.with_values({s: blank.input(s) for s in symbols if s not in varied})
        for _ in range(FAILURES):
            point = order.drawn(lambda: start.redrawn(varied), DRAWS if rows else FIRST_DRAWS)
            if point is None:
                return None
            try:
                there = state(point, configuration, symbols)
                columns = [there.values(c.conditions) for c in group]
            except InadmissibleError:
                continue
            rows += [list(row) for row in zip(*columns, strict=True)]
            needed -= 1
            if needed == 0:
                return start, rows
    except (InadmissibleError, ContradictionError):
        return None
    return None


def _constants(
    values: Values, others: Values | None, group: Sequence[Candidate], configuration: Configuration
) -> dict[int, sp.Expr] | None:
    """Coefficients of which two trials have the values: numbers times products of two parameters, or quotients."""
    if others is None or set(values) != set(others):
        return None
    moving = {*configuration.slots.coordinates, *configuration.slots.prescribed, t}
    symbols = {s for k in values for e in group[k].conditions for s in e.free_symbols if base(s) not in moving}
    parameters = sorted((s for s in symbols if not isinstance(s, Sign)), key=str)[:MOST_PARAMETERS]
    found = {}
    for k, residue in values.residues.items():
        constant = _constant(residue, others.residues[k], values.point, others.point, parameters)
        if constant is None:
            return None
        found[k] = constant
    return found


def _constant(a: int, b: int, first: FieldPoint, second: FieldPoint, parameters: Sequence[sp.Symbol]) -> sp.Expr | None:
    for m in _monomials(parameters):
        ratio = [p.reconstructed(p.field.reduce(v * p.field.inverse(p.value(m)))) for v, p in ((a, first), (b, second))]
        r = ratio[0]
        if r is not None and r == ratio[1] and abs(r.p) <= LARGEST_NUMBER and r.q <= LARGEST_NUMBER:
            return r * m
    return None


def _monomials(parameters: Sequence[sp.Symbol]) -> Iterator[sp.Expr]:
    yield sp.S.One
    for p in parameters:
        yield from (p, 1 / p)
    for p, q in combinations_with_replacement(parameters, 2):
        yield from (p * q, p / q, q / p, 1 / (p * q))
