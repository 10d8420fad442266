"""Checking answers to every question about a problem: degrees of freedom, equations, equilibria, reactions, ...

An `Examiner` solves a problem once and then checks any number of answers, as `lagsolve check` and `lagsolve grade` do.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields, replace
from functools import cached_property
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.answers.equations import ComparedAnswer, check_equations, compared_answer
from lagrange.answers.limits import UNITS_OF_CHECKING
from lagrange.answers.questions.own_answers import (
    answers_besides_equations,
    asks_for_rest_alone,
    compared_impending,
    compared_rest,
    conditions_of_rest,
    explained_rest,
    on_freedom_and_class,
    readable,
)
from lagrange.answers.questions.stated_constraints import (
    about_constraints,
    check_constraints,
    is_about_freedom,
    stated_in_words,
)
from lagrange.answers.questions.texts.frequency_labels import FREQUENCY_WORDS
from lagrange.answers.questions.values_in_text import as_asked
from lagrange.answers.readings import GivenEquation, read_answer
from lagrange.answers.reference_systems import reference_of_equations
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import (
    AnswerVerdict,
    Judgement,
    Reason,
    Verdict,
)
from lagrange.answers.written.joined_lines import has_sign_of_equality
from lagrange.answers.written.values import with_all_values
from lagrange.core.diagnostics import Diagnostic, Fragment, GaveUpError, ProblemError
from lagrange.core.effort import allowed_for
from lagrange.core.records import record
from lagrange.core.symbols import base, symbols_in
from lagrange.expressions.characters import GREEK
from lagrange.expressions.reader import Scope, is_inequality
from lagrange.mechanics.results import Solution
from lagrange.mechanics.solution import OnStage, silent, solve
from lagrange.problem.model import Answers, Problem

if TYPE_CHECKING:
    from lagrange.answers.points import Score
    from lagrange.answers.written.working import Working


@record
class Examiner:
    """Checks any number of answers to a problem, which is solved once.

    solution  None if the file gives the equations outright
    """

    problem: Problem
    solution: Solution | None

    @classmethod
    def of(cls, problem: Problem, on_stage: OnStage = silent) -> Examiner:
        """Solves the problem, so that answers can be checked. Raises ProblemError if it cannot be solved."""
        solution = None if problem.equations else solve(problem, on_stage=on_stage)
        if solution is not None and solution.given_up:
            raise GaveUpError(solution.given_up)
        return cls(problem, solution)

    @cached_property
    def reference(self) -> Reference:
        """The equations of motion that answers are compared with. Raises ProblemError if there are none."""
        return reference_of_equations(self.problem) if self.solution is None else _reference_of(self.solution)

    @cached_property
    def required(self) -> int | None:
        """How many independent equations of motion are asked for; None if the problem asks for no motion."""
        if self.solution is not None and self.solution.own.motion is None:
            return None
        return check_equations((Fragment.of("0 = 0"),), self.reference).missing

    @property
    def asks_for_conditions(self) -> bool:
        """Whether inequalities are asked for: where friction holds the system."""
        return self.solution is not None and bool(conditions_of_rest(self.solution))

    @property
    def reads_inequalities(self) -> bool:
        """Whether an inequality may be an answer: a condition of rest, or the limit of a parameter."""
        asked = self.solution.asked if self.solution is not None else ()
        parameters = {p.symbol for p in self.problem.parameters}
        return self.asks_for_conditions or any(a.question.quantity in parameters for a in asked)

    @property
    def names_of_questions(self) -> tuple[str, ...]:
        """The names of everything the file asks for: its questions, the coordinates of a response, and frequencies."""
        if self.solution is None:
            return ()
        oscillations = any(v.linearization is not None for v in self.solution.views)
        coordinates = {q.name for v in self.solution.views if v.response is not None for q in v.response.by_coordinate}
        frequencies = FREQUENCY_WORDS if oscillations else ()
        amplitudes = ("amplitude", "Amplitude") if len(coordinates) == 1 else ()
        return *(a.question.name for a in self.solution.asked), *sorted(coordinates), *frequencies, *amplitudes

    def score(self, judgement: Judgement) -> Score:
        """The points for an answer that was judged by this examiner."""
        from lagrange.answers.points import score

        return score(self.problem, judgement, self.required)

    def check(self, answer: tuple[Fragment, ...]) -> Judgement:
        """The verdict on equations. Raises ProblemError if there are none, or none to compare them with."""
        only_words = bool(answer) and not any(map(has_sign_of_equality, (f.text for f in answer)))
        if self.solution is not None and (only_words or about_constraints(self.solution)):
            words = stated_in_words("\n".join(dict.fromkeys(f.whole.source.text for f in answer)))
            if words != Answers():
                equations = () if only_words else tuple(f for f in answer if not is_about_freedom(f))
                return self.check_answers(words, equations)
            if only_words:
                from lagrange.answers.questions.stability_in_text import (
                    check_stability_sentences,
                    is_about_stability,
                )

                if all(is_about_stability(f.text) for f in answer):
                    verdict = check_stability_sentences(answer, self.solution, self._statics_reference)
                    if verdict is not None:
                        return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), (verdict,))
                answer = as_asked(answer, self.solution) or answer
        with allowed_for("comparing answers", UNITS_OF_CHECKING):
            return self._checked(answer)

    def _checked(self, answer: tuple[Fragment, ...]) -> Judgement:
        from lagrange.answers.questions.in_text import judged_in_text
        from lagrange.answers.written.lines import separated_lines
        from lagrange.answers.written.numbering import notes_on_numbers

        notes = [note for source in dict.fromkeys(f.whole.source for f in answer) for note in notes_on_numbers(source)]
        answer = separated_lines(answer)
        judged = (
            self._compared(answer) if self.solution is None else judged_in_text(answer, self.solution, self._compared)
        )
        return replace(judged, equations=replace(judged.equations, notes=(*notes, *judged.equations.notes)))

    def _compared(self, answer: Sequence[Fragment]) -> Judgement:
        """The verdict on equations of motion, of equilibrium, and on constraints."""
        from lagrange.answers.friction.forces_of_working import in_two, without_case
        from lagrange.answers.questions.at_release import is_about_release
        from lagrange.answers.questions.equilibrium_in_text import with_stated_conditions
        from lagrange.answers.written.lines import condition_alone, conditions_of
        from lagrange.answers.written.one_line import without_prose
        from lagrange.answers.written.working import Working, understood

        solution = self.solution
        if solution is not None and self.asks_for_conditions and any(map(is_inequality, answer)):
            from lagrange.answers.friction.stated_limits import with_limits_put_in

            answer, case = without_case(with_limits_put_in(answer), [q.name for q in self.problem.slots.coordinates])
            stated = [p for f in answer for c in conditions_of(condition_alone(f)) for p in in_two(condition_alone(c))]
            known = self._statics_reference.scope.names()
            judged = self._with_conditions([without_prose(c, known.__contains__) for c in stated], solution)
            said = f"`{case}`: the case in which a condition holds is not judged"
            notes = (Diagnostic("not-judged", said, answer[0].whole).as_note(),) if case else ()
            return replace(judged, equations=replace(judged.equations, notes=(*judged.equations.notes, *notes)))
        if solution is not None and self.asks_for_conditions and asks_for_rest_alone(solution):
            from lagrange.answers.friction.stated_limits import check_limits

            limits = check_limits(answer, conditions_of_rest(solution), self._statics_reference, solution)
            return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), (limits,))
        moving = solution is None or solution.own.motion is not None
        scope = self.reference if moving else self._statics_reference
        working = understood(answer, scope, moving=moving and (solution is None or solution.own.equilibrium is None))
        if solution is not None and about_constraints(solution):
            return self._judgement(check_constraints(working, solution))
        if not working.judged:
            if working.quoting and not working.unreadable:
                message = "the method is quoted, and no equation follows that could be checked"
                help_ = "carry the derivatives out, or write down the Lagrangian: `L = ...`"
                raise ProblemError(Diagnostic("no-answer", message, answer[0].whole, help=help_))
            working = Working(tuple(answer))
        if solution is not None and not moving:
            working = with_stated_conditions(working, solution)
        at_rest = solution is not None and (
            solution.own.motion is None or not _moves(working.judged, self._statics_reference.scope)
        )
        if solution is not None and at_rest and any(v.impending for v in solution.views):
            from lagrange.answers.equilibria import alternatives_of
            from lagrange.answers.friction.impending import by_directions, one_a_line

            shown = working.judged
            verdict = compared_impending(solution, alternatives_of(shown))
            for sorted_ in (one_a_line, by_directions):  # up or down, a line each
                unsettled = verdict.verdict in (Verdict.WRONG, Verdict.INCOMPLETE)
                if not unsettled or len(lines := sorted_(shown, solution)) < 2:
                    continue
                each = compared_impending(solution, lines)
                better = (Verdict.EQUIVALENT, Verdict.INCOMPLETE) if verdict.verdict is Verdict.WRONG else _RIGHT
                verdict = each if each.verdict in better else verdict
            if verdict.verdict is Verdict.WRONG and verdict.diagnosis:
                return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), (verdict,))
            return self._judgement(verdict, statics=True)
        if solution is not None and solution.own.equilibrium is not None and at_rest:
            return self._statics(working, solution)
        verdict = self._on_motion(working)
        if working.unknowns and verdict.verdict in (Verdict.INCOMPLETE, Verdict.TRIVIAL):
            alone = understood(answer, scope, eliminating=False)
            verdict = self._on_motion(alone if alone.judged else Working(tuple(answer)))
        if working.unknowns and verdict.verdict is Verdict.WRONG:
            named = self._on_motion(understood(answer, scope, naming=True))
            some_right = any(e.verdict is Verdict.EQUIVALENT for e in named.equations)
            if any(e.model or (e.cause and some_right) for e in named.equations):
                verdict = replace(named, verdict=Verdict.WRONG)  # of a force that is eliminated nothing can be said
        if is_about_release(verdict):
            return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), (replace(verdict, name="ask"),))
        return self._judgement(verdict)

    def _with_conditions(self, answer: Sequence[Fragment], solution: Solution) -> Judgement:
        """The verdict on conditions of rest, with that on equations where the problem asks for these too."""
        equations = tuple(f for f in answer if not is_inequality(f))
        forces = (
            {s.name for r in solution.law.newton.reactions for s in (r.multiplier, r.force)} if solution.law else {}
        )
        laws = [f for f in answer if is_inequality(f) and not {*_WORD.findall(f.text)}.isdisjoint(forces)]
        if equations and laws and solution.own.motion is not None:  # |F| <= mu_s*N beside the equations of motion
            answer = [f for f in answer if f not in laws]
            if len(answer) == len(equations):
                return self._checked(equations)
        from lagrange.answers.friction.forces_of_working import without_forces
        from lagrange.answers.friction.stated_limits import chains_that_differ

        alone = asks_for_rest_alone(solution)
        inequalities = tuple(f for f in answer if is_inequality(f))
        defined = self._defined_beside(equations) if inequalities else {}
        working = without_forces(inequalities, equations, self._statics_reference) if alone else None
        if working is not None:
            inequalities, equations, defined = working.conditions, working.equations, {**defined, **working.forces}
            answer = [*inequalities, *equations]
        if defined:  # with the angle of friction, tan(rho) = mu
            equations = tuple(f for f in equations if not _is_definition(f, defined))
            answer = [*inequalities, *equations]
        differing = chains_that_differ(inequalities, self._statics_reference)
        rest = differing or compared_rest(solution, answer if alone else inequalities, defined)
        if alone and rest.verdict is Verdict.UNDECIDED and equations:
            rest = self._beside_balances(inequalities, equations, defined, solution) or rest
        rest = replace(rest, notes=(*rest.notes, *(working.notes if working else ())))
        if alone or not equations:
            return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), (rest,))
        judged = self._checked(equations)
        if rest.verdict is Verdict.EQUIVALENT and judged.verdict is Verdict.INCOMPLETE and solution.own.motion is None:
            return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), (rest,))  # a reaction, from which they follow
        return replace(judged, others=(rest, *judged.others))

    def _beside_balances(
        self,
        inequalities: Sequence[Fragment],
        equations: Sequence[Fragment],
        defined: Mapping[str, sp.Expr],
        solution: Solution,
    ) -> AnswerVerdict | None:
        """The verdict on conditions of rest beside balances of reactions, and equations at a limit, P h = W b.

        None if it is not settled.
        """
        from lagrange.answers.friction.forces_of_working import in_both_senses, without_forces

        newton = solution.law.newton if solution.law else None
        named = {s for r in (newton.reactions if newton else ()) for s in (r.given, r.multiplier, r.symbol) if s}
        reference = self._statics_reference
        named |= {
            *reference.unknowns,
            *(s for s in reference.scope.scalars.values() if s.is_Symbol and s.name[:2] == "F_"),
        }
        named -= {*reference.parameters.values(), *reference.scope.slots.coordinates}
        working = without_forces(inequalities, equations, reference, {s.name: s for s in named})
        notes: tuple[Diagnostic, ...] = ()
        if working is not None:
            inequalities, equations, notes = working.conditions, working.equations, working.notes
            defined = {**defined, **working.forces}
        settled = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)
        limits = [
            f
            for f in equations
            if any(compared_rest(solution, [c], defined).verdict in settled for c in in_both_senses(f))
        ]
        stated = [*inequalities, *(f for f in equations if f not in limits)]
        verdict = compared_rest(solution, stated, defined)
        return None if verdict.verdict is Verdict.UNDECIDED else replace(verdict, notes=(*verdict.notes, *notes))

    def _defined_beside(self, equations: Sequence[Fragment]) -> Mapping[str, sp.Expr]:
        """The names that equations beside conditions of rest define."""
        from lagrange.answers.written.working import understood

        if not equations:
            return {}
        working = understood(equations, self._statics_reference, moving=False)
        return {} if working.unreadable else working.defined

    def _on_motion(self, working: Working) -> AnswerVerdict:
        from lagrange.answers.questions.at_release import at_release
        from lagrange.answers.recognition import integrals_apart
        from lagrange.answers.results.forces import kept_from_start
        from lagrange.answers.written.judging import verdict_on

        reference = self.reference.of_answers
        if working.unknowns:
            reference = replace(reference, unknowns=(*reference.unknowns, *working.unknowns))

        last: tuple[list[Fragment], ComparedAnswer] | None = None

        def check(equations: Sequence[Fragment], diagnosing: bool) -> AnswerVerdict:
            nonlocal last  # a wrong answer is asked about twice, the second time with a diagnosis
            if last is None or [*map(id, equations)] != [*map(id, last[0])]:
                last = [*equations], compared_answer(equations, reference)
            verdict = last[1].verdict(diagnosing=diagnosing)
            if verdict.verdict is Verdict.WRONG:
                verdict = kept_from_start(equations, verdict, self.problem.initial, reference)
            return verdict if self.solution is None else at_release(equations, verdict, self.solution, reference)

        return integrals_apart(verdict_on(working, reference, check, only_motion=self._asks_only_for_motion))

    @property
    def _asks_only_for_motion(self) -> bool:
        """Whether nothing is asked for that a relation between coordinates may answer, as a path or a position."""
        if self.solution is None or self.problem.initial or self.solution.asked:
            return False
        return not any(v.linearization or v.steady or v.equilibrium or v.response for v in self.solution.views)

    def _statics(self, working: Working, solution: Solution) -> Judgement:
        from lagrange.answers.questions.stability_in_text import with_stability
        from lagrange.answers.questions.statics import check_statics_answers
        from lagrange.answers.written.judging import verdict_on

        kinds = (True, False)

        def check(equations: Sequence[Fragment], _: bool) -> AnswerVerdict:
            nonlocal kinds
            verdict, *shown = check_statics_answers(equations, solution)
            kinds = (shown[0], shown[1])
            return verdict

        verdict = verdict_on(working, self._statics_reference, check, moving=False)
        if verdict.verdict in (Verdict.WRONG, Verdict.INCOMPLETE) and len(working.judged) > 1:
            verdict = self._as_alternatives(working, solution, verdict)
        if verdict.verdict is Verdict.WRONG and kinds == (True, False):
            verdict = self._with_explanation(working, solution, verdict)
        verdict = with_stability(verdict, working.judged, solution, self._statics_reference)
        return self._judgement(verdict, statics=kinds[0], reactions=kinds[1])

    def _as_alternatives(self, working: Working, solution: Solution, verdict: AnswerVerdict) -> AnswerVerdict:
        """The verdict on equations that cannot hold together, one a line, as on positions of equilibrium in a list."""
        from lagrange.answers.equilibria import alternatives_of, check_equilibria

        equilibria = [v.equilibrium for v in solution.views if v.equilibrium is not None]
        if grouped := _several_positions(working.judged):
            together = check_equilibria(grouped, equilibria, self._statics_reference)
            if together.verdict is Verdict.EQUIVALENT:
                return replace(together, notes=(*together.notes, *working.notes))
        listed = [a for f in working.judged for a in alternatives_of([f])]
        each = check_equilibria(listed, equilibria, self._statics_reference)
        if verdict.verdict is Verdict.INCOMPLETE:  # `theta = asin(M/m)` and `theta = pi - asin(M/m)`, no `x = 0; y = l`
            readings = [f.reading for f in working.judged if isinstance(f, GivenEquation)]
            moving = {*self._statics_reference.scope.slots.coordinates}
            used = {s for r in readings for e in r.components for s in e.free_symbols} & moving
            if each.verdict is not Verdict.EQUIVALENT or len(used) != 1:
                return verdict
        if each.verdict not in (Verdict.EQUIVALENT, Verdict.INCOMPLETE):
            return verdict
        message = "the equations cannot hold together, and are read as one position of equilibrium each"
        help_ = "write `or` between alternatives"
        note = Diagnostic("read-as", message, working.judged[0].whole, help=help_).as_note()
        return replace(each, notes=(*each.notes, *working.notes, note))

    def _with_explanation(self, working: Working, solution: Solution, verdict: AnswerVerdict) -> AnswerVerdict:
        """The verdict on wrong equilibria, with the changed problem of which they are the equilibria."""
        from lagrange.answers.equilibria import alternatives_of

        equilibria = [v.equilibrium for v in solution.views if v.equilibrium is not None]
        wrong = [
            (f,)
            for f, e in zip(working.judged, verdict.equations, strict=False)
            if e.verdict is Verdict.WRONG and len(verdict.equations) == len(working.judged)
        ]
        tried = (alternatives_of(working.judged), wrong if len(wrong) < len(working.judged) else [])
        explanations = (explained_rest(a, equilibria, self._statics_reference, self.problem) for a in tried if a)
        why = next(filter(None, explanations), "")
        others = [e for e in verdict.equations if e.verdict is Verdict.WRONG and not e.is_unexplained]
        occurring = {s.name for e in equilibria for c in e.conditions for s in c.expression.free_symbols}
        letters = (_letters(e.text) for e in verdict.equations if e.is_for(Reason.NOT_REQUIRED))
        if not why or others or not all(those & occurring for those in letters):
            return verdict  # no changed problem gives W = 7 l where neither letter occurs
        equations = tuple(
            replace(
                e,
                hints=(e.diagnosis, e.diagnosis, f"{e.diagnosis}; {why}"),
                diagnosis=f"{e.diagnosis}; {why}",
                cause=why,
            )
            if e.verdict is Verdict.WRONG and e.is_unexplained
            else e
            for e in verdict.equations
        )
        return replace(verdict, equations=equations)

    @cached_property
    def _statics_reference(self) -> Reference:
        assert self.solution is not None
        return reference_of_solution(self.solution)

    def check_answers(self, answers: Answers, more: tuple[Fragment, ...] = ()) -> Judgement:
        """The verdict on answers to all questions; `more` are equations beside them. Raises ProblemError."""
        from lagrange.answers.written.lines import separated_lines

        solution, equations = self.solution, (*answers.equations, *more)
        listed: tuple[AnswerVerdict, ...] = ()
        if solution is not None and solution.own.motion is None and len(answers.equilibrium) == 1:
            [flat] = answers.equilibrium
            stated = separated_lines(with_all_values(flat, solution.problem.scope.names()))
            if [f.text for f in stated] != [f.text for f in flat]:  # `theta = 0, theta = pi` is as in a text
                listed = (replace(self._compared(stated).equations, name="equilibrium"),)
                answers = replace(answers, equilibrium=())
        if len(answers.steady) == 1:  # `v^2 = g r, v = r phi'`
            answers = replace(answers, steady=(tuple(e for f in answers.steady[0] for e in separated_lines([f])),))
        others = (
            tuple(_nothing_to_compare(answers))
            if solution is None
            else (*on_freedom_and_class(solution, answers), *answers_besides_equations(solution, answers))
        )
        others = (*others, *listed)
        if not equations:
            return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), others)
        with allowed_for("comparing answers", UNITS_OF_CHECKING):
            judged = self._checked(equations)
            return replace(judged, others=(*others, *judged.others))

    def check_own(self) -> Judgement:
        """The verdict on the answers that the problem file states. Raises ProblemError if it states none."""
        answers, solution = self.problem.answers or Answers(), self.solution
        if solution is None:
            return self.check(answers.equations)
        others = (
            *on_freedom_and_class(solution, answers),
            *map(readable, answers_besides_equations(solution, answers)),
        )
        if not answers.equations and others:
            return self._judgement(AnswerVerdict(Verdict.EQUIVALENT), others)
        if solution.linear_motion is not None:
            from lagrange.answers.questions.linear_equations import check_linear_motion_answers

            return self._judgement(check_linear_motion_answers(answers.equations, solution), others)
        return self._judgement(check_equations(answers.equations, self.reference), others)

    def revealed(self, judgement: Judgement) -> tuple[sp.Expr, ...]:
        """The derived equations, each zero, in the coordinates in which an answer was compared; none in statics."""
        return self._derived(judgement.equations)

    def _derived(self, equations: AnswerVerdict) -> tuple[sp.Expr, ...]:
        choice, solution = equations.choice, self.solution
        if solution is None:
            return next(c.system.equations for c in self.reference.candidates if c.choice == choice)
        motions = {v.name: v.motion for v in solution.views}
        motion = motions.get(choice) if equations.equations else next(iter(motions.values()))
        return motion.expressions if motion is not None else ()

    def _judgement(
        self,
        equations: AnswerVerdict,
        others: tuple[AnswerVerdict, ...] = (),
        *,
        statics: bool = False,
        reactions: bool = False,
    ) -> Judgement:
        """The verdict on the whole."""
        derived = self._derived(equations) if equations.equations else ()
        return Judgement(equations, others, statics, reactions, problem=self.problem, derived=derived)


def _is_definition(fragment: Fragment, defined: Mapping[str, sp.Expr]) -> bool:
    """Whether an equation has one of the names that an answer defines alone, or in one function, on its left."""
    words = [GREEK.get(w, w) for w in _WORD.findall(fragment.text.partition("=")[0])]
    return bool(words) and len(words) <= 2 and words[-1] in defined


_WORD = re.compile(r"[^\W\d]\w*")

_RIGHT = (Verdict.EQUIVALENT,)


def _letters(text: str) -> set[str]:
    """The words of a text that are no commands of LaTeX."""
    return {*_WORD.findall(re.sub(r"\\[A-Za-z]+", " ", text))}


def check_answer(problem: Problem, answer: tuple[Fragment, ...]) -> Judgement:
    """The verdict on equations. Raises ProblemError if there are none, or none to compare them with."""
    return Examiner.of(problem).check(answer)


def check_answers(problem: Problem, answers: Answers, more: tuple[Fragment, ...] = ()) -> Judgement:
    """The verdict on answers to all questions; `more` are equations beside them. Raises ProblemError."""
    return Examiner.of(problem).check_answers(answers, more)


def _nothing_to_compare(answers: Answers) -> Iterator[AnswerVerdict]:
    """The answers to questions that equations given outright do not settle: undecided."""
    why = "the problem gives its equations and no more: there is nothing to compare this with"
    for answer in fields(Answers):
        if answer.name != "equations" and getattr(answers, name := answer.name) not in (None, (), {}):
            yield AnswerVerdict(Verdict.UNDECIDED, name=name, diagnosis=why)


def _moves(answer: Sequence[Fragment], scope: Scope) -> bool:
    """Whether velocities or accelerations occur in an answer."""
    readings = [read_answer(f, scope) for f in answer]
    return any(base(s) != s for r in readings for e in r.components for s in symbols_in(e))


def check_own_answers(problem: Problem) -> Judgement:
    """The verdict on the answers that the problem file states. Raises ProblemError if it states none."""
    return Examiner.of(problem).check_own()


def reference(problem: Problem) -> Reference:
    """The reference for answers to a problem: its solution, or the equations that it gives outright."""
    return Examiner.of(problem).reference


def _reference_of(solution: Solution) -> Reference:
    if solution.own.motion is None:
        message = "the problem asks for no motion: there are no equations to compare with"
        help_ = "give the problem masses, and leave `find` out"
        raise ProblemError(Diagnostic("no-equations", message, help=help_))
    return reference_of_solution(solution)


def _several_positions(judged: Sequence[Fragment]) -> list[list[Fragment]]:
    """`x = a, y = b or x = c, y = d` as two positions of two coordinates each; empty if it is no such list."""
    from lagrange.answers.equilibria import alternatives_of

    listed = [f for whole in judged for alternative in alternatives_of([whole]) for f in alternative]
    names = [f.text.partition("=")[0].strip(" $&") for f in listed]
    size = len(dict.fromkeys(names))
    if size < 2 or size == len(names) or names != names[:size] * (len(names) // size):
        return []
    return [listed[n : n + size] for n in range(0, len(listed), size)]
