"""Which answers exist: within the ranges of the coordinates, with the values of a problem; why there is none.

Why a question has no answer: it is not determined, or its condition never holds.

The states of an answer in the ranges of the coordinates: the slider of a crank on this side of the shaft.

Which branches of an answer exist with the values of a problem: those whose conditions are not violated by them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.symbols import Bounded
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.motion import NewtonLaw
from lagrange.mechanics.equilibrium.admissible_positions import distances
from lagrange.mechanics.equilibrium.in_numbers import condition_holds
from lagrange.mechanics.questions.branches import sign_of_value
from lagrange.mechanics.questions.limits import DIGITS
from lagrange.mechanics.questions.results import AnswerBranch, Asked
from lagrange.problem.model import Question
from lagrange.values.quantities import NotRealError, Values


def changes(question: Question) -> Diagnostic:
    """The quantity is not constant, and the question does not say when it is wanted."""
    message = f"the quantity of the question `{question.name}` changes during the motion"
    help_ = "say at which state it is wanted, with `when`, or as a function of what, with `by`"
    return Diagnostic("not-determined", message, question.written.whole, help=help_)


def not_determined(question: Question, free: Iterable[sp.Symbol], not_given: Iterable[sp.Symbol]) -> Diagnostic:
    """The quantity depends on what is not known."""
    listed = ", ".join(f"`{s}`" for s in sorted(free, key=str))
    message = f"the quantity of the question `{question.name}` is not determined: it depends on {listed}"
    missing = ", ".join(f"`{s}`" for s in not_given)
    help_ = f"give {missing} at t = 0 in `initial`, or another condition in `when`"
    return Diagnostic("not-determined", message, question.written.whole, help=help_)


def mixed(question: Question) -> Diagnostic:
    """The failure in which no set of coordinates covers all that the question mentions."""
    message = f"the question `{question.name}` mixes coordinates of several choices"
    help_ = "use the file's coordinates, and those of one choice"
    return Diagnostic("mixed-choices", message, question.span, help=help_)


def never_holds(question: Question, approached: bool = False, outright: bool = False) -> Diagnostic:
    """The motion does not get to the state, or only in the limit; `outright`: whatever the integrals of the motion."""
    first = question.when[0].span if question.when else question.span
    message = f"the `when` of the question `{question.name}` never holds in this motion"
    help_ = "the motion from the given initial values does not get there: check the condition, and `initial`"
    if outright:
        help_ += "; if it takes one value of a parameter `a`, ask for that, `{quantity: a, when: ...}`"
    if approached:
        message = f"the `when` of the question `{question.name}` holds only in the limit t → ∞"
        help_ = "the motion approaches this state and is never there: ask when a part of the way is left"
    return Diagnostic("never-holds", message, first, help=help_)


def slip_has_ended(question: Question, holds: str = "holds only after the slip has ended") -> Diagnostic:
    """The state comes after the time for which the law of friction holds."""
    first = question.when[0].span if question.when else question.span
    message = f"the `when` of the question `{question.name}` {holds}"
    help_ = "the friction is not that of slipping then: ask for the rolling, or for rest, in a file of its own"
    return Diagnostic("never-holds", message, first, help=help_)


def does_not_slip(question: Question) -> Diagnostic:
    """What touches does not slip at t = 0, and no force makes it slip."""
    message = f"the question `{question.name}` is about slip that does not begin: what touches does not slip at t = 0"
    help_ = "friction at rest is enough, or nothing drives it: write rolling as a constraint, `static:` for its limit"
    return Diagnostic("never-holds", message, question.span, help=help_)


def contact_has_ended(question: Question, constraint: str) -> Diagnostic:
    """The state comes after a one-sided constraint has ceased to act: its force would have the wrong sign there."""
    first = question.when[0].span if question.when else question.span
    message = f"the `when` of the question `{question.name}` holds only after contact with `{constraint}` has ended"
    help_ = "ask for the place where its force is zero; what follows is a motion without it, for a file of its own"
    return Diagnostic("never-holds", message, first, help=help_)


# Ranges


SymbolValues = Mapping[sp.Symbol, sp.Expr]
_TOLERANCE = sp.Float(10) ** (-DIGITS // 2)


def in_ranges(b: AnswerBranch, configuration: Configuration, values: SymbolValues) -> AnswerBranch | None:
    """The part of a branch in the ranges of the coordinates; None if there is none."""
    kept = [s for s in b.states if not any(_is_outside(q, s, configuration, values) for q in configuration.ranges)]
    return b.at(kept) if kept or not b.states else None


def _is_outside(q: sp.Symbol, state: SymbolValues, configuration: Configuration, values: SymbolValues) -> bool:
    if q not in state:
        return False
    expressions = (
        *configuration.finite_constraints,
        *(c for p in configuration.points for c in p.position.fixed().components),
    )
    is_angle = any(q in f.free_symbols for e in expressions for f in e.atoms(*CIRCULAR))
    tested, complement = distances(q, configuration.ranges[q], is_angle)
    numbers = [e.xreplace({q: state[q]}).xreplace(dict(values)).evalf(DIGITS) for e in tested]
    if not all(n.is_number and n.is_real for n in numbers):
        return False
    return all(n > _TOLERANCE for n in numbers) if complement and numbers else any(n < -_TOLERANCE for n in numbers)


def has_wrong_sign(b: AnswerBranch, parameter: sp.Symbol | None) -> bool:
    """Whether a parameter that is adapted to the conditions would be negative, although it is positive."""
    if parameter is None or not parameter.is_nonnegative or not b.states:
        return False
    return all(parameter in s and sign_of_value(s[parameter]) == -1 for s in b.states)


def is_lifted(b: AnswerBranch, question: Question, law: NewtonLaw, known: Mapping[sp.Symbol, sp.Expr | None]) -> bool:
    """Whether a positive parameter that is asked for is one for which a contact of its condition would have to pull.

    known  the reactions, by symbol
    """
    parameter = question.quantity
    if not (parameter.is_Symbol and parameter.is_positive) or len(b.values) != 1 or len(b.states) > 1:
        return False
    [value] = b.values
    if sign_of_value(value) is not None:
        return False
    named = set().union(*(c.function.free_symbols for c in question.when))
    pressing = [r for r in law.newton.reactions if r.constraint.side is not None and r.symbol_of_force in named]
    rule = {**(b.states[0] if b.states else {}), parameter: value}
    forces = [force.xreplace(rule) for r in pressing if (force := known.get(r.force)) is not None]
    return any(sign_of_value(f, (*b.conditions, more_than_zero(value))) == -1 for f in forces)


def in_bounds(asked: Asked) -> Asked:
    """The answer where a parameter that is asked for lies between its bounds, an acute angle is acute.

    Raises ProblemError if it lies there nowhere.
    """
    parameter = asked.question.quantity
    if not isinstance(parameter, Bounded):
        return asked
    kept = tuple(b for b in (_in_bounds(b, parameter) for b in asked.branches) if b is not None)
    if not kept:
        raise ProblemError(never_holds(asked.question))
    return replace(asked, branches=kept)


def _in_bounds(b: AnswerBranch, parameter: Bounded) -> AnswerBranch | None:
    inside = [v for v in b.values if not is_beyond(v, parameter)]
    if len(inside) == len(b.values):
        return b
    kept = [s for s in b.states if parameter not in s or not is_beyond(s[parameter], parameter)]
    return b.at(kept) if inside and kept else None


def is_beyond(value: sp.Expr, parameter: Bounded) -> bool:
    """Whether a value is certainly none that the parameter may have."""
    margins = (value - parameter.low, parameter.high - value)
    pairs = zip(margins, parameter.strict, strict=True)
    return any(sign_of_value(e) in ((0, -1) if strict else (-1,)) for e, strict in pairs)


# With the values of the problem


def branches_with(asked: Asked, values: Values) -> tuple[AnswerBranch, ...]:
    """The branches without those that the values exclude; a condition with open parameters excludes none."""
    return tuple(b for b in asked.branches if not any(_is_violated(c, values) for c in b.conditions))


def _is_violated(condition: SignCondition, values: Values) -> bool:
    try:
        return condition_holds(condition, values.put_in) is False
    except NotRealError:
        return True
