"""What one run shows: the solution, its comparison with the file's answers, the derivation."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from lagrange.answers import Verdict
from lagrange.checking import ComparedAnswer, compared_answers
from lagrange.derivation import Derivation, Step
from lagrange.diagnostics import Diagnostic
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
from lagrange.explain.statement import explain_statement
from lagrange.problem import Problem
from lagrange.render.kinds import Notation
from lagrange.solution import Solution, solve


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


def report(problem: Problem, choice: str | None = None) -> Report:
    """Solves a problem and explains the solution. Raises what `solve` raises."""
    solution = solve(problem, choice)
    answers = tuple(compared_answers(solution))
    steps = tuple(_steps(solution, answers))
    return Report(solution, answers, Derivation(problem.title, problem.source, steps), notation_of(solution))


def _steps(solution: Solution, answers: tuple[ComparedAnswer, ...]) -> Iterator[Step]:
    problem, classification = solution.problem, solution.classification
    yield explain_statement(problem, solution.configuration)
    yield explain_constraints(classification)
    if classification.constraints:
        yield explain_forms(classification, problem.slots)
        yield explain_integrability(classification, names_of(problem))
    yield explain_classification(classification)
    yield explain_freedom(classification)
    yield explain_displacements(solution.configuration, solution.elimination, solution.carried)
    if solution.motion is not None:
        yield explain_principle(solution.motion, problem)
        yield explain_equations(solution.motion, problem)
    for c in solution.choices:
        yield explain_choice(c.coordinates)
        if c.motion is not None:
            yield explain_motion_in_choice(c.coordinates, c.motion, problem)
    yield explain_checks(solution, [(a.name, a.verdict.value) for a in answers])


def names_of(problem: Problem) -> frozenset[str]:
    """What the problem has names for: its symbols, vectors and functions."""
    scope = problem.scope
    symbols = (*problem.slots.coordinates, *problem.slots.prescribed)
    return frozenset({*scope.scalars, *scope.vectors, *scope.functions, *(s.name for s in symbols)})


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
        forces=(*(c.reaction for c in problem.constraints), *problem.unknowns),
        scalar_names=frozenset(problem.scope.scalars),
    )
