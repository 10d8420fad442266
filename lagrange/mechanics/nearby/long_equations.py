"""Equations of motion with multipliers of a system in which nothing is eliminated, written with abbreviations.

    Σ m r''·∂r/∂q_k + Σ dH/dt·ω_k − Q_k = Σ λ a_k

is put together from the accelerations as they come, without multiplying out. Whatever occurs in it several times gets a
name z_1, z_2, ..., each defined by earlier ones only: so the equations of a bicycle are some hundred short lines,
quickly evaluated by a program; multiplied out they fill fifty pages.

Reactions that are too long as functions of position and velocity, of chains of rods in their own coordinates.

Newton's equations give them in terms of the accelerations, in a few letters: at the end of a chain by m r'', before it
by two of these. Of the n equations Σ_j λ_j a_jk = D_k as many are used as there are reactions, those
with the simplest coefficients. Where all parameters have values, the numbers at a state are found as well.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import partial, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations, share_of_damper, share_of_spring
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.dynamics.reactions import Reactions
from lagrange.mechanics.dynamics.spot_values import SpotValue
from lagrange.mechanics.limits import LONGEST_BY_ACCELERATIONS
from lagrange.mechanics.nearby.linear_equations import reference
from lagrange.mechanics.nearby.one_state import (
    NOT_POSSIBLE,
    StateInNumbers,
    at_state,
    check_state,
    has_numbers,
    start_in_numbers,
)
from lagrange.problem.model import Problem


@record
class LongEquations:
    """The equations of motion in abbreviations.

    definitions  z_1, z_2, ... in their order; a definition contains symbols of the problem, and earlier ones
    left         shape (n,): the left sides, without reactions
    right        shape (n,): the reactions, Σ λ a_k
    whole        shape (n,): the left sides without abbreviations
    """

    definitions: Mapping[sp.Symbol, sp.Expr]
    left: tuple[sp.Expr, ...]
    right: tuple[sp.Expr, ...]
    whole: tuple[sp.Expr, ...]


def long_equations(problem: Problem, configuration: Configuration) -> LongEquations:
    """D'Alembert's principle for each coordinate, in abbreviations."""
    whole = tuple(_coefficients(configuration))
    n = len(configuration.slots.coordinates)
    used = [r for r in configuration.rows if not r.is_identity]
    right = [sp.Add(*(r.multiplier * r.coefficients[k] for r in used)) for k in range(n)]
    taken = {name.partition("_")[0] for name in problem.scope.names()}
    definitions, short = abbreviated([*whole, *right], taken)
    return LongEquations(definitions, tuple(short[:n]), tuple(short[n:]), whole)


def _coefficients(configuration: Configuration) -> list[sp.Expr]:
    """Σ m r''·∂r/∂q_k + Σ dH/dt·ω_k − Q_k."""
    slots = configuration.slots
    turning = {r.name: r for r in configuration.rotations}
    centres = {p.name: p for p in configuration.points}
    totals = []
    for k, (q, v) in enumerate(zip(slots.coordinates, slots.velocities, strict=True)):
        terms = [p.mass * p.acceleration.dot(p.partials[k]) for p in configuration.points if p.mass != 0]
        terms += [r.momentum_rate.dot(r.partials[k]) for r in configuration.rotations if r.has_inertia]
        for load in configuration.loads:
            moved = centres[load.on].partials[k] if load.on in turning else load.point.partial(q)
            terms.append(-load.vector.dot(moved))
        terms += [-m.dot(r.partials[k]) for name, r in turning.items() for m in configuration.moments_on(name)]
        terms += [-share_of_spring(s, q) for s in configuration.springs]
        terms += [-share_of_damper(d, v, slots) for d in configuration.dampers]
        field = configuration.potential - sp.Add(*(s.energy for s in configuration.springs))
        terms.append(field.diff(q))
        terms += [-configuration.generalized[k]] if configuration.generalized else []
        totals.append(sp.Add(*terms))
    return totals


def abbreviated(
    expressions: Sequence[sp.Expr], taken: Collection[str]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr]]:
    """Names z_1, z_2, ... for what occurs several times in some expressions, and the expressions with these names.

    taken  names, up to an index, that must not be used
    """
    uses: Counter[sp.Expr] = Counter()
    stack = list(expressions)
    while stack:  # each distinct part once; a part of a part that is named is not counted again
        e = stack.pop()
        for a in e.args:
            if a.args and not a.is_number:
                uses[a] += 1
                if uses[a] == 1:
                    stack.append(a)
    definitions: dict[sp.Symbol, sp.Expr] = {}
    known: dict[sp.Expr, sp.Expr] = {}

    def written(e: sp.Expr) -> sp.Expr:
        if not e.args or e.is_number:
            return e
        if e not in known:
            inner = [written(a) for a in e.args]
            short = e.func(*inner, evaluate=False) if e.is_Add or e.is_Mul or e.is_Pow else e.func(*inner)
            if uses[e] > 1 and not (e.is_Mul and len(e.args) == 2 and e.args[0] == -1):
                name = _name(len(definitions) + 1, taken)
                definitions[name] = short
                short = name
            known[e] = short
        return known[e]

    return definitions, [written(e) for e in expressions]


def _name(number: int, taken: Collection[str]) -> sp.Symbol:
    letter = next(c for c in ("z", "Z", "zz", "ZZ", "zzz") if c not in taken)
    return sp.Symbol(f"{letter}_{number}", real=True)


def check_long_equations(equations: LongEquations, configuration: Configuration) -> list[Check]:
    """Lagrange's equations, differentiated in symbols, at random points of a prime field."""
    others = lagrange_equations(configuration).left
    surface = Surface()
    verdicts = [surface.is_zero(a - b) for a, b in zip(equations.whole, others, strict=True)]
    how = "exact, at random points: T differentiated, nothing multiplied out"
    return [Check("Lagrange's equations give the same equations of motion", all_hold(verdicts), how)]


# Long reactions


CHECK = "the reactions in terms of accelerations satisfy Lagrange's equations"


@record
class LongReactions:
    """Forces that have a name, or multipliers, that are not written down as functions of position and velocity.

    lost              those
    by_accelerations  them in terms of accelerations, by name; without those that are long even so
    hold              whether these satisfy Lagrange's equations, where there are any
    at                the state for which numbers are known; None without values
    from_initial      whether it is the state with which the motion begins
    numbers           at this state, by name
    """

    lost: tuple[Reaction, ...]
    by_accelerations: Mapping[str, sp.Expr]
    hold: bool | None
    at: StateInNumbers | None
    from_initial: bool
    numbers: Mapping[str, sp.Expr]


def long_reactions(
    law: NewtonLaw,
    configuration: Configuration,
    independent: Sequence[int],
    solved: Sequence[Reactions],
    spot: SpotValue | None,
) -> LongReactions | None:
    """The reactions that were too long in every set of coordinates; None if there are none.

    configuration  the file's own
    independent    its coordinates whose displacements are free, by index
    solved         the reactions as they were found, in each set of coordinates
    spot           a state at which the equations of motion are tried
    """
    lost = tuple(
        r for r in law.used if solved and all(r.name in s.multipliers and s.multipliers[r.name] is None for s in solved)
    )
    if not lost or law.frictions:
        return None
    by_accelerations, hold = _by_accelerations(law, configuration, lost)
    at, from_initial = _at(law.problem, configuration, independent, spot)
    numbers = {}
    if at is not None:
        values = law.problem.given_values | dict(at.state)
        for r in lost:
            if r.name in at.multipliers:
                numbers[r.name] = sp.N(at.multipliers[r.name] / r.per_force.xreplace(values))
    return LongReactions(lost, by_accelerations, hold, at, from_initial, numbers)


def check_long_reactions(reactions: LongReactions) -> list[Check]:
    """Both by Lagrange's equations."""
    checks = []
    if reactions.by_accelerations:
        checks.append(Check(CHECK, reactions.hold, "exact, at random points: T differentiated"))
    if reactions.at is not None:
        checks.append(check_state(reactions.at, "reactions"))
    return checks


def _by_accelerations(
    law: NewtonLaw, configuration: Configuration, lost: Sequence[Reaction]
) -> tuple[dict[str, sp.Expr], bool | None]:
    """The reactions, and whether they are right, from as many equations Σ λ_j a_jk = D_k, the simplest ones."""
    size, used = len(configuration.slots.coordinates), law.used
    accelerations = configuration.slots.accelerations
    rows = [[-e for e in row[size:]] for row in law.system.rows[:size]]
    balance = [
        sp.Add(*(m * a for m, a in zip(row[:size], accelerations, strict=True)), -b)
        for row, b in zip(law.system.rows[:size], law.system.right, strict=False)
    ]
    chosen: list[int] = []
    for k in sorted(
        range(size), key=lambda k: (sum(count_operations(e) for e in rows[k]), count_operations(balance[k]))
    ):
        if configuration.states.rank([rows[i] for i in (*chosen, k)]) == len(chosen) + 1:
            chosen.append(k)
        if len(chosen) == len(used):
            break
    letters = {sp.Dummy(f"D_{k}", real=True): balance[k] for k in chosen}
    solved = solved_linear([rows[k] for k in chosen], [*letters], configuration.states) or []
    values: dict[sp.Symbol, sp.Expr] = {}
    for r, value in zip(used, solved, strict=False):
        if value is not None:
            written = sp.Add(*(partial(value, d) * e for d, e in letters.items()))
            if count_operations(written) <= LONGEST_BY_ACCELERATIONS:
                values[r.multiplier] = textbook_form(written)
    projected = _projected(configuration, rows, balance, used)
    for s, (value, _) in projected.items():
        if s not in values or count_operations(value) < count_operations(values[s]):
            values[s] = value
    forces = {r.name: textbook_form(values[r.multiplier] / r.per_force) for r in lost if r.multiplier in values}
    if not forces:
        return forces, None
    left = lagrange_equations(configuration).left
    alone = [s for s, (value, _) in projected.items() if values.get(s) == value]
    verdicts = [configuration.states.is_zero(sp.Add(*map(sp.Mul, projected[s][1], left)) - values[s]) for s in alone]
    verdicts.append(_hold(configuration, chosen, used, {s: e for s, e in values.items() if s not in alone}))
    return forces, all_hold([v for v in verdicts if v is not None or len(verdicts) == 1])


def _projected(
    configuration: Configuration,
    rows: Sequence[Sequence[sp.Expr]],
    balance: Sequence[sp.Expr],
    used: Sequence[Reaction],
) -> dict[sp.Symbol, tuple[sp.Expr, list[sp.Expr]]]:
    """λ_i = Σ_k w_k D_k with w = a_i/|a_i|², where a_i is normal to the coefficients of every other reaction; and w."""
    is_zero = configuration.states.is_zero
    columns = [list(c) for c in zip(*rows, strict=True)]
    projected = {}
    for n, (r, column) in enumerate(zip(used, columns, strict=True)):
        others = [sp.Add(*map(sp.Mul, column, c)) for m, c in enumerate(columns) if m != n]
        if any(is_zero(product) is not True for product in others):
            continue
        square = textbook_form(sp.Add(*(a**2 for a in column)))
        if is_zero(square) is not False:
            continue
        weights = [a / square for a in column]
        value = textbook_form(sp.Add(*map(sp.Mul, weights, balance)))
        if count_operations(value) <= LONGEST_BY_ACCELERATIONS:
            projected[r.multiplier] = value, weights
    return projected


def _hold(
    configuration: Configuration,
    chosen: Sequence[int],
    used: Sequence[Reaction],
    values: Mapping[sp.Symbol, sp.Expr],
) -> bool | None:
    """Whether Lagrange's equations L_k = Σ λ a_k, with the derivatives of T, hold where all λ in them are known."""
    left = lagrange_equations(configuration).left
    verdicts = []
    for k in chosen:
        shares = [
            (r.multiplier, a) for r in used if (a := without_root(r.row, configuration.slots).coefficients[k]) != 0
        ]
        if all(s in values for s, _ in shares):
            forces = sp.Add(*(values[s] * a for s, a in shares))
            verdicts.append(configuration.states.is_zero(left[k] - forces))
    return all_hold(verdicts) if verdicts else None


def _at(
    problem: Problem, configuration: Configuration, independent: Sequence[int], spot: SpotValue | None
) -> tuple[StateInNumbers | None, bool]:
    """The numbers at the state with which the motion begins, or at the one that equations of motion are tried at."""
    if not has_numbers(problem):
        return None, False
    start = start_in_numbers(problem, configuration)
    if start is not None:
        return start, True
    if spot is None or t in spot.values:
        return None, False
    parameters = problem.given_values
    try:
        slots = configuration.slots
        free = [slots.coordinates[k] for k in independent]
        rates = [slots.velocities[k] for k in independent]
        stated = {s: spot.values[s] for s in (*free, *rates) if s in spot.values}
        near = {s: e for s, e in spot.values.items() if s in slots.coordinates}
        return at_state(configuration, reference(configuration, stated, parameters, near)), False
    except NOT_POSSIBLE:
        return None, False
