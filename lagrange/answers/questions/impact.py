"""Are the stated velocities, impulses and losses of energy of an impact right?

Each entry is an expression, or an equation with its name on the left: a velocity just after (`x'`), the impulse of a
reaction under the name of its constraint or of its force, or `energy_lost`. It must have the derived value in the
position of the impact, exactly, with decimals that may be rounded. An impulse may be stated for the opposite force, or
for the multiplier; a remark says so.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.answers.questions.asked_quantities import read_stated
from lagrange.answers.questions.named_values import Judged, check_each
from lagrange.answers.readings import decimals_in
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import UNDECIDED, AnswerVerdict, Verdict
from lagrange.answers.written.decimals import as_written, numbers_rounding_to
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, suggestion
from lagrange.core.symbols import prime
from lagrange.mechanics.momenta.impact import ImpulsiveMotion
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Problem

ENERGY_LOST = "energy_lost"
_NOT_DERIVED = "the problem does not ask for an impact"
_OPEN = "the impulse is not determined: the constraints depend on one another"
_OPPOSITE = "it is taken as the opposite force"
_MULTIPLIER = "it is taken as the impulse of the multiplier"
_ROUNDED = "it is taken as a rounded number"


def check_impact_answers(stated: Mapping[str, Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on all entries together."""
    motion = solution.impact
    if motion is None:
        return AnswerVerdict(Verdict.UNDECIDED, name="impact", diagnosis=_NOT_DERIVED)
    reference = reference_of_solution(solution)
    return check_each(
        "impact", stated, lambda name, fragment: _judged(name, fragment, motion, solution.problem, reference)
    )


def _judged(name: str, fragment: Fragment, motion: ImpulsiveMotion, problem: Problem, reference: Reference) -> Judged:
    """The verdict on one entry. Raises ProblemError, DivisionByZeroError."""
    values = [*_values(name, fragment, motion)]
    scope = replace(reference.scope, decimals="")
    expression, equation = read_stated(fragment, scope, name)
    if expression is None:
        assert equation is not None
        expression = _solved(equation, name, motion)
        if expression is None:
            help_ = f"write the expression, or `{name} = ...`"
            message = f"this equation does not give `{name}`"
            raise ProblemError(Diagnostic("unexpected-equation", message, fragment.whole, help=help_))
    if not values:
        return Verdict.UNDECIDED, _OPEN
    undecided = False
    for value, remark in values:
        same = _same(expression, value, motion, reference)
        if same is None:
            undecided = True
        elif same:
            rounding = _ROUNDED if decimals_in([expression]) else ""
            return Verdict.EQUIVALENT, "; ".join(filter(None, [remark, rounding]))
    if undecided:
        return Verdict.UNDECIDED, UNDECIDED
    from lagrange.answers.results.impacts import explained_impact

    before = dict(zip(motion.slots.velocities, motion.velocities, strict=True))
    claim = motion.at(as_written(expression)).xreplace(before)
    values_ = dict(reference.values)
    why = explained_impact(
        name, claim, values[0][0], motion, problem, lambda e: motion.surface.is_zero(e.xreplace(values_))
    )
    if not why:
        from lagrange.answers.results.units import wrong_dimension

        why = wrong_dimension(claim, reference.units, values[0][0])
    return Verdict.WRONG, why


def _values(name: str, fragment: Fragment, motion: ImpulsiveMotion) -> Iterator[tuple[sp.Expr, str]]:
    """The derived value under a name, and what an impulse may be instead; none where it is not determined.

    Raises ProblemError where the name means nothing.
    """
    velocities = {q.name: v for q, v in motion.all_velocities.items()}
    plain = name.strip().replace("′", "'").removesuffix("'")
    impulses = {n: i for i in motion.impulses for n in (i.name, str(i.symbol), str(i.reaction.constraint.reaction))}
    if plain in velocities:
        yield velocities[plain], ""
    elif name == ENERGY_LOST:
        yield motion.energy_lost, ""
    elif name in impulses:
        i = impulses[name]
        if i.value is not None and i.multiplier is not None:
            yield i.value, ""
            others = ((-i.value, _OPPOSITE), (i.multiplier, _MULTIPLIER))
            yield from ((value, remark) for value, remark in others if value != i.value)
    else:
        known = [*(f"{q}'" for q in velocities), *(i.name for i in motion.impulses), ENERGY_LOST]
        message = f"`{name}` is neither a velocity nor an impulse of this impact"
        help_ = suggestion(name, known, "results")
        raise ProblemError(Diagnostic("unknown-name", message, fragment.whole, help=help_))


def _solved(equation: sp.Expr, name: str, motion: ImpulsiveMotion) -> sp.Expr | None:
    """What an equation gives for the named velocity or impulse, if it is linear in it."""
    plain = name.strip().removesuffix("'")
    coordinate = next((q for q in motion.all_velocities if q.name == plain), None)
    impulse = next((i.symbol for i in motion.impulses if name in (i.name, str(i.symbol))), None)
    unknown = prime(coordinate) if coordinate is not None else impulse
    if unknown is None:
        return None
    slope = equation.diff(unknown)
    if slope == 0 or slope.has(unknown):
        return None
    return sp.cancel(unknown - equation / slope)


def _same(claim: sp.Expr, value: sp.Expr, motion: ImpulsiveMotion, reference: Reference) -> bool | None:
    """Whether a claim has a value in the position of the impact, its decimals being numbers that round to them."""
    before = dict(zip(motion.slots.velocities, motion.velocities, strict=True))
    difference = (motion.at(claim).xreplace(before) - value).xreplace(dict(reference.values))
    exact = motion.surface.is_zero(as_written(difference))
    if exact is not False or not decimals_in([difference]):
        return exact
    return numbers_rounding_to([difference]) is not None
