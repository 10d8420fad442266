"""Why a question has no answer: it is not determined, or its condition never holds."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from lagrange.core.diagnostics import Diagnostic
from lagrange.problem.model import Question


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
