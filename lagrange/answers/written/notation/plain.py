r"""Other notations of an equation, rewritten in the language of expressions: nothing here is ever run as code.

    d/dt(e)   d^2θ/dt^2   dU/dr   ∂L/∂θ'               diff(e, t)   θ''   diff(U, r)   diff(L, θ')
    dθ'/dθ   x(t).diff(t, 2)   e^(-k t)   30 deg       θ''/θ'   diff(x, t, 2)   exp(-k t)   30*pi/180
    δx   dx                                            delta(x)   d(x)
    ddot(x)   x_ddot   x''[t]   D(x)(t)   θ¨           x''          x''   x''          x'   θ''
    Derivative(x(t), (t, 2))   diff(x(t), t$2)         diff(x, t, t)
    Sin[x]   arctan(x)   sgn(x)                        sin(x)   atan(x)   sign(x)
    mgl sinθ                                           m*g*l sin θ, where m, g, l are declared

A name that the problem declares keeps its meaning. Each rule is one pass over the text.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from unicodedata import normalize

from lagrange.answers.written.notation.numbers import units_in_si
from lagrange.answers.written.notation.programs import as_functions
from lagrange.answers.written.notation.rare import extremes, special, with_operators
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.expressions.edits import Draft, Edit, closings, cuts
from lagrange.expressions.latex_names import NAMED_FUNCTIONS, LatexNames
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import FUNCTIONS, OPERATIONS, Role

_INVISIBLE = {"\u2061": "", "\u2062": " ", "\u2063": ",", "\u2064": "+",
    "〖": "(", "〗": ")", "⟨": "(", "⟩": ")",
    "▒": "", "┤": ")", "├": "(", "′": "'", "´": "'", "`": "'", "‘": "'", "“": "''", "”": "''", "＝": "=",
    "⁄": "/", "≡": "=", "≔": "=", "≝": "=", "•": "*", "✕": "*", "∙": "*", "—": "-", "﹣": "-"}  # fmt: skip
_ODD = re.compile(f"[{''.join(_INVISIBLE)}]")
_QUOTED = re.compile(r'(?<=[\w)])"(?!\w)')
_SPACING_DOTS = re.compile("[¨˙]|\u00b4\u00b4")
_BLANK_DOTS = re.compile("(?<=[^\\W\\d_])[ \u00a0]+(?=[\u0307\u0308\u20db])")
_DOTS_OF_WORD = re.compile(
    rf"(?:(?P<bracket>\()\s*)?(?<![A-Za-z0-9_])(?P<letter>[{''.join(GREEK)}A-Za-z])(?P<index>_[0-9A-Za-z]{{1,2}})"
    "\\s*(?(bracket)\\)\\s*|[ \u00a0]+)(?P<dot>[\u0307\u0308])"
)
"""Word's linear form of a rate with an index: `θ_2 ̈`, `(θ_2 ) ̇`."""
_NAME = rf"(?:[{''.join(GREEK)}]|[A-Za-z]+)(?:_?\{{[A-Za-z0-9]{{1,8}}\}}|[A-Za-z0-9_{''.join(SUBSCRIPTS)}])*"
_POWER = r"(?:\s*\^\s*\{?\s*([1-4])\s*\}?|([²³])|\*\*([1-4]))?"
_RATE = re.compile(
    rf"(?<![A-Za-z0-9_'])[dⅆ∂]{_POWER}\s*(?P<name>{_NAME})(?P<dots>['\u0307\u0308]*)(?:\(t\))?\s*/\s*"
    rf"\(?\s*[dⅆ∂]\s*(?P<by>{_NAME})(?P<more>['\u0307\u0308]*)(?:\s*\^\s*\{{?\s*[1-4]\s*\}}?|[²³]|\*\*[1-4])?\s*\)?(?!\s*\()"
)
_OPERATOR = re.compile(
    rf"(?<![A-Za-z0-9_'])\(?[dⅆ∂]{_POWER}\s*/\s*\(?\s*[dⅆ∂]\s*(?P<by>{_NAME})(?P<more>['\u0307\u0308]*)"
    r"(?:\s*\^\s*\{?\s*[1-4]\s*\}?|[²³]|\*\*[1-4])?\s*\)?"
)
_RATE_OF_BRACKET = re.compile(r"(?<![A-Za-z0-9_'/])d\s?(?=\()")
_BY_TIME = re.compile(r"\s*/\s*\(?\s*dt\b(?!\s*\()")
_GREEK_INDEX = re.compile(rf"(?<=[A-Za-z{''.join(GREEK)}]_)[{''.join(GREEK)}]")
_MOMENTUM = re.compile(rf"(?<![A-Za-z0-9_])p(?=[{''.join(GREEK)}])")
_VARIATION = re.compile(rf"δ\s*(?P<name>{_NAME})(?!\s*\()")
_DIFFERENTIAL = re.compile(rf"(?<![A-Za-z0-9_'])d\s?(?P<name>{_NAME})(?![A-Za-z0-9_'(])")
_DISPLACED = re.compile(r"(?<![A-Za-z0-9_'/])(d|δ|delta)\s?(?=\()(?!d\(t\))")
_NAMES = re.compile(rf"(?<![A-Za-z0-9_]){_NAME}")
_ORDERS = {"²": 2, "³": 3}
_DOTTED = re.compile(r"(?<![A-Za-z0-9_])(d{1,3})ot\s*(?=\()")
_SUFFIX = re.compile(
    rf"(?<![A-Za-z_])(?P<name>(?:[{''.join(GREEK)}]|[A-Za-z]{{1,12}}?)[A-Za-z0-9_{''.join(SUBSCRIPTS)}]{{0,8}}?)(?:_?(?P<dots>(?:dot){{1,3}}|d{{1,3}}ot)|_(?P<short>d{{1,2}}|t{{1,2}})|(?P<joined>d{{1,2}}|D{{1,2}}))(?P<index>_?[0-9]{{1,2}})?(?![A-Za-z0-9_(])"
)
_PREFIX = re.compile(rf"(?<![A-Za-z0-9_'])(?P<dots>dd|d2|d{{1,2}}ot_?)(?P<name>{_NAME})(?![A-Za-z0-9_'(])")
_MODULE = re.compile(r"(?<![A-Za-z0-9_.)\]])(?:np|numpy|math|sp|sym|sympy|mpmath)\.(?=[A-Za-z])")
_BY_VELOCITY = re.compile(rf",\s*diff\(\s*({_NAME})(?:\(\s*t\s*\))?\s*,\s*t\s*\)\s*\)")
_RATIONAL = re.compile(r"\bRational\(\s*([0-9]{1,6})\s*,\s*([0-9]{1,6})\s*\)")
_SMALL_FRACTION = re.compile(r"(?<![\w)\]])([⁰¹²³⁴-⁹]{1,3})[⁄∕/]([₀-₉]{1,3})")
"""A fraction of small digits, `⁴⁄₃`."""
_ITALIC = re.compile("[\u210e\U0001d400-\U0001d7ff]+")
_DOTS_BEFORE_INDEX = re.compile(f"(?<=[^\\W\\d_])([¨˙])([0-9{''.join(SUBSCRIPTS)}]{{1,2}})")
_INDEXED = re.compile(
    rf"((?<![A-Za-z0-9_])[A-Za-z]+|[{''.join(GREEK)}])([\u0307\u0308]?)_(?:\{{([0-9]{{1,2}})\}}|([0-9]{{1,2}})(?![A-Za-z0-9_]))"
)
_INVERSE = re.compile(r"(?<![A-Za-z])(sin|cos|tan)\s*(?:\^\s*[({]\s*[-−]\s*1\s*[)}]|⁻¹)")
_DERIVATIVE = re.compile(r"(?<![A-Za-z0-9_])(?:Derivative|Diff)\s*(?=\()")
_MATLAB = re.compile(
    rf"(?<![A-Za-z0-9_])diff\s*\(\s*(?P<name>{_NAME})\s*(?:\(\s*t\s*\))?\s*(?:,\s*(?P<order>[1-4])\s*)?\)"
)
_TIMES = re.compile(r",\s*\(\s*([A-Za-z_0-9]+)\s*,\s*([1-4])\s*\)")
_DOLLAR = re.compile(r"\$\s*([1-4])")
_BRACES_OF_TIME = re.compile(r",\s*\{\s*(t)\s*,\s*([1-4])\s*\}")
_MAPLE = re.compile(rf"\(?\bD(?:\s*@@\s*([1-3]))?\)?\s*\(\s*({_NAME})\s*\)\s*\(\s*t\s*\)")
_DERIVED = re.compile(rf"\bDerivative\[([1-3])\]\[({_NAME})\]\[t\]")
_OF_TIME = re.compile(r"(?<=[\w'])\[\s*t\s*\]")
_APPLIED = re.compile(r"(?<![A-Za-z0-9_])(Arc(?:Sin|Cos|Tan)|[A-Z][a-z]{1,7}|D)\s*(?=\[)")
_CALLED = re.compile(
    r"(?<![A-Za-z0-9_\\])(arcsin|arccos|arctan2?|Arcsin|Arccos|Arctan|sgn|Sgn|ln|Sin|Cos|Tan|Cot|Exp|Sqrt)(?![a-z_0-9])"
)
_ARCTAN = re.compile(r"(?<![A-Za-z0-9_\\])arctan(?=\()")
_COMMA = re.compile(r",")
_CALLS = {
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctan2": "atan2",
    "sgn": "sign",
    "ln": "log",
    "arccot": "acot",
}
_ELEMENTWISE = re.compile(r"\.(?=[*/^])")
_DER = re.compile(r"(?<![A-Za-z0-9_])der\s*(?=\()")
_SPOKEN = re.compile(
    rf"(?<![A-Za-z0-9_])(?P<name>{_NAME})\s+(?P<dots>double[- ]?dot|dot\s+dot|dot)(?![A-Za-z0-9_]|\s*\()"
)
_RUN = re.compile(r"(?<![A-Za-z_.])(?<![A-Za-z_][0-9])(?<![A-Za-z_][0-9][0-9])[A-Za-z][A-Za-z0-9_]*")
_DEGREES = re.compile(r"(?<=[0-9])\s*(?:°|\b(?:deg|degs|degrees?|Grad)\b)|(?<=[0-9])\s+(?:rad|radians?)\b")
_DEGREES_OF_FUNCTION = re.compile(
    r"(?<![A-Za-z])(sin|cos|tan|cot|sec|csc) *([0-9]+(?:\.[0-9]+)?)\s*(?:°|(?:deg|degs|degrees?)\b)"
)
_EXPONENTIAL = re.compile(
    rf"(?<![A-Za-z0-9_'])(?P<e>[eE])\s*(?:\^|\*\*)\s*(?:(?=[({{])|(?P<power>-?\s*(?:[0-9]+|{_NAME})))"
)
_AFTER_FUNCTION = re.compile(r"(?<![A-Za-z])(?:sin|cos|tan|cot|exp)\s*\Z")
_CLOSED_POWER = re.compile(r"\s*(?:\^\s*[0-9]{1,2}|[²³])")
_IN_RADIANS = "*pi/(2*90)"
"""A number with three digits, 180, would count as rounded."""


def rewritten(fragment: Fragment, scope: Scope) -> Fragment:
    """A plain text with other notations written in that of the language; the text itself where there are none."""
    draft = Draft(fragment)
    characters(draft)
    special(draft, scope)
    draft.replace(_DEGREES_OF_FUNCTION, lambda m: f"{m[1]}({m[2]}{_IN_RADIANS})")  # cos 20° − 2 is no product
    draft.apply(units_in_si(draft.text, scope))
    draft.replace(_DEGREES, lambda m: None if _is_declared_unit(m[0], scope) else "" if "rad" in m[0] else _IN_RADIANS)
    draft.apply(_exponentials(draft.text, scope))
    draft.replace(_MAPLE, lambda m: m[2] + "'" * int(m[1] or 1))
    draft.replace(_DERIVED, lambda m: m[2] + "'" * int(m[1]))
    draft.replace(_OF_TIME, "")
    draft.apply(_called_with_brackets(draft.text, scope))
    draft.apply(_of_two(draft.text))
    draft.replace(_CALLED, lambda m: _function(m[1]) if scope.role(m[1]) is Role.UNDECLARED else None)
    draft.apply(_grouping(draft.text))
    draft.replace(_ELEMENTWISE, "")
    draft.replace(_DERIVATIVE, "diff")
    draft.replace(_MATLAB, lambda m: f"diff({m['name']}, t{',' if m['order'] else ''} {m['order'] or ''})")
    draft.replace(_BY_VELOCITY, r", \1')")
    draft.replace(_BRACES_OF_TIME, r", \1, \2")
    draft.replace(_TIMES, r", \1, \2")
    draft.replace(_DOLLAR, r", \1")
    draft.apply(_modelica(draft.text, scope))
    draft.replace(_SPOKEN, lambda m: _spoken(m, scope))
    draft.apply(_dotted(draft.text))
    draft.replace(_INDEXED, lambda m: _indexed(m, scope))
    draft.replace(_PREFIX, lambda m: _prefixed(m, scope))
    draft.replace(_SUFFIX, lambda m: _with_primes(m, scope))
    draft.replace(_INVERSE, r"a\1")
    if scope.role("D") is Role.UNDECLARED:
        with_operators(draft, frozenset(q.name for q in scope.slots.coordinates))
    if scope.role("max") is scope.role("min") is Role.UNDECLARED:
        draft.apply(extremes(draft.text))
    _derivatives(draft, scope)
    _displacements(draft, scope)
    draft.apply(of_argument(draft.text, scope))
    draft.replace(_RUN_WITH_POWER, lambda m: _divisor(m, scope))
    draft.replace(_RUN, lambda m: _product(m, scope))
    return draft.finished()


def _is_declared_unit(written: str, scope: Scope) -> bool:
    """Whether what looks like a unit of angles is a name of the problem."""
    name = written.strip()
    return name.isalpha() and scope.role(name) is not Role.UNDECLARED


def _exponentials(text: str, scope: Scope) -> Iterator[Edit]:
    """`e^(-k t)` as exp(-k t), where no `e` is declared."""
    ends: dict[int, int] | None = None
    for match in _EXPONENTIAL.finditer(text):
        if scope.role(match["e"]) is not Role.UNDECLARED:
            continue
        if match["power"]:
            yield match.start(), match.end(), f"exp({match['power']})"
            continue
        ends = closings(text) if ends is None else ends
        if (end := ends.get(match.end())) is not None:
            yield match.start(), match.end() + 1, "exp("
            yield end, end + 1, ")"


def _displacements(draft: Draft, scope: Scope) -> None:
    """`δx` as delta(x), and `dx` as d(x); for a name that the answer defines, as the differential of its value."""
    moving = {q.name for q in scope.slots.coordinates} | {"t"}

    def displaced(match: re.Match[str], sign: str) -> str | None:
        name = _spelled(match["name"], scope)
        own = sign == "d" and scope.role(match[0].replace(" ", "")) is not Role.UNDECLARED
        if name in moving or own:
            return None if own else f" {sign}({name})"
        if sign == "d" and any(f.name == name for f in scope.slots.prescribed):
            return f" {name}'*d(t)"
        value = scope.scalar(name) if sign == "delta" else None
        varied = sorted(value.free_symbols & {*scope.slots.coordinates}, key=str) if value is not None else []
        terms = [f"diff({name}, {q})*delta({q})" for q in varied]
        return f" ({' + '.join(terms)})" if terms else None

    draft.apply(_displaced_expressions(draft.text, moving, scope))
    if scope.role("delta") is Role.UNDECLARED:
        draft.replace(_VARIATION, lambda m: displaced(m, "delta"))
    if scope.role("d") is Role.UNDECLARED:
        draft.replace(_DIFFERENTIAL, lambda m: displaced(m, "d"))


def _spelled(name: str, scope: Scope) -> str:
    """The declared name that is written θ₁ or x_{2}."""
    plain = "".join(GREEK.get(c, c) for c in name if c not in "{}")
    digits = "".join(SUBSCRIPTS.get(c, c) for c in plain)
    return scope.spelling(re.sub(r"(?<=[A-Za-z])(?=[0-9])", "_", digits, count=1) if digits != plain else plain)


def _displaced_expressions(text: str, moving: Collection[str], scope: Scope) -> Iterator[Edit]:
    """`d(2 b cos θ)` as diff(2 b cos θ, θ)*d(θ), and so with δ."""
    ends: dict[int, int] | None = None
    for match in _DISPLACED.finditer(text):
        sign = "d" if match[1] == "d" else "delta"
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        if end is None or scope.role(sign) is not Role.UNDECLARED:
            continue
        inside = text[match.end() + 1 : end]
        letters = {_spelled(n, scope) for n in _NAMES.findall(inside)}
        if inside.strip() in moving or _spelled(inside.strip(), scope) in moving:
            continue
        terms = [f"diff({inside}, {q})*{sign}({q})" for q in sorted(letters & {*moving} - {"t"})]
        if terms and len(terms) <= 6:
            yield match.start(), end + 1, f"({' + '.join(terms)})"


def characters(draft: Draft) -> None:
    """Replace invisible operators, italic letters, spacing dots, and the quotation mark of `θ"`."""
    draft.replace(_QUOTED, "''")
    draft.replace(_SMALL_FRACTION, lambda m: f"({normalize('NFKC', m[1])}/{normalize('NFKC', m[2])})")
    draft.replace(_DOTS_OF_WORD, lambda m: f"{m['letter']}{m['dot']}{m['index']}")
    draft.replace(_BLANK_DOTS, "")
    draft.replace(_ITALIC, lambda m: normalize("NFKC", m[0]))
    draft.replace(_DOTS_BEFORE_INDEX, lambda m: f"{m[2]}{_SPACED[m[1]]}")
    draft.replace(_SPACING_DOTS, lambda m: _SPACED.get(m[0], "''"))
    draft.replace(_ODD, lambda m: _INVISIBLE[m[0]])


_SPACED = {"¨": "''", "˙": "'"}
_COLON_EQUALS = re.compile(r":\s?=(?!=)")


def cleaned(fragment: Fragment, declared: Collection[str] = ("p",)) -> Fragment:
    """The text with invisible operators and odd signs replaced: they are harmless in an answer.

    declared  the names of the problem: where `p` is none, pφ is the momentum p_φ
    """
    draft = Draft(fragment)
    characters(draft)
    draft.replace(_COLON_EQUALS, "=")
    draft.replace(_MODULE, "")
    draft.replace(_RATIONAL, r"(\1/\2)")
    as_functions(draft)
    if "\\" not in draft.text and "$" not in draft.text:
        if "p" not in declared:
            draft.replace(_MOMENTUM, "p_")
        draft.replace(_GREEK_INDEX, lambda m: GREEK[m[0]])
    return draft.finished(latex=getattr(fragment, "latex", False))


def _function(name: str) -> str:
    lower = name.lower()
    return _CALLS.get(lower, lower)


def _called_with_brackets(text: str, scope: Scope) -> Iterator[Edit]:
    """`Sin[x]` as sin(x), `D[L, x]` as diff(L, x)."""
    ends: dict[int, int] | None = None
    for match in _APPLIED.finditer(text):
        name = _function({"ArcTan": "arctan", "ArcSin": "arcsin", "ArcCos": "arccos"}.get(match[1], match[1]))
        name = "diff" if name == "d" else name
        if name not in (*FUNCTIONS, "diff") or scope.role(match[1]) is not Role.UNDECLARED:
            continue
        ends = closings(text) if ends is None else ends
        if match.end() in ends:
            yield match.start(), match.end() + 1, f"{name}("
            yield ends[match.end()], ends[match.end()] + 1, ")"


def _of_two(text: str) -> Iterator[Edit]:
    """`arctan(y, x)` of Maple as arctan2(y, x)."""
    for match in _ARCTAN.finditer(text):
        end = closings(text).get(match.end())
        if end is not None and len(cuts(text[match.end() + 1 : end], _COMMA)) > 1:
            yield match.end(), match.end(), "2"


def _grouping(text: str) -> Iterator[Edit]:
    """`[a + b]` as (a + b): brackets without a comma are no list."""
    if "[" not in text:
        return
    for start, end in closings(text).items():
        if text[start] == "[" and "," not in text[start:end] and "=" not in text[start:end]:
            yield start, start + 1, "("
            yield end, end + 1, ")"


def _dotted(text: str) -> Iterator[Edit]:
    """`ddot(x)` as (x)''; `dot(a, b)` is a product of vectors."""
    ends: dict[int, int] | None = None
    for match in _DOTTED.finditer(text):
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        if end is None or (match[1] == "d" and "," in text[match.end() : end]):
            continue
        yield match.start(), match.end(), ""
        yield end + 1, end + 1, "'" * len(match[1])


def _modelica(text: str, scope: Scope) -> Iterator[Edit]:
    """`der(x)` as diff(x, t)."""
    if "der" not in text or scope.role("der") is not Role.UNDECLARED:
        return
    ends = closings(text)
    for match in _DER.finditer(text):
        if match.end() in ends:
            yield match.start(), match.end(), "diff"
            yield ends[match.end()], ends[match.end()], ", t"


def _spoken(match: re.Match[str], scope: Scope) -> str | None:
    """`r dot dot`, `theta double dot` as r'', theta''."""
    if scope.role(_spelled(match["name"], scope)) is Role.UNDECLARED:
        return None
    return match["name"] + "'" * (match["dots"].lower().count("dot") + ("double" in match["dots"].lower()))


def _with_primes(match: re.Match[str], scope: Scope) -> str | None:
    """`x_ddot`, `x1_ddot`, `xddot` as x''."""
    written = match[0]
    name = match["name"].rstrip("_")
    index = match["index"] or ""
    if not name or scope.role(written) is not Role.UNDECLARED:
        return None
    short = match["short"] or match["joined"]
    if short in ("d", "D", "t") and scope.role(short) is not Role.UNDECLARED and short == match["joined"]:
        return None  # a product
    short = short and short.lower()
    dots = match["dots"] or ""
    order = len(short) if short else dots.count("dot") if dots.startswith("dot") else len(dots) - 2
    for candidate in (name + index, f"{name}_{index}" if index else name):
        role = scope.role(scope.spelling(candidate))
        moving = role is not Role.UNDECLARED and (short not in ("t", "tt", "d") or _is_moving(candidate, scope))
        if moving or ("_" in written and not short):
            return candidate + "'" * order
    return None


def _is_moving(name: str, scope: Scope) -> bool:
    """Whether a name is that of a coordinate, or of something with coordinates in it."""
    value = scope.scalar(scope.spelling(name))
    return value is not None and not value.free_symbols.isdisjoint(scope.slots.coordinates)


def _indexed(match: re.Match[str], scope: Scope) -> str | None:
    """`m_1` as m1, and `φ̈_1` as φ1'', where these are declared and the names with an underscore are not."""
    index = match[3] or match[4]
    name = GREEK.get(match[1], match[1])
    if scope.role(f"{name}_{index}") is not Role.UNDECLARED or scope.role(f"{name}{index}") is Role.UNDECLARED:
        return None
    return f" {name}{index}" + {"": "", "\u0307": "'", "\u0308": "''"}[match[2]]


def _prefixed(match: re.Match[str], scope: Scope) -> str | None:
    """`ddx`, `d2theta`, `dot_x` as x'', theta'', x'."""
    if scope.role(match[0]) is not Role.UNDECLARED or scope.role(scope.spelling(match["name"])) is Role.UNDECLARED:
        return None
    dots = match["dots"].rstrip("_")
    return match["name"] + "'" * (len(dots) - 2 if dots.endswith("ot") else 2)


def is_rate(name: str, scope: Scope) -> bool:
    """Whether a name is that of a derivative of something that is known: `xddot`, `r_dd`, `ddx`, but not `x_d`."""
    if name[:1] == "d" and any(q.name == name[1:] for q in scope.slots.coordinates):
        return True  # a differential
    suffix, prefix = _SUFFIX.fullmatch(name), _PREFIX.fullmatch(name)
    if suffix and suffix["short"] != "d":
        stem = suffix["name"].rstrip("_") + (suffix["index"] or "")
        if scope.role(scope.spelling(stem)) is not Role.UNDECLARED:
            return (_with_primes(suffix, scope) or name) != name
    return prefix is not None and _prefixed(prefix, scope) is not None


# Derivatives


def _derivatives(draft: Draft, scope: Scope) -> None:
    """dθ/dt, d^2θ/dt^2, dU/dr, ∂L/∂θ', and the operators d/dt and ∂/∂x before what they are applied to."""
    if "/" not in draft.text:
        return
    is_letter = scope.role("d") is not Role.UNDECLARED  # d/dt is an operator nevertheless
    draft.apply(_rates_of_brackets(draft.text, scope))
    draft.replace(_RATE, lambda m: _rate(m, scope))
    for _ in range(8):  # nested operators, the last first
        matches = [m for m in _OPERATOR.finditer(draft.text) if not is_letter or m[0][0] != "d" or m["by"] == "t"]
        if not matches:
            return
        draft.apply(_operator(draft.text, matches[-1]))


def _rates_of_brackets(text: str, scope: Scope) -> Iterator[Edit]:
    """`d(m x')/dt` as diff(m x', t)."""
    ends: dict[int, int] | None = None
    for match in _RATE_OF_BRACKET.finditer(text):
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        over = _BY_TIME.match(text, end + 1) if end is not None else None
        if end is not None and over is not None and scope.role("d") is Role.UNDECLARED:
            yield match.start(), match.end(), "diff"
            yield end, over.end(), ", t)"


def _order(match: re.Match[str]) -> int:
    return int(match[1] or match[3] or _ORDERS.get(match[2], 1))


def _rate(match: re.Match[str], scope: Scope) -> str | None:
    name, order, by = match["name"] + match["dots"], _order(match), match["by"]
    whole = match[0].split("/")[0].strip().replace(" ", "")
    if scope.role(whole) is not Role.UNDECLARED and whole[0] == "d":
        return None
    if by == "t" and not match["more"]:
        return f"{name}{chr(39) * order}{_left_over(match)}" if not name.isdigit() else None
    along = order == 1 and not match["more"] and match[0].lstrip("(")[0] != "∂"
    if along and is_velocity(match["name"], match["dots"], scope):
        return f"(diff({name}, t)/{by}'){_left_over(match)}"
    inner = f"{name}"
    for _ in range(order):
        inner = f"diff({inner}, {by}{match['more']})"
    return inner + _left_over(match)


def is_velocity(name: str, dots: str, scope: Scope) -> bool:
    """Whether a name or its derivative is a velocity, so that `dv/dx` means v'/x' along the motion.

    An energy depends on velocities too, by their squares, and its derivatives are partial ones.
    """
    spelled = scope.spelling("".join(GREEK.get(c, c) for c in name))
    if dots:
        return any(q.name == spelled for q in scope.slots.coordinates)
    value = scope.scalar(spelled)
    if any(q.name == spelled for q in scope.slots.coordinates):
        return True  # dy/dx along the motion
    if value is None:
        return False
    present = [v for v in scope.slots.velocities if v in value.free_symbols]
    return bool(present) and all(value.diff(v).free_symbols.isdisjoint(scope.slots.velocities) for v in present)


def _left_over(match: re.Match[str]) -> str:
    """The bracket after a derivative that closes one before it: (dL/dx), and not dL/(dx)."""
    return ")" if match[0].count(")") > match[0].count("(") else ""


def _operator(text: str, match: re.Match[str]) -> Iterator[Edit]:
    """`d/dt(e)` and `d/dt e`, up to the next sign outside brackets, as diff(e, t)."""
    ends = closings(text)
    start = match.end()
    while start < len(text) and text[start] in " *·":
        start += 1
    if start < len(text) and text[start] in "([{" and start in ends:
        end = ends[start] + 1
        if text[start] in "[{":
            yield start, start + 1, "("
            yield end - 1, end, ")"
    else:
        end = start
        while end < len(text) and text[end] not in "+-−=,;)]}":
            end = ends[end] + 1 if end in ends else end + 1
    order = _order(match)
    opened = "(" if match[0].count("(") > match[0].count(")") else ""
    yield match.start(), match.end(), f"{opened} {'diff(' * order}"
    yield end, end, f", {match['by']}{match['more']})" * order


def of_argument(text: str, scope: Scope, *, bare: bool = False) -> Iterator[Edit]:
    """`U'(r)` as diff(U, r), where U is a function of r: a prime on a function of one argument, which follows.

    bare  whether the argument may be missing: in plain text U' is the derivative with respect to time
    """
    for name, function in scope.functions.items():
        yield from _by_index(text, name, function.arguments, scope)
        if len(function.arguments) != 1 or function.arguments == ("t",) or len(name) > 20:
            continue
        (argument,) = function.arguments
        prime = r"(?:'|′|’|\^\s*\{?\s*(?:\\prime\s*){1,3}\}?)"
        inside = rf"\(\s*{re.escape(argument)}\s*\)"
        # in LaTeX names stand side by side, g f' and f'f'', but not in the name of a command
        before = r"(?<![_\\])(?<!\\[A-Za-z])(?<!\\[A-Za-z]{2})(?<!\\[A-Za-z]{3})" if bare else r"(?<![A-Za-z0-9_\\])"
        pattern = rf"{before}{re.escape(name)}\s*(?P<primes>{prime}{{1,3}})(?:\s*{inside}){'?' if bare else ''}"
        for match in re.finditer(pattern, text):
            order = len(re.findall(r"'|′|’|\\prime", match["primes"]))
            made = name
            for _ in range(order):
                made = f"diff({made}, {argument})"
            if (
                text[match.start() - 1 : match.start()].isalpha()
                and scope.role(_word_at(text, match)) is not Role.UNDECLARED
            ):
                continue  # the last letter of a name
            yield match.start(), match.end(), made


def _by_index(text: str, name: str, arguments: Sequence[str], scope: Scope) -> Iterator[Edit]:
    """`f_x` as diff(f, x), where f is a function of x; as diff(f, X) where it is one of X in a problem with x."""
    coordinates = {q.name for q in scope.slots.coordinates}
    for argument in arguments:
        if scope.role(f"{name}_{argument}") is not Role.UNDECLARED or argument == "t":
            continue
        written = re.escape(argument)
        if argument.isupper() and argument.lower() not in arguments and argument.lower() in coordinates:
            written = f"[{argument}{argument.lower()}]"  # of f(X, Y, Z), which is taken at (x, y, z)
            if scope.role(f"{name}_{argument.lower()}") is not Role.UNDECLARED:
                continue
        index = rf"(?:{written}(?![A-Za-z0-9_])|\{{\s*{written}\s*\}})"
        for match in re.finditer(rf"(?<![A-Za-z0-9_\\]){re.escape(name)}_{index}", text):
            yield match.start(), match.end(), f"diff({name}, {argument})"


def _word_at(text: str, match: re.Match[str]) -> str:
    """The word that ends with the name in a match of `of_argument`."""
    start = match.start()
    while start and text[start - 1].isalnum():
        start -= 1
    return text[start : match.start()] + re.match(r"\w*", match[0])[0]  # type: ignore[index]


# Products


_RUN_WITH_POWER = re.compile(r"(?<=/)(?P<space> ?)(?P<run>[A-Za-z]{2,4})(?P<power>\s*(?:\^\s*[2-4]|[²³⁴]))(?![\w^])")
"""A run of letters with a power under a bar, `/ml^2`."""


def _divisor(match: re.Match[str], scope: Scope) -> str | None:
    """`a/ml^2` as a/(m*l^2): what stands without a space after the bar is under it."""
    run = re.match(r"[A-Za-z]+", match["run"])
    written = _product(_RUN.match(match["run"]), scope) if run else None  # type: ignore[arg-type]
    return f"{match['space']}({written.strip('()')}{match['power']})" if written else None


def _product(match: re.Match[str], scope: Scope) -> str | None:
    """`mgl` as m*g*l, where it is no name and all of these are; after a `/`, and with its power, in parentheses."""
    written = match[0]
    if len(written) < 2 or written in FUNCTIONS or written in OPERATIONS or scope.role(written) is not Role.UNDECLARED:
        return None
    if written in ("d", "delta") or scope.spelling(written) != written or "_" in written[:-2]:
        return None
    names = LatexNames(scope)
    run = names.run(written)
    pieces = [name for _, name in run.pieces]
    function = pieces[-1] if pieces[-1] in NAMED_FUNCTIONS and not names.is_declared(pieces[-1]) else ""
    known = pieces[:-1] if function else pieces
    if len(pieces) < 2 or run.several or not all(names.is_declared(p) for p in known):
        return None
    text, at = match.string, match.start() - 1
    while at >= 0 and text[at] == " ":
        at -= 1
    product = "*".join(known)
    if not function and _AFTER_FUNCTION.search(text, max(0, match.start() - 8), match.start()):
        return f"({product})"
    if function:
        return f"{product} {_CALLS.get(function, function)}"
    if at >= 0 and text[at] == "/":
        power = _CLOSED_POWER.match(text, match.end())
        return f"({product})" if power is None else None
    return product
