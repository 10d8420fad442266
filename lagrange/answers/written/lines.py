r"""Lines of an answer in plain text: which belong together, where equations begin and end in them.

A line continues the one before it if that one ends, or it begins, with a sign that needs something on its other side,
and one of them has no `=`. Several equations on a line are separated by `;`, by arrows, and by commas or wide spaces
after which another equation comes. Bullets, numbers and words before an equation, words and comments after it, and the
braces of a list around equations are omitted.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from lagrange.answers.written.cases import with_cases
from lagrange.answers.written.joined_lines import KNOWN, LINKING, joined_lines
from lagrange.answers.written.notation.documents import in_plain_text
from lagrange.answers.written.notation.habits import in_usual_signs
from lagrange.answers.written.notation.matrices import rows_of_lists, rows_with_names, with_bracketed_arrays
from lagrange.answers.written.notation.numbers import with_decimal_points
from lagrange.answers.written.notation.programs import by_comprehension, by_method_of_lagrange, one_by_one
from lagrange.answers.written.notation.rare import name_of_extreme, ratios_of, tuples_of
from lagrange.answers.written.numbering import without_numbers
from lagrange.answers.written.values import (
    CONDITIONAL,
    STABILITY,
    WHEN,
    exact_results,
    with_claim_last,
    with_equality,
    with_place_first,
    without_star,
)
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, closings, cuts
from lagrange.expressions.latex_layout import OneEquation, equations, is_latex
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.reader import is_inequality

_COMMENT = re.compile(r"(?:^|\s)(?:#|%|//)[^\n]*|\(\*[^\n]*?\*\)|/\*[^\n]*?\*/")
_LATEX_COMMENT = re.compile(r"(?<!\\)%[^\n]*|\s//\s[^\n]*")
_ARROW = r"(?:==?>|(?:-+>|→|⟶)(?!\s*(?:∞|inf|0(?![\w.])))|=>|⇒|⟹|∴|⇔|⟺|↔|\bimplies\b|\bhence\b|\btherefore\b)"
_LIMIT = r"(?:-+>|→|⟶)\s*(?:∞|inf(?:inity|ty)?\b|0)\s*[,:](?=[^=]*=)"
_SENTENCE = (
    r"(?<=[\w)\]²³'])\.\s+(?=(?:[A-ZÄÖÜÉ][^\W\d_]+|A|I)(?:[\s,:]|\Z)|[^\W\d_]{1,5}(?:_\w{1,8}|\d)?['\u0307\u0308]*\s*=)"
)
_BETWEEN = (
    r"(?<=[\w)\]²³'])[,.]?\s+(?:(?:this|which|that|it|we|so|and|thus|then)\s+){0,3}"
    r"(?:ergibt|liefert|donne|becomes|gives|give|yields|giving|yielding|means|reads|leads\s+to|results\s+in|get|obtain|find|so|thus)"
    r"(?:\s+that)?[,:]?\s+(?=[^=]*=)"
)
"""Words between two equations."""
_REACHED = (
    r"(?<=[\w)\]²³'])\s+(?:(?:is|and|which|it|wird)\s+){0,2}(?:reached|attained|occurs?|happens?|erreicht|atteinte?)"
    r"\s+(?:at|after|when|for|bei|nach|zur Zeit|à)\s(?=[^=]*=)"
)
"""Words between a value and its time: `x = 2 m g/k reached at t = ...`."""
_SEPARATOR = re.compile(
    rf";|{_LIMIT}|{_ARROW}|\b(?:and|where|with)\b(?=[^=]*=)|(?<=[\w)\]²³'])\s+(?:if|when|at)\s(?=[^=]*=)|(?<=[\w)\]²³'])\s+(?:at|for|bei|für|pour)\s+(?=(?:cos|sin|tan)[^=]{{1,20}}=)|(?<=\s)(?:und|et|mit|avec|wobei|sowie|où)\s(?=[^=]*=)"
    rf"|{_BETWEEN}|{_REACHED}|{_SENTENCE}|\\n|[,\s(]i\.\s?e\.,?(?=\s[^=]*=)|(?<=[\w)\]²³'])\s*(?:\.\.\.|…)(?=[^=]*=)"
    r"|(?<=[\w)\]²³'])\.\s+(?=[(\[][^=]*=)"
)
_LEADS_ON = re.compile(_BETWEEN)
_ROWS_OF_WORD = re.compile(rf"{_SEPARATOR.pattern}|(?<!@)@(?!@)")
_PIECES = re.compile(r"[,;](?=\s)")
_SOFT = re.compile(r",|\s{3,}|\t")
_EQUALS = re.compile(r"(?<![<>!=])=(?![=>])|==(?!>)")
_NAMED = re.compile(
    r"\s*(?:(?:In|Out)\[[0-9]{0,4}\]\s*:?=|>+|>>>)?\s*(?:[A-Za-z][A-Za-z0-9_]{0,20}\s*(?::=(?=[^=]*=)|=(?=[^=]*==[^=]*\Z)))?"
)
_WORD_ARRAY = re.compile(r"\s*(?:[{〖├]\s*)?■\s*(?=\()")
_ABOUT_PARTS = re.compile(r"\s*[^\W\d_](?:[^=:*/^\\'()\[\]0-9<>≤≥;]|\([^()=*/^']{1,40}\)){3,60}:(?=\s)")
_SPECIAL_CASE = re.compile(
    r"\s*(?:for|if|when|in the case)\s+[^\s=]{1,12}\s*=\s*[^\s=]{1,12}\s*,?(?:\s+[^\W\d_]+,?){3,}[.!]?\s*\Z",
    re.IGNORECASE,
)
_LONG_WORDS = re.compile(r"[^\W\d_]{3,}")
_ASIDE = re.compile(r"\(([^()]*=[^()]*)\)\s*[:.,;]?\s*\Z")
_FIRST = "it|again|at|the|after|when|which|that|is|are|has|have|we|then|where|from|by|until|before|since|because|while"
_COLON = re.compile(r"=[^=:]{1,60}(:)\s(?=[^=]*=)")
_SO = re.compile(
    r"(?<![<>!])=[^=]{1,80}?(?<=[\w)\]²³'])\s((?:so|thus)(?:\s+that)?"
    rf"|(?:{_FIRST})(?:\s+(?!(?:{'|'.join(KNOWN)})\b)[a-z]{{2,12}}){{1,8}})\s+(?=[^=]{{1,40}}=)"
)
"""Words between two equations, the first of which goes on: `x' = 0 again at w t = pi`, `x = 0 it has gone x = a t`."""
_HEADING = re.compile(r"[^\W\d_]{4,}[^:;'\u0308¨]{0,60}:(?=\s)")
_WORDS_BEFORE = re.compile(r"(?:[^\W\d_]{2,}(?![^\W\d_])[\s,.:]{0,3}){1,8}\Z")  # a run of letters is one word
_NAMES_NEXT = re.compile(rf"\s*(?:[A-Za-z{''.join(GREEK)}]|{'|'.join({*GREEK.values()})})(?:_?\w{{1,8}})?\s*=(?!=)")
_LATEX_WORDS = re.compile(
    r"[\s,;.](?:where|with|wobei|mit|and|und|et)\s(?=[^=]*=)|,?\si\.\s?e\.,?\s(?=[^=]*=)"
    r"|[,;.]\s+(?:(?:and|so|then|thus|hence|therefore|i\.\s?e\.|which|that|this|it|gives|giving|yields|is|also|damit|also|folgt)[\s,:]+){1,4}(?=[^=]*=)"
    r"|(?<=[\w)}\]])\.\s+(?=[A-Z][^\W\d_]+[\s,:])(?=[^=]*=)",
    re.IGNORECASE,
)
"""What separates equations in a text of LaTeX without a `$`: `a = b. Then c = d, i.e. e = f`."""
_LEADING = re.compile(rf"\s*(?:{_ARROW}|d/dt\s*(?:\([^()=]{{0,20}}\))?\s*:|[:.,&>]|\*\s)\s*")
_I_GOT = re.compile(
    r"[iI]\s+(?:got|get|have|found|find|obtain(?:ed)?|used?|took|take|set|wrote|write|started with|assumed?)\b"
    r"(?!\s*[=*/^+])"
)
_WORD = re.compile(r"(?:[^\W\d_]['’])?[^\W\d_]{2,}(?:['’]s|(?<=n)['’]t)?[.,:]?(?=\s|$|[,:])")
_STANDS_ALONE = re.compile(r"\s*:?=(?![=>])")
"""What follows a word that is a name, as in `den = ...`."""
_NEXT_WORD = re.compile(r"\s*(?:[^\W\d_]['’])?([^\W\d_]{2,})(?:['’]s|(?<=n)['’]t)?[.,:]?(?=\s|$|[,:])")
_TAIL = re.compile(
    r"(?:(?<!\s)(?:\s*[,.;])?\s+(?:(?:where|with|for|since|because|which|when|if|so|as|by|using|from|towards?|to|upwards?|downwards?|(?:counter|anti)?-?clockwise|after|opposite|leads?|gives?|giving|yields?|is|are|at|in(?![.,;\s]*\Z|/)|the|q\.?e\.?d"
    r"|provided|valid|and|wobei|mit|für|on|about|around|über|um|bei|independent|holds|being|here|again|also|not|but|of|only|each|respectively|dabei|où|pour|avec|degrees?\s+of|dofs?|freiheitsgrade?n?|degrés)\b)[^=]*|\s+(?:etc|usw)\b\.?|\s+\((?P<remark>(?:[^()=*^'/+]|(?<=[a-z]{3})'s\b)*)\)[.,;:]*|\s*[.,;:]+)\s*\Z",
    re.IGNORECASE,
)
_RATE_MARKS = "='\u0307\u0308¨˙"
_WHERE_VALID = re.compile(
    rf"\s+\((?=[^()]*[<>≤≥≠])[^(){_RATE_MARKS}]*\)[.,;]?\s*\Z"
    rf"|,?\s+(?:for|as long as|while)\s+(?=[^=]*[<>≤≥≠])[^{_RATE_MARKS}]*\Z"
)
"""Where an equation is valid: `(r > 0)`. A sign of a velocity is no such remark, since friction depends on it."""
_AFTER_COMMA = re.compile(
    rf",\s+(?!(?:{'|'.join(sorted(KNOWN - {'eq'}))})(?![^\W\d_]))"
    r"(?=[^\W\d_]{2,}(?:-[^\W\d_]+)*(?:[\s.,;:)]|\Z)|[0-9]{1,2}\s+(?:degrees?|DOFs?|d\.o\.f|Freiheitsgrade?)\b)[^=()\[\]+*^]*\Z"
)
"""Words after a comma, where no equation follows: a comma outside brackets is no part of an equation."""
_LIST = re.compile(r"\s*(?:(?:In|Out)\[[0-9]{0,4}\]\s*:?=|>)?\s*(?:\w+\s*:?=\s*)?([\[{])")
_EQ = re.compile(
    r"\s*(?:\w+\s*=\s*)?(?:sp\.|sympy\.)?Eq\s*(?=\()|\s*(?:\w+\s*=\s*)?(?:DSolve|Solve|NDSolve|solve|dsolve|(?:Full)?Simplify|simplify|[Ee]xpand)\s*(?=\[|\()"
)
_MAPLE = re.compile(r"(?<=[A-Za-z0-9_])\s*\$\s*([1-4])(\s*[,)])")
_RULES = re.compile(r"\s*(?:Out\[[0-9]{0,4}\]\s*=)?\s*\{\s*\{?\s*\w+'*(?:\[t\])?\s*->")
_RULE = re.compile(r"->")
_OPERATOR = re.compile(r"∂|\\partial|d\s*/\s*dt|\{\s*dt\s*\}|\bdiff\b|\\p?dv|Derivative|\bD\[")
_PLACE_BEFORE = re.compile(
    r"\s*(?:about|around|near|at)\s+[^:=]{1,30}(?:=[^:=]{1,20}){1,3}:\s+(?=[^=]*=)", re.IGNORECASE
)
"""The place for which an equation holds, before it: `about θ = 0: ω = sqrt(g/R)`."""


def equations_of_line(fragment: Fragment, beside: str = "") -> Iterator[Fragment]:
    """The equations of one line, each without accompanying words; `beside` are the words above it."""
    fragment = with_claim_last(with_place_first(with_equality(fragment)))
    if place := _PLACE_BEFORE.match(fragment.text):
        beside = f"{beside} {place[0]}"
        fragment = _part(fragment, place.end(), len(fragment.text))
    if is_latex(fragment):
        if _MAPLE.search(fragment.text) is None or "\\" in fragment.text:
            yield from _in_latex(fragment, beside)
            return
        draft = Draft(fragment)
        draft.replace(_MAPLE, r", \1\2")
        fragment = draft.finished()
    text = fragment.text
    comment = _COMMENT.search(text)
    end = comment.start() if comment and "\n" not in text[comment.start() :].strip() else len(text)
    if stated := _in_other_shape(text[:end]) or by_method_of_lagrange(text) or by_comprehension(text[:end]):
        yield from (_rewritten(fragment, equation) for equation in stated)
        return
    if len(pieces := cuts(text[:end], _PIECES)) > 1 and any(ratios_of(text[a:b]) for a, b in pieces):
        for a, b in pieces:
            yield from equations_of_line(_part(fragment, a, b), beside)
        return
    if pairs := [f"{text[a:b].strip()} = {text[c:d].strip()}" for a, b, c, d in one_by_one(text[:end])]:
        yield from (_rewritten(fragment, pair) for pair in pairs)
        return
    if _RULES.match(text, 0, end):
        draft = Draft(fragment)
        draft.replace(_RULE, " =")
        yield from equations_of_line(draft.finished(), beside)
        return
    remarks = [*STABILITY.finditer(text, 0, end)]
    if remarks or CONDITIONAL.search(text, 0, end):
        draft = Draft(fragment)
        draft.apply([(m.start(), m.end(), " " * len(m[0])) for m in (*remarks, *CONDITIONAL.finditer(text, 0, end))])
        fragment = draft.finished()
        text = fragment.text
    heading = _HEADING.match(text, 0, end)
    for start, stop in _parts(text, 0, end):
        words = _WORDS_BEFORE.search(text, max(0, start - 80), start) if start else None
        before = words[0] if words else ""
        if _EQUALS.search(text, 0, start) is None:  # prose with mathematics: `small angles sin θ ≈ θ so ...`
            before = text[:start]
        remark = _remarks_on(text, start, stop, remarks)
        above = heading[0] if heading and start >= heading.end() else ""
        about = [beside, remark and f"{remark};", above, before]
        for e in _one(fragment, start, stop, " ".join(filter(None, about))):
            leads_on = _LEADS_ON.match(text, stop) is not None  # what stands after it is about the next equation
            said = _ENDED.sub("", " ".join(filter(None, about)))
            yield replace(e, beside=said) if leads_on and isinstance(e, OneEquation) else e


def _in_other_shape(text: str) -> list[str]:
    """The equations that an equation between lists, or between ratios, states; that for `T_max` of one for `max(T)`."""
    if len(text) > MAX_ANSWER_CHARACTERS:
        return []
    named = [name for name in (name_of_extreme(text),) if name != text]
    return tuples_of(text) or rows_of_lists(text) or ratios_of(text) or named


def _remarks_on(text: str, start: int, stop: int, remarks: Sequence[re.Match[str]]) -> str:
    """The remarks on stability after an equation, or before it if the first remark precedes all equations."""
    signs = [m.start() for m in _EQUALS.finditer(text)]
    own = [s for s in signs if start <= s < stop]
    if not remarks or not own:
        return ""
    ahead = [m for m in remarks if _PLACE_NEXT.match(text, m.end())]
    said = [m for m in ahead if own[0] == next((s for s in signs if s >= m.end()), None)]
    if others := [m for m in remarks if m not in ahead]:
        before = others[0].start() < signs[0]
        beyond = [s for s in signs if (s < own[0] if before else s > own[-1])]
        limit = (beyond[-1:] or [-1])[0] if before else (beyond[:1] or [len(text)])[0]
        said += [m for m in others if (limit < m.start() < own[0] if before else own[-1] < m.start() < limit)]
    return "; ".join(_bare(m[0]) for m in said)


_PLACE_NEXT = re.compile(r"\s*(?:at|in|for|near|around|about|bei|um|für|en|à|pour)\s+[^\s=<>≤≥]{1,16}\s*=(?!=)")
"""The place that a remark on stability is about, after it: `stable at θ = 0`."""


def _bare(remark: str) -> str:
    """A remark without the punctuation around it, and without its parentheses."""
    plain = remark.strip(" ,;")
    return plain[1:-1].strip() if plain[:1] == "(" and plain[-1:] == ")" else plain


def _rewritten(fragment: Fragment, text: str) -> Fragment:
    draft = Draft(fragment)
    draft.apply([(0, len(fragment.text), text)])
    return draft.finished()


def _in_latex(fragment: Fragment, beside: str) -> Iterator[Fragment]:
    text = fragment.text
    start = 0 if "$" in text else _after_words(text, 0, len(text))
    comment = _LATEX_COMMENT.search(text) if "\n" not in text.strip() else None
    end = comment.start() if comment and comment.start() > start else len(text)
    if "=" not in text[start:end] and not re.search(r"\\equiv|\\coloneqq", text):
        return
    words = f"{beside} {text[:start]} {' '.join(_TEXT.findall(text))}".strip()
    plain = text.replace("$", " ")
    remarks = [*STABILITY.finditer(plain, start, end)] if "$" in text else []
    pieces = cuts(text[start:end], _LATEX_WORDS) if "$" not in text else [(0, end - start)]
    for first, last in pieces:
        whole = (start + first, start + last) == (0, len(text))
        if not whole and first:
            first += _after_words(text[start + first : start + last], 0, last - first)
        part = fragment if whole else _part(fragment, start + first, start + last)
        for e in equations(part):
            said = words
            if "$" in part.text:
                at = e.span(0, 1).start - part.span(0, 1).start
                on = _remarks_on(plain, start + first + at, start + first + at + len(e.text), remarks)
                said = f"{words} {_words_before(part.text, at)} {on and f'; {on}'}".strip()
            yield replace(e, beside=said) if isinstance(e, OneEquation) else e


def _words_before(text: str, at: int) -> str:
    """The words of the sentence before an equation between `$`, without mathematics, remarks, the words in \\text."""
    before = STABILITY.sub(" ", _TEXT.sub(" ", _INLINE.sub(" ", text[: max(0, at)]))).rstrip(" $:\n")
    return _END_OF_SENTENCE.split(before)[-1].strip()


_INLINE = re.compile(r"\$+[^$]*\$+")
_TEXT = re.compile(r"\\text\{([^{}]{0,80})\}")
_END_OF_SENTENCE = re.compile(r"[.;]\s|\n\s*\n")


def _parts(text: str, start: int, end: int) -> Iterator[tuple[int, int]]:
    """Where equations begin and end in plain text."""
    if array := _WORD_ARRAY.match(text, start, end):
        close = closings(text).get(array.end(), end)
        for first, last in cuts(text[array.end() + 1 : close], re.compile("@")):
            yield from _parts(text, array.end() + 1 + first, array.end() + 1 + last)
        return
    aside = _ASIDE.search(text, start, end)
    if aside and len(_LONG_WORDS.findall(before := text[start : aside.start()])) > 1 and "=" not in before:
        for first, last in cuts(aside[1], re.compile(",")):
            yield from _parts(text, aside.start(1) + first, aside.start(1) + last)
        return
    if colon := _COLON.search(text, start, end) or _SO.search(text, start, end):
        yield from _parts(text, start, colon.start(1))
        yield from _parts(text, colon.end(1), end)
        return
    if (bracket := _equations_in_brackets(text, start, end)) is not None:
        yield from _parts(text, start, bracket[0])
        yield from _parts(text, bracket[0] + 1, bracket[1])
        return
    inside = _inside_list(text, start, end)
    if inside is not None:
        for first, last in cuts(text[inside[0] : inside[1]], re.compile(",")):
            yield from _parts(text, inside[0] + first, inside[0] + last)
        return
    are_rows = all("=" in row for row in text[start:end].split("@"))
    for first, last in cuts(text[start:end], _ROWS_OF_WORD if are_rows else _SEPARATOR):
        pieces = cuts(text[start + first : start + last], _SOFT)
        whole = start + first
        begin = pieces[0][0]
        for n, (_, stop) in enumerate(pieces):
            following = text[whole + stop : start + last]
            here = text[whole + begin : whole + stop]
            ended = n == len(pieces) - 1
            if ended or (_EQUALS.search(here) and _begins_equation(following)):
                if _EQUALS.search(here) or _EQ.match(here):
                    if (whole + begin, whole + stop) != (start, end) and _inside_list(
                        text, whole + begin, whole + stop
                    ):
                        yield from _parts(text, whole + begin, whole + stop)
                    else:
                        yield whole + begin, whole + stop
                begin = pieces[n + 1][0] if not ended else stop


def _equations_in_brackets(text: str, start: int, end: int) -> tuple[int, int] | None:
    """The brackets at the end of a line, after an equation, with other equations in them: `(where w^2 = g/l)`."""
    stop = len(text[start:end].rstrip(" .,;")) + start
    if stop <= start or text[stop - 1] != ")" or "=" not in text[start:stop]:
        return None
    opening = next((a for a, b in closings(text[start:stop]).items() if b == stop - start - 1), None)
    if opening is None or not text[start + opening - 1 : start + opening].isspace():
        return None
    first = start + opening
    before = _EQUALS.search(text, start, first)
    return (first, stop - 1) if before and _EQUALS.search(text, first, stop - 1) else None


def _begins_equation(text: str) -> bool:
    """Whether the next equation has its left side in the text: `, b = c`, and not `   = c` or `  + d = e`."""
    following = text.lstrip(" \t,")
    sides = _EQUALS.split(following, maxsplit=1)
    return (
        len(sides) == 2
        and bool(sides[0].strip())
        and following[:1] not in "+*/−·)="
        and following[:2] != "- "
        and (following[:1] != "(" or text.lstrip()[:1] == ",")
    )


def _inside_list(text: str, start: int, end: int) -> tuple[int, int] | None:
    """The inside of the brackets of a list of equations, of `Eq(a, b)` no more than that."""
    match = _LIST.match(text, start, end)
    if match is None:
        return None
    opening = match.start(1)
    close = closings(text).get(opening)
    if close is None or text[close + 1 : end].strip(" .;,"):
        return None
    inner = text[opening + 1 : close]
    return (opening + 1, close) if _EQUALS.search(inner) or "Eq(" in inner else None


def _one(fragment: Fragment, start: int, end: int, beside: str) -> Iterator[Fragment]:
    text = fragment.text
    if _SPECIAL_CASE.match(text, start, end):
        return
    begin = _after_words(text, start, end)
    end = begin + len(text[begin:end].rstrip())
    if match := _EQ.match(text, begin, end):
        yield from _from_call(fragment, match.end(), beside)
        return
    tail = ""
    if rest := _WHERE_VALID.search(text, begin, end) or _AFTER_COMMA.search(text, begin, end):
        tail, end = rest[0], rest.start()
    words = _TAIL.search(text, begin, end)
    remark = words["remark"] if words else None
    if words and _EQUALS.search(text, begin, words.start()) and (remark is None or _is_prose(remark)):
        tail, end = f"{words[0]} {tail}", words.start()
    elif words and remark is not None:
        end = begin + len(text[begin:end].rstrip(" .,;:"))
    if begin < end and _EQUALS.search(text, begin, end):
        said = tail if tail.strip(" .,;:") else ""
        yield _made(fragment, begin, end, _ENDED.sub("", f"{beside} {text[start:begin]} {said}".strip()))


_ENDED = re.compile(r";[\s,]*\Z")
"""The end of a remark on stability, where nothing else is said."""
_SIGNS = re.compile(r"\s[-+−·]\s|[−·√²³½\u0300-\u036f]")


def _is_prose(text: str) -> bool:
    """Whether a text in parentheses is a remark, as in `(towards the bottom)`, and no factor."""
    words = re.findall(r"[A-Za-zÀ-ÖØ-öø-ÿ]{2,}", text)
    if _SIGNS.search(text):
        return False
    return any(len(w) > 3 for w in words) and not any(w.lower() in KNOWN for w in words)


def _from_call(fragment: Fragment, opening: int, beside: str) -> Iterator[Fragment]:
    """The equation that `Eq(a, b)` states."""
    text = fragment.text
    close = closings(text).get(opening)
    if close is None:
        return
    sides = cuts(text[opening + 1 : close], re.compile(","))
    if text[opening - 1] != "q":  # Solve, with what is asked for, or Simplify
        first, last = sides[0]
        for start, stop in _parts(text, opening + 1 + first, opening + 1 + last):
            yield from _one(fragment, start, stop, beside)
    elif len(sides) == 2:
        draft = Draft(_part(fragment, opening + 1, close))
        at = sides[0][1]
        draft.apply([(at, at + 1, " = ")])
        yield replace(draft.finished(), beside=beside)  # type: ignore[call-arg]


def _after_words(text: str, start: int, end: int) -> int:
    """Where mathematics begins after words, arrows and labels."""
    named = _NAMED.match(text, start, end)
    at = named.end() if named else start
    about = _ABOUT_PARTS.match(text, at, end)
    if about and len(re.findall(r"[^\W\d_]{4,}", about[0])) > 1:
        at = about.end()
    if _EQ.match(text, at, end):
        return at
    words, read = _prose_words(text, at, end), 0
    while at < end:
        if text[at].isspace():
            at += 1
        elif leading := _LEADING.match(text, at, end) or _I_GOT.match(text, at, end):
            at = leading.end()
        elif (word := _WORD.match(text, at, end)) and _STANDS_ALONE.match(text, word.end(), end) and word[0][-1] != ":":
            break
        elif word and (words > 0 or _is_word(word[0], read, text, word.end(), end)):
            at, words, read = word.end(), words - 1, read + 1
        elif named := _NAME_FOR.match(text, at, end):
            at = named.end()
        elif article := (_ARTICLE if read else _FIRST_ARTICLE).match(text, at, end):
            at, words = article.end(), words or _prose_words(text, article.end(), end)
        else:
            break
    name = _NAME_AND_COMMA.match(text, at, end) if read else None  # with the friction angle φ, tan φ = μ
    return name.end() if name else at


_ARTICLE, _FIRST_ARTICLE = re.compile(r"[aAI](?=\s+[^\W\d_]{2})"), re.compile(r"A(?=\s+[a-z]{3,}\s+[a-z]{3,}\s)")
_NAME_FOR = re.compile(r"[^\W\d]\w{0,12}\s+(?:for|für|pour)\s+(?=[^=]{1,40}=)")
"""The multiplier of a constraint before it: `N for y = R`."""
_NAME_AND_COMMA = re.compile(r"[^\W\d]\w{0,12}\s*,\s+(?=[^=,]{1,40}=)")


def _is_known(word: str) -> bool:
    """Whether a word is mathematics: a function, a Greek letter, or a function of one, `cosθ`."""
    plain = word.rstrip(".,:").lower()
    return plain in KNOWN or _OF_GREEK.fullmatch(plain) is not None


_DIFFERENTIAL = re.compile(rf"[dδ][qrstxyz{''.join(GREEK)}]")
_OF_GREEK = re.compile(rf"(?:arc|a)?(?:sin|cos|tan|cot|exp|sqrt|ln|log)[{''.join(GREEK)}]\w?")


def _prose_words(text: str, at: int, end: int) -> int:
    """The number of words with which a sentence begins: of at least two words one is long, and none is mathematics."""
    number, long = 0, False
    while word := _NEXT_WORD.match(text, at, end):
        if _is_known(word[1]) or _DIFFERENTIAL.fullmatch(word[1]) or (len(word[1]) == 1 and number == 0):
            break
        number, long, at = number + 1, long or len(word[1]) > 4, word.end()
    return number if number > 1 and long else 0


def _is_word(word: str, words: int, text: str, at: int, end: int) -> bool:
    plain = word.rstrip(".,:").lower()
    if _is_known(plain) or _DIFFERENTIAL.fullmatch(plain):
        return word.endswith(":")
    if plain in LINKING or word.endswith(":"):
        return True
    if len(plain) > (2 if words > 1 else 3) and _NAMES_NEXT.match(text, at, end):
        return True
    following = _WORD.match(text, at + 1, end)
    return len(plain) > 3 and (words > 0 or (following is not None and not _is_known(following[0])))


def _part(fragment: Fragment, start: int, end: int) -> Fragment:
    if isinstance(fragment, OneEquation) or fragment.start is None:
        draft = Draft(fragment)
        draft.keep(start, end)
        return draft.finished()
    return Fragment(fragment.text[start:end], fragment.span(start, end), fragment.start + start)


def _made(fragment: Fragment, start: int, end: int, beside: str) -> Fragment:
    part = _part(fragment, start, end)
    made = part if isinstance(part, OneEquation) else OneEquation(part.text, part.whole, part.start)
    return replace(made, beside=beside)


def in_pairs(fragment: Fragment) -> list[Draft]:
    """`N = b = c` as N = b and N = c, each a value of N; none unless there are three to eight sides.

    `d/dt(∂L/∂x') = b = c`, whose first side may be the method quoted, is that and b = c.
    """
    parts = cuts(fragment.text, _EQUALS)
    if not 2 < len(parts) <= 8 or any(not fragment.text[start:end].strip(" $&") for start, end in parts):
        return []
    pieces = []
    (first, end), *_ = parts
    between = _LONG_WORDS.findall(fragment.text[end : parts[-1][0]])
    prose = any(word.lower() not in KNOWN for word in between) and "\\" not in fragment.text
    vanishes = fragment.text[slice(*parts[-1])].strip(" $&.,;") == "0"  # δW = W δy - P δx = 0
    from_first = _OPERATOR.search(fragment.text, first, end) is None and not prose and not vanishes
    for (start, _), (begin, last) in pairwise(parts):
        piece = Draft(fragment)
        if from_first and start != first:
            piece.apply([(end, begin, " = ")])
            piece.keep(first, last - (begin - end) + 3)
        else:
            piece.keep(start, last)
        pieces.append(piece)
    return pieces


def separated_lines(answer: Iterable[Fragment]) -> tuple[Fragment, ...]:
    """The equations of an answer; one text may have several. A text without any is kept, so that an error names it."""
    answer = [*answer]
    if len(answer) > 1 and not any(isinstance(f, OneEquation) for f in answer):  # a case each
        texts = "\n".join(f.text for f in answer)
        together = with_cases(texts)
        answer = answer if together == texts else [Fragment.of(together, answer[0].whole.source.name)]
    separated = with_lists_written_out([e for fragment in answer for e in _separated(fragment)])
    return exact_results([without_star(f) for f in separated])


def with_lists_written_out(answer: Sequence[Fragment]) -> list[Fragment]:
    """`A*[x''; y''] = rhs`, where A and rhs are lists that other lines define, as one equation a row."""
    made = zip(answer, rows_with_names([f.text for f in answer]), strict=True)
    return [row for f, rows in made for row in ([f] if rows is None else [_rewritten(f, r) for r in rows])]


def condition_alone(fragment: Fragment) -> Fragment:
    """A text with inequalities without the words before and after them, and in parentheses."""
    if not is_inequality(fragment):
        return fragment
    draft = Draft(fragment)
    draft.replace(
        _WORDS_IN_BRACKETS,
        lambda m: None if any(map(_is_known, _LONG_WORDS.findall(m[0]))) or _SIGNS.search(m[0]) else " ",
    )
    if not is_latex(fragment):
        if case := _CASE.match(draft.text):
            draft.keep(case.end(), len(draft.text))
        draft.keep(_after_words(draft.text, 0, len(draft.text)), len(draft.text.rstrip(" .,;")))
        if tail := _AFTER_COMMA.search(draft.text):
            draft.keep(0, tail.start())
    elif "$" in draft.text:
        inside = [m for m in _BETWEEN_DOLLARS.finditer(draft.text) if re.search(r"[<>≤≥]|\\[gl]eq?", m[1])]
        ends = [0, *(x for m in inside for x in m.span(1)), len(draft.text)]
        between = [
            (a, b, _joint(draft.text[a:b]) if a > 0 and b < len(draft.text) else "")
            for a, b in zip(ends[::2], ends[1::2], strict=True)
        ]
        draft.apply(between if inside else [])
    else:
        draft.keep(_after_words(draft.text, 0, len(draft.text)), len(draft.text))
    return draft.finished(latex=is_latex(fragment))


def _joint(words: str) -> str:
    """What joins two conditions between which there are words."""
    return r" \text{ or } " if re.fullmatch(r"[\s,;$]*(?:or|oder|ou)[\s,;$]*", words) else ", "


_CASE = re.compile(r"[^:;=]*[<>≤≥][^:;=]*:\s(?=[^:]*[=<>≤≥])")
"""A case, which has a result of its own: `if mu < b/h: P_max = ...`."""
_WORDS_IN_BRACKETS = re.compile(r"(?<![^\W\d_])\(\s*[^()<>=≤≥0-9*/^\\]*[^\W\d_]{3,}[^()<>=≤≥*/^\\]*\)")
_BETWEEN_DOLLARS = re.compile(r"\$+([^$]+)(?:\$+|\Z)")
_BETWEEN_CONDITIONS = re.compile(
    rf"(?<!\\)[,;](?!\s*{WHEN}\s)|\bi\.\s?e\b\.?|\bor equivalently\b|(?<=\s)(?:so|hence|thus|therefore)\s(?:that\s)?"
    r"|(?<=\s)(?:and|und|et)(?=\s+(?:[^\W\d_]{2,}\s+){0,3}[^\W\d_]{3,}:)"
)


def conditions_of(fragment: Fragment) -> list[Fragment]:
    """The parts of a text between commas, if each of them is an equation or an inequality."""
    places = [*cuts(fragment.text, _BETWEEN_CONDITIONS)]
    places = [(start, end) for start, end in places if fragment.text[start:end].strip()]
    parts = [_part(fragment, start, end) for start, end in places]
    return parts if all("=" in p.text or is_inequality(p) for p in parts) else [fragment]


_BESIDE_CONDITION = re.compile(r"(?<=[\s,;$])(?:with|where|wobei|mit|avec|où)\s(?=[^=]*=)")


def _separated(fragment: Fragment) -> list[Fragment]:
    if isinstance(fragment, OneEquation):
        return [fragment]
    parts = conditions_of(fragment) if "\n" not in fragment.text and is_inequality(fragment) else []
    if sum(map(is_inequality, parts)) > 1:  # H <= mu N, so tan(theta) <= mu
        return [e for p in parts for e in _separated(p)]
    beside = cuts(fragment.text, _BESIDE_CONDITION)
    if len(beside) > 1 and "\n" not in fragment.text and is_inequality(first := _part(fragment, *beside[0])):
        return [first, *(e for place in beside[1:] for e in _separated(_part(fragment, *place)))]
    fragment = replace(fragment, text=without_numbers(fragment.text))
    if (cases := with_cases(in_usual_signs(in_plain_text(fragment.text)))) != fragment.text:
        fragment = Fragment.of(cases, fragment.whole.source.name)
    if is_latex(fragment):
        fragment = replace(fragment, text=with_bracketed_arrays(fragment.text))
        return list(_in_latex(fragment, "")) or list(equations(fragment))
    if (decimals := with_decimal_points(fragment.text)) != fragment.text:
        fragment = replace(fragment, text=decimals)
    lines = [(m.start(), m.end(), m[0]) for m in re.finditer(r"[^\n]+", fragment.text)]
    written = [(start, end) for start, end in joined_lines([x for x in lines if x[2].strip()])]
    parts = [e for start, end in written for e in equations_of_line(_part(fragment, start, end))]
    return parts or [fragment]
