r"""Habits of writing that change no mathematics, put into usual signs before a text is taken apart.

    \stackrel{!}{=}   \overset{(1)}{=}             =
    \sum F_A = 0:\ m g - N = 0                     m g - N = 0: the name of a law before its equation
    \sum F_x = -k x = m \ddot x                    -k x = m \ddot x
    p = m r^2 \dot\phi = \text{const.}             p = m r^2 \dot\phi = \text{const}
    \theta = 0 \lor \cos\theta = a    θ = 0 ∨ ...  \theta = 0 \text{ or } \cos\theta = a, and so with `oder`, `ou`
    \sin\theta = \frac{M}{m} \quad (M < m)         \sin\theta = \frac{M}{m}
    cos θ = 2/3 (θ ≈ 48.2°)    m g 2R              cos θ = 2/3    m g*2R
    \frac{\mathrm dU}{\mathrm dr}                  \frac{dU}{dr}
    x'' = a, rolls if mu >= b                      x'' = a; mu >= b

Whatever is omitted becomes spaces, so that every place stays where it is; an `or` takes more room than its sign.
"""

from __future__ import annotations

import re
from unicodedata import normalize

from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import cuts
from lagrange.expressions.syntax_tree import FUNCTIONS

_LABELLED = re.compile(r"\\(?:stackrel|overset)\s?\{(?:[^{}]|\{[^{}]{0,30}\}){0,30}\}\s?\{\s?=\s?\}")
_OF_COORDINATE = re.compile(
    r"(?P<before>^|\n|\\\\|\\q?quad(?![A-Za-z])|\$|&|\\\[)\s*"
    r"(?:\(\s*\\?[A-Za-z]+(?:_\w)?\s*\)\s*:?\s*\\q?quad(?![A-Za-z])|\\(?!q?quad)[A-Za-z]{2,10}(?:_\w)?\s*:(?![=:]))"
)
"""The coordinate that an equation belongs to, before it: `(\\varphi)\\quad`, `\\varphi:`."""
_CONST = re.compile(r"(?<=\{)(\s*[Kk]onst|\s*const|\s*[Cc]st)\.\s*\}")
_ADDED_CONST = re.compile(
    r"(?<=[-+−])\s*\\(?:text|textrm|mathrm|mbox|rm)\s*\{\s*(?:[Cc]onst(?:ant)?|[Kk]onst(?:ante)?|[Cc]st|cte)\.?\s*\}"
)
"""A constant of integration, `+ \\text{const.}`."""
_UPRIGHT_D = re.compile(r"\\(?:mathrm|text|rm|mathsf)\s+(d)(?=\s*[A-Za-z\\}^])")
_SUM = r"\\sum(?![A-Za-z])(?:\\limits|_(?:\{[^{}]{0,12}\}|\w))?[^=:$\n&;,]{1,40}?"
_ARROW = r"\\(?:Rightarrow|Longrightarrow|implies|quad|qquad|to|rightarrow)(?![A-Za-z])"
_LAW_BEFORE = re.compile(
    rf"{_SUM}&?\s*(?:=|\\stackrel\{{!\}}\{{=\}})\s*&?\s*[^=:$\n&;,]{{1,24}}?&?\s*(?::|{_ARROW})(?=[^$\n]*?=)"
)
_LAW_IN_CHAIN = re.compile(rf"{_SUM}&?\s*=(?=[^=$\n;:]{{1,200}}=)(?![^=]*{_ARROW})")
_OR = re.compile(r"\\(?:lor|vee)(?![A-Za-z])")
_OR_IN_OTHER_WORDS = re.compile(r"(?<=[\s,{])(?:oder|ou|bzw\.)(?=[\s}])")
_OR_SIGN = re.compile(r"\s?∨\s?")
_SIGN = r"(?:[<>≤≥≠]|\\(?:[lg]eq?|neq?|[lg]eqslant)(?![A-Za-z]))"
_SIZE = r"\\?(?:left|right|big|Big)?"
_CONDITION = re.compile(
    rf"(?:\\q?quad(?![A-Za-z])|\\[,;:! ]|~|\s)\s*{_SIZE}\s*\((?=[^()]*{_SIGN})[^(){{}}$\n=]{{1,80}}{_SIZE}\)"
    r"(?=\s*[.,;]?\s*(?:\$|\\\]|\\\)|\\\\|\\end|\Z))"
)
"""A condition in parentheses at the end of an equation in LaTeX, which has no rate: friction depends on its sign."""


_CLAIM = re.compile(
    r"(?:[,;.]\s*|(?<=\s)|^)(?:\\text\s?\{\s*)?(?:and\s+)?(?:it|they|(?:the|a)\s+[a-z]{1,20})?\s*\b"
    r"(?:rolls?|(?:does|do|will)\s+not\s+(?:slip|slide|skid)|no\s+slip(?:ping)?)\b[a-z ]{0,30}?\s"
    r"(?:if\s+and\s+only\s+if|only\s+if|if|iff|when|as\s+long\s+as|provided(?:\s+that)?|requires)\s*\}?\s+"
    rf"(?=[^;,\n]{{0,80}}{_SIGN})",
    re.IGNORECASE | re.MULTILINE,
)
"""The words before a condition that is a result: `rolls if mu >= tan(alpha)/3`."""
_ABOUT_AS_WELL = re.compile(
    r"(?<=[\w)}°²$])\s+\((?:[^()=<>≤≥$]{0,24}?)(?:≈|≃|\\approx(?![A-Za-z])|\bapprox\.?|\bca\.|\bi\.\s?e\.)"
    r"\s*[-+−]?[0-9][^()=<>$]{0,24}\)"
)
"""A number in parentheses after an exact result, `cos θ = 2/3 (θ ≈ 48.2°)`."""
_NUMBER_AMONG_LETTERS = re.compile(r"(?<![\w\\.])(?P<word>[A-Za-z]{1,5}) (?=[2-9](?:[A-Za-z](?![A-Za-z]{2})|\())")
"""A number right before a letter, after a name: `m g 2R`. An index, `x 2`, stands alone."""
_ITALIC = re.compile("[\u210e\U0001d400-\U0001d7ff]+")
_GREEK = "".join(GREEK)
_ALIAS = re.compile(
    rf"(?P<before>^|\s)\((?P<name>[A-Za-z{_GREEK}](?:_?\w)?\s*(?:=|≡)\s*(?!pi\b)[A-Za-z{_GREEK}]\w{{0,12}})\)(?=[\s.,;]|\Z)",
    re.MULTILINE,
)
"""What a letter stands for, in parentheses: `(a = alpha)`."""
_DEFINED_BEFORE = re.compile(
    r"^\s*(?:with|where|let|setting|writing|putting|mit|avec)\s+(?P<one>[^=:\n]{1,40}=[^=:\n<>≤≥]{1,60}):(?=\s[^\n]*[=<>≤≥])",
    re.IGNORECASE | re.MULTILINE,
)
"""`with tan(phi) = mu: P <= ...`"""
_NAME_OF_WORDS = re.compile(
    r"^(?P<before>[\s$]*)(?P<name>[A-Z](?:_\w{1,3})?)(?P<words>\s(?:about|of|at|for|in|along|around|through|on|round)(?:\s[a-z]{2,12}){1,4})(?=\s*=(?!=))",
    re.MULTILINE,
)
"""A letter with the words that say what it is: `I about the shaft = m R^2`."""
_FUNCTION_OF_TIME = re.compile(r"(?P<name>\b[A-Za-z]\w{0,12}\s*:=\s*)(?P<arrow>\(?\s*t\s*\)?\s*->\s*)")
"""Maple's `v := t -> a*t`."""
_AT_REST = re.compile(
    r"\((?P<first>\$?\s*(?:\\d{1,2}ot\s*(?:\{\s*\\?\w+\s*\}|\\?\w+)|[^\W\d_]\w{0,8}(?:'{1,2}|[\u0307\u0308]))(?:_\w)?\s*=)"
    r"[^()+*/^]{0,60}?(?<=[=\s])0\s*\$?\)"
)
"""A condition in parentheses after the name of a motion: `steady (\\ddot\\theta = \\dot\\theta = 0)`."""
_FOR_ALL = re.compile(
    r"\((?:for|at|with)\s+(?:every|all|any|each|arbitrary)(?:\s+values?\s+of)?\s+\\?[^\W\d]\w{0,12}\)|"
    r"(?<=\s)(?:every|all|any|each|arbitrary)(?:\s+values?\s+of)?\s+\\?[^\W\d]\w{0,12}\s+(?:if|when|for|where|provided(?:\s+that)?)(?=\s[^=<>≤≥]*=)"
)
"""For which positions an equation between parameters holds: `(for every theta) W = c h`, `any theta if W = c h`."""
_COLON_BEFORE_CONDITION = re.compile(r"^([^:\n<>≤≥]*=[^=:<>≤≥\n]{1,80}):(?=\s+[^:=\n]{1,60}[<>≤≥])", re.MULTILINE)
_COLON_BEFORE_EQUATION = re.compile(r"^([^:\n]*[^:=\n]=[^=:\n]{1,120}):(?=\s+[^:=\n]{1,80}=(?!=))", re.MULTILINE)
"""What separates an equation from the next one: `N_1 = W_1: F <= ...`, `\\ddot x = 0: T = m g`."""
_MUST_BE = re.compile(
    r",?\s+(?:(?:which|this|it|and|das|dies)\s+)?(?:must|has\s+to|needs\s+to|should|muss|doit)\s+(?:(?:be|être)(?=\s*[<>≤≥])|(?=[<>≤≥]))"
)
"""Words before the sign of a condition: `N = W - P h/b, must be >= 0`."""
_HALF = re.compile(r"(?<![\w\\])t(?=½\s*=)")
_AT_PLACES = re.compile(
    r"^(?P<label>[ \t]*(?:(?:eigen)?frequenc(?:y|ies)|Frequenz(?:en)?|ω|omega|w)\s*:)"
    r"(?P<items>(?:[^=:;\n]{1,80}\s(?:about|around|at|near|for|um|bei|für)\s[^=:;\n]{1,40}=[^=:;\n]{1,60}(?:;|$)){1,6})",
    re.IGNORECASE | re.MULTILINE,
)
"""`frequencies: a about theta = 0; b about theta = pi`."""
_RATE = r"\\?(?:omega|Omega|ω|Ω)(?:_\{?\w{1,3}\}?)?(?:\s*\^\s*\{?2\}?)?\s*&?="
_AT = r"(?:at|about|around|near|for|um|bei|für)"
_RATE_AT_IN_LINE = re.compile(
    rf"\$(?P<rate>\s*{_RATE}[^$=]{{1,160}})\$\s*,?\s+\(?{_AT}\s+(?:the\s+(?:equilibrium|position)\s+)?"
    r"\$(?P<place>[^$=<>]{1,40}=[^$=<>]{1,60})\$\)?"
)
_INSIDE = r"(?!\\\\|\\(?:text|q?quad|end|\])|[=$\n;])."
_RATE_AT = re.compile(
    rf"(?P<rate>{_RATE}(?:{_INSIDE}){{1,160}}?)(?:\\[,;:! ]|\\q?quad|~|\s)*"
    rf"\\text\{{\s*\(?{_AT}(?:\s+the\s+(?:equilibrium|position))?\s*\}}"
    rf"(?P<place>(?:{_INSIDE}){{1,40}}=(?:{_INSIDE}){{1,60}}?)(?:\\text\{{\s*\)\s*\}}|(?<![\w}})])\))?(?=\s*(?:[,.]?\s*(?:\\\\|\\(?:text|q?quad|end|\])|[$\n;])|,|\.?\s*\Z))"
)
"""The place of a frequency after it: `$\\omega^2 = g/R$ at $\\theta = 0$`, `\\omega = a \\text{ at } \\theta = 0`."""
_RADIANS = re.compile(r"(?<=[0-9])(?P<unit>\s?rad)(?![A-Za-z/^])(?=[\s.,;)]|\Z)")
"""The unit of an angle after a number, which is 1."""
_OF_MAXIMA = re.compile(
    r"^\s*\(%[io][0-9]{1,4}\)|(?<![A-Za-z0-9_'])'(?=(?:diff|integrate)\()|%(?=(?:pi|e)\b)", re.MULTILINE
)
"""Labels and nouns of Maxima: `(%o5)`, `'diff(x, t, 2)`, `%pi`."""
_SINE = re.compile(r"(?<![A-Za-z_\\])sen(?=\s?(?:\^|²|³|\(|[^\W\d_]))(?![a-z]{2})")
"""`sen α`, the sine in Spanish, Italian and Portuguese."""
_GREEK_INDEX = re.compile(rf"(?<![A-Za-z0-9_])(?P<name>[A-Za-z]{{1,3}})_(?P<index>[{_GREEK}])(?![A-Za-z0-9_])")
_KEPT = re.compile(
    r"(?:(?<=[)}²³'\u0307])|(?<=\^[0-9]))\s+(?:is|ist|est|es)\s+(?:conserved|constant|erhalten|konstant|conserv[ée]e?|constante?)"
    r"(?:\s*\(\s*=\s*(?P<value>[^()=\n]{1,20})\))?(?=[\s.,;)]|\Z)"
)
"""`p = m r^2 φ' is conserved (= h)`."""
_DICTIONARY = re.compile(r"\s*\[?\{(?P<items>\s*[^\W\d]\w{0,12}(?:\(t\)|'{1,2})?\s*:[^{}]*)\}\]?\s*")
_ITEM = re.compile(r"\s*(?P<name>[^\W\d]\w{0,12}(?:\(t\)|'{1,2})?)\s*:(?!=)(?P<value>[^:]*)\Z")
_NO_NAMES = "arcsin arccos arctan ln sgn to is of and or by at in for the with so are as eq case dt"
_FUNCTIONS = frozenset({*FUNCTIONS, *_NO_NAMES.split()})


def in_usual_signs(text: str) -> str:
    """The text without these habits."""
    text = _of_dictionary(text)
    if "\\" not in text:
        text = _OF_MAXIMA.sub(_blank, text)
        text = _SINE.sub("sin", text)
        text = _GREEK_INDEX.sub(lambda m: f"{m['name']}_{GREEK[m['index']]}", text)
        text = _KEPT.sub(lambda m: f" = {m['value'].strip()} = const" if m["value"] else " = const", text)
    text = _ITALIC.sub(lambda m: normalize("NFKC", m[0]), text)
    text = _NAME_OF_WORDS.sub(lambda m: f"{m['before']}{m['name']}{' ' * len(m['words'])}", text)
    text = _FUNCTION_OF_TIME.sub(lambda m: f"{m['name']}{' ' * len(m['arrow'])}", text)
    text = _AT_REST.sub(_blank, text)
    text = _FOR_ALL.sub("", text)
    text = _MUST_BE.sub(_blank, text)
    if ":" in text:
        text = _COLON_BEFORE_CONDITION.sub(lambda m: m[0] if "\\" in m[0] or "tabil" in m[0] else f"{m[1]};", text)
    if ":" in text and "\\" in text and "$" not in text:
        text = _COLON_BEFORE_EQUATION.sub(r"\1;", text)
    text = _HALF.sub("t_", text)
    text = _AT_PLACES.sub(lambda m: "; ".join(f"omega = {i.strip()}" for i in m["items"].split(";") if i.strip()), text)
    if "≈" in text or "approx" in text:
        text = _RADIANS.sub(lambda m: " " * len(m["unit"]), text)
    if "\\" in text:
        text = _RATE_AT_IN_LINE.sub(lambda m: f"${m['place']}$: ${m['rate']}$", text)
        text = _RATE_AT.sub(lambda m: rf"{m['place']} \quad {m['rate']}", text)
        text = _OF_COORDINATE.sub(lambda m: m["before"].ljust(len(m[0])), text)
        text = _LABELLED.sub(lambda m: "=".ljust(len(m[0])), text)
        text = _CONST.sub(r"\1} ", text)
        text = _ADDED_CONST.sub(lambda m: " const".ljust(len(m[0])), text)
        text = _UPRIGHT_D.sub(lambda m: m[1].rjust(len(m[0])), text)
        if "stab" in text and not _DISPLAY.search(text):
            text = "\n".join(map(_with_words_outside, text.split("\n")))
        if "\\sum" in text:
            text = _LAW_BEFORE.sub(_blank, text)
            text = _LAW_IN_CHAIN.sub(_blank, text)
        text = _OR.sub(r"\\text{ or }", text)
        text = _CONDITION.sub(lambda m: m[0] if "dot" in m[0] or "'" in m[0] else _blank(m), text)
    else:
        text = _ALIAS.sub(lambda m: f"{m['before']};{m['name']};", text)
        text = _DEFINED_BEFORE.sub(lambda m: f"{m[0][:-1]};", text)
    text = _OR_IN_OTHER_WORDS.sub("or", text)
    text = _CLAIM.sub(_semicolon, text)
    text = _ABOUT_AS_WELL.sub(_blank, text)
    text = _NUMBER_AMONG_LETTERS.sub(lambda m: m[0] if m["word"] in _FUNCTIONS else f"{m['word']}*", text)
    return _OR_SIGN.sub(r" \\text{ or } " if "\\" in text else " or ", text)


_DISPLAY = re.compile(r"\\\[|\\\(|\\begin|\$")
_IN_TEXT = re.compile(r"\\(?:text|mbox|textrm)\s*\{([^{}]{0,80})\}")


def _with_words_outside(line: str) -> str:
    r"""`\theta = 0 \text{ is stable for } a < b` with its mathematics between `$`, as sentences have it."""
    if not any("stab" in m[1] for m in _IN_TEXT.finditer(line)):
        return line
    return "$" + _IN_TEXT.sub(lambda m: f"$ {m[1]} $", line) + "$"


def _of_dictionary(text: str) -> str:
    """`{X: a, Y: b}` of SymPy as X = a; Y = b."""
    match = _DICTIONARY.fullmatch(text) if "{" in text and ":" in text else None
    if match is None:
        return text
    items = [_ITEM.fullmatch(match["items"][a:b]) for a, b in cuts(match["items"], re.compile(","))]
    return "; ".join(f"{i['name']} = {i['value'].strip()}" for i in items if i) if all(items) else text


def _semicolon(match: re.Match[str]) -> str:
    """The room of the match, which begins a new statement where it is not the first of its line."""
    first = match.start() == 0 or match.string[match.start() - 1] == "\n"
    return " " * len(match[0]) if first else ";".ljust(len(match[0]))


def _blank(match: re.Match[str]) -> str:
    return " " * len(match[0])
