"""Grading one answer from Python: for the tests of a notebook (nbgrader, Otter) and the graders of a platform.

    grade = lagrange.grade("ex11", "l theta'' + g sin theta = 0")
    grade.points(4)      # 4.0: the last line of a test cell of nbgrader with 4 points
    grade.require()      # an AssertionError with the feedback, where it is not right: a test of Otter
    print(grade)         # the feedback

No answer raises an exception: what cannot be read earns no points, and the feedback says why. The feedback
never contains the equations asked for; at hint level 1 it only says which equations are wrong.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from functools import lru_cache
from os import PathLike
from pathlib import Path

from lagrange.answers.examiner import Examiner
from lagrange.answers.submissions import Graded, Grader, Submission
from lagrange.answers.verdicts import MARKS, Verdict
from lagrange.api.limits import LONGEST_FEEDBACK
from lagrange.core.diagnostics import Diagnostic, ProblemError, Source
from lagrange.core.printable import visible
from lagrange.core.records import record
from lagrange.explain.report import Report, report
from lagrange.mechanics.questions.ranges import branches_with
from lagrange.problem.library import is_file_name, path_of
from lagrange.problem.limits import MAX_BYTES
from lagrange.problem.loader import read_problem
from lagrange.problem.sources import read_source
from lagrange.problem.variants.writing import variant_source

WIDTH = 78


@record
class Grade:
    """The grade of an answer.

    verdict   "equivalent", "wrong", "incomplete", "trivial", "unreadable" or "undecided"
    score     the points by the weights of the problem; None if a person has to look at it
    out_of    the points of a complete answer
    feedback  the feedback in plain text
    """

    verdict: Verdict
    score: float | None
    out_of: float
    feedback: str

    @property
    def fraction(self) -> float:
        """The score as a part of a complete answer, from 0 to 1; 0 if it could not be judged."""
        return 0.0 if self.score is None else min(1.0, max(0.0, self.score / self.out_of))

    def points(self, worth: float = 1.0) -> float:
        """The points of a question that is worth so many; prints the feedback where they are not all of them."""
        if self.fraction < 1:
            print(self.feedback)
        return worth * self.fraction

    def require(self, fraction: float = 1.0) -> None:
        """Raises AssertionError, with the feedback, where less than a fraction of the answer is right."""
        if self.fraction < fraction:
            raise AssertionError(f"\n{self.feedback}")

    def __str__(self) -> str:
        return self.feedback


def grade(problem: str | PathLike[str], answer: str, *, hint: int = 1, seed: str = "", kind: str = ".txt") -> Grade:
    """The grade of an answer.

    problem  a problem file, or the name of a shipped problem
    answer   the text handed in: equations in lines, with prose around them as in a file of answers
    hint     how much the feedback reveals about a wrong equation: 1, 2 or 3
    seed     the student's seed, for a problem with `vary`
    kind     the extension that a file with this text would have: ".tex", ".md", ".yaml"

    Raises ProblemError if the problem cannot be read or solved.
    """
    text = problem if isinstance(problem, str) else str(Path(problem))
    return grade_source(read_source(Path(text) if is_file_name(text) else path_of(text)), answer, hint, seed, kind)


def grade_source(problem: Source, answer: str, hint: int = 1, seed: str = "", kind: str = ".txt") -> Grade:
    """The same for a problem as a text."""
    if hint not in (1, 2, 3):
        raise ValueError(f"the hint levels are 1, 2 and 3, and not {hint!r}")
    content = answer.encode("utf-8", "replace")[: MAX_BYTES + 1]
    graded = _grader(problem, seed).grade(Submission("answer", ((f"answer{kind}", content),)))
    return grade_of(graded, hint)


def grade_of(graded: Graded, hint: int) -> Grade:
    """The grade for the outcome of a submission."""
    return Grade(graded.verdict, graded.points, graded.possible or 1.0, feedback_text(graded.at_hint_level(hint)))


@lru_cache(maxsize=8)
def _grader(problem: Source, seed: str) -> Grader:
    if seed:
        from lagrange.problem.variants.writing import variant_source

        problem = variant_source(problem, seed)
    return Grader.of(Examiner.of(read_problem(problem)))


def feedback_text(graded: Graded) -> str:
    """The feedback for the author of an answer, in plain text."""
    text = visible("\n".join(_lines(graded)))
    return text if len(text) <= LONGEST_FEEDBACK else f"{text[:LONGEST_FEEDBACK]}\n..."


def _lines(graded: Graded) -> Iterator[str]:
    yield from _wrapped(graded.headline, "")
    if graded.verdict is Verdict.UNDECIDED:
        yield from _wrapped("No points were taken off: a person has to look at this answer.", "")
    for answer in graded.others:
        yield from _wrapped(f"{MARKS[answer.verdict]} {answer.name.replace('_', ' ')}", "  ")
        yield from _wrapped(answer.diagnosis, "      ")
    for equation in graded.equations:
        yield from _wrapped(f"{MARKS[equation.verdict]} {' '.join(equation.text.split())}", "  ")
        for sentence in (equation.diagnosis, *equation.remarks):
            yield from _wrapped(sentence, "      ")
    for message in graded.messages:
        yield from ("", *message.splitlines())


def _wrapped(sentence: str, indentation: str) -> list[str]:
    return textwrap.wrap(
        sentence, WIDTH, initial_indent=indentation, subsequent_indent=f"{indentation}  ", break_on_hyphens=False
    )


# -- Variants of a problem, and whether one still has an answer --------------------------------------------------------
#
# Values that a file may have can still be unfit: a spring too weak to hold its mass upright, a speed too small for a
# question to have an answer, stated answers in numbers that belong to other values. So a variant is solved like any
# problem, and what it asks for must be there: every check holds, every question has a value, every equilibrium that
# is
# asked for has a position. Values that do not pass are refused and not drawn again: which values a seed means must
# not
# depend on what some version of the program can solve.


def variant(source: Source, seed: str) -> Source:
    """The problem file of the variant that a seed draws. Raises ProblemError if it has no answer, or no `vary`."""
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
    """Messages about what a problem asks for and its solution lacks."""
    yield from (d.message for d in solved.shortcomings)
    solution, values = solved.solution, solved.values
    for asked in solution.asked:
        if not asked.branches or (values is not None and not branches_with(asked, values)):
            yield f"the question `{asked.question.name}` has no answer with these values"
    for view in solution.views:
        if view.in_numbers is not None and not view.in_numbers.positions:
            yield "there is no equilibrium with these values"
