"""What one run shows: the solution, its comparison with the file's answers, the derivation."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answers import Verdict
from lagrange.checking import ComparedAnswer, compared_answers
from lagrange.derivation import Derivation, Step
from lagrange.diagnostics import Diagnostic
from lagrange.dynamics import Motion
from lagrange.explain.checks import explain_checks
from lagrange.explain.constraints import (
    explain_classification,
    explain_constraints,
    explain_forms,
    explain_freedom,
    explain_integrability,
)
from lagrange.explain.displacements import explain_displacements
from lagrange.explain.motion import (
    explain_choice,
    explain_equations,
    explain_motion_in_choice,
    explain_principle,
)
from lagrange.explain.newton import explain_newton, explain_works
from lagrange.explain.reactions import explain_reactions
from lagrange.explain.statement import explain_statement
from lagrange.problem import Problem
from lagrange.render.kinds import Notation
from lagrange.solution import Solution, solve

if TYPE_CHECKING:
    from lagrange.static_reactions import StaticReactions


@dataclass(frozen=True)
class Report:
    """One problem, solved and explained."""

    solution: Solution
    answers: tuple[ComparedAnswer, ...]
    derivation: Derivation
    notation: Notation

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """What is to be said of how the file was read."""
        return self.solution.problem.notes

    @property
    def shortcomings(self) -> tuple[Diagnostic, ...]:
        """What is undecided, which checks did not hold, which answers of the file do not agree."""
        return tuple(_shortcomings(self.solution, self.answers))

    @property
    def holds(self) -> bool:
        """Whether there are none."""
        return not self.shortcomings

    def _repr_markdown_(self) -> str:
        """What a notebook shows of a report."""
        from lagrange.render import markdown

        return markdown.body(self.derivation, self.notation)


def report(problem: Problem, choice: str | None = None, *, complete: bool = True) -> Report:
    """Solves a problem and explains the solution. Raises what `solve` raises."""
    solution = solve(problem, choice, complete=complete)
    answers = tuple(compared_answers(solution))
    steps = tuple(_steps(solution, answers))
    return Report(solution, answers, Derivation(problem.title, problem.source, steps), notation_of(solution))


def _steps(solution: Solution, answers: tuple[ComparedAnswer, ...]) -> Iterator[Step]:
    problem, classification = solution.problem, solution.classification
    yield explain_statement(problem, solution.configuration)
    yield explain_constraints(classification)
    if classification.constraints:
        yield explain_forms(classification, problem.slots)
        yield explain_integrability(classification, problem.slots, names_of(problem))
    yield explain_classification(classification, names_of(problem))
    yield explain_freedom(classification)
    yield explain_displacements(solution.configuration, solution.elimination, solution.carried, solution.normals)
    yield from _statics(solution)
    yield from _motion(solution)
    for c in solution.choices:
        yield explain_choice(c.coordinates)
        if c.equilibrium is not None:
            from lagrange.explain.statics import explain_equilibrium_in_choice

            yield explain_equilibrium_in_choice(c.coordinates, c.equilibrium, c.stability)
            yield from _reactions_at_rest(solution, c.reactions_at_rest)
        if c.dynamics is not None:
            yield explain_motion_in_choice(c.coordinates, c.dynamics.written, problem)
            yield from _reactions(solution, c.dynamics, c.name)
    yield explain_checks(solution, [(a.name, a.verdict.value) for a in answers])


def names_of(problem: Problem) -> frozenset[str]:
    """What the problem has names for: its symbols, vectors and functions."""
    scope = problem.scope
    symbols = (*problem.slots.coordinates, *problem.slots.prescribed)
    return frozenset({*scope.scalars, *scope.vectors, *scope.functions, *(s.name for s in symbols)})


def _statics(solution: Solution) -> Iterator[Step]:
    """From the free bodies, unless those of motion are shown, to the equilibria and the reactions there."""
    if solution.equilibrium is None:
        return
    law = solution.law
    shown = bool(solution.works) and law is not None and solution.dynamics is None
    if shown and law is not None:
        freedom = solution.classification.degrees_of_freedom
        unknown = bool(solution.problem.unknowns)
        yield explain_newton(law.newton, (), solution.configuration, freedom, at_rest=True, unknown_forces=unknown)
        yield explain_works(solution.works, solution.configuration)
    workless = shown and all(w.vanishes for w in solution.works)
    stability = None if solution.problem.choices else solution.stability
    from lagrange.explain.statics import explain_virtual_work

    yield explain_virtual_work(solution.equilibrium, stability, workless)
    yield from _reactions_at_rest(solution, solution.reactions_at_rest)


def _reactions_at_rest(solution: Solution, found: StaticReactions | None) -> Iterator[Step]:
    if found is not None and solution.law is not None:
        from lagrange.explain.static_reactions import explain_reactions_at_rest

        step = explain_reactions_at_rest(found, solution.law.newton)
        if step is not None:
            yield step


def _motion(solution: Solution) -> Iterator[Step]:
    """From Newton's law to the equations of motion; friction needs the reactions first."""
    law, dynamics = solution.law, solution.dynamics
    if law is None or dynamics is None:
        return
    if solution.works:
        freedom = solution.classification.degrees_of_freedom
        yield explain_newton(law.newton, dynamics.rubbed, solution.configuration, freedom)
        yield explain_works(solution.works, solution.configuration)
    if dynamics.rubbed:
        yield from _reactions(solution, dynamics)
    yield explain_principle(dynamics.written)
    yield explain_equations(dynamics.written, solution.problem)
    if not dynamics.rubbed:
        yield from _reactions(solution, dynamics)


def _reactions(solution: Solution, dynamics: Motion | None, choice: str = "") -> Iterator[Step]:
    if solution.law is not None and dynamics is not None:
        shorter = bool(solution.choices and not choice)
        first = solution.dynamics is not None and solution.dynamics.reactions is None
        first = first and choice == next((c.name for c in solution.choices if c.dynamics and c.dynamics.reactions), "")
        step = explain_reactions(dynamics, solution.law.newton, choice, shorter=shorter, first=first or not choice)
        if step is not None:
            yield step


def _shortcomings(solution: Solution, answers: tuple[ComparedAnswer, ...]) -> Iterator[Diagnostic]:
    c = solution.classification
    for word, verdict in (("holonomic", c.holonomic), ("scleronomic", c.scleronomic), ("catastatic", c.catastatic)):
        if verdict is None:
            yield Diagnostic("undecided", f"it could not be decided whether the system is {word}")
    for check in solution.checks:
        if not check.passed:
            where = f" ({check.choice})" if check.choice else ""
            outcome = "could not be decided" if check.passed is None else "did not hold"
            yield Diagnostic("check-failed", f"a check {outcome}: {check.name}{where}")
    for answer in answers:
        if answer.verdict is not Verdict.EQUIVALENT:
            yield Diagnostic("answer-differs", f"among the file's answers, `{answer.name}` is {answer.verdict}")


def notation_of(solution: Solution) -> Notation:
    """How the symbols of a solution are written."""
    problem = solution.problem
    new = [q for c in solution.choices for q in c.coordinates.configuration.slots.coordinates]
    return Notation(
        coordinates=tuple(dict.fromkeys((*problem.slots.coordinates, *new))),
        prescribed=problem.slots.prescribed,
        speeds=tuple(problem.speeds),
        parameters=tuple(p.symbol for p in problem.parameters),
        forces=(*_names_of_reactions(solution), *problem.unknowns),
        scalar_names=frozenset(problem.scope.scalars),
    )


def _names_of_reactions(solution: Solution) -> Iterator[sp.Symbol]:
    """The multipliers, and the tensions of rods."""
    yield from (c.reaction for c in solution.problem.constraints)
    if solution.law is not None:
        yield from solution.law.newton.tensions
