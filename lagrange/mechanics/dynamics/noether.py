"""Symmetries: the displacements and shifts of time that give conserved quantities.

With Lagrange's expressions Λ_k = p_k' − ∂L/∂q_k − Q'_k = Σ_j λ_j a_jk, multipliers μ_k(q, q', t) give

    δq = ξ:   Σ ξ_k Λ_k  = d/dt (Σ ξ_k p_k) − R ,   R = Σ ξ_k (∂L/∂q_k + Q'_k) + Σ ξ_k' p_k
    δt:       Σ q_k' Λ_k = dh/dt − R ,              R = Σ Q'_k q_k' − ∂L/∂t .

So Σ c I is conserved if Σ c R = 0 and Σ c Σ_k a_jk μ_k = 0 for every constraint j: the reactions then have no power in
the displacement. A cyclic coordinate alone is not enough, because in a nonholonomic system its reaction may do work.
The candidates are translations along one coordinate, rotations q_i δq_j, virtual displacements admitted by kinematic
constraints, and δt. Both conditions are linear in the constants c, which are found as a null space at random states.

Gauge symmetries need only R = dG/dt; then I − G is conserved:

    m x'' = q B y'                 δx:  R = q B y' = d/dt (q B y) ,       m x' − q B y = const
    the same, and y                a rotation:  R = −q B (x x' + y y') ,  m (x y' − y x') + q B (x² + y²)/2 = const
    a lift with acceleration a     δt:  R = −∂L/∂t = dG/dt with G of q and t ,     h − G = const

R must be linear in the velocities, ρ·q' + ρ_t, with an exact form ρ dq + ρ_t dt, conditions that are linear in c again.
For a displacement, G must not contain time. Reference: E. Noether, Invariante Variationsprobleme, 1918.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from functools import cache
from itertools import combinations, combinations_with_replacement

import sympy as sp

from lagrange.algebra.exact.limits import DRAWS
from lagrange.algebra.exact.linear_algebra import row_reduced
from lagrange.algebra.exact.zero_test import FieldPoint, InadmissibleError, Point
from lagrange.algebra.forms.exact_forms import potential_of
from lagrange.algebra.fourier.ring import Element
from lagrange.core.records import record
from lagrange.core.symbols import Sign, base, t
from lagrange.mechanics.constraints.kinematics import Configuration, MassPoint
from lagrange.mechanics.dynamics.comparison import ContradictionError, agreed_in_motion, random_state
from lagrange.mechanics.dynamics.energy_functions import EnergyFunctions
from lagrange.mechanics.dynamics.limits import (
    FIRST_DRAWS,
    LARGEST_NUMBER,
    MOST_FAILED_STATES,
    MOST_GAUGE_COORDINATES,
    MOST_PARAMETERS,
    MOST_ROTATIONS,
    PARAMETER_TRIALS,
    SPARE_STATES,
)


class SymmetryKind(StrEnum):
    """The kind of displacement of a candidate."""

    TRANSLATION = "translation"
    ROTATION = "rotation"
    ADMITTED = "admitted"
    GAUGE = "gauge"
    TIME = "time"


@record
class SymmetryCandidate:
    """One displacement, or the shift of time.

    multipliers  shape (n,): μ
    conditions   shape (m + 1,): Σ_k a_jk μ_k of each constraint, and R
    gauge        G, if R = dG/dt has been moved to the left side: then R is 0
    """

    kind: SymmetryKind
    multipliers: tuple[sp.Expr, ...]
    conditions: tuple[sp.Expr, ...]
    gauge: sp.Expr = sp.S.Zero


@record
class Symmetry:
    """Σ c · candidate: `terms` are the candidates with c, shape of `multipliers` (n,)."""

    kind: SymmetryKind
    terms: tuple[tuple[SymmetryCandidate, sp.Expr], ...]

    @property
    def multipliers(self) -> tuple[sp.Expr, ...]:
        """Σ c μ, shape (n,)."""
        each = ([c * m for m in candidate.multipliers] for candidate, c in self.terms)
        return tuple(sp.Add(*column) for column in zip(*each, strict=True))

    @property
    def displacement(self) -> tuple[sp.Expr, ...]:
        """Σ c ξ of the displacements among the candidates, shape (n,)."""
        each = [[c * m for m in k.multipliers] for k, c in self.terms if k.kind is not SymmetryKind.TIME]
        return tuple(sp.Add(*column) for column in zip(*each, strict=True))


def candidates(energies: EnergyFunctions, columns: Sequence[Sequence[sp.Expr]]) -> list[SymmetryCandidate]:
    """The candidates; `columns` are virtual displacements admitted by the kinematic constraints, (., n).

    A rotation enters as its halves, q_j δq_i and q_i δq_j: the null space finds their coefficients together with those
    of the other points that rotate with it. With quasi-coordinates, for which Lagrange's equations do not hold, the
    shift of time is the only candidate.
    """
    configuration, slots = energies.configuration, energies.slots
    n = len(slots.coordinates)
    rows = configuration.rows
    quasi = energies.are_quasi

    @cache
    def forces() -> list[sp.Expr]:
        return [f.to_sympy() for f in energies.lagrangian_forces]

    def displaced(kind: SymmetryKind, xi: Sequence[sp.Expr]) -> SymmetryCandidate:
        r = sp.Add(*(x * f for x, f in zip(xi, forces(), strict=True) if x != 0))
        if kind is not SymmetryKind.TRANSLATION:
            rates = [slots.time_derivative(x) for x in xi]
            r += sp.Add(*(x * p.to_sympy() for x, p in zip(rates, energies.momenta, strict=True) if x != 0))
        powers = (sp.Add(*(a * x for a, x in zip(row.coefficients, xi, strict=True))) for row in rows)
        return SymmetryCandidate(kind, tuple(xi), (*powers, r))

    tried = []
    if not quasi:
        plain = [(SymmetryKind.TRANSLATION, _unit(n, {k: sp.S.One})) for k in range(n)]
        for i, j in _planes(energies):
            plain.append((SymmetryKind.ROTATION, _unit(n, {i: slots.coordinates[j]})))
            plain.append((SymmetryKind.ROTATION, _unit(n, {j: slots.coordinates[i]})))
        if not (n > MOST_GAUGE_COORDINATES and _all_work_at_rest(plain, energies)):
            tried += [displaced(kind, xi) for kind, xi in plain]
        tried += [displaced(SymmetryKind.ADMITTED, xi) for xi in columns]
    if not quasi or not energies.has_motion_of_its_own:
        powers = (-row.drift for row in rows)
        tried.append(SymmetryCandidate(SymmetryKind.TIME, slots.velocities, (*powers, energies.jacobi_rate.to_sympy())))
    return tried


def _all_work_at_rest(plain: Sequence[tuple[SymmetryKind, Sequence[sp.Expr]]], energies: EnergyFunctions) -> bool:
    """Whether every combination of displacements of free coordinates changes the potential energy of some position.

    None of them is a symmetry then: Σ c R = 0 would hold term by term in the velocities, and so for the terms without
    any, which are few where the others are thousands. A full rank at random positions is a proof.
    """
    configuration = energies.configuration
    if configuration.rows or not configuration.states.exact or energies.jacobi_rate:
        return False
    try:
        forces = [f.to_sympy() for f in energies.forces_at_rest]
    except ValueError:
        return False
    tried = [
        SymmetryCandidate(kind, tuple(xi), (sp.Add(*(x * f for x, f in zip(xi, forces, strict=True) if x != 0)),))
        for kind, xi in plain
    ]
    states = _states(tried, configuration, 0)
    return states is not None and len(row_reduced(states[0].arithmetic, states[1])[1]) == len(tried)


def _unit(n: int, entries: Mapping[int, sp.Expr]) -> tuple[sp.Expr, ...]:
    return tuple(entries.get(k, sp.S.Zero) for k in range(n))


def _planes(energies: EnergyFunctions) -> list[tuple[int, int]]:
    """Pairs of Cartesian coordinates of one point, in axes that may turn with time."""
    ring = energies.ring
    pairs = {
        (i, j)
        for point in energies.configuration.points
        for (i, x), (j, y) in combinations(_straight(point, energies).items(), 2)
        if not ring.dot(x, y) and not (ring.dot(x, x) - ring.dot(y, y))  # perpendicular and equally long
    }
    return sorted(pairs) if len(pairs) <= MOST_ROTATIONS else []


def _straight(point: MassPoint, energies: EnergyFunctions) -> dict[int, list[Element]]:
    """The derivatives of a position, by their coordinate, that are not zero and independent of the coordinates."""
    ring, coordinates = energies.ring, energies.slots.coordinates
    straight = {}
    for k, slope in enumerate(point.partials):
        if not slope.is_zero:
            components = [ring.from_sympy(c) for c in slope.fixed().components]
            if all(ring.free_symbols(c).isdisjoint(coordinates) for c in components):
                straight[k] = components
    return straight


def symmetries(tried: Sequence[SymmetryCandidate], configuration: Configuration) -> list[Symmetry]:
    """The combinations with constant coefficients that satisfy the conditions, those of fewest terms first.

    If the constraints cannot be solved exactly, each candidate is tried by itself: a null space needs a field.
    """
    if not configuration.states.exact:
        return [s for s in _alone(tried) if _is_symmetry(s, configuration)]
    combinations: list[Symmetry] = []
    for group in _groups(tried):
        combinations += _combined(group, configuration)
    return sorted(combinations, key=lambda s: (s.kind is SymmetryKind.TIME, len(s.terms)))


def _groups(tried: Sequence[SymmetryCandidate]) -> Iterator[list[SymmetryCandidate]]:
    """Rotations with translations; admitted displacements; gauge candidates; δt with rotations and translations."""
    plain = [c for c in tried if c.kind in (SymmetryKind.TRANSLATION, SymmetryKind.ROTATION)]
    admitted = [c for c in tried if c.kind is SymmetryKind.ADMITTED]
    gauged = [c for c in tried if c.kind is SymmetryKind.GAUGE]
    yield from (group for group in (plain, admitted, gauged) if group)
    for c in tried:
        if c.kind is SymmetryKind.TIME:
            yield [*plain, c] if any(e != 0 for e in c.conditions) else [c]


def _alone(tried: Sequence[SymmetryCandidate]) -> Iterator[Symmetry]:
    for c in tried:
        if c.kind is not SymmetryKind.ROTATION:
            yield Symmetry(c.kind, ((c, sp.S.One),))
    turns = [c for c in tried if c.kind is SymmetryKind.ROTATION]
    for a, b in zip(turns[::2], turns[1::2], strict=True):
        yield Symmetry(SymmetryKind.ROTATION, ((a, sp.S.NegativeOne), (b, sp.S.One)))


def _is_symmetry(symmetry: Symmetry, configuration: Configuration) -> bool:
    width = len(symmetry.terms[0][0].conditions)
    conditions = [sp.Add(*(c * k.conditions[n] for k, c in symmetry.terms)) for n in range(width)]

    def holds(moving: Point) -> bool:
        return all(moving.is_zero(e) for e in conditions)

    return agreed_in_motion(configuration, holds, conditions) is True


def _combined(group: Sequence[SymmetryCandidate], configuration: Configuration) -> list[Symmetry]:
    # Coefficients may be functions of the parameters, and a null space in a field shows only their residues: a second
    # trial with other parameters tells whether the functions read off the first are right.
    time = [n for n, c in enumerate(group) if c.kind is SymmetryKind.TIME]
    first = _null_space(group, configuration, 0)
    if time:
        first = {free: v for free, v in first.items() if free in time}
    if not first:
        return []
    second: Mapping[int, TrialValues] | None = None
    coefficients = []
    for free, values in first.items():
        if set(values) == {free}:
            coefficients.append({free: sp.S.One})
            continue
        second = _null_space(group, configuration, 1) if second is None else second
        numbers = _constants(values, second.get(free), group, configuration)
        if numbers is not None:
            coefficients.append(numbers)
    kept = []
    for numbers in coefficients:
        kinds = {group[k].kind for k in numbers}
        kind = next(
            (k for k in (SymmetryKind.TIME, SymmetryKind.ROTATION) if k in kinds), group[next(iter(numbers))].kind
        )
        turned = [c for k, c in numbers.items() if group[k].kind is SymmetryKind.ROTATION]
        if kind is SymmetryKind.TIME or all(c.is_number for c in turned):
            kept.append(Symmetry(kind, tuple((group[k], numbers[k]) for k in sorted(numbers))))
    return kept


@record
class TrialValues:
    """The residues of the coefficients in one trial, by candidate, and the point with the values of the parameters."""

    point: FieldPoint
    residues: Mapping[int, int]

    def __iter__(self) -> Iterator[int]:
        return iter(self.residues)


def _null_space(
    group: Sequence[SymmetryCandidate], configuration: Configuration, number: int
) -> dict[int, TrialValues]:
    """The null space of the conditions at states with one set of parameters, by the last candidate of each vector."""
    for attempt in range(PARAMETER_TRIALS):
        states = _states(group, configuration, number + 2 * attempt)
        if states is None:
            continue
        point, rows = states
        reduced, pivots = row_reduced(point.arithmetic, rows)
        vectors = {}
        for free in (k for k in range(len(group)) if k not in pivots):
            others = {p: point.arithmetic.reduce(-row[free]) for p, row in zip(pivots, reduced, strict=True)}
            vectors[free] = TrialValues(point, {k: v for k, v in others.items() if v} | {free: 1})
        return vectors
    return {}


def _states(
    group: Sequence[SymmetryCandidate], configuration: Configuration, number: int
) -> tuple[FieldPoint, list[list[int]]] | None:
    """The conditions at enough states that share the parameters; None if there are no such states."""
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
    needed = len(group) // max(len(group[0].conditions) - 1, 1) + SPARE_STATES
    try:
        start = blank.with_values({s: blank.input(s) for s in symbols if s not in varied})
        for _ in range(MOST_FAILED_STATES):
            point = order.drawn(lambda: start.redrawn(varied), DRAWS if rows else FIRST_DRAWS)
            if point is None:
                return None
            try:
                moving_point = random_state(point, configuration, symbols)
                columns = [moving_point.values(c.conditions) for c in group]
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
    values: TrialValues, others: TrialValues | None, group: Sequence[SymmetryCandidate], configuration: Configuration
) -> dict[int, sp.Expr] | None:
    """Coefficients with the residues of two trials: numbers times products or quotients of two parameters."""
    if others is None or set(values) != set(others):
        return None
    moving = {*configuration.slots.coordinates, *configuration.slots.prescribed, t}
    symbols = {s for k in values for e in group[k].conditions for s in e.free_symbols if base(s) not in moving}
    parameters = sorted((s for s in symbols if not isinstance(s, Sign)), key=str)[:MOST_PARAMETERS]
    constants = {}
    for k, residue in values.residues.items():
        constant = _constant(residue, others.residues[k], values.point, others.point, parameters)
        if constant is None:
            return None
        constants[k] = constant
    return constants


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


@record
class _Rate:
    """A candidate with R = ρ·q' + ρ_t: `form` is (ρ, ρ_t), shape (n + 1,), and `candidate` has its conditions."""

    candidate: SymmetryCandidate
    form: tuple[Element, ...]


def gauged(tried: Sequence[SymmetryCandidate], energies: EnergyFunctions) -> list[Symmetry]:
    """The gauge symmetries among candidates and their combinations, each as one candidate with its G."""
    if energies.are_quasi or len(energies.slots.coordinates) > MOST_GAUGE_COORDINATES:
        return []
    displacements = [_Affine(energies, SymmetryKind.GAUGE).of(c) for c in _displacements(tried)]
    shifts = [
        _Affine(energies, SymmetryKind.TIME).of(c)
        for c in tried
        if c.kind is SymmetryKind.TIME and _is_driven(energies)
    ]
    return _with_rates(displacements, energies) + _with_rates(shifts, energies)


def _is_driven(energies: EnergyFunctions) -> bool:
    """Whether all of dh/dt comes from time in L: constant friction dissipates, although its work is a function."""
    velocities = [energies.ring.from_sympy(v) for v in energies.slots.velocities]
    return bool(energies.ring.is_zero(energies.ring.dot(energies.forces, velocities)))


def _displacements(tried: Sequence[SymmetryCandidate]) -> list[SymmetryCandidate]:
    """Translations, and rotations as single candidates: either half alone has an R quadratic in the velocities."""
    turns = [c for c in tried if c.kind is SymmetryKind.ROTATION]
    rotations = [
        SymmetryCandidate(
            SymmetryKind.ROTATION,
            tuple(y - x for x, y in zip(a.multipliers, b.multipliers, strict=True)),
            tuple(y - x for x, y in zip(a.conditions, b.conditions, strict=True)),
        )
        for a, b in zip(turns[::2], turns[1::2], strict=True)
    ]
    return [c for c in tried if c.kind is SymmetryKind.TRANSLATION] + rotations


class _Affine:
    """Makes candidates with the last condition, R = 0, replaced by the conditions for R = dG/dt."""

    def __init__(self, energies: EnergyFunctions, kind: SymmetryKind) -> None:
        self.ring, self.slots, self.kind = energies.ring, energies.slots, kind

    def of(self, candidate: SymmetryCandidate) -> _Rate | None:
        """The candidate with its form; None if R is not linear in the velocities."""
        ring, slots = self.ring, self.slots
        try:
            rho, rest = ring.linear(ring.from_sympy(candidate.conditions[-1]), slots.velocities)
        except ValueError:
            return None
        partials = [ring.partial(q) for q in slots.coordinates]
        frozen = ring.frozen_derivative(slots)
        curl = [partials[a](rho[b]) - partials[b](rho[a]) for a, b in combinations(range(len(rho)), 2)]
        if self.kind is SymmetryKind.TIME:
            curl += [frozen(r) - d(rest) for r, d in zip(rho, partials, strict=True)]
        else:
            curl += [rest, *map(frozen, rho)]
        conditions = (*candidate.conditions[:-1], *(c.to_sympy() for c in curl))
        return _Rate(SymmetryCandidate(self.kind, candidate.multipliers, conditions), (*rho, rest))


def _with_rates(tried: Sequence[_Rate | None], energies: EnergyFunctions) -> list[Symmetry]:
    """The combinations that satisfy the conditions and have a known G, without those with R = 0."""
    ring = energies.ring
    rates = [r for r in tried if r is not None and any(not ring.is_zero(e) for e in r.form)]
    if all(ring.is_zero(e) for r in rates for e in r.form[:-1]) and all(
        r.candidate.kind is SymmetryKind.GAUGE for r in rates
    ):
        return []
    candidates = [r.candidate for r in rates]
    result = []
    for symmetry in symmetries(candidates, energies.configuration):
        used = [(next(r for r in rates if r.candidate is k), c) for k, c in symmetry.terms]
        form = [ring.total(ring.from_sympy(c) * r.form[n] for r, c in used) for n in range(len(rates[0].form))]
        if all(ring.is_zero(e) for e in form):
            continue
        g = potential_of([e.to_sympy() for e in form], (*energies.slots.coordinates, t), energies.slots)
        if g is not None:
            combined = SymmetryCandidate(symmetry.kind, symmetry.multipliers, (), g)
            result.append(Symmetry(symmetry.kind, ((combined, sp.S.One),)))
    return result
