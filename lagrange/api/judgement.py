"""What `lagrange.check` gives: the verdict on an answer, with what `lagsolve check` would print of it."""

from __future__ import annotations

from dataclasses import field

import sympy as sp

from lagrange.answers.equations import EquationVerdict
from lagrange.answers.verdicts import CheckedAnswer
from lagrange.core.records import record
from lagrange.problem.model import Problem


@record
class Judgement(CheckedAnswer):
    """The verdict on an answer.

    verdict   "equivalent", "wrong", "incomplete", "trivial", "unreadable" or "undecided"
    each      the verdicts on the equations, in their order: `verdict`, `diagnosis`, `remarks`, `text`
    others    the verdicts on answers to other questions: degrees of freedom, equilibrium, reactions
    messages  what could not be read, and where
    headline  the verdict in a sentence; `print` shows all of it
    problem   what was answered
    derived   the derived equations, each zero, in the coordinates of the answer; none in statics
    """

    problem: Problem = field(kw_only=True)
    derived: tuple[sp.Expr, ...] = field(kw_only=True, default=())

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
        """The choice of coordinates that it was compared in; empty for the file's own."""
        return self.equations.choice

    def __str__(self) -> str:
        from lagrange.render import verdict

        return verdict.text(self, self.problem, 80).rstrip("\n")

    def __repr__(self) -> str:
        return f"<Judgement: {self.headline}>"

    def _repr_markdown_(self) -> str:
        """What a notebook shows: the same as the terminal."""
        return f"```text\n{self}\n```"
