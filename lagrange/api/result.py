"""The result of `lagrange.solve`: the solution under the names of the field, and its derivation in every format."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, SupportsFloat

import sympy as sp

from lagrange.answers.verdicts import AnswerVerdict
from lagrange.api.formulation import Formulation
from lagrange.api.notebook import Equations, figure_of
from lagrange.core.diagnostics import Diagnostic, suggestion
from lagrange.core.mime import Shown
from lagrange.core.records import record
from lagrange.document.derivation import Derivation, Detail
from lagrange.explain.report import Report
from lagrange.mechanics.constraints.classification import Classification
from lagrange.mechanics.constraints.constraints import ConstraintAnalysis
from lagrange.mechanics.constraints.displacements import possible_displacement, virtual_displacement
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.results import InCoordinates, Solution
from lagrange.problem.model import Problem

if TYPE_CHECKING:
    from lagrange.api.motion import SimulatedMotion
    from lagrange.mechanics.momenta.impact import ImpulsiveMotion
    from lagrange.mechanics.questions.results import Asked

FORMATS = ("pretty", "latex", "markdown", "html", "json")


@record
class Result(Shown):
    """A problem, solved and explained: n coordinates in the file, m constraints.

    `own` and `choices` have equations of motion, reactions and conserved quantities, each in one set of coordinates;
    `result["angle"]` is the choice `angle`, `result[""]` the file's own coordinates. A notebook shows the derivation.
    """

    report: Report

    @property
    def problem(self) -> Problem:
        """The problem."""
        return self.solution.problem

    @property
    def solution(self) -> Solution:
        """The results of all stages of the derivation."""
        return self.report.solution

    @property
    def classification(self) -> Classification:
        """`holonomic`, `scleronomic`, `catastatic` (None: undecided), `rank`, `hidden` relations, ..."""
        return self.solution.classification

    @property
    def degrees_of_freedom(self) -> int:
        """The number of independent virtual displacements."""
        return self.classification.degrees_of_freedom

    @property
    def constraints(self) -> tuple[ConstraintAnalysis, ...]:
        """The analysis of each constraint, shape (m,): `row` (its form), `integrable`, `integral`, `exactness`, ..."""
        return self.classification.constraints

    @property
    def possible_displacements(self) -> Equations:
        """Σ a_k d(q_k) + a_t d(t) of each constraint, each zero, shape (m,)."""
        forms = (possible_displacement(r, self.problem.slots) for r in self.classification.rows)
        return Equations(forms, self.report.notation)

    @property
    def virtual_displacements(self) -> Equations:
        """Σ a_k delta(q_k) of each constraint, each zero, shape (m,)."""
        forms = (virtual_displacement(r, self.problem.slots) for r in self.classification.rows)
        return Equations(forms, self.report.notation)

    @property
    def dependent_displacements(self) -> Mapping[sp.Symbol, sp.Expr]:
        """Each dependent delta(q) in terms of the independent ones."""
        return self.solution.own.elimination.solved(self.problem.slots)

    @property
    def newton(self) -> Equations:
        """Newton's law with reactions, component by component; empty if the coordinates define no free bodies."""
        law = self.solution.law
        pairs = (law.newton.equations if law else None) or ()
        return Equations((sp.Eq(a, b, evaluate=False) for a, b in pairs), self.report.notation)

    @cached_property
    def own(self) -> Formulation:
        """The problem in the file's own coordinates."""
        return self._in_coordinates(self.solution.own)

    @cached_property
    def choices(self) -> Mapping[str, Formulation]:
        """The problem in each choice of generalized coordinates, by name."""
        made = (self._in_coordinates(c) for c in self.solution.choices)
        return MappingProxyType({f.name: f for f in made})

    def _in_coordinates(self, view: InCoordinates) -> Formulation:
        figure = partial(figure_of, self.derivation, view.name)
        return Formulation(self.problem, self.report.notation, view, figure)

    def __getitem__(self, choice: str) -> Formulation:
        """The problem in the choice of this name; the empty name is the file's own coordinates. Raises KeyError."""
        if choice == "":
            return self.own
        if choice not in self.choices:
            raise KeyError(f"the solution has no choice `{choice}`; {suggestion(choice, [*self.choices], 'choices')}")
        return self.choices[choice]

    @property
    def impact(self) -> ImpulsiveMotion | None:
        """The impact of the file: `all_velocities` just after, by coordinate, `impulses`, `energy_lost`, `kinetic`."""
        return self.solution.impact

    @property
    def asked(self) -> Mapping[str, Asked]:
        """The answers to the questions of the file, by name: `branches`, each with `rhs` and `conditions`; `how`."""
        return MappingProxyType({a.question.name: a for a in self.solution.asked})

    @property
    def checks(self) -> tuple[Check, ...]:
        """The checks: `name`, `passed` (None: undecided), `how`, `choice`."""
        return self.solution.checks

    @property
    def answers(self) -> tuple[AnswerVerdict, ...]:
        """The answers that the file states, each with its `verdict`."""
        return self.report.answers

    @property
    def holds(self) -> bool:
        """Whether all checks held, nothing is undecided, and the answers of the file agree."""
        return self.report.holds

    @property
    def shortcomings(self) -> tuple[Diagnostic, ...]:
        """The undecided questions, the checks that failed, and the answers of the file that do not agree."""
        return self.report.shortcomings

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """Notes on how the file was read."""
        return self.report.notes

    @property
    def derivation(self) -> Derivation:
        """The derivation as data: steps of prose, equations and tables."""
        return self.report.derivation

    def render(self, format: str = "pretty", *, detail: str = "steps", width: int = 80, static: bool = False) -> str:
        """The derivation as the command prints it.

        format  "pretty" (plain text), "latex", "markdown", "html" or "json"
        detail  "brief", "steps" or "full"; JSON has everything
        width   characters in a line of plain text
        static  whether a web page has no figure that moves, and no script

        Raises ValueError if there is no such format or detail.
        """
        if format not in FORMATS:
            raise ValueError(f"there is no format `{format}`; {suggestion(format, FORMATS, 'formats')}")
        if detail.upper() not in Detail.__members__:
            raise ValueError(f"there is no detail `{detail}`; it is brief, steps or full")
        if format == "json":
            from lagrange.render import json

            return json.render([self.report])
        shown, written = Detail[detail.upper()], (self.derivation, self.report.notation)
        if format == "pretty":
            from lagrange.render import terminal

            return terminal.text(*written, width, shown)
        from lagrange.animation.moving import moving_figure
        from lagrange.render import html, latex, markdown

        if format == "latex":
            return latex.render([written], detail=shown)
        if format == "markdown":
            return markdown.render([written], detail=shown)
        return html.render([written], shown, [] if static else [moving_figure(self.solution)])

    def simulate(
        self,
        until: float | None = None,
        *,
        values: Mapping[str, SupportsFloat] = MappingProxyType({}),
        initial: Mapping[str, SupportsFloat] = MappingProxyType({}),
        functions: Mapping[str, sp.Expr] = MappingProxyType({}),
        choice: str | None = None,
        samples: int | None = None,
    ) -> SimulatedMotion:
        """The motion in numbers, as `lagsolve simulate` finds it: arrays, plots, an animation.

        until      the time to which it is followed; by default as long as shows something
        values     numbers for parameters, by name, in SI units; those of the file need not be repeated
        initial    coordinates and velocities at t = 0, of the file or of a choice; they complete those of the file
        functions  expressions for undefined functions and prescribed motions, in the names of their arguments or t
        choice     the coordinates; by default those in which the motion is best integrated, `""` for the file's own
        samples    the number of times

        What nobody has given is assumed, and listed in `assumed`. Raises ProblemError if the initial values
        contradict each other or something is missing, ValueError at a name that does not exist.
        """
        from lagrange.api.motion import simulated_motion

        if choice:
            _ = self[choice]  # raises KeyError
        return simulated_motion(self.solution, until, choice, values, initial, functions, samples)

    def __str__(self) -> str:
        return self.render()

    def __repr__(self) -> str:
        c, n = self.classification, self.degrees_of_freedom
        words = {"holonomic": "nonholonomic", "scleronomic": "rheonomic"}
        classes = [w if getattr(c, w) else not_ for w, not_ in words.items() if getattr(c, w) is not None]
        freedom = f"{n} degree{'s' * (n != 1)} of freedom"
        listed = f"; choices: {', '.join(self.choices)}" if self.choices else ""
        return f"<Result of {self.problem.title!r}: {', '.join([freedom, *classes])}{listed}>"

    def _repr_html_(self) -> str:
        """The derivation with its figures, for a notebook."""
        from lagrange.render.html import cell

        return cell(self.derivation, self.report.notation)

    def _repr_markdown_(self) -> str:
        """The derivation without figures, where a notebook shows no HTML."""
        from lagrange.render import markdown

        return markdown.body(self.report.derivation, self.report.notation)
