r"""Rare notations: names and functions common in values, the derivative as an operator D, ratios and tuples.

Notations of names and functions that are rare in equations of motion but common in values.

m1, θ1                              m_1, theta_1, where these are declared and the others are not
∛(c/b)                              (c/b)^(1/3)
arcosh(x), acosh(x), \cosh^{-1} x   log(x + sqrt(x^2 - 1)), and so for the other inverse hyperbolic functions
v_\infty, v_{\max}                  v_{inf}, v_{max}
∫ i dt, with i = q'                 q
ω_+ = ..., \omega_- = ...           ω_plus = ..., \omega_{minus} = ...

The time derivative as an operator D: `D^2 x`, `D x`, `(D phi)^2`, `D(m r^2 D phi)`, `(m D^2 + b D + c) x`.

An operator before brackets is applied to their contents; one before a name, to that name; a sum with operators in
brackets is applied to the name or the brackets after it, term by term. D is an operator only where the problem declares
no `D`.

Equations between ratios and between tuples, and the greatest and the least of several values.

h : R = 5 : 2                      (h)/(R) = (5)/(2)
A_1 : A_2 : A_3 = 1 : 2 : 1        (A_1)/(A_2) = (1)/(2),  (A_2)/(A_3) = (2)/(1)
N / W = 1 : 2                      N / W = (1)/(2)
max(a, b), min(a, b)               (a + b + |a - b|)/2, (a + b - |a - b|)/2
max(T) = ...                       T_max = ...
(x, y) = (0, 0), (a, b)            [x, y] = [0, 0],  [x, y] = [a, b]
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from lagrange.answers.limits import LONGEST_REPEATED, MOST_IN_A_RATIO, MOST_OPERATORS
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.expressions.edits import Draft, Edit, closings, cuts
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role

_INDEX = re.compile(
    rf"(?:(?<![A-Za-z0-9_])(?P<name>[A-Za-z]+)|(?P<greek>[{''.join(GREEK)}]))(?P<index>[0-9]{{1,2}})(?![A-Za-z0-9_.])"
)
_CUBE_ROOT = re.compile(r"∛\s*(?:(?=\()|(?P<simple>[0-9]+|[^\W\d_]))")
_INVERSE = re.compile(
    r"(?<![A-Za-z\\])(?:ar?c?(?P<name>sinh|cosh|tanh)|(?P<power>sinh|cosh|tanh)\s*\^\s*[({]?\s*[-−]\s*1\s*[)}]?)\s*(?=\()"
)
_INVERSE_LATEX = re.compile(
    r"\\(?:operatorname\*?\s*\{\s*ar?c?(?P<named>sinh|cosh|tanh)\s*\}|(?:mathrm|text|rm)\s*\{\s*ar?c?(?P<upright>sinh|cosh|tanh)\s*\}"
    r"|ar?c?(?P<name>sinh|cosh|tanh)(?![A-Za-z])|(?P<power>sinh|cosh|tanh)\s*\^\s*\{\s*-\s*1\s*\})\s*(?:\\left|\\[bB]igg?l?)?\s*(?=\()"
)
_COMMAND_AS_INDEX = re.compile(
    r"_\s*(?:\\(?P<plain>infty|max|min|star)(?![A-Za-z])|\{\s*\\(?P<braced>infty|max|min|star)\s*\})"
)
_SIGN_AS_INDEX = re.compile(
    r"_(?:\{\s*)?(?P<sign>[+−-]|\\pm(?![A-Za-z])|±)(?:\s*\})?(?=\s*(?:\^\s*\{?2\}?|²)?\s*&?(?:=|\Z))"
)
_HALF_AS_INDEX = re.compile(r"_(?:1/2|½|\{\s*(?:1/2|½|\\[dt]?frac\s*\{?1\}?\s*\{?2\}?)\s*\})(?=\s*&?=)")
_BARE_INDEX = re.compile(r"_(max|min|tot|end|top|side|crit|res|eff)(?![A-Za-z])")
"""An index of several letters without its braces, which TeX would not print as it is meant."""
_WRITTEN_OUT = {
    "sinh": "log(({x}) + sqrt(({x})^2 + 1))",
    "cosh": "log(({x}) + sqrt(({x})^2 - 1))",
    "tanh": "(log((1 + ({x}))/(1 - ({x})))/2)",
}


_INTEGRAL = re.compile(
    r"(?:∫|\\int(?![A-Za-z_^])(?:\\limits)?)\s*(?P<rate>\\dot\s*(?:\{\s*\\?[A-Za-z]+\s*\}|\\?[A-Za-z]+)|[A-Za-z](?:_\w{1,4})?['\u0307]?)\s*"
    r"(?:\\[,;:! ]|~|\s)*(?:d|\\mathrm\s*\{\s*d\s*\})\s?t(?![A-Za-z])"
)
_IS_RATE_OF = (
    r"(?<![A-Za-z]){name}\s*=\s*(?:\\dot\s*\{{?\s*|d\s?|\\[dt]?frac\s*\{{\s*d\s?)?"
    r"(?P<of>[A-Za-z]+)(?:['\u0307]|\s*\}}?\s*(?:/|\{{)?\s*d?t?)"
)


def integrals_over_time(texts: Sequence[str], coordinates: Sequence[str]) -> list[str]:
    """`∫ i dt` as q, where i is the rate of the coordinate q: one says so, or there is no other."""
    whole = "\n".join(texts)

    def integrated(match: re.Match[str]) -> str:
        rate = re.sub(r"\\dot|[{}\\\s'\u0307]", "", match["rate"])
        if rate in coordinates:
            return f" {rate} " if rate != match["rate"] else match[0]
        stated = re.search(_IS_RATE_OF.format(name=re.escape(rate)), whole)
        if stated is not None and stated["of"] in coordinates:
            return f" {stated['of']} "
        return f" {coordinates[0]} " if len(coordinates) == 1 and stated is None else match[0]

    return [_INTEGRAL.sub(integrated, text) if "∫" in text or "\\int" in text else text for text in texts]


def signs_as_indices(draft: Draft) -> None:
    """Name what has a sign, or a half, as its index, on the left of an equation."""
    latex = "\\" in draft.text
    draft.replace(_HALF_AS_INDEX, "_{half}" if latex else "_half")
    draft.replace(
        _SIGN_AS_INDEX,
        lambda m: ("_{%s}" if latex else "_%s") % {"+": "plus", "-": "minus", "−": "minus"}.get(m["sign"], "pm"),
    )


def special(draft: Draft, scope: Scope) -> None:
    """Rewrite the notations of plain text."""
    draft.replace(_CUBE_ROOT, lambda m: f"({m['simple']})^(1/3) " if m["simple"] else None)
    draft.apply(_cube_roots(draft.text))
    draft.apply(_inverses(draft.text, _INVERSE, _WRITTEN_OUT))
    draft.replace(_INDEX, lambda m: _with_index(m, scope))


def with_indices(fragment: Fragment, scope: Scope) -> Fragment:
    """`x1 = ...` as x_1 = ..., so that it does not define a new name."""
    if is_latex(fragment) or not _INDEX.search(fragment.text):
        return fragment
    draft = Draft(fragment)
    draft.replace(_INDEX, lambda m: _with_index(m, scope))
    return draft.finished()


def special_latex(draft: Draft) -> None:
    """Rewrite the notations of LaTeX."""
    draft.replace(_COMMAND_AS_INDEX, lambda m: f"_{{{(m['plain'] or m['braced'])[:3]}}}")
    draft.replace(_BARE_INDEX, r"_{\1}")
    in_latex = {n: e.replace("log", r"\ln").replace("sqrt((", r"\sqrt{((") for n, e in _WRITTEN_OUT.items()}
    in_latex = {n: e.replace("^2 + 1))", "^2 + 1})").replace("^2 - 1))", "^2 - 1})") for n, e in in_latex.items()}
    draft.apply(_inverses(draft.text, _INVERSE_LATEX, in_latex))


def _with_index(match: re.Match[str], scope: Scope) -> str | None:
    """`m1` as m_1."""
    name = match["name"] or GREEK[match["greek"]]
    made = f"{name}_{match['index']}"
    known = scope.role(f"{name}{match['index']}") is not Role.UNDECLARED
    return None if known or scope.role(made) is Role.UNDECLARED else f" {made}"


def _cube_roots(text: str) -> Iterator[Edit]:
    ends: dict[int, int] | None = None
    for match in _CUBE_ROOT.finditer(text):
        ends = closings(text) if ends is None else ends
        if (end := ends.get(match.end())) is not None:
            yield match.start(), match.end(), ""
            yield end + 1, end + 1, "^(1/3)"


def _inverses(text: str, pattern: re.Pattern[str], forms: dict[str, str]) -> Iterator[Edit]:
    """Inverse hyperbolic functions by logarithms."""
    ends: dict[int, int] | None = None
    for match in pattern.finditer(text):
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        if end is not None and end - match.end() < LONGEST_REPEATED:
            name = next(filter(None, match.groups()))
            inside = re.sub(r"\\right\s*\Z", "", text[match.end() + 1 : end])
            yield match.start(), end + 1, forms[name].replace("{x}", inside)


# The operator D


_POWER = r"(?:\s*(?:\^\s*\{?\s*|\*\*)(?P<order>[1-3])\s*\}?|(?P<raised>[²³]))?"
_D = re.compile(rf"(?<![A-Za-z0-9_'.\\])(?:\\(?:mathrm|operatorname)\{{D\}}|D){_POWER}(?:\s*\*\s*(?=[A-Za-z(]))?")
_NAME = re.compile(
    rf"\s*(?P<name>\\?(?:[{''.join(GREEK)}]|[A-Za-z]+)(?:_\{{[A-Za-z0-9]{{1,8}}\}}|[A-Za-z0-9_{''.join(SUBSCRIPTS)}])*)(?![A-Za-z0-9_(\[])"
)
_JOINED = re.compile(rf"(?<![A-Za-z0-9_'.\\])D(?=[{''.join(GREEK)}]|\\[a-z])")
_BRACKET = re.compile(r"\s*(?=\()")
_SIGN = re.compile(r"(?<=[^\s(])\s*[+−-](?!\Z)")


def with_operators(draft: Draft, names: frozenset[str]) -> None:
    """Write the operators as derivatives; `names` are those that D and D^2 may be attached to, as in `Dx`."""
    if "D" not in draft.text:
        return
    if names:
        joined = re.compile(rf"(?<![A-Za-z0-9_'.\\])D(?=(?:{'|'.join(map(re.escape, sorted(names)))})(?![A-Za-z0-9_]))")
        draft.replace(joined, "D ")
    draft.replace(_JOINED, "D ")
    for _ in range(MOST_OPERATORS):
        if not (draft.apply(_polynomials(draft.text)) or draft.apply(_last(draft.text))):
            return


def _order(match: re.Match[str]) -> int:
    return int(match["order"] or {"²": 2, "³": 3}.get(match["raised"] or "", 1))


def _last(text: str) -> Iterator[Edit]:
    """The last operator, which is applied to a name or to brackets."""
    matches = [*_D.finditer(text)]
    if not matches:
        return
    match = matches[-1]
    order = _order(match)
    if name := _NAME.match(text, match.end()):
        yield match.start(), name.end(), f"{'diff(' * order}{name['name']}{', t)' * order}"
    elif _BRACKET.match(text, match.end()):
        opening = text.index("(", match.end())
        end = closings(text).get(opening)
        if end is not None and "," not in text[opening:end].replace(", t)", ""):
            yield match.start(), opening, "diff(" * order
            yield end + 1, end + 1, ", t)" * order


def _polynomials(text: str) -> Iterator[Edit]:
    """`(m D^2 + c) x` as m D^2 x + c x."""
    ends: dict[int, int] | None = None
    for match in _D.finditer(text):
        if _NAME.match(text, match.end()) or _BRACKET.match(text, match.end()):
            continue
        ends = closings(text) if ends is None else ends
        around = [(s, e) for s, e in ends.items() if s < match.start() < e and text[s] == "("]
        if not around:
            continue
        start, end = max(around)
        name = _NAME.match(text, end + 1)
        bracket = _BRACKET.match(text, end + 1)
        if name is None and (bracket is None or bracket.end() not in ends):
            continue
        stop = name.end() if name else ends[bracket.end()] + 1  # type: ignore[union-attr]
        operand = text[end + 1 : stop].strip()
        terms = _terms(text[start + 1 : end])
        if len(terms) > MOST_OPERATORS or any(len(_D.findall(term)) > 1 for term in terms):
            continue
        yield start, stop, f"({' '.join(_applied(term, operand) for term in terms)})"
        return


def _terms(inside: str) -> list[str]:
    places = [start for start, _ in cuts(inside, _SIGN)]
    starts = [0, *(m.start() for m in _SIGN.finditer(inside) if any(m.end() == p for p in places)), len(inside)]
    return [inside[a:b].strip() for a, b in pairwise(starts)]


def _applied(term: str, operand: str) -> str:
    match = _D.search(term)
    if match is None:
        return f"{term} {operand}"
    factor, order = f"{term[: match.start()]} {term[match.end() :]}".strip(), _order(match)
    joint = " " if factor and factor[-1] not in "+-−*/" else ""
    return f"{factor}{joint}{'diff(' * order}{operand}{', t)' * order}"


# Ratios


_EQUALS = re.compile(r"(?<![<>!=:])==?(?![=>])")
_COLON = re.compile(r"\\colon(?![A-Za-z])|(?<!:):(?![=:])|∶")
_WORD = re.compile(r"(?<![\\\w])[^\W\d_]{4,}(?![\w(])")
_EXTREME = re.compile(r"(?<![A-Za-z0-9_\\])\\?(max|min|Max|Min)\s*(?=[(\[{])")
_OF_A_NAME = re.compile(
    r"\s*\$?\s*\\?(?P<which>max|min|Max|Min)\s*(?:\(|\\left\s*\(|\{)\s*\|?(?P<name>\\?[A-Za-zα-ωΑ-Ω]{1,8})\|?\s*(?:\)|\\right\s*\)|\})\s*(?==)"
)


def ratios_of(text: str) -> list[str]:
    """The equations that an equation between ratios states; none if it is no such equation."""
    if not _COLON.search(text):
        return []
    sides = cuts(text, _EQUALS)
    if len(sides) != 2:
        return []
    left, right = (_members(text[start:end]) for start, end in sides)
    if len(right) < 2:
        return []
    if len(left) == len(right) + 1 and _WORD.search(left[0]):  # a label before the ratio
        left = left[1:]
    if len(left) == 1 and len(right) == 2:
        return [f"{left[0]} = ({right[0]})/({right[1]})"]
    if len(left) != len(right) or len(left) > MOST_IN_A_RATIO or any(map(_WORD.search, (*left, *right))):
        return []
    pairs = zip(left, left[1:], right, right[1:], strict=False)
    return [f"({a})/({b}) = ({c})/({d})" for a, b, c, d in pairs]


_TUPLE = re.compile(r"\(\s*[^()=]+(?:\([^()]*\)[^()=]*)*\)")
_TUPLES = re.compile(
    rf"\s*(?P<names>\((?:[^()=,]+,)+[^()=,]+\))\s*=\s*(?P<values>{_TUPLE.pattern}(?:\s*(?:,|;|or|and|oder|und)\s*{_TUPLE.pattern})*)[\s.]*\Z"
)


def tuples_of(text: str) -> list[str]:
    """`(x, y) = (0, 0), (1, 2)` as one equation between lists for each value; none if it is no such equation."""
    match = _TUPLES.match(text)
    if match is None:
        return []
    comma = re.compile(",")
    names = match["names"][1:-1]
    values = [
        match["values"][a + 1 : b] for a, b in closings(match["values"]).items() if _depth(match["values"], a) == 0
    ]
    number = len(cuts(names, comma))
    if not 2 <= number <= 3 or any(len(cuts(v, comma)) != number for v in values):
        return []
    if len(values) == 1:
        pairs = zip(cuts(names, comma), cuts(values[0], comma), strict=True)
        return [f"{names[a:b].strip()} = {values[0][c:d].strip()}" for (a, b), (c, d) in pairs]
    return [f"[{names}] = [{v}]" for v in values]


def _depth(text: str, at: int) -> int:
    return text.count("(", 0, at) - text.count(")", 0, at)


def ratio_as_fractions(text: str) -> Iterator[Edit]:
    """One equation between two ratios as one between fractions."""
    made = ratios_of(text) if ":" in text or "\\colon" in text else []
    if len(made) == 1:
        yield 0, len(text), made[0]


def _members(side: str) -> list[str]:
    """The members of a ratio; none if one of them is empty."""
    members = [side[start:end].strip(" $&~") for start, end in cuts(side, _COLON)]
    return members if all(members) else []


def name_of_extreme(text: str) -> str:
    """`max(T) = ...` as `T_max = ...`; the text itself where it is no such line."""
    match = _OF_A_NAME.match(text)
    if match is None:
        return text
    index = match["which"].lower()
    return (
        f"{match['name']}_{{{index}}} " + text[match.end() :]
        if "\\" in text
        else f"{match['name']}_{index} " + text[match.end() :]
    )


def extremes(text: str, *, latex: bool = False) -> Iterator[Edit]:
    """The greatest and the least of two to four values, by absolute values; of one, the value itself."""
    ends: dict[int, int] | None = None
    for match in _EXTREME.finditer(text):
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        if end is None:
            continue
        inside = text[match.end() + 1 : end]
        values = [re.sub(r"\\(?:left|right|\{|\})\s*\Z", "", inside[a:b]) for a, b in cuts(inside, re.compile(","))]
        if len(values) > MOST_IN_A_RATIO or not all(v.strip() for v in values) or len(inside) > 200:
            continue
        made, sign = f"({values[0]})", "+" if match[1].lower() == "max" else "-"
        bars = (r"\left|", r"\right|") if latex else ("abs(", ")")
        for value in values[1:]:
            made = f"(({made}+({value}){sign}{bars[0]}{made}-({value}){bars[1]})/2)"
        yield match.start(), end + 1, made
