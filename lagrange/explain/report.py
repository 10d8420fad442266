"""One run: the problem solved, compared with the file's answers, and explained."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answers.limits import UNITS_OF_CHECKING
from lagrange.answers.questions.own_answers import (
    compared_answers,
    not_compared,
    stated_equations,
    stated_reactions,
)
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Diagnostic, GaveUpError
from lagrange.core.effort import Attempts, allowed_for
from lagrange.core.records import record
from lagrange.core.symbols import t, velocity_before
from lagrange.core.vectors import Vector
from lagrange.document.derivation import Derivation, MadeWhenRead, Step, labels_in, not_referring
from lagrange.document.names import Notation
from lagrange.explain.checks import explain_checks
from lagrange.explain.constraints import (
    explain_classification,
    explain_constraints,
    explain_forms,
    explain_freedom,
    explain_integrability,
)
from lagrange.explain.displacements import explain_displacements
from lagrange.explain.energy.conservation import explain_conserved
from lagrange.explain.illustrations import illustrated
from lagrange.explain.limits import RESULT_DIGITS, UNITS_OF_A_STEP, UNITS_OF_EXPLAINING
from lagrange.explain.motion import (
    explain_choice,
    explain_equations,
    explain_matrix_form,
    explain_motion_in_choice,
    explain_principle,
)
from lagrange.explain.newton import explain_newton, explain_works
from lagrange.explain.page.arrangement import steps_of_page, without_names_of_choices
from lagrange.explain.page.forms import in_forms_of_page
from lagrange.explain.page.names import short_names
from lagrange.explain.reactions import explain_reactions, explain_reactions_at_rest
from lagrange.explain.statement import explain_statement
from lagrange.explain.statement import remarks as remarks_on
from lagrange.mechanics.constraints.definedness import explained_failures
from lagrange.mechanics.dynamics.conservation import Conserved
from lagrange.mechanics.dynamics.equations import DalembertMotion, LagrangeMotion
from lagrange.mechanics.dynamics.motion import Method, Motion, NewtonLaw
from lagrange.mechanics.energy_symbols import (
    energy_symbols,
    letters_of_oscillations,
    small_displacements,
    states_potential,
)
from lagrange.mechanics.results import InCoordinates, Solution, values_in, with_known_values
from lagrange.mechanics.solution import OnStage, silent, solve
from lagrange.problem.model import Problem, Question
from lagrange.problem.values import no_values

if TYPE_CHECKING:
    from lagrange.explain.energy.energies import LagrangeExposition
    from lagrange.mechanics.dynamics.quasi_equations import QuasiVelocityForm
    from lagrange.mechanics.equilibrium.static_reactions import StaticReactions
    from lagrange.values.quantities import Values

EVERY_CHOICE = "all"
"""In place of the name of a choice: all of them, and none folded. A choice that is called so takes precedence."""


@record
class Report:
    """One problem, solved and explained.

    values  of its parameters; None if there are none
    """

    solution: Solution
    answers: tuple[AnswerVerdict, ...]
    derivation: Derivation
    notation: Notation
    remarks: tuple[Diagnostic, ...] = ()
    values: Values | None = None

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """Notes on how the file was read, and on what was asked."""
        return (*self.solution.problem.notes, *self.remarks)

    @property
    def shortcomings(self) -> tuple[Diagnostic, ...]:
        """The undecided questions, the checks that did not hold, the answers of the file that do not agree."""
        return tuple(_shortcomings(self.solution, self.answers))

    @property
    def holds(self) -> bool:
        """Whether there are no shortcomings."""
        return not self.shortcomings


def report(
    problem: Problem,
    choice: str | None = None,
    *,
    complete: bool = True,
    method: Method = Method.DALEMBERT,
    digits: int = RESULT_DIGITS,
    on_stage: OnStage = silent,
) -> Report:
    """Solves a problem and explains the solution. Arguments are those of `solve`; raises what `solve` raises.

    choice    also `EVERY_CHOICE`: all choices, as without one, but the page shows them all
    complete  the full derivation is made at once and the page when it is read; without it, the other way round
    digits   the significant digits of results in numbers
    """
    with explained_failures(problem):
        return _reported(problem, choice, complete, method, digits, on_stage)


def _reported(
    problem: Problem, choice: str | None, complete: bool, method: Method, digits: int, on_stage: OnStage
) -> Report:
    every_choice = choice == EVERY_CHOICE and all(c.name != choice for c in problem.choices)
    named = None if every_choice else choice
    solution = solve(problem, named, complete=complete, method=method, on_stage=on_stage)
    on_stage("comparing answers")
    answers: tuple[AnswerVerdict, ...] = ()
    try:
        with allowed_for("comparing answers", UNITS_OF_CHECKING):
            answers = tuple(compared_answers(solution))
    except GaveUpError as error:
        solution = replace(solution, given_up=solution.given_up or error.place)
    on_stage("explanations and pictures")
    return _explained(solution, answers, complete, every_choice, method, digits)


def _explained(
    solution: Solution,
    answers: tuple[AnswerVerdict, ...],
    complete: bool,
    every_choice: bool,
    method: Method,
    digits: int,
) -> Report:
    """The solution with its explanations. A step that takes too much work is missing; then the page has all others."""
    make = Attempts(UNITS_OF_EXPLAINING, UNITS_OF_A_STEP)
    notation = notation_of(solution)
    problem, values = solution.problem, values_in(solution)
    answered, solution = solution, solution if values is None else with_known_values(solution, values)
    large = not solution.own.elimination.is_closed

    def finished(steps: Iterable[Step]) -> Iterator[Step]:
        if values is not None or any(v.in_numbers is not None for v in solution.views):
            from lagrange.explain.numbers import with_numbers

            letters = energy_symbols(solution).of_energies
            steps = with_numbers(steps, solution, (values or no_values(problem)).with_energies(*letters), digits)
        return illustrated(steps, solution, notation)

    def in_full() -> Iterator[Step]:
        return illustrated(steps, solution, notation) if large else finished(steps)

    def on_page() -> Iterator[Step]:
        right = any(a.name == "equations" and a.verdict is Verdict.EQUIVALENT for a in answers)
        stated = stated_equations(solution) if right and solution.own.motion is not None else ()
        forces = stated_reactions(solution, answers)
        shown = in_forms_of_page(solution, stated)
        again = steps if shown is solution else [s for s in _steps(make, shown, answers, complete) if s is not None]
        arranged = steps_of_page(shown, again, stated, forces, every_choice=every_choice)
        return without_names_of_choices(finished(arranged))

    made = _of_large(make, solution, answers) if large else _steps(make, solution, answers, complete)
    steps = tuple(step for step in made if step is not None)
    whole: Sequence[Step] = ()
    arranged: Sequence[Step] = ()
    if not make.why_not:
        whole = make(lambda: tuple(in_full())) or () if complete or large else _later(in_full, problem, steps)
        if not large:
            arranged = _later(on_page, problem, whole) if complete else make(lambda: tuple(on_page())) or ()
    remarks = () if large else make(lambda: (*remarks_on(solution, method), *not_compared(solution, answers))) or ()
    if make.why_not:
        given_up = solution.given_up or f"explanations and pictures, {make.why_not}"
        solution, answered = replace(solution, given_up=given_up), replace(answered, given_up=given_up)
        whole, arranged = _without_missing((*steps[:-1], explain_checks(solution, _compared(answers)))), ()
    derivation = Derivation(problem.title, problem.source, whole, arranged)
    return Report(answered, answers, derivation, notation, remarks, values)


def _without_missing(steps: Sequence[Step]) -> tuple[Step, ...]:
    """The steps with words in place of references to equations of steps that are missing."""
    present = labels_in(steps)
    return tuple(
        replace(s, body=tuple(not_referring(b, lambda label: label not in present) for b in s.body)) for s in steps
    )


def _compared(answers: Sequence[AnswerVerdict]) -> list[tuple[str, str]]:
    return [(a.name, a.verdict.value) for a in answers]


def _of_large(make: Attempts, solution: Solution, answers: tuple[AnswerVerdict, ...]) -> Iterator[Step | None]:
    """The steps for a system in which nothing is eliminated."""
    from lagrange.explain.rest.large_systems import large_system_steps, result_of_large_system

    yield from make.each(result_of_large_system, solution)
    yield make(explain_statement, solution.problem, solution.own.configuration)
    yield from make.each(large_system_steps, solution, names_of(solution.problem))
    yield make(explain_checks, solution, _compared(answers))


def _later(make: Callable[[], Iterator[Step]], problem: Problem, otherwise: Sequence[Step]) -> MadeWhenRead:
    """Steps that are not shown, built only on access, with an allowance of their own."""

    def made() -> tuple[Step, ...]:
        with explained_failures(problem):
            return Attempts(2 * UNITS_OF_EXPLAINING, 0)(lambda: tuple(make())) or tuple(otherwise)

    return MadeWhenRead(made)


def _steps(
    make: Attempts, solution: Solution, answers: tuple[AnswerVerdict, ...], complete: bool
) -> Iterator[Step | None]:
    """The steps in the order of the chapter; None for one that has nothing to show."""
    problem, classification = solution.problem, solution.classification
    yield make(explain_statement, problem, solution.own.configuration, not _states_energies(solution))
    yield make(explain_constraints, classification, solution.own.configuration.satisfies_constraints_itself)
    if classification.constraints:
        yield make(explain_forms, classification, problem.slots)
        yield make(explain_integrability, classification, problem.slots, names_of(problem))
    yield make(explain_classification, classification, names_of(problem))
    yield make(explain_freedom, classification)
    yield make(
        explain_displacements,
        solution.own.configuration,
        solution.own.elimination,
        solution.transport_rates,
        solution.normals,
    )
    yield from _rest(make, solution, solution.own)
    yield from _statics(make, solution)
    yield from _motion(make, solution, complete)
    if solution.own.dynamics is None:
        yield make(_speeds, solution.own.in_speeds, solution)
    yield make(_small_oscillations, solution.own)
    yield make(_forced, solution.own)
    yield from _in_momenta(make, solution.own, solution)
    for c in solution.choices:
        yield from (step and replace(step, choice=c.name) for step in _in_choice(make, solution, c, complete))
    if solution.impact is not None and problem.impact is not None:
        from lagrange.explain.contact.impact import explain_impact, explain_motion_after

        yield make(explain_impact, solution.impact, problem.impact, energy_symbols(solution))
        if solution.after is not None:
            yield make(explain_motion_after, solution.after, solution.impact)
    if solution.asked:
        from lagrange.explain.questions import explain_questions

        yield from make.each(explain_questions, solution)
    if solution.from_start is not None:
        from lagrange.explain.questions import explain_from_start

        yield make(explain_from_start, solution.from_start)
    stated = (e for a in answers if a.name == "reactions" for e in a.equations)
    remarks = [(e.text.partition(":")[0], remark) for e in stated for remark in e.remarks]
    yield make(explain_checks, solution, _compared(answers), remarks)


def _in_choice(make: Attempts, solution: Solution, c: InCoordinates, complete: bool) -> Iterator[Step | None]:
    """The steps in a choice of generalized coordinates."""
    problem = solution.problem
    yield make(explain_choice, c.coordinates)
    if c.equilibrium is not None:
        from lagrange.explain.rest.equilibrium import explain_equilibrium_in_choice

        yield make(explain_equilibrium_in_choice, c.coordinates, c.equilibrium, c.stability)
        yield make(_reactions_at_rest, solution, c.reactions_at_rest)
    yield from _rest(make, solution, c)
    if c.dynamics is not None:
        written = c.dynamics.written
        if isinstance(written, LagrangeMotion):
            yield from _by_lagrange(make, solution, written)
        elif isinstance(written, DalembertMotion):
            yield make(explain_motion_in_choice, written, problem, c.dynamics.with_multipliers)
        yield make(explain_matrix_form, c.dynamics, c.name) if complete else None
    yield make(_speeds, c.in_speeds, solution)
    yield make(_reactions, solution, c.dynamics, c.name)
    yield make(_rolling, c)
    yield make(_conserved, c.conserved, problem, c.name)
    yield make(_small_oscillations, c)
    yield make(_forced, c)
    yield from _in_momenta(make, c, solution)


def names_of(problem: Problem) -> frozenset[str]:
    """The names that the problem uses: of symbols, vectors and functions."""
    scope = problem.scope
    symbols = (*problem.slots.coordinates, *problem.slots.prescribed)
    return frozenset({*scope.scalars, *scope.vectors, *scope.functions, *(s.name for s in symbols)})


def _statics(make: Attempts, solution: Solution) -> Iterator[Step | None]:
    """Free bodies (unless those of the motion are shown), virtual work, equilibria, reactions at rest."""
    if solution.own.equilibrium is None:
        return
    law = solution.law
    shown = bool(solution.works) and law is not None and solution.own.dynamics is None
    if shown and law is not None:
        freedom = solution.classification.degrees_of_freedom
        unknown = bool(solution.problem.unknowns)
        yield make(
            explain_newton, law.newton, (), solution.own.configuration, freedom, at_rest=True, unknown_forces=unknown
        )
        yield make(explain_works, solution.works, solution.own.configuration)
    workless = shown and all(w.vanishes for w in solution.works)
    stability = None if solution.problem.choices else solution.own.stability
    from lagrange.explain.rest.equilibrium import explain_virtual_work

    yield make(explain_virtual_work, solution.own.equilibrium, stability, workless)
    yield make(_reactions_at_rest, solution, solution.own.reactions_at_rest)
    yield make(_rolling, solution.own) if shown else None


def _rest(make: Attempts, solution: Solution, view: InCoordinates) -> Iterator[Step | None]:
    """Friction at rest, and at its limit."""
    if view.at_rest is None and view.impending is None:
        return
    from lagrange.explain.contact.friction_at_rest import explain_impending, explain_rest

    if view.at_rest is not None and solution.law is not None:
        yield make(explain_rest, view.at_rest, solution.law.newton)
    if view.impending is not None and solution.law is not None:
        yield make(explain_impending, view.impending, solution.law.newton, view.name)


def _rolling(view: InCoordinates) -> Step | None:
    if view.rolling is None:
        return None
    from lagrange.explain.contact.friction_at_rest import explain_rolling

    return explain_rolling(view.rolling)


def _small_oscillations(view: InCoordinates) -> Step | None:
    if view.linearization is None:
        return None
    from lagrange.explain.rest.oscillations import explain_linearization

    return explain_linearization(view.linearization, after=view.equilibrium)


def _forced(view: InCoordinates) -> Step | None:
    if view.forced is None:
        return None
    from lagrange.explain.rest.steady_motions import explain_response

    return explain_response(view.forced, view.response)


def _in_momenta(make: Attempts, view: InCoordinates, solution: Solution) -> Iterator[Step | None]:
    if view.hamiltonian is not None:
        from lagrange.explain.energy.energies import explain_hamiltonian

        yield make(explain_hamiltonian, view.hamiltonian, energy_symbols(solution))
    if view.steady is not None:
        from lagrange.explain.rest.steady_motions import explain_steady

        yield make(explain_steady, view.steady)


def _reactions_at_rest(solution: Solution, reactions: StaticReactions | None) -> Step | None:
    if reactions is None or solution.law is None:
        return None
    return explain_reactions_at_rest(reactions, solution.law.newton)


def _motion(make: Attempts, solution: Solution, complete: bool) -> Iterator[Step | None]:
    """From Newton's law to the equations of motion; friction needs the reactions first."""
    law, dynamics = solution.law, solution.own.dynamics
    if law is None or dynamics is None:
        return
    written = dynamics.written
    if solution.works and not isinstance(written, LagrangeMotion):
        freedom = solution.classification.degrees_of_freedom
        yield make(explain_newton, law.newton, dynamics.friction_forces, solution.own.configuration, freedom)
        yield make(explain_works, solution.works, solution.own.configuration)
    if dynamics.friction_forces and isinstance(written, LagrangeMotion):
        from lagrange.explain.energy.energies import explain_friction_first

        yield make(explain_friction_first, _exposition(solution, law, written))
    if dynamics.friction_forces:
        yield make(_reactions, solution, dynamics)
    if isinstance(written, LagrangeMotion):
        yield from _by_lagrange(make, solution, written)
    elif isinstance(written, DalembertMotion):
        yield make(explain_principle, written)
        multiplied = None if law.newton.equations is not None else dynamics.with_multipliers  # they are Newton's, then
        yield make(explain_equations, written, solution.problem, multiplied)
    yield make(explain_matrix_form, dynamics) if complete else None
    yield make(_speeds, solution.own.in_speeds, solution)
    if not dynamics.friction_forces:
        yield make(_reactions, solution, dynamics)
    yield make(_rolling, solution.own)
    yield make(_conserved, solution.own.conserved, solution.problem)


def _conserved(conserved: Conserved | None, problem: Problem, choice: str = "") -> Step | None:
    return None if conserved is None else explain_conserved(conserved, choice, names_of(problem))


def _speeds(form: QuasiVelocityForm | None, solution: Solution) -> Step | None:
    if form is None:
        return None
    from lagrange.explain.quasi_velocities import explain_speeds

    first = next(v.in_speeds for v in solution.views if v.in_speeds is not None)
    stated = solution.law is not None and solution.law.method is Method.DALEMBERT
    return explain_speeds(form, solution.problem, form is first, stated)


def _by_lagrange(make: Attempts, solution: Solution, written: LagrangeMotion) -> Iterator[Step | None]:
    """T, V and Q_k, Lagrange's equations, and the equations without multipliers."""
    from lagrange.explain.energy.energies import explain_energies
    from lagrange.explain.energy.lagrange import explain_lagrange, explain_lagrange_motion

    if solution.law is not None:
        exposition = _exposition(solution, solution.law, written)
        yield make(explain_energies, exposition)
        yield make(explain_lagrange, exposition)
        yield make(explain_lagrange_motion, exposition)


def _exposition(solution: Solution, law: NewtonLaw, written: LagrangeMotion) -> LagrangeExposition:
    """What the explanation of Lagrange's method needs in one set of coordinates."""
    from lagrange.explain.energy.energies import LagrangeExposition

    finite = frozenset(c.row.name for c in solution.classification.constraints if c.integrable)
    friction_forces = solution.own.dynamics.friction_forces if solution.own.dynamics is not None else ()
    return LagrangeExposition(written, energy_symbols(solution), law, solution.problem, friction_forces, finite)


def _states_energies(solution: Solution) -> bool:
    """Whether V is stated together with T, for weights, springs and fields alike."""
    by_lagrange = solution.law is not None and solution.law.method is Method.LAGRANGE
    return by_lagrange and not states_potential(solution)


def _reactions(solution: Solution, dynamics: Motion | None, choice: str = "") -> Step | None:
    if solution.law is None or dynamics is None:
        return None
    shorter = bool(solution.choices and not choice)
    first = solution.own.dynamics is not None and solution.own.dynamics.reactions is None
    first = first and choice == next((c.name for c in solution.choices if c.dynamics and c.dynamics.reactions), "")
    lost = solution.long_reactions
    return explain_reactions(dynamics, solution.law.newton, choice, shorter, first=first or not choice, lost_ones=lost)


def _shortcomings(solution: Solution, answers: tuple[AnswerVerdict, ...]) -> Iterator[Diagnostic]:
    c = solution.classification
    for word, verdict in (("holonomic", c.holonomic), ("scleronomic", c.scleronomic), ("catastatic", c.catastatic)):
        if verdict is None:
            yield Diagnostic("undecided", f"it could not be decided whether the system is {word}")
    if solution.given_up:
        help_ = "what was found before is complete; a smaller system, or shorter expressions, may be solved"
        yield Diagnostic("given-up", f"given up at: {solution.given_up}", help=help_)
    for check in solution.checks:
        if not check.passed:
            where = f" ({check.choice})" if check.choice else ""
            outcome = "could not be decided" if check.passed is None else "did not hold"
            yield Diagnostic("check-failed", f"a check {outcome}: {check.name}{where}")
    for asked in solution.asked:
        if asked.is_open:
            message = f"the question `{asked.question.name}` could not be answered"
            yield Diagnostic("undecided", message, help=_cure_of(asked.question, solution.problem))
    for answer in answers:
        if answer.verdict is not Verdict.EQUIVALENT:
            yield Diagnostic("answer-differs", f"among the file's answers, `{answer.name}` is {answer.verdict}")


def _cure_of(question: Question, problem: Problem) -> str:
    """What to write where a parameter of the initial state is asked for, and the condition may be meant for t = 0."""
    of_start = {s for v in problem.initial for s in v.value.free_symbols}
    timed = any(t in c.function.free_symbols for c in question.when)
    if question.quantity not in of_start or not question.when or timed:
        return ""
    return "where the condition is meant for the initial state, add `and t = 0` to `when`"


def notation_of(solution: Solution) -> Notation:
    """How the symbols of a solution are written."""
    problem = solution.problem
    new = [q for c in solution.choices for q in c.configuration.slots.coordinates]
    lengths = [link.length_symbol for link in solution.own.configuration.links]
    momenta = (p for v in solution.views if v.hamiltonian is not None for p in v.hamiltonian.momenta)
    steady = [s for v in solution.views if v.response is not None for s in (*v.response.letters, *v.response.lags)]
    struck = solution.impact
    before = [] if struck is None else [velocity_before(q) for q in struck.slots.coordinates]
    return Notation(
        coordinates=tuple(dict.fromkeys((*problem.slots.coordinates, *new, *lengths, *small_displacements(solution)))),
        prescribed=problem.slots.prescribed,
        speeds=(*(s.symbol for s in problem.speeds), *momenta, *before),
        frequencies=letters_of_oscillations(solution),
        parameters=(*(p.symbol for p in problem.parameters), *steady),
        forces=(*_names_of_reactions(solution), *problem.unknowns),
        scalar_names=frozenset(problem.scope.scalars),
        directions=tuple(name for name, value in problem.abbreviations.items() if isinstance(value, Vector)),
        page_names=short_names(solution, _energy_letters(solution)),
    )


def _energy_letters(solution: Solution) -> frozenset[str]:
    """The letters of T, V, L and H, where the page has them."""
    by_lagrange = solution.law is not None and solution.law.method is Method.LAGRANGE
    if not by_lagrange and all(v.hamiltonian is None for v in solution.views):
        return frozenset()
    letters = energy_symbols(solution)
    energies = (letters.kinetic, letters.potential, letters.lagrangian, letters.hamiltonian, letters.routhian)
    return frozenset(s.name for s in energies)


def _names_of_reactions(solution: Solution) -> Iterator[sp.Symbol]:
    """The multipliers, and the tensions of rods."""
    yield from (c.reaction for c in solution.problem.constraints)
    if solution.impact is not None:
        yield from (i.symbol for i in solution.impact.impulses)
    if solution.law is not None:
        yield from solution.law.newton.single_forces
