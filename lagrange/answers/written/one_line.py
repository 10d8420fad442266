r"""The equations of one line of an answer, stripped of number, label, box and colour, and of the words around them.

The equations of one line of an answer, stripped of number, label, box and colour.

a = b = c is a = b and b = c. A line with `or` is kept whole, since it states alternatives.

Sentences around an equation in plain text: words that are no names of the problem.

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
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace

from lagrange.answers.limits import MOST_LISTED, SHORTEST_WORD
from lagrange.answers.readings import GivenEquation, Reading
from lagrange.answers.written.expansions import ORDER
from lagrange.answers.written.lines import in_pairs
from lagrange.answers.written.notation.matrices import has_matrix, rows_of_matrices
from lagrange.answers.written.notation.numbers import unit_behind
from lagrange.answers.written.notation.plain import cleaned, is_rate
from lagrange.answers.written.notation.programs import as_equation
from lagrange.answers.written.notation.rare import integrals_over_time
from lagrange.answers.written.numbering import number_at_the_end
from lagrange.answers.written.reading import too_long, without_braces
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import ABOUT, GREEK
from lagrange.expressions.edits import Draft, cut, cuts
from lagrange.expressions.latex_layout import OneEquation, is_latex
from lagrange.expressions.latex_names import LatexNames
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import FUNCTIONS, OPERATIONS

_ALTERNATIVES = re.compile(r"(?<![\w\\])or(?![\w'])|\\(?:text|textrm|mbox|mathrm)\{\s*or\s*\}")
_ITEM = re.compile(r"\s*\(([a-h]|[ivx]{1,4})\)\s+")
_IN_BRACKETS = re.compile(
    r"\s*(?:\\left\s*)?(?:\[|\\\{)(?P<inside>[^\[\]]*=[^\[\]]*?)(?:\\right\s*)?(?:\]|\\\})\s*\Z|\s*\\(?:text)?color\s*\{[^{}\\]{0,40}\}\s*\{(?P<colour>.*=.*)\}\s*\Z"
)
_ABOUT = re.compile(rf"{ABOUT}|\\sim(?![A-Za-z])|~=|(?<=\s)~(?=\s)")
_ORDER_TERM = re.compile(
    r"\s*[-+−]\s*(?:\\mathcal\s*\{?\s*O\s*\}?|\\mathrm\s*\{\s*O\s*\}|[Oo𝒪])\s*(?:\\left\s*)?"
    r"\((?:[^()=]|\([^()=]{0,20}\)){1,40}\)\s*\Z"
)
"""What is left out in an expansion, `+ O(theta^3)`."""
_NEGLECTED = re.compile(r"\((.*)\)\s*\Z")
_INTEGRAL = re.compile(r"(?:∫|\\o?int(?![A-Za-z])(?:\\limits)?|(?<![A-Za-z])int(?:egral)?)\s*(?:[_^₀-₉⁰-⁹]|from\b)")
"""An integral with limits."""
_ACCELERATION = re.compile(r"''|″|\u0308|¨|\\ddot|ddot|d\s*(?:\^\s*\{?2|²)|\\dot\s*\{?\s*\\dot")
_LABEL = re.compile(
    r"(?:[\s&]*(?:\\(?:text(?:bf|it|rm|sf)?|mbox|mathrm|underline)\s*\{[^{}=]{1,60}(?::\s*\}|\}\s*&?\s*:)"
    r"|\\(?:[ns][ew]arrow|(?:up|down|left|right|curve|circle)arrow(?:left|right)?|curvearrow(?:left|right))[^:=+\\]{0,8}:"
    r"|[↑↓→←↗↘↖↙↺↻⟲⟳]\s*:|\\?[A-Za-z]{1,10}(?:_\{?\w{1,3}\}?)?\s*:(?=\s*(?:&|~|\\q?quad|\\[,;: !])))"
    r"\s*(?:&|~|\\q?quad|\\[,;: !])*)+"
)
"""What an equation is about, before it: `\\text{radial: }`, `\\searrow:`."""


@dataclass
class Line:
    """One equation of the answer, as far as it has been parsed; a `whole` one states alternatives."""

    fragment: Fragment
    text: str
    number: str = ""
    reading: Reading | None = None
    definition: bool = False
    whole: bool = False


def lines_of(fragment: Fragment, declared: Collection[str]) -> list[Line]:
    """The equations of a fragment without its number: a = b = c is a = b and b = c."""
    if isinstance(fragment, GivenEquation):
        return [Line(fragment, fragment.text, reading=fragment.reading)]
    text = fragment.text.strip()
    if len(text) > MAX_ANSWER_CHARACTERS:  # its error, and nothing else of it
        return [Line(fragment, text, reading=Reading(text, error=too_long(fragment)))]
    if _ALTERNATIVES.search(fragment.text):
        return [Line(fragment, text, whole=True)]
    if has_matrix(text) and (in_rows := rows_of_matrices(fragment.text)):
        return [Line(in_place_of(fragment, row), row) for row in in_rows]
    fragment = without_order_term(fragment, declared)
    draft = Draft(cleaned(fragment, declared))
    as_equation(draft, declared)
    if (item := _ITEM.match(draft.text)) and item[1] not in declared:
        draft.keep(item.end(), len(draft.text))
    if label := _LABEL.match(draft.text):
        draft.keep(label.end(), len(draft.text))
    if boxed := _IN_BRACKETS.match(draft.text):
        draft.keep(*boxed.span(boxed.lastgroup or 0))
    without_braces(draft)
    draft.keep(0, unit_behind(draft.text, declared))
    if (positive := _POSITIVE.search(draft.text)) and "=" in draft.text[: positive.start()]:
        draft.keep(0, positive.start())
    end, number = number_at_the_end(draft.text)
    about = next((m.start() for m in _ABOUT.finditer(draft.text) if "=" in draft.text[: m.start()]), end)
    latex = is_latex(fragment)
    draft.keep(0, min(end, about))
    whole = finished(draft, fragment, latex)
    pieces = in_pairs(whole) if draft.text.count("=") > 1 else []
    if not pieces:
        return [Line(whole, text, number)]
    made = [finished(piece, fragment, latex) for piece in pieces]
    return [Line(m, m.text.strip(" &$\n")) for m in made]


def without_order_term(fragment: Fragment, declared: Collection[str]) -> Fragment:
    """`a = b + O(x^3)` as a = b, which is approximate; `a = b = c + O(x^3)` as a = b."""
    text = fragment.text.rstrip(" .,;$")
    order = _ORDER_TERM.search(text)
    if order is None or "=" not in text or "O" in declared:
        return fragment
    latex, draft = is_latex(fragment), Draft(fragment)
    end = text.rindex("=") if text.count("=") > 1 else order.start()
    draft.keep(0, len(text[:end].rstrip("& ")))
    if "$" in draft.text:
        draft.replace(re.compile(r"\$"), " ")
    made = draft.finished(latex=latex)
    neglected = _NEGLECTED.search(order[0])
    marked = f" approximately, {ORDER.format(neglected[1])}" if neglected else " approximately"
    about = getattr(fragment, "beside", "") + ("" if text.count("=") > 1 else marked)
    return replace(made, beside=about.strip()) if isinstance(made, OneEquation) else made


def is_integral(text: str) -> bool:
    """Whether an integral with limits occurs in a line, which is working."""
    return _INTEGRAL.search(text) is not None


def without_integrals(fragment: Fragment) -> Fragment:
    """`t = \\int_a^b f dx = c` as t = c; the text itself where fewer than two sides are left."""
    if not is_integral(fragment.text):
        return fragment
    places = cuts(fragment.text, _SIGN)
    kept = [place for place in places if not is_integral(fragment.text[slice(*place)])]
    if len(kept) < 2 or len(kept) == len(places) or not all(fragment.text[slice(*p)].strip(" &$") for p in kept):
        return fragment
    draft = Draft(fragment)
    removed = [(a, b) for a, b in places if (a, b) not in kept]
    draft.apply([(max(0, a - 1) if a else a, b if a else b + 1, "") for a, b in removed])
    return finished(draft, fragment, is_latex(fragment))


_SIGN = re.compile(r"(?<![<>!=:])=(?![=>])")


def each_alternative(fragment: Fragment) -> list[Fragment]:
    """`theta'' = a or theta'' = b` as two equations, both of which have to be right."""
    if isinstance(fragment, GivenEquation) or not _ALTERNATIVES.search(fragment.text):
        return [fragment]
    places = cuts(fragment.text, _ALTERNATIVES)
    pieces = [fragment.text[slice(*p)] for p in places]
    if len(pieces) > MOST_LISTED or not all(_SIGN.search(p) for p in pieces):
        return [fragment]
    beside = getattr(fragment, "beside", "")
    parts = [cut(fragment, *p) for p in places]
    return [replace(p, beside=beside) if isinstance(p, OneEquation) else p for p in parts]


def each_equation_of_motion(fragment: Fragment) -> list[Fragment]:
    """The alternatives of a line if all have accelerations; positions of rest stay alternatives."""
    parts = each_alternative(fragment)
    return parts if all(_ACCELERATION.search(p.text) for p in parts) else [fragment]


_POSITIVE = re.compile(r"\s*(?:>=?|≥|\\geq?(?:slant)?(?![A-Za-z]))\s*0[\s.,;$]*\Z")
"""That what is stated is positive, as a normal force is: `N = m g - m v^2/R >= 0`."""
_DEFINITION = re.compile(
    r"[\s$&]*(?:\\?(?P<function>sin|cos|tan)\s*\(?\s*)?(?P<name>\\?[^\W\d_]+(?:_\w{1,4})?)\s*\)?\s*&?=(?![=>])(?P<value>[^=]+)\Z"
)
"""`phi = arctan(mu)`, `tan(phi) = mu`."""


def with_definitions_in_alternatives(answer: Sequence[Fragment], declared: Collection[str]) -> list[Fragment]:
    """`P = W tan(a - phi) or P = W tan(a + phi)` with what other lines say phi is, in its place."""
    meant: dict[str, str] = {}
    for f in answer:
        match = None if isinstance(f, GivenEquation) or _ALTERNATIVES.search(f.text) else _DEFINITION.match(f.text)
        if match is None or _spelled_name(match["name"]) in declared or match["name"].lstrip("\\") in FUNCTIONS:
            continue
        value = match["value"].strip(" $&.,;")
        inverse = match["function"] and f"{chr(92) if is_latex(f) else ''}arc{match['function']}"
        meant[match["name"]] = f"{inverse}({value})" if inverse else f"({value})"
    if not meant:
        return [*answer]
    used = re.compile(
        rf"(?<![\w\\])(?:{'|'.join(map(re.escape, sorted(meant, key=len, reverse=True)))})(?![A-Za-z0-9_])"
    )
    made = []
    for f in answer:
        draft = Draft(f)
        stated = isinstance(f, GivenEquation) or not _ALTERNATIVES.search(f.text)
        made.append(f if stated or not draft.replace(used, lambda m: meant[m[0]]) else finished(draft, f, is_latex(f)))
    return made


def _spelled_name(written: str) -> str:
    """`phi` of `\\varphi` and of `φ`."""
    name = "".join(GREEK.get(c, c) for c in written.lstrip("\\"))
    return name.removeprefix("var") if written.startswith("\\") else name


def in_place_of(fragment: Fragment, text: str) -> Fragment:
    """Another text at the place of a fragment."""
    draft = Draft(fragment)
    draft.apply([(0, len(fragment.text), text)])
    return draft.finished(latex=True)


def finished(draft: Draft, fragment: Fragment, latex: bool) -> Fragment:
    """The draft as a fragment, with the accompanying words."""
    made = draft.finished(latex=latex and draft.text != draft.outer.text)
    beside = getattr(fragment, "beside", "")
    return replace(made, beside=beside) if isinstance(made, OneEquation) else made


def with_integrals(answer: Sequence[Fragment], coordinates: Sequence[str]) -> list[Fragment]:
    """The answer with coordinates for integrals over time of their rates."""
    made = []
    answer = [without_integrals(f) for f in answer]
    for f, text in zip(answer, integrals_over_time([f.text for f in answer], coordinates), strict=True):
        draft = Draft(f)
        draft.apply([(0, len(f.text), text)] if text != f.text else [])
        made.append(f if text == f.text else finished(draft, f, is_latex(f)))
    return made


# Prose


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


def is_condition(beside: str, text: str = "") -> bool:
    """Whether the words before an equation make it a condition: `slack when T = 0`, `where T = 0`."""
    words = re.findall(r"[^\W\d_]+", beside)
    conditional = bool(words) and (
        words[-1].lower() in _CONDITIONAL or (words[-1].lower() in _WHERE and _VANISHES.fullmatch(text) is not None)
    )
    return conditional and not beside.rstrip().endswith((":", ",", "."))


_WHERE = frozenset({"where", "wo", "où"})
_VANISHES = re.compile(r"[\s$]*\\?[^\W\d]\w{0,12}\s*&?=\s*0[\s.,;$]*")
"""A name that is zero, which defines nothing."""


def words_known(scope: Scope, texts: Sequence[str]) -> Callable[[str], bool]:
    """Whether a word is a name of the problem, a product of such names, or defined by one of several equations."""
    names = LatexNames(scope)
    alone = {m[1] for text in texts if (m := re.match(r"\s*([^\W\d]\w*)\s*(?::=|==?)", text))}

    def known(word: str) -> bool:
        run = names.run(word)
        declared = not run.several and all(names.is_declared(name) for _, name in run.pieces)
        return declared or word in alone or is_rate(word, scope)

    return known


def is_prose(word: str, known: Callable[[str], bool]) -> bool:
    """Whether a word is neither a name nor a function; one of a few letters may be a product of names."""
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
    prose = [m.start() for m in _WORD.finditer(text, 0, end) if is_prose(m[0], known)]
    if not prose:
        return 0
    verb = _AFTER_VERB.search(text, 0, end)
    if verb and is_prose(verb["verb"], known):
        return verb.end("verb")
    cuts = [stop for start, stop in _joints(text, 0, end) if prose[0] <= start and stop > prose[-1]]
    rest = text[cuts[-1] : end].strip() if cuts else ""
    return cuts[-1] if rest and rest[0] not in "*/^)" else 0


_AFTER_VERB = re.compile(
    rf"\b(?:{'|'.join(sorted(_LINKS))})\s+(?P<verb>[^\W\d_]{{3,12}})\s+[^\W\d]\w{{0,12}}['\u0307\u0308]*\s*\Z",
    re.IGNORECASE,
)
"""A verb before the name that a sentence is about: `after the time t it has gone x = a t^2/2`."""


def _before_sentence(text: str, start: int, known: Callable[[str], bool]) -> int:
    """Where the right side ends."""
    for first, _ in _joints(text, start, len(text)):
        if not text[start:first].strip() or text[first - 1] in "*/^(":
            continue
        words = [m[0] for m in _WORD.finditer(text, first)]
        rest = _WORD.sub(" ", text[first:]).strip(" ,;:.()!")
        all_links = bool(words) and all(w.lower() in _LINKS for w in words)
        if words and ((all_links and not rest) or any(is_prose(w, known) for w in words)):
            aside = _ASIDE.search(text, start, first)
            return aside.start() if aside and all(is_prose(w, known) for w in aside[1].split()) else first
    return len(text)


_ASIDE = re.compile(r"\s\(([^()=*^/+<>]{1,60})\)\s*\Z")
"""Words in parentheses after an equation, where the sentence goes on: `I = m l²/3 (Schwerpunkt) folgt ...`."""
