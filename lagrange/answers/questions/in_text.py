"""Texts that answer other questions than for equations of motion: impacts, steady states, values, Hamilton's function.

In a file of answers each question has its key. In a text it is recognised by what the problem asks for and by the
contents of the lines. What is an equation of motion, a position of equilibrium or a constraint is judged as such.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.questions.equilibrium_in_text import (
    at_stated_positions,
    definition_of_kept,
    is_kept,
    period_as_rate,
    positions_of,
    says_steady,
    supports_of,
    with_rate_as_omega,
)
from lagrange.answers.questions.named_values import NOT_EQUAL, sides_agree, stated_in_numbers, without_place
from lagrange.answers.questions.stability_in_text import with_sentences_on_stability
from lagrange.answers.questions.texts.beside_motion import questions_of_condition, with_results_beside
from lagrange.answers.questions.texts.frequency_labels import (
    is_characteristic,
    name_of_frequency,
    stated_frequencies,
)
from lagrange.answers.questions.values_in_text import asked_in_text
from lagrange.answers.readings import read_answer
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Judgement, Recognised, Verdict
from lagrange.answers.written.lines import condition_alone, conditions_of, in_pairs
from lagrange.answers.written.one_line import each_alternative, without_integrals
from lagrange.answers.written.reading import read_as_written, tried
from lagrange.answers.written.values import marks_approximation, with_all_values
from lagrange.answers.written.working import Working
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.expressions.edits import cut
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.reader import is_inequality, limit_of, read_value
from lagrange.mechanics.results import Solution
from lagrange.problem.values import values_of

Judge = Callable[[Sequence[Fragment]], Judgement]
"""The verdict on equations of motion, of equilibrium, and of constraints. May raise ProblemError."""

_SECOND_VARIATION = re.compile(
    r"\s*\$?\s*(?:[VUEΠ](?:''|″|_\{?\w\w\}?\s)|d\s*(?:\^\s*2|²)\s*[VUEΠ]|\\frac\s*\{\s*d\s*\^\s*\{?2\}?\s*[VUE])"
)
"""The second derivative of a potential energy, which is working."""
_NUMBER_ALONE = re.compile(r"(?:=|≈)\s*[-+−]?[0-9]{1,12}(?:\.[0-9]{1,12})?[\s.]*\Z")
_JUDGED = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.WRONG)
_MAY_BE_ENERGY = re.compile(r"[\s$&]*(?:T|K)(?:_\{?\w{1,8}\}?)?\s*&?=(?!=)")
_HAMILTON = re.compile(
    r"\s*\$*\s*(?:\\(?:mathcal|mathrm|mathscr)\s*\{?\s*H\s*\}?|H|ℋ)\s*(?:\([^()=]{0,40}\)|\[t\])?\s*="
)


def judged_in_text(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    """The verdict on a text; that of `judge` if the text is about nothing else. Raises ProblemError."""
    from lagrange.answers.claims.conditions import is_no_result
    from lagrange.answers.claims.judging import with_claims

    results = [f for f in answer if not (is_inequality(f) and is_no_result(f.text, solution))] or answer
    judged = with_results_beside(results, _judged(results, solution, judge), solution)
    return with_claims(answer, with_sentences_on_stability(answer, judged, solution), solution)


def _judged(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    if solution.impact is not None and solution.own.motion is None:
        return _impact(answer, solution)
    if solution.linear_motion is not None:
        from lagrange.answers.questions.linear_equations import check_linear_motion_answers

        return Judgement(check_linear_motion_answers(answer, solution), problem=solution.problem)
    if (rest := solution.rest_in_numbers) is not None and not _with_accelerations(answer, solution):
        from lagrange.answers.questions.statics import compared_with_rest

        return Judgement(compared_with_rest([answer], rest, solution), statics=True, problem=solution.problem)
    if any(v.response is not None for v in solution.views):
        return _response(answer, solution, judge)
    if any(v.hamiltonian is not None for v in solution.views):
        functions = [f for f in answer if _HAMILTON.match(f.text)]
        if functions:
            return _hamiltonian(functions, [f for f in answer if f not in functions], solution, judge)
    if any(v.steady is not None for v in solution.views):
        return _with_frequencies(answer, solution, lambda rest: _steady(rest, solution, judge))
    if any(v.linearization is not None for v in solution.views) and not solution.asked:
        return _linearized(answer, solution, lambda f: _with_frequencies(f, solution, judge))
    if any(a.answered for a in solution.asked):
        if any(v.linearization is not None for v in solution.views):
            return _asked(answer, solution, lambda rest: _with_frequencies(rest, solution, judge))
        return _asked(answer, solution, judge)
    if solution.own.motion is None and any(v.equilibrium is not None for v in solution.views):
        answer = with_all_values(answer, solution.problem.scope.names())
        answer = [f for f in answer if not _SECOND_VARIATION.match(f.text)] or answer
        if (of_supports := supports_of(answer, solution)) is not None:
            forces, answer = of_supports
            if not answer:
                return _only(forces, solution)
            judged = judge(answer)
            return replace(judged, others=(*judged.others, forces))
    return judge(answer)


def _only(verdict: AnswerVerdict, solution: Solution) -> Judgement:
    """The verdict on an answer to a single question, if the text contains nothing else."""
    return Judgement(AnswerVerdict(Verdict.EQUIVALENT), (verdict,), problem=solution.problem)


def _with_accelerations(answer: Sequence[Fragment], solution: Solution) -> bool:
    """Whether a text has equations of motion."""
    reference = reference_of_solution(solution)
    readings = (read_answer(f, reference.scope) for f in answer)
    return any({*e.free_symbols} & {*solution.problem.slots.accelerations} for r in readings for e in r.components)


def _impact(answer: Sequence[Fragment], solution: Solution) -> Judgement:
    from lagrange.answers.questions.impact import (
        check_impact_in_text,
        check_loss,
        with_impulses,
        with_losses,
        with_omega,
        without_primes_after,
        without_sign_after,
    )
    from lagrange.answers.written.working import understood

    motion = solution.impact
    assert motion is not None
    answer = [without_sign_after(f) for f in answer]
    lines = with_losses(answer)
    if losses := [check_loss(f, solution) for f, is_loss in lines if is_loss]:
        rest = [f for f, is_loss in lines if not is_loss]
        judged = _impact(rest, solution) if rest else None
        return replace(judged, others=(*judged.others, *losses)) if judged else _only(losses[-1], solution)
    reference = with_impulses(reference_of_solution(solution), motion)
    answer = without_primes_after(answer, reference.declared)
    verdict = check_impact_in_text(understood(answer, reference), motion, reference, solution.problem)
    if verdict.unreadable or verdict.verdict in (Verdict.UNDECIDED, Verdict.TRIVIAL, Verdict.INCOMPLETE):
        others = with_omega(answer, reference, motion)  # omega may be the name of the rate
        tried = [check_impact_in_text(understood(answer, r), motion, r, solution.problem) for r in others]
        right = next((v for v in tried if v.verdict is Verdict.EQUIVALENT), None)
        wrong_in_both = all(v.verdict is Verdict.WRONG for v in tried)
        doubtful = verdict.verdict is not Verdict.INCOMPLETE or wrong_in_both
        verdict = right or (next(iter(tried), verdict) if doubtful else verdict)
    verdict = replace(verdict, name="impact")
    if not solution.asked:
        return _only(verdict, solution)
    if verdict.verdict is Verdict.EQUIVALENT:
        found = asked_in_text(answer, solution)
        judged, values = _only(verdict, solution), found.verdict
        if values is not None and values.verdict in (Verdict.EQUIVALENT, Verdict.WRONG):
            return replace(judged, others=(*judged.others, _if_complete(values, found.missing)))
        if values is not None or not found.missing:
            return judged
        unanswered = AnswerVerdict(Verdict.EQUIVALENT, name="ask")
        return replace(judged, others=(*judged.others, _if_complete(unanswered, found.missing)))
    judged = _with_asked(
        answer,
        solution,
        lambda f: _only(
            replace(check_impact_in_text(understood(f, reference), motion, reference, solution.problem), name="impact"),
            solution,
        ),
        _only(verdict, solution),
    )
    return judged or _only(verdict, solution)


def _response(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    from lagrange.answers.questions.response import response_in_text

    verdict = response_in_text(answer, solution)
    return judge(answer) if verdict is None else _only(verdict, solution)


def _hamiltonian(
    functions: Sequence[Fragment], rest: Sequence[Fragment], solution: Solution, judge: Judge
) -> Judgement:
    from lagrange.answers.questions.stated_quantities import check_hamiltonian_answer

    functions = [pairs[-1].finished(latex=is_latex(f)) if (pairs := in_pairs(f)) else f for f in functions]
    verdicts = tuple(check_hamiltonian_answer(f, solution) for f in functions)
    alone = Judgement(AnswerVerdict(Verdict.EQUIVALENT), verdicts[-1:], problem=solution.problem)
    if not rest:
        return alone
    try:
        others = judge(rest)
    except ProblemError:
        return alone
    if others.verdict in (Verdict.EQUIVALENT, Verdict.WRONG):
        return replace(others, others=(*others.others, *verdicts[-1:]))
    return alone


def _steady(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    """The verdict on equations without accelerations as conditions of steady motion, where they are no others."""
    from lagrange.answers.equilibria import alternatives_of, check_steady_answers
    from lagrange.answers.readings import GivenEquation
    from lagrange.answers.written.working import understood
    from lagrange.core.symbols import base, prime

    reference = reference_of_solution(solution)
    cyclic = next((v.steady.cyclic for v in solution.views if v.steady is not None), ())
    if all(is_kept(f) for f in answer):  # m r^2 phi' = const is an integral of every motion
        return judge(answer)
    whole = answer
    answer = [definition_of_kept(f) or f for f in answer]  # of p in p = m r^2 phi' = const
    answer = [period_as_rate(f, cyclic, reference) for f in answer if not is_kept(f)]
    answer = [f for f in answer if not says_steady(f, cyclic, reference)] or answer
    working = understood(answer, with_rate_as_omega(reference, cyclic), moving=False)
    used = {
        s for f in working.judged if isinstance(f, GivenEquation) for e in f.reading.components for s in e.free_symbols
    }
    if not working.judged or any(base(s) != s and prime(base(s)) != s for s in used):
        return judge(whole)
    conditions = [v.steady.general for v in solution.views if v.steady is not None]
    try:
        verdict = check_steady_answers(alternatives_of(working.judged), conditions, reference)
    except ProblemError:
        return judge(whole)
    if verdict.verdict in (Verdict.UNREADABLE, Verdict.TRIVIAL):
        return judge(whole)
    if verdict.verdict is Verdict.WRONG:
        first = judge(whole)
        if first.verdict is not Verdict.WRONG:
            return first
        from lagrange.answers.questions.own_answers import explained_steady

        verdict = explained_steady(verdict, alternatives_of(working.judged), conditions, solution)
    return _only(replace(verdict, name="steady", notes=(*working.notes, *verdict.notes)), solution)


def _with_frequencies(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    """The verdict on equations of motion together with frequencies."""
    from lagrange.answers.questions.frequencies import check_frequencies
    from lagrange.answers.written.working import understood

    reference = reference_of_solution(solution)
    answer = [e for f in answer for e in _sides_of_label(f, reference)]
    stated = [f for f in stated_frequencies(answer) if not _is_energy(f, reference)]
    if stated:
        frequencies = check_frequencies([stated], solution)
        if frequencies.verdict not in (Verdict.EQUIVALENT, Verdict.INCOMPLETE) and len(stated) > 1:
            by_place = check_frequencies([[f] for f in stated], solution)  # one for each equilibrium
            frequencies = by_place if by_place.verdict is Verdict.EQUIVALENT else frequencies
        rest = [f for f in answer if f not in stated and not _is_characteristic(f, reference)]
        if frequencies.verdict is Verdict.UNREADABLE and rest:
            working = understood(rest, reference)
            tried = check_frequencies([stated], solution, working.defined)
            if working.defined and tried.verdict is not Verdict.UNREADABLE:
                frequencies, rest = replace(tried, notes=working.notes), list(working.judged)
        if frequencies.verdict in (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED) and rest:
            frequencies = at_stated_positions(answer, stated, frequencies, solution)
        if frequencies.verdict is Verdict.WRONG:  # omega, and the period, may be those of a steady motion itself
            others = _if_readable(answer, judge)
            if others is not None and others.verdict is Verdict.EQUIVALENT and not _leaves_out(stated, others):
                return others
        undeclared = not any(name_of_frequency(f) in reference.declared for f in stated)
        if frequencies.verdict in _JUDGED or (frequencies.verdict is Verdict.UNDECIDED and rest and undeclared):
            judged = _beside_frequencies(rest, solution, judge) if rest else None
            if judged is not None and frequencies.verdict is Verdict.EQUIVALENT and _is_unread(judged):
                named = tuple(d.as_note() for d in judged.messages)  # a line that cannot be read does not sink the rest
                return _only(replace(frequencies, notes=(*frequencies.notes, *named)), solution)
            if judged is not None and frequencies.verdict is Verdict.EQUIVALENT:
                judged = _with_places_as_labels(judged, rest, stated, solution)
            return replace(judged, others=(*judged.others, frequencies)) if judged else _only(frequencies, solution)
        if frequencies.verdict is Verdict.UNDECIDED and not rest:
            others = _if_readable(answer, judge)
            return (
                others if others is not None and _is_about(others, stated, reference) else _only(frequencies, solution)
            )
    return _with_positions(answer, solution, judge)


def _with_places_as_labels(
    judged: Judgement, rest: Sequence[Fragment], stated: Sequence[Fragment], solution: Solution
) -> Judgement:
    """The verdict where right positions, each on one line with a frequency, only say where that is one.

    They are no list of equilibria then, and none is missing if each place with frequencies of its own has them.
    """
    from lagrange.answers.questions.linear_equations import number_of_oscillating_places

    lines = {_line_of(f) for f in stated}
    labels = {f.text.strip() for f in rest if _line_of(f) in lines}
    needed = number_of_oscillating_places(solution) if labels else None
    if needed is None or len(labels) < needed:
        return judged
    others = [
        replace(a, verdict=Verdict.EQUIVALENT, missing=0)
        if (a.name, a.verdict) == ("equilibrium", Verdict.INCOMPLETE)
        and {e.text.strip() for e in a.equations} <= labels
        else a
        for a in judged.others
    ]
    return replace(judged, others=tuple(others))


def _line_of(fragment: Fragment) -> int:
    """The number of the line of the source on which a fragment begins."""
    span = fragment.span(0, len(fragment.text))
    return span.source.text.count("\n", 0, span.start)


def _is_about(judged: Judgement, stated: Sequence[Fragment], reference: Reference) -> bool:
    """Whether lines that look like frequencies are about something else: right as such, or in names of the problem."""
    if judged.verdict is Verdict.EQUIVALENT:
        return True
    if all(e.kind is Recognised.OF_PARAMETERS for e in judged.each):
        return False
    return all(name_of_frequency(f) in reference.declared for f in stated)


def _linearized(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    """The verdict on equations of small oscillations, where the answer is not right as anything else."""
    from lagrange.answers.questions.linear_equations import check_linearized

    failed: ProblemError | None = None
    try:
        judged = judge(answer)
        if judged.verdict not in (Verdict.WRONG, Verdict.UNREADABLE):
            return judged
    except ProblemError as error:
        judged, failed = None, error
    if (linear := check_linearized(answer, solution)) is not None:
        return _only(linear, solution)
    if judged is None:
        assert failed is not None
        raise failed
    return judged


def _if_readable(answer: Sequence[Fragment], judge: Judge) -> Judgement | None:
    """The verdict on an answer as on equations of motion; None if it cannot be read as such."""
    try:
        judged = judge(answer)
    except ProblemError:
        return None
    return judged if judged.verdict in (Verdict.EQUIVALENT, Verdict.WRONG) else None


def _is_characteristic(fragment: Fragment, reference: Reference) -> bool:
    """Whether an equation between parameters and ω is the one from which the frequencies follow."""
    if not is_characteristic(fragment):
        return False
    reading = read_as_written(fragment, reference.scope)
    used = {s for e in reading.components for s in e.free_symbols}
    return reading.error is None and used <= {*reference.parameters.values(), reference.scope.scalar("omega")}


def _is_unread(judged: Judgement) -> bool:
    """Whether no part of the text could be read."""
    return bool(judged.each) and all(e.verdict is Verdict.UNREADABLE for e in judged.each)


def _is_energy(fragment: Fragment, reference: Reference) -> bool:
    """Whether `T = ...` is a kinetic energy, quadratic in the velocities, and no period."""
    if not _MAY_BE_ENERGY.match(fragment.text):
        return False
    side, scope = cut(fragment, fragment.text.index("=") + 1, len(fragment.text)), reference.scope
    try:
        value = tried(side, scope, lambda f: read_value(f, scope, [], latex=True))
    except ProblemError:
        return False
    return isinstance(value, sp.Expr) and any(sp.diff(value, v, v) != 0 for v in scope.slots.velocities)


def _leaves_out(lines: Sequence[Fragment], judged: Judgement) -> bool:
    """Whether some lines are not judged because they cannot be read as equations."""
    unread = {e.text for e in judged.each if e.verdict is Verdict.UNREADABLE}
    return any(f.text.strip() in unread for f in lines)


def _sides_of_label(fragment: Fragment, reference: Reference) -> list[Fragment]:
    """`omega = sqrt(g/l) = 4.43 rad/s` as two statements; what defines it may have several sides, too."""
    from lagrange.answers.questions.texts.frequency_labels import listed_frequencies

    alone = stated_frequencies([fragment]) and len(listed_frequencies(fragment)) == 1
    pairs = in_pairs(fragment) if alone else []
    made = [p.finished(latex=is_latex(fragment)) for p in pairs] or [fragment]
    return made[:1] if sides_agree(fragment, reference) else made


def _beside_frequencies(rest: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement | None:
    """The verdict on what accompanies frequencies; None for linearized equations that are right, which are working."""
    from lagrange.answers.questions.linear_equations import check_linearized
    from lagrange.answers.written.working import understood

    working = understood(rest, reference_of_solution(solution))
    if working.judged and len(working.approximate) == len(working.judged):
        return _linear_beside(working, solution)
    if working.judged and 0 in working.approximate and not working.unreadable:
        linear = check_linearized(rest, solution)
        if linear is not None and linear.verdict is not Verdict.WRONG:
            return None
        if linear is not None and any(marks_approximation(f.whole.source.text) for f in rest):
            return _only(linear, solution)
    if not working.judged and not working.unreadable:
        return None
    judged = _with_positions(rest, solution, judge)
    if judged.verdict is Verdict.WRONG:  # linear equations without a word may be those of the frequencies
        linear = check_linearized(rest, solution, are_marked=True)
        if linear is not None and linear.verdict in (Verdict.EQUIVALENT, Verdict.INCOMPLETE):
            return _only(replace(linear, verdict=Verdict.EQUIVALENT, missing=0), solution)
    return judged


def _linear_beside(working: Working, solution: Solution) -> Judgement | None:
    """The verdict on linearized equations beside their frequencies; None where they are working that cannot be judged.

    Lines that cannot be read are named, and do not sink them.
    """
    from lagrange.answers.questions.linear_equations import check_linearized

    linear = check_linearized(working.judged, solution)
    errors = (d for f in working.unreadable if f.reading.error for d in f.reading.error.diagnostics)
    notes = tuple(d.as_note() for d in errors)
    if linear is None or linear.verdict not in (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.WRONG):
        return None if not notes else _only(AnswerVerdict(Verdict.EQUIVALENT, notes=notes), solution)
    whole = Verdict.EQUIVALENT if linear.verdict is Verdict.INCOMPLETE else linear.verdict
    return _only(replace(linear, verdict=whole, notes=(*linear.notes, *notes)), solution)


def _with_positions(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    """The verdict on equations of motion together with positions of equilibrium."""
    failed: ProblemError | None = None
    first: Judgement | None = None
    try:
        first = judge(answer)
        if first.verdict is Verdict.EQUIVALENT:
            return first
    except ProblemError as error:
        failed = error
    positions = positions_of(answer, solution)
    if positions is None:
        if first is None:
            assert failed is not None
            raise failed
        return first
    verdict, rest = positions
    if not rest:
        restated = first is not None and first.verdict is not Verdict.WRONG and verdict.verdict is Verdict.WRONG
        return first if first is not None and restated else _only(verdict, solution)
    judged = judge(rest)
    return replace(judged, others=(*judged.others, verdict))


def _asked(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    """The verdict on values in numbers, each with its unit, and on everything else."""
    answer = [part for f in answer for part in each_alternative(f)]
    answer = [without_integrals(f) for f in answer]
    answer = [without_place(f, [p.symbol.name for p in solution.problem.parameters]) for f in answer]
    valued = values_of(solution.problem) is not None
    numbered = [(f, stated_in_numbers(f) if valued else None) for f in answer]
    if any(n for _, n in numbered):  # beside these a number alone is one whose unit was omitted
        numbered = [(f, n or ((f, None) if _NUMBER_ALONE.search(f.text) else None)) for f, n in numbered]
    numbers = [n[0] for _, n in numbered if n]
    lines = asked_in_text(numbers, solution) if numbers else None
    if lines is None or lines.verdict is None:
        return _asked_in_formulas(answer, solution, judge)
    unasked = (
        Diagnostic("not-judged", f"`{f.text.strip()}` is not asked for, and is not judged", f.whole).as_note()
        for f in lines.rest
    )
    verdict = replace(lines.verdict, notes=(*lines.verdict.notes, *unasked))
    reference = reference_of_solution(solution)
    chains = [(f, sides_agree(f, reference)) for f, n in numbered if n is not None and n[1] is not None]
    wrong = [EquationVerdict(f.text.strip(), Verdict.WRONG, NOT_EQUAL) for f, agree in chains if agree is False]
    if wrong:
        verdict = replace(verdict, verdict=Verdict.WRONG, equations=(*verdict.equations, *wrong))
    consistent = [f for f, agree in chains if agree is not None]
    try:
        formulas = [f if n is None else _first_of(n[1]) if f in consistent else n[1] for f, n in numbered]
        others = _asked_in_formulas([f for f in formulas if f is not None], solution, judge)
    except ProblemError:
        return _only(_if_complete(verdict, lines.missing), solution)
    if others.verdict is Verdict.INCOMPLETE and not lines.missing:  # what it omits is answered in numbers
        return _only(verdict, solution)
    return replace(others, others=(*others.others, verdict))


def _first_of(chain: Fragment | None) -> Fragment | None:
    """`v = sqrt(2 a d)` of `v = sqrt(2 a d) = sqrt(24)`."""
    pairs = in_pairs(chain) if chain is not None else []
    return pairs[0].finished(latex=is_latex(pairs[0].outer)) if pairs else chain


def _if_complete(verdict: AnswerVerdict, missing: Sequence[str]) -> AnswerVerdict:
    if verdict.verdict is not Verdict.EQUIVALENT or not missing:
        return verdict
    why = f"there is no answer to {', '.join(f'`{name}`' for name in missing)}"
    return replace(verdict, verdict=Verdict.INCOMPLETE, diagnosis=why)


def _asked_in_formulas(answer: Sequence[Fragment], solution: Solution, judge: Judge) -> Judgement:
    failed: ProblemError | None = None
    first: Judgement | None = None
    parts = [
        c
        for f in answer
        for c in (map(condition_alone, conditions_of(condition_alone(f))) if is_inequality(f) else [f])
    ]
    limits = [limit_of(f, "a condition", strict=True)[0] for f in parts if is_inequality(f)]
    answer = [f for f in parts if not is_inequality(f)]
    try:
        first = judge(answer) if answer else None
    except ProblemError as error:
        failed = error
    answer = [*answer, *limits]
    if first is not None and first.verdict is Verdict.EQUIVALENT and not _has_wrong_value(answer, first, solution):
        return first
    judged = _with_asked(answer, solution, judge, first)
    if judged is None:
        where = answer[0].whole if answer else None
        raise failed or ProblemError(Diagnostic("no-answer", "there is no equation to check", where))
    return judged


def _has_wrong_value(answer: Sequence[Fragment], judged: Judgement, solution: Solution) -> bool:
    """Whether a line that accompanies correct frequencies, or answers a question after `it leaves when`, is wrong."""
    for f in answer:
        found = (
            asked_in_text(answer, solution, among=[f]).verdict
            if (names := questions_of_condition(f, solution))
            else None
        )
        if found is not None and any(e.verdict is Verdict.WRONG and e.part in names for e in found.equations):
            return True
    if not any(a.name == "frequencies" for a in judged.others):
        return False
    lines = asked_in_text(answer, solution)
    return lines.verdict is not None and lines.verdict.verdict is Verdict.WRONG


def _with_asked(
    answer: Sequence[Fragment], solution: Solution, judge: Judge, first: Judgement | None
) -> Judgement | None:
    """The verdict on the lines that answer questions and on the others; `first` if there are none of the former."""
    lines = asked_in_text(answer, solution)
    from lagrange.answers.questions import values_in_text
    from lagrange.answers.questions.texts.frequency_labels import stated_frequencies
    from lagrange.answers.written.working import understood

    if lines.verdict is None:
        unread = first is None or first.verdict is Verdict.UNREADABLE
        foreign = values_in_text.under_another_name(answer, solution) if unread else None
        return _only(foreign, solution) if foreign is not None else first
    verdict = lines.verdict
    others: Judgement | None = None
    reference = reference_of_solution(solution)
    asks_for_frequencies = any(v.linearization is not None for v in solution.views)
    frequencies = stated_frequencies(lines.rest) if asks_for_frequencies else []
    beside = [f for f in values_in_text.working_beside(lines.rest, answer, reference) if f not in frequencies]
    rest = [f for f in lines.rest if f not in beside]
    working = understood(rest, reference) if rest else None
    is_judged = working is None or bool(working.unreadable or frequencies)
    if working is not None and not is_judged and values_in_text.only_beside(working, reference):
        beside, working = [*beside, *working.judged], None
    verdict = replace(
        verdict, notes=(*verdict.notes, *values_in_text.not_judged(beside, "is working, and is not judged"))
    )
    if frequencies or (working is not None and (working.judged or working.unreadable)):
        try:
            others = judge(rest)
        except ProblemError:
            others = None
    if others is not None and others.verdict in (Verdict.EQUIVALENT, Verdict.WRONG):
        return replace(others, others=(*others.others, verdict))
    if verdict.verdict is Verdict.EQUIVALENT and lines.missing:
        unread = others is not None and others.verdict is Verdict.UNREADABLE
        why = f"there is no answer to {', '.join(f'`{name}`' for name in lines.missing)}"
        verdict = replace(verdict, verdict=Verdict.UNREADABLE if unread else Verdict.INCOMPLETE, diagnosis=why)
    messages = others.messages if others is not None else ()
    return _only(replace(verdict, notes=(*verdict.notes, *(d.as_note() for d in messages))), solution)
