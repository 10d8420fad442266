"""Statics: the principle of virtual work.

A system with ideal constraints is in equilibrium where the virtual work of the applied forces vanishes for every
virtual displacement,

    δW = Σ F·δr − δV = Σ Q_k δq_k = 0 .

If the δq_k are independent, each Q_k vanishes; if constraints bind them, A δq = 0 is substituted first:
Q_k + Σ_d B_dk Q_d = 0, together with the constraints. These conditions are solved in closed form as far as possible.
Where a pivot would be divided by, multipliers stand in for the reactions, Q + Aᵀ λ = 0, so that no position is lost.
Unknown forces are solved for first: as many of them as there are conditions are found for every position.

A force need not have a value everywhere: a spring of length 0 pulls in no direction, a potential may have a pole. Such
a position is no equilibrium, although it may satisfy a condition multiplied by its denominator; it is named.

Reference: Lagrange 1788, part 1; Lanczos, The Variational Principles of Mechanics, ch. 3.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from dataclasses import replace
from functools import cached_property
from itertools import chain

import sympy as sp

from lagrange.algebra.closed_forms.branching import solutions
from lagrange.algebra.closed_forms.polynomial_roots import without_squares
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet, is_part
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError, is_outside_circular
from lagrange.algebra.exact.zero_test import DivisionByZeroError, Point, Surface, agreed, is_zero, rank
from lagrange.algebra.fourier.ring import Element, FourierRing
from lagrange.algebra.fourier.terms import CommonFactor, common_factor, normalised
from lagrange.algebra.fourier.textbook_form import Textbook
from lagrange.core.records import all_hold, record
from lagrange.core.symbols import never_vanishes, variation
from lagrange.mechanics.constraints.constrained_system import Row
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import of_independent
from lagrange.mechanics.dynamics.principle import generalized_forces
from lagrange.mechanics.equilibrium.admissible_positions import (
    idle_coordinates,
    is_at_edge,
    is_only_of_chart,
    moves_nothing,
    place_as_drawn,
    symmetric_places,
    within,
    within_bounds,
)
from lagrange.mechanics.equilibrium.loads import at_rest, load_parameters, solved_for


@record
class VirtualWork:
    """δW in the coordinates of a configuration.

    coefficients  shape (n,): Q_k, as ring elements
    forces        shape (n,): Q_k, in textbook form
    statement     Σ Q_k δq_k, in textbook form
    """

    coefficients: tuple[Element, ...]
    forces: tuple[sp.Expr, ...]
    statement: sp.Expr
    textbook: Textbook

    @property
    def ring(self) -> FourierRing:
        """The ring of the coefficients."""
        return self.textbook.ring


@record
class ConditionOfEquilibrium:
    """expression = 0, the coefficient of the virtual displacement of `coordinate`.

    factor    the factor divided out; it cannot vanish
    below     the denominator multiplied by; solutions are sought where it vanishes as well
    reversed  whether the sign has been changed as well
    """

    coordinate: sp.Symbol
    expression: sp.Expr
    factor: CommonFactor
    below: CommonFactor
    reversed: bool


@record
class SingularPlace:
    """Positions at which a force is undefined; `springs` are those whose length is 0 there."""

    branch: Branch
    springs: tuple[str, ...]


@record
class Equilibrium:
    """The equilibria of one configuration.

    independent_forces  the coefficient of each independent δq after substituting the dependent ones: Q_k + Σ B_dk Q_d
    reduced      Σ over the independent δq, after substituting the dependent ones
    conditions   each is zero; the finite constraints complete them
    forces       the unknown forces that occur
    given        whether the position is arbitrary, because only the forces are determined
    solution     all solutions
    branches     those of the solution, without multipliers as far as possible
    multipliers  the unknowns λ in Q + Aᵀ λ = 0, one for each binding constraint
    singular     where the conditions multiplied by their denominators hold, but a force has no value
    idle         for each branch the coordinates on which the position does not depend there (`idle_coordinates`)
    poles        such branches of a choice at which the forces do not balance in the file's coordinates, omitted above
    outside      branches that lie outside of the ranges of the coordinates, omitted above
    slack        branches among them at which a contact would have to pull, or a string to push (`static_reactions`)
    pulls        for each branch the forces of the springs there, by name (`with_spring_forces`)
    laws         further conditions on the unknown forces, each zero, that are no virtual work: friction at its limit
    all_found    whether the places of rest that a search in numbers finds are in the list (`searched`); None: not tried
    """

    configuration: Configuration
    work: VirtualWork
    elimination: Elimination
    independent_forces: tuple[sp.Expr, ...]
    reduced: sp.Expr
    conditions: tuple[ConditionOfEquilibrium, ...]
    forces: tuple[sp.Symbol, ...]
    given: bool
    solution: SolutionSet
    branches: tuple[Branch, ...]
    multipliers: tuple[sp.Symbol, ...] = ()
    singular: tuple[SingularPlace, ...] = ()
    idle: tuple[tuple[sp.Symbol, ...], ...] = ()
    poles: tuple[Branch, ...] = ()
    outside: tuple[Branch, ...] = ()
    slack: tuple[Branch, ...] = ()
    pulls: tuple[Mapping[str, sp.Expr], ...] = ()
    laws: tuple[sp.Expr, ...] = ()
    all_found: bool | None = None

    @property
    def required(self) -> tuple[sp.Expr, ...]:
        """Expressions that are zero: the conditions and the laws."""
        return (*(c.expression for c in self.conditions), *self.laws)

    @property
    def expressions(self) -> tuple[sp.Expr, ...]:
        """Expressions that are zero: the conditions, the laws and the finite constraints."""
        return (*self.required, *self.configuration.finite_constraints)

    @property
    def binding(self) -> tuple[Row, ...]:
        """The constraints that are not identities."""
        return tuple(r for r in self.configuration.rows if not r.is_identity)

    def balance(self, multipliers: Sequence[sp.Symbol]) -> tuple[sp.Expr, ...]:
        """Q + Aᵀ λ, shape (n,), one λ for each binding constraint."""
        pairs = tuple(zip(multipliers, self.binding, strict=True))
        return tuple(sp.Add(q, *(m * row.coefficients[k] for m, row in pairs)) for k, q in enumerate(self.work.forces))

    @cached_property
    def needs_multipliers(self) -> bool:
        """Whether the conditions are better stated with multipliers.

        Dividing by pivots may lose equilibria: a pivot vanishes at one, or no equilibrium was found. Or multipliers
        remain in what could not be solved.
        """
        pivots = self.elimination.pivots
        if any(s in self.multipliers for b in self.branches for r in b.equations for s in r.residual.free_symbols):
            return True
        if not self.multipliers or not pivots or not self.elimination.independent:
            return False
        points = [p for b in self.branches for p in b.points]
        if not points:
            coordinates = set(self.configuration.slots.coordinates)
            return any(p.free_symbols & coordinates for p in pivots)
        return any(self._value_is_zero(pivot, at) is not False for pivot in pivots for at in points)

    def _value_is_zero(self, e: sp.Expr, at: Values) -> bool | None:
        """Whether an expression is zero at a point of a branch; None: undecided, or it has no value there."""
        try:
            return is_zero(self.solution.at(at, e))
        except (NotAlgebraicError, DivisionByZeroError):
            return None

    @property
    def exists(self) -> bool | None:
        """Whether there is an equilibrium in these coordinates; None if unknown."""
        if self.solution.solved:
            return bool(self.branches)
        return True if any(not b.left or b.occupied for b in self.branches) else None

    @property
    def dead_centres(self) -> tuple[int, ...]:
        """The numbers of the branches at which the only coordinate moves nothing to first order."""
        held = (moves_nothing(self.configuration, self.solution, b) for b in self.branches)
        return tuple(n for n, holds in enumerate(held) if holds)

    def turned(self, b: Branch) -> tuple[sp.Symbol, ...]:
        """The angles of a branch at whose full turns the forces balance too, but are others."""
        given = [q for q in self.configuration.slots.coordinates if q in b.common and any(q not in p for p in b.points)]
        return tuple(
            q for q in given if is_outside_circular(q, (*self.work.forces, *self.configuration.finite_constraints))
        )

    @property
    def undetermined(self) -> tuple[sp.Symbol, ...]:
        """The unknown forces of which only combinations are determined."""
        used = {s for b in self.branches for r in b.relations for s in r.rhs.free_symbols}
        return tuple(f for f in self.forces if f in used) if self.given else ()

    @property
    def presupposed(self) -> tuple[sp.Expr, ...]:
        """What must not vanish at a given position for the forces to be determined there.

        Factors of conditions, and what the forces have as divisors: x and sin θ at the dead centres of a crank.
        """
        if not self.given or self.needs_multipliers:
            return ()
        coordinates = set(self.configuration.slots.coordinates)
        factors = [f for c in self.conditions for f in common_factor(c.expression).nonzero]
        below = (sp.fraction(r.rhs)[1] for b in self.branches for r in b.relations if r.lhs in self.forces)
        factors += [f.as_base_exp()[0] for d in below for f in sp.Mul.make_args(d) if sign_of(f) is None]
        return tuple(dict.fromkeys(f for f in factors if f.free_symbols & coordinates and f not in self.forces))


def is_balanced(e: Equilibrium, at: Callable[[sp.Expr], sp.Expr]) -> bool | None:
    """Whether there is equilibrium at a point; `at` gives the value of an expression there. None: undecided.

    With constraints the generalized forces must be a combination of their rows, Q = −Aᵀ λ, without a division.
    Finite constraints must hold. Raises the errors of `at`.
    """
    rows = e.binding
    verdicts: list[bool | None] = [is_zero(at(f)) for f in (*e.configuration.finite_constraints, *e.laws)]
    if not rows:
        verdicts += [is_zero(at(c.expression)) for c in e.conditions]
    else:
        matrix = [[at(a) for a in row.coefficients] for row in rows]
        ranks = rank(matrix), rank([*matrix, [at(q) for q in e.work.forces]])
        verdicts.append(None if None in ranks else ranks[0] == ranks[1])
    return all_hold(verdicts)


def is_balanced_on(e: Equilibrium, surface: Surface, values: Mapping[sp.Symbol, sp.Expr]) -> bool | None:
    """Whether there is equilibrium at all points of a surface, symbols having some values; None: undecided.

    The conditions of equilibrium presuppose that the constraints can be solved for the dependent displacements. Where
    they cannot, as in a linkage stretched out, forces may balance that do not satisfy the conditions.
    """
    verdict = all_hold([surface.is_zero(c.xreplace(dict(values))) for c in e.required])
    if verdict is not False or e.given or not e.binding:
        return verdict
    rows = [[a.xreplace(dict(values)) for a in row.coefficients] for row in e.binding]
    forces = [q.xreplace(dict(values)) for q in e.work.forces]

    def balanced(point: Point) -> bool:
        bound = point.matrix(rows)
        return point.rank(bound) == point.rank([*bound, point.values(forces)])

    laws = [surface.is_zero(law.xreplace(dict(values))) for law in e.laws]
    return all_hold([*laws, agreed(surface, balanced, [*chain(*rows), *forces], lambda result: not result)])


def without_poles(e: Equilibrium, original: Equilibrium) -> Equilibrium:
    """The equilibria of a choice without the poles of its chart where the forces do not balance.

    At θ = 0 of a sphere Q_θ = Q_φ = 0 may hold for φ = π/2 only, which is the same position as any other φ; and with
    x = a cos θ nothing moves at θ = 0. The file's coordinates, in `original`, have no pole there and decide.
    """
    return _split_off(
        e,
        [
            not b.left
            and (bool(idle) or is_at_edge(e.configuration, original.configuration.slots.coordinates, e.solution, b))
            and _is_unbalanced(b, e, original)
            for b, idle in zip(e.branches, e.idle, strict=False)
        ],
    )


def _split_off(e: Equilibrium, at_poles: Sequence[bool]) -> Equilibrium:
    """The equilibria with some branches among the poles."""
    if not any(at_poles):
        return e
    kept = [(b, idle) for b, idle, pole in zip(e.branches, e.idle, at_poles, strict=True) if not pole]
    poles = (*e.poles, *(b for b, pole in zip(e.branches, at_poles, strict=True) if pole))
    return replace(e, branches=tuple(b for b, _ in kept), idle=tuple(idle for _, idle in kept), poles=poles)


def _is_unbalanced(b: Branch, e: Equilibrium, original: Equilibrium) -> bool:
    """Whether the forces do not balance in the file's coordinates at any point of a branch."""
    return bool(b.points) and all(balance_in(original, e, p) is False for p in b.points)


def balance_in(original: Equilibrium, e: Equilibrium, point: Values) -> bool | None:
    """Whether the forces balance in the file's coordinates at a point of a choice; None: undecided."""
    try:
        return is_balanced(original, lambda x: e.solution.at(point, e.configuration.rewritten(x)))
    except (NotAlgebraicError, DivisionByZeroError):
        return None


def virtual_work(configuration: Configuration) -> VirtualWork:
    """δW of the applied forces."""
    ring = FourierRing()
    textbook = Textbook(ring)
    coefficients = generalized_forces(configuration, ring)
    displacements = [ring.from_sympy(variation(q)) for q in configuration.slots.coordinates]
    statement = ring.total(q * v for q, v in zip(coefficients, displacements, strict=True))
    return VirtualWork(coefficients, tuple(textbook.form(q) for q in coefficients), textbook.form(statement), textbook)


def equilibrium(
    configuration: Configuration,
    elimination: Elimination,
    unknown_forces: tuple[sp.Symbol, ...] = (),
    work: VirtualWork | None = None,
    laws: Sequence[sp.Expr] = (),
    place: Mapping[sp.Symbol, sp.Expr] | None = None,
) -> Equilibrium:
    """The equilibria of a configuration, in closed form as far as possible.

    unknown_forces  the symbols to be found in addition to the coordinates
    work            of the forces at rest, if that is not the work of the applied forces
    laws            further conditions on the unknown forces, each zero
    place           a position that the constraints hold: only there
    """
    if work is None:
        configuration = at_rest(configuration)
        work = virtual_work(configuration)
    coordinates = configuration.slots.coordinates
    forces_on_independent = of_independent(work.coefficients, work.ring, elimination)
    displacements = [work.ring.from_sympy(variation(coordinates[k])) for k in elimination.independent]
    virtual = work.ring.total(q * v for q, v in zip(forces_on_independent, displacements, strict=True))
    reduced = work.textbook.form(virtual)
    conditions = tuple(
        condition
        for k, q in zip(elimination.independent, forces_on_independent, strict=True)
        if (condition := _condition(work, coordinates[k], q)).expression != 0
    )
    used = {s for expression in (*(c.expression for c in conditions), *laws) for s in expression.free_symbols}
    forces = tuple(f for f in unknown_forces if f in used)
    blank = Equilibrium(
        configuration,
        work,
        elimination,
        tuple(map(work.textbook.form, forces_on_independent)),
        reduced,
        conditions,
        forces,
        False,
        solutions((), ()),
        (),
        laws=tuple(laws),
    )
    return _for_forces(blank) or _for_all(blank, place or {})


def _condition(work: VirtualWork, coordinate: sp.Symbol, force: Element) -> ConditionOfEquilibrium:
    """The condition without common denominators and without common factors that cannot vanish."""
    expression = work.textbook.form(force)
    common = common_factor(expression)
    factor = common.only(never_vanishes)
    below = CommonFactor(sp.S.One, common.denominator.only(lambda f: not never_vanishes(f)).powers)
    kept = below.multiply(factor.divide(expression))
    if below.powers:
        kept = work.textbook.form(kept)
        kept = common_factor(kept).only(never_vanishes).divide(kept)
    leading = normalised(kept)
    return ConditionOfEquilibrium(coordinate, leading, factor, below, leading != kept)


def _for_forces(e: Equilibrium) -> Equilibrium | None:
    """The equilibrium with the unknown forces as functions of any position; None if they cannot be found so."""
    if not e.forces or len(e.forces) < len(e.required):
        return None
    solution = solutions(e.required, e.forces)
    generic = tuple(b for b in solution.branches if not b.special)
    if not generic or not solution.solved:
        return None
    return replace(e, given=True, solution=replace(solution, branches=generic), branches=generic)


def at_position(e: Equilibrium, position: Mapping[sp.Symbol, sp.Expr]) -> Equilibrium:
    """The equilibrium with the unknown forces as functions of any position, at the one that the constraints hold."""
    at = [replace(c, expression=normalised(c.expression.xreplace(dict(position)))) for c in e.conditions]
    laws = tuple(law.xreplace(dict(position)) for law in e.laws)
    held = _for_forces(replace(e, conditions=tuple(c for c in at if c.expression != 0), laws=laws))
    return e if held is None else held


def _for_all(e: Equilibrium, place: Mapping[sp.Symbol, sp.Expr]) -> Equilibrium:
    """The equilibrium with all positions, or at one that the constraints hold, and the forces belonging to them."""
    multipliers = tuple(row.multiplier for row in e.binding)
    position = [q - v for q, v in place.items()] or e.configuration.finite_constraints
    forces = (*e.balance(multipliers), *e.laws) if multipliers else e.required
    equations = [*(f.xreplace(dict(place)) for f in forces), *(position if multipliers else ())]
    coordinates = e.configuration.slots.coordinates
    unknowns = (*coordinates, *e.forces, *multipliers)

    def solved(*more: sp.Expr) -> SolutionSet:
        return solutions([*equations, *more], unknowns, (*multipliers, *e.forces), origin=e.work.forces)

    solution = solved()
    if not solution.solved and (held := _held(e)) is not None:
        solution, multipliers = held, ()
    branches, divisors = _without(solution.branches, multipliers)
    for divisor in divisors:
        beside, _ = _without(solved(divisor).branches, multipliers)
        branches += tuple(b for b in beside if not b.special and not any(is_part(b, o, solution) for o in branches))
    if not solution.solved:
        verdicts = [solution.verified] if any(not b.left for b in branches) else []
        drawn = [*place_as_drawn(e.configuration)]
        # with the multipliers put in: the tensions of two strings that are equal make a position symmetric
        left = [r.residual for b in branches if b.left for r in b.equations]
        for assumed in (*symmetric_places([*equations, *left], coordinates), *drawn):
            there = solved(*assumed)
            beside, _ = _without(there.branches, multipliers)
            stated = {b.relations for b in branches}
            # Of a drawing that fits particular parameters only, strings of equal length, nothing is known in general.
            fitting = [b for b in beside if not (b.special and assumed in drawn)]
            closed = (b for b in fitting if not b.left and b.relations not in stated)
            more = [b for b in closed if not any(is_part(b, o, solution) for o in branches)]
            branches = (*more, *branches)
            verdicts += [there.verified] if more else []
        solution = replace(solution, verified=all_hold(verdicts) if verdicts else solution.verified)
    excluded, _ = _without(solution.excluded, multipliers)
    ranges = e.configuration.ranges
    restricted = [within(b, ranges, solution) for b in branches] if ranges else branches
    bounded = e.configuration.bounded
    restricted = [b if b is None else within_bounds(b, bounded, solution) for b in restricted]
    outside = tuple(b for b, inside in zip(branches, restricted, strict=True) if inside is None)
    branches = tuple(b for b in restricted if b is not None)
    singular = tuple(
        SingularPlace(b, _without_length(b, solution, e.configuration)) for b in _consistent(excluded, solution)
    )
    applied = load_parameters(e.configuration)
    branches = tuple(replace(b, conditions=solved_for(b.conditions, applied)) for b in branches)
    branches = _merged((_with_stated_angles(b, solution) for b in branches), {*solution.letters.angles})
    idle = tuple(idle_coordinates(e.configuration, solution, b) for b in branches)
    completed = replace(e, solution=solution, branches=branches, multipliers=multipliers, singular=singular, idle=idle)
    free = (coordinates[k] for k in e.elimination.independent)
    balances = dict(zip(free, e.independent_forces, strict=True))
    return _split_off(
        replace(completed, outside=outside),
        [is_only_of_chart(balances, solution, b, i) for b, i in zip(branches, idle, strict=True)],
    )


def _held(e: Equilibrium) -> SolutionSet | None:
    """The positions that the constraints alone determine, where they are independent: any forces balance there.

    Where two such positions meet, for particular parameters, the constraints are dependent: conditions are strict.
    None if they are not found, or dependent.
    """
    finite, coordinates = e.configuration.finite_constraints, e.configuration.slots.coordinates
    if e.forces or e.laws or e.elimination.independent or not len(finite) == len(coordinates) == len(e.binding):
        return None
    solution = solutions(finite, coordinates)
    at = replace(e, solution=solution)
    points = [p for b in solution.branches for p in b.points]
    is_open = not solution.solved or any(b.left or b.special for b in solution.branches)
    if is_open or any(at._value_is_zero(pivot, p) is not False for pivot in e.elimination.pivots for p in points):
        return None
    strict = {"≥": ">", "≤": "<"}
    conditions = (
        [replace(c, relation=strict.get(c.relation, c.relation)) for c in b.conditions] for b in solution.branches
    )
    return replace(
        solution,
        branches=tuple(
            replace(b, conditions=tuple(dict.fromkeys(cs))) for b, cs in zip(solution.branches, conditions, strict=True)
        ),
    )


def _consistent(branches: Sequence[Branch], solution: SolutionSet) -> list[Branch]:
    """The branches whose relations are consistent, each once: not x = 0 together with x = a."""

    def fails(p: Values, e: sp.Expr) -> bool:
        try:
            value = solution.at(p, e)
        except (NotAlgebraicError, DivisionByZeroError):
            return False
        return not value.free_symbols & {*solution.unknowns} and is_zero(value) is False

    kept: list[Branch] = []
    for b in branches:
        contradictory = not b.left and any(fails(p, r.residual) for p in b.points for r in b.relations)
        if not contradictory and not any(is_part(b, o, solution) for o in kept):
            kept.append(b)
    return kept


def _with_stated_angles(b: Branch, solution: SolutionSet) -> Branch:
    """The branch with the angles that it states: where θ occurs beside sin θ, R θ + l at sin θ = 0 is l at θ = 0.

    At its points so are other unknowns that it gives by the angle: x = R θ, which also holds full turns further, is
    x = 0 at θ = 0. A root that is none any more is a modulus: |H − l| where cos θ = −1.
    """
    angles = {r.lhs: r.rhs for r in b.relations if r.lhs in solution.letters.angles}
    common, *points = (
        {u: without_squares(v.xreplace(angles)) for u, v in values.items()} for values in (b.common, *b.points)
    )
    return replace(b, common={**angles, **common}, points=tuple(points))


def _merged(branches: Iterable[Branch], angles: Set[sp.Symbol]) -> tuple[Branch, ...]:
    """The branches without those contained in another one: x = 0 in x = R θ, both at θ = 0."""
    kept: dict[object, Branch] = {}
    for n, b in enumerate(branches):
        points = frozenset(frozenset((u, v) for u, v in p.items() if u not in angles) for p in b.points)
        stated = frozenset((u, v) for u, v in b.common.items() if u in angles)
        key = (points, stated, frozenset(b.conditions), b.left) if stated and not b.special else n
        known = kept.get(key)
        if known is None or _letters_of(b) > _letters_of(known):
            kept[key] = b
    return tuple(kept.values())


def _letters_of(b: Branch) -> int:
    """How many letters the unknowns are given by."""
    return sum(len(r.rhs.free_symbols) for r in b.relations)


def _without_length(b: Branch, solution: SolutionSet, configuration: Configuration) -> tuple[str, ...]:
    """The springs that have the length 0 in all positions of a branch."""

    def vanishes(length: sp.Expr, at: Values) -> bool:
        try:
            return bool(is_zero(solution.at(at, length)))
        except (NotAlgebraicError, DivisionByZeroError):
            return False

    return tuple(s.name for s in configuration.springs if all(vanishes(s.distance, p) for p in b.points))


def _without(
    branches: tuple[Branch, ...], multipliers: Sequence[sp.Symbol]
) -> tuple[tuple[Branch, ...], tuple[sp.Expr, ...]]:
    """The branches without their relations for multipliers, and the divisors with unknowns that this takes.

    Branches that become equal are merged.
    """
    merged: dict[object, Branch] = {}
    divisors: dict[sp.Expr, None] = {}
    for b in branches:
        turned, divided = _turned(b, multipliers)
        divisors |= dict.fromkeys(divided)
        values = {r.lhs: r.rhs for r in turned.relations if r.lhs in multipliers}
        relations = tuple(r for r in turned.relations if r.lhs not in multipliers)
        left = tuple(_with_multipliers_put_in(e, values) for e in turned.left)
        key = (relations, turned.conditions, left)
        known = merged.get(key)
        points = (*(known.points if known else ()), *turned.points)
        merged[key] = replace(turned, relations=relations, left=left, points=points)
    return tuple(merged.values()), tuple(divisors)


def _with_multipliers_put_in(e: sp.Expr, values: Values) -> sp.Expr:
    """An unsolved equation with the multipliers for which relations are omitted: without these it would say less."""
    for _ in values:  # a value may contain other multipliers
        if not e.free_symbols & values.keys():
            break
        e = sp.expand(e.xreplace(dict(values)))
    return e


def _turned(b: Branch, multipliers: Sequence[sp.Symbol]) -> tuple[Branch, list[sp.Expr]]:
    """The branch with a relation y = c λ, a coordinate by a free multiplier, turned into λ = y/c with free y.

    The second result is c, where that may vanish: such positions are in another branch.
    """
    divisors = []
    for m in multipliers:
        for r in b.relations:
            rate = sp.expand(r.rhs).diff(m)
            if r.lhs in multipliers or not r.lhs.is_Symbol or rate == 0 or m in rate.free_symbols or b.left:
                continue
            divisors += [sp.fraction(sp.together(rate))[0]] if rate.free_symbols else []
            rule = {m: sp.cancel((r.lhs - r.rhs.xreplace({m: sp.S.Zero})) / rate)}
            relations = tuple(
                replace(o, rhs=sp.factor(o.rhs.xreplace(rule)) if m in o.rhs.free_symbols else o.rhs)
                for o in b.relations
                if o is not r
            )
            points = tuple(_given_by(p, r.lhs, rule) for p in b.points)
            b = replace(b, relations=relations, points=points, common=_given_by(b.common, r.lhs, rule))
            break
    return b, divisors


def _given_by(values: Values, free: sp.Symbol, rule: dict[sp.Symbol, sp.Expr]) -> Values:
    """The values of letters with a multiplier expressed by a coordinate, which becomes free."""
    return {u: v.xreplace(rule) for u, v in values.items() if u != free} | rule
