"""Answers compared: those that a problem file states, and somebody else's.

`compared_answers` is what every solve does with the file's own; `check_answer` and `check_own_answers` are what
`lagsolve check` does.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answers.answer_readings import read_answer
from lagrange.answers.equations import AnswerVerdict, EquationVerdict, Verdict, check_equations
from lagrange.answers.reactions import AtRest, check_reaction
from lagrange.answers.reference_systems import reference_of_equations
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import FIRST, CheckedAnswer, ComparedAnswer, missing_equilibria
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import base
from lagrange.expressions.latex_layout import separated
from lagrange.mechanics.solution import Solution, solve
from lagrange.problem.model import Answers, Problem

if TYPE_CHECKING:
    from lagrange.mechanics.equilibrium.equilibrium import Equilibrium


def compared_answers(solution: Solution) -> Iterator[ComparedAnswer]:
    """The file's own answers against the solution. Raises ProblemError where one cannot be read."""
    answers = solution.problem.answers
    if answers is None:
        return
    yield from _before_equations(solution, answers)
    if answers.equations and (verdict := _equations(solution, answers)) is not None:
        yield ComparedAnswer("equations", verdict)
    yield from map(_readable, _after_equations(solution, answers))


def _readable(answer: ComparedAnswer) -> ComparedAnswer:
    """An answer of the file; one that cannot be read is a mistake of the file."""
    if answer.verdict is Verdict.UNREADABLE and answer.messages:
        raise ProblemError(answer.messages)
    return replace(answer, messages=())


def _before_equations(solution: Solution, answers: Answers) -> Iterator[ComparedAnswer]:
    """The answers about constraints."""
    classification = solution.classification
    if answers.degrees_of_freedom is not None:
        yield ComparedAnswer(
            "degrees_of_freedom", _agrees(answers.degrees_of_freedom == classification.degrees_of_freedom)
        )
    if answers.classification:
        yield _together("classification", {word: _class(solution, word) for word in answers.classification})
    if answers.integrable:
        found = {c.constraint.name: c.integrable for c in classification.constraints}
        said = {n: None if found.get(n) is None else found[n] == s for n, s in answers.integrable.items()}
        yield _together("integrable", said)


def _together(name: str, parts: Mapping[str, bool | None]) -> ComparedAnswer:
    """The verdict on several statements, saying which are not right."""
    verdict = _all_agree(iter(parts.values()))
    named = [n for n, agrees in parts.items() if agrees is (False if verdict is Verdict.WRONG else None)]
    heading = "undecided" if verdict is Verdict.UNDECIDED else "not right"
    diagnosis = f"{heading}: {', '.join(named)}" if len(parts) > 1 and named else ""
    return ComparedAnswer(name, verdict, diagnosis)


def _after_equations(solution: Solution, answers: Answers) -> Iterator[ComparedAnswer]:
    """The answers about equilibria and reactions."""
    if answers.equilibrium:
        yield _equilibrium(solution, answers.equilibrium)
    if answers.frequencies:
        from lagrange.answers.frequencies import check_frequencies

        found = [solution.linearization, *(c.linearization for c in solution.choices)]
        there = [f for f in found if f is not None]
        verdict = check_frequencies(answers.frequencies, there, reference_of_solution(solution))
        yield ComparedAnswer("frequencies", verdict)
    if answers.reactions and (of_reactions := _reactions(solution, answers.reactions)) is not None:
        yield of_reactions


def _equilibrium(solution: Solution, alternatives: Sequence[Sequence[Fragment]]) -> ComparedAnswer:
    """The verdict on equilibria."""
    from lagrange.answers.equilibrium_answers import check_equilibria

    found = [e for e in (solution.equilibrium, *(c.equilibrium for c in solution.choices)) if e is not None]
    linear = [solution.linearization, *(c.linearization for c in solution.choices)]
    found = found or [f.equilibrium for f in linear if f is not None]
    if not found:
        return ComparedAnswer("equilibrium", Verdict.UNDECIDED, "the problem does not ask for equilibrium")
    verdict = check_equilibria(alternatives, found, reference_of_solution(solution))
    diagnosis = missing_equilibria(verdict.missing) if verdict.verdict is Verdict.INCOMPLETE else ""
    messages = (*verdict.unreadable, *verdict.notes)
    return ComparedAnswer("equilibrium", verdict.verdict, diagnosis, verdict.equations, messages)


def _equations(solution: Solution, answers: Answers) -> Verdict | None:
    """The verdict on the file's equations; None where they are in a choice of coordinates that was not asked for."""
    if solution.motion is None:
        return Verdict.UNDECIDED
    verdict = check_equations(answers.equations, reference_of_solution(solution))
    if verdict.unreadable:
        raise ProblemError(verdict.unreadable)
    return None if verdict.verdict is Verdict.UNREADABLE and _some_left_out(solution) else verdict.verdict


def _some_left_out(solution: Solution) -> bool:
    """Whether there are choices of coordinates that were not asked for."""
    return len(solution.choices) < len(solution.problem.choices)


def not_compared(solution: Solution, compared: Sequence[ComparedAnswer]) -> tuple[Diagnostic, ...]:
    """A note on the answers of the file that are in coordinates of a choice that was not asked for."""
    answers = solution.problem.answers
    if answers is None or solution.law is None or not _some_left_out(solution):
        return ()
    parts = {a.name: a.equations for a in compared}
    left_out = ["equations"] if answers.equations and "equations" not in parts else []
    left_out += [f"reactions: {name}" for name in answers.reactions] if answers.reactions else []
    said = {f"reactions: {p.text.partition(':')[0]}" for p in parts.get("reactions", ())}
    names = ", ".join(f"`{name}`" for name in left_out if name not in said)
    message = f"answers of the file in coordinates of other choices are not compared: {names}"
    return (Diagnostic("not-compared", message, help="without `--choice` all are").as_note(),) if names else ()


def _reactions(solution: Solution, stated: Mapping[str, Fragment]) -> ComparedAnswer | None:
    """The verdict on all stated reactions together, but those in coordinates of a choice that was not asked for."""
    if solution.law is None:
        return ComparedAnswer("reactions", Verdict.UNDECIDED, "no reactions are derived for this problem")
    reactions = {r.name: r for r in solution.law.newton.reactions}
    reference = reference_of_solution(solution)
    at_rest = _at_rest(solution) if solution.motion is None else None
    parts: list[EquationVerdict] = []
    messages: list[Diagnostic] = []
    for name, fragment in stated.items():
        check = at_rest.check_stated if at_rest else partial(check_reaction, reference=reference)
        unreadable = EquationVerdict(f"{name}: {fragment.text}", Verdict.UNREADABLE)
        try:
            found = check(fragment, reactions[name])
        except ProblemError as error:
            messages += error.diagnostics
            found = unreadable
        if found is not None or not _some_left_out(solution):
            parts.append(found or unreadable)
    if not parts:
        return None
    order = (Verdict.UNREADABLE, Verdict.WRONG, Verdict.UNDECIDED)
    whole = next((v for v in order if any(p.verdict is v for p in parts)), Verdict.EQUIVALENT)
    return ComparedAnswer("reactions", whole, "", tuple(parts), tuple(messages))


def _at_rest(solution: Solution) -> AtRest | None:
    """The reactions at the equilibria, where there are constraints."""
    if solution.law is None or solution.reactions_at_rest is None:
        return None
    found = [solution.reactions_at_rest, *(c.reactions_at_rest for c in solution.choices if c.reactions_at_rest)]
    return AtRest(solution.law.newton, found, reference_of_solution(solution))


def _agrees(same: bool | None) -> Verdict:
    return Verdict.UNDECIDED if same is None else Verdict.EQUIVALENT if same else Verdict.WRONG


def _all_agree(verdicts: Iterator[bool | None]) -> Verdict:
    found = list(verdicts)
    return _agrees(False if False in found else None if None in found else True)


def _class(solution: Solution, word: str) -> bool | None:
    """Whether the system is of a class; None where that is undecided."""
    c = solution.classification
    positive = {"holonomic": c.holonomic, "scleronomic": c.scleronomic, "catastatic": c.catastatic}
    negative = {"nonholonomic": c.holonomic, "rheonomic": c.scleronomic, "acatastatic": c.catastatic}
    if word in positive:
        return positive[word]
    value = negative[word]
    return None if value is None else not value


@record
class Examiner:
    """Checks any number of answers to a problem that is solved once.

    solution  None where the file gives the equations outright
    """

    problem: Problem
    solution: Solution | None

    @classmethod
    def of(cls, problem: Problem) -> Examiner:
        """Solves the problem, so that answers can be checked. Raises ProblemError where it cannot be solved."""
        return cls(problem, None if problem.equations else solve(problem))

    @cached_property
    def reference(self) -> Reference:
        """What equations of motion are compared with. Raises ProblemError where there is nothing of the kind."""
        return reference_of_equations(self.problem) if self.solution is None else _reference_of(self.solution)

    def check(self, answer: tuple[Fragment, ...]) -> CheckedAnswer:
        """The verdict on somebody's equations. Raises ProblemError where there are none, or none to compare with."""
        answer = separated(answer)
        solution = self.solution
        at_rest = solution is not None and (solution.motion is None or not _moves(answer, solution))
        if solution is not None and solution.equilibrium is not None and at_rest:
            return _check_statics(answer, solution, solution.equilibrium)
        return CheckedAnswer(check_equations(answer, self.reference))

    def check_answers(self, answers: Answers, more: tuple[Fragment, ...] = ()) -> CheckedAnswer:
        """The verdict on somebody's answers to all questions; `more` are equations beside them. Raises ProblemError."""
        solution, equations = self.solution, (*answers.equations, *more)
        others = (
            tuple(_nothing_to_compare(answers))
            if solution is None
            else (*_before_equations(solution, answers), *_after_equations(solution, answers))
        )
        if not equations:
            return CheckedAnswer(AnswerVerdict(Verdict.EQUIVALENT, ()), others)
        return replace(self.check(equations), others=others)

    def check_own(self) -> CheckedAnswer:
        """The verdict on the answers that the problem file states. Raises ProblemError where it states none."""
        answers, solution = self.problem.answers or Answers(), self.solution
        if solution is None:
            return self.check(answers.equations)
        others = (*_before_equations(solution, answers), *map(_readable, _after_equations(solution, answers)))
        if not answers.equations and others:
            return CheckedAnswer(AnswerVerdict(Verdict.EQUIVALENT, ()), others)
        return CheckedAnswer(check_equations(answers.equations, self.reference), others)

    def revealed(self, checked: CheckedAnswer) -> tuple[sp.Expr, ...]:
        """The derived equations, each zero, in the coordinates in which an answer was compared; none in statics."""
        choice, solution = checked.equations.choice, self.solution
        if solution is None:
            return next(c.system.equations for c in self.reference.candidates if c.choice == choice)
        motions = {"": solution.motion, **{c.name: c.motion for c in solution.choices}}
        found = motions.get(choice) if checked.equations.equations else next(iter(motions.values()))
        return found.expressions if found is not None else ()


def check_answer(problem: Problem, answer: tuple[Fragment, ...]) -> CheckedAnswer:
    """The verdict on somebody's equations. Raises ProblemError where there are none, or none to compare them with."""
    return Examiner.of(problem).check(answer)


def check_answers(problem: Problem, answers: Answers, more: tuple[Fragment, ...] = ()) -> CheckedAnswer:
    """The verdict on somebody's answers to all questions; `more` are equations beside them. Raises ProblemError."""
    return Examiner.of(problem).check_answers(answers, more)


def _nothing_to_compare(answers: Answers) -> Iterator[ComparedAnswer]:
    """The answers that a reference system given outright says nothing about."""
    why = "the problem gives its equations and no more: there is nothing to compare this with"
    for name in ("degrees_of_freedom", "classification", "integrable", "equilibrium", "reactions"):
        if getattr(answers, name) not in (None, (), {}):
            yield ComparedAnswer(name, Verdict.UNDECIDED, why)


def _check_statics(answer: Sequence[Fragment], solution: Solution, equilibrium: Equilibrium) -> CheckedAnswer:
    """The verdict on equilibria, and on what is said of reactions there."""
    from lagrange.answers.equilibrium_answers import alternatives_of, check_equilibria

    found = [equilibrium, *(c.equilibrium for c in solution.choices if c.equilibrium is not None)]
    reference = reference_of_solution(solution)
    at_rest = _at_rest(solution)
    readings = [(f, read_answer(f, reference.scope)) for f in answer] if at_rest else []
    about = [(f, r) for f, r in readings if at_rest and at_rest.is_about(r)]
    rest = [f for f in answer if all(f is not other for other, _ in about)]
    if not about or at_rest is None:
        return CheckedAnswer(check_equilibria(alternatives_of(answer), found, reference), statics=True)
    stated = tuple(at_rest.check(r) for _, r in about)
    verdict = _all_stated(stated)
    notes = tuple(n for _, r in about for n in r.notes)
    if not rest:
        return CheckedAnswer(AnswerVerdict(verdict, stated, notes=notes), reactions=True)
    positions = check_equilibria(alternatives_of(rest), found, reference)
    both = next((v for v in FIRST if v in (positions.verdict, verdict) and v is not Verdict.TRIVIAL), positions.verdict)
    return CheckedAnswer(
        replace(positions, verdict=both, equations=(*positions.equations, *stated), notes=(*positions.notes, *notes)),
        statics=True,
        reactions=True,
    )


def _all_stated(stated: Sequence[EquationVerdict]) -> Verdict:
    """The verdict on several equations; identities count where there is nothing else."""
    verdicts = {v.verdict for v in stated}
    return next((v for v in (*FIRST[:-1], Verdict.EQUIVALENT) if v in verdicts), Verdict.TRIVIAL)


def _moves(answer: Sequence[Fragment], solution: Solution) -> bool:
    """Whether velocities or accelerations occur in an answer."""
    scope = reference_of_solution(solution).scope
    readings = [read_answer(f, scope) for f in answer]
    return any(base(s) != s for r in readings for e in r.components for s in e.free_symbols)


def check_own_answers(problem: Problem) -> CheckedAnswer:
    """The verdict on the answers that the problem file states. Raises ProblemError where it states none."""
    return Examiner.of(problem).check_own()


def reference(problem: Problem) -> Reference:
    """What answers to a problem are compared with: its solution, or the equations that it gives outright."""
    return Examiner.of(problem).reference


def _reference_of(solution: Solution) -> Reference:
    if solution.motion is None:
        message = "the problem asks for no motion: there are no equations to compare with"
        help_ = "give the problem masses, and leave `find` out"
        raise ProblemError(Diagnostic("no-equations", message, help=help_))
    return reference_of_solution(solution)
