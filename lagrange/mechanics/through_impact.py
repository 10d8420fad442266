"""An impact, and the motion that begins with it.

The questions of a file with an impact are about the motion after it. That begins at t = 0 in the position of the impact
with the velocities just after it, under the old constraints and those of the new ones that persist, whose coefficient
of restitution is 0: a bullet that lodges stays in the block, a ball that rebounds is free. It is a problem of its own,
solved like any other: its equations of motion, first integrals and checks know nothing of the impact. Energy is lost in
the instant of the impact, and may be conserved from then on.

A question for a parameter with conditions on reactions alone is about their impulses.

Where the impulse of a reaction vanishes: a hand that holds a rod is not jarred where 3 a = 2 l.

An impulse is a quotient of polynomials in the parameters. It vanishes, and where it does so to an odd power it changes
its sense, where a factor of its numerator does: a sum of terms of both signs in positive parameters. Such a place
counts only if the position that it belongs to exists, that is if the constraints remain real there.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, NotCoveredError, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import base, prime
from lagrange.mechanics.limits import MOST_VANISHING_TERMS
from lagrange.mechanics.momenta.impact import ImpulsiveMotion, impulsive_motion
from lagrange.mechanics.momenta.impact_checks import check_impact
from lagrange.mechanics.questions.elimination import eliminated
from lagrange.mechanics.questions.forms import shown
from lagrange.mechanics.questions.ranges import has_wrong_sign
from lagrange.mechanics.questions.results import Asked, How, Route, Substituted
from lagrange.mechanics.results import Solution
from lagrange.problem.keys import Find
from lagrange.problem.model import Choice, Constraint, InitialValue, Problem, Question


def with_impact(solution: Solution, taken: frozenset[str], solve_after: Callable[[Problem], Solution]) -> Solution:
    """The solution with the velocities after the impact of the file, the impulses, and the answers to its questions.

    solve_after  solves the motion after the impact
    """
    problem = solution.problem
    choices = [c.coordinates for c in solution.choices]
    motion = impulsive_motion(problem, choices, solution.own.coordinates, taken)
    checks = (*solution.checks, *check_impact(motion, problem))
    solution = replace(solution, impact=motion, checks=checks)
    if not problem.questions:
        return solution
    if problem.initial:
        message = "the motion after the impact begins with the state that the impact leaves, and not with `initial`"
        help_ = "move what holds just before the impact to `before` under `impact`, and leave `initial` out"
        raise ProblemError(Diagnostic("two-starts", message, problem.initial[0].span, help=help_))
    answers = {q.name: a for q in problem.questions if (a := answer_by_impulses(q, motion, problem)) is not None}
    later = tuple(q for q in problem.questions if q.name not in answers)
    if not later:
        return replace(solution, asked=tuple(answers.values()))
    after = solve_after(problem_after(replace(problem, questions=later), motion))
    known = {(c.name, c.choice) for c in checks}
    checks += tuple(c for c in after.checks if (c.name, c.choice) not in known)
    answers |= {a.question.name: a for a in after.asked}
    asked = tuple(answers[q.name] for q in problem.questions if q.name in answers)
    return replace(solution, after=after, asked=asked, checks=checks, given_up=after.given_up)


def answer_by_impulses(question: Question, motion: ImpulsiveMotion, problem: Problem) -> Asked | None:
    """The parameter for which reactions have given impulses: where a rod is struck so that its hinge feels no blow.

    None for a question about anything else, or if the impulses do not determine it.
    """
    impulses = {i.reaction.constraint.reaction: i.value for i in motion.impulses if i.value is not None}
    parameters = {p.symbol for p in problem.parameters}
    named = set().union(*(c.function.free_symbols for c in question.when))
    if question.quantity not in parameters or not named & impulses.keys() or not named <= parameters | impulses.keys():
        return None
    stated = tuple((c.lhs.xreplace(impulses), c.rhs.xreplace(impulses)) for c in question.when)
    parameter = question.quantity
    elimination = eliminated([a - b for a, b in stated], parameter, [parameter], [], parameter)
    branches = tuple(shown(b) for b in elimination.branches if not has_wrong_sign(b, parameter))
    if not branches or not elimination.solved:
        return None
    used = tuple(Substituted(s, impulses[s]) for s in sorted(named & impulses.keys(), key=str))
    how, verified = How.EXACT, elimination.verified
    return Asked(question, "", how, Route.IMPACT, (), used, stated, parameter, branches, verified=verified)


def problem_after(problem: Problem, motion: ImpulsiveMotion) -> Problem:
    """The motion after an impact as a problem: its constraints, and its state at t = 0."""
    impact = problem.impact
    assert impact is not None
    names = {i.name for i in motion.impulses if i.is_new and i.restitution == 0}
    persistent = tuple(c for c in impact.constraints if c.name in names)
    choices = tuple(c for c in (_within(c, persistent) for c in problem.choices) if c is not None)
    known = {*problem.slots.coordinates, *(q for c in choices for q in c.coordinates)}
    over = {c.reaction for c in impact.constraints if c.name not in names}
    for question in problem.questions:
        asked = {base(s) for e in (question.quantity, *(w.function for w in question.when)) for s in e.free_symbols}
        if lost := sorted(q.name for c in problem.choices for q in c.coordinates if q in asked - known):
            raise NotCoveredError(
                f"a question about `{lost[0]}` after the impact, which no remaining choice has,", question.span
            )
        if gone := sorted(s.name for s in over & asked):
            what = f"a question about `{gone[0]}` after the impact, whose constraint has ended,"
            raise NotCoveredError(what, question.span)
    state = {
        **motion.position,
        **{prime(q): v for q, v in zip(motion.slots.coordinates, motion.velocities, strict=True)},
    }
    return replace(
        problem,
        constraints=(*problem.constraints, *persistent),
        choices=choices,
        impact=None,
        initial=tuple(InitialValue(s, value, impact.span) for s, value in state.items() if base(s) in known),
        find=(Find.MOTION,),
        answers=None,
        speeds=(),
    )


def problem_begun(problem: Problem, found: ImpulsiveMotion) -> Problem:
    """The problem after the impact; coordinates that `before` leaves open are those of `initial`."""
    after = problem_after(problem, found)
    known = {v.symbol for v in after.initial}
    places = (v for v in problem.initial if v.symbol in problem.slots.coordinates and v.symbol not in known)
    return replace(after, initial=(*after.initial, *places))


def _within(choice: Choice, persistent: Sequence[Constraint]) -> Choice | None:
    """The choice without the coordinates that persistent constraints give by the others; None if that fails."""
    coordinates, substitute = [*choice.coordinates], dict(choice.substitute or {})
    for c in persistent:
        if c.kinematic or choice.substitute is None:
            return None
        f = c.function.xreplace(substitute)
        for q in reversed(coordinates):
            slope = sp.diff(f, q)
            if slope != 0 and slope.free_symbols.isdisjoint(coordinates):
                value = sp.expand(q - f / slope)
                coordinates.remove(q)
                substitute = {old: e.xreplace({q: value}) for old, e in substitute.items()}
                substitute |= {} if q in substitute else {q: value}
                break
        else:
            return None
    return replace(choice, coordinates=tuple(coordinates), substitute=substitute) if persistent else choice


# Impulses that vanish


@record
class Vanishing:
    """left = right, where the impulse is zero; `turns` if it has opposite senses on the two sides."""

    left: sp.Expr
    right: sp.Expr
    turns: bool


def vanishings(value: sp.Expr, coefficients: Sequence[sp.Expr]) -> Iterator[Vanishing]:
    """The places where an impulse vanishes; `coefficients`: of the constraints in the position of the impact."""
    for factor in sp.Mul.make_args(sp.factor(sp.fraction(sp.together(value))[0])):
        base, exponent = factor.as_base_exp()
        terms = sp.Add.make_args(base)
        if len(terms) != MOST_VANISHING_TERMS or not exponent.is_Integer or not base.is_polynomial(*base.free_symbols):
            continue
        first, second = (a for a in sorted(terms, key=lambda a: a.could_extract_minus_sign()))
        if not first.is_positive or not second.is_negative or not _exists(first, -second, coefficients):
            continue
        yield Vanishing(first, -second, exponent % 2 == 1)


def _exists(left: sp.Expr, right: sp.Expr, coefficients: Sequence[sp.Expr]) -> bool:
    """Whether the constraints are real there, tried at one place."""
    symbols = sorted({s for e in (left - right, *coefficients) for s in e.free_symbols}, key=lambda s: s.name)
    for s in sorted((left - right).free_symbols, key=lambda s: s.name):
        if sp.degree(left - right, s) != 1:
            continue
        [place] = sp.solve(left - right, s)
        values = {other: sp.Rational(n + 7, 7) for n, other in enumerate(symbols) if other != s}
        at = {**values, s: place.xreplace(values)}
        return all(e.xreplace(at).is_real is not False for e in coefficients)
    return False
