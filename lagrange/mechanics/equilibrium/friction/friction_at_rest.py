"""Friction at rest: for which parameters, and in which positions, a system with rough contacts can be at rest.

At rest the friction in a contact is not given: it is an unknown F along the tangent, at most μ_s |N|. With multipliers
for the reactions the forces balance if and only if

    Q_k + Σ_j λ_j a_jk + Σ_i F_i t_i·∂r_i/∂q_k = 0     for every coordinate of the file,

r_i being the point that touches, relative to what it touches. Rest is possible if these equations, the bounds |F_i| ≤
μ_i |N_i| and N_j ≥ 0 for one-sided constraints have a solution. The equations are solved first. If they determine
everything, the bounds are the conditions; otherwise the system is statically indeterminate, all distributions of the
forces that satisfy the bounds are admitted, and the unknowns that remain are eliminated (`linear_inequalities`). An
equation without unknowns is a condition as well. Belts add their tensions to the bounds (`belts`).

The unknown forces of the file are solved for last. Those that the equations leave open stay in the conditions, which
say how large they must be.

In space F has two components; there it must be determined. Where |N| occurs and the sign of N is not known, both are
tried.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import islice, permutations, product

import sympy as sp

from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.core.effort import GivenUpError, allowed_for_a_search
from lagrange.core.records import all_hold, record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.friction import unpressed
from lagrange.mechanics.dynamics.lagrangian import lagrange_equations
from lagrange.mechanics.dynamics.newton import Newton
from lagrange.mechanics.equilibrium.equilibrium import VirtualWork
from lagrange.mechanics.equilibrium.friction.balance import (
    BeltLaw,
    ForceBalance,
    LengthsGiven,
    RoughContact,
    SolvedBalance,
    belt_laws,
    equal_angles,
    held_positions,
    lengths_by_angles,
    sought_forces,
    tensions_between,
)
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import (
    LoadLimits,
    RestCondition,
    SolvedFor,
    bounded_by,
    implies_all,
    joined_cases,
    limits_of_load,
    not_negative,
    positive,
    vanishing,
    without_weaker,
)
from lagrange.mechanics.equilibrium.friction.linear_inequalities import (
    Inequality,
    NotEliminatedError,
    Signs,
    shortest,
    solvable,
)
from lagrange.mechanics.equilibrium.friction.open_force import always, bounds_of
from lagrange.mechanics.equilibrium.friction.rough_contacts import rough_contacts, without_keeping
from lagrange.mechanics.equilibrium.limits import (
    CONTACTS_OF_LIMITS,
    MOST_CASES,
    MOST_ORDERS,
    UNITS_OF_REST,
)
from lagrange.mechanics.equilibrium.loads import load_parameters
from lagrange.problem.keys import Find
from lagrange.problem.model import Problem

Pair = tuple[sp.Expr, sp.Expr]


@record
class AtRest:
    """Where a system with rough contacts can be at rest, in one set of coordinates.

    balance      the equations, each zero, by coordinate of the file
    forces       every unknown, in terms of those that the equations leave open, and of unknown forces of the file
    open         these
    equations    conditions that are equations, each zero
    cases        the conditions: all those of one of the cases hold; none: rest is impossible
    assumed      sines and cosines that are taken to be positive
    presupposed  what the equations are divided by, if its sign is not known: it is not zero
    verified     whether the forces satisfy Lagrange's equations at rest
    where        what must be positive for the conditions to be these, if they are the limits of one force
    partly       whether the cases are those that were seen at drawn numbers, so that there may be others
    equal        angles that the constraints make equal to others, if both are acute
    lengths      what constraints give in terms of angles, where the balance contains it
    unexamined   what is positive or negative in the cases, and may perhaps vanish as well
    place        the position for which this holds, up to a displacement of the whole; empty if it holds for all
    elsewhere    other positions that the constraints admit; there rest is impossible, or needs more than here
    bounds       those of the only force that is open, where they are few
    always       where the conditions hold in every position
    """

    configuration: Configuration
    contacts: tuple[RoughContact, ...]
    belts: tuple[BeltLaw, ...]
    balance: Mapping[sp.Symbol, sp.Expr]
    forces: Mapping[sp.Symbol, sp.Expr]
    open: tuple[sp.Symbol, ...]
    equations: tuple[sp.Expr, ...]
    cases: tuple[tuple[RestCondition, ...], ...]
    assumed: tuple[sp.Expr, ...]
    presupposed: tuple[sp.Expr, ...]
    verified: bool | None
    where: tuple[RestCondition, ...] = ()
    partly: bool = False
    equal: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    unexamined: tuple[sp.Expr, ...] = ()
    lengths: LengthsGiven = LengthsGiven({})
    place: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    elsewhere: tuple[Mapping[sp.Symbol, sp.Expr], ...] = ()
    bounds: tuple[RestCondition, ...] = ()
    always: RestCondition | None = None

    @property
    def name(self) -> str:
        """The name of the choice of coordinates."""
        return self.configuration.name

    @property
    def relations(self) -> tuple[Pair, ...]:
        """The conditions that are equations, as left = right, solved for a coordinate or its sine where that is so."""
        coordinates = {*self.configuration.slots.coordinates}
        return tuple(_relation(e, coordinates) for e in self.equations)

    @property
    def friction(self) -> dict[str, tuple[sp.Expr, ...]]:
        """The components of each friction force that is determined, by name."""
        unknown = {*self.open}
        return {
            c.name: tuple(self.forces[f] for f in c.components)
            for c in self.contacts
            if all(self.forces[f].free_symbols.isdisjoint(unknown) for f in c.components)
        }


def _relation(e: sp.Expr, coordinates: set[sp.Symbol]) -> Pair:
    """e = 0 as left = right: sin φ = 8/3 sin α for R W (3 sin φ − 8 sin α)/8 = 0, tan φ = a/b for b sin φ = a cos φ.

    Without numbers and positive parameters as factors. It is solved only where what it is divided by has a sign.
    """
    factors = sp.Mul.make_args(sp.factor(e))
    reduced = sp.Mul(*(f for f in factors if not f.is_number and not (f.is_positive and f.is_Symbol)))
    if not coordinates & reduced.free_symbols:
        return reduced, sp.S.Zero
    waves = sorted((w for w in reduced.atoms(sp.sin, sp.cos) if w.args[0] in coordinates), key=str)
    moving = waves or sorted(coordinates & reduced.free_symbols, key=str)
    dummies = [sp.Dummy() for _ in moving]
    linear = sp.expand(reduced.xreplace(dict(zip(moving, dummies, strict=True))))
    rates = [linear.diff(d) for d in dummies]
    constant = linear.xreplace(dict.fromkeys(dummies, sp.S.Zero))
    if coordinates & linear.free_symbols or any(r.free_symbols & {*dummies} for r in rates):
        return reduced, sp.S.Zero
    if len(moving) == 1 and sign_of(rates[0]) in (1, -1):
        return moving[0], shortest(-constant / rates[0])
    pair = len(waves) == 2 and waves[0].args == waves[1].args and constant == 0
    if pair and sign_of(rates[1]) in (1, -1):  # the cosine comes before the sine
        return sp.tan(waves[1].args[0]), shortest(-rates[0] / rates[1])
    return reduced, sp.S.Zero


def rest_with_friction(
    problem: Problem, newton: Newton, original: Configuration, configuration: Configuration, work: VirtualWork
) -> AtRest:
    """Where the system can be at rest.

    original  the file's coordinates; `work` that of the applied forces in them

    Raises NotCoveredError if that cannot be decided, ProblemError if a contact is not as the file says.
    """
    loading = {s for q in work.forces for s in q.free_symbols}
    sought = sought_forces(problem, belt_laws(problem, newton, configuration))
    between = tensions_between(problem, loading)
    positions = held_positions(configuration)

    def resting(wanted: tuple[sp.Symbol, ...]) -> AtRest:
        only = len(positions) == 1
        there = [_at_rest(problem, newton, original, configuration, work, wanted, held, only) for held in positions]
        return _least_demanding(there, Signs({p.symbol for p in problem.parameters}))

    if between:
        held = resting(tuple(s for s in sought if s not in between))
        if all(held.cases):
            return held
    return resting(sought)


def _least_demanding(positions: Sequence[AtRest], signs: Signs) -> AtRest:
    """The position in which the system can be at rest whenever it can be in any of the others.

    Raises NotCoveredError if there is none.
    """
    if len(positions) == 1 and not positions[0].place:
        return positions[0]
    for one in positions:
        others = [o for o in positions if o is not one]
        if all(any(implies_all(case, own, signs) for own in one.cases) for o in others for case in o.cases):
            return replace(one, elsewhere=tuple(o.place for o in others))
    [first, *_] = positions
    span = (first.contacts[0].friction if first.contacts else first.belts[0].belt).span
    raise NotCoveredError("friction at rest in several positions that the constraints admit", span)


def _at_rest(
    problem: Problem,
    newton: Newton,
    original: Configuration,
    configuration: Configuration,
    work: VirtualWork,
    sought: tuple[sp.Symbol, ...],
    position: Mapping[sp.Symbol, sp.Expr],
    only: bool,
) -> AtRest:
    """Where the system can be at rest in one position, as conditions on these unknown forces; others are eliminated.

    only  whether it is the only position
    """
    equal = equal_angles(configuration)
    held = {**equal, **position}
    moving = {*configuration.slots.coordinates}
    shifted = any(not v.free_symbols.isdisjoint(moving) for v in position.values())
    touching = rough_contacts(problem, newton, original, configuration)
    newton = without_keeping(newton, touching)
    belts = belt_laws(problem, newton, configuration)

    def balanced(position: Mapping[sp.Symbol, sp.Expr]) -> tuple[tuple[RoughContact, ...], ForceBalance]:
        contacts = tuple(c.at(position) for c in touching)
        return contacts, ForceBalance(
            newton, contacts, original, configuration, work, problem.unknowns, sought, position
        )

    contacts, system = balanced(held)
    lengths = lengths_by_angles(configuration, held)
    if any(e.free_symbols & lengths.values.keys() for row in system.rows for e in row):
        held = {q: v.xreplace(dict(lengths.values)) for q, v in held.items()} | dict(lengths.values)
        contacts, system = balanced(held)
    else:
        lengths = LengthsGiven({})
    wanted = SolvedFor(sought, tuple(c.coefficient for c in contacts), load_parameters(original, problem.unknowns))
    angles = {p.symbol for p in problem.parameters} | {*_acute_by_range(configuration)}
    positions = angles | {*configuration.slots.coordinates}

    def resting(
        solved: SolvedBalance,
        cases: tuple[tuple[RestCondition, ...], ...],
        signs: Signs,
        where: tuple[RestCondition, ...] = (),
        partly: bool = False,
    ) -> AtRest:
        return AtRest(
            configuration,
            contacts,
            belts,
            {q: e for q, e in zip(original.slots.coordinates, system.balance, strict=True) if e != 0},
            solved.forces,
            solved.open,
            solved.equations,
            cases,
            tuple(sorted(signs.used, key=str)),
            solved.presupposed,
            _verified(solved, contacts, newton, original, configuration, held),
            where,
            partly,
            {q: e for q, e in equal.items() if held[q] == e},
            lengths=lengths,
            place=position if shifted or not only else {},
        )

    if len(contacts) >= CONTACTS_OF_LIMITS and not belts and len(system.sought) == 1:
        signs = Signs(positions)
        solved = system.solved(signs, system.pressing)
        limits = _limits_of(solved, contacts, problem, system.sought[0], signs)
        regimes = [
            (
                tuple(c for e in one.where for c in not_negative(e, SolvedFor(), signs)),
                tuple(c for slack in one.slacks for c in not_negative(slack, SolvedFor(sought), signs)),
            )
            for one in limits
        ]
        if len(regimes) == 1:
            [(where, case)] = regimes
            return resting(solved, (without_weaker(case, signs),), signs, where)
        if regimes:
            return resting(
                solved, tuple((*where, *without_weaker(case, signs)) for where, case in regimes), signs, partly=True
            )
    for most, acute in product((0, MOST_CASES), (angles, positions)):
        for order in islice(permutations(system.pressing), MOST_ORDERS):
            signs = Signs(acute)
            try:
                solved = system.solved(signs, order)
                unexamined: list[sp.Expr] = []
                cases = _cases(solved, contacts, belts, wanted, signs, most, unexamined)
            except NotEliminatedError:
                if not solved.open:
                    break
                continue
            if acute is angles and angles != positions and _is_evident(cases, Signs(positions)):
                break
            rest = replace(resting(solved, cases, signs), unexamined=tuple(dict.fromkeys(unexamined)))
            one = len(solved.open) == 1 and not belts and all(c.sign and len(c.components) == 1 for c in contacts)
            bounds = (*_one_sided(solved), *_in_cones(solved, contacts)) if one else ()
            return replace(rest, bounds=bounds_of(bounds, solved.open, signs), always=always(cases, positions, signs))
    span = contacts[0].friction.span if contacts else belts[0].belt.span
    raise NotCoveredError("friction at rest in contacts whose forces have no known signs", span)


def _acute_by_range(configuration: Configuration) -> Iterator[sp.Expr]:
    """The coordinates between 0 and a right angle, and θ/2 for those between 0 and a straight one."""
    for q, limits in configuration.ranges.items():
        if limits.low == 0 and (limits.high - sp.pi / 2).is_nonpositive:
            yield q
        if limits.low == 0 and (limits.high - sp.pi).is_nonpositive:
            yield q / 2


def _limits_of(
    solved: SolvedBalance, contacts: Sequence[RoughContact], problem: Problem, load: sp.Symbol, signs: Signs
) -> list[LoadLimits]:
    """Between which limits one force must be, case by case; none if the signs of reactions are open."""
    if not solved.open or solved.equations or any(c.sign is None or len(c.components) > 1 for c in contacts):
        return []
    values = problem.given_values
    coefficients = [c.coefficient for c in contacts]
    return limits_of_load(_in_cones(solved, contacts), load, coefficients, values, signs)


def rest_within(
    problem: Problem, newton: Newton, original: Configuration, configuration: Configuration, work: VirtualWork
) -> tuple[AtRest | None, str]:
    """`rest_with_friction` with its own work allowance, and the reason for a failure, empty otherwise.

    Raises NotCoveredError if nothing else is asked: impending motion, which needs less, is an answer without it.
    """
    with allowed_for_a_search(UNITS_OF_REST) as allowance:
        try:
            return rest_with_friction(problem, newton, original, configuration, work), ""
        except GivenUpError:
            if allowance.left >= 0:
                raise  # the time is over, and not this allowance used up
            return None, "friction at rest, the work allowed for it is used up"
        except NotCoveredError:
            if Find.IMPENDING not in problem.find:
                raise
    return None, "friction at rest, statically indeterminate contacts whose forces have no known signs"


def _is_evident(cases: Sequence[Sequence[RestCondition]], signs: Signs) -> bool:
    """Whether a condition says no more than that sines and cosines of positions are positive."""
    return any(signs.of(shortest(c.right - c.left)) == 1 for case in cases for c in case)


def _cases(
    solved: SolvedBalance,
    contacts: Sequence[RoughContact],
    belts: Sequence[BeltLaw],
    wanted: SolvedFor,
    signs: Signs,
    most: int,
    unexamined: list[sp.Expr],
) -> tuple[tuple[RestCondition, ...], ...]:
    """The conditions, case by case; expressions that must not vanish, so far as known, are added to `unexamined`."""
    if any(signs.of(e) in (1, -1) for e in solved.equations):
        return ()
    if not solved.open:
        conditions = _determined(solved, contacts, belts, wanted, signs)
        return () if conditions is None else (conditions,)
    if any(len(c.components) > 1 for c in contacts):
        raise NotEliminatedError
    cases: list[tuple[RestCondition, ...]] = []
    open_signs = [c for c in contacts if c.sign is None]
    for chosen in product((1, -1), repeat=len(open_signs)):
        settled = dict(zip((c.name for c in open_signs), chosen, strict=True))
        signed = [replace(c, sign=settled.get(c.name, c.sign)) for c in contacts]
        inequalities = [*_one_sided(solved), *_in_cones(solved, signed), *_on_drums(solved, belts)]
        for case in solvable(inequalities, signs, most):
            conditions = (
                *(c for e in case.zero for c in vanishing(e, wanted, signs)),
                *(c for e in case.positive for c in positive(e, wanted, signs)),
                *(c for slack in case.slacks for c in not_negative(slack, wanted, signs)),
            )
            unexamined += [e for e in case.unexamined if -e not in unexamined]
            cases.append(without_weaker(conditions, signs))
    return joined_cases(cases, signs)


def _scaled(factor: sp.Expr, i: Inequality) -> Inequality:
    return Inequality(tuple(shortest(factor * c) for c in i.coefficients), shortest(factor * i.constant))


def _sum(a: Inequality, b: Inequality) -> Inequality:
    pairs = zip(a.coefficients, b.coefficients, strict=True)
    return Inequality(tuple(shortest(x + y) for x, y in pairs), shortest(a.constant + b.constant))


def _one_sided(solved: SolvedBalance) -> list[Inequality]:
    """That one-sided constraints only push or pull."""
    strings = [solved.linear[u] for u in solved.pulling if u in solved.linear]
    return [*(_scaled(sense, solved.linear[r.force]) for r, sense in solved.one_sided), *strings]


def _in_cones(solved: SolvedBalance, contacts: Sequence[RoughContact]) -> list[Inequality]:
    """μ N ± F ≥ 0 in each contact, and N ≥ 0."""
    inequalities = []
    for c in contacts:
        assert c.sign is not None
        pressed = _scaled(c.sign * c.normal, solved.linear[c.reaction.force])
        most, [force] = _scaled(c.coefficient, pressed), c.components
        inequalities += [_sum(most, _scaled(sp.Integer(s), solved.linear[force])) for s in (1, -1)]
        if c.reaction.constraint.side is None:
            inequalities.append(pressed)
    return inequalities


def _on_drums(solved: SolvedBalance, belts: Sequence[BeltLaw]) -> list[Inequality]:
    """T_2 e^(μ β) − T_1 ≥ 0 and T_1 ≥ 0 for each belt."""
    return [_in_open(solved, e) for b in belts for e in (b.reserve, b.tight)]


def _in_open(solved: SolvedBalance, e: sp.Expr) -> Inequality:
    """e ≥ 0, e being linear in the unknowns, in terms of those that are open. Raises NotEliminatedError."""
    known = [u for u in solved.linear if u in e.free_symbols]
    rates = {u: sp.expand(e).diff(u) for u in known}
    if any(not r.free_symbols.isdisjoint(known) for r in rates.values()):
        raise NotEliminatedError
    rest = Inequality((sp.S.Zero,) * len(solved.open), e.xreplace(dict.fromkeys(known, sp.S.Zero)))
    for u, rate in rates.items():
        rest = _sum(rest, _scaled(rate, solved.linear[u]))
    return rest


def _determined(
    solved: SolvedBalance,
    contacts: Sequence[RoughContact],
    belts: Sequence[BeltLaw],
    wanted: SolvedFor,
    signs: Signs,
) -> tuple[RestCondition, ...] | None:
    """The bounds themselves; None if one of them never holds."""
    conditions: list[RestCondition] = []
    rough = {c.reaction.name for c in contacts if not c.also}
    smooth = [solved.forces[r.force] * sense for r, sense in solved.one_sided if r.name not in rough]
    for slack in (*smooth, *(solved.forces[u] for u in solved.pulling if u in solved.forces)):
        sign = signs.of(slack)
        if sign == -1:
            return None
        if sign is None:
            conditions += not_negative(slack, wanted, signs)
            signs = signs.assuming(slack)
    for c in contacts:
        pressed = shortest(c.normal * solved.forces[c.reaction.force] * (1 if c.sign is None else c.sign))
        friction = tuple(shortest(solved.forces[f]) for f in c.components)
        if pressed == 0 and not c.also:
            raise ProblemError(unpressed(c.friction))
        if c.also:
            conditions += bounded_by(friction, c.resultant(solved.forces), c.coefficient, True, signs) or ()
            continue
        if (
            len(friction) == 1
            and c.sign is not None
            and not (friction[0] + pressed).free_symbols.isdisjoint(wanted.forces)
        ):
            for side in (1, -1):
                conditions += not_negative(c.coefficient * pressed + side * friction[0], wanted, signs)
            continue
        bound = bounded_by(friction, pressed, c.coefficient, c.sign is not None, signs)
        if bound is None:
            return None
        conditions += bound
    for reserve in _on_drums(solved, belts):
        if signs.of(reserve.constant) == -1:
            return None
        conditions += not_negative(reserve.constant, wanted, signs)
    return without_weaker(conditions, signs)


def _verified(
    solved: SolvedBalance,
    contacts: Sequence[RoughContact],
    newton: Newton,
    original: Configuration,
    configuration: Configuration,
    held: Mapping[sp.Symbol, sp.Expr],
) -> bool | None:
    """Whether the forces satisfy Lagrange's equations at rest, apart from the conditions that are equations."""
    if solved.equations:
        return None
    slots = original.slots
    at_rest = dict.fromkeys((*slots.velocities, *slots.accelerations), sp.S.Zero)
    verdicts = []
    for k, left in enumerate(lagrange_equations(original).left):
        reactions = [r.force * r.per_force * without_root(r.row, slots).coefficients[k] for r in newton.reactions]
        friction = [f * row[k] for c in contacts for f, row in zip(c.components, c.generalized, strict=True)]
        balance = configuration.rewritten(left.xreplace(at_rest) - sp.Add(*reactions)) - sp.Add(*friction)
        verdicts.append(configuration.surface.is_zero(balance.xreplace(dict(held)).xreplace(dict(solved.forces))))
    return all_hold(verdicts)
