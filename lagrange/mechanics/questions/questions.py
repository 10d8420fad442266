"""Answers to the questions of a file.

A question asks for a quantity at the state in which its conditions hold, or as a function of one coordinate or of t.
The routes are tried in this order, in each set of coordinates that has all that the question mentions:

    the state       the conditions give position and velocity: accelerations and reactions follow from these
    integrals       first integrals with their values at t = 0, the constraints and the conditions determine it
    solution        the equations of motion have a solution in closed form, and the conditions determine t
    quadrature      t = ∫ dq/q', where q' is known from an integral
    numbers         with values for all parameters: the first time at which the conditions hold

An answer found by one of them is exact, but for the last one. What is not found is said, with what is known.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.symbols import t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.questions.branches import first_branches
from lagrange.mechanics.questions.elimination import Eliminated, eliminated
from lagrange.mechanics.questions.integrals_of_motion import integrals
from lagrange.mechanics.questions.results import Asked, How, Route, Substituted, UsedIntegral
from lagrange.mechanics.questions.states import Meanings, Place, Values, initial_state, meanings
from lagrange.problem.model import Problem, Question


def answers_to_questions(
    problem: Problem, places: Sequence[Place], configurations: Sequence[Configuration]
) -> tuple[Asked, ...]:
    """The answers to all questions.

    places          in the order in which they are tried
    configurations  all sets of coordinates

    Raises ProblemError where the initial state contradicts the constraints, where a condition never holds, and where
    nothing determines the quantity.
    """
    settings = [_Setting(place, problem, configurations) for place in places]
    return tuple(_answer(q, settings) for q in problem.questions)


class _Setting:
    """A place with all that questions need of it, found once."""

    def __init__(self, place: Place, problem: Problem, configurations: Sequence[Configuration]) -> None:
        self.place = place
        self.problem = problem
        self.initial: Values = initial_state(place, problem, configurations)
        self.known: Meanings = meanings(place)
        self.integrals, self.missing = integrals(place, self.known, self.initial)


def _answer(question: Question, settings: Sequence[_Setting]) -> Asked:
    """The first answer that is found. Raises ProblemError."""
    tried: list[Asked] = []
    coordinates = tuple(dict.fromkeys(q for s in settings for q in _all_coordinates(s.place.configuration)))
    for setting in settings:
        mentioned = _mentioned(question)
        if not setting.place.knows(mentioned, coordinates):
            continue
        if question.by is not None and question.by not in (t, *setting.place.configuration.slots.coordinates):
            continue
        asked = _Search(question, setting).answer()
        if asked.answered:
            return asked
        tried.append(asked)
    if not tried:
        message = f"the question `{question.name}` mixes coordinates of several choices"
        help_ = "use the file's coordinates, and those of one choice"
        raise ProblemError(Diagnostic("mixed-choices", message, question.span, help=help_))
    return tried[0]


def _all_coordinates(configuration: Configuration) -> Iterator[sp.Symbol]:
    yield from configuration.slots.coordinates
    yield from configuration.expressed


def _mentioned(question: Question) -> set[sp.Symbol]:
    symbols = set(question.quantity.free_symbols)
    return symbols.union(*(c.function.free_symbols for c in question.when))


class _Search:
    """The search for the answer to one question in one set of coordinates."""

    def __init__(self, question: Question, setting: _Setting) -> None:
        self.question = question
        self.setting = setting
        self.place = setting.place
        self.configuration = setting.place.configuration
        self.slots = self.configuration.slots
        self.quantity = self._applied(question.quantity)
        self.conditions = tuple((self._applied(c.lhs), self._applied(c.rhs)) for c in question.when)
        self.when = [a - b for a, b in self.conditions]
        self.used = tuple(self._used())
        parameters = {p.symbol for p in setting.problem.parameters} | {*setting.problem.unknowns}
        of_quantity = sorted(question.quantity.free_symbols & parameters, key=str)
        only_parameters = question.quantity.free_symbols <= parameters
        self.parameter = of_quantity[0] if only_parameters else None

    def _applied(self, e: sp.Expr) -> sp.Expr:
        return self.setting.known.applied(self.configuration.rewritten(e))

    def _used(self) -> Iterator[Substituted]:
        """The reactions, accelerations and energies that the question mentions."""
        known = self.setting.known
        for s in sorted(_mentioned(self.question), key=str):
            if s in known.reactions or s in known.energies or s.name.endswith("''"):
                value = self._applied(s)
                if value != s:
                    yield Substituted(s, value)

    def answer(self) -> Asked:
        """The answer, or what is known of it. Raises ProblemError where there is none."""
        unknown = [r for e in (self.question.quantity, *(c.function for c in self.question.when))
                   for r in self.setting.known.unknown(e)]  # fmt: skip
        if unknown:
            return self._asked(Route.STATE)
        for route, used in ((Route.STATE, []), (Route.INTEGRALS, self.setting.integrals)):
            if route is Route.INTEGRALS and not used:
                break
            found = self._eliminated(used)
            if found.never:
                raise ProblemError(self._never_holds())
            if found.branches and found.solved and not found.free:
                return self._chosen(route, found, used)
        return self._asked(Route.INTEGRALS)

    def _eliminated(self, used: Sequence[UsedIntegral]) -> Eliminated:
        """The quantity from the integrals, the constraints and the conditions."""
        configuration = self.configuration
        rates = [r.velocity_form(self.slots) for r in configuration.rows]
        equations = [*(i.expression - i.value for i in used), *configuration.finite_constraints, *rates, *self.when]
        unknowns = [s for s in (*self.slots.velocities, *self.slots.coordinates, t) if s != self.question.by]
        if self.parameter is not None:
            unknowns.append(self.parameter)
        return eliminated(equations, self.quantity, unknowns, self.slots.velocities, self.question.quantity)

    def _chosen(self, route: Route, found: Eliminated, used: Sequence[UsedIntegral]) -> Asked:
        chosen = first_branches(found.branches, self.setting.initial, self.setting.known.accelerations, self.slots)
        asked = self._asked(route, How.EXACT, used)
        return Asked(
            **{
                **{f: getattr(asked, f) for f in ("question", "choice", "how", "route", "used", "conditions")},
                "integrals": tuple(used),
                "quantity": self.quantity,
                "branches": chosen.branches,
                "dropped": chosen.dropped,
                "mirrored": chosen.mirrored,
                "first": chosen.first,
                "verified": found.verified,
            }
        )

    def _asked(self, route: Route, how: How | None = None, used: Sequence[UsedIntegral] = ()) -> Asked:
        return Asked(
            self.question,
            self.place.name,
            how,
            route,
            tuple(used) or tuple(self.setting.integrals),
            self.used,
            self.conditions,
            self.quantity,
            missing=tuple(sorted(self.setting.missing, key=str)),
        )

    def _never_holds(self) -> Diagnostic:
        first = self.question.when[0].span if self.question.when else self.question.span
        message = f"the `when` of the question `{self.question.name}` never holds in this motion"
        help_ = "no state with the given initial values satisfies it: check the condition, and `initial`"
        return Diagnostic("never-holds", message, first, help=help_)
