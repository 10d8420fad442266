"""Reactions at rest: the multipliers at each equilibrium.

With multipliers for the reactions of the file's constraints, n equations in its n coordinates balance the applied
forces (λ with a plus sign, as in `newton.py`),

    Q_k + Σ_j λ_j a_jk = 0 ,

in general more equations than multipliers: they are consistent only at an equilibrium. So the branch of equilibria (and
of unknown forces) is substituted first, exactly, as far as its points share it: with tan θ = a there, cos θ remains in
λ. The result is linear in λ and solved by elimination; a pivot must vanish at no point of the branch. Where constraints
are redundant, or become dependent at that position, only combinations of multipliers are determined.

Shapes: a (m, n), Q (n,), λ (m,). Reference: Lagrange 1788, part 1, section IV.

The forces of springs at the equilibria: k (d − l) at every point of a branch, positive where the spring pulls.

A branch such as cos θ = a is a set of points. The force is stated where it is the same at all of them, which is decided
exactly; otherwise the branch says too little.

A contact can only push, and a string can only pull. Where the sign of such a force is not known, the branch has the
condition that it is not negative, N = m g tan θ ≥ 0 where sin θ ≥ 0: its other points are no equilibria.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.closed_forms.limits import LARGEST_FACTORED
from lagrange.algebra.closed_forms.polynomial_roots import without_squares
from lagrange.algebra.closed_forms.shortest_form import in_sines, shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, not_negative, sign_of
from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import (
    Branch,
    SolutionSet,
    by_stated_roots,
    known_positive,
    parameters_given,
    resolved,
)
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import Surface, is_zero
from lagrange.algebra.fourier.linear_systems import tidy_quotient
from lagrange.core.expression_size import count_operations
from lagrange.core.records import all_hold, record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.constraints.springs_dampers import StretchedSpring
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reaction_signs import is_called_string
from lagrange.mechanics.dynamics.reactions import (
    Reactions,
    ReactionSystem,
    SolutionPlace,
    over_one_denominator,
    reactions_at,
)
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import MOST_BRANCH_POINTS
from lagrange.problem.keys import Keeper

if TYPE_CHECKING:
    from lagrange.mechanics.dynamics.motion import NewtonLaw
    from lagrange.values.quantities import Values as ValuesGiven


@record
class Points:
    """The points of one branch of equilibria.

    values  of the letters at each point
    given   a parameter, if the branch exists for particular values only
    around  the surface of the coordinates that the branch leaves open
    alone   the constraints leave isolated positions, not found in closed form: `around` may miss some of them, and only
            an identity is certain to be zero at all
    """

    solution: SolutionSet
    values: tuple[Values, ...]
    given: Mapping[sp.Symbol, sp.Expr]
    around: Surface
    alone: bool = False

    def at(self, point: Values, e: sp.Expr) -> sp.Expr:
        """An expression at one of the points. Raises NotAlgebraicError, DivisionByZeroError."""
        value = self.solution.at(point, e.xreplace(dict(self.given)))
        if value.has(sp.zoo, sp.nan, sp.oo):
            raise DivisionByZeroError(e)
        return value

    def verdicts(self, e: sp.Expr, numbers: Mapping[sp.Symbol, sp.Expr] | None = None) -> Iterator[bool | None]:
        """Whether an expression is zero, point by point, for given parameters. Raises DivisionByZeroError."""
        for point in self.values:
            try:
                value = self.at(point, e).xreplace(dict(numbers or {}))
                zero = self.around.is_zero(value)
                yield None if zero and self.alone and not is_zero(value) else zero
            except NotAlgebraicError:
                yield None

    def sign(self, point: Values, e: sp.Expr, numbers: Mapping[sp.Symbol, sp.Expr]) -> int | None:
        """The sign of an expression at one of the points, for given parameters; None if it is not known."""
        try:
            return sign_of(self.at(point, e).xreplace(dict(numbers)))
        except (NotAlgebraicError, DivisionByZeroError):
            return None

    def values_at(self, expressions: Sequence[sp.Expr]) -> Iterator[list[sp.Expr]]:
        """Several expressions at each of the points. Raises NotAlgebraicError, DivisionByZeroError."""
        for point in self.values:
            yield [self.at(point, e) for e in expressions]

    def is_zero(self, expression: sp.Expr) -> bool | None:
        """Whether an expression is zero at all points, or at none; None: neither, or undecided."""
        try:
            verdicts = {*self.verdicts(expression)}
        except DivisionByZeroError:
            return None
        return verdicts.pop() if len(verdicts) == 1 else None

    def holds(self, expression: sp.Expr, numbers: Mapping[sp.Symbol, sp.Expr] | None = None) -> bool | None:
        """Whether an expression is zero at every point, for given parameters. Raises DivisionByZeroError."""
        verdicts = [*self.verdicts(expression, numbers)]
        return all_hold(verdicts) if verdicts else None


@record
class ReactionsAtRest:
    """The reactions at one branch of equilibria.

    open      multipliers that the position does not determine, because the constraints are dependent there
    verified  whether they balance the forces at every point
    contact   by name of the constraint, the condition under which a contact pushes or a string pulls, if it may not
    """

    points: Points
    reactions: Reactions
    open: tuple[sp.Symbol, ...]
    verified: bool | None
    contact: Mapping[str, SignCondition] = field(default_factory=dict)

    def with_contact(self, kept: Callable[[SignCondition], bool]) -> ReactionsAtRest:
        """These with some of the conditions of contact."""
        return replace(self, contact={name: c for name, c in self.contact.items() if kept(c)})

    @property
    def rule(self) -> dict[sp.Symbol, sp.Expr]:
        """The values of the multipliers; in a combination, that of the first in terms of the others."""
        values = {s: v for s, v in self.reactions.values.items() if s not in self.open}
        for c in self.reactions.combinations:
            (_, first), *rest = c.terms
            if c.value is not None:
                values[first] = sp.Add(c.value, *(-share * other for share, other in rest))
        return values


@record
class StaticReactions:
    """The reactions at the equilibria of one configuration; `at` has one for each branch; None: not found there."""

    equilibrium: Equilibrium
    at: tuple[ReactionsAtRest | None, ...]

    @property
    def configuration(self) -> Configuration:
        """The coordinates that they are written in."""
        return self.equilibrium.configuration


def would_act_backwards(
    there: ReactionsAtRest | None, newton: Newton, values: Mapping[sp.Symbol, sp.Expr] | None = None
) -> list[Reaction]:
    """The one-sided constraints that would have to pull, and the strings that would have to push: no equilibrium.

    values  those of the parameters, as far as they are given
    """
    forces = {} if there is None else _one_sided(there.reactions, newton)
    signs = {name: sign_of(force.xreplace(dict(values or {}))) for name, force in forces.items()}
    return [r for r in newton.reactions if signs.get(r.name) == -1]


def _one_sided(found: Reactions, newton: Newton) -> dict[str, sp.Expr]:
    """The forces that cannot be negative, by name of the constraint: of contacts, and the tensions of strings."""
    strings = {r.name for r in newton.reactions if is_string(r)} & found.tensions.keys()
    return {name: found.tensions[name] for name in strings} | dict(found.contacts)


def is_one_sided(r: Reaction) -> bool:
    """Whether a named force cannot be negative: of a contact, or the tension of a string."""
    return r.named and (r.constraint.side is not None or (is_string(r) and r.tension is not None))


def is_string(r: Reaction) -> bool:
    """Whether a string keeps the constraint, by its `by` or, without one, by its name."""
    by = r.constraint.by
    return by is Keeper.STRING or (by is None and is_called_string(r.name))


def possible(
    at: Sequence[ReactionsAtRest | None], newton: Newton, values: Mapping[sp.Symbol, sp.Expr] | None = None
) -> list[int]:
    """The branches, by index, at which no reaction would act backwards; all of them where none is left."""
    kept = [n for n, there in enumerate(at) if not would_act_backwards(there, newton, values)]
    return kept or [*range(len(at))]


def in_contact(
    e: Equilibrium, static: StaticReactions | None, law: NewtonLaw | None, values: ValuesGiven | None
) -> Equilibrium:
    """The equilibria with the conditions under which contacts push and strings pull, and those at which one would not.

    `slack` is none where these are all; of a branch with other points as well, it has the points that are slack.
    """
    if static is None or law is None or not static.at:
        return e
    numbers = values.numbers if values is not None else {}
    kept = possible(static.at, law.newton, numbers)
    slack, branches = [], []
    for n, (b, there) in enumerate(zip(e.branches, static.at, strict=True)):
        impossible = would_act_backwards(there, law.newton, numbers)
        conditions = {} if there is None or impossible else there.contact  # from a false one everything would follow
        branches.append(replace(b, implied=(*b.implied, *conditions.values())) if conditions else b)
        if n not in kept:
            slack.append(b)
        elif there is not None and conditions:
            forces = _one_sided(there.reactions, law.newton).values()
            points = tuple(p for p in b.points if any(there.points.sign(p, f, numbers) == -1 for f in forces))
            slack += [replace(b, points=points)] if 0 < len(points) < len(b.points) else []
    return replace(e, branches=tuple(branches), slack=tuple(slack))


def static_reactions(
    resting: Equilibrium, original: Equilibrium, newton: Newton, used: Sequence[Reaction]
) -> StaticReactions:
    """The reactions at every equilibrium of a configuration.

    original  the equilibrium in the file's coordinates
    used      the reactions of independent constraints
    """
    return StaticReactions(resting, tuple(_at(b, resting, original, newton, used) for b in resting.branches))


def _at(
    b: Branch, resting: Equilibrium, original: Equilibrium, newton: Newton, used: Sequence[Reaction]
) -> ReactionsAtRest | None:
    """The reactions at one branch; None if they cannot be written in closed form, or not be verified."""
    if len(b.points) > MOST_BRANCH_POINTS or not b.points:
        return None
    points = _points(b, resting)
    if b.left and points.alone and (len(resting.branches) > 1 or original.elimination.independent):
        return None
    common = {} if b.left else b.common
    configuration, letters = resting.configuration, resting.solution.letters

    places = {q: letters.write(v) for q, v in common.items() if q in configuration.slots.coordinates}

    def write(e: sp.Expr) -> sp.Expr:
        algebraic = letters.read(configuration.rewritten(e).xreplace(dict(points.given)))
        written = resolved(letters.write(resolved(algebraic, common)), places)  # x under a root is no letter
        return written.xreplace(dict(points.given))

    def shorten(e: sp.Expr) -> sp.Expr:
        return by_stated_roots(over_one_denominator(shortest_form(e)), b.relations)

    place = SolutionPlace(write, points, points, tidy_quotient, shorten)
    slots = original.configuration.slots
    try:
        rows = tuple(tuple(write(r.row.coefficients[k]) for r in used) for k, _ in enumerate(slots.coordinates))
        system = ReactionSystem(rows, tuple(-write(q) for q in original.work.forces), tuple(r.multiplier for r in used))
        reactions = reactions_at(place, system, newton, used, configuration)
        opened = _open(system, reactions, points)
        if opened is None:
            return None
        at_rest = ReactionsAtRest(points, reactions, opened, None)
        verified = _balance(at_rest, original, newton)
    except (NotAlgebraicError, DivisionByZeroError):
        return None
    if b.left and verified is not True:
        return None
    return ReactionsAtRest(points, reactions, opened, verified, _contact_conditions(b, reactions, newton))


def _contact_conditions(b: Branch, reactions: Reactions, newton: Newton) -> dict[str, SignCondition]:
    """That one-sided forces of either sign are not negative: sin θ ≥ 0 for N = m g tan θ with cos θ > 0."""
    positive = known_positive(b)
    forces = {name: f for name, f in _one_sided(reactions, newton).items() if not is_zero(f)}
    found = {}
    for name, force in forces.items():
        is_divided = sign_of(sp.fraction(in_sines(force))[0], positive) is not None  # W/z is never zero
        conditions = not_negative(in_sines(force), positive)
        if conditions is None:
            found[name] = more_than_zero(force)
        elif conditions:
            found[name] = more_than_zero(force, positive) if is_divided else conditions[0]
    return found


def _points(b: Branch, resting: Equilibrium) -> Points:
    given: Mapping[sp.Symbol, sp.Expr] = {}
    if b.special:
        _, given = parameters_given([r.residual for r in b.relations], resting.solution.unknowns)
    configuration = resting.configuration
    around = configuration.surface if resting.given else Surface()
    if b.left:
        unsolved = _on_equation(b, resting)
        return Points(resting.solution, ({},), given, unsolved or configuration.surface, alone=unsolved is None)
    return Points(resting.solution, tuple({**p, **given} for p in b.points), given, around)


def _on_equation(b: Branch, resting: Equilibrium) -> Surface | None:
    """The positions of an equation that is not solved, for all parameters; None if it is linear in none of them.

    Where it is, as a cos θ = l sin³ θ is in a, its points are those of a graph: what vanishes at generic ones vanishes
    at all of them.
    """
    equations = [r.residual for r in b.equations]
    if len(equations) != 1 or b.special:
        return None
    [e] = equations
    for p in sorted(e.free_symbols - {*resting.solution.unknowns}, key=str):
        rate = sp.expand(e).coeff(p, 1)
        if rate != 0 and p not in sp.expand(e - rate * p).free_symbols | rate.free_symbols:
            places = (*resting.configuration.slots.coordinates, p)
            return Surface((*resting.configuration.finite_constraints, e), places)
    return None


def _open(system: ReactionSystem, reactions: Reactions, points: Points) -> tuple[sp.Symbol, ...] | None:
    """The multipliers that the equations do not determine at any point; None if some are determined but not found.

    λ_j is determined if and only if its unit row is a combination of the rows.
    """
    combined = {s for c in reactions.combinations for _, s in c.terms}
    known = {*reactions.values} | combined
    missing = [s for s in system.unknowns if s not in known]
    if any(c.value is None for c in reactions.combinations):
        return None
    for symbol in missing:
        unit = tuple(sp.S.One if s == symbol else sp.S.Zero for s in system.unknowns)
        for p in points.values:
            rows = [[points.at(p, e) for e in row] for row in system.rows]
            ranks = points.around.rank(rows), points.around.rank([*rows, unit])
            if None in ranks or ranks[0] == ranks[1]:
                return None
    return tuple(missing)


def _balance(trial: ReactionsAtRest, original: Equilibrium, newton: Newton) -> bool | None:
    """Whether the multipliers balance the forces of Lagrange's equations at rest, at every point."""
    configuration = original.configuration
    slots = configuration.slots
    at_rest = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    rewritten = trial.reactions.configuration.rewritten
    verdicts = []
    for k, left in enumerate(lagrange_equations(configuration).left):
        balance = sp.Add(left.xreplace(at_rest), *(-r.multiplier * r.row.coefficients[k] for r in newton.reactions))
        claim = rewritten(balance).xreplace(trial.rule)
        holds = trial.points.holds(claim)
        if holds is True or not claim.free_symbols & {*trial.open}:
            verdicts.append(holds)  # otherwise it determines a combination of the open ones
    return all_hold(verdicts)


# Springs at rest


def with_spring_forces(e: Equilibrium) -> Equilibrium:
    """The equilibria with the force of each spring on each branch, by name, where it is unique."""
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
