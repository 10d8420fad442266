"""Answers to the questions of a file.

A question asks for a quantity at the state in which its conditions hold, or as a function of one coordinate or of t.
The routes are tried in this order, in each set of coordinates that has all that the question mentions:

    the state       the conditions give position and velocity: accelerations and reactions follow from these
    integrals       first integrals with their values at t = 0, the constraints and the conditions determine it
    solution        the equations of motion have a solution in closed form, and the conditions determine t
    quadrature      t = ∫ dq/q', where q' is known from an integral
    orbit           round a centre, r is a known function of the angle
    numbers         with values for all parameters: the first time at which the conditions hold

All but the last are exact; `rest` has questions about a system at rest.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import ProblemError
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.questions import arrivals, numerical, ranges
from lagrange.mechanics.questions.branches import InitialMotion, first_branches, outright, sign_of_value
from lagrange.mechanics.questions.closed_motions import ClosedMotion, closed_motions, power_drag
from lagrange.mechanics.questions.elimination import Eliminated, eliminated
from lagrange.mechanics.questions.forms import given_state, shown, under, under_one_root
from lagrange.mechanics.questions.integrals_of_motion import multiple_of_integral, parameter_of_integral
from lagrange.mechanics.questions.orbits import orbit
from lagrange.mechanics.questions.quadrature import (
    not_elementary,
    speed_stated,
    taken_between_speeds,
    time_between,
    toward,
)
from lagrange.mechanics.questions.reach import approach, initial_motion, kept_senses, place_stated
from lagrange.mechanics.questions.results import AnswerBranch, Asked, How, Reason, Route, Substituted, UsedIntegral
from lagrange.mechanics.questions.setting import Setting, all_coordinates, completed, mentioned, reduced
from lagrange.mechanics.questions.states import (
    Meanings,
    MotionView,
    SymbolValues,
    initial_state,
    meanings_at,
    places_stated,
    without,
)
from lagrange.mechanics.questions.times import TimeRoot, after_start, in_order, keeps_sign, times
from lagrange.problem.model import Condition, Problem, Question


def answers_to_questions(
    problem: Problem, places: Sequence[MotionView], configurations: Sequence[Configuration]
) -> tuple[Asked, ...]:
    """The answers to all questions.

    places          in the order in which they are tried
    configurations  all sets of coordinates

    Raises ProblemError if the initial state contradicts the constraints, where a condition never holds, and where
    nothing determines the quantity.
    """
    settings = [Setting(place, problem, initial_state(place, problem, configurations)) for place in places]
    return tuple(_answer(q, settings) for q in problem.questions)


def _answer(question: Question, settings: Sequence[Setting]) -> Asked:
    """The first answer that is found. Raises ProblemError."""
    tried: list[Asked] = []
    coordinates = tuple(dict.fromkeys(q for s in settings for q in all_coordinates(s.place.configuration)))
    for setting in settings:
        if not setting.place.knows(mentioned(question), coordinates):
            continue
        if question.by is not None and question.by not in (t, *setting.place.configuration.slots.coordinates):
            continue
        asked = _with_either_sense(question, setting)
        if asked.answered:
            if asked.excluded_by(setting.values, {t, *coordinates}):
                raise ProblemError(ranges.never_holds(question))
            asked = ranges.in_bounds(asked.within(setting.values, {t, *coordinates}))
            return under(setting.known.starting, asked)
        tried.append(asked)
    if not tried:
        raise ProblemError(ranges.mixed(question))
    return tried[0]


def _with_either_sense(question: Question, setting: Setting) -> Asked:
    """The answer; where there is none, with the opposite sense of a force that is compared with the normal force.

    μ_s in F = μ_s N compares sizes, and the sense in which F is counted is that of the equation in the file.
    """
    try:
        return _Search(question, setting).answer()
    except ProblemError as error:
        for force in setting.of_either_sense(question):
            try:
                asked = _Search(question, setting, force).answer()
            except ProblemError:
                continue
            if asked.answered:
                return replace(asked, opposite=force)
        raise error


class _Search:
    """The search for the answer to one question in one set of coordinates."""

    def __init__(self, question: Question, setting: Setting, opposite: sp.Symbol | None = None) -> None:
        self.question = question
        self.opposite = opposite
        self.setting = setting
        self.place = setting.place
        self.configuration = setting.place.configuration
        self.slots = self.configuration.slots
        self.known = self._meanings()
        quantity = self._applied(question.quantity)
        self.quantity = quantity.xreplace({t: sp.S.Zero}) if self._is_at_start else quantity
        self.conditions = tuple((self._applied(c.lhs), self._applied(c.rhs)) for c in question.when)
        self.when = [a - b for a, b in self.conditions]
        self.used = tuple(self._used())
        parameters = {p.symbol for p in setting.problem.parameters} | {*setting.problem.unknowns}
        of_system: set[sp.Symbol] = set().union(*(e.free_symbols for e in setting.known.accelerations.values()))
        # Of l ω_0 it is ω_0 that is asked for, which the system itself does not have:
        of_quantity = sorted(question.quantity.free_symbols & parameters, key=lambda s: (s in of_system, s.name))
        only_parameters = question.quantity.free_symbols <= parameters
        self.parameter = of_quantity[0] if only_parameters else None
        occurring = [q for q in self.slots.coordinates if any(q in e.free_symbols for e in (self.quantity, *self.when))]
        rather_not = {*mentioned(question), *occurring, *map(prime, occurring)}
        self.rule = setting.dependent(rather_not, question.by)
        self.kept_senses = kept_senses(self.when, setting)
        self.adapted = setting.adapted([e.xreplace(self.rule) for e in self.when]) if self.parameter is None else None

    def _meanings(self) -> Meanings:
        """The meanings; what is too large in general is solved with what is fixed, or at the initial state."""
        setting, known = self.setting, self.setting.known
        names = mentioned(self.question)
        missing = {a for a in self.slots.accelerations if a not in known.accelerations} & names
        if missing or any(known.unknown(s) for s in names):
            where = {**setting.fixed, **places_stated(self.question, self.slots)}
            known = meanings_at(self.place, known, setting.initial if self._is_at_start else where)
        if self.opposite is None:
            return known
        value = known.reactions.get(self.opposite)
        return replace(known, reactions={**known.reactions, self.opposite: None if value is None else -value})

    def _applied(self, e: sp.Expr) -> sp.Expr:
        return self.known.applied(self.configuration.rewritten(e))

    def _used(self) -> Iterator[Substituted]:
        """The reactions, accelerations and energies that the question mentions."""
        known = self.known
        for s in sorted(mentioned(self.question), key=str):
            if s in known.reactions or s in known.energies or s.name.endswith("''"):
                value = self._applied(s)
                if value != s:
                    yield Substituted(s, value)

    def answer(self) -> Asked:
        """The answer, or the partial results towards it. Raises ProblemError if there are none."""
        named = (self.question.quantity, *(c.function for c in self.question.when))
        if self.setting.known.held:
            what = "is about a motion that does not begin: friction holds it at rest"
            raise ProblemError(ranges.slip_has_ended(self.question, what))
        self.setting.refuse_rolling(self.question)
        if self._beginning_of_slip is None:
            raise ProblemError(
                ranges.slip_has_ended(self.question, "asks for slip that does not begin: friction prevents it")
            )
        if any(self.known.unknown(e) for e in named) or self._lacks_accelerations():
            return self._asked(Route.STATE)
        free: frozenset[sp.Symbol] = frozenset()
        if self._is_about_time and not self._is_at_start:
            asked = self._in_time() or self._by_quadrature()
            if asked is not None:
                return asked if asked.answered else self._in_numbers() or asked
        elif self.question.by is None and (constant := self._constant()) is not None:
            return constant
        is_of_state = self.question.by is not None or self.setting.is_of_state(self.quantity, self.when)
        if self.question.by != t and is_of_state:
            for route, used in (
                (Route.STATE, []),
                *((Route.INTEGRALS, u) for u in self.setting.finite_integrals(self.when)),
            ):
                elimination = self._eliminated(used)
                if elimination.never:
                    raise ProblemError(ranges.never_holds(self.question, outright=route is Route.STATE))
                if elimination.branches and elimination.solved and not elimination.free:
                    return self._chosen(route, elimination, used)
                free = elimination.free
            asked = None if self._is_about_time else self._in_time() or self._by_speed() or self._on_orbit()
            if asked is not None:
                return asked
        if not self.question.when and self.question.by is None and self.parameter is None:
            raise ProblemError(ranges.changes(self.question))
        if free and self.setting.not_given:
            raise ProblemError(ranges.not_determined(self.question, free, self.setting.not_given))
        return self._in_numbers() or self._asked(Route.INTEGRALS, free=free)

    def _lacks_accelerations(self) -> bool:
        return any(e.free_symbols & {*self.slots.accelerations} for e in (self.quantity, *self.when))

    def _in_numbers(self) -> Asked | None:
        """The answer at the first time at which the condition holds, in numbers; None where values are missing."""
        if not self._has_numbers:
            return None
        stated = self.question.when[0].function, self.question.quantity
        if (value := numerical.first_from_equilibrium(self.setting, *stated, self._along)) is not None:
            return replace(self._in_digits(value), integrals=tuple(self.setting.integrals), mirrored=True)
        if not numerical.is_available():
            return replace(self._asked(Route.NUMBERS), needs=numerical.EXTRA)
        value = numerical.first_of_motion(self.setting, self.when[0], self.quantity)
        return None if value is None else self._in_digits(value)

    def _in_digits(self, value: float) -> Asked:
        branch = AnswerBranch(self.question.quantity, sp.Float(value, 6), (sp.Float(value, 6),))
        return replace(self._asked(Route.NUMBERS, How.NUMERICAL, ()), branches=(branch,), verified=None)

    def _along(self, q: sp.Symbol, e: sp.Expr) -> Sequence[AnswerBranch]:
        """An expression as a function of one coordinate alone, by the integrals."""
        try:
            return _Search(replace(self.question, quantity=e, when=(), by=q), self.setting).answer().branches
        except ProblemError:
            return ()

    @property
    def _has_numbers(self) -> bool:
        """Whether the motion can be integrated in numbers up to the condition."""
        return len(self.when) == 1 and self.setting.has_numbers([self.quantity, *self.when])

    def _constant(self) -> Asked | None:
        """The answer where an integral alone gives it: its multiple, or a parameter in its value."""
        question, integrals, moving = self.question, self.setting.integrals, {*self.place.moving}
        if question.when:
            found = parameter_of_integral(self.when, self.parameter, question.quantity, integrals, moving)
        else:
            found = multiple_of_integral(self.quantity, question.quantity, integrals, moving)
        if found is None:
            return None
        asked = self._asked(Route.INTEGRALS, How.EXACT, [found.integral])
        return replace(asked, branches=tuple(map(shown, found.branches)), verified=found.verified)

    @property
    def _is_about_time(self) -> bool:
        """Whether the question mentions t, or asks for a function of it."""
        return self.question.by == t or any(t in e.free_symbols for e in (self.quantity, *self.when))

    def _eliminated(self, used: Sequence[UsedIntegral]) -> Eliminated:
        """The quantity from the integrals, the constraints and the conditions."""
        configuration = self.configuration
        rates = [r.velocity_form(self.slots) for r in configuration.rows]
        start = [s - v for s, v in self.setting.initial.items()] if self._is_at_start else []
        equations = [*(i.expression - i.value for i in used), *configuration.finite_constraints, *rates]
        equations = reduced([*equations, *start, *self.when], self.rule)
        moving = {*self.slots.velocities, *self.slots.coordinates}
        unknowns = [s for s in self.place.moving if s != self.question.by and s not in self.rule]
        unknowns.sort(key=lambda s: s not in self.slots.velocities)
        unknowns += [s for s in (self.parameter, self.adapted) if s is not None]
        velocities = [v for v in self.slots.velocities if v in unknowns]
        quantity = self.quantity.xreplace(self.rule)
        elimination = eliminated(equations, quantity, unknowns, velocities, self.question.quantity)
        if not self.rule:
            return elimination
        states = [tuple(completed(s, self.rule, moving) for s in b.states) for b in elimination.branches]
        branches = tuple(replace(b, states=s) for b, s in zip(elimination.branches, states, strict=True))
        return replace(elimination, branches=branches)

    @property
    def _is_at_start(self) -> bool:
        """Whether the question is about the initial state: `when: t = 0`."""
        return any(c.function in (t, -t) for c in self.question.when)

    def _chosen(self, route: Route, elimination: Eliminated, used: Sequence[UsedIntegral]) -> Asked:
        reached = outright(self.when, self.slots.coordinates)
        quantity = self.question.quantity if self.parameter is not None else self.quantity
        signed = [b for b in elimination.branches if not ranges.has_wrong_sign(b, self.adapted)]
        signed = [b for b in signed if not ranges.is_lifted(b, self.question, self.place.law, self.known.reactions)]
        inside = (ranges.in_ranges(b, self.configuration, self.setting.values) for b in signed)
        elimination = replace(elimination, branches=tuple(b for b in inside if b is not None))
        parted = [self._with_stated_slip(b) for b in elimination.branches]
        lasting = [b for b in parted if b is not None]
        against = [b for b, kept in zip(elimination.branches, parted, strict=True) if kept is None]
        chosen = first_branches(lasting, replace(self._beginning, values={}), reached, self.question.by, quantity)
        possible = [b for b in chosen.branches if not b.excluded_by(self.setting.values)]
        if len(possible) > 1 or any(len(b.values) > 1 for b in possible):  # two branches, or cos θ = c of ±θ
            chosen = first_branches(lasting, self._beginning, reached, self.question.by, quantity)
        if against and all(self._beginning.is_initial(s) for b in chosen.branches for s in b.states):
            return self._after_turning(route, used)
        branches = list(chosen.branches)
        if self.question.by is None and self.setting.initial and not self._is_at_start:
            asked = (tuple(self.when), self.parameter, self.quantity, self.question)
            on_the_way = arrivals.Arrivals(self.setting, self._beginning, self.rule, *asked)
            branches = on_the_way.reached(branches) or on_the_way.at_the_start(lasting)
        if not branches:
            raise ProblemError(ranges.never_holds(self.question))
        if self._is_at_start:
            begins = dict.fromkeys(self._beginning_of_slip or ())
            branches = [replace(b, conditions=tuple({**dict.fromkeys(b.conditions), **begins})) for b in branches]
        if self.setting.stated_slips:
            branches = [replace(b, provided=True) if self._slip_is_open(b) else b for b in branches]
        if branches and all(b.provided for b in branches):
            branches = self._confirmed_in_time(branches)
        later: list[AnswerBranch] = []
        if len(branches) > 1 and self.question.by is None and self._has_numbers and numerical.is_available():
            first = numerical.first_of_motion(self.setting, self.when[0], self.quantity)
            branches, later = numerical.those_with(branches, first, self.setting.values)
        if self.question.by is not None:
            branches = [b.where_reached() for b in branches]
        dropped = (*((b, Reason.SENSE) for b in against), *chosen.dropped, *((b, Reason.LATER) for b in later))
        return replace(
            self._asked(route, How.EXACT, used),
            branches=tuple(shown(b) for b in branches),
            dropped=tuple((shown(b), why) for b, why in dropped),
            mirrored=chosen.mirrored,
            verified=elimination.verified,
        )

    def _confirmed_in_time(self, branches: list[AnswerBranch]) -> list[AnswerBranch]:
        """The branch without a doubt to whose value the solution in time comes; all where none is seen to be that."""
        asked = self._in_time() if self.parameter is None else None
        found = asked.branches if asked is not None else ()
        for b, other in product(branches, found if len(found) == 1 else ()):
            if len(b.values) == 1 and is_zero(sp.expand_log(other.values[0] - b.values[0])) is True:
                conditions = tuple(dict.fromkeys((*b.conditions, *other.conditions)))
                return [replace(b, provided=False, limit=b.limit or other.limit, conditions=conditions)]
        return branches

    def _with_stated_slip(self, b: AnswerBranch) -> AnswerBranch | None:
        """The part of a branch in which slip has the sense with which the equations of motion were found, if any."""
        states = tuple(s for s in b.states if not self._slips_backwards(s, b))
        return b.at(states) if states or not b.states else None

    def _slip_is_open(self, b: AnswerBranch) -> bool:
        """Whether a state of a branch does not say that slip has the sense that the file states."""
        moving, about = {*self.place.moving}, [e.xreplace(self.rule) for e in (*self.when, self.quantity)]
        if self._is_at_start or self.question.by is not None or all(e.free_symbols.isdisjoint(moving) for e in about):
            return False
        speeds = [(e.xreplace(self.rule).xreplace(dict(s)), s) for s in b.states for e in self.setting.stated_slips]
        if not b.provided:
            speeds = [(e, s) for e, s in speeds if not arrivals.goes_on(e, s, self._beginning)]
        return any(self._beginning.sign(e, b.conditions) not in (0, 1) for e, _ in speeds)

    def _slips_backwards(self, state: SymbolValues, b: AnswerBranch) -> bool:
        """Whether slip has the other sense in a state, or would have led away from it since the start."""
        covered = [s * (state[q] - self.setting.initial[q]) for q, s in self.kept_senses.items() if q in state]
        speeds = [*(e.xreplace(dict(state)) for e in self.setting.slips), *covered]
        moving = {*self.place.moving}
        sign = self._beginning.sign
        return any(e.free_symbols.isdisjoint(moving) and sign(e, b.conditions) == -1 for e in speeds)

    def _after_turning(self, route: Route, used: Sequence[UsedIntegral]) -> Asked:
        """The answer where the motion comes to rest first and goes back, with friction or drag in the other sense."""
        unanswered = self._asked(route, None, used)
        senses = self.setting.known.senses
        if len(senses) != 1 or self._is_about_time or len(self.setting.slips) != 1 or self.setting.turnings:
            return unanswered
        [(v, sense)] = senses.items()
        if not isinstance(v, sp.Symbol):
            return unanswered
        rest = Condition(v, sp.S.Zero, self.question.span)
        turning = replace(self.question, quantity=base(v), when=(rest,), by=None)
        first = _Search(turning, self.setting).answer()
        if not first.answered or len(first.branches) != 1 or len(first.branches[0].states) != 1:
            return unanswered
        [b] = first.branches
        state = {s: e for s, e in b.states[0].items() if s in self.setting.initial}
        after = self.setting.turned({**self.setting.initial, **state}, {v: -sense})
        starts = after.known.accelerations[prime(v)].xreplace(dict(after.initial))
        way = sign_of_value(-sense * starts)
        if way in (0, -1):
            raise ProblemError(ranges.never_holds(self.question))
        asked = _Search(self.question, after).answer()
        back = () if way == 1 else (more_than_zero(-sense * starts),)
        conditions = (*b.conditions, *back)
        later = tuple(shown(replace(x, conditions=(*x.conditions, *conditions))) for x in asked.branches)
        return replace(asked, branches=later, turning=Substituted(base(v), b.values[0]))

    @property
    def _beginning_of_slip(self) -> list[SignCondition] | None:
        """The conditions under which slip begins in the sense that the file states; None where friction prevents it."""
        return arrivals.while_it_begins(self.setting, self.rule, self._beginning.sign)

    @property
    def _beginning(self) -> InitialMotion:
        return initial_motion(self.setting, self.rule, self.when)

    def _asked(
        self,
        route: Route,
        how: How | None = None,
        used: Sequence[UsedIntegral] | None = None,
        free: Collection[sp.Symbol] = (),
    ) -> Asked:
        return Asked(
            self.question,
            self.place.name,
            how,
            route,
            tuple(self.setting.integrals if used is None else used),
            self.used,
            self.conditions,
            self.quantity,
            missing=tuple(sorted(self.setting.missing, key=str)),
            open=tuple(sorted(free, key=str)),
            initial=given_state(self.setting.problem),
            senses=self.setting.known.senses,
        )

    def _on_orbit(self) -> Asked | None:
        """The answer from the orbit round a centre, at an angle or as a function of it; None if there is none."""
        sign = self._beginning.sign
        accelerations = {a: e.xreplace(self.rule) for a, e in self.known.accelerations.items()}
        found = orbit(accelerations, self.setting.initial, self._beginning.own, sign)
        if found is None:
            return None
        quantity, when = (e.xreplace(self.rule) for e in (self.quantity, self.when[0] if self.when else sp.S.Zero))
        by, moving = self.question.by, {*self.place.moving} - {self.question.by}
        if by not in (None, found.angle) or len(self.when) != (by is None):
            return None
        values = found.values(quantity, when, by is not None, sign)
        branches = [AnswerBranch(self.question.quantity, v, (v,), (state,), where) for v, state, where in values]
        if not branches or any(not v.free_symbols.isdisjoint(moving) for b in branches for v in b.values):
            return None
        radial = prime(found.inverse.radius)
        constant = [i for i in self.setting.integrals if radial not in i.expression.free_symbols]
        return replace(
            self._asked(Route.ORBIT, How.EXACT, constant),
            branches=tuple(map(shown, branches)),
            orbit=found.inverse,
        )

    # -- in time -------------------------------------------------------------------------------------------------------

    def _in_time(self) -> Asked | None:
        """The answer from the solution of the equations of motion; None if that is not found."""
        state = {*self.slots.coordinates, *self.slots.velocities}
        rule = self.rule
        named = {s for e in (self.quantity, *self.when) for s in e.xreplace(rule).free_symbols & state}
        wanted = {base(s) for s in named} | ({self.question.by} - {t, None})
        accelerations = {a: e.xreplace(rule) for a, e in self.known.accelerations.items()}
        slipping = {base(s) for e in self._slips for s in e.free_symbols & state}
        if self.question.by == t:
            slipping |= {base(v) for v in self.setting.known.senses if v.is_Symbol}
        places = self.setting.places_of_no_matter(accelerations)
        rates = [r.velocity_form(self.slots) for r in self.configuration.rows if r.finite is None]
        motions = closed_motions(accelerations, {**self.setting.initial, **places}, wanted | slipping, rates)
        if not motions and self.question.by == t and not slipping:
            found = [power_drag(q, accelerations, self.setting.initial) for q in wanted]
            motions = [m for m in found if m is not None] if len(found) == 1 else []
        branches: list[AnswerBranch] = []
        ended = False
        for m in motions:
            at_time = self._at_time_of(m)
            if at_time is None:
                return None
            lasting = [self._while_slipping(b, m) for b in at_time]
            ended = ended or None in lasting
            branches += [b for b in lasting if b is not None]
        if ended and not branches:
            raise ProblemError(ranges.slip_has_ended(self.question))
        if not motions or any(b.rhs.free_symbols & {*places.values()} for b in branches):
            return None
        branches = [replace(b, states=tuple(without(s, places.values()) for s in b.states)) for b in branches]
        branches = branches or [
            arrivals.approached(self.question, self.quantity.xreplace(rule), self.when, rule, motions)
        ]
        return replace(
            self._asked(Route.SOLUTION, How.EXACT, ()),
            branches=tuple(shown(b) for b in branches),
            solutions={}
            if len(motions) > 1
            else {
                prime(q) if q in places else q: under_one_root(motions[0].speed(q) if q in places else e)
                for q, e in motions[0].solutions.items()
            },
        )

    @property
    def _slips(self) -> list[sp.Expr]:
        """The speeds of slip in the senses that the file states."""
        return [] if self._is_at_start else [e.xreplace(self.rule) for e in self.setting.stated_slips]

    def _while_slipping(self, b: AnswerBranch, motion: ClosedMotion) -> AnswerBranch | None:
        """The branch with the conditions under which slip lasts up to it; None if it has ended."""
        speeds = [motion.at_time(e) for e in self._slips]
        by_time = self.question.by == t
        if by_time:
            speeds += [s * motion.at_time(v) for v, s in self.setting.known.senses.items()]
        until = t if by_time else next((s[t] for s in b.states if t in s), None)
        if not speeds or until is None:
            return b
        try:
            conditions = arrivals.while_slipping(speeds, until, lambda e: self._beginning.sign(e, b.conditions))
        except arrivals.SlipEndUndecidedError:
            return replace(b, provided=True)
        if conditions is None:
            return None
        together = (*b.conditions, *conditions, *(self._beginning_of_slip or ()))
        return replace(b, conditions=tuple(dict.fromkeys(together)))

    def _at_time_of(self, motion: ClosedMotion) -> list[AnswerBranch] | None:
        """The quantity in one case of the motion, at the first time at which the conditions hold."""
        called = self.question.quantity
        value = motion.at_time(self.quantity.xreplace(self.rule))
        when = [motion.at_time(e.xreplace(self.rule)) for e in self.when]
        if self.question.by not in (t, None):
            when.append(motion.solutions[self.question.by] - self.question.by)
        if self.question.by == t:
            return None if when else [AnswerBranch(called, value, (value,), ({},), motion.conditions)]
        linear = [e for e in when if e.is_Add and e.coeff(t, 1) in (1, -1)]
        given = next((e for e in linear if t not in (e - e.coeff(t, 1) * t).free_symbols), None)
        timed = sorted((e for e in when if t in e.free_symbols), key=lambda e: (e is not given, count_operations(e)))
        for equation in timed:
            roots = times(equation, positive=self.question.by is None)
            if roots is None:
                continue
            branches: list[AnswerBranch] | None = []
            for root in in_order(roots):
                rest = [e for e in when if e is not equation]
                more = self._at(root, value, rest, motion, called)
                branches = None if more is None or branches is None else [*branches, *more]
            return branches
        return [] if any(e.is_nonzero for e in when if t not in e.free_symbols) else None  # it never holds

    def _at(
        self, root: TimeRoot, value: sp.Expr, rest: Sequence[sp.Expr], motion: ClosedMotion, called: sp.Expr
    ) -> list[AnswerBranch] | None:
        """The quantity at one time, where the other conditions hold too; a parameter may be found from these."""
        rule = {t: root.value}
        conditions = tuple(dict.fromkeys((*motion.conditions, *root.conditions)))
        left = [e.xreplace(rule) for e in rest]
        if self.parameter is not None:
            elimination = eliminated(left, called, [self.parameter], [], called)
            if not elimination.solved or elimination.free:
                return None
            later = (after_start(b, root.value, self.parameter) for b in elimination.branches)
            return [b for b in later if b is not None and not all(sign_of(v) == -1 for v in b.values)]
        if any(is_zero(e) is not True for e in left):
            return None
        at = motion.written(value.xreplace(rule))
        rates = {prime(q): motion.speed(q) for q in motion.solutions}
        senses = self.setting.known.senses
        if not all(keeps_sign(rates[v], senses[v], root) for v in rates if v in senses):
            return None
        state = {t: root.value} | {q: e.xreplace(rule) for q, e in motion.solutions.items()}
        state |= {v: e.xreplace(rule) for v, e in rates.items()}
        return [AnswerBranch(called, at, (at,), (state,), conditions)]

    def _by_quadrature(self) -> Asked | None:
        """t = ∫ dq/q' from q_0 to q_1, where one coordinate moves and an integral gives q'; None if it is not found."""
        beginning = self._beginning
        one = beginning.free == 1
        if self.question.quantity != t or len(self.when) != 1:
            return None
        place = place_stated(self.when[0], self.setting, beginning) if one or beginning.along else None
        if place is None:
            return self._by_speed() or approach(self._asked(Route.QUADRATURE, How.EXACT), self.when[0], self.setting)
        (q, end), initial = place, self.setting.initial
        if q not in initial or end.free_symbols & {*self.place.moving}:
            return None
        used = [i for i in self.setting.integrals if not one or prime(q) in i.expression.free_symbols]
        rates = [r.velocity_form(self.slots) for r in self.configuration.rows]
        equations = [*(i.expression - i.value for i in used), *self.configuration.finite_constraints, *rates]
        unknowns = [s for s in (*self.slots.velocities, *self.slots.coordinates) if s != q]
        elimination = eliminated(equations, prime(q), unknowns, self.slots.velocities, prime(q))
        way = sign_of_value(end - initial[q])
        if way in (1, -1) and -way in (self.kept_senses.get(q), self._beginning.direction(q)):
            return None  # it would have to turn round first
        speed = toward((v for b in elimination.branches for v in b.values), q, (initial[q], end), way)
        if speed is None or way is None:
            return None
        integrand = (q, under_one_root(speed), initial[q], end)
        asked = replace(self._asked(Route.QUADRATURE, None, used), integrand=integrand)
        if (taken := time_between(q, speed, initial[q], end, way)) is None:
            number, whole = not_elementary((q, speed, initial[q], end), way, self.setting.values)
            branches, how = ((), None) if number is None else ((AnswerBranch(t, number, (number,)),), How.NUMERICAL)
            return replace(asked, branches=branches, how=how, verified=None, integral=whole)
        conditions = tuple(c for c in elimination.branches[0].conditions if q not in (c.lhs - c.rhs).free_symbols)
        branch = AnswerBranch(t, taken, (taken,), (), conditions)
        return replace(asked, branches=(shown(branch),), how=How.EXACT)

    def _by_speed(self) -> Asked | None:
        """t = ∫ dv/v' or q − q_0 = ∫ v dv/v' from v_0 to v_1, where the acceleration depends on the velocity alone."""
        stated = speed_stated(self.when, self.known.accelerations, self.setting.initial, self.slots)
        quantity = self.question.quantity
        if stated is None or quantity not in (t, base(stated[0])):
            return None
        place = sp.S.Zero if quantity == t else self.setting.initial.get(quantity)
        if place is None or (found := taken_between_speeds(*stated, self.setting.values, quantity == t)) is None:
            return None
        branch = AnswerBranch(quantity, place + found[0], (place + found[0],), (), found[1])
        return replace(self._asked(Route.QUADRATURE, How.EXACT, ()), integrand=stated, branches=(shown(branch),))
