"""Verdicts on an answer, as records: on each equation, on each question, and on the whole, with its wording.

An answer is equivalent if it has the same solutions as the derived equations; incomplete if it follows from them but
has more solutions; trivial if it excludes nothing; wrong if some part does not follow. The verdict on the whole is the
first of `FIRST` that a part has, else equivalent.

A `Judgement` is written as JSON (FORMAT's object) or as plain text: a headline, then each part with its mark and its
remarks. An equation that may have been misread is shown as it was read. The derived equations are never shown unless
they are passed in as `revealed`.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from enum import Enum, StrEnum, auto

import sympy as sp

from lagrange.answers.limits import MAX_SHOWN_CHARACTERS, WIDEST
from lagrange.core.diagnostics import Diagnostic
from lagrange.core.printable import visible
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.document.math_writer import text as plain
from lagrange.document.math_writer import unicode
from lagrange.document.names import Notation
from lagrange.problem.model import Problem


class Verdict(StrEnum):
    """The verdict on an answer, or on one of its equations."""

    UNREADABLE = "unreadable"
    WRONG = "wrong"
    UNDECIDED = "undecided"
    INCOMPLETE = "incomplete"
    EQUIVALENT = "equivalent"
    TRIVIAL = "trivial"


FIRST = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED, Verdict.INCOMPLETE, Verdict.TRIVIAL)
"""The verdict on several parts is the first of these that one of them has."""

WORST_TO_BEST = (
    Verdict.UNREADABLE,
    Verdict.WRONG,
    Verdict.UNDECIDED,
    Verdict.TRIVIAL,
    Verdict.INCOMPLETE,
    Verdict.EQUIVALENT,
)
"""The best of the verdicts in several sets of coordinates."""

NOT_JUDGED = "not judged, because another equation is unreadable"
DIVIDES_BY_ZERO = "it divides by an expression that is exactly zero"
DOES_NOT_FOLLOW = "it does not follow from the equations of motion"
MIXED_CHOICES = "it mixes coordinates of several choices; use the file's coordinates and those of one choice"
UNDECIDED = "it could not be decided whether it is right"


class Recognised(Enum):
    """The kind of an equation that is not an equation of motion."""

    SQUARE = auto()  # of a right equation
    SUM_OF_SQUARES = auto()
    POWER = auto()  # of a right equation, or a product of several
    HOLDS = auto()  # for the motion, and perhaps for other motions
    NOT_LINEAR = auto()
    ENERGY = auto()
    MOMENTUM = auto()
    INTEGRAL = auto()  # another first integral
    OF_PARAMETERS = auto()  # the state does not occur in it
    IMPOSSIBLE = auto()  # 1 = 0
    NO_ACCELERATION = auto()  # and it does not hold for every motion
    OTHER = auto()

    @property
    def is_first_integral(self) -> bool:
        """Whether its time derivative follows from the equations of motion."""
        return self in (Recognised.ENERGY, Recognised.MOMENTUM, Recognised.INTEGRAL)


WHAT_IT_IS = {
    Recognised.SQUARE: "it is not linear in the accelerations: it is the square of a correct equation",
    Recognised.SUM_OF_SQUARES: (
        "it is not linear in the accelerations: it is composed of squares and products of correct equations"
    ),
    Recognised.POWER: "it is not linear in the accelerations: it is a power, or a product, of correct equations",
    Recognised.HOLDS: "it is not linear in the accelerations, though it holds for the motion",
    Recognised.NOT_LINEAR: "it is not linear in the accelerations, as an equation of motion must be",
    Recognised.ENERGY: "it is a first integral, that of energy; {derivative}",
    Recognised.MOMENTUM: "it is a first integral, that of a momentum; {derivative}",
    Recognised.INTEGRAL: "it is a first integral; {derivative}",
    Recognised.OF_PARAMETERS: "it says nothing about the motion, and does not hold for all values of the parameters",
    Recognised.IMPOSSIBLE: "it can never hold",
    Recognised.NO_ACCELERATION: "it contains no acceleration, and does not hold in every state of motion",
    Recognised.OTHER: DOES_NOT_FOLLOW,
}
"""What is said of each kind of equation."""


@record
class Subject:
    """What the positions of an answer are, as nouns of its diagnoses."""

    one: str
    many: str
    an: str
    at: str


REST = Subject("equilibrium", "equilibria", "an equilibrium", "at")
STEADY_MOTION = Subject("steady motion", "steady motions", "a steady motion", "in")


class Reason(StrEnum):
    """Why an equation is wrong or undecided, where the verdict on others depends on it: its sentence about a subject.

    What decides on a reason compares it and never looks for words in a diagnosis.
    """

    NOWHERE = "it does not hold {s.at} any {s.one}{detail}"
    NOT_REQUIRED = "the conditions of {s.one} do not require it"
    HOLDS_ELSEWHERE = "it has solutions that are not {s.many}"
    HOLDS_WITHOUT = "it also holds where there is no {s.one}"
    HOLDS_WHERE = "it also holds where {detail}, which is not {s.an}"
    CONTRADICTS = "it cannot hold together with the other equations and the constraints"


_UNEXPLAINED = (Reason.NOWHERE, Reason.NOT_REQUIRED, Reason.HOLDS_ELSEWHERE)


@record
class Why:
    """A reason, and what its sentence says more than others for the same reason."""

    reason: Reason
    detail: str = ""

    def about(self, subject: Subject) -> str:
        """The sentence."""
        return self.reason.format(s=subject, detail=self.detail)


MARKS = {
    Verdict.EQUIVALENT: "✓",
    Verdict.WRONG: "✗",
    Verdict.TRIVIAL: "·",
    Verdict.UNREADABLE: "!",
    Verdict.UNDECIDED: "?",
    Verdict.INCOMPLETE: "·",
}


@record
class EquationVerdict:
    """The verdict on one equation, with what is wrong (`diagnosis`) and further remarks.

    sides  both sides as they were read, if the reading may surprise; otherwise empty
    hints  for a wrong equation of motion: the diagnosis at each of the three hint levels, the last being `diagnosis`
    cause  the mistake in a few words, the same for all who made it; empty if it is not known
    model  the name of the model that explains it; empty if none does
    part   of an answer to several questions: the name of the one that it answers
    why    the reason of which `diagnosis` is the sentence; None if nothing depends on it
    kind   what an equation is that is none of motion; None if it was not asked
    """

    text: str
    verdict: Verdict
    diagnosis: str = ""
    remarks: tuple[str, ...] = ()
    sides: tuple[sp.Expr | Vector, ...] = ()
    hints: tuple[str, ...] = ()
    cause: str = ""
    model: str = ""
    part: str = ""
    why: Why | None = None
    kind: Recognised | None = None

    @classmethod
    def because(cls, text: str, why: Why) -> EquationVerdict:
        """The verdict that an equation about equilibria is wrong."""
        return cls(text, Verdict.WRONG, why.about(REST), why=why)

    def is_for(self, *reasons: Reason) -> bool:
        """Whether one of these is the reason."""
        return self.why is not None and self.why.reason in reasons

    @property
    def is_unexplained(self) -> bool:
        """Whether the diagnosis says no more than that positions are wrong."""
        return self.is_for(*_UNEXPLAINED) and self.why is not None and not self.why.detail

    def about(self, subject: Subject) -> EquationVerdict:
        """The verdict with its diagnosis in words of another subject."""
        return self if self.why is None else replace(self, diagnosis=self.why.about(subject))

    @classmethod
    def of(cls, text: str, verdict: Verdict, comment: str) -> EquationVerdict:
        """The verdict with a comment: a remark if it is right, otherwise the diagnosis."""
        right = verdict is Verdict.EQUIVALENT
        return cls(text, verdict, "" if right else comment, (comment,) if right and comment else ())

    def at_hint_level(self, level: int) -> EquationVerdict:
        """The verdict with the diagnosis of a hint level: 1, 2 or 3; only the last names the cause."""
        if not self.hints:
            return self
        shown = self if level == len(self.hints) else replace(self, cause="", model="")
        return replace(shown, diagnosis=self.hints[level - 1])

    def without_cause(self, level: int) -> EquationVerdict:
        """The verdict on a result at a hint level: only the last level says why it is wrong."""
        if self.hints or self.verdict is not Verdict.WRONG:
            return self.at_hint_level(level)
        return replace(self, diagnosis="", cause="", model="")

    def as_json(self) -> dict[str, object]:
        """FORMAT's JSON object, with `cause` and `model` where they are known."""
        written: dict[str, object] = {
            "text": self.text,
            "verdict": self.verdict.value,
            "diagnosis": self.diagnosis,
            "remarks": list(self.remarks),
        }
        written |= {"cause": self.cause} if self.cause else {}
        return written | ({"model": self.model} if self.model else {})

    def lines(self, notation: Notation, width: int, indent: str) -> Iterator[str]:
        """The equation with its mark, and below it the reading, the diagnosis and the remarks."""
        under = indent + _UNDER[len(_INDENT) :]
        room = width - len(under)
        written = " ".join(self.text.split())
        if len(written) > MAX_SHOWN_CHARACTERS:
            written = f"{written[:MAX_SHOWN_CHARACTERS]} ..."
        yield from _wrapped(f"{MARKS[self.verdict]} {_breakable(written, room)}", width, indent, under)
        if self.sides:
            read = " = ".join(unicode(side, notation) for side in self.sides)
            yield from _wrapped(f"read as {_breakable(read, room)}", width, under, under + _INDENT)
        for sentence in (self.diagnosis, *self.remarks):
            if sentence:
                yield from _wrapped(sentence, width, under, under)


_NOT_RIGHT = "not right: "


@record
class AnswerVerdict:
    """The verdict on the answer to one question.

    equations   the verdicts on its equations; for equilibria and reactions, on each part
    missing     how many independent equations (or solutions) are missing
    choice      the choice of coordinates in which it was compared; empty for the file's own
    unreadable  what could not be read, with its place
    notes       how the rest was read, where that may surprise
    name        the question, as the key of `answers` in a problem file
    diagnosis   what is wrong with it, or why it is not judged
    """

    verdict: Verdict
    equations: tuple[EquationVerdict, ...] = ()
    missing: int = 0
    choice: str = ""
    unreadable: tuple[Diagnostic, ...] = ()
    notes: tuple[Diagnostic, ...] = ()
    name: str = "equations"
    diagnosis: str = ""

    @property
    def messages(self) -> tuple[Diagnostic, ...]:
        """What could not be read, then the notes."""
        return (*self.unreadable, *self.notes)

    def at_hint_level(self, level: int) -> AnswerVerdict:
        """The verdict with the diagnoses of a hint level: 1, 2 or 3; 2 tells which parts are not right, only 3 why."""
        if level > 2 or self.verdict not in (Verdict.WRONG, Verdict.UNDECIDED):
            return self
        where, _, _ = self.diagnosis.partition("; ")
        named = where.startswith(_NOT_RIGHT) and level == 2
        kept = where if named or self.verdict is Verdict.UNDECIDED else ""
        return replace(self, equations=tuple(e.without_cause(level) for e in self.equations), diagnosis=kept)

    @property
    def causes(self) -> tuple[str, ...]:
        """The mistakes, each in words that are the same for all who made it."""
        if self.verdict is not Verdict.WRONG:
            return ()
        where, _, why = self.diagnosis.partition("; ")
        own = why if where.startswith(_NOT_RIGHT) and why else self.diagnosis
        parts = (e.cause or e.diagnosis for e in self.equations if e.verdict is Verdict.WRONG)
        return tuple(dict.fromkeys(filter(None, (own, *(parts if not own else ())))))

    def as_json(self) -> dict[str, object]:
        """Name and verdict; diagnosis and equations if there are any."""
        written: dict[str, object] = {"name": self.name, "verdict": self.verdict.value}
        written |= {"diagnosis": self.diagnosis} if self.diagnosis else {}
        return written | ({"equations": [e.as_json() for e in self.equations]} if self.equations else {})


@record
class Judgement:
    """The verdict on an answer.

    verdict    "equivalent", "wrong", "incomplete", "trivial", "unreadable" or "undecided"
    each       the verdicts on the equations, in their order: `verdict`, `diagnosis`, `remarks`, `text`
    equations  the verdict on the equations together
    others     the verdicts on answers to other questions: degrees of freedom, equilibrium, reactions
    statics    whether the equations are those of an equilibrium
    reactions  whether they give the reactions there
    messages   what could not be read, with its place, and how the rest was read where that may surprise
    headline   the verdict in a sentence; `print` shows all of it
    problem    the problem that was answered
    derived    the derived equations, each zero, in the coordinates of the answer; none in statics
    """

    equations: AnswerVerdict
    others: tuple[AnswerVerdict, ...] = ()
    statics: bool = False
    reactions: bool = False
    problem: Problem = field(kw_only=True)
    derived: tuple[sp.Expr, ...] = field(kw_only=True, default=())

    @property
    def verdict(self) -> Verdict:
        """The verdict on everything: the first that applies."""
        verdicts = [self.equations.verdict, *(a.verdict for a in self.others)]
        return next((v for v in FIRST if v in verdicts), self.equations.verdict)

    @property
    def each(self) -> tuple[EquationVerdict, ...]:
        """The verdict on each equation, in their order."""
        return self.equations.equations

    @property
    def missing(self) -> int:
        """How many independent equations the answer lacks."""
        return self.equations.missing

    @property
    def choice(self) -> str:
        """The choice of coordinates used for the comparison; empty for the file's own."""
        return self.equations.choice

    @property
    def messages(self) -> tuple[Diagnostic, ...]:
        """What could not be read, with its place, and how the rest was read where that may surprise.

        That something is not judged is not said where another question judges it.
        """
        judged = {e.text for a in self.others for e in a.equations if e.verdict in _SETTLED}
        every = (*self.equations.messages, *(m for a in self.others for m in a.messages))
        return tuple(m for m in every if m.code != "not-judged" or judged.isdisjoint(_QUOTED.findall(m.message)))

    def at_hint_level(self, level: int) -> Judgement:
        """The same with the diagnoses of a hint level: 1, 2 or 3."""
        equations = tuple(e.at_hint_level(level) for e in self.each)
        others = tuple(a.at_hint_level(level) for a in self.others)
        return replace(self, equations=replace(self.equations, equations=equations), others=others)

    @property
    def headline(self) -> str:
        """The verdict on everything, in one line."""
        headlines = _HEADLINES | (_HEADLINES_OF_STATICS if self.statics else {})
        headlines |= _HEADLINES_OF_REACTIONS[self.statics] if self.reactions else {}
        headlines |= _HEADLINES_OF_ANSWERS if self.others else {}
        missing = missing_equilibria if self.statics else _missing_equations
        return headlines[self.verdict].format(missing=missing(self.missing))

    def as_json(self, revealed: Sequence[sp.Expr] = ()) -> dict[str, object]:
        """FORMAT's JSON object; `answers` are the others, `reference` the derived equations if they are revealed."""
        written: dict[str, object] = {"verdict": self.verdict.value, "equations": [e.as_json() for e in self.each]}
        written["missing"] = self.missing
        if self.others:
            written["answers"] = [a.as_json() for a in self.others]
        if revealed:
            notation = notation_of_problem(self.problem)
            written["reference"] = [f"{plain(e, notation)} = 0" for e in revealed]
        return written

    def text(self, width: int, revealed: Sequence[sp.Expr] = ()) -> str:
        """The verdict in lines of at most `width` characters; longer words have lines of their own.

        revealed  derived equations, each zero, to be shown below it
        """
        notation, width = notation_of_problem(self.problem), min(width, WIDEST)
        lines = [*self._lines(notation, width)]
        if revealed:
            lines += ["", *_wrapped("the derived equations:", width, "", "")]
            for e in revealed:
                lines += _wrapped(f"{plain(e, notation)} = 0", width, _INDENT, _UNDER)
        return "".join(f"{line}\n" for line in lines)

    def _lines(self, notation: Notation, width: int) -> Iterator[str]:
        yield from _wrapped(self.headline, width, "", _INDENT)
        for answer in self.others:
            yield from _wrapped(f"{MARKS[answer.verdict]} {answer.name.replace('_', ' ')}", width, _INDENT, _UNDER)
            if answer.diagnosis:
                yield from _wrapped(answer.diagnosis, width, _UNDER, _UNDER)
            for e in answer.equations:
                yield from e.lines(notation, width, _INDENT + _INDENT)
        for e in self.each:
            yield from e.lines(notation, width, _INDENT)

    def __str__(self) -> str:
        return self.text(80).rstrip("\n")

    def __repr__(self) -> str:
        return f"<Judgement: {self.headline}>"

    def _repr_markdown_(self) -> str:
        """The text, for a notebook."""
        return f"```text\n{self}\n```"


_SETTLED = (Verdict.EQUIVALENT, Verdict.WRONG)
_QUOTED = re.compile(r"`([^`]*)`")
_HEADLINES = {
    Verdict.EQUIVALENT: "equivalent: the equations have the same solutions as the derived ones",
    Verdict.WRONG: "wrong: not every equation follows from the equations of motion",
    Verdict.INCOMPLETE: "incomplete: every equation follows, but {missing}",
    Verdict.TRIVIAL: "trivial: the equations say nothing about the motion",
    Verdict.UNREADABLE: "unreadable: not every equation can be read",
    Verdict.UNDECIDED: "undecided: it could not be settled whether the equations follow",
}
_HEADLINES_OF_STATICS = {
    Verdict.EQUIVALENT: "equivalent: these are the positions of equilibrium, and all of them",
    Verdict.WRONG: "wrong: not every solution is an equilibrium",
    Verdict.TRIVIAL: "trivial: the equations say nothing about the equilibrium",
    Verdict.UNDECIDED: "undecided: it could not be settled whether these are the equilibria",
}
_HEADLINES_OF_REACTIONS = {
    False: {
        Verdict.EQUIVALENT: "equivalent: these are reactions at every position of equilibrium",
        Verdict.WRONG: "wrong: these are not the reactions at every position of equilibrium",
        Verdict.INCOMPLETE: "incomplete: these are not the reactions at every position of equilibrium",
        Verdict.TRIVIAL: "trivial: the equations say nothing about the reactions",
        Verdict.UNDECIDED: "undecided: it could not be settled whether these are the reactions",
    },
    True: {
        Verdict.EQUIVALENT: "equivalent: these are the positions of equilibrium, all of them, and reactions there",
        Verdict.WRONG: "wrong: not every solution is an equilibrium, or the reactions differ",
        Verdict.UNDECIDED: "undecided: it could not be settled whether these are the equilibria and reactions",
    },
}
_HEADLINES_OF_ANSWERS = {
    Verdict.EQUIVALENT: "equivalent: the answers agree with the derivation",
    Verdict.WRONG: "wrong: not all of the answers agree with the derivation",
    Verdict.INCOMPLETE: "incomplete: the answers agree with the derivation, but something is missing",
    Verdict.UNREADABLE: "unreadable: not every answer can be read",
    Verdict.UNDECIDED: "undecided: it could not be settled whether all of the answers are right",
}


def _missing_equations(number: int) -> str:
    return "one independent equation is missing" if number == 1 else f"{number} independent equations are missing"


def missing_equilibria(number: int) -> str:
    """The equilibria missing from an incomplete answer."""
    return "an equation or a solution is missing" if number <= 1 else f"{number} solutions are missing"


def notation_of_problem(problem: Problem) -> Notation:
    """How the symbols of a problem are written."""
    new = [q for c in problem.choices for q in c.coordinates]
    return Notation(
        coordinates=tuple(dict.fromkeys((*problem.slots.coordinates, *new))),
        prescribed=problem.slots.prescribed,
        parameters=tuple(p.symbol for p in problem.parameters),
        forces=problem.unknowns,
        scalar_names=frozenset(problem.scope.scalars),
    )


_INDENT = "  "
_UNDER = "      "
_NO_BREAK = "\u00a0"


def _breakable(equation: str, room: int) -> str:
    """An equation that breaks before its signs and never inside brackets, unless a term is too long for the room."""
    depth, characters = 0, []
    for c in equation:
        depth += (c in "([{") - (c in ")]}")
        characters.append(_NO_BREAK if c == " " and depth > 0 else c)
    words = re.sub("([-+=−]) ", rf"\1{_NO_BREAK}", "".join(characters)).split(" ")
    return " ".join(w if len(w) < room else w.replace(_NO_BREAK, " ") for w in words)


def _wrapped(line: str, width: int, first: str, others: str) -> list[str]:
    """A line, broken at blanks where it is too wide, and inside a word only where that is wider than a line."""
    lines = textwrap.wrap(
        visible(line), max(width, 20), initial_indent=first, subsequent_indent=others, break_on_hyphens=False
    )
    return [x.replace(_NO_BREAK, " ") for x in lines] or [first.rstrip()]
