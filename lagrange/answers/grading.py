"""One submission graded against a problem that has been solved.

A submission is what somebody handed in: a file, or the files of a folder, whose equations together are the answer. It
comes from a stranger. What cannot be read is a verdict on it, like any other, and never an exception; bounds on time
and memory are the business of whoever calls.

Of the `required` independent equations, those that do not follow from the submitted ones are missing; the others are
`right`. A wrong equation counts for nothing. What is said names what is wrong and never the equations asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath
from time import perf_counter

from lagrange.answers.answer_files import equations_in_file
from lagrange.answers.equations import EXIT_STATUS, WHAT_IT_IS, EquationVerdict, Verdict, check_equations
from lagrange.answers.examiner import Examiner
from lagrange.answers.recognition import Kind
from lagrange.answers.verdicts import CheckedAnswer
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.problem.answer_yaml import read_answers
from lagrange.problem.model import Answers
from lagrange.problem.yaml_nodes import decode


@record
class Submission:
    """What somebody handed in.

    name   what it is called; it may be shown as it stands
    files  name and content of each file
    notes  what was left aside
    """

    name: str
    files: tuple[tuple[str, bytes], ...]
    notes: tuple[str, ...] = ()


@record
class Graded:
    """The outcome for one submission: texts and numbers, since it goes from one process to another.

    headline   the verdict in one sentence
    equations  the verdict on each equation
    others     name, verdict and diagnosis of the answers to other questions
    messages   errors and notes with their places, for the author of the submission
    right      how many independent equations it has; None where that is not known
    required   how many are asked for; None where equations are not what is counted
    """

    verdict: Verdict
    headline: str
    equations: tuple[EquationVerdict, ...] = ()
    messages: tuple[str, ...] = ()
    right: int | None = None
    required: int | None = None
    seconds: float = 0.0
    others: tuple[tuple[str, Verdict, str], ...] = ()

    @property
    def remark(self) -> str:
        """The first thing to be said: what is wrong, or else what is remarkable."""
        said = (e.diagnosis for e in self.equations if e.diagnosis and e.verdict is not Verdict.EQUIVALENT)
        wrong = [diagnosis.removeprefix(f"{WHAT_IT_IS[Kind.OTHER]}; ") for diagnosis in said]
        remarks = [r for e in self.equations for r in e.remarks]
        if wrong or self.verdict is Verdict.EQUIVALENT:
            return next(iter([*wrong, *remarks]), "")
        return self.headline.partition(": ")[2]


@record
class Grader:
    """Grades any number of submissions to one problem. `required` is as in `Graded`."""

    examiner: Examiner
    required: int | None

    @classmethod
    def of(cls, examiner: Examiner) -> Grader:
        """Counts the equations that are asked for. Raises ProblemError where there is nothing to compare with."""
        nothing = (Fragment.of("0 = 0"),)
        if examiner.solution is not None and examiner.solution.motion is None:
            examiner.check(nothing)
            return cls(examiner, None)
        return cls(examiner, check_equations(nothing, examiner.reference).missing)

    def grade(self, submission: Submission) -> Graded:
        """The verdict on a submission."""
        start = perf_counter()
        try:
            found = self._checked(submission)
            if found is None:
                return self._unread(Verdict.UNREADABLE, "there is no equation in it", submission.notes)
        except ProblemError as error:
            undecided = error.exit_status == EXIT_STATUS[Verdict.UNDECIDED]
            verdict = Verdict.UNDECIDED if undecided else Verdict.UNREADABLE
            messages = (*(str(d) for d in error.diagnostics), *submission.notes)
            return self._unread(verdict, error.diagnostics[0].message, messages)
        return Graded(
            found.verdict,
            found.headline,
            tuple(EquationVerdict(e.text, e.verdict, e.diagnosis, e.remarks) for e in found.equations.equations),
            (*(str(d) for d in found.messages), *submission.notes),
            self._right(found),
            None if found.statics else self.required,
            perf_counter() - start,
            tuple((a.name, a.verdict, a.diagnosis) for a in found.others),
        )

    def _checked(self, submission: Submission) -> CheckedAnswer | None:
        """The verdict on all that was handed in; None where there is nothing. Raises ProblemError."""
        fragments: list[Fragment] = []
        answers: Answers | None = None
        for name, content in submission.files:
            source, ending = decode(content, name), PurePath(name).suffix.lower()
            if ending not in (".yaml", ".yml"):
                fragments += equations_in_file(source, ending)
            elif answers is None:
                answers = read_answers(source, self.examiner.problem)
            else:
                message = f"there are several files of answers, and {name} is one too many"
                raise ProblemError(Diagnostic("several-answer-files", message, help="put all answers into one file"))
        if answers is not None:
            return self.examiner.check_answers(answers, tuple(fragments))
        return self.examiner.check(tuple(fragments)) if fragments else None

    def _unread(self, verdict: Verdict, reason: str, messages: Sequence[str]) -> Graded:
        right = 0 if verdict is Verdict.UNREADABLE and self.required is not None else None
        return Graded(verdict, f"{verdict.value}: {reason}", (), tuple(messages), right, self.required)

    def _right(self, found: CheckedAnswer) -> int | None:
        """How many independent equations follow; None where some could not be judged."""
        verdicts = [e.verdict for e in found.equations.equations]
        if self.required is None or found.statics or Verdict.UNDECIDED in verdicts:
            return None
        if Verdict.EQUIVALENT not in verdicts:
            return 0
        return max(0, self.required - found.equations.missing)
