"""A wrong equation that is right for one sense of the motion: friction turns with the velocity.

m x'' = −k x − μ m g is right while x' > 0. In the derived equations the sign of x' is put to +1 and to −1 (and |x'| to
x' and −x'); if the equation follows from one of the two systems, it holds while the velocity has that sign. Where the
answer says so itself, it is right as far as it goes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.limits import MOST_SENSES
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.cases.by_sense import single_condition
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.document.math_writer import text
from lagrange.expressions.reader import read_value
from lagrange.mechanics.dynamics.comparison import Standing, System, compare
from lagrange.problem.model import InitialValue

_BAD = (Standing.CONTRADICTS, Standing.NOT_LINEAR)


def one_sense(equation: sp.Expr, system: System) -> str:
    """For which sense of the motion a wrong equation is right, in a sentence; empty if for none."""
    for condition in _senses(equation, system):
        return f"it holds only while {text(condition)} > 0: what depends on the sign of a velocity turns with it"
    return ""


def _senses(equation: sp.Expr, system: System) -> Iterator[sp.Expr]:
    """What is positive where the equation follows from the system."""
    velocities = {*system.configuration.slots.velocities}
    signs = {w for e in system.equations for w in e.atoms(sp.sign, sp.Abs) if w.args[0].free_symbols & velocities}
    for u in sorted({w.args[0] for w in signs}, key=sp.default_sort_key)[:MOST_SENSES]:
        for s in (sp.S.One, sp.S.NegativeOne):
            rule = {sp.sign(u): s, sp.Abs(u): s * u}
            one = System(system.configuration, tuple(e.xreplace(rule) for e in system.equations), system.multipliers)
            try:
                result = compare([equation.xreplace(rule)], one)
            except DivisionByZeroError:
                continue
            if result is not None and not {*_BAD} & {*result.standings}:
                yield s * u


def kept_from_start(
    equations: Sequence[Fragment], verdict: AnswerVerdict, initial: Sequence[InitialValue], reference: Reference
) -> AnswerVerdict:
    """The verdict, in which an equation for one sense of the motion is right if the motion keeps this sense.

    A ball that is dropped falls: it starts with y' ≥ 0, and where y' vanishes y'' > 0, so that y' never changes its
    sign. It is asked of a system with one velocity and no multipliers, whose acceleration at rest has one sign.
    """
    if verdict.verdict is not Verdict.WRONG or not initial or len(verdict.equations) != len(equations):
        return verdict
    start = {s.symbol: s.value for s in initial}
    judged = [*verdict.equations]
    for n, e in enumerate(judged):
        if e.verdict is not Verdict.WRONG:
            continue
        fragment = equations[n]
        if not isinstance(fragment, GivenEquation) or len(fragment.reading.components) != 1:
            return verdict
        [equation] = fragment.reading.components
        kept = next(filter(None, (_kept_sense(c, equation, start) for c in reference.candidates)), None)
        if kept is None:
            return verdict
        remark = f"{text(kept)} > 0 from the start on, and for this sense it is right"
        judged[n] = EquationVerdict(e.text, Verdict.EQUIVALENT, remarks=(remark,))
    return replace(verdict, verdict=Verdict.EQUIVALENT, equations=tuple(judged), missing=0, diagnosis="")


def _kept_sense(candidate: ReferenceCandidate, equation: sp.Expr, start: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr | None:
    """The velocity, with a sign, that stays positive after the start, and for which an equation is right; None if
    there is none, or that is not seen."""
    slots = candidate.configuration.slots
    if len(slots.velocities) != 1 or candidate.multipliers or len(candidate.system.equations) != 1:
        return None
    [v], [a], [derived] = slots.velocities, slots.accelerations, candidate.system.equations
    for positive in _senses(candidate.read(equation), candidate.system):
        sense = positive.coeff(v)
        first = start.get(v)
        if positive != sense * v or first is None or not (sense * first).is_nonnegative:
            continue
        at_rest = derived.xreplace({sp.sign(v): sense, sp.Abs(v): sense * v}).xreplace({v: sp.S.Zero})
        slope = at_rest.diff(a)
        if slope != 0 and (-sense * at_rest.xreplace({a: sp.S.Zero}) / slope).is_positive:
            return positive
    return None


def right_as_far_as_stated(
    equations: list[Fragment], verdict: AnswerVerdict, reference: Reference
) -> AnswerVerdict | None:
    """The verdict if each wrong equation is right under the condition that stands beside it; None if one is not."""
    judged = [*verdict.equations]
    for n, e in enumerate(judged):
        if e.verdict is not Verdict.WRONG:
            continue
        stated = single_condition(getattr(equations[n], "beside", ""))
        if stated is None or not _holds_where(equations[n], stated, reference):
            return None
        greater, less = stated
        judged[n] = e.__class__(
            e.text,
            Verdict.EQUIVALENT,
            remarks=(f"right while {greater} > {less}; another equation holds while {greater} < {less}",),
        )
    return AnswerVerdict(
        Verdict.INCOMPLETE, tuple(judged), max(1, verdict.missing), verdict.choice, notes=verdict.notes
    )


def _holds_where(equation: Fragment, stated: tuple[str, str], reference: Reference) -> bool:
    if not isinstance(equation, GivenEquation) or len(equation.reading.components) != 1:
        return False
    try:
        greater, less = (read_value(Fragment.of(side), reference.scope, latex=True) for side in stated)
    except ProblemError:
        return False
    if not isinstance(greater, sp.Expr) or not isinstance(less, sp.Expr):
        return False
    (e,) = equation.reading.components
    for c in reference.candidates_for({s.name for s in e.free_symbols}):
        for positive in _senses(c.read(e), c.system):
            ratio = sp.cancel(c.read(greater - less) / positive)
            if ratio.is_positive:
                return True
    return False
