"""One submission graded against a problem that has been solved.

A submission is what somebody handed in: a file, or the files of a folder, whose equations together are the answer. It
comes from a stranger. What cannot be read is a verdict on it, like any other, and never an exception; bounds on time
and memory are the business of whoever calls.

Of the `required` independent equations, those that do not follow from the submitted ones are missing; the others are
`right`. A wrong equation counts for nothing. What is said names what is wrong and never the equations asked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter

from lagrange.answers import EXIT_STATUS, EquationVerdict, Verdict, check_equations
from lagrange.checking import CheckedAnswer, Examiner
from lagrange.diagnostics import Fragment, ProblemError, Source, Span
from lagrange.yaml_nodes import decode


@dataclass(frozen=True)
class Submission:
    """What somebody handed in.

    name   what it is called; it may be shown as it stands
    files  name and content of each file
    notes  what was left aside
    """

    name: str
    files: tuple[tuple[str, bytes], ...]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Graded:
    """The outcome for one submission: texts and numbers, since it goes from one process to another.

    headline   the verdict in one sentence
    equations  the verdict on each equation
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

    @property
    def remark(self) -> str:
        """The first thing to be said: what is wrong, or else what is remarkable."""
        wrong = [e.diagnosis for e in self.equations if e.diagnosis and e.verdict is not Verdict.EQUIVALENT]
        remarks = [r for e in self.equations for r in e.remarks]
        if wrong or self.verdict is Verdict.EQUIVALENT:
            return next(iter([*wrong, *remarks]), "")
        return self.headline.partition(": ")[2]


@dataclass(frozen=True)
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
            sources = [decode(content, name) for name, content in submission.files]
            answer = tuple(e for source in sources for e in equations_in(source))
            if not answer:
                return self._unread(Verdict.UNREADABLE, "there is no equation in it", submission.notes)
            found = self.examiner.check(answer)
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
        )

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


def equations_in(source: Source) -> Iterator[Fragment]:
    """The lines that are neither empty nor comments; each knows where in its file it stands."""
    start = 0
    for line in source.text.split("\n"):
        if line.strip() and not line.lstrip().startswith("#"):
            yield Fragment(line, Span(source, start, start + len(line)), start)
        start += len(line) + 1
