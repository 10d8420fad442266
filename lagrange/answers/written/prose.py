r"""Sentences around an equation in plain text: words that are no names of the problem.

    let x be the elongation, so r = l + x:      r = l + x
    Torque about the contact point (instantaneous centre): I_P = 3/2 m r^2
    g_eff = g - a*Omega^2*cos(Omega*t), thus    g_eff = g - a*Omega^2*cos(Omega*t)

What precedes the left side is dropped up to the last linking word or punctuation mark that has a word of prose
before it; what stands after the right side, from the first of them that is followed by prose alone. A word of prose has
four letters or more, and is no name of the problem or the answer, no function and no product of names. A single
unknown word beside an equation is not omitted: it may be a factor.

An equation after `when`, `if`, `until` and the like is a condition: it is no statement about every motion.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from lagrange.answers.limits import SHORTEST_WORD
from lagrange.answers.written.notation.plain import is_rate
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_names import LatexNames
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import FUNCTIONS, OPERATIONS

_RELATION = re.compile(r"(?<![<>!:])==?(?![=>])|[≤≥]|<=|>=|:=")
_LINKING_WORDS = """
so thus hence then therefore and or is are be that gives give gave yields yield get have has obtain find becomes as
where with which if when for from to by of the we i.e i.e. e.g since because giving yielding means implies reads equals
also finally now both namely let alors donc avec also mit und ist gilt folgt wobei damit somit using via
"""
_LINKS = frozenset(_LINKING_WORDS.split())
_WORD = re.compile(r"(?<![\w\\'])[^\W\d_]+(?:['’]s)?(?![\w(\[{'^*/])")
_JOINT = re.compile(r"[,;:.](?=\s|\Z)")
_CONDITIONS = (
    "when if until till once whenever provided unless while wenn falls sobald bis lorsque quand si iff assuming"
)
_CONDITIONAL = frozenset(_CONDITIONS.split())


def without_prose(fragment: Fragment, known: Callable[[str], bool]) -> Fragment:
    """The equation, or the inequality, without the sentences around it; the same where there are none."""
    text = fragment.text
    if "\\" in text or "$" in text:
        return fragment
    signs = [m.span() for m in _RELATION.finditer(text)]
    if not signs:
        return fragment
    begin = _after_sentence(text, signs[0][0], known)
    end = _before_sentence(text, signs[-1][1], known)
    if (begin, end) == (0, len(text)):
        return fragment
    draft = Draft(fragment)
    draft.keep(begin, end)
    return draft.finished()


def is_condition(beside: str) -> bool:
    """Whether the words before an equation make it a condition: `slack when T = 0`."""
    words = re.findall(r"[^\W\d_]+", beside)
    return bool(words) and words[-1].lower() in _CONDITIONAL and not beside.rstrip().endswith((":", ",", "."))


def words_known(scope: Scope, texts: Sequence[str]) -> Callable[[str], bool]:
    """Whether a word is a name of the problem, a product of such names, or defined by one of several equations."""
    names = LatexNames(scope)
    alone = {m[1] for text in texts if (m := re.match(r"\s*([^\W\d]\w*)\s*(?::=|==?)", text))}

    def known(word: str) -> bool:
        run = names.run(word)
        declared = not run.several and all(names.is_declared(name) for _, name in run.pieces)
        return declared or word in alone or is_rate(word, scope)

    return known


def _is_prose(word: str, known: Callable[[str], bool]) -> bool:
    plain = re.sub("['’]s$", "", word)
    lower = plain.lower()
    if len(plain) < SHORTEST_WORD or lower in FUNCTIONS or lower in OPERATIONS or lower in GREEK.values():
        return False
    return plain.isascii() is False or not known(plain)


def _joints(text: str, start: int, end: int) -> list[tuple[int, int]]:
    """Where linking words and punctuation marks begin and end."""
    joints = [m.span() for m in _JOINT.finditer(text, start, end)]
    joints += [m.span() for m in _WORD.finditer(text, start, end) if m[0].lower() in _LINKS]
    return sorted(joints)


def _after_sentence(text: str, end: int, known: Callable[[str], bool]) -> int:
    """Where the left side begins."""
    prose = [m.start() for m in _WORD.finditer(text, 0, end) if _is_prose(m[0], known)]
    if not prose:
        return 0
    cuts = [stop for start, stop in _joints(text, 0, end) if prose[0] <= start and stop > prose[-1]]
    rest = text[cuts[-1] : end].strip() if cuts else ""
    return cuts[-1] if rest and rest[0] not in "*/^)" else 0


def _before_sentence(text: str, start: int, known: Callable[[str], bool]) -> int:
    """Where the right side ends."""
    for first, _ in _joints(text, start, len(text)):
        if not text[start:first].strip() or text[first - 1] in "*/^(":
            continue
        words = [m[0] for m in _WORD.finditer(text, first)]
        rest = _WORD.sub(" ", text[first:]).strip(" ,;:.()!")
        all_links = bool(words) and all(w.lower() in _LINKS for w in words)
        if words and ((all_links and not rest) or any(_is_prose(w, known) for w in words)):
            return first
    return len(text)
