"""What `lagsolve check` says: the verdict on equations, those on answers to other questions, and a headline."""

from __future__ import annotations

from dataclasses import replace

from lagrange.answers.equations import EXIT_STATUS, AnswerVerdict, EquationVerdict, Verdict
from lagrange.core.diagnostics import Diagnostic
from lagrange.core.records import record


@record
class ComparedAnswer:
    """One answer that is no system of equations of motion, with the verdict on it.

    diagnosis  what is wrong with it, or why nothing is said
    equations  the verdicts on its parts: equilibria, reactions
    messages   what could not be read, with places, and how the rest was read
    """

    name: str
    verdict: Verdict
    diagnosis: str = ""
    equations: tuple[EquationVerdict, ...] = ()
    messages: tuple[Diagnostic, ...] = ()

    def as_json(self) -> dict[str, object]:
        """Name and verdict, and what else there is to say."""
        found: dict[str, object] = {"name": self.name, "verdict": self.verdict.value}
        found |= {"diagnosis": self.diagnosis} if self.diagnosis else {}
        return found | ({"equations": [e.as_json() for e in self.equations]} if self.equations else {})


@record
class CheckedAnswer:
    """The outcome of `lagsolve check`: the verdict on equations; of the file's own answers, on the others too.

    statics    whether the equations are those of an equilibrium
    reactions  whether they are about the reactions there
    """

    equations: AnswerVerdict
    others: tuple[ComparedAnswer, ...] = ()
    statics: bool = False
    reactions: bool = False

    @property
    def verdict(self) -> Verdict:
        """The verdict on everything: the first that applies."""
        found = [self.equations.verdict, *(a.verdict for a in self.others)]
        return next((v for v in FIRST if v in found), self.equations.verdict)

    @property
    def exit_status(self) -> int:
        """0 equivalent; 1 wrong, incomplete or trivial; 2 unreadable; 3 undecided."""
        return EXIT_STATUS[self.verdict]

    @property
    def messages(self) -> tuple[Diagnostic, ...]:
        """What could not be read, with its place, and how the rest was read where that may surprise."""
        return (*self.equations.unreadable, *self.equations.notes, *(m for a in self.others for m in a.messages))

    def hinted(self, degree: int) -> CheckedAnswer:
        """The same, with no more said of what is wrong than this degree allows: 1, 2 or 3."""
        equations = tuple(e.hinted(degree) for e in self.equations.equations)
        return replace(self, equations=replace(self.equations, equations=equations))

    def as_json(self) -> dict[str, object]:
        """The verdict as FORMAT's JSON object; `answers` are those of the file that are not equations."""
        equations = [e.as_json() for e in self.equations.equations]
        found: dict[str, object] = {"verdict": self.verdict.value, "equations": equations}
        found["missing"] = self.equations.missing
        answers = [a.as_json() for a in self.others]
        return found | ({"answers": answers} if answers else {})

    @property
    def headline(self) -> str:
        """The verdict on everything, in one line."""
        headlines = _HEADLINES | (_HEADLINES_OF_STATICS if self.statics else {})
        headlines |= _HEADLINES_OF_REACTIONS[self.statics] if self.reactions else {}
        headlines |= _HEADLINES_OF_ANSWERS if self.others else {}
        missing = missing_equilibria if self.statics else _missing
        return headlines[self.verdict].format(missing=missing(self.equations.missing))


FIRST = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED, Verdict.INCOMPLETE, Verdict.TRIVIAL)
_HEADLINES = {
    Verdict.EQUIVALENT: "equivalent: the equations have the same solutions as the derived ones",
    Verdict.WRONG: "wrong: not every equation follows from the equations of motion",
    Verdict.INCOMPLETE: "incomplete: what is there follows, and {missing}",
    Verdict.TRIVIAL: "trivial: the equations say nothing of the motion",
    Verdict.UNREADABLE: "unreadable: not every equation can be read",
    Verdict.UNDECIDED: "undecided: it could not be settled whether the equations follow",
}
_HEADLINES_OF_STATICS = {
    Verdict.EQUIVALENT: "equivalent: these are the positions of equilibrium, and all of them",
    Verdict.WRONG: "wrong: not every solution is an equilibrium",
    Verdict.TRIVIAL: "trivial: the equations say nothing of the equilibrium",
    Verdict.UNDECIDED: "undecided: it could not be settled whether these are the equilibria",
}
_HEADLINES_OF_REACTIONS = {
    False: {
        Verdict.EQUIVALENT: "equivalent: these are reactions at every position of equilibrium",
        Verdict.WRONG: "wrong: these are not the reactions at every position of equilibrium",
        Verdict.TRIVIAL: "trivial: the equations say nothing of the reactions",
        Verdict.UNDECIDED: "undecided: it could not be settled whether these are the reactions",
    },
    True: {
        Verdict.EQUIVALENT: "equivalent: these are the positions of equilibrium, all of them, and reactions there",
        Verdict.WRONG: "wrong: not every solution is an equilibrium, or the reactions are others",
        Verdict.UNDECIDED: "undecided: it could not be settled whether these are the equilibria and reactions",
    },
}
_HEADLINES_OF_ANSWERS = {
    Verdict.EQUIVALENT: "equivalent: the answers agree with what is derived",
    Verdict.WRONG: "wrong: not all of the answers agree with what is derived",
    Verdict.INCOMPLETE: "incomplete: what is there agrees with what is derived, and something is missing",
    Verdict.UNREADABLE: "unreadable: not every answer can be read",
    Verdict.UNDECIDED: "undecided: it could not be settled whether all of the answers are right",
}


def _missing(number: int) -> str:
    return "one independent equation is missing" if number == 1 else f"{number} independent equations are missing"


def missing_equilibria(number: int) -> str:
    """What is missing of an equilibrium."""
    return "an equation or a solution is missing" if number <= 1 else f"{number} solutions are missing"
