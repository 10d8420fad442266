"""A wrong equation that is right for one sense of the motion: friction turns with the velocity.

m x'' = −k x − μ m g is right while x' > 0. In the derived equations the sign of x' is put to +1 and to −1 (and |x'| to
x' and −x'); if the equation follows from one of the two systems, it holds while the velocity has that sign. Where the
answer says so itself, it is right as far as it goes.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.limits import MOST_SENSES
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.answers.written.cases.by_sense import single_condition
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.document.math_writer import text
from lagrange.expressions.reader import read_value
from lagrange.mechanics.dynamics.comparison import Standing, System, compare

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
