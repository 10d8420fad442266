r"""Values without a sign of equality: the name of a question before a colon, or an expression alone.

    range: v^2*sin(2*alpha)/g          range = v^2*sin(2*alpha)/g
    0, \sqrt{c/m}                      the frequencies, where small oscillations are asked for
    F/sqrt((c - m*w^2)^2 + b^2*w^2)    the amplitude of the only coordinate, where a response is asked for

An expression alone answers the only thing that the problem asks for beside its equations of motion.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import replace

from lagrange.answers.limits import LONGEST_RUN_OF_LETTERS
from lagrange.answers.written.lines import has_sign_of_equality
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, cut, cuts
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.relations import is_inequality
from lagrange.expressions.syntax_tree import FUNCTIONS
from lagrange.mechanics.results import Solution

_NAMED = re.compile(
    r"^[ \t]*(?:[-*][ \t]+)?(?P<name>[^\W\d]\w{0,40})[ \t]*(?P<colon>:)(?=[ \t]+\S)(?P<rest>[^\n]*)$", re.MULTILINE
)
_BETWEEN = re.compile(r"[,;]|\b(?:and|or)\b|\\(?:text|mathrm|mbox)\{\s*(?:and|or)?\s*\}|\\q?quad(?![A-Za-z])|\n")
_COMMAND = re.compile(r"\\(?:text|mathrm|mbox)\{[^{}]*\}|\\[A-Za-z]+")
_WORD = re.compile(r"[^\W\d_]{2,}")
_SMALL_WORDS = "is are be the it we an to of in at on by for if no so"
_OF_SENTENCES = frozenset(_SMALL_WORDS.split())
_KNOWN = frozenset({*FUNCTIONS, *GREEK.values(), "arcsin", "arccos", "arctan", "and", "or"})


def with_sign_after_names(text: str, names: Collection[str]) -> str:
    """`height: v^2/(2*g)` with `=` for the colon, for each name of a question; every place stays where it is."""
    places = [
        m.start("colon")
        for m in _NAMED.finditer(text)
        if m["name"] in names and not has_sign_of_equality(m["rest"]) and not is_inequality(Fragment.of(m["rest"]))
    ]
    for place in places:
        text = f"{text[:place]}={text[place + 1 :]}"
    return text


def is_expressions(text: str) -> bool:
    """Whether a text without equations may be expressions, and no sentence."""
    words = [w.lower() for w in _WORD.findall(_COMMAND.sub(" ", text))]
    prose = [w for w in words if w not in _KNOWN and (len(w) > LONGEST_RUN_OF_LETTERS or w in _OF_SENTENCES)]
    return bool(text.strip()) and not prose and ":" not in text and not is_inequality(Fragment.of(text))


def as_asked(answer: Sequence[Fragment], solution: Solution) -> tuple[Fragment, ...] | None:
    """Expressions as equations for what the problem asks for; None if that is not clear."""
    names_of_questions = {a.question.name for a in solution.asked}
    named = [with_sign_after_names(f.text, names_of_questions) for f in answer]
    if any(text != f.text for text, f in zip(named, answer, strict=True)):
        return tuple(replace(f, text=text) for text, f in zip(named, answer, strict=True))
    if not all(is_expressions(f.text) for f in answer):
        return None
    pieces = [cut(f, *p) for f in answer for p in cuts(f.text, _BETWEEN) if f.text[slice(*p)].strip(" $.\n")]
    names = _names(solution, pieces)
    if names is None or len(names) != len(pieces):
        return None
    return tuple(_equation(name, f) for name, f in zip(names, pieces, strict=True))


def _names(solution: Solution, pieces: Sequence[Fragment]) -> list[str] | None:
    """What each expression is the value of."""
    views = solution.views
    responses = [v.response for v in views if v.response is not None]
    if any(v.hamiltonian is not None for v in views):
        return ["H"] if all("p_" in f.text for f in pieces) else None
    if responses:
        return [q.name for q in responses[0].by_coordinate]
    if any(v.linearization is not None for v in views):
        return None if solution.asked else [f"omega_{n}" for n, _ in enumerate(pieces, 1)]
    return [solution.asked[0].question.name] if len(solution.asked) == 1 else None


def _equation(name: str, fragment: Fragment) -> Fragment:
    letter, _, index = name.partition("_")
    latex = is_latex(fragment)
    draft = Draft(fragment)
    if latex and letter in GREEK.values():
        name = f"\\{letter}_{{{index}}}" if index else f"\\{letter}"
    draft.apply([(0, 0, f"{name} = ")])
    return draft.finished(latex=latex)
