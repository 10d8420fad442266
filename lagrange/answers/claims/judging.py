"""An answer with its claims: what a text says in words and conditions beside its equations.

Right equations with a false claim beside them are no right answer. A claim that can be refuted makes the answer wrong,
one that is right is said to be; of one that cannot be judged a note says so.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.answers.claims.conditions import on_conditions
from lagrange.answers.claims.frequencies import on_frequencies
from lagrange.answers.claims.relations import on_relations
from lagrange.answers.claims.sentences import Sentence, sentences
from lagrange.answers.claims.stability import on_stability
from lagrange.answers.limits import LONGEST_IN_WORDS
from lagrange.answers.questions.own_answers import on_freedom_and_class
from lagrange.answers.questions.stability_in_text import WORD
from lagrange.answers.questions.stated_constraints import counts_of_freedom
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Judgement, Verdict
from lagrange.answers.written.working import understood
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Source, Span
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Answers

NAME = "claims"
_MAYBE = re.compile(
    r"[<>≤≥]|\\[gl](?:t|eq?|eqslant)(?![A-Za-z])|stab|labil|freedom|\bdof\b|freiheitsgrad|libert|\b(?:if|when|wenn|falls|si)\b"
    r"|oscillat|frequen|period|schwing|eigen",
    re.IGNORECASE,
)
_FREEDOM = "degrees_of_freedom"
_SETTLED = (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


def with_claims(answer: Sequence[Fragment], judged: Judgement, solution: Solution) -> Judgement:
    """The verdict on an answer, with that on its claims."""
    if judged.verdict not in _SETTLED or any(a.name == NAME for a in judged.others) or not answer:
        return judged
    texts = dict.fromkeys((s.name, s.original or s.text) for s in (f.whole.source for f in answer))
    sources = [s for s in (Source(*t) for t in texts) if _MAYBE.search(s.text)]
    if not sources:
        return judged
    reference = reference_of_solution(solution)
    found, notes = _claims(answer, sources, judged, solution, reference)
    others = [*judged.others, *_on_freedom(sources, judged, solution)]
    if found:
        wrong = any(e.verdict is Verdict.WRONG for e in found)
        others.append(AnswerVerdict(Verdict.WRONG if wrong else Verdict.EQUIVALENT, tuple(found), name=NAME))
    claimed = [_bare(e.text) for e in found]

    def is_claimed(d: Diagnostic) -> bool:
        return d.span is not None and any(_bare(d.span.source.text[d.span.start : d.span.end]) in c for c in claimed)

    def is_claimed_note(n: Diagnostic) -> bool:
        return n.code == "not-judged" and (is_claimed(n) or (counted and bool(counts_of_freedom(n.message))))

    counted = any(a.name == _FREEDOM for a in others)
    motion = judged.equations
    equations = replace(
        motion,
        notes=(*(n for n in motion.notes if not is_claimed_note(n)), *notes),
        unreadable=tuple(d for d in motion.unreadable if not is_claimed(d)),
        equations=tuple(
            e
            for e in motion.equations
            if e.verdict is not Verdict.UNREADABLE or not any(_bare(e.text) in c for c in claimed)
        ),
    )
    return replace(judged, equations=equations, others=tuple(others))


def _claims(
    answer: Sequence[Fragment], sources: Sequence[Source], judged: Judgement, solution: Solution, reference: Reference
) -> tuple[list[EquationVerdict], list[Diagnostic]]:
    """The verdicts on the claims of several texts, and notes on those that are not judged."""
    every = sentences(sources, reference.scope)
    settled = [_bare(e.text) for a in (judged.equations, *judged.others) for e in a.equations]
    rests = any(v.at_rest is not None for v in solution.views)
    found: list[EquationVerdict] = []
    notes: list[Diagnostic] = []
    defined: Mapping[str, sp.Expr] | None = None
    for n, sentence in enumerate(every):
        is_claim = bool(WORD.search(sentence.text)) or bool(sentence.inequalities)
        if is_claim and not _is_settled(sentence, settled):
            each = (
                on_stability(sentence, solution, reference),
                on_conditions(sentence, every[:n], solution, reference),
            )
            verdicts = [v for v in each if v is not None]
            found += [v for v in verdicts if v.verdict is Verdict.WRONG][:1] or verdicts[:1]
            is_of_rest = rests and not WORD.search(sentence.text)  # the verdict on rest is on all its conditions
            if not verdicts and not is_of_rest and _says_something(sentence, reference):
                notes.append(_note(sentence, sources))
        if len(sentence.equations) > 1:
            defined = _defined(answer, reference) if defined is None else defined
            relation = on_relations(sentence, defined, reference)
            found += [relation] if relation is not None else []
    asks_for_frequencies = any(v.linearization is not None or v.steady is not None for v in solution.views)
    if not asks_for_frequencies:
        found += [v for _, v in on_frequencies(answer, solution, reference) if _bare(v.text) not in settled]
    return found, notes


def _defined(answer: Sequence[Fragment], reference: Reference) -> Mapping[str, sp.Expr]:
    """The names that an answer defines."""
    try:
        return understood(answer, reference).defined
    except ProblemError:
        return {}


def _bare(text: str) -> str:
    return "".join(text.split()).strip(".,;$")


def _is_settled(sentence: Sentence, settled: Sequence[str]) -> bool:
    """Whether a claim is among what is judged already."""
    own = _bare(sentence.shown)
    if WORD.search(sentence.text):
        return any(own in s or (WORD.search(s) and s in own) for s in settled)
    inequalities = [_bare(r.text) for r in sentence.inequalities]
    return any(own in s for s in settled) or all(any(r in s or (s and s in r) for s in settled) for r in inequalities)


def _says_something(sentence: Sentence, reference: Reference) -> bool:
    """Whether it has a verb and a noun at least, and not only the sense of the motion: `m > 0`, `it falls (y' > 0)`."""
    rates = {*reference.scope.slots.velocities}
    stated = [r.positive(reference.scope) for r in sentence.inequalities]
    if stated and all(e is not None and (e in rates or -e in rates) for e in stated):
        return False
    return len(re.findall(r"[^\W\d_]{3,}", sentence.words)) >= 2


def _note(sentence: Sentence, sources: Sequence[Source]) -> Diagnostic:
    start = sentence.text.strip()[:20].split("\n")[0].strip()
    source = next((s for s in sources if start in s.text), sources[0])
    at = max(source.text.find(start), 0)
    end = min(at + len(sentence.text), len(source.text))
    return Diagnostic("not-judged", f"`{sentence.shown}` is not judged", Span(source, at, end)).as_note()


def _on_freedom(sources: Sequence[Source], judged: Judgement, solution: Solution) -> Iterator[AnswerVerdict]:
    """The verdict on the number of degrees of freedom that a text states."""
    if any(a.name == _FREEDOM for a in judged.others):
        return
    counts = [c for s in sources for c in counts_of_freedom(s.text[:LONGEST_IN_WORDS])]
    if not counts:
        return
    right = solution.classification.degrees_of_freedom
    stated = right if right in (n for _, n in counts) else max(counts)[1]
    if stated is not None:
        yield from on_freedom_and_class(solution, Answers(degrees_of_freedom=stated))
