"""Impending motion: equilibrium with friction at its limit in every rough contact.

    F_i = μ_i N_i against the direction in which the point that touches is about to slip.

With this law the reactions follow from as many of the equations of balance as there are constraints, those of the
dependent coordinates. Substituted into F, they make friction a force that depends on the position alone; what remains
is an equilibrium of applied forces, found by the principle of virtual work. At an equilibrium all equations of balance
hold, so that the reactions found there are those of the system.

Where the file gives no direction, both are tried, in several contacts those that a displacement can have at once: a rod
that slides out below slides down above. Several contacts are all taken to slip at once. Belts slip with them:
their tensions satisfy T_1 = T_2 e^(μ β), one more condition on the forces.

Where the constraints hold the angles and only forces are sought, the position is the one that they hold, as for the
conditions of rest: a bracket on a pipe is upright.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import combinations, product

import sympy as sp

from lagrange.algebra.closed_forms.conditions import (
    NeverPositiveError,
    conditions_for,
    positive_part,
    with_shortest_conditions,
)
from lagrange.algebra.closed_forms.shortest_form import with_differences_of_squares, without_leading_minus
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.terms import normalised
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import NotCoveredError, ProblemError
from lagrange.core.records import record
from lagrange.mechanics.constraints.displacements import Elimination
from lagrange.mechanics.constraints.kinematics import Configuration, Load
from lagrange.mechanics.dynamics.contact.touching import point_on
from lagrange.mechanics.dynamics.free_bodies import without_root
from lagrange.mechanics.dynamics.friction import friction_forces, unpressed
from lagrange.mechanics.dynamics.newton import Newton, Reaction
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium, VirtualWork, at_position, equilibrium
from lagrange.mechanics.equilibrium.friction.balance import (
    BeltLaw,
    RoughContact,
    belt_laws,
    held_coordinates,
    held_positions,
    one_sided,
)
from lagrange.mechanics.equilibrium.friction.conditions_of_rest import (
    RestCondition,
    SolvedFor,
    not_negative,
    solved_for_exponent,
    value_of_letter,
)
from lagrange.mechanics.equilibrium.friction.linear_inequalities import Signs, shortest
from lagrange.mechanics.equilibrium.friction.rough_contacts import each_contact_once, rough_contacts
from lagrange.problem.model import Friction, Problem

GIVEN_AS_A_RULE = "WwMmg"
"""First letters of weights and masses: of a weight and a push without values the push is sought."""


@record
class ImpendingMotion:
    """Equilibrium with friction at its limit, for one direction of slip in each contact.

    belts        each slips towards its tight side
    senses       by friction: +1 if it acts along its tangent, −1 if against it
    pressed      by constraint: the force in which its reaction is written
    equilibrium  with the friction as applied forces
    held         the position that the constraints hold, which an answer need not state
    place        that position, wherever the forces are those there
    """

    contacts: tuple[RoughContact, ...]
    belts: tuple[BeltLaw, ...]
    senses: Mapping[str, int]
    pressed: Mapping[str, sp.Expr]
    equilibrium: Equilibrium
    held: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    place: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)

    def pressed_with(self, b: Branch) -> dict[str, sp.Expr]:
        """The reactions, by constraint, with the unknown forces that an equilibrium gives."""
        found = {r.lhs: r.rhs for r in b.relations if r.lhs in self.equilibrium.forces}
        return {
            name: shortest(f.xreplace(found)) if f.free_symbols & found.keys() else f
            for name, f in self.pressed.items()
        }

    def may_be_lifted(self, newton: Newton, pressed: Mapping[str, sp.Expr]) -> dict[str, sp.Expr]:
        """By constraint, the forces of one-sided ones whose sign is not known: contact needs them not to be negative.

        pressed  their values, from `pressed` or `pressed_with`
        """
        sides = {r.name: 1 if r.named else r.constraint.side for r in newton.reactions if r.constraint.side is not None}
        forces = {r.name: sp.Integer(sides[r.name]) * r.force for r in newton.reactions if r.name in sides}
        return {name: f for name, f in forces.items() if sign_of(sides[name] * pressed[name]) != 1}


@record
class _Statics:
    """The file's coordinates: configuration, elimination, work of the applied forces."""

    original: Configuration
    elimination: Elimination
    work: VirtualWork


def impending_motions(
    problem: Problem,
    newton: Newton,
    file: tuple[Configuration, Elimination, VirtualWork],
    configuration: Configuration,
    elimination: Elimination,
) -> tuple[ImpendingMotion, ...]:
    """The equilibria with friction at its limit, for each direction of slip that is possible.

    file  the configuration, the elimination and the work of the applied forces in the file's coordinates

    Raises NotCoveredError if the sign of a normal force is not known, ProblemError.
    """
    statics = _Statics(*file)
    if statics.elimination.unused:
        raise NotCoveredError(
            "impending motion with redundant constraints, which share their reactions in no known way"
        )
    contacts = rough_contacts(problem, newton, statics.original, configuration)
    rolling = next((c for c in contacts if c.keeping), None)
    if rolling is not None:
        what = f"impending slip where the constraint `{rolling.keeping[0].name}` keeps what touches from slipping,"
        raise NotCoveredError(what, rolling.friction.span, cure="leave that constraint out, or `find: equilibrium`")
    belts = belt_laws(problem, newton, configuration)
    spatial = [c for c in contacts if len(c.components) > 1]
    if spatial:
        raise NotCoveredError("impending motion in space, in a direction that is not given,", spatial[0].friction.span)
    given = _given_senses(problem, newton, contacts, statics.original, configuration)
    open_ = [c.name for c in contacts if c.name not in given]
    signs = Signs({p.symbol for p in problem.parameters})
    motions = []
    held = held_positions(configuration)
    places = held if len(held) > 1 else [{}]
    tied = _tied(contacts, statics, configuration)
    for chosen in product((1, -1), repeat=len(open_)):
        senses = given | dict(zip(open_, chosen, strict=True))
        for signed, place in product(_signed(contacts), places):
            here = tuple(c.at(place) for c in signed)
            motion = _at_limit(problem, newton, statics, configuration, elimination, here, belts, senses, signs, place)
            if motion is not None and _can_slip(motion, open_, tied, signs):
                motions.append(motion)
    return tuple(motions)


def _tied(
    contacts: Sequence[RoughContact], statics: _Statics, configuration: Configuration
) -> dict[tuple[str, str], sp.Expr]:
    """Contacts that cannot slip independently: pairs of names, and what has the sign of the ratio of their slips.

    The slips, t_i·δr_i, are linear in the free displacements, and two of them may be proportional.
    """
    shape = statics.elimination.shape(len(statics.original.slots.coordinates))
    columns = range(len(statics.elimination.independent))
    rates: dict[str, list[sp.Expr]] = {}
    for c in contacts:
        rows = [(g, row) for g, row in zip(c.generalized[0], shape, strict=True) if g != 0]
        rates[c.name] = [shortest(sp.Add(*(g * configuration.rewritten(row[j]) for g, row in rows))) for j in columns]
    tied: dict[tuple[str, str], sp.Expr] = {}
    for a, b in combinations(rates, 2):
        one, other = rates[a], rates[b]
        minors = (one[j] * other[k] - one[k] * other[j] for j, k in combinations(columns, 2))
        if all(configuration.surface.is_zero(m) is True for m in minors):
            products = [x * y for x, y in zip(one, other, strict=True) if x != 0 and y != 0]
            if products:
                tied[a, b] = shortest(products[0])
    return tied


def _can_slip(
    motion: ImpendingMotion, open_: Sequence[str], tied: Mapping[tuple[str, str], sp.Expr], signs: Signs
) -> bool:
    """Whether a displacement has the slips; a pair whose directions the file gives is not asked."""
    for (a, b), ratio in tied.items():
        wanted = motion.senses[a] * motion.senses[b]
        if {a, b} & {*open_} and _signs_at(ratio, motion.equilibrium, signs) == {-wanted}:
            return False
    return True


def _signs_at(e: sp.Expr, resting: Equilibrium, signs: Signs) -> set[int | None]:
    """The signs of an expression at all equilibria; None if one is not known."""
    sign = signs.of(e)
    if sign is not None:
        return {sign}
    try:
        return {signs.of(resting.solution.at(p, e)) for b in resting.branches for p in b.points}
    except (NotAlgebraicError, DivisionByZeroError):
        return {None}


def _given_senses(
    problem: Problem,
    newton: Newton,
    contacts: Sequence[RoughContact],
    original: Configuration,
    configuration: Configuration,
) -> dict[str, int]:
    """The sense of each friction whose direction the file gives: the tangent of a vector `slip` is against it."""
    senses = {c.name: 1 for c in contacts if c.friction.toward is not None}
    rough = each_contact_once(f for f in problem.forces if isinstance(f, Friction))
    along = [f for f in rough if f.slip is not None]
    for f in friction_forces(along, newton, original, configuration):
        [contact] = (c for c in contacts if c.name == f.friction.name)
        share = textbook_form((f.along * f.sense).fixed().dot(contact.tangents[0]))
        senses[contact.name] = 1 if share.is_negative else -1
    return senses


def _signed(contacts: Sequence[RoughContact]) -> Iterator[tuple[RoughContact, ...]]:
    """The contacts with each sign of the normal forces whose sign is not known."""
    open_ = [n for n, c in enumerate(contacts) if c.sign is None]
    for chosen in product((1, -1), repeat=len(open_)):
        settled = dict(zip(open_, chosen, strict=True))
        yield tuple(replace(c, sign=settled.get(n, c.sign)) for n, c in enumerate(contacts))


def _at_limit(
    problem: Problem,
    newton: Newton,
    statics: _Statics,
    configuration: Configuration,
    elimination: Elimination,
    contacts: Sequence[RoughContact],
    belts: Sequence[BeltLaw],
    senses: Mapping[str, int],
    signs: Signs,
    place: Mapping[sp.Symbol, sp.Expr],
) -> ImpendingMotion | None:
    """One direction of slip in each contact; None if it is impossible.

    place  the position, if it is one of several that the constraints hold
    """

    def write(e: sp.Expr) -> sp.Expr:
        return configuration.rewritten(e).xreplace(dict(place))

    unknowns = [r.force for r in newton.reactions]
    shares = {c.reaction.force: (c, senses[c.name] * (c.sign or 1) * c.coefficient * c.normal) for c in contacts}
    rows, right = [], []
    for k in range(len(statics.work.forces)):
        row = []
        for r in newton.reactions:
            entry = write(without_root(r.row, statics.original.slots).coefficients[k] * r.per_force)
            if r.force in shares:
                contact, share = shares[r.force]
                entry += share * contact.generalized[0][k]
            row.append(shortest(entry))
        rows.append(row)
        right.append(shortest(write(-statics.work.forces[k])))
    span = contacts[0].friction.span if contacts else belts[0].belt.span
    found = _pressed_by(rows, right, statics.elimination.dependent, configuration)
    if found is None:
        raise NotCoveredError("impending motion whose normal forces are not determined,", span)
    solved, beside = found
    pressed = {u: without_leading_minus(shortest(v)) for u, v in zip(unknowns, solved, strict=True)}
    loads = []
    for contact, share in shares.values():
        if pressed[contact.reaction.force] == 0:
            raise ProblemError(unpressed(contact.friction))
        vector = (contact.tangents[0] * shortest(share * pressed[contact.reaction.force])).map(shortest)
        loads.append(Load(contact.name, contact.friction.on, vector, contact.place))
        if contact.opposite:
            loads.append(
                Load(contact.name, contact.opposite, -vector, point_on(configuration, contact.opposite, contact.place))
            )
    loaded = replace(configuration, loads=(*configuration.loads, *loads))
    laws = [*beside, *(shortest(b.reserve.xreplace(pressed)) for b in belts)]
    resting = equilibrium(loaded, elimination, problem.unknowns, laws=laws, place=place)
    held = place
    if not place and (resting.given or beside or len(resting.branches) > 1):
        held = held_coordinates(configuration)
    if place and not resting.given:
        resting = _stated_where_held(resting, place)
    elif resting.given and held:
        pressed = {u: shortest(v.xreplace(held)) for u, v in pressed.items()}
        resting = at_position(resting, held)
    elif held and (there := _where_held(resting, held)) is not None:
        pressed = {u: shortest(v.xreplace(held)) for u, v in pressed.items()}
        resting = there
    values = problem.given_values
    balance = [
        sp.Add(*(a * pressed[u] for a, u in zip(row, unknowns, strict=True)), -r)
        for row, r in zip(rows, right, strict=True)
    ]
    resting = _in_balance(_possible(resting, contacts, signs, values), balance)
    if not resting.branches or _is_pulled_off(one_sided(newton, statics.original.slots.coordinates), pressed, signs):
        return None
    for c in contacts:
        verdicts = {_sign_there(c, pressed, resting, signs, problem.given_values)}
        if -1 in verdicts:
            return None
        if None in verdicts and c.reaction.constraint.side is None and c.friction.contact is None:
            what = f"impending motion without the sign of the reaction of `{c.reaction.name}` (give `contact`),"
            raise NotCoveredError(what, c.friction.span)
    resting = _where_pressed(resting, contacts, pressed, signs, values)
    if not resting.branches:
        return None
    resting = replace(resting, branches=tuple(_solved_for_friction(b, contacts) for b in resting.branches))
    by_name = {r.name: pressed[r.force] for r in newton.reactions}
    unstated = {} if resting.given else held
    return ImpendingMotion(tuple(contacts), tuple(belts), dict(senses), by_name, resting, unstated, held)


def _in_balance(resting: Equilibrium, balance: Sequence[sp.Expr]) -> Equilibrium:
    """The equilibria without those at which an equation of balance does not hold.

    Where the dependent displacements have no solution, as of two strings that hang straight down, the principle of
    virtual work for the independent ones says too little.
    """

    def fails(b: Branch) -> bool:
        if b.special or b.left or not b.points:  # their points do not have the relations between parameters put in
            return False
        try:
            return all(any(is_zero(resting.solution.at(p, e)) is False for e in balance) for p in b.points)
        except (NotAlgebraicError, DivisionByZeroError):
            return False

    kept = [n for n, b in enumerate(resting.branches) if resting.given or not fails(b)]
    if len(kept) == len(resting.branches):
        return resting
    idle = tuple(resting.idle[n] for n in kept if n < len(resting.idle))
    solution = replace(resting.solution, branches=tuple(b for b in resting.solution.branches if not fails(b)))
    further = (without_leading_minus(sp.fraction(sp.together(shortest(e)))[0]) for e in balance)
    laws = (*resting.laws, *dict.fromkeys(e for e in further if e != 0))
    return replace(resting, branches=tuple(resting.branches[n] for n in kept), idle=idle, solution=solution, laws=laws)


def _pressed_by(
    rows: Sequence[Sequence[sp.Expr]], right: Sequence[sp.Expr], dependent: Sequence[int], configuration: Configuration
) -> tuple[list[sp.Expr], list[sp.Expr]] | None:
    """The reactions, and the conditions that they leave; None if the equations of balance do not determine them.

    They follow from the equations of the dependent coordinates. Where no force acts along these, as on the arm of tongs
    whose load hangs by friction alone, other equations give the reactions, and those that are left are conditions.
    """

    def solved(chosen: Sequence[int]) -> list[sp.Expr] | None:
        if not chosen:
            return []
        values = solved_linear([rows[k] for k in chosen], [right[k] for k in chosen], configuration.surface, shortest)
        return None if values is None or None in values else [v for v in values if v is not None]

    reactions = solved(dependent)
    if not dependent or any(right[k] != 0 for k in dependent) or not any(right):
        return None if reactions is None else (reactions, [])
    loaded = [k for k, force in enumerate(right) if force != 0]
    if len(loaded) != 1:
        return None if reactions is None else (reactions, [])
    for left_out in dependent:
        chosen = [*(k for k in dependent if k != left_out), *loaded]
        other = solved(chosen)
        if other is not None:
            residual = sp.Add(*(entry * value for entry, value in zip(rows[left_out], other, strict=True)))
            return other, [shortest(residual)]
    return None if reactions is None else (reactions, [])


def _where_held(resting: Equilibrium, held: Mapping[sp.Symbol, sp.Expr]) -> Equilibrium | None:
    """The equilibria in the position that the constraints hold: a drawer would fit askew. None if none is there."""

    waves = {str(f(q)): f(v) for q, v in held.items() for f in (sp.sin, sp.cos)}
    there = waves | {q.name: v for q, v in held.items()}

    def is_elsewhere(point: Mapping[sp.Symbol, sp.Expr]) -> bool:
        return any(s.name in there and is_zero(e - there[s.name]) is False for s, e in point.items())

    here = [n for n, b in enumerate(resting.branches) if not all(map(is_elsewhere, b.points))]
    if not here:
        return None
    idle = tuple(resting.idle[n] for n in here if n < len(resting.idle))
    solution = resting.solution
    left = tuple(b for b in solution.branches if not b.points or not all(map(is_elsewhere, b.points)))
    branches = tuple(resting.branches[n] for n in here)
    resting = replace(resting, branches=branches, idle=idle, solution=replace(solution, branches=left))
    return _stated_where_held(resting, held)


def _stated_where_held(resting: Equilibrium, held: Mapping[sp.Symbol, sp.Expr]) -> Equilibrium:
    """The equilibria in a position, without saying again that it is this one."""
    branches = tuple(_without_held(b, held) for b in resting.branches)
    at = [replace(c, expression=normalised(c.expression.xreplace(dict(held)))) for c in resting.conditions]
    conditions = tuple(c for c in at if c.expression != 0)
    laws = tuple(law.xreplace(dict(held)) for law in resting.laws)
    return replace(resting, conditions=conditions, laws=laws, branches=branches)


def _without_held(b: Branch, held: Mapping[sp.Symbol, sp.Expr]) -> Branch:
    """The branch with what it says beside the position that the constraints hold."""
    other = tuple(r for r in b.relations if r.lhs not in held or shortest(r.rhs - held[r.lhs]) != 0)
    return replace(b, relations=other or b.relations)


def _possible(
    resting: Equilibrium, contacts: Sequence[RoughContact], signs: Signs, values: Mapping[sp.Symbol, sp.Expr]
) -> Equilibrium:
    """The equilibria without those for parameters that have other signs: μ cos α + sin α = 0."""
    kept = [
        n
        for n, b in enumerate(resting.branches)
        if not (b.special and any(signs.of(r.residual) in (1, -1) for r in b.relations))
        and not any(r.lhs.is_positive and signs.of(r.rhs) in (0, -1) for r in b.relations)
    ]
    known = SolvedFor(coefficients=tuple(c.coefficient for c in contacts))
    branches = tuple(_limits_solved(resting.branches[n], resting, known, signs, values) for n in kept)
    idle = tuple(resting.idle[n] for n in kept if n < len(resting.idle))
    return replace(resting, branches=branches, idle=idle)


def _limits_solved(
    b: Branch, resting: Equilibrium, wanted: SolvedFor, signs: Signs, values: Mapping[sp.Symbol, sp.Expr]
) -> Branch:
    """The branch with its relations between parameters solved for a coefficient of friction, tan α = μ.

    Of values for all other letters, what has none is asked for: P = W (sin α + μ cos α)/(cos α − μ sin α).
    """
    b = _coefficients_solved(b, resting)
    if not b.special:
        oriented = (replace(r, rhs=_oriented(r.rhs, wanted.coefficients, signs)) for r in b.relations)
        return replace(b, relations=tuple(replace(r, rhs=with_differences_of_squares(r.rhs)) for r in oriented))
    relations = []
    for r in b.relations:
        written: tuple[RestCondition, ...] = ()
        letters = r.residual.free_symbols
        rough = [c for c in dict.fromkeys(wanted.coefficients) if c in letters]
        open_ = letters - {*values} if values and {*rough} <= {*values} else set()
        loads = {s for s in open_ if s.name[0] not in GIVEN_AS_A_RULE}
        for sought in ([*open_], [*loads], rough):  # what alone has no value, otherwise the coefficient
            letter = sought[0] if len(sought) == 1 < len(letters) else None
            limit = None if letter is None else value_of_letter(r.residual, letter, values, signs)
            if letter is not None and limit is not None:
                written = (RestCondition(limit, letter) if sought is rough else RestCondition(letter, limit),)
                break
        if not written and r.residual.free_symbols.isdisjoint(resting.solution.unknowns):
            written = tuple(not_negative(r.residual, wanted, signs))
        relations += [replace(r, lhs=c.left, rhs=c.right) for c in written] or [r]
    return replace(b, relations=tuple(relations))


def _oriented(e: sp.Expr, coefficients: Sequence[sp.Expr], signs: Signs) -> sp.Expr:
    """W (sin α − μ cos α)/(cos β − μ sin β), whose divisor is positive for little friction; else without a minus."""
    above, below = sp.fraction(e)
    if not below.is_Add or not any(term.could_extract_minus_sign() for term in below.args):
        return e
    smooth = signs.of(below.xreplace(dict.fromkeys(coefficients, sp.S.Zero)))
    turned = smooth == -1 if smooth else above.as_coeff_Mul()[0].is_negative
    return without_leading_minus(-above) / -below if turned else e


def _coefficients_solved(b: Branch, resting: Equilibrium) -> Branch:
    """The branch with the law of a belt solved for an unknown coefficient: μ = log(T_1/T_2)/β."""
    stated = {r.lhs: r.rhs for r in b.relations if r.lhs.is_Symbol}
    left, relations = [], list(b.relations)
    for e in b.left:
        limits = {s: solved_for_exponent(e.xreplace(stated), s) for s in resting.forces if s not in stated}
        solved = [Relation(s, limit.value) for s, limit in limits.items() if limit is not None]
        left += [] if solved else [e]
        relations += solved[:1]
    return replace(b, relations=tuple(relations), left=tuple(left))


def _solved_for_friction(b: Branch, contacts: Sequence[RoughContact]) -> Branch:
    """The branch with the one equation that is not solved for a position solved for the only coefficient of friction.

    It must be linear in it, and its other terms have a sign for acute angles.
    """
    rough = [c for c in dict.fromkeys(c.coefficient for c in contacts) if any(c in e.free_symbols for e in b.left)]
    if len(b.left) != 1 or len(rough) != 1 or not rough[0].is_Symbol:
        return b
    signs = Signs(b.left[0].free_symbols)
    value = value_of_letter(b.left[0], rough[0], {}, signs)
    if value is None:
        return b
    above, below = map(shortest, sp.fraction(value))
    limit = Relation(rough[0], _oriented(without_leading_minus(above / below), (), signs))
    return replace(b, relations=(*b.relations, limit), left=())


def _is_pulled_off(
    reactions: Sequence[tuple[Reaction, sp.Expr]], pressed: Mapping[sp.Symbol, sp.Expr], signs: Signs
) -> bool:
    """Whether one-sided constraints would have to pull, one of them or one of two."""
    needed = [pressed[r.force] * sense for r, sense in reactions]
    for n, force in enumerate(needed):
        if any((signs.assuming(shortest(other)) if other != 0 else signs).of(force) == -1 for other in needed[:n]):
            return True
    return any(signs.of(force) == -1 for force in needed)


def _where_pressed(
    resting: Equilibrium,
    contacts: Sequence[RoughContact],
    pressed: Mapping[sp.Symbol, sp.Expr],
    signs: Signs,
    values: Mapping[sp.Symbol, sp.Expr],
) -> Equilibrium:
    """The equilibria with the conditions on the parameters under which every normal force presses.

    The push P = W (sin α + μ cos α)/(cos α − μ sin α) up an incline needs N = W/(cos α − μ sin α) > 0: beyond that
    slope no push slides the block, and the formula is that of a force which would pull it off. Where several factors of
    N have unknown signs, no condition is stated: nobody would read the alternatives.
    """
    kept: list[tuple[int, Branch]] = []
    unknown = {*resting.solution.unknowns, *resting.forces}
    for n, b in enumerate(resting.branches):
        stated = {r.lhs: r.rhs for r in b.relations if r.lhs in resting.forces}
        forces = [shortest(((c.sign or 1) * pressed[c.reaction.force]).xreplace(stated)) for c in contacts]
        open_ = [f for f in forces if f.free_symbols.isdisjoint(unknown) and signs.of(f) is None]
        if any(x.is_number and sign_of(x) == -1 for x in (f.xreplace(dict(values)) for f in open_)):
            continue
        asked = [f for f in open_ if _open_factors(f, signs) == 1]
        try:
            further = conditions_for(asked, [positive_part(c) for c in b.conditions if c.relation in "<>"]) or ()
        except NeverPositiveError:
            continue
        kept.append((n, replace(b, conditions=(*b.conditions, *further)) if further else b))
    idle = tuple(resting.idle[n] for n, _ in kept if n < len(resting.idle))
    return replace(resting, branches=tuple(with_shortest_conditions([b for _, b in kept])), idle=idle)


def _open_factors(e: sp.Expr, signs: Signs) -> int:
    """How many factors of an expression have a sign that is not known."""
    return sum(signs.of(f.as_base_exp()[0]) is None for f in sp.Mul.make_args(sp.factor(e)))


def _sign_there(
    c: RoughContact,
    pressed: Mapping[sp.Symbol, sp.Expr],
    resting: Equilibrium,
    signs: Signs,
    values: Mapping[sp.Symbol, sp.Expr],
) -> int | None:
    """The sign of N, as `c` takes it, at all equilibria; None if it is not the same, or not known.

    Where letters leave it open, the values of the problem decide, with the unknown forces that the equilibrium gives.
    """
    force = (c.sign or 1) * pressed[c.reaction.force]
    signs_there = _signs_at(force, resting, signs)
    if None in signs_there and values:
        stated = [{r.lhs: r.rhs for r in b.relations if r.lhs.is_Symbol} for b in resting.branches]
        numbers = [force.xreplace(rule).xreplace(dict(values)) for rule in stated]
        signs_there = {sign_of(n) if n.is_number else None for n in numbers}
    return signs_there.pop() if len(signs_there) == 1 else None
