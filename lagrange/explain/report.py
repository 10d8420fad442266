"""What one run shows: the solution, its comparison with the file's answers, the derivation."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answers.equations import Verdict
from lagrange.answers.examiner import compared_answers, not_compared
from lagrange.answers.verdicts import ComparedAnswer
from lagrange.core.diagnostics import Diagnostic
from lagrange.core.records import record
from lagrange.document.derivation import Derivation, Step
from lagrange.document.notation import Notation
from lagrange.explain.checks import explain_checks
from lagrange.explain.conservation import explain_conserved
from lagrange.explain.constraints import (
    explain_classification,
    explain_constraints,
    explain_forms,
    explain_freedom,
    explain_integrability,
)
from lagrange.explain.displacements import explain_displacements
from lagrange.explain.illustrated import illustrated
from lagrange.explain.matrix_form import explain_matrix_form
from lagrange.explain.motion import (
    explain_choice,
    explain_equations,
    explain_motion_in_choice,
    explain_principle,
)
from lagrange.explain.newton import explain_newton, explain_works
from lagrange.explain.reactions import explain_reactions
from lagrange.explain.statement import explain_statement
from lagrange.mechanics.dynamics.conservation import Conserved
from lagrange.mechanics.dynamics.equations import DalembertMotion
from lagrange.mechanics.dynamics.motion import Law, Method, Motion
from lagrange.mechanics.dynamics.multipliers import LagrangeMotion
from lagrange.mechanics.energy_symbols import letters, states_potential
from lagrange.mechanics.solution import Solution, letters_of_oscillations, small_displacements, solve
from lagrange.problem.model import Find, Problem

if TYPE_CHECKING:
    from lagrange.explain.energies import Told
    from lagrange.mechanics.dynamics.quasi_verification import InSpeeds
    from lagrange.mechanics.equilibrium.linearization import Linearization
    from lagrange.mechanics.equilibrium.static_reactions import StaticReactions


@record
class Report:
    """One problem, solved and explained."""

    solution: Solution
    answers: tuple[ComparedAnswer, ...]
    derivation: Derivation
    notation: Notation
    remarks: tuple[Diagnostic, ...] = ()

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """What is to be said of how the file was read, and of what was asked."""
        return (*self.solution.problem.notes, *self.remarks)

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


def report(
    problem: Problem, choice: str | None = None, *, complete: bool = True, method: Method = Method.DALEMBERT
) -> Report:
    """Solves a problem and explains the solution. Raises what `solve` raises."""
    solution = solve(problem, choice, complete=complete, method=method)
    answers = tuple(compared_answers(solution))
    notation = notation_of(solution)
    steps = tuple(illustrated(_steps(solution, answers, complete), solution, notation))
    derivation = Derivation(problem.title, problem.source, steps)
    remarks = (*_remarks(problem, method), *not_compared(solution, answers))
    return Report(solution, answers, derivation, notation, remarks)


def _remarks(problem: Problem, method: Method) -> tuple[Diagnostic, ...]:
    """That a method of motion was asked for where nothing moves."""
    if method is Method.DALEMBERT or Find.MOTION in problem.find:
        return ()
    message = f"`--method {method}` makes no difference here: no equations of motion are asked for"
    help_ = "equilibrium is found by the principle of virtual work; `find: motion` asks for equations of motion"
    return (Diagnostic("method-without-motion", message, help=help_).as_note(),)


def _steps(solution: Solution, answers: tuple[ComparedAnswer, ...], complete: bool) -> Iterator[Step]:
    problem, classification = solution.problem, solution.classification
    yield explain_statement(problem, solution.configuration, not _tells_energies(solution))
    yield explain_constraints(classification)
    if classification.constraints:
        yield explain_forms(classification, problem.slots)
        yield explain_integrability(classification, problem.slots, names_of(problem))
    yield explain_classification(classification, names_of(problem))
    yield explain_freedom(classification)
    yield explain_displacements(solution.configuration, solution.elimination, solution.carried, solution.normals)
    yield from _statics(solution)
    yield from _motion(solution, complete)
    if solution.dynamics is None:
        yield from _speeds(solution.in_speeds, solution)
    yield from _small_oscillations(solution.linearization)
    for c in solution.choices:
        yield explain_choice(c.coordinates)
        if c.equilibrium is not None:
            from lagrange.explain.statics import explain_equilibrium_in_choice

            yield explain_equilibrium_in_choice(c.coordinates, c.equilibrium, c.stability)
            yield from _reactions_at_rest(solution, c.reactions_at_rest)
        if c.dynamics is not None:
            written = c.dynamics.written
            if isinstance(written, LagrangeMotion):
                yield from _by_lagrange(solution, written)
            elif isinstance(written, DalembertMotion):
                yield explain_motion_in_choice(c.coordinates, written, problem, c.dynamics.with_multipliers)
            yield from _matrix_form(c.dynamics, c.name, complete)
        yield from _speeds(c.in_speeds, solution)
        if c.dynamics is not None:
            yield from _reactions(solution, c.dynamics, c.name)
        yield from _conserved(c.conserved, problem, c.name)
        yield from _small_oscillations(c.linearization)
    stated = (e for a in answers if a.name == "reactions" for e in a.equations)
    remarks = [(e.text.partition(":")[0], said) for e in stated for said in e.remarks]
    yield explain_checks(solution, [(a.name, a.verdict.value) for a in answers], remarks)


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


def _matrix_form(dynamics: Motion, choice: str, complete: bool) -> Iterator[Step]:
    """The equations in matrix form: in full detail only."""
    step = explain_matrix_form(dynamics, choice) if complete else None
    if step is not None:
        yield step


def _small_oscillations(found: Linearization | None) -> Iterator[Step]:
    if found is not None:
        from lagrange.explain.oscillations import explain_linearization

        yield explain_linearization(found)


def _reactions_at_rest(solution: Solution, found: StaticReactions | None) -> Iterator[Step]:
    if found is not None and solution.law is not None:
        from lagrange.explain.static_reactions import explain_reactions_at_rest

        step = explain_reactions_at_rest(found, solution.law.newton)
        if step is not None:
            yield step


def _motion(solution: Solution, complete: bool) -> Iterator[Step]:
    """From Newton's law to the equations of motion; friction needs the reactions first."""
    law, dynamics = solution.law, solution.dynamics
    if law is None or dynamics is None:
        return
    written = dynamics.written
    if solution.works and not isinstance(written, LagrangeMotion):
        freedom = solution.classification.degrees_of_freedom
        yield explain_newton(law.newton, dynamics.rubbed, solution.configuration, freedom)
        yield explain_works(solution.works, solution.configuration)
    if dynamics.rubbed and isinstance(written, LagrangeMotion):
        from lagrange.explain.energies import explain_friction_first

        yield explain_friction_first(_told(solution, law, written))
    if dynamics.rubbed:
        yield from _reactions(solution, dynamics)
    if isinstance(written, LagrangeMotion):
        yield from _by_lagrange(solution, written)
    elif isinstance(written, DalembertMotion):
        yield explain_principle(written)
        multiplied = None if law.newton.equations is not None else dynamics.with_multipliers  # they are Newton's, then
        yield explain_equations(written, solution.problem, multiplied)
    yield from _matrix_form(dynamics, "", complete)
    yield from _speeds(solution.in_speeds, solution)
    if not dynamics.rubbed:
        yield from _reactions(solution, dynamics)
    yield from _conserved(solution.conserved, solution.problem)


def _conserved(found: Conserved | None, problem: Problem, choice: str = "") -> Iterator[Step]:
    step = None if found is None else explain_conserved(found, choice, names_of(problem))
    if step is not None:
        yield step


def _speeds(found: InSpeeds | None, solution: Solution) -> Iterator[Step]:
    if found is not None:
        from lagrange.explain.quasi_velocities import explain_speeds

        others = (solution.in_speeds, *(c.in_speeds for c in solution.choices))
        stated = solution.law is not None and solution.law.method is Method.DALEMBERT
        yield explain_speeds(found, solution.problem, found is next(s for s in others if s is not None), stated)


def _by_lagrange(solution: Solution, written: LagrangeMotion) -> Iterator[Step]:
    """T, V and Q_k, Lagrange's equations, and what they come to without multipliers."""
    from lagrange.explain.energies import explain_energies
    from lagrange.explain.lagrange import explain_lagrange, explain_lagrange_motion

    if solution.law is not None:
        told = _told(solution, solution.law, written)
        yield explain_energies(told)
        yield explain_lagrange(told)
        yield explain_lagrange_motion(told)


def _told(solution: Solution, law: Law, written: LagrangeMotion) -> Told:
    """What is told of Lagrange's equations in one set of coordinates."""
    from lagrange.explain.energies import Told

    finite = frozenset(c.row.name for c in solution.classification.constraints if c.integrable)
    rubbed = solution.dynamics.rubbed if solution.dynamics is not None else ()
    return Told(written, letters(solution), law, solution.problem, rubbed, finite)


def _tells_energies(solution: Solution) -> bool:
    """Whether V is told of where T is, the weights' with that of springs and fields."""
    by_lagrange = solution.law is not None and solution.law.method is Method.LAGRANGE
    return by_lagrange and not states_potential(solution)


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
    lengths = [link.length_symbol for link in solution.configuration.links]
    return Notation(
        coordinates=tuple(dict.fromkeys((*problem.slots.coordinates, *new, *lengths, *small_displacements(solution)))),
        prescribed=problem.slots.prescribed,
        speeds=tuple(s.symbol for s in problem.speeds),
        frequencies=letters_of_oscillations(solution),
        parameters=tuple(p.symbol for p in problem.parameters),
        forces=(*_names_of_reactions(solution), *problem.unknowns),
        scalar_names=frozenset(problem.scope.scalars),
    )


def _names_of_reactions(solution: Solution) -> Iterator[sp.Symbol]:
    """The multipliers, and the tensions of rods."""
    yield from (c.reaction for c in solution.problem.constraints)
    if solution.law is not None:
        yield from solution.law.newton.tensions
