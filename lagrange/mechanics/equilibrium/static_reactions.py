"""Reactions at rest: the multipliers at each equilibrium.

With multipliers for the reactions of the file's constraints, n equations in its n coordinates balance the applied
forces,

    Q_k + Σ_j λ_j a_jk = 0 ,

in general more than there are multipliers: only at an equilibrium do they agree. So the branch of equilibria (and of
unknown forces) is put in first, exactly, as far as its points share it: with tan θ = a there, cos θ stays in λ. What is
left is linear in the λ and solved by elimination; a pivot is one that vanishes at no point of the branch. Where
constraints are redundant, or become dependent at that position, only combinations of multipliers are determined.

Shapes: a (m, n), Q (n,), λ (m,). Reference: Lagrange 1788, part 1, section IV.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from lagrange.algebra.closed_forms.closed_form import Values
from lagrange.algebra.closed_forms.presentation import shown
from lagrange.algebra.closed_forms.solution_sets import Branch, SolutionSet, parameters_given, resolved
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.exact import DivisionByZeroError, Surface, is_zero
from lagrange.algebra.fourier.linear_systems import tidy_quotient
from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.dynamics.reactions import LinearSystem, Place, Reactions, over_one_denominator, reactions_at
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium

MOST_TRIED = 12
"""Points of a branch beyond which its reactions are not looked for."""


@record
class Points:
    """The points of one branch of equilibria, and what holds at all of them.

    values  of the letters at each point
    given   a parameter, where the branch exists for particular ones only
    around  where the coordinates that the branch leaves open lie
    alone   the constraints leave single positions, not found in closed form: `around` may miss some of them, and only
            an identity is zero at all
    """

    solution: SolutionSet
    values: tuple[Values, ...]
    given: Mapping[sp.Symbol, sp.Expr]
    around: Surface
    alone: bool = False

    def at(self, point: Values, e: sp.Expr) -> sp.Expr:
        """An expression at one of the points. Raises NotAlgebraicError, DivisionByZeroError."""
        there = self.solution.at(point, e.xreplace(dict(self.given)))
        if there.has(sp.zoo, sp.nan, sp.oo):
            raise DivisionByZeroError(e)
        return there

    def verdicts(self, e: sp.Expr, numbers: Mapping[sp.Symbol, sp.Expr] | None = None) -> Iterator[bool | None]:
        """Whether an expression is zero, point by point, for given parameters. Raises DivisionByZeroError."""
        for point in self.values:
            try:
                there = self.at(point, e).xreplace(dict(numbers or {}))
                zero = self.around.is_zero(there)
                yield None if zero and self.alone and not is_zero(there) else zero
            except NotAlgebraicError:
                yield None

    def is_zero(self, expression: sp.Expr) -> bool | None:
        """Whether an expression is zero at all points, or at none; None: neither, or undecided."""
        try:
            found = {*self.verdicts(expression)}
        except DivisionByZeroError:
            return None
        return found.pop() if len(found) == 1 else None

    def holds(self, expression: sp.Expr, numbers: Mapping[sp.Symbol, sp.Expr] | None = None) -> bool | None:
        """Whether an expression is zero at every point, for given parameters. Raises DivisionByZeroError."""
        found = [*self.verdicts(expression, numbers)]
        return False if False in found else None if None in found or not found else True


@record
class ReactionsAtRest:
    """The reactions at one branch of equilibria.

    open      multipliers that the position does not determine, because the constraints are dependent there
    verified  whether they balance the forces at every point
    """

    points: Points
    reactions: Reactions
    open: tuple[sp.Symbol, ...]
    verified: bool | None

    @property
    def rule(self) -> dict[sp.Symbol, sp.Expr]:
        """What is known of the multipliers; of a combination, the first by the others."""
        found = {s: v for s, v in self.reactions.values.items() if s not in self.open}
        for c in self.reactions.combinations:
            (_, first), *rest = c.terms
            if c.value is not None:
                found[first] = sp.Add(c.value, *(-share * other for share, other in rest))
        return found


@record
class StaticReactions:
    """The reactions at the equilibria of one configuration: `at` goes with the branches; None: not found there."""

    equilibrium: Equilibrium
    at: tuple[ReactionsAtRest | None, ...]

    @property
    def configuration(self) -> Configuration:
        """The coordinates that they are written in."""
        return self.equilibrium.configuration


def static_reactions(
    found: Equilibrium, original: Equilibrium, newton: Newton, used: Sequence[Reaction]
) -> StaticReactions:
    """The reactions at every equilibrium of a configuration.

    original  the equilibrium in the file's coordinates
    used      the reactions of independent constraints
    """
    return StaticReactions(found, tuple(_at(b, found, original, newton, used) for b in found.branches))


def _at(
    b: Branch, found: Equilibrium, original: Equilibrium, newton: Newton, used: Sequence[Reaction]
) -> ReactionsAtRest | None:
    """The reactions at one branch; None where they cannot be written down, or not be proved."""
    if len(b.points) > MOST_TRIED or not b.points:
        return None
    if b.left and (len(found.branches) > 1 or original.elimination.independent):
        return None
    points = _points(b, found)
    common = {} if b.left else b.common
    configuration, letters = found.configuration, found.solution.letters

    def write(e: sp.Expr) -> sp.Expr:
        there = letters.read(configuration.rewritten(e).xreplace(dict(points.given)))
        there = letters.write(resolved(there, common))
        return there.xreplace(dict(points.given))

    place = Place(write, points, points, tidy_quotient, lambda e: over_one_denominator(shown(e)))
    slots = original.configuration.slots
    try:
        rows = tuple(tuple(write(r.row.coefficients[k]) for r in used) for k, _ in enumerate(slots.coordinates))
        system = LinearSystem(rows, tuple(-write(q) for q in original.work.forces), tuple(r.multiplier for r in used))
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
    return ReactionsAtRest(points, reactions, opened, verified)


def _points(b: Branch, found: Equilibrium) -> Points:
    given: Mapping[sp.Symbol, sp.Expr] = {}
    if b.special:
        _, given = parameters_given([r.residual for r in b.relations], found.solution.unknowns)
    configuration = found.configuration
    around = configuration.surface if found.given else Surface()
    if b.left:
        return Points(found.solution, ({},), given, configuration.surface, alone=True)
    return Points(found.solution, tuple({**p, **given} for p in b.points), given, around)


def _open(system: LinearSystem, reactions: Reactions, points: Points) -> tuple[sp.Symbol, ...] | None:
    """The multipliers that the equations do not determine at any of the points; None where some are just not found.

    λ_j is determined where its unit row is a combination of the rows.
    """
    loose = {s for c in reactions.combinations for _, s in c.terms}
    known = {*reactions.values} | loose
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


def _balance(found: ReactionsAtRest, original: Equilibrium, newton: Newton) -> bool | None:
    """Whether the multipliers balance the forces that Lagrange's equations have at rest, at every point."""
    configuration = original.configuration
    slots = configuration.slots
    still = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    rewritten = found.reactions.configuration.rewritten
    verdicts = []
    for k, left in enumerate(lagrange_equations(configuration).left):
        balance = sp.Add(left.xreplace(still), *(-r.multiplier * r.row.coefficients[k] for r in newton.reactions))
        claim = rewritten(balance).xreplace(found.rule)
        holds = found.points.holds(claim)
        if holds is True or not claim.free_symbols & {*found.open}:
            verdicts.append(holds)  # otherwise it determines a combination of the open ones
    return False if False in verdicts else None if None in verdicts else True
