r"""Equations that hold in some cases only: for a sense of the motion, for special parameters.

Equations that differ with the sense of the motion, as for friction, as one with the sign of a velocity.

    for x' > 0: m x'' = -k x - mu m g           m x'' = (1 + s)/2 (-k x - mu m g) + (1 - s)/2 (-k x + mu m g),
    for x' < 0: m x'' = -k x + mu m g           s = sign(x')

    m x'' + k x = \begin{cases} -\mu m g & \dot x > 0 \\ \mu m g & \dot x < 0 \end{cases}
    m x'' + k x = Piecewise((-mu*m*g, x' > 0), (mu*m*g, True))
    F = mu m g if x' > 0 and F = -mu m g if x' < 0
    m x'' + k x = ∓ mu m g (upper sign for x' > 0)

Two cases are put together where their conditions are opposite and compare a velocity with a velocity or with zero. The
condition of a single case goes before its equation, as words do; what it is worth is seen when it is compared.

The sense of a motion that a word or a lone sign gives: as a condition, or as the sign of the velocity.

    m x'' = -k x - mu m g  (moving right)       m x'' = -k x - mu m g  (x' > 0)
    m x'' + k x = ∓ mu m g                      m x'' + k x = - sign(x') mu m g

The velocity is that of the one acceleration in the line. To the right is the positive sense of a coordinate. The upper
sign of a ∓ is for a positive velocity; which case comes first in a ± is not known, and it stays as it is.

What an answer says of a special case beside its equations: `if M = 3 m, then T = 3 m g/2`.

The case is a relation between parameters, or the place of a coordinate (`T = 3 m g when theta = 0`), after `for`, `if`,
`when` and the like. It is no statement about every motion, and neither is what follows it on its line, or comes right
before it. A relation that every motion satisfies, `for r = R`, is a constraint and no case.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from unicodedata import normalize

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.answers.limits import LONGEST_BEFORE_CASE, LONGEST_CONNECTIVE, MOST_PIECEWISE, ROUNDING_OF_CASES
from lagrange.answers.readings import Reading, decimals_in
from lagrange.answers.references import Reference
from lagrange.answers.written.decimals import numbers_rounding_to
from lagrange.core.diagnostics import Fragment
from lagrange.core.records import record
from lagrange.core.symbols import Decimal, base
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import closings, cuts
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.mechanics.dynamics.comparison import Standing, compare

_NAME = r"\\?[^\W\d_][A-Za-z0-9]{0,12}(?:_\{?\w{1,6}\}?)?"
_RATE = (
    rf"(?:\\dot\s*\{{\s*{_NAME}\s*\}}(?:_\{{?\w{{1,4}}\}}?)?|\\dot\s*{_NAME}|{_NAME}'(?!')(?:\s*[(\[]\s*t\s*[)\]])?"
    r"|[^\W\d_](?:_\w{1,4})?\u0307(?:_\w{1,4})?|[^\W\d_]\w{0,8}?_?dot(?![A-Za-z])|d[A-Za-z]\w{0,8}\s*/\s*dt|ẋ|ẏ|ż|ṙ|ṡ"
    r"|(?:diff|Derivative)\(\w{1,10}(?:\(t\))?,\s*t\)|\\frac\s*\{\s*d\s*\\?\w{1,10}\s*\}\s*\{\s*d\s*t\s*\}|v(?:_\w{1,3})?(?![\w'(]))"
)
_TERM = rf"(?:{_RATE}|{_NAME}|0)"
_SUM = rf"{_TERM}(?:\s*[-+−]\s*{_TERM})?"
_RELATION = r">=?|<=?|[≥≤]|\\(?:gt|lt|geq?|leq?|geqslant|leqslant)(?![A-Za-z])"
_CONDITION = re.compile(
    rf"(?<![\w\\'=<>≤≥/*^+−-])(?P<left>{_SUM})\s*(?P<relation>{_RELATION})\s*(?P<right>{_SUM})"
    r"(?![\w'(]|[ \t]*(?:[*/^+−=<>≤≥-]|\\[lg]))"
)
_IS_RATE = re.compile(_RATE)
_MAYBE = re.compile(r"[<>≤≥]|\\[lg](?:t|e|eq|eqslant)(?![A-Za-z])")
_ROW = re.compile(r"\n|;|\\\\|\bwhere\b")
_CONNECTIVE = (
    r"(?:\b(?:for|if|when|where|while|and|but|with|in\s+the\s+case|case|fall|für|wenn|falls|bei|und|pour|si|et|is|moving|then|it|so)\b"
    r"|\\(?:text|mathrm|mbox)\s*\{[^{}=]{0,40}\}|\\q?quad|(?<!\\)\\[,;: !]"
    r"|\(?\b(?:[0-9]|[iI]{1,3}|[abAB])[):.]|\((?:[^\W\d_]{2,20}[ ,]{0,2}){2,8}\)|[&,:.;$~]|\\\\|\s)"
)
_LAST = re.compile(
    rf"(?:{_CONNECTIVE}|[(\[]|\\left\s*[(\[]|\\\(|\b(?:while|as|when)\s(?:[^\W\d_]{{1,20}}\s){{1,6}})\Z", re.IGNORECASE
)
"""One of the words and signs between an equation and its condition, at the end of a text."""
_AFTER = re.compile(rf"(?:{_CONNECTIVE}|[)\]]|\\right\s*[)\].])+", re.IGNORECASE)
_CASES = re.compile(
    r"(?:\\left\s*\\\{\s*)?\\begin\s*\{(?P<kind>d?cases|rcases|array|aligned)\}(?:\s*\{[lcr@{} ]{1,12}\})?"
    r"(?P<rows>.*?)\\end\s*\{(?P=kind)\}"
    r"(?:\s*\\right\s*\.)?",
    re.DOTALL,
)
_CALL = re.compile(r"(?<![A-Za-z])(?P<name>Piecewise|piecewise|If)\s*(?=[(\[])")
_OTHERWISE = re.compile(
    r"[\s&]*(?:\\(?:text|mathrm|mbox)\s*\{\s*(?:otherwise|else|sonst|sinon)[^{}]{0,10}\}|True|otherwise|else|sonst|sinon)[\s.,]*\Z"
)
_SIGNS = re.compile(r"[±∓]|\\(?:pm|mp)(?![A-Za-z])")
_UPPER = re.compile(r"\(?\s*(?:with\s+)?(?:the\s+)?upper\s+sign(?:\s+(?:for|if|when|where)|\s*:)\s*\$?", re.IGNORECASE)
_LOWER = re.compile(
    r"[\s,;$]*(?:and\s+)?(?:the\s+)?lower\s+(?:sign\s+)?(?:(?:for|if|when|where)\s+|:\s*|otherwise)?\$?", re.I
)
_LABEL = re.compile(
    r"\A[^\W\d_]{3,20}(?:\s[^\W\d_]{1,20}){0,9}:(?!=)\s*"
    r"|\A[^\W\d_]{3,20}(?:\s[^\W\d_]{2,20}){1,9},?\s(?:so|thus|hence|and|then|also|donc)(?:\sthat)?,?\s"
)
"""`rising:` before an equation, `the belt drags it forward, so`."""
_EQUALS = re.compile(r"(?<![<>!:=])==?(?![=>])")


_DOTTED = re.compile(r"\\dot\s*\{?\s*\\?([A-Za-z]+)\s*\}?")


@record
class _Condition:
    """A condition `greater > less` at a place in a text."""

    start: int
    end: int
    greater: str
    less: str

    def opposite(self, other: _Condition) -> bool:
        own, its = (["".join(side.split()) for side in (c.greater, c.less)] for c in (self, other))
        return own == its[::-1]

    def sign(self, latex: bool) -> str:
        """The sign of the difference."""
        difference = self.greater if self.less == "0" else f"{self.greater} - ({self.less})"
        difference = f"-({self.less})" if self.greater == "0" else difference
        return rf"\operatorname{{sgn}}\left({difference}\right)" if latex else f"sign({difference})"


def with_cases(text: str) -> str:
    """The text with the cases of opposite velocities in one equation; the same where there are none."""
    if len(text) <= MAX_ANSWER_CHARACTERS:
        text = with_senses(_SIGN_OF_CASE.sub(_upper_sign, text))
    if not _MAYBE.search(text) or len(text) > MAX_ANSWER_CHARACTERS or not any(_conditions(text)):
        return text
    latex = "\\" in text
    text = _NAMED_SIGN.sub(lambda m: _named_sign(m, latex), text)
    for step in (_calls, _environments, _signs, _lines):
        text = step(text, latex)
    return text


_PLUS_MINUS = {"±": "∓", "∓": "±", "\\pm": "\\mp", "\\mp": "\\pm"}
_SIGN_OF_CASE = re.compile(
    r"(?P<both>[±∓]|\\pm(?![A-Za-z])|\\mp(?![A-Za-z]))(?P<term>[^\n;±∓]{1,120}?)(?P<opened>,?\s*(?:\\q?quad\s*)?(?:\\text\s*\{\s*)?\(\s*\$?)"
    r"(?P<case>[+−-]|(?:lower|minus|plus)(?:\s+sign)?)\$?\s*(?:\\text\s*\{\s*)?(?P<where>if|for|when|where)(?P<first>[\s}][^,;\n()]{1,60}?)"
    r"(?P<second>[,;]\s*(?:and\s+)?\$?(?:[+−-]|minus|plus|upper\s+sign|lower\s+sign)\$?\s*(?:if|for|when|where|otherwise|else)[^()\n]{0,60}?)?(?=\s*\))"
)
"""`± a (+ if x' < v)`, `∓ a (lower sign for x' > 0)`."""


def _upper_sign(match: re.Match[str]) -> str:
    """The same with the case of the upper sign, and with its signs exchanged where the lower one is described."""
    upper = {"±": "+", "\\pm": "+", "∓": "-", "\\mp": "-"}[match["both"]]
    case = match["case"].split()[0].lower().replace("−", "-").replace("plus", "+").replace("minus", "-")
    both = match["both"] if case == upper else _PLUS_MINUS[match["both"]]
    first = (
        match["first"].replace("}", "", 1) if match["first"].count("}") > match["first"].count("{") else match["first"]
    )
    return f"{both}{match['term']}{match['opened']}upper sign {match['where']}{first}"


_NAMED_SIGN = re.compile(
    r"(?P<name>\\?[^\W\d_]{1,10})\s*=\s*(?P<value>[+−-]?\s*1)\$?,?\s*(?:\\text\s*\{\s*)?(?:for|if|when)\s*\}?\s*\$?(?P<where>[^,;\n=]{1,60}?)\$?"
    r"(?:[,;]\s*|\s+)(?:and\s+)?(?:\$?(?P=name)\s*=\s*)?(?P<other>[+−-]?\s*1)\$?,?\s*(?:\\text\s*\{\s*)?"
    r"(?:otherwise|else|(?:for|if|when)\s*\}?\s*\$?(?P<else>[^,;\n=.]{1,60}))\$?"
)
"""`s = +1 for x' < v and s = -1 for x' > v`."""


def _named_sign(match: re.Match[str], latex: bool) -> str:
    """The same as `s = sign(...)`, where the second case is the opposite of the first."""
    where, second = _condition(match["where"]), _condition(match["else"]) if match["else"] else None
    values = ["-" if match[g].lstrip()[0] in "-−" else "" for g in ("value", "other")]
    if where is None or values[0] == values[1] or (match["else"] and (second is None or not where.opposite(second))):
        return match[0]
    closing = "$" if match[0].count("$") % 2 else " "
    return f"{match['name']} = {values[0]}{where.sign(latex)}{closing}"


def _conditions(text: str) -> Iterator[_Condition]:
    for m in _CONDITION.finditer(text):
        if not (_IS_RATE.search(m["left"]) or _IS_RATE.search(m["right"])):
            continue
        left, right = m["left"].strip(), m["right"].strip()
        is_less = m["relation"][0] in "<≤" or m["relation"].startswith("\\l")
        yield _Condition(m.start(), m.end(), *((right, left) if is_less else (left, right)))


def _condition(text: str) -> _Condition | None:
    """The only condition that a text consists of."""
    every = [*_conditions(text)]
    if len(every) != 1 or _AFTER.sub("", text[: every[0].start]).strip() or text[every[0].end :].strip(" \n$.,;)]"):
        return None
    return every[0]


def _halves(condition: _Condition, first: str, second: str, latex: bool) -> str:
    """The sum that is `first` where the condition holds, and `second` elsewhere."""
    s = condition.sign(latex)
    if latex:
        return rf"\frac{{1 + {s}}}{{2}}\left({first}\right) + \frac{{1 - {s}}}{{2}}\left({second}\right)"
    return f"(1 + {s})/2*({first}) + (1 - {s})/2*({second})"


def _together(condition: _Condition, first: str, second: str, latex: bool) -> str:
    """The equation that is `first` where the condition holds, and `second` elsewhere; empty if they are not two."""
    sides = [[e[a:b].strip(" &$,.") for a, b in cuts(e, _EQUALS)] for e in (first, second)]
    if any(len(pair) != 2 or not all(pair) for pair in sides):
        return ""
    (left, right), (other, its) = sides
    if "".join(left.split()) == "".join(other.split()):
        return f"{left} = {_halves(condition, right, its, latex)}"
    made = [rf"{a} - \left({b}\right)" if latex else f"{a} - ({b})" for a, b in sides]
    return f"{_halves(condition, made[0], made[1], latex)} = 0"


def _calls(text: str, latex: bool) -> str:
    """`Piecewise((a, x' > 0), (b, True))`, `Piecewise[{{a, x' > 0}, {b, x' < 0}}]`, `If[x' > 0, a, b]`."""
    for _ in range(4):
        ends = closings(text)
        for call in [*_CALL.finditer(text)][:MOST_PIECEWISE]:
            if (close := ends.get(call.end())) is None:
                continue
            parts = _parts(text[call.end() + 1 : close])
            for _ in range(2):
                parts = [x for p in parts for x in (_parts(p[1:-1]) if p[:1] in "({" and _in_brackets(p) else [p])]
            conditions = [_condition(p) for p in parts]
            first = next((c for c in conditions if c is not None), None)
            values = [p for p, c in zip(parts, conditions, strict=True) if c is None and not _OTHERWISE.match(p)]
            if first is None or len(values) != 2:
                continue
            made = _halves(first, values[0], values[1], latex)
            text = f"{text[: call.start()]}({made}){text[close + 1 :]}"
            break
        else:
            return text
    return text


def _parts(text: str) -> list[str]:
    return [text[a:b].strip() for a, b in cuts(text, re.compile(","))]


def _in_brackets(text: str) -> bool:
    """Whether a text is a list in brackets, `(a, x' > 0)`, and no bracketed expression."""
    return closings(text).get(0) == len(text) - 1 and len(_parts(text[1:-1])) > 1


def _environments(text: str, latex: bool) -> str:
    r"""`\begin{cases} a & \dot x > 0 \\ b & \dot x < 0 \end{cases}`, of expressions or of equations."""

    def made(match: re.Match[str]) -> str:
        written = [r for r in re.split(r"\\\\", match["rows"]) if r.strip()]
        if len(written) != 2:
            return match[0]
        pieces = []
        for row in written:
            where = next(_conditions(row), None)
            end = where.start if where else m.start() if (m := re.search(r"[&,](?=[^&,]*\Z)", row)) else len(row)
            if where is None and not _OTHERWISE.search(row[end:].lstrip("&,")):
                return match[0]
            pieces.append((_without_last(row[:end]).strip(" &,"), where))
        (first, condition), (second, other) = pieces
        if condition is None or (other is not None and not condition.opposite(other)):
            return match[0]
        if "=" in first or "=" in second:
            return _together(condition, first, second, latex) or match[0]
        return rf"\left({_halves(condition, first, second, latex)}\right)"

    return _CASES.sub(made, text) if latex else text


def _signs(text: str, latex: bool) -> str:
    """`∓ a (upper sign for x' > 0)` with the sign of the velocity."""
    upper = _UPPER.search(text)
    where = next(_conditions(text[upper.end() :]), None) if upper else None
    if upper is None or where is None or not _SIGNS.search(text[: upper.start()]):
        return text
    end = upper.end() + where.end
    if lower := _LOWER.match(text, end):
        end = lower.end()
        other = next(_conditions(text[end:]), None)
        end += other.end if other is not None and other.start == 0 else 0
    rest = text[end:].lstrip("$").removeprefix(")")
    s = where.sign(latex)
    dot = r"\cdot " if latex else "*"

    def sign(match: re.Match[str]) -> str:
        return f"{'+' if match[0] in ('±', chr(92) + 'pm') else '-'} {s}{dot}"

    return _SIGNS.sub(sign, text[: upper.start()]).rstrip(" ,;\\") + rest


def _lines(text: str, latex: bool) -> str:
    """Two equations, or an equation with two right sides, with a condition each; a single one after its condition."""
    every = [*_conditions(text)]
    pairs = [(a, b) for a, b in zip(every[::2], every[1::2], strict=False) if a.opposite(b)]
    if not pairs or len(every) != 2 * len(pairs):
        return _single(text, every, latex) if len(every) == 1 else text
    for first, second in reversed(pairs):
        text = _pair(text, first, second, latex)
    return text


def _pair(text: str, first: _Condition, second: _Condition, latex: bool) -> str:
    begin = max((m.end() for m in _ROW.finditer(text, 0, first.start)), default=0)
    before, between = text[begin : first.start], text[first.end : second.start]
    if "=" in before:  # a = b for x' > 0, and a = c for x' < 0
        one, other = _bare(before), _bare(between)
        end = second.end
        rest = text[end:]
        rest = rest.lstrip(" ")[1:] if rest.lstrip(" ")[:1] in (")", "]") else rest
        if "=" not in other:
            other = f"{one[: cuts(one, _EQUALS)[0][1]]} = {other}"
        start = begin + before.find(one)
    else:  # for x' > 0: a = b
        stop = next(
            (m.start() for m in _ROW.finditer(text, second.end) if text[second.end : m.start()].strip(" :,\n")),
            len(text),
        )
        one, other = _bare(between), _bare(text[second.end : stop])
        rest, start = text[stop:], begin + len(_without_last(before))
    together = _together(first, one, other, latex)
    return f"{text[:start]}{together}{rest}" if together else text


def _without_last(text: str) -> str:
    """A text without the words and signs at its end that join it to a condition."""
    end = len(text)
    while last := _LAST.search(text, max(0, end - LONGEST_CONNECTIVE), end):
        end = last.start()
    return text[:end]


def _bare(text: str) -> str:
    """An equation without the words and signs that join it to its condition."""
    text = _without_last(text)
    after = _AFTER.match(text)
    text = text[after.end() :].strip() if after else text.strip()
    return _LABEL.sub("", text)


def _single(text: str, every: Sequence[_Condition], latex: bool) -> str:
    """The text with the condition of its only case before the equation."""
    (only,) = every
    begin = max((m.end() for m in _ROW.finditer(text, 0, only.start)), default=0)
    before = text[begin : only.start]
    if "=" not in before:
        return text
    equation = _bare(before)
    rest = text[only.end :]
    rest = rest.lstrip(" ")[1:] if rest.lstrip(" ")[:1] in (")", "]") else rest
    condition = _DOTTED.sub(r"\1'", text[only.start : only.end])
    words = rf"\text{{for {condition}: }}" if latex else f"for {condition}: "
    if "$" in before:
        equation = f"${equation}$"
        rest = rest.lstrip("$").removeprefix(")")
    return f"{text[:begin]}{words}{equation}{rest}"


def single_condition(words: str) -> tuple[str, str] | None:
    """What is greater, and than what, in the only condition on a velocity that words state; None if there is none."""
    every = [*_conditions(words)] if _MAYBE.search(words) else []
    return (every[0].greater, every[0].less) if len(every) == 1 else None


# Senses in words


_ACCELERATION = re.compile(
    r"(?P<primed>[^\W\d_]\w{0,12})(?:''|″)|\\ddot\s*\{?\s*(?P<latex>\\?[A-Za-z]{1,12}(?:_\w)?)\s*\}?|(?P<dotted>[^\W\d_])\u0308"
)
_MOVING = re.compile(
    r"\b(?:(?:it|the\s+\w{1,12})\s+)?(?:is\s+|when\s+|while\s+)?(?:moving|moves|motion|slides|sliding)\s+(?:to\s+the\s+)?(?P<to>right|left)(?:wards?)?\b",
    re.IGNORECASE,
)
_MINUS_PLUS = re.compile(r"∓|\\mp(?![A-Za-z])")
_TOLD = re.compile(r"[<>≤≥]|\\[lg](?:t|eq?)(?![A-Za-z])")
"""A condition stands there in signs already."""
_UPPER_OR_LOWER = re.compile(r"\b(?:upper|lower)\b", re.IGNORECASE)


def with_senses(text: str) -> str:
    """The text with conditions for words like `moving right`, and without ∓ where a velocity has its sign."""
    moving = _MOVING.search(text) is not None
    alone = _MINUS_PLUS.search(text) is not None and not _UPPER_OR_LOWER.search(text)
    if not moving and not alone:
        return text
    return "".join(_of_line(line, alone) for line in text.splitlines(keepends=True))


def _of_line(line: str, alone: bool) -> str:
    names = {m["primed"] or m["latex"] or m["dotted"] for m in _ACCELERATION.finditer(normalize("NFD", line))}
    if len(names) != 1:
        return line
    latex = "\\" in line
    [name] = names
    rate = rf"\dot{{{name}}}" if latex else f"{name}'"
    if not _TOLD.search(line):
        line = _MOVING.sub(lambda m: f"{rate} {'>' if m['to'].lower() == 'right' else '<'} 0", line)
    if alone and len(_MINUS_PLUS.findall(line)) == 1:
        sign = rf"- \operatorname{{sgn}}\left({rate}\right)\cdot " if latex else f"- sign({rate})*"
        line = _MINUS_PLUS.sub(lambda _: sign, line)
    return line


# Special parameters


_CASE = re.compile(
    r"(?:\b(?:for|if|when|where|in\s+(?:the|a)\s+(?:special\s+|limiting\s+)?case(?:\s+(?:of|that|where))?|case|check|setting"
    r"|wenn|für|falls|bei|im\s+fall|pour|si|at)\b|\\text\s*\{\s*(?:for|if|when|where|at)\s*\})[\s,:($\\]*\Z"
    r"|\b(?:if|when|case|wenn|falls|si|lorsque)\s(?:[^\W\d_][\w-]*,?\s+){2,16}(?:then|dann|alors|i\.\s?e\.|that\s+is,?)[\s$]*\Z"
    r"|\b(?:if|case|falls|si)\s(?:[^\W\d_][\w-]*\s+){2,16}[^\W\d_][\w-]*,[\s$]*\Z"
    r"|\b(?:circle|circular|steady|uniform|at\s+(?:constant|rest))\b[^.=;]{0,60}:[\s$\\(\[]*\Z"
    r"|\b(?:for|in|on)\s+(?:a|an|the|such\s+a)\s+(?:[^\W\d_]+\s+){0,3}(?:circles?|circular\s+\w+|steady\s+\w+)[\s,$]*\Z"
    r"|\b(?:on|at|in)\s+(?:the|its)\s+(?:[^\W\d_]+\s+){1,3}[\s$(]*\Z",
    re.IGNORECASE,
)
"""What precedes a case: `if`, `if the rope is pulled in steadily then`, `Circle at constant height:`,
`for a circle`, `at the top`."""
_LIMIT = re.compile(
    r"\b(?:for|as|when|if|limit|case|für|wenn|pour)\b[^=.;]{0,30}?(?<![\w\\])(?P<name>\\?[^\W\d_]\w{0,12})[\s$]*"
    r"(?:→|->|⟶|\\(?:to|rightarrow|longrightarrow)(?![A-Za-z]))[\s$]*(?:∞|\\infty|inf(?:inity|ty)?\b|0(?![\w.]))(?:(?!\.\s).)*\Z",
    re.IGNORECASE | re.DOTALL,
)
"""A limit for which everything after it on a line is said: `for M → ∞, `."""
_PLACE = re.compile(
    r"\b(?:on|at|in|where|when|for|bei|für|pour)\s(?:[^\W\d_]+\s+){0,4}[\s$(]*(?P<name>\\?[^\W\d_]\w{0,12})\s*=\s*"
    r"[-−]?(?:[0-9]{1,3}|\\?pi|π)(?:/[0-9]{1,2})?(?:\s*(?:°|deg))?[\s$)]*:[\s$]*\Z",
    re.IGNORECASE,
)
_JOINS = re.compile(
    r"[\s,($]*(?:\\[,;: ]|\\q?quad|\\text\s*\{)?\s*"
    r"(?:\b(?:for|if|when|in\s+the\s+case|wenn|für|falls|bei|at)\b)[\s}(:$]*\Z",
    re.IGNORECASE,
)


def about_special_cases(
    equations: Sequence[tuple[Fragment, Reading]], reference: Reference, *, at_rest: bool = False
) -> tuple[set[int], set[int]]:
    """The indices of the equations that state a case, and of those that hold in one and do not contradict the answer.

    at_rest  then only a parameter with a number is a case: other equations may be positions, or conditions of rest
    """
    states = _gives_parameter if at_rest else _is_case
    cases = {n for n, (f, r) in enumerate(equations) if _CASE.search(_before(f)) and states(r, reference)}
    if at_rest and cases:  # `for α = 30°, β = 45° and W = 2 N`
        for n in range(min(cases) + 1, len(equations)):
            if n - 1 in cases and _gives_parameter(equations[n][1], reference):
                cases.add(n)
    special = {n for n, (f, _) in enumerate(equations) if _in_limit(f, reference)} - cases
    for n in cases:
        case = equations[n][0].span(0, len(equations[n][0].text))
        before = [m for m in range(n) if m not in cases]
        for m, (f, _) in enumerate(equations):
            own = f.span(0, len(f.text))
            if m in cases or own.source is not case.source:
                continue
            first, last = sorted((own, case), key=lambda s: s.start)
            between = case.source.text[first.end : last.start]
            if "\n" not in between and (own is last or (before[-1:] == [m] and _JOINS.match(between))):
                special.add(m)
    others = [r for n, (_, r) in enumerate(equations) if n not in cases | special]
    stated = [equations[n][1] for n in cases]
    return cases, {n for n in special if not _is_contradicted(equations[n][1], stated, others)}


def _before(fragment: Fragment) -> str:
    """The end of the text that precedes an equation on its line."""
    span = fragment.span(0, len(fragment.text))
    text = span.source.text[: span.start]
    return text[max(text.rfind("\n") + 1, span.start - LONGEST_BEFORE_CASE) :]


def _in_limit(fragment: Fragment, reference: Reference) -> bool:
    """Whether a statement is for a very large or small parameter, or for one place: `at the top x = 0: `."""
    before = _before(fragment)
    limit, place = _LIMIT.search(before), _PLACE.search(before)
    names = ["".join(GREEK.get(c, c) for c in m["name"].lstrip("\\")) if m else "" for m in (limit, place)]
    return names[0] in reference.parameters or names[1] in reference.coordinates


def _gives_parameter(reading: Reading, reference: Reference) -> bool:
    """Whether an equation gives one parameter a number."""
    if reading.error is not None or len(reading.components) != 1:
        return False
    symbols = {s for s in reading.components[0].free_symbols if not isinstance(s, Decimal)}
    return len(symbols) == 1 and symbols <= {*reference.parameters.values()}


def _is_contradicted(special: Reading, case: Sequence[Reading], others: Sequence[Reading]) -> bool:
    """Whether a number stated for a special case contradicts what the same answer says in general."""
    values: dict[sp.Symbol, sp.Expr] = {}
    for reading in case:
        for e in reading.components:
            for s in e.free_symbols:
                slope = e.diff(s)
                if not isinstance(s, Decimal) and not slope.free_symbols:
                    values[s] = s - e / slope
    stated = {s for e in special.components for s in e.free_symbols if not isinstance(s, Decimal)}
    if len(stated) != 1 or len(special.components) != 1:
        return False
    [e], [s] = special.components, stated
    slope = e.diff(s)
    if slope.free_symbols or slope == 0:
        return False
    number = s - e / slope
    residuals = [x.xreplace(values) for r in others if r.error is None for x in r.components if s in x.free_symbols]
    residuals = [x for x in residuals if all(y == s or isinstance(y, Decimal) for y in x.free_symbols)]
    return bool(residuals) and not any(_fits(x, s, number) for x in residuals)


def _fits(residual: sp.Expr, s: sp.Symbol, number: sp.Expr) -> bool:
    """Whether a residual vanishes at a number that may be rounded; an angle in degrees has no decimals any more."""
    if decimals_in([residual, number]):
        return numbers_rounding_to([residual.xreplace({s: number})]) is not None
    ends = [residual.xreplace({s: number * (1 + sign * ROUNDING_OF_CASES)}).evalf() for sign in (-1, 1)]
    return all(end.is_real for end in ends) and bool(ends[0] * ends[1] <= 0)


def _is_case(reading: Reading, reference: Reference) -> bool:
    """Whether an equation is between parameters, gives a coordinate a place that few motions have, or is q'' = 0."""
    if reading.error is not None or len(reading.components) != 1:
        return False
    (e,) = reading.components
    given = {*reference.parameters.values(), *reference.scope.slots.prescribed}
    used = {s for s in e.free_symbols if base(s) not in given}
    if not used:
        return bool(e.free_symbols)
    if e.free_symbols <= {*reference.scope.slots.velocities, *reference.scope.slots.accelerations}:
        return True
    if not used <= {*reference.scope.slots.coordinates} or len(used) != 1:
        return False
    for c in reference.candidates_for({s.name for s in e.free_symbols}):
        try:
            result = compare([c.read(e)], c.system)
        except DivisionByZeroError:
            return False
        return result is not None and Standing.CONTRADICTS in result.standings
    return False
