"""Variants of a problem, and whether one still has an answer.

Values that a file may have can still be unfit: a spring too weak to hold its mass upright, a speed too small for a
question to have an answer, stated answers in numbers that belong to other values. So a variant is solved like any
problem, and what it asks for must be there: every check holds, every question has a value, every equilibrium that is
asked for has a position. Values that do not pass are refused and not drawn again: which values a seed means must not
depend on what some version of the program can solve.
"""

from __future__ import annotations

from collections.abc import Iterator

from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.explain.report import Report, report
from lagrange.mechanics.questions.in_numbers import branches_with
from lagrange.problem.loader import read_problem
from lagrange.problem.variants.writing import variant_source


def variant(source: Source, seed: str) -> Source:
    """The problem file of the variant that a seed draws. Raises ProblemError where it has no answer, or no `vary`."""
    drawn = variant_source(source, seed)
    problem = read_problem(drawn)
    try:
        reasons = list(_unanswered(report(problem, complete=False)))
    except ProblemError as error:  # a question whose condition never holds
        reasons = [d.message for d in error.diagnostics]
    if reasons:
        heading = drawn.text.split("\n", 1)[0].removeprefix("# The variant of the seed ")
        message = f"the variant {heading} has no answer: {reasons[0]}"
        help_ = "leave out of `vary` the values that do not fit; stated answers are written in letters"
        raise ProblemError(Diagnostic("variant-without-answer", message, help=help_))
    return drawn


def _unanswered(solved: Report) -> Iterator[str]:
    """What a solved problem asks for and does not have."""
    yield from (d.message for d in solved.shortcomings)
    solution, values = solved.solution, solved.values
    for asked in solution.asked:
        if not asked.branches or (values is not None and not branches_with(asked, values)):
            yield f"the question `{asked.question.name}` has no answer with these values"
    for view in solution.views:
        if view.in_numbers is not None and not view.in_numbers.positions:
            yield "there is no equilibrium with these values"
