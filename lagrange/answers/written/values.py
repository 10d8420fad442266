r"""Values in an answer: with units, of parameters, several at once, and numbers beside exact results.

The value of a quantity with its unit, `x = 4.9 cm`, in a problem whose parameters have values.

The dimension of a coordinate, a parameter or a force says what a letter means that may be a unit or a name:
`x = 0.049 m` is a length, although m is a mass, and `N = 85 N` is a force. A unit of another dimension is an error.

Values that an answer states for parameters, `g = 9.81 m/s^2`: numbers, and what follows them as a unit.

Several values after one sign of equality, as positions of equilibrium are listed.

    theta = 0, pi        θ = 0 or π, or cos θ = W l/(c b²)        \theta = 0 \text{ or } \pi        theta = {0, pi}
    {{x -> 0}, {x -> a}}

Each value without a sign of equality belongs to the left side before it; all together are alternatives.

Numbers beside exact results, and the letters of the parts of a question: what does not belong to an equation.

cos(theta) = 2/3, i.e. theta ≈ 48.2°            cos(theta) = 2/3
\cos\theta = \frac23 \Rightarrow \theta \approx 48{,}2^\circ
theta ≈ 48.2°                                   theta = 48.2°, where there is no other sign of equality
(a) v = ...                                     v = ..., where another line begins with (b)

Remarks on the stability of an equilibrium, as they stand in a line beside its equation.

theta = 0, stable for W < c h        theta = pi is unstable        theta = 0 (stable if c b^2 > W l)
stable: theta = 0        it is stable for k > m g/(2 a), unstable otherwise
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

import sympy as sp

from lagrange.answers.limits import MOST_LISTED
from lagrange.answers.references import Reference
from lagrange.answers.written.notation.numbers import in_one_number, plain_unit
from lagrange.answers.written.notation.rare import signs_as_indices
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.units import split_number, unit_of
from lagrange.expressions.characters import ABOUT, GREEK
from lagrange.expressions.edits import Draft, cuts
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.syntax_tree import FUNCTIONS
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.values.dimensions import dimension_of_unit

_STATED = re.compile(r"[\s$]*\\?(?P<name>[^\W\d_]\w{0,12})\s*&?=\s*(?P<value>[-+−]?[0-9][^=]{0,50}?)[\s.,;$]*\Z")
_NUMBER = re.compile(r"[\s$]*[-+−]?[0-9]")


def with_value_in_si(fragment: Fragment, reference: Reference) -> Fragment:
    """`x = 4.9 cm` as x = (4.9)*(1/100); other texts as they are.

    Raises ProblemError at a unit of another dimension.
    """
    match = _STATED.match(fragment.text) if reference.values else None
    if match is None:
        return fragment
    name = "".join(GREEK.get(c, c) for c in match["name"])
    symbol = reference.scope.scalar(reference.scope.spelling(name))
    unit = "N" if is_force(symbol, reference) else reference.units.get(symbol, "")
    if not unit and symbol in reference.unknowns:  # a force or a moment: of N = 240 N the second N is a unit
        unit = (split_number(plain_unit(match["value"])) or ("", ""))[1]
    return _in_si(fragment, match["name"], (match.start("value"), match.end("value")), unit, reference)


def force_in_si(fragment: Fragment, reaction: Reaction, reference: Reference) -> Fragment:
    """`85 N`, stated for a reaction that is a force, as (85); other texts as they are.

    Raises ProblemError at a unit of another dimension.
    """
    if not reference.values or reaction.single is None or not _NUMBER.match(fragment.text):
        return fragment
    return _in_si(fragment, reaction.name, (0, len(fragment.text)), "N", reference)


def is_force(symbol: object, reference: Reference) -> bool:
    """Whether a symbol is that of a reaction that is a single force."""
    reactions = reference.newton.reactions if reference.newton is not None else ()
    return any(
        r.single is not None and ((r.named and symbol == r.force) or symbol == r.symbol_of_force) for r in reactions
    )


def _in_si(fragment: Fragment, name: str, place: tuple[int, int], unit: str, reference: Reference) -> Fragment:
    """The text with the number and unit at a place converted to SI, for units of the expected dimension."""
    written = fragment.text[slice(*place)]
    expected = dimension_of_unit(unit) if unit else None
    parts = split_number(plain_unit(written))
    meant = unit_of(parts[1]) if parts else None
    if expected is None or parts is None or meant is None or meant.is_angle:
        return fragment
    if tuple(map(sp.Integer, meant.dimension)) != tuple(expected):
        if {*re.findall(r"[A-Za-z]+", parts[1])} <= {*reference.scope.scalars} and "\\" not in written:
            return fragment
        message = f"`{parts[1]}` is no unit of `{name}`"
        raise ProblemError(Diagnostic("unit-mismatch", message, fragment.span(*place), help=f"it is in {unit}"))
    latex = is_latex(fragment)
    draft = Draft(fragment)
    draft.apply([(*place, in_one_number(parts[0], meant.factor, latex))])
    return draft.finished(latex=latex)


# Stated values


NUMBER = re.compile(
    r"\s*(?:≈|\\approx)?\s*[-+−]?\s*(?P<number>[0-9]+(?:(?:[.,]|\{,\})[0-9]+)?|[0-9]*\.[0-9]+)"
    r"(?:\s*(?:\\cdot|\\times|\*|·|×)\s*10\s*\^\s*\{?(?P<ten>-?[0-9]{1,3})\}?|[eE](?P<power>-?[0-9]{1,3}))?(?P<unit>[^+=]{0,60})\Z"
)
_UNIT_NAMES = """
m cm mm km dm g kg mg t s ms min h N kN mN J kJ W Pa Hz rad deg rev rpm ft in lb lbf slug mph K Nm Ns SI grad m2 m3
kgm2 units metres meters seconds kilograms newton newtons
"""
_UNITS = frozenset(_UNIT_NAMES.split())
_UNIT_WORDS = re.compile(r"[^\W\d_]+[23]?")
_NO_WORDS = re.compile(r"\\(?:mathrm|text|rm|frac|si|SI|unit|cdot|left|right|quad|,|;|:|!)")


def is_unit(text: str, declared: Collection[str], bare: bool) -> bool:
    """Whether what follows a number is a unit; `bare`: whether there may be none."""
    words = _UNIT_WORDS.findall(_NO_WORDS.sub(" ", text))
    if not words:
        return bare and not text.strip(" .,;$\\{}")
    return all(w in _UNITS for w in words) and (text[0] in " \\~" or not all(w in declared for w in words))


def value_of(number: re.Match[str]) -> sp.Expr:
    """The number that a match of NUMBER states."""
    power = int(number["ten"] or number["power"] or 0)
    return sp.Rational(number["number"].replace("{,}", ".").replace(",", ".")) * sp.Integer(10) ** power


# Listed values


_SEPARATOR = re.compile(
    r",|;|(?<![\w\\])(?:or|and|oder|und)(?![\w'])|\\(?:text|textrm|mbox|mathrm)\s*\{\s*,?\s*(?:or|and|oder|und)\s*\}|\\q?quad(?![A-Za-z])|\\lor(?![A-Za-z])|∨"
)
_EQUALS = re.compile(r"(?<![<>!=:])=(?![=>])")
_WORDS = re.compile(r"(?<!\\)[^\W\d_]{3,}")
_KNOWN = frozenset({*FUNCTIONS, *GREEK.values(), "arcsin", "arccos", "arctan", "left", "right", "frac", "sqrt"})
_SET = re.compile(r"(?:=|∈|\\in(?![A-Za-z]))\s*(?:\\left\s*)?\\?\{(?P<inside>[^{}=]*)\\?\}\s*\Z")
_SEVERAL = re.compile(
    rf"(\\?[A-Za-z]+|[{''.join(GREEK)}])_?(?:\{{\s*|(?=[0-9]\s?,\s?[0-9]\s*=))([0-9])\s*[,/]\s*[0-9](?:\s*,\s*[0-9]){{0,4}}\s*\}}?(?=\s*=)"
)
"""A coordinate with the numbers of several of its values, `\\theta_{3,4}`."""
_PLUS_MINUS = re.compile(r"±|\\pm(?![A-Za-z])|\+/-")


def with_listed_values(fragment: Fragment, declared: Collection[str] = ()) -> Fragment:
    """The text as alternatives `q = a or q = b`; the text itself where it lists none."""
    draft = Draft(fragment)
    if listed := _SET.search(draft.text):
        draft.apply([(listed.start(), listed.start("inside"), "= "), (listed.end("inside"), listed.end(), "")])
    draft.replace(_SEVERAL, lambda m: None if f"{_plain(m[1])}_{m[2]}" in declared else m[1])
    text = draft.text
    if not _EQUALS.search(text):
        return fragment
    latex = is_latex(fragment)
    pieces = [(a, b) for a, b in cuts(text, _SEPARATOR) if text[a:b].strip(" $.~,")]
    sides: list[str] = []
    left = ""
    for a, b in pieces:
        signs = cuts(text[a:b], _EQUALS)
        if len(signs) == 2:
            left = text[a : a + signs[0][1]].strip(" $")
            value = text[a:b].strip(" $")
        elif len(signs) == 1 and left and _is_value(text[a:b]):
            value = f"{left} = {text[a:b].strip(' $.')}"
        else:
            return fragment
        sides.append(value)
    signed = any(_PLUS_MINUS.search(side) for side in sides)
    if signed:
        sides = [_PLUS_MINUS.sub(lambda _, s=sign: s, side) for side in sides for sign in _signs(side)]  # type: ignore[misc]
    stated = all(_EQUALS.search(text[a:b]) for a, b in pieces)
    if not 1 < len(sides) <= MOST_LISTED or (stated and not signed):
        return draft.finished(latex=latex)
    draft.apply([(0, len(text), (r" \text{ or } " if latex else " or ").join(sides))])
    return draft.finished(latex=latex)


def _signs(side: str) -> tuple[str, ...]:
    """+ and −, if a side contains exactly one ±; otherwise the empty sign."""
    return ("+", "-") if len(_PLUS_MINUS.findall(side)) == 1 else ("",)


def _plain(name: str) -> str:
    return "".join(GREEK.get(c, c) for c in name).strip("\\ ")


def _is_value(text: str) -> bool:
    """Whether a text may be a value, and has no words."""
    return all(w.lower() in _KNOWN for w in _WORDS.findall(text)) and not re.search(
        r"[<>≤≥]|\\[gl]eq?(?![A-Za-z])", text
    )


def with_all_values(answer: Sequence[Fragment], declared: Collection[str] = ()) -> list[Fragment]:
    """The same for each of several texts."""
    return [with_listed_values(f, declared) for f in answer]


# Approximations


_ABOUT = re.compile(rf"{ABOUT}|~=")
_EQUALS_OR_TWO = re.compile(r"(?<![<>!:])==?(?![=>])")
_JOINT = re.compile(
    r"[,;]|⇒|⟹|→|==?>|-->?|\\(?:Rightarrow|Longrightarrow|implies|to|rightarrow|q?quad|therefore)(?![A-Za-z])"
    r"|(?<![\w\\])(?:i\.?\s?e\.|d\.\s?h\.|or|so|thus|hence|that is|also|somit|bzw\.|soit|donc)(?!\w)"
)
_ALONE = re.compile(
    rf"(?P<left>[^=<>≤≥≈+]{{0,60}}[\w)}}'])\s*(?P<about>{ABOUT}|~=)"
    r"\s*[-+−]?\s*[0-9]{1,9}\.[0-9]{1,9}[^=≈<>]{0,30}\Z"
)
_PART = re.compile(r"[\s$]*\(\s*(?:(?P<letter>[a-h])|(?P<roman>[ivx]{1,4}))\s*\)\s*(?=[^\s=)*/^+])")
_ROMAN = ("i", "ii", "iii", "iv", "v", "vi", "vii", "viii")


_MARKED = re.compile(
    r"small|approx|lineari[sz]|neglect|taylor|first[ -]order|klein|näherung|≈|\\approx|\\ll|\\gg|<<|>>"
    r"|(?:\\to|\\rightarrow|→|->)\s*(?:0|\\infty|∞)|\blimit(?:ing)?\b|\bspecial case\b|\bwe recover\b|grenzfall",
    re.IGNORECASE,
)
_NEGATED = re.compile(r"\bnot\b|\bwithout\b|n't\b|\bno\b|\bnon-?linear|\bnicht\b|\bohne\b|\bkein", re.IGNORECASE)


def marks_approximation(words: str) -> bool:
    """Whether the words beside an equation say that it is one for small angles, or approximate in another way."""
    return bool(_MARKED.search(words)) and not _NEGATED.search(words)


def is_about(line: str) -> bool:
    """Whether a line gives a number with decimals by `≈` alone."""
    return "=" not in _ABOUT.sub(" ", line) and _ALONE.search(line.strip(" $.,;\r")) is not None


def with_equality(fragment: Fragment) -> Fragment:
    """`theta ≈ 48.2°` as an equation; the fragment itself if it has another sign of equality."""
    if not is_about(fragment.text):
        return fragment
    draft = Draft(fragment)
    draft.replace(_ABOUT, "=")
    return draft.finished(latex=is_latex(fragment))


def exact_results(answer: Sequence[Fragment]) -> tuple[Fragment, ...]:
    """The equations without accompanying matter: part letters, and decimals after exact results."""
    numbered = _parts_numbered([f.text for f in answer])
    return tuple(_alone(f, parts=numbered) for f in answer)


def _alone(fragment: Fragment, *, parts: bool) -> Fragment:
    draft = Draft(fragment)
    signs_as_indices(draft)
    fragment = _finished(draft, fragment)
    text = fragment.text
    start = match.end() if parts and (match := _PART.match(text)) else 0
    return _kept(fragment, start, _end(text))


def _end(text: str) -> int:
    """Where the equation ends, after which another quantity is given approximately."""
    signs = [*_EQUALS_OR_TWO.finditer(text)]
    about = _ABOUT.search(text, signs[-1].end()) if signs else None
    if about is None:
        return len(text)
    joints = [m.start() for m in _JOINT.finditer(text, signs[-1].end(), about.start())]
    return next((at for at in joints if text[signs[-1].end() : at].strip()), len(text))


def _parts_numbered(texts: Sequence[str]) -> bool:
    """Whether two lines begin with letters that follow one another."""
    numbered = [m for text in texts if (m := _PART.match(text))]
    letters = {ord(m["letter"]) for m in numbered if m["letter"]}
    romans = {_ROMAN.index(m["roman"]) for m in numbered if m["roman"] in _ROMAN}
    return any(n + 1 in numbers for numbers in (letters, romans) for n in numbers)


def _kept(fragment: Fragment, start: int, end: int) -> Fragment:
    if (start, end) == (0, len(fragment.text)):
        return fragment
    draft = Draft(fragment)
    draft.keep(start, end)
    return _finished(draft, fragment)


def _finished(draft: Draft, fragment: Fragment) -> Fragment:
    if draft.text == fragment.text:
        return fragment
    return draft.finished(latex=is_latex(fragment))


# Remarks on stability


WHEN = (
    r"(?:(?:only|if\s+and\s+only|precisely|exactly|genau\s+dann|nur)\s+)?(?:iff?|for|when(?:ever)?|where|while|provided(?:\s+that)?"
    r"|(?:as|so)\s+long\s+as|solange|sofern|falls|wenn|für|si|pour|tant\s+que)"
)
"""What introduces the condition of a claim."""
_KIND = r"(?:un|in|not\s+|non-)?(?:stab(?:le|il)|labil)(?:e[nrs]?)?|(?:marginally|neutrally)\s+stable"
_CONDITION = (
    rf",?\s+{WHEN}\s+"
    r"[^;\n,=<>≤≥]{1,80}?(?:[<>]=?|[≤≥])[^;\n,=<>≤≥]{1,80}?"
    r"(?=\s*(?:[,;\n]|\Z|\.(?:\s|\Z)|\s(?:and|but|or|otherwise|else|while|whereas|und|aber|sonst)\s))"
)
_OTHERWISE = (
    r"(?:\s*(?:[,;]|\band\b|\bund\b)?\s*"
    r"(?:otherwise\s+(?:un)?stable|(?:un)?stable\s+otherwise|(?:un)?stable\s+if\s+not))?"
)
STABILITY = re.compile(
    rf"\(\s*(?:[^()=<>]{{0,40}}\s)?(?:{_KIND})(?![^\W\d_])(?:[^()=]|\([^()=]{{0,60}}\)){{0,120}}\)"
    rf"|(?:[,;]\s*|(?<=[\s\w)}}°²³])\s|^\s*)(?:(?:and|but)\s+)?(?:(?:which|that|this|it|this\s+(?:one|position))\s+)?"
    rf"(?:(?:is|are|ist|sind)\s+)?(?:always\s+|only\s+|an?\s+)?(?:{_KIND})(?![^\W\d_])"
    rf"(?:\s+(?:equilibrium|position|one)s?(?:\s+(?:at|for|is)(?=\s+[^\s<>≤≥]+\s*=))?)?(?:{_CONDITION})?{_OTHERWISE}\s*[:,]?",
    re.IGNORECASE,
)

_OF_IT = re.compile(
    r"(?:^|[,.;])\s*(?:(?:so|hence|thus|therefore|and)\s+)?(?:this|that|it|the)"
    r"(?:\s+(?:equilibrium|position|one|state|point)(?:\s+of\s+(?:equilibrium|rest))?)?"
    rf"\s+is\s+(?:therefore\s+|thus\s+|always\s+)?(?:an?\s+)?(?:{_KIND})(?![^\W\d_])",
    re.IGNORECASE,
)


_CONDITION_FIRST = re.compile(
    rf"\A\s*(?P<when>{WHEN})\s+(?P<condition>[^=;\n<>≤≥]{{1,80}}?(?:[<>]=?|[≤≥])[^=;,\n<>≤≥]{{1,80}}?)"
    r"(?:,\s*(?:then\s+)?|\s+(?=(?:is|ist|then|the|die)\s))(?:(?:is|ist|then|the|die)\s+)*(?:(?:position|equilibrium|Lage)\s+)?"
    rf"(?P<place>[^=<>≤≥;,]{{1,40}}=[^=<>≤≥;,]{{1,60}}?)\s+(?P<said>(?:(?:is|ist)\s+)?(?:{_KIND}))[\s.]*\Z",
    re.IGNORECASE,
)
_STABILITY_OF = re.compile(
    r"\A\s*(?:stability|stabilität|stabilité)\s+(?:of|at|for|von|bei|de)\s+(?P<place>[^=<>≤≥;:]{1,40}=[^=<>≤≥;:]{1,60}?)\s*:"
    r"\s*(?:if|for|when)?\s*(?P<condition>[^=;\n<>≤≥]{1,80}?(?:[<>]=?|[≤≥])[^=;,\n<>≤≥]{1,80})\Z",
    re.IGNORECASE,
)


def with_claim_last(fragment: Fragment) -> Fragment:
    """`If W l < c b^2, theta = 0 is stable` as `theta = 0 is stable if W l < c b^2`."""
    text, draft = fragment.text, Draft(fragment)
    if first := _CONDITION_FIRST.match(text):
        draft.apply([(0, len(text), f"{first['place']} {first['said']} {first['when']} {first['condition']}")])
    elif of := _STABILITY_OF.match(text):
        draft.apply([(0, len(text), f"{of['place']} is stable for {of['condition']}")])
    else:
        return fragment
    return draft.finished(latex=is_latex(fragment))


def stability_of_it(line: str) -> str:
    """What a sentence says of the stability of the position before it: `This equilibrium is stable.`"""
    said = None if "=" in line.replace("<=", "").replace(">=", "") else _OF_IT.search(line)
    return "" if said is None else line[said.start() :].strip(" ,.;$\n").replace("$", " ")


CONDITIONAL = re.compile(
    r"\(\s*(?:[^()=<>≤≥]{0,40}\s)?(?:if|for|when|exists?|only|where|falls|nur|wenn|für|provided|needs?|requires?|possible|assuming|since|because|as|valid)(?![^\W\d_])"
    r"(?:[^()=]|\([^()=]{0,60}\)){0,80}[<>≤≥](?:[^()]|\([^()]{0,60}\)){1,80}\)"
    r"|,\s*(?:(?:which|this|it)\s+)?(?:only\s+)?(?:exists?|(?:is\s+)?(?:possible|real)|existiert|gibt\s+es|existe)\s+(?:only\s+|nur\s+|seulement\s+)?"
    r"(?:iff?|for|when|where|as\s+long\s+as|provided(?:\s+that)?|falls|wenn|für|si|pour)\s[^=;,<>≤≥]{1,60}[<>≤≥][^=;,<>≤≥]{1,60}?(?=\s*(?:[,;]|\.?\s*\Z|\.\s))"
)
"""A condition of existence after an equation, which is not judged: `(only if W l < c b²)`, `exists for c < b`."""


_RESULT_AT_A_PLACE = re.compile(
    r"(?P<result>(?<![\w\\'])(?:omega|[ωΩ]|w|f|T)(?:_?\w{1,3})?(?:\s*\^\s*2|²)?\s*=\s*[^=;,:'\u0308¨]{1,80}?)"
    r"\s*,?\s+(?:at|about|around|near|for|bei|um|für)\s+(?:the\s+equilibrium\s+)?"
    r"(?P<place>(?:(?:cos|sin|tan)\s*\(?\s*)?[^\W\d]\w{0,12}\s*\)?\s*=\s*[^=;,:]{1,40}?)(?=\s*(?:;|\.?\s*\Z|,\s|\.\s|\band\b|\bund\b))"
)


def with_place_first(fragment: Fragment) -> Fragment:
    """`ω = sqrt(g/R - Ω²) at θ = 0` as `θ = 0: ω = sqrt(g/R - Ω²)`."""
    if "=" not in fragment.text or is_latex(fragment):
        return fragment
    draft = Draft(fragment)
    changed = draft.replace(_RESULT_AT_A_PLACE, lambda m: f"{m['place'].strip()}: {m['result'].strip()}")
    return draft.finished() if changed else fragment


_STAR = re.compile(
    r"(?<=[\w)}])\s?\*(?=\s*&?=(?!=))|\s*[_^]\s*(?:\{\s*)?(?:\*|\\ast(?![A-Za-z])|\\star(?![A-Za-z]))(?:\s*\})?(?=\s*&?=(?!=))"
)
"""The mark of a particular value: `v* = ...`, `\\theta^* = ...`."""


def without_star(fragment: Fragment) -> Fragment:
    """`cos θ* = 2/3` as cos θ = 2/3."""
    if "=" not in fragment.text:
        return fragment
    draft = Draft(fragment)
    if not draft.replace(_STAR, ""):
        return fragment
    return draft.finished(latex=is_latex(fragment))
