r"""Other notations of an equation in LaTeX, rewritten with the commands that are read; nothing is ever run as code.

\dv[2]{x}{t}   \pdv{L}{x}   {a \over b}            \frac{d^2x}{dt^2}   \frac{\partial L}{\partial x}   \frac{a}{b}
\overset{..}{x}   \color{red}   \underbrace{a}_{b}   \ddot{x}   (nothing)   a
x^(1/2)   \dot x^2\,4c                             x^{1/2}   \dot x^2 \cdot 4c
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from lagrange.answers.written.notation.numbers import units_of_latex_in_si
from lagrange.answers.written.notation.plain import characters, is_velocity, of_argument
from lagrange.answers.written.notation.rare import extremes, ratio_as_fractions, special_latex
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, Edit, closings
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role

_L_OVER = re.compile(r"\\over(?![A-Za-z])")
_L_POWER_GROUP = re.compile(r"\^\s*\(")
_L_BEFORE_NUMBER = re.compile(
    r"(?:(?<=[A-Za-z})\]])|(?P<power>\^\s*(?:[0-9]|\{\s*[0-9]{1,2}\s*\})))\s*"
    r"(?P<space>(?:\\[,;:! ]|~)\s*)*(?<=[\s~,;:!])(?=[0-9])"
)
_L_FUNCTION = re.compile(r"\\(?:sin|cos|tan|cot|sinh|cosh|tanh|ln|log|exp|sqrt|begin|[a-z]*arrow)\s*\Z")
_L_COLOUR = re.compile(r"\\(?:color|textcolor|colorbox)\s*(?:\[[A-Za-z]{1,8}\])?\s*\{[^{}\\]{0,40}\}")
_L_TIES = re.compile(r"(?<=\{)\s*(?:~\s*)+(?=d\b)")
"""The tie that handwriting recognition puts before a differential: `\\mathrm{~d} t`."""
_L_DROPPED = re.compile(
    r"\\(?:mathcal|mathscr|mathfrak|mathop|mathbin|mathrel|mathord|mathstrut|strut|bf|it|large|Large|small"
    r"|underline|overline|uwave|smash|therefore|because|implies|Rightarrow|Longrightarrow|rightarrow|to|leadsto|iff"
    r"|Leftrightarrow|blacksquare|square|Box|qed|checkmark|vdots|lvert_|unicode\{[0-9x]+\})(?![A-Za-z])|\\(?:left|right|Bigg?r?)\s*\."
)
_L_DEGREES = re.compile(
    r"(?<=[0-9])\s*(?:\^\s*(?:\\circ(?![A-Za-z])|\{\s*\\circ\s*\})|\\(?:degree|textdegree)(?![A-Za-z])|°)"
)
_L_FRAC = re.compile(r"\\(?:nicefrac|sfrac|flatfrac|xfrac)(?![A-Za-z])")
_L_OVERSET = re.compile(
    r"\\(?:overset|stackrel)\s*\{\s*(\.{1,3}|(?:\\cdot\s*){1,3}|(?:\\bullet\s*){1,3})\s*\}\s*(?=[{\\A-Za-z])"
)
_L_SIGNS = re.compile(r":=|\\(?:equiv|coloneqq|triangleq)(?![A-Za-z])|\\(?:overset|stackrel)\s*\{[^{}]{0,20}\}\s*\{=\}")
_L_CANCEL = re.compile(r"\\(?:cancel|bcancel|xcancel|sout|not)\s*(?=\{)")
_L_BRACE = re.compile(r"\\(under|over)(?:brace|bracket|line|set)\s*(?=\{)")
_L_DV = re.compile(r"\\(?P<kind>dv|odv|derivative|pdv|pderivative|fdv)\*?\s*(?:\[\s*(?P<order>[1-4])\s*\])?\s*(?=\{)")
_L_PARTIAL = re.compile(
    r"\\[dt]?frac\s*\{\s*(?:d|\\mathrm\s*\{\s*d\s*\}|\\dd)\s*(?P<f>[A-Za-z]+|\\[A-Za-z]+)\s*\}"
    r"\s*\{\s*(?:d|\\mathrm\s*\{\s*d\s*\}|\\dd)\s*(?P<x>\\?[A-Za-z]+(?:_\{?[A-Za-z0-9]{1,4}\}?)?)\s*\}"
)
_L_ALONG = re.compile(
    r"\\[dt]?frac\s*\{\s*(?:d|\\mathrm\s*\{\s*d\s*\})\s*\\dot\s*(?P<f>\{\s*\\?[A-Za-z]+\s*\}|\s[A-Za-z]|\\[A-Za-z]+)\s*\}"
    r"\s*\{\s*(?:d|\\mathrm\s*\{\s*d\s*\})\s*(?P<x>\\?[A-Za-z]+(?:_\{?[A-Za-z0-9]{1,4}\}?)?)\s*\}"
)
_L_DIFFERENTIAL = re.compile(
    r"(?<![A-Za-z\\{^_/])d\s*(?P<name>(?:\\[A-Za-z]+|[A-Za-z])(?:_\{?\w{1,4}\}?)?)(?![A-Za-z'^])"
)
"""`dx`, `d\\phi`, outside fractions."""
_L_INVERSE = re.compile(r"\\(sin|cos|tan)\s*\^\s*\{\s*-\s*1\s*\}")
_L_STARS = re.compile(r"\*\*")
_L_NAMED = re.compile(
    r"\\(?:mathrm|text|operatorname\*?)\s*\{\s*([aA]rctan|[aA]rcsin|[aA]rccos|[Ss]in|[Cc]os|[Tt]an|[Cc]ot|sgn|sign|ln|log|exp)\s*\}"
)


def rewritten_latex(fragment: Fragment, scope: Scope, *, keep_cancelled: bool = False) -> Fragment:
    """A LaTeX text with other commands replaced by those that are understood."""
    draft = Draft(fragment)
    characters(draft)
    special_latex(draft)
    draft.replace(_L_COLOUR, "")
    draft.replace(_L_TIES, "")
    draft.apply(units_of_latex_in_si(draft.text, scope))
    draft.apply(ratio_as_fractions(draft.text))
    draft.apply(extremes(draft.text, latex=True))
    draft.replace(_L_DEGREES, r"\\frac{\\pi}{2\\cdot 90}")  # 180 would count as rounded
    draft.replace(_L_SIGNS, "=")
    draft.replace(_L_OVERSET, lambda m: "\\" + "d" * (m[1].count(".") or m[1].count("\\")) + "ot")
    draft.replace(_L_DROPPED, lambda m: None if m[0].startswith("\\overline") else " ")
    draft.replace(_L_FRAC, r"\\frac")
    draft.replace(
        _L_NAMED, lambda m: r"\operatorname{" + m[1] + "}" if m[1] in ("sgn", "sign") else "\\" + m[1].lower() + " "
    )
    draft.replace(_L_STARS, "^")
    draft.replace(_L_INVERSE, r"\\arc\1 ")
    draft.apply(_cancelled(draft.text, keep_cancelled))
    draft.apply(_braces(draft.text))
    for _ in range(4):  # nested, the outer first
        if not draft.apply(_physics(draft.text)):
            break
    draft.apply(over_as_fraction(draft.text))
    draft.replace(_L_ALONG, lambda m: None if m["x"] == "t" else rf"\frac{{\ddot{m['f']}}}{{\dot{{{m['x']}}}}}")
    draft.replace(_L_SECOND, lambda m: _second_as_partial(m, scope))
    draft.replace(_L_PARTIAL, lambda m: _total_as_partial(m, scope))
    if scope.role("d") is Role.UNDECLARED:
        draft.replace(_L_DIFFERENTIAL, lambda m: _upright(m, scope))
    draft.replace(_L_BY_TIME, lambda m: _with_dots(m, scope))
    draft.replace(_L_BEFORE_BRACKETS, lambda m: rf"\left({m[0]}\right)" if m["f"] in scope.functions else None)
    draft.apply(_of_argument_in_latex(draft.text, scope))
    draft.apply(power_groups(draft.text))
    draft.apply(products_with_numbers(draft.text))
    return draft.finished(latex=True)


_L_BY_TIME = re.compile(
    r"(?P<name>\\[A-Za-z]+|(?<![A-Za-z\\])[A-Za-z])(?:_\{?(?P<index>[0-9])(?:,\s*)?)?(?(index)|_)"
    r"(?:\{\s*(?P<braced>t{1,2})\s*\}|(?P<bare>t)|(?(index)(?P<joined>t{1,2})\}|(?!)))(?![A-Za-z])"
)
"""A derivative by the time as an index: `\\theta_{tt}`, `x_t`, `x_{1,tt}`."""


def _with_dots(match: re.Match[str], scope: Scope) -> str | None:
    name = match["name"] + (f"_{match['index']}" if match["index"] else "")
    order = len(match["braced"] or match["bare"] or match["joined"])
    spelled = re.sub(r"[\\]", "", name)
    if not _is_moving(name, scope) or scope.role(f"{spelled}_{'t' * order}") is not Role.UNDECLARED:
        return None
    return rf"\{'d' * order}ot{{{name}}}"


def _upright(match: re.Match[str], scope: Scope) -> str | None:
    r"""dx with an upright d, which no product has; None in fractions and after `\mathrm`, where it is one already."""
    before = match.string[: match.start()].rstrip()
    if before.endswith(("{", "\\mathrm", "\\rm")) or not _is_moving(match["name"], scope):
        return None
    return rf"\mathrm{{d}}{match['name']}"


def _is_moving(name: str, scope: Scope) -> bool:
    """Whether a name in LaTeX is that of a coordinate, or the time."""
    plain = re.sub(r"[\\{}\s]", "", name)
    names = {q.name for q in scope.slots.coordinates}
    return plain == "t" or not names.isdisjoint({plain, plain.replace("_", ""), plain.replace("var", "")})


def _of_argument_in_latex(text: str, scope: Scope) -> Iterator[Edit]:
    for start, end, new in of_argument(text, scope, bare=True):
        order = new.count("diff(")
        name, argument, *_ = new.replace("diff(", "").replace(")", "").split(", ")
        power = f"^{order}" if order > 1 else ""
        by = _in_latex(argument)
        # in parentheses, since what follows in brackets is a factor and no argument
        yield start, end, rf"\left(\frac{{\partial{power} {_in_latex(name)}}}{{\partial {by}{power}}}\right)"


def _in_latex(name: str) -> str:
    return f"\\{name}" if name in GREEK.values() else name


_L_BEFORE_BRACKETS = re.compile(
    r"\\[dt]?frac\s*\{\s*\\partial(?:\s*\^\s*\{?2\}?)?\s*(?P<f>[A-Za-z])\s*\}\s*\{\s*\\partial\s*\\?[A-Za-z]+(?:\s*\^\s*\{?2\}?)?\s*\}"
    r"(?=\s*(?:\\left|\\[bB]igg?l?)?\s*\()"
)
"""A derivative of a function before brackets, which are a factor and not its argument."""
_L_SECOND = re.compile(
    r"\\[dt]?frac\s*\{\s*d\s*\^\s*\{?\s*2\s*\}?\s*(?P<f>[A-Za-z])\s*\}\s*\{\s*d\s*(?P<x>\\?[A-Za-z]+)\s*\^\s*\{?\s*2\s*\}?\s*\}"
)


def _second_as_partial(match: re.Match[str], scope: Scope) -> str | None:
    r"""`\frac{d^2 f}{dx^2}` as a partial derivative, where f is a function of the problem and x is not the time."""
    if match["x"] == "t" or match["f"] not in scope.functions or scope.role("d") is not Role.UNDECLARED:
        return None
    return rf"\left(\frac{{\partial^2 {match['f']}}}{{\partial {match['x']}^2}}\right)"


def _total_as_partial(match: re.Match[str], scope: Scope) -> str | None:
    r"""`\frac{dU}{dr}` as a partial derivative, where U is a function or a quantity and r is not the time."""
    if match["x"] == "t" or scope.role("d" + match["f"]) is not Role.UNDECLARED:
        return None
    if is_velocity(match["f"].lstrip("\\"), "", scope):
        return rf"\frac{{\frac{{d}}{{dt}}\left({match['f']}\right)}}{{\dot{{{match['x']}}}}}"
    return rf"\frac{{\partial {match['f']}}}{{\partial {match['x']}}}"


def _cancelled(text: str, keep: bool) -> Iterator[Edit]:
    ends: dict[int, int] | None = None
    for match in _L_CANCEL.finditer(text):
        ends = closings(text) if ends is None else ends
        if (end := ends.get(match.end())) is not None:
            yield (match.start(), match.end(), "") if keep else (match.start(), end + 1, " ")


def _braces(text: str) -> Iterator[Edit]:
    r"""`\underbrace{a}_{b}` as {a}."""
    ends: dict[int, int] | None = None
    for match in _L_BRACE.finditer(text):
        if match[0].rstrip().endswith(("line", "set")):
            continue
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        if end is None:
            continue
        yield match.start(), match.end(), ""
        label = re.compile(r"\s*[_^]\s*(?=\{)").match(text, end + 1)
        if label and label.end() in ends:
            yield end + 1, ends[label.end()] + 1, ""


def _physics(text: str) -> list[Edit]:
    r"""`\dv[2]{x}{t}`, `\dv{t}(...)`, `\pdv{L}{x}`, outermost ones only."""
    edits: list[Edit] = []
    ends: dict[int, int] | None = None
    done = -1
    for match in _L_DV.finditer(text):
        ends = closings(text) if ends is None else ends
        first = match.end()
        if match.start() < done or first not in ends:
            continue
        above = text[first + 1 : ends[first]].strip()
        at = ends[first] + 1
        following = re.compile(r"\s*(?=\{)").match(text, at)
        below = ""
        if following and following.end() in ends:
            below = text[following.end() + 1 : ends[following.end()]].strip()
            at = ends[following.end()] + 1
        else:
            above, below = "", above
        total = match["kind"] in ("dv", "odv", "derivative") and below == "t"
        sign = "d" if total else r"\partial "
        power = f"^{match['order']}" if match["order"] else ""
        edits.append((match.start(), at, rf"\frac{{{sign}{power} {above}}}{{{sign}{below}{power}}}"))
        done = at
    return edits


def over_as_fraction(text: str) -> Iterator[Edit]:
    r"""`{a \over b}` as \frac{a}{b}."""
    if "\\over" not in text:
        return
    ends = closings(text)
    opened = sorted((start, end) for start, end in ends.items() if text[start] == "{")
    for match in _L_OVER.finditer(text):
        around = [(s, e) for s, e in opened if s < match.start() < e] if len(opened) <= 200 else []
        if around:
            start, _ = around[-1]
            yield start, start + 1, r"\frac{"
            yield match.start(), match.end(), "}{"


def products_with_numbers(text: str) -> Iterator[Edit]:
    r"""`\dot x^2\,4c` and `x^2 4c` as products with 4: after a power, or a space that is visible in print."""
    for match in _L_BEFORE_NUMBER.finditer(text):
        is_argument = _L_FUNCTION.search(text, max(0, match.start() - 20), match.start())
        if (match["power"] or match["space"]) and not is_argument:
            yield match.end(), match.end(), r"\cdot "


def power_groups(text: str) -> Iterator[Edit]:
    """`x^(1/2)` as x^{1/2}."""
    ends: dict[int, int] | None = None
    for match in _L_POWER_GROUP.finditer(text):
        ends = closings(text) if ends is None else ends
        at = match.end() - 1
        if at in ends:
            yield at, at + 1, "{"
            yield ends[at], ends[at] + 1, "}"
