"""Impacts: velocities that change in an instant, by blows and by constraints that begin to act.

Integrated over the instant of an impact, in which the position does not change, Newton's law reads m Δv = Ĵ + R̂, with
the impulses Ĵ of the blows and R̂ of the reactions. Forces that stay finite, such as weights and springs, have none.
For all virtual displacements that the old and the new constraints A δq = 0 permit, the reactions do no work, and

    Σ (m Δv − Ĵ)·δr + Σ (ΔH − Ĝ)·δπ = 0 ,      that is      Nᵀ (M Δq' − Ĵ) = 0     where δq = N δq_I .

The velocities after the impact satisfy the old constraints, and the new ones with Newton's coefficient of restitution,

    A_old q' + a_t = 0 ,      A_new q' + a_t = −e (A_new q'_0 + a_t) ,

e = 0 where the constraint persists. With these velocities the impulses of the reactions follow from all coordinates,

    M Δq' = Ĵ + Aᵀ Λ ,

and the kinetic energy that is lost at a constraint is the work of its impulse on the mean of the velocities before and
after, −½ Λ A (q' + q'_0), which is −½ (1 − e) Λ A q'_0 (Thomson and Tait); for e = 0 and without blows the total is the
kinetic energy of the lost velocities (Carnot).

Reference: Routh, Elementary Rigid Dynamics, chs. 4, 8; Whittaker, § 97; Pars, Analytical Dynamics, ch. 14.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.shortest_form import without_leading_minus
from lagrange.algebra.exact.zero_test import Surface
from lagrange.algebra.fourier.linear_systems import solved_linear, tidy_quotient
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError, UndecidedError
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Slots, free_letter, prime, sign_in_range, velocity_before
from lagrange.mechanics.constraints.constrained_system import ConstrainedSystem, Row
from lagrange.mechanics.constraints.constraints import constraint_row
from lagrange.mechanics.constraints.coordinates import GeneralizedCoordinates, pulled_back
from lagrange.mechanics.constraints.displacements import Elimination, eliminate
from lagrange.mechanics.constraints.kinematics import Configuration, file_configuration, substituted_configuration
from lagrange.mechanics.dynamics.newton import Newton, Reaction, newton_equations
from lagrange.mechanics.dynamics.reactions import over_one_denominator
from lagrange.mechanics.limits import LONGEST_FACTORED
from lagrange.problem.model import Friction, Impact, InitialValue, Problem

ZERO, HALF = sp.S.Zero, sp.Rational(1, 2)


@record
class ReactionImpulse:
    """The impulse of the reaction of one constraint.

    symbol      in which it is written
    multiplier  Λ; None if the equations do not determine it
    value       of the force where the reaction is a single one, otherwise Λ; None likewise
    is_new      whether the constraint begins to act
    restitution e; 0 for old constraints
    lost        the kinetic energy that is lost there; None if Λ is not determined, or the constraints move
    """

    symbol: sp.Symbol
    reaction: Reaction
    multiplier: sp.Expr | None
    value: sp.Expr | None
    is_new: bool
    restitution: sp.Expr
    lost: sp.Expr | None

    @property
    def name(self) -> str:
        """The name of the constraint."""
        return self.reaction.name


@record
class Presupposition:
    """The presupposition of a one-sided constraint: `quantity` > 0, or ≥ 0 if it is an impulse."""

    constraint: str
    quantity: sp.Expr
    is_impulse: bool


@record
class ImpulsiveMotion:
    """An impact in one set of coordinates.

    coordinates    the choice, or the file's own
    full           the system in the file's coordinates, with the blows as its forces, under all constraints
    configuration  the same in these coordinates
    position       the coordinates that are known at the instant
    surface        where the remaining finite relations hold
    rows           all constraints in that position
    new            the names of those that begin to act
    before         shape (n,): the velocities just before
    elimination    the virtual displacements, and (as its drift) the velocities that all constraints impose
    balance        shape (n,): M (q' − q'_0) − Ĵ, the coefficients of the δq
    equations      shape (n − r,): the coefficients of the independent δq
    velocities     shape (n,): just after
    impulses       of the reactions
    conditions     of contact
    work           of the blows
    energy_lost    what the kinetic energy loses beyond the work of the blows
    kinetic        the kinetic energy before and after
    is_driven      whether time occurs in positions or constraints: a motor may do work too
    """

    coordinates: GeneralizedCoordinates
    full: Configuration
    configuration: Configuration
    position: Mapping[sp.Symbol, sp.Expr]
    surface: Surface
    rows: tuple[Row, ...]
    new: tuple[str, ...]
    before: tuple[sp.Expr, ...]
    elimination: Elimination
    balance: tuple[sp.Expr, ...]
    equations: tuple[sp.Expr, ...]
    velocities: tuple[sp.Expr, ...]
    impulses: tuple[ReactionImpulse, ...]
    conditions: tuple[Presupposition, ...]
    work: sp.Expr
    energy_lost: sp.Expr
    kinetic: tuple[sp.Expr, sp.Expr]
    is_driven: bool

    @property
    def slots(self) -> Slots:
        """The coordinates."""
        return self.configuration.slots

    @property
    def energy_gained(self) -> sp.Expr:
        """What the kinetic energy gains beyond the work of the blows."""
        return sp.expand(-self.energy_lost)

    @property
    def share_lost(self) -> sp.Expr | None:
        """The energy lost as a share of that before, where it is a function of the masses alone: M/(M + m)."""
        before = self.kinetic[0]
        if self.energy_lost == 0 or before == 0 or self.full.loads or self.full.torques:
            return None
        share = sp.factor(sp.cancel(self.energy_lost / before))
        return None if share.free_symbols & {*before.free_symbols} - self._masses else share

    @property
    def _masses(self) -> set[sp.Symbol]:
        return {s for p in self.full.points for s in p.mass.free_symbols}

    def at(self, expression: sp.Expr) -> sp.Expr:
        """An expression of the file's coordinates in these ones, in the position of the impact."""
        return self.configuration.rewritten(expression).xreplace(self.position)

    def after(self, expression: sp.Expr) -> sp.Expr:
        """An expression of coordinates and velocities, just after the impact."""
        return self.at(expression).xreplace(dict(zip(self.slots.velocities, self.velocities, strict=True)))

    def just_before(self, expression: sp.Expr) -> sp.Expr:
        """An expression of coordinates and velocities, just before the impact."""
        return self.at(expression).xreplace(dict(zip(self.slots.velocities, self.before, strict=True)))

    @property
    def all_velocities(self) -> dict[sp.Symbol, sp.Expr]:
        """The velocities just after, of these coordinates and then of those that they replace."""
        velocities = dict(zip(self.slots.coordinates, self.velocities, strict=True))
        others = [q for q in self.full.slots.coordinates if q not in velocities]
        return velocities | {q: _tidy(self.after(prime(q))) for q in others}

    @property
    def open_impulses(self) -> tuple[str, ...]:
        """The names of constraints whose impulses are not determined."""
        return tuple(i.name for i in self.impulses if i.value is None)


def impulsive_motion(problem: Problem, choices: Sequence[GeneralizedCoordinates], own: GeneralizedCoordinates,
                     taken: frozenset[str]) -> ImpulsiveMotion:  # fmt: skip
    """The impact that a problem describes, in the first choice that knows the given state, or the file's coordinates.

    taken  names that the letters of impulses must not use

    Raises NotCoveredError if it cannot be treated, ProblemError where the state before contradicts the constraints.
    """
    impact = problem.impact
    assert impact is not None  # asked for only where the file has one
    full = _during(problem, impact)
    coordinates = _chosen([*choices, own], full, impact.before)
    configuration = _in(coordinates, full)
    position, surface = _position(configuration, impact)
    rows = tuple(_at_position(r, position) for r in configuration.rows)
    new = tuple(c.name for c in impact.constraints)
    before = _before(configuration, impact, [r for r in rows if r.name not in new], position, surface)
    restitution = {c.name: impact.restitution.get(c.name, ZERO) for c in impact.constraints}
    after = [_with_restitution(r, before, restitution.get(r.name, ZERO)) if r.name in new else r for r in rows]
    elimination = eliminate(after, len(before), surface)
    n = len(before)
    shape = elimination.shape(n)
    imposed = [ZERO] * n
    for k, rate in zip(elimination.dependent, elimination.drift, strict=True):
        imposed[k] = rate
    _check_consistent([after[r] for r in elimination.unused], imposed, surface, impact)
    mass = [[textbook_form(e.xreplace(position)) for e in row] for row in mass_matrix(configuration)]
    blows = [textbook_form(e.xreplace(position)) for e in generalized_impulses(configuration)]
    velocities = _velocities(mass, blows, before, imposed, elimination, surface)
    slots = configuration.slots
    changes = [sp.Add(*(m * (v - b) for m, v, b in zip(row, slots.velocities, before, strict=True))) for row in mass]
    balance = tuple(_sum(c - j) for c, j in zip(changes, blows, strict=True))
    equations = tuple(
        _sum(sp.Add(*(shape[k][j] * balance[k] for k in range(n)))) for j in range(len(elimination.independent))
    )
    still = dict.fromkeys(slots.velocities, ZERO)
    speeds = [*(p.velocity for p in configuration.points), *(r.angular_velocity for r in configuration.rotations)]
    carried = any(c.xreplace(still) != 0 for v in speeds for c in v.components)
    is_driven = carried or any(r.drift != 0 for r in rows)
    motion = ImpulsiveMotion(
        coordinates, full, configuration, position, surface, rows, new, before, elimination, balance, equations,
        velocities, (), (), ZERO, ZERO, (ZERO, ZERO), is_driven,
    )  # fmt: skip
    motion = replace(motion, impulses=tuple(_impulses(motion, problem, impact, restitution, taken)))
    motion = replace(motion, conditions=tuple(_conditions(motion)))
    return _with_energies(motion, mass, blows)


def mass_matrix(configuration: Configuration) -> list[list[sp.Expr]]:
    """M, shape (n, n): Σ m ∂r/∂q_k·∂r/∂q_l + Σ I ω_k·ω_l."""
    size = range(len(configuration.slots.coordinates))
    rows = []
    for k in size:
        row = []
        for n in size:
            terms = [p.mass * p.partials[k].dot(p.partials[n]) for p in configuration.points if p.mass != 0]
            for r in configuration.rotations:
                terms.append(r.inertia.form(r.partials[k].components, r.partials[n].components))
            row.append(sp.Add(*terms))
        rows.append(row)
    return rows


def generalized_impulses(configuration: Configuration) -> list[sp.Expr]:
    """Ĵ_k, shape (n,), of the blows: on a body at its mass centre, with their moments about it."""
    points = {p.name: p for p in configuration.points}
    turning = {r.name: r for r in configuration.rotations}
    total = []
    for k, q in enumerate(configuration.slots.coordinates):
        terms = []
        for load in configuration.loads:
            if load.on in turning:
                arm = load.point - points[load.on].position
                terms.append(load.vector.dot(points[load.on].partials[k]))
                terms.append(arm.cross(load.vector).dot(turning[load.on].partials[k]))
            else:
                terms.append(load.vector.dot(load.point.partial(q)))
        terms += [m.vector.dot(turning[m.on].partials[k]) for m in configuration.torques]
        total.append(sp.Add(*terms))
    return total


# -- the system during the impact --------------------------------------------------------------------------------------


def _during(problem: Problem, impact: Impact) -> Configuration:
    """The system with the blows for forces, under the old and the new constraints."""
    rough = [f for f in problem.forces if isinstance(f, Friction)]
    if rough:
        raise NotCoveredError(f"an impact with dry friction, `{rough[0].name}`,", rough[0].span)
    if problem.unknowns:
        raise NotCoveredError("an impact with unknown forces")
    constraints = (*problem.constraints, *impact.constraints)
    rows = tuple(constraint_row(c, problem.slots) for c in constraints)
    for row, constraint in zip(rows, constraints, strict=True):
        if row.nonlinear is not None:
            what = f"an impact under `{constraint.name}`, which is not linear in the velocities,"
            raise NotCoveredError(what, constraint.span)
    struck = replace(problem, forces=impact.impulses, gravity=None, constraints=constraints)
    return file_configuration(struck, ConstrainedSystem(problem.slots, rows))


def _chosen(
    views: Sequence[GeneralizedCoordinates], full: Configuration, before: Sequence[InitialValue]
) -> GeneralizedCoordinates:
    """The first set of coordinates without roots in which everything given about the state before is known."""
    for view in views:
        slots, old = view.configuration.slots, full.slots
        known = {*slots.coordinates, *slots.velocities, *(prime(q) for q in view.configuration.expressed)}
        if not view.signs and not view.through_rates and all(v.symbol in known for v in before):
            return view
    unknown = next((v for v in before if v.symbol not in {*full.slots.coordinates, *full.slots.velocities}), before[0])
    message = f"no set of coordinates knows both `{unknown.symbol}` and the rest of the state before the impact"
    help_ = (
        f"give the state in the coordinates {', '.join(f'`{q}`' for q in old.coordinates)}, or in those of one choice"
    )
    raise ProblemError(Diagnostic("no-state", message, unknown.span, help=help_))


def _in(view: GeneralizedCoordinates, full: Configuration) -> Configuration:
    """The system in the coordinates of a choice, under the constraints that it does not satisfy by itself."""
    if not view.configuration.name:
        return full
    expressed, slots = view.configuration.expressed, view.configuration.slots
    old = full.slots.coordinates
    rows = tuple(
        pulled_back(r, old, expressed, view.jacobian, slots) for r in full.rows if r.name not in view.satisfied
    )
    return substituted_configuration(full, view.configuration.name, slots.coordinates, expressed, rows)


def _position(configuration: Configuration, impact: Impact) -> tuple[dict[sp.Symbol, sp.Expr], Surface]:
    """The coordinates that are given or follow from a finite relation linear in them, and what is left of these."""
    coordinates = configuration.slots.coordinates
    position = {v.symbol: v.value for v in impact.before if v.symbol in coordinates}
    left: list[sp.Expr] = []
    for row in reversed(configuration.rows):  # the new constraints first
        if row.finite is None:
            continue
        relation = row.finite.xreplace(position)
        used = [q for q in coordinates if relation.has(q)]
        if not used:
            _check_position(row, relation, impact)
            continue
        solved = next((q for q in used if relation.diff(q).is_number), None)
        if solved is None:
            left.append(relation)
            continue
        value = {solved: sp.expand(solved - relation / relation.diff(solved))}
        position = {q: e.xreplace(value) for q, e in position.items()} | value
        left = [e.xreplace(value) for e in left]
    kept = [e for e in left if any(e.has(q) for q in coordinates)]
    return position, Surface(kept, [q for q in coordinates if q not in position])


def _check_position(row: Row, relation: sp.Expr, impact: Impact) -> None:
    """Raises ProblemError if the given position does not satisfy a constraint."""
    if Surface().is_zero(relation) is True:
        return
    span = next((c.span for c in impact.constraints if c.name == row.name), impact.span)
    message = f"the position given in `before` does not satisfy the constraint `{row.name}`"
    help_ = "all constraints hold at the instant of the impact; correct the position, or leave out a coordinate"
    raise ProblemError(Diagnostic("contradictory-state", message, span, help=help_))


def _at_position(row: Row, position: Mapping[sp.Symbol, sp.Expr]) -> Row:
    coefficients = tuple(textbook_form(a.xreplace(position)) for a in row.coefficients)
    finite = None if row.finite is None else row.finite.xreplace(position)
    return replace(row, coefficients=coefficients, drift=textbook_form(row.drift.xreplace(position)), finite=finite)


def _before(
    configuration: Configuration,
    impact: Impact,
    old: Sequence[Row],
    position: Mapping[sp.Symbol, sp.Expr],
    surface: Surface,
) -> tuple[sp.Expr, ...]:
    """q'_0, shape (n,): the given velocities, and the rest as free as the old constraints allow."""
    slots = configuration.slots
    still = dict.fromkeys(slots.velocities, ZERO)
    given = []
    for value in impact.before:
        if value.symbol in slots.coordinates:
            continue
        speed = configuration.rewritten(value.symbol).xreplace(position)
        coefficients = tuple(textbook_form(speed.diff(v)) for v in slots.velocities)
        given.append(Row(str(value.symbol), coefficients, textbook_form(speed.xreplace(still) - value.value)))
    rows = [*given, *old]
    solved = eliminate(rows, len(slots.coordinates), surface)
    free = [velocity_before(q) for q in slots.coordinates]
    before = list(free)
    for k, row, rate in zip(solved.dependent, solved.solution, solved.drift, strict=True):
        before[k] = _tidy(sp.Add(rate, *(c * free[j] for c, j in zip(row, solved.independent, strict=True))))
    for r in solved.unused:
        if _residual(rows[r], before, surface) is not True:
            what = f"the velocity `{rows[r].name}`" if r < len(given) else f"the constraint `{rows[r].name}`"
            message = f"the velocities before the impact contradict {what}"
            span = next((v.span for v in impact.before if str(v.symbol) == rows[r].name), impact.span)
            help_ = "the constraints of the file hold before the impact too; correct a velocity, or leave it out"
            raise ProblemError(Diagnostic("contradictory-state", message, span, help=help_))
    return tuple(before)


def _residual(row: Row, velocities: Sequence[sp.Expr], surface: Surface) -> bool | None:
    return surface.is_zero(sp.Add(row.drift, *(a * v for a, v in zip(row.coefficients, velocities, strict=True))))


def _with_restitution(row: Row, before: Sequence[sp.Expr], restitution: sp.Expr) -> Row:
    """The row whose drift is that of the velocities after: A q' + a_t + e (A q'_0 + a_t) = 0."""
    approach = sp.Add(row.drift, *(a * v for a, v in zip(row.coefficients, before, strict=True)))
    return row if restitution == 0 else replace(row, drift=_sum(row.drift + restitution * approach))


def _check_consistent(
    unused: Sequence[Row],
    imposed: Sequence[sp.Expr],
    surface: Surface,
    impact: Impact,
) -> None:
    """Raises where a redundant constraint asks for another velocity than those that it follows from."""
    for row in unused:
        holds = _residual(row, imposed, surface)
        if holds is None:
            raise UndecidedError(
                f"whether `{row.name}` agrees with the other constraints after the impact", impact.span
            )
        if holds is False:
            message = (
                f"`{row.name}` depends on the other constraints, and they give it another velocity after the impact"
            )
            span = next((c.span for c in impact.constraints if c.name == row.name), impact.span)
            help_ = "leave the constraint out, or give dependent constraints the same coefficient of restitution"
            raise ProblemError(Diagnostic("contradictory-impact", message, span, help=help_))


# -- its solution ------------------------------------------------------------------------------------------------------


def _velocities(
    mass: Sequence[Sequence[sp.Expr]],
    blows: Sequence[sp.Expr],
    before: Sequence[sp.Expr],
    imposed: Sequence[sp.Expr],
    elimination: Elimination,
    surface: Surface,
) -> tuple[sp.Expr, ...]:
    """q' = N q'_I + d, from Nᵀ M N q'_I = Nᵀ (Ĵ + M (q'_0 − d))."""
    n = len(before)
    shape = elimination.shape(n)
    size = range(len(elimination.independent))
    push = [
        sp.Add(blows[k], *(m * (b - d) for m, b, d in zip(mass[k], before, imposed, strict=True))) for k in range(n)
    ]
    moved = [[sp.Add(*(mass[k][m] * shape[m][j] for m in range(n))) for j in size] for k in range(n)]
    reduced = [[sp.Add(*(shape[k][i] * moved[k][j] for k in range(n))) for j in size] for i in size]
    right = [sp.Add(*(shape[k][i] * push[k] for k in range(n))) for i in size]
    free = solved_linear(reduced, right, surface) if reduced else []
    if free is None:
        raise NotCoveredError("an impact whose velocities are too long to be written")
    if None in free:
        raise NotCoveredError(
            "an impact after which a velocity is not determined, since nothing with mass moves with it,"
        )
    return tuple(
        _tidy(sp.Add(imposed[k], *(shape[k][j] * v for j, v in enumerate(free) if v is not None))) for k in range(n)
    )


def _impulses(
    motion: ImpulsiveMotion,
    problem: Problem,
    impact: Impact,
    restitution: Mapping[str, sp.Expr],
    taken: frozenset[str],
) -> Iterator[ReactionImpulse]:
    """Λ from the equations of all coordinates of the file, M Δq' − Ĵ = Aᵀ Λ, and the forces that they belong to."""
    full, surface = motion.full, motion.surface
    constraints = (*problem.constraints, *impact.constraints)
    if not constraints:
        return
    newton = reactions_of(full, problem, impact)
    slots = full.slots
    speeds = [(_tidy(motion.after(v)), _tidy(motion.just_before(v))) for v in slots.velocities]
    mass = [[motion.at(e) for e in row] for row in mass_matrix(full)]
    blows = [motion.at(e) for e in generalized_impulses(full)]
    right = [
        _tidy(sp.Add(-j, *(m * (a - b) for m, (a, b) in zip(row, speeds, strict=True))))
        for row, j in zip(mass, blows, strict=True)
    ]
    forms = [[textbook_form(motion.at(a)) for a in r.coefficients] for r in full.rows]
    columns = [[form[k] for form in forms] for k in range(len(slots.coordinates))]
    multipliers = solved_linear(columns, right, surface) or [None] * len(constraints)
    names = [r.name.replace(".", "_") for r in newton.reactions]
    letter = free_letter("S", "J", "P", "Imp", taken=taken, of=names)
    for r, name, form, value in zip(newton.reactions, names, forms, multipliers, strict=True):
        is_new = r.name in motion.new
        force, lost = None, None
        if value is not None:
            factor = r.single.factor if r.single is not None else sp.S.One
            force = _tidy(motion.at(factor) * value)
            if not motion.is_driven:
                lost = _tidy(-HALF * value * sp.Add(*(a * (u + b) for a, (u, b) in zip(form, speeds, strict=True))))
        given = r.constraint.reaction if is_new and r.constraint.reaction != r.row.multiplier else None
        symbol = given or sp.Symbol(f"{letter}_{name}", real=True)
        yield ReactionImpulse(symbol, r, value, force, is_new, restitution.get(r.name, ZERO), lost)


def reactions_of(full: Configuration, problem: Problem, impact: Impact) -> Newton:
    """The reactions during the impact, and Newton's law for each free body."""
    constraints = (*problem.constraints, *impact.constraints)
    return newton_equations(full, constraints, 0, frozenset(problem.scope.names()))


def _conditions(motion: ImpulsiveMotion) -> Iterator[Presupposition]:
    """What one-sided constraints require: new ones are approached, and no impulse pulls. Raises ProblemError."""
    sides = {i.name: i.reaction.constraint.side for i in motion.impulses}
    spans = {i.name: i.reaction.constraint.span for i in motion.impulses}
    for impulse in motion.impulses:
        side = sides[impulse.name]
        if side is None:
            continue
        row = next(r for r in motion.full.rows if r.name == impulse.name)
        if impulse.is_new:
            approach = _tidy(-side * motion.just_before(row.velocity_form(motion.full.slots)))
            if approach != 0 and _is_positive(-approach):
                message = f"nothing approaches `{impulse.name}` before the impact: {-approach} is its rate"
                help_ = "correct the velocities under `before`, or leave out the constraint"
                raise ProblemError(Diagnostic("contradictory-impact", message, spans[impulse.name], help=help_))
            if not _is_positive(approach) and approach != 0:
                yield Presupposition(impulse.name, approach, False)
        push = None if impulse.multiplier is None else _tidy(side * impulse.multiplier)
        if push is not None and push != 0 and _is_positive(-push):
            message = f"the impulse of `{impulse.name}` would have to pull: the contact ends in the impact"
            help_ = "leave the constraint out of this impact"
            raise ProblemError(Diagnostic("contradictory-impact", message, spans[impulse.name], help=help_))
        if push is not None and push != 0 and not _is_positive(push):
            yield Presupposition(impulse.name, push, True)


def _is_positive(expression: sp.Expr) -> bool:
    """Whether it is positive for all values of the parameters, or never negative."""
    signs = []
    for f in sp.Mul.make_args(sp.factor(expression)):
        signs.append(1 if f.is_nonnegative else -1 if f.is_nonpositive else sign_in_range(f))
    return None not in signs and sp.prod([s for s in signs if s is not None]) > 0


def _with_energies(
    motion: ImpulsiveMotion, mass: Sequence[Sequence[sp.Expr]], blows: Sequence[sp.Expr]
) -> ImpulsiveMotion:
    """The work of the blows, the energy lost, the kinetic energy before and after."""
    means = [HALF * (u + b) for u, b in zip(motion.velocities, motion.before, strict=True)]
    work = _tidy(sp.Add(*(j * v for j, v in zip(blows, means, strict=True))))
    if motion.is_driven:
        from lagrange.mechanics.dynamics.lagrangian import kinetic_energy

        energy = kinetic_energy(motion.configuration)
        before, after = _tidy(motion.just_before(energy)), _tidy(motion.after(energy))
        return replace(motion, work=work, energy_lost=_tidy(before - after), kinetic=(before, after))

    def kinetic(velocities: Sequence[sp.Expr]) -> sp.Expr:
        size = range(len(velocities))
        return _tidy(sp.Add(*(HALF * mass[k][n] * velocities[k] * velocities[n] for k in size for n in size)))

    before, after = kinetic(motion.before), kinetic(motion.velocities)
    parts = [i.lost for i in motion.impulses]
    lost = sp.Add(*(p for p in parts if p is not None)) if None not in parts else before - after + work
    return replace(motion, work=work, energy_lost=_tidy(lost), kinetic=(before, after))


def _tidy(expression: sp.Expr) -> sp.Expr:
    """A quotient in lowest terms, over one denominator, in factors where that is shorter."""
    tidied = over_one_denominator(tidy_quotient(expression))
    if tidied.is_Atom or count_operations(tidied) > LONGEST_FACTORED or tidied.atoms(sp.Function):
        return tidied
    factors = sp.factor(tidied)
    nested = any(a.is_Pow and a.exp.is_negative for b in tidied.atoms(sp.Add) for a in sp.preorder_traversal(b))
    return without_leading_minus(factors) if nested or count_operations(factors) <= count_operations(tidied) else tidied


def _sum(expression: sp.Expr) -> sp.Expr:
    """A sum in textbook form."""
    return textbook_form(expression)
