r"""Submissions: the equations in a file, and the verdict on everything handed in for a problem.

A submission is a file, or the files of a folder, whose equations together are the answer. It comes from a stranger:
what cannot be read is a verdict on it like any other, never an exception; bounds on time and memory are the caller's
task. Of the `required` independent equations, those that follow from the submitted ones are `right`; a wrong equation
counts for nothing. Messages name what is wrong, never the equations asked for.

Where a file has its equations depends on its extension:

    .tex             between `$`, in displays and in environments, if there is a `=`; without any mathematics and
                     without `\begin{document}`, each line
    .md              the same, fenced code and code spans; without any of these, each line
    everything else  each line, and displays and environments over several lines

A line without a `=` is prose. A line with one is an equation, which may follow a number, a label or a bullet; if it has
a `$`, the equation is between them. Comments are lines that begin with `#` or `%`, and in LaTeX everything after a `%`.
Every equation knows its place in the file.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import PurePath
from time import perf_counter

from lagrange.answers.examiner import Examiner
from lagrange.answers.limits import MAX_FILE_LINES, MAX_MARKS, MAX_SIGNS
from lagrange.answers.points import Score, as_number, score, unread_score
from lagrange.answers.questions.stability_in_text import is_about_stability
from lagrange.answers.questions.stated_constraints import stated_in_words
from lagrange.answers.questions.values_in_text import is_expressions, with_sign_after_names
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Judgement, Verdict
from lagrange.answers.written.cases import with_cases
from lagrange.answers.written.joined_lines import has_sign_of_equality, is_mathematics, joined_lines
from lagrange.answers.written.lines import equations_of_line
from lagrange.answers.written.notation.documents import (
    cells_of_row,
    in_plain_text,
    is_list_of_dashes,
    macros_of,
    text_of_html,
    with_macros,
    without_named_letters,
)
from lagrange.answers.written.notation.habits import in_usual_signs
from lagrange.answers.written.notation.matrices import with_bracketed_arrays
from lagrange.answers.written.notation.numbers import with_decimal_points
from lagrange.answers.written.notation.programs import declares, equations_of_program
from lagrange.answers.written.notation.rare import ratios_of
from lagrange.answers.written.notation.typesetters import in_plain_formulas
from lagrange.answers.written.numbering import without_numbers
from lagrange.answers.written.values import stability_of_it
from lagrange.core.diagnostics import Diagnostic, Fragment, NotCoveredError, ProblemError, Source, Span, UndecidedError
from lagrange.core.records import record
from lagrange.expressions.edits import cuts
from lagrange.expressions.latex_layout import (
    LayoutMark,
    OneEquation,
    Region,
    delimited,
    equations,
    has_equation,
    marks_of,
    rows,
)
from lagrange.expressions.reader import is_inequality
from lagrange.problem.model import Answers
from lagrange.problem.sources import decode
from lagrange.problem.stated_answers import read_answers

_BULLET = re.compile(r"\s*(?:[*•◦▪]\s+)?")
_MARKDOWN_BULLET = re.compile(r"\s*(?:>\s*)*(?:[-+*]\s+)?")
_NUMBER = re.compile(r"(?:\(\s*(?P<round>[0-9]{1,2})\s*\)\s*|(?P<point>[0-9]{1,2})\.\s+)")
_ENUMERATION = re.compile(r"(?:[0-9]{1,2}|[a-z]|[ivx]{1,4})\s?\)\s*")
_LABEL = re.compile(
    r"[^=:\\${}()+*/^<>≤≥;]{0,60}:(?!=)\s*|\s*(?:for|if|when|where|für|wenn|falls|pour|si)\s[^=:\\${}()+*/^;]{0,60}:(?!=)\s*"
    r"|[^\W\d_][^=:\\${}()+*/^]{2,40}\s\((?:at\s+)?[^()=:]{1,12}=[^()=:]{1,12}\)\s*:(?!=)\s*"
)
"""`Eq. 1:`, `for x' > 0:`, `Top (θ = π):` before an equation. Any other inequality before a colon is a statement."""
_LABEL_WITH_MATHEMATICS = re.compile(
    r"(?=[^=:\\${}\n]*[^\W\d_]{2})[^=:\\${}\n<>≤≥]{1,80}(?<=[\w)]):(?!=)\s+(?=[^=:]*=)"
)
"""`integrating factor e^(k t): `, `(1) in (2): `: words and expressions before an equation."""
_FENCE = re.compile(r"\s{0,3}(?:[-*+]\s+|[0-9]{1,2}[.)]\s+)?(?P<fence>`{3,}|~{3,})")
_SPAN = re.compile(r"(?<!`)(?P<ticks>`{1,2})(?!`)(?P<code>[^`\n]{1,2000})(?P=ticks)(?!`)")
_BODY, _END = re.compile(r"\\begin\s?\{document\}"), re.compile(r"\\end\s?\{document\}")
_SENTENCE = re.compile(r"[.;:]\s|\n\s*\n|\\end\{|\\\]|\$\$|\\(?:sub)*section")
_INLINE = ("$", r"\(", r"\)")
_HEADING = re.compile(
    r"\s*(?:[^\W\d_]+\s+){0,6}(?:about|around|near|at|um|bei)\s+[^:'\u0307\u0308¨]{1,60}:\s*\Z", re.IGNORECASE
)
"""A line under which others stand: `linearised about θ1 = θ2 = 0:`."""
_NOTHING = ("no-equations",)
"""The mistakes of a problem that has nothing to compare an answer with."""


def equations_in_file(source: Source, ending: str, *, conditions: bool = False) -> tuple[Fragment, ...]:
    """The equations in a text; `ending` is the file's extension: `.tex`, `.md`, ...

    conditions  whether inequalities count as well, a line each

    Raises ProblemError at mathematics that is not closed, and at a line that continues another.
    """
    fragment = Fragment(source.text, Span(source, 0, len(source.text)), 0)
    _check_size(fragment)
    if (plain := without_numbers(with_decimal_points(source.text))) != source.text:
        fragment = Fragment(plain, fragment.whole, 0)
    if conditions and is_inequality(fragment):
        return tuple(_conditions(fragment))
    if macros := macros_of(source.text):
        return tuple(with_macros(e, macros) for e in _found(fragment, source, ending))
    return tuple(_found(fragment, source, ending))


def _found(fragment: Fragment, source: Source, ending: str) -> Iterator[Fragment]:
    """The equations in a text, as its extension says."""
    match ending.lower():
        case ".tex" | ".latex" | ".ltx":
            yield from _in_latex(fragment)
        case ".html" | ".htm" | ".xhtml":
            text = without_numbers(with_decimal_points(text_of_html(source.text)))
            yield from _in_lines(Fragment.of(text, source.name))
        case ".md" | ".markdown":
            yield from _in_markdown(fragment)
        case _:
            text = without_named_letters(in_plain_text(fragment.text))
            yield from _in_lines(fragment if text == fragment.text else Fragment.of(text, source.name))


def answer_in_file(
    source: Source, ending: str, *, conditions: bool = False, names: Collection[str] = ()
) -> tuple[Fragment, ...]:
    """The equations in a text; the text itself if it has none, but words that are judged, or expressions alone.

    conditions  whether inequalities count as well, a line each
    names       of questions: what follows one of them and a colon is its answer

    Raises ProblemError as `equations_in_file` does.
    """
    source = replace(source, text=with_sign_after_names(source.text, names)) if names else source
    usual = with_bracketed_arrays(with_cases(in_usual_signs(in_plain_formulas(source.text))))
    source = replace(source, text=usual, original=source.text if usual != source.text else "")
    equations = equations_in_file(source, ending, conditions=conditions)
    in_words = not equations and (stated_in_words(source.text) != Answers() or is_about_stability(source.text))
    if in_words or (not equations and is_expressions(source.text)):
        return (Fragment(source.text, Span(source, 0, len(source.text)), 0),)
    return equations


def answer_to(examiner: Examiner, source: Source, ending: str) -> tuple[Fragment, ...]:
    """The parts of a text that may answer the questions of a problem. Raises as `equations_in_file` does."""
    names = examiner.names_of_questions
    return answer_in_file(source, ending, conditions=examiner.reads_inequalities, names=names)


def _conditions(fragment: Fragment) -> Iterator[Fragment]:
    """The lines with inequalities, each without words before it, and the other lines with equations."""
    number = results = 0
    fragment = replace(fragment, text=_ENVIRONMENT.sub(lambda m: " " * len(m[0]), fragment.text))
    for start, end in _lines(fragment.text):
        if not is_inequality(_part(fragment, start, end)):
            found = [*_in_lines(_part(fragment, start, end))]
            results += len(found)
            yield from found
            continue
        if results and _PROVISO.match(fragment.text, start, end):
            continue
        if also := _AND_ALWAYS.search(fragment.text, start, end):
            end = also.start()
        places = [(start + a, start + b) for a, b in cuts(fragment.text[start:end], _BETWEEN_STATEMENTS)]
        places = [place for place in places if _ALWAYS_IF.fullmatch(fragment.text, *place) is None] or places
        ended = any(fragment.text[a:b].strip() in (".", "\\\\") for (_, a), (b, _) in pairwise(places))
        if not ended and all(is_inequality(_part(fragment, *place)) for place in places):
            places = [(places[0][0], places[-1][1])]
        for begins, stop in places:
            if not is_inequality(_part(fragment, begins, stop)):
                yield from _in_lines(_part(fragment, begins, stop))
                continue
            begins += _beginning(fragment.text[begins:stop], number, _BULLET)
            number += 1
            kept = fragment.text[begins:stop].strip(" .,;\r")
            kept = kept.strip(" $.,;") if kept.count("$") <= 2 and kept[:1] == kept[-1:] == "$" else kept
            if display := _DISPLAY.fullmatch(kept):
                kept = display[1]
            begins += fragment.text[begins:stop].find(kept)
            yield _part(fragment, begins, begins + len(kept))


_DISPLAY = re.compile(r"\\[\[(]\s*(.*?)[\s.,;]*\\[\])]")
_ALWAYS = r"\b(?:every|any|all|each|whatever|always|jede\w*|immer|toujours|toute?s?)\b[^<>≤≥=,;.]*"
_IF = r"\b(?:if|when|for|wenn|falls|für|si)\b[^,;]*[<>≤≥]"
_ALWAYS_IF = re.compile(rf"\s*(?:and\s+|und\s+)?{_IF}[^,;]*[,:][^<>≤≥=]*{_ALWAYS}", re.IGNORECASE)
_AND_ALWAYS = re.compile(
    rf"[,;]\s*(?:and\s+|und\s+)?[^<>≤≥=,;]{{0,40}}{_ALWAYS}{_IF}[^,;<>≤≥]*?(?=[.;]?\s*\Z)", re.IGNORECASE
)
_PROVISO = re.compile(
    r"(?![^=<>≤≥]*(?:rest|slid|slip|hold|held|equilibr|mov|tip|stand|stay|balance|lock|stab|possib|ruht|gleit|haft|bleib|kipp))"
    r"[^=<>≤≥$]*[^\W\d_]{3,}[^=<>≤≥$]*,\s*(?:if|provided(?:\s+that)?|as\s+long\s+as|falls|wenn|si)\s",
    re.IGNORECASE,
)
"""`the greatest, if $\\alpha + \\rho < \\frac{\\pi}{2}$`: where a result exists that was stated before."""
"""`if mu*nu >= 1, at every angle`: when a condition of rest beside it is no restriction."""
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\s?\{(?:align(?:ed)?|gather(?:ed)?|equation|split|eqnarray)\*?\}")
_BETWEEN_STATEMENTS = re.compile(r";|\\\\|==?>|⇒|⟹|→|->|(?<=[\w)$}])\.\s+(?=[A-Z][a-z]*\s)")


def _check_size(fragment: Fragment) -> None:
    """Refuse a file with more signs or lines than any answer has, before a record is made of each of them."""
    text = fragment.text
    for number, most, what in (
        (text.count("="), MAX_SIGNS, "signs of equality"),
        (sum(map(text.count, "\\${}()[],;`")), MAX_MARKS, "brackets, commas and commands"),
        (text.count("\n"), MAX_FILE_LINES, "lines"),
    ):
        if number > most:
            message = f"a file may have {most:,} {what}; this one has {number:,}"
            help_ = "hand in the equations asked for, and not everything that was computed"
            raise ProblemError(Diagnostic("too-many-equations", message, fragment.span(0, 20), help=help_))


def _part(fragment: Fragment, start: int, end: int) -> Fragment:
    return Fragment(fragment.text[start:end], fragment.span(start, end), (fragment.start or 0) + start)


def _regions(fragment: Fragment, marks: Sequence[LayoutMark]) -> list[Region]:
    """The mathematics with equations in it."""
    regions, unclosed = delimited(marks)
    if unclosed:
        first = unclosed[0]
        message = f"this `{fragment.text[first.start : first.end]}` is not closed"
        span = fragment.span(first.start, first.end)
        raise ProblemError(Diagnostic("not-closed", message, span, help="close the mathematics where it ends"))
    return [r for r in regions if has_equation(marks, r)]


def _in_latex(fragment: Fragment) -> Iterator[Fragment]:
    begins, ends = _BODY.search(fragment.text), _END.search(fragment.text)
    start = begins.end() if begins else 0
    body = _part(fragment, start, ends.start() if ends and ends.start() > start else len(fragment.text))
    marks = marks_of(body.text)
    regions = _regions(body, marks)
    if regions or begins:
        for r in regions:
            words = _SENTENCE.split(body.text[max(0, r.opens - 200) : r.opens].rstrip(" :"))[-1].strip()
            yield from (replace(e, beside=f"{words} {e.beside}".strip()) for e in rows(body, marks, r))
    else:
        yield from _in_lines(body)


def _in_markdown(fragment: Fragment) -> Iterator[Fragment]:
    blanked, placed = _code(fragment)
    marks = marks_of(blanked)
    for region in _regions(Fragment(blanked, fragment.whole, fragment.start), marks):
        placed += [(region.start, equation) for equation in rows(fragment, marks, region)]
    if placed:
        yield from (equation for _, equation in sorted(placed, key=lambda pair: pair[0]))
    else:
        yield from _in_lines(fragment, _MARKDOWN_BULLET)


def _code(fragment: Fragment) -> tuple[str, list[tuple[int, Fragment]]]:
    """The text with its code blanked out, and the equations in the code, each with its place."""
    blanked: list[str] = []
    placed: list[tuple[int, Fragment]] = []
    fence, begins = "", 0
    for start, end in [*_lines(fragment.text), (len(fragment.text), len(fragment.text))]:
        line = fragment.text[start:end]
        opens = _FENCE.match(line)
        last = start == len(fragment.text) and bool(fence)
        if fence and (last or (opens and opens["fence"].startswith(fence) and not line[opens.end() :].strip())):
            placed += [(begins, equation) for equation in _in_lines(_part(fragment, begins, max(begins, start)))]
            fence, line = "", " " * len(line)
        elif fence:
            line = " " * len(line)
        elif opens:
            fence, begins, line = opens["fence"], min(end + 1, len(fragment.text)), " " * len(line)
        else:
            kept, at = [], 0
            for span in _SPAN.finditer(line):
                if "=" in span["code"]:
                    code = _part(fragment, start + span.start("code"), start + span.end("code"))
                    placed += [(start + span.start(), equation) for equation in equations(code)]
                    kept += [line[at : span.start()], " " * len(span[0])]
                    at = span.end()
            line = "".join([*kept, line[at:]])
        blanked.append(line)
    return "\n".join(blanked[:-1]), placed


def _in_lines(fragment: Fragment, bullet: re.Pattern[str] = _BULLET) -> Iterator[Fragment]:
    """The lines that are equations, and mathematics in displays and environments, over several lines too."""
    if of_program := equations_of_program(fragment):
        yield from of_program
        return
    if is_list_of_dashes(fragment.text):
        bullet = _MARKDOWN_BULLET
    marks = [m for m in marks_of(fragment.text) if m.kind not in _INLINE]
    regions = _regions(fragment, marks)
    next_region = 0
    number = 0
    block: list[tuple[int, int, str]] = []
    words = ""
    labels = frozenset(_label(m) for s, e in _lines(fragment.text) if (m := _NUMBER.match(fragment.text, s, e)))
    for start, end in _lines(fragment.text):
        line = fragment.text[start:end]
        inside = next_region and start < regions[next_region - 1].closes
        opens = next_region < len(regions) and regions[next_region].opens < end
        if not inside and not opens and line.strip() and not line.lstrip().startswith(("#", "%", "//")):
            if declares(line):
                continue
            block.append((start, end, line))
            continue
        for e in _of_block(fragment, block, number, bullet, words, labels):
            number += 1
            yield e
        block, words = [], (block[-1][2] if block and "=" not in block[-1][2] else "")
        while next_region < len(regions) and regions[next_region].opens < end:
            in_region = rows(fragment, marks, regions[next_region])
            number, next_region = number + len(in_region), next_region + 1
            yield from (replace(e, beside=f"{words} {e.beside}".strip()) for e in in_region)
        for a, b in _outside(regions, start, end):
            if not has_sign_of_equality(fragment.text[a:b]) or fragment.text[a:b].lstrip().startswith("%"):
                continue
            for e in _of_block(fragment, [(a, b, fragment.text[a:b])], number, bullet, words, labels):
                number += 1
                yield e
    yield from _of_block(fragment, block, number, bullet, words, labels)


def _outside(regions: Sequence[Region], start: int, end: int) -> Iterator[tuple[int, int]]:
    r"""The parts of a line beside the displays in it, `\[ y = a \] and $x = b$`."""
    for region in (*regions, None):
        stop = min(region.opens, end) if region else end
        if start < stop:
            yield start, stop
        start = max(start, region.closes) if region else end


def _of_block(
    fragment: Fragment,
    lines: list[tuple[int, int, str]],
    number: int,
    bullet: re.Pattern[str],
    words: str,
    labels: frozenset[int],
) -> Iterator[Fragment]:
    """The equations in lines between empty ones."""
    places = [*joined_lines(lines)]
    for n, (start, end) in enumerate(places):
        line = fragment.text[start:end]
        if cells := cells_of_row(line):
            for a, b in cells:
                for e in _of_block(fragment, [(start + a, start + b, line[a:b])], number, bullet, words, labels):
                    number += 1
                    yield e
        elif _HEADING.match(line):
            words = line.strip()
        elif has_sign_of_equality(line):
            begins = start + _beginning(line, number, bullet, labels)
            beside = f"{words} {fragment.text[start:begins]}".strip()
            found = [*equations_of_line(_part(fragment, begins, end), beside)]
            of_last = stability_of_it(fragment.text[slice(*places[n + 1])]) if n + 1 < len(places) else ""
            for k, e in enumerate(found, 1):
                number += 1
                is_last = k == len(found) and bool(of_last)
                yield replace(e, beside=f"{e.beside}; {of_last}") if is_last and isinstance(e, OneEquation) else e
        elif not is_mathematics(line):
            words = line.strip()


def _label(numbered: re.Match[str]) -> int:
    return int(numbered["round"] or numbered["point"])


def _beginning(line: str, number: int, bullet: re.Pattern[str], labels: Collection[int] = ()) -> int:
    """Where the equation begins in a line: after a bullet, its number, or a label that ends with a colon.

    `(2)` and `2.` are numbers before the second equation and where another line begins with `(1)` or `(3)`, and
    factors elsewhere.
    """
    matched = bullet.match(line)
    at = matched.end() if matched else 0
    if (numbered := _NUMBER.match(line, at)) and (
        _label(numbered) == number + 1 or not {_label(numbered) - 1, _label(numbered) + 1}.isdisjoint(labels)
    ):
        at = numbered.end()
    elif not numbered and (enumerated := _ENUMERATION.match(line, at)):
        at = enumerated.end()
    if any(map(ratios_of, re.split(r"[,;]\s", line[at:]))):
        return at
    label = _LABEL.match(line, at) or _LABEL_WITH_MATHEMATICS.match(line, at)
    return label.end() if label else at


def _lines(text: str) -> Iterator[tuple[int, int]]:
    """Where each line begins and ends."""
    start = 0
    while start <= len(text):
        end = text.find("\n", start)
        end = len(text) if end < 0 else end
        yield start, end
        start = end + 1


@record
class Submission:
    """A submission to be graded.

    name     its name, which is safe to be shown
    files    name and content of each file; none if nothing was handed in for this problem
    notes    what was ignored in it
    problem  which of the problems of an assignment it answers, from 0
    seed     the seed of the student's variant of the problem; empty if the problem is the same for all
    """

    name: str
    files: tuple[tuple[str, bytes], ...]
    notes: tuple[str, ...] = ()
    problem: int = 0
    seed: str = ""


@record
class Graded:
    """The outcome for one submission: texts and numbers only, since it goes from one process to another.

    headline   the verdict in one sentence
    equations  the verdict on each equation
    together   the verdict on the equations together
    others     the verdicts on answers to other questions, each with its parts
    messages   errors and notes with their places, for the author of the submission
    right      the number of independent equations that it has; None if that is not known
    required   the number asked for; None if equations are not what is counted
    score      the points, part by part; None if the submission could not be graded at all
    """

    verdict: Verdict
    headline: str
    equations: tuple[EquationVerdict, ...] = ()
    messages: tuple[str, ...] = ()
    right: int | None = None
    required: int | None = None
    seconds: float = 0.0
    others: tuple[AnswerVerdict, ...] = ()
    together: Verdict = Verdict.EQUIVALENT
    score: Score | None = None

    def at_hint_level(self, level: int) -> Graded:
        """The outcome with the diagnoses of a hint level: 1, 2 or 3, which is all of it."""
        equations = tuple(e.at_hint_level(level) for e in self.equations)
        others = tuple(a.at_hint_level(level) for a in self.others)
        return replace(self, equations=equations, others=others)

    @property
    def points(self) -> float | None:
        """The points earned; None if a person has to look at it."""
        return None if self.score is None or not self.score.settled else as_number(self.score.points)

    @property
    def possible(self) -> float | None:
        """The points for a complete answer."""
        return None if self.score is None else as_number(self.score.possible)

    @property
    def remark(self) -> str:
        """The most important remark: the parts that are not right, and the first diagnosis or else another remark."""
        diagnoses = [a.diagnosis for a in self.others if a.diagnosis]
        diagnoses += [e.diagnosis for a in self.others for e in a.equations if e.diagnosis]
        diagnoses += [e.diagnosis for e in self.equations if e.diagnosis and e.verdict is not Verdict.EQUIVALENT]
        remarks = [r for e in self.equations for r in e.remarks]
        if self.verdict is Verdict.EQUIVALENT:
            return next(iter([*diagnoses, *remarks]), "")
        if parts := self._of_parts:
            return "; ".join([parts, *diagnoses[:1]])
        return next(iter(diagnoses), self.headline.partition(": ")[2])

    @property
    def _of_parts(self) -> str:
        """`degrees of freedom wrong, equations right`; empty unless questions are answered beside the equations."""
        parts = [(a.name.replace("_", " "), a.verdict) for a in self.others]
        parts += [("equations", self.together)] if parts and self.equations else []
        return ", ".join(f"{name} {'right' if v is Verdict.EQUIVALENT else v.value}" for name, v in parts)


def _without_sides(equations: Sequence[EquationVerdict]) -> tuple[EquationVerdict, ...]:
    """The verdicts without expressions: what goes from one process to another is text."""
    return tuple(replace(e, sides=()) for e in equations)


@record
class Grader:
    """Grades any number of submissions to one problem. `required` is as in `Graded`."""

    examiner: Examiner
    required: int | None

    @classmethod
    def of(cls, examiner: Examiner) -> Grader:
        """A grader with the number of equations asked for. Raises ProblemError if there is nothing to compare with."""
        if examiner.solution is None and examiner.required is None and not examiner.problem.points:
            examiner.check((Fragment.of("0 = 0"),))
        return cls(examiner, examiner.required)

    def grade(self, submission: Submission) -> Graded:
        """The verdict on a submission."""
        start = perf_counter()
        if not submission.files:
            return self._unread(Verdict.INCOMPLETE, "nothing was handed in for this problem", submission.notes)
        try:
            judgement = self._checked(submission)
            if judgement is None:
                return self._unread(Verdict.UNREADABLE, "there is no equation in it", submission.notes)
        except ProblemError as error:
            undecided = isinstance(error, UndecidedError | NotCoveredError) or error.diagnostics[0].code in _NOTHING
            verdict = Verdict.UNDECIDED if undecided else Verdict.UNREADABLE
            messages = (*(str(d) for d in error.diagnostics), *submission.notes)
            return self._unread(verdict, error.diagnostics[0].message, messages)
        return Graded(
            judgement.verdict,
            judgement.headline,
            _without_sides(judgement.each),
            (*(str(d) for d in judgement.messages), *submission.notes),
            self._right(judgement),
            None if judgement.statics else self.required,
            perf_counter() - start,
            tuple(
                AnswerVerdict(a.verdict, _without_sides(a.equations), name=a.name, diagnosis=a.diagnosis)
                for a in judgement.others
            ),
            judgement.equations.verdict,
            score(self.examiner.problem, judgement, self.required),
        )

    def _checked(self, submission: Submission) -> Judgement | None:
        """The verdict on a whole submission; None if it is empty. Raises ProblemError."""
        fragments: list[Fragment] = []
        answers: Answers | None = None
        for name, content in submission.files:
            source, ending = decode(content, name), PurePath(name).suffix.lower()
            if ending not in (".yaml", ".yml"):
                fragments += answer_to(self.examiner, source, ending)
                if len(fragments) > MAX_SIGNS:
                    message = f"a submission may have {MAX_SIGNS:,} equations in all its files"
                    help_ = "hand in the equations asked for, and not everything that was computed"
                    raise ProblemError(Diagnostic("too-many-equations", message, fragments[-1].whole, help=help_))
            elif answers is None:
                answers = read_answers(source, self.examiner.problem)
            else:
                message = f"there are several files of answers, and {name} is one too many"
                raise ProblemError(Diagnostic("several-answer-files", message, help="put all answers into one file"))
        if answers is not None:
            return self.examiner.check_answers(answers, tuple(fragments))
        return self.examiner.check(tuple(fragments)) if fragments else None

    def unread(self, reason: str) -> Graded:
        """The outcome for a submission that cannot be read at all."""
        return self._unread(Verdict.UNREADABLE, reason, ())

    def _unread(self, verdict: Verdict, reason: str, messages: Sequence[str]) -> Graded:
        judged = verdict in (Verdict.UNREADABLE, Verdict.INCOMPLETE)
        right = 0 if judged and self.required is not None else None
        points = unread_score(self.examiner.problem, verdict, self.required)
        return Graded(verdict, f"{verdict.value}: {reason}", (), tuple(messages), right, self.required, score=points)

    def _right(self, judgement: Judgement) -> int | None:
        """The number of independent equations that follow; None if some could not be judged."""
        verdicts = [e.verdict for e in judgement.each]
        if self.required is None or judgement.statics or Verdict.UNDECIDED in verdicts:
            return None
        if Verdict.EQUIVALENT not in verdicts:
            return 0
        return max(0, self.required - judgement.missing)
