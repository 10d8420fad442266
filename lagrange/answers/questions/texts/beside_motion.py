"""Results beside complete equations of motion: what else the problem asks for, where a text states it.

    l θ'' = -g sin θ,  T_max = 2 m g        θ'' = (Ω² cos θ - g/R) sin θ,  equilibrium: cos θ = g/(Ω R)

Where the equations are complete, lines without accelerations are definitions, values or energies, which are not
judged. Some of them are answers to other questions: values asked for, frequencies, positions of equilibrium, conditions
of steady motion, amplitudes. These are judged, and a wrong one makes the answer wrong. What an equation with an
acceleration contains, ω_0 in θ'' = -ω_0² sin θ, is a definition and no answer.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.claims.conditions import is_no_result
from lagrange.answers.limits import LETTERS_OF_STEM
from lagrange.answers.questions.frequencies import check_frequencies, frequencies_in
from lagrange.answers.questions.named_values import label_of, written_label
from lagrange.answers.questions.stability_in_text import WORD as STABLE
from lagrange.answers.questions.stability_in_text import check_stability_beside
from lagrange.answers.questions.texts.frequency_labels import ACCELERATION, stated_frequencies
from lagrange.answers.readings import GivenEquation
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, Judgement, Verdict
from lagrange.answers.written.lines import condition_alone, conditions_of
from lagrange.answers.written.names import has_word, lines_with, spelled_out
from lagrange.answers.written.values import with_all_values
from lagrange.answers.written.working import understood
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity, Span
from lagrange.core.symbols import base
from lagrange.expressions.reader import is_inequality, limit_of
from lagrange.mechanics.results import Solution

_SETTLED = (Verdict.EQUIVALENT, Verdict.WRONG)
_AT_REST = re.compile(r"equilibri|gleichgewicht|ruhelage|équilibre|rest position|positions? of rest", re.IGNORECASE)
_STEADY = re.compile(r"steady|circular|circle|kreis|station[aä]r|gleichförmig|relative equilibri", re.IGNORECASE)
_OSCILLATION = re.compile(r"frequen|period|schwing|oscillat|eigen|mode", re.IGNORECASE)
_PLACE = re.compile(
    r"(?:\b(?:for|at|when|if|from|with|of|about|around|near|für|bei|wenn|um|à|pour|start\w*|initially)\s+|\()[\s$]*\Z",
    re.IGNORECASE,
)
"""What stands before a place at which something else is stated: `at θ = 0`."""
_NO_RESULT = re.compile(r"=\s*[-+−]?\s*(?:0|(?:2\s*\*?\s*)?(?:pi|π|\\pi)(?:\s*/\s*[24])?)[\s.,;$)]*\Z")
"""A simple place, `θ = 0`, which is seldom what is asked for."""


def with_results_beside(answer: Sequence[Fragment], judged: Judgement, solution: Solution) -> Judgement:
    """The verdict on complete equations of motion, with that on other results that are asked for and stated."""
    if judged.verdict is not Verdict.EQUIVALENT:
        return judged
    spans = [d.span for d in judged.messages if d.span and (d.code == "not-judged" or d.level is Severity.ERROR)]
    lines = [f for f in answer if is_inequality(f) or any(_overlap(f.span(0, len(f.text)), s) for s in spans)]
    parameters = {p.symbol for p in solution.problem.parameters}
    if any(a.question.quantity in parameters for a in solution.asked):
        lines += [f for f in _conditions_beside(answer) if not is_no_result(f.text, solution)]
    found = [v for v in _verdicts(lines, answer, solution) if v.verdict in _SETTLED] if lines else []
    if not found:
        return judged
    taken = {e.text for v in found for e in v.equations}
    settled = [f.span(0, len(f.text)) for f in lines if " ".join(f.text.split()) in taken]

    def is_judged(note: Diagnostic) -> bool:
        return note.code == "not-judged" and note.span is not None and any(_overlap(note.span, s) for s in settled)

    motion = judged.equations
    notes = tuple(n for n in motion.notes if not is_judged(n))
    unread = tuple(d for d in motion.unreadable if d.span is None or not any(_overlap(d.span, s) for s in settled))
    read = tuple(e for e in motion.equations if e.verdict is not Verdict.UNREADABLE or e.text not in taken)
    return replace(
        judged,
        equations=replace(motion, notes=notes, unreadable=unread, equations=read),
        others=(*judged.others, *found),
    )


def _conditions_beside(answer: Sequence[Fragment]) -> Iterator[Fragment]:
    """The inequalities of a text that are in none of its equations: `x'' = ...; mu >= tan(alpha)/3`."""
    taken = [f.span(0, len(f.text)) for f in answer]
    for source in dict.fromkeys(f.whole.source for f in answer):
        for piece in re.finditer(r"[^\s;][^;\n]*", source.text):
            span = Span(source, *piece.span())
            stated = Fragment(piece[0].rstrip(), span, piece.start())
            if is_inequality(stated) and not any(_overlap(span, t) for t in taken):
                yield stated


def _overlap(a: Span, b: Span) -> bool:
    return a.source is b.source and a.start < b.end and b.start < a.end


def _verdicts(lines: Sequence[Fragment], answer: Sequence[Fragment], solution: Solution) -> Iterator[AnswerVerdict]:
    """The verdicts on what some lines of an answer state."""
    reference = reference_of_solution(solution)
    if any(a.answered for a in solution.asked):
        from lagrange.answers.questions.values_in_text import asked_in_text

        results = [f for f in lines if not _is_place(f) or questions_of_condition(f, solution)]
        stated = [e for f in results if not _is_needed(f, answer, reference) for e in _limits(f)]
        verdict = asked_in_text(answer, solution, among=stated).verdict
        if verdict is not None:
            yield verdict
    if any(v.linearization is not None for v in solution.views):
        frequencies = [f for f in stated_frequencies(answer) if f in lines and _is_frequency(f, reference)]
        if frequencies:
            yield _of_frequencies(frequencies, solution)
        positions = [f for f in lines if _AT_REST.search(_line(f))]
        if positions:
            from lagrange.answers.questions.equilibrium_in_text import positions_of

            found = positions_of(with_all_values(positions, reference.scope.names()), solution)
            if found is not None:
                yield found[0]
        claims = [f for f in lines if STABLE.search(getattr(f, "beside", ""))]
        if claims:
            working = understood(claims, reference, moving=False)
            stability = check_stability_beside(working.judged, solution, reference)
            if stability is not None:
                yield stability
    if any(v.steady is not None for v in solution.views):
        yield from _of_steady_motion(lines, solution)
    if any(v.response is not None for v in solution.views):
        from lagrange.answers.questions.response import response_in_text

        response = response_in_text(lines, solution)
        if response is not None:
            yield response


def _is_needed(fragment: Fragment, answer: Sequence[Fragment], reference: Reference) -> bool:
    """Whether an equation with an acceleration contains a name that a line defines."""
    label = written_label(fragment)
    if not label or label_of(fragment) in reference.declared:
        return False
    return any(ACCELERATION.search(f.text) and has_word(label, f.text) for f in answer)


def _limits(fragment: Fragment) -> Iterator[Fragment]:
    """The limits that an inequality states, as equations; an equation is returned as it is."""
    if not is_inequality(fragment):
        yield fragment
        return
    for condition in conditions_of(condition_alone(fragment)):
        try:
            yield limit_of(condition_alone(condition), "a condition", strict=True)[0]
        except ProblemError:
            continue


def _of_frequencies(stated: Sequence[Fragment], solution: Solution) -> AnswerVerdict:
    """The verdict on frequencies of one equilibrium, or of one each."""
    verdict = check_frequencies([stated], solution)
    if verdict.verdict is Verdict.WRONG and len(stated) > 1:
        each = check_frequencies([[f] for f in stated], solution)
        return each if each.verdict is Verdict.EQUIVALENT else verdict
    return replace(verdict, verdict=Verdict.EQUIVALENT) if verdict.verdict is Verdict.INCOMPLETE else verdict


def _is_frequency(fragment: Fragment, reference: Reference) -> bool:
    """Whether a line gives frequencies in terms of parameters; a line `T = ...` only if it says that it is a period."""
    if not re.match(r"\s*\$?\s*\\?(?:omega|ω)", fragment.text) and not _OSCILLATION.search(_line(fragment)):
        return False
    try:
        values = frequencies_in(fragment, reference)
    except ProblemError:
        return False
    return all(v.free_symbols <= {*reference.parameters.values()} for v in values)


def _of_steady_motion(lines: Sequence[Fragment], solution: Solution) -> Iterator[AnswerVerdict]:
    """The verdicts on conditions of steady motion."""
    from lagrange.answers.equilibria import alternatives_of, check_steady_answers
    from lagrange.answers.questions.equilibrium_in_text import is_kept, says_steady, with_rate_as_omega

    families = [v.steady for v in solution.views if v.steady is not None]
    reference = reference_of_solution(solution)
    cyclic = next((s.cyclic for s in families), ())
    wider = with_rate_as_omega(reference, cyclic)
    for f in lines:
        if not _STEADY.search(_line(f)) or is_kept(f) or says_steady(f, cyclic, reference):
            continue
        working = understood([f], wider, moving=False)
        if any(g.reading.components == (sp.S.Zero,) for g in working.judged if isinstance(g, GivenEquation)):
            continue  # phi' = Omega, the name of the constant rate
        stated = [g for g in working.judged if not says_steady(g, cyclic, reference)]  # r' = r'' = 0
        if not stated or working.unreadable:
            continue
        try:
            verdict = check_steady_answers(alternatives_of(stated), [s.general for s in families], reference)
        except ProblemError:
            continue
        yield replace(verdict, name="steady")


def _line(fragment: Fragment) -> str:
    """The line in which a fragment ends, up to the fragment's end, with the words next to it."""
    span, text = fragment.span(0, len(fragment.text)), fragment.whole.source.text
    first = text.rfind("\n", 0, span.start) + 1
    stop = text.find("\n", span.end)
    return f"{getattr(fragment, 'beside', '')} {text[first : stop if stop >= 0 else len(text)]}"


def _is_place(fragment: Fragment) -> bool:
    """Whether an equation only says where or when something else holds."""
    before = fragment.whole.source.text[: fragment.span(0, len(fragment.text)).start]
    return bool(_PLACE.search(before[-20:]) or _NO_RESULT.search(fragment.text))


_CLAUSE = re.compile(
    r"(?:^|[.:;])\s*(?P<clause>(?:[^\W\d_]+,?\s+){2,12})(?:if|when|where|once|as soon as|for|at)\s*\$?\s*\Z", re.I
)
_INTRODUCED = re.compile(r"\S\s+(?:if|when|where|once|provided(?: that)?|as soon as|for)\s*\$?\s*\Z", re.I)


def questions_of_condition(fragment: Fragment, solution: Solution) -> set[str]:
    """The questions that an equation may answer although it stands as a condition: `it leaves when θ = a`.

    The clause before it names the question, or the question is for a parameter; `the speed is greatest when θ = π/2`
    is about something else.
    """
    span = fragment.span(0, len(fragment.text))
    line = span.source.text[: span.start].rsplit("\n", 1)[-1]
    clause = _CLAUSE.search(line)
    parameters = {p.symbol for p in solution.problem.parameters}
    if clause is None:  # `beta = alpha throughout when I_2 = ...`
        label = label_of(fragment) if _INTRODUCED.search(line) else ""
        own = (a.question for a in solution.asked if a.question.quantity in parameters)
        return {q.name for q in own if q.quantity.name == label}
    words = {
        w.lower()[:LETTERS_OF_STEM] for w in re.findall(r"[^\W\d_]+", clause["clause"]) if len(w) >= LETTERS_OF_STEM
    }
    return {
        a.question.name
        for a in solution.asked
        if a.question.quantity in parameters
        or (
            _occurs(a.question.quantity, fragment)
            and any(
                w.lower()[:LETTERS_OF_STEM] in words for w in a.question.name.split("_") if len(w) >= LETTERS_OF_STEM
            )
        )
    }


def _occurs(quantity: sp.Expr, fragment: Fragment) -> bool:
    """Whether the letter of a quantity is on the left of an equation."""
    left = spelled_out(fragment.text.partition("=")[0])
    return any(lines_with(base(s).name, [left]) or s.name in left for s in quantity.free_symbols)
