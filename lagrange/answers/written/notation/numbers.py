r"""Numbers as they are written: with units, with decimal commas.

Numbers with units among expressions, in SI: `12 cm` as (12)*(1/100), `9.81\,\mathrm{m/s^2}` as (9.81).

In plain text a unit is one in which at least one letter is no name of the problem: `2 m` beside a mass m is twice a
mass, `9.81 m/s^2` is an acceleration where no `s` is declared. In LaTeX a unit is upright, and is meant wherever it
stands after a number.

Decimal commas, `2,5 R` for 2.5 R: a comma between two digits, without a space, outside lists and indices.

Each is replaced by a point, so that the text keeps its length and every place in it. A comma in the brackets of a
function of several arguments, in a list `[1,2]`, in braces `x_{1,2}` or in an enumeration `1,2,3` is not a decimal
comma, and neither is that of `10,000`, which may separate thousands.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

import sympy as sp

from lagrange.core.units import unit_of
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Edit
from lagrange.expressions.latex_names import LatexNames
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role

_WORD = r"[A-Za-zµμΩ]{1,6}(?:\s?\^\s?[({]?\s?[-−]?[1-4]\s?[)}]?|[²³]|⁻[¹²³])?"
_UNIT = re.compile(
    rf"(?<![A-Za-z_0-9.])(?P<number>[0-9]{{1,12}}(?:\.[0-9]{{1,12}})?)\s?\*?\s?"
    rf"(?P<unit>(?:{_WORD}|1)(?:\s?[/·⋅*]\s?{_WORD}|(?<=[NgJs])\s{_WORD}|\s(?:s|m|kg)(?:\^-[12]|⁻[¹²]))*)(?![A-Za-z0-9_('])"
)
_NAME = re.compile(r"[A-Za-zµμΩ]+")
_TEN_TO = re.compile(r"(?<![0-9.])10\s*(?:\^|\*\*)\Z")
"""Before the exponent of a power of ten, 3*10^2 m: other exponents have no unit."""
_UPRIGHT = (
    r"\\(?:text|textrm|mathrm|mbox|rm|si|unit|textup)\s*\{[^{}]{1,24}(?:\{[^{}]{1,4}\}[^{}]{0,24}){0,3}\}"
    r"(?:\s*\^\s*(?:\{\s*-?[1-4]\s*\}|[1-4]))?"
)
_NUMERAL = r"[0-9]{1,12}(?:\.[0-9]{1,12})?(?:\s*\\(?:cdot|times)\s*10\s*\^\s*(?:\{\s*-?[0-9]{1,2}\s*\}|[0-9]))?"
_IN_LATEX = re.compile(
    rf"(?<![A-Za-z0-9.}}])(?<!frac )(?P<number>{_NUMERAL})(?P<space>(?:\s|~|\\[,;:! ])*)"
    rf"(?P<unit>{_UPRIGHT}(?:(?:\s|\\[,;: ]|~)*(?:/|\\cdot|\\times)?(?:\s|\\[,;: ])*{_UPRIGHT})*"
    rf"|\\[dt]?frac\s*\{{\s*{_UPRIGHT}\s*\}}\s*\{{\s*{_UPRIGHT}\s*\}})(?=\s*(?:\Z|[-=+−,;.$)&\]}}]|\\))"
)
_SIUNITX = re.compile(r"\\(?:SI|qty)\s*\{(?P<number>[^{}]{1,24})\}\s*\{(?P<unit>[^{}]{1,40})\}")
_MACROS = {
    r"\kilogram": "kg",
    r"\newton": "N",
    r"\radian": "rad",
    r"\joule": "J",
    r"\hertz": "Hz",
    r"\meter": "m",
    r"\metre": "m",
    r"\second": "s",
    r"\per": "/",
    r"\squared": "^2",
    r"\centi": "c",
    r"\milli": "m",
    r"\kilo": "k",
}


def units_in_si(text: str, scope: Scope) -> Iterator[Edit]:
    """The numbers with units in plain text."""
    for match in _UNIT.finditer(text):
        names = _NAME.findall(match["unit"])
        if not names or all(_is_product(n, scope) for n in names):
            continue
        before = text[max(0, match.start() - 8) : match.start()].rstrip()
        if before.endswith("/") or (before.endswith(("^", "**")) and not _TEN_TO.search(before)):  # 1/2 s, R^2 Ω
            continue
        made = _in_si(match["number"], match["unit"])
        if made:
            yield match.start(), match.end(), f" {made}"


def _is_product(word: str, scope: Scope) -> bool:
    """Whether letters are a name or several of them: `mg` is a weight beside a mass and g, and no milligram."""
    names = LatexNames(scope)
    run = names.run("".join(GREEK.get(c, c) for c in word))
    return not run.several and all(names.is_declared(name) for _, name in run.pieces)


def units_of_latex_in_si(text: str, scope: Scope) -> Iterator[Edit]:
    """The numbers with upright units in LaTeX."""
    for match in (*_SIUNITX.finditer(text), *_IN_LATEX.finditer(text)):
        names = _NAME.findall(plain_unit(match["unit"]))
        spaced = match.re is _SIUNITX or match["space"] or "text" in match["unit"]
        if not spaced and all(scope.role(n) is not Role.UNDECLARED for n in names):
            continue
        made = _in_si(match["number"], plain_unit(match["unit"]), latex=True)
        if made:
            yield match.start(), match.end(), made


def plain_unit(unit: str) -> str:
    r"""`\mathrm{m}/\mathrm{s}^{2}` as m/s^2."""
    for macro, written in _MACROS.items():
        unit = unit.replace(macro, written)
    unit = re.sub(r"\\[dt]?frac\s*\{(.*)\}\s*\{(.*)\}\Z", r"\1/\2", unit)
    unit = re.sub(r"\^\s*\{([^{}]*)\}", r"^\1", unit)
    unit = re.sub(r"\\(?:text|textrm|mathrm|mbox|rm|si|unit|textup)\s*\{([^{}]*)\}", r"\1", unit)
    unit = re.sub(r"\\(?:cdot|times)", "*", re.sub(r"\\[,;:! ]|~", " ", unit))
    return re.sub(r"[{}]", "", unit).strip()


_UNIT_BEHIND = re.compile(
    r"(?:\s|~|\\[,;:! ]|\\q?quad(?![A-Za-z]))+\$?(?:in\s+)?(?:\\left\s*)?(?P<open>[\[(])(?P<unit>[^\[\]=]{1,50}?)"
    r"(?:\\right\s*)?(?P<close>[\])])[\s.,;$]*\Z"
)


def unit_behind(text: str, declared: Collection[str]) -> int:
    """Where a unit in brackets begins behind an equation, `... = -g/l sin(theta)   [rad/s^2]`; the text's end if none.

    In round brackets, and as a small letter alone, it may be a factor, unless one of its letters is no name of the
    problem.
    """
    match = _UNIT_BEHIND.search(text, text.rindex("=") + 1) if "=" in text else None
    if match is None or {match["open"], match["close"]} not in ({"[", "]"}, {"(", ")"}):
        return len(text)
    written = plain_unit(match["unit"])
    names = _NAME.findall(written)
    is_unit = bool(names) and unit_of(re.sub(r"\^\s?[({]?\s?[-−]\s?([1-4])\s?[)}]?", r"^-\1", written)) is not None
    alone = len(names) == 1 and names[0] == written and written.islower()
    may_be_factor = (match["open"] == "(" or alone) and all(n in declared for n in names)
    before = text[text.rindex("=") + 1 : match.start()].strip(" $&")
    return match.start() if is_unit and before and not may_be_factor else len(text)


_SPELLED_OUT = {"inch": "in", "inches": "in", "foot": "ft", "feet": "ft", "pounds": "lb", "metres": "m", "meters": "m"}


def _in_si(number: str, unit: str, *, latex: bool = False) -> str:
    """A number in SI, as text; empty if the unit is not known."""
    unit = _SPELLED_OUT.get(unit.strip(), unit)
    meant = unit_of(re.sub(r"\^\s?[({]?\s?[-−]\s?([1-4])\s?[)}]?", r"^-\1", unit.strip()))
    if meant is None or not re.fullmatch(r"\s*[-+−]?[0-9.]+\s*(?:\\(?:cdot|times)\s*10\s*\^.*)?", number):
        return ""
    return in_one_number(number.strip(), meant.factor, latex)


def in_one_number(number: str, factor: sp.Expr, latex: bool) -> str:
    """`84.9` kN as (84.9)*10^3: 84.9e3 is a product where `e` is declared, and 1000 would count as rounded, too."""
    power = next((n for n in range(-12, 13) if sp.Integer(10) ** n == factor), None)
    if factor == 1:
        product = f"({number})"
    elif power is not None and _PLAIN.fullmatch(number):
        product = f"({number}){'*' if power > 0 else '/'}10^{_exponent(abs(power), latex)}"
    else:
        product = f"({number})*({_in_short_numbers(factor)})"
    return product.replace("*", r" \cdot ") if latex else product


def _exponent(power: int, latex: bool) -> str:
    return f"{{{power}}}" if latex else str(power)


def _in_short_numbers(factor: sp.Expr) -> str:
    """A factor without numbers of three digits, which would count as rounded: an inch is (2+54/(10*10))/(10*10) m."""
    if not factor.is_Rational or factor.q <= 1 or factor.q >= 10**14:
        return str(factor).replace("180", "(2*90)")
    digits = next((n for n in range(0, 20, 2) if (10**n) % factor.q == 0), None)
    if digits is None:
        return str(factor)
    pairs, whole = [], int(factor * 10**digits)
    for _ in range(digits // 2):
        whole, pair = divmod(whole, 100)
        pairs.append(pair)
    text = "0"
    for pair in pairs:
        text = f"({pair}+{text})/(10*10)"
    return f"{whole}+{text}" if whole < 100 else str(factor)


_PLAIN = re.compile(r"[-+]?[0-9]+(?:\.[0-9]+)?")


# Decimal commas


_COMMA = re.compile(
    r"(?<![0-9A-Za-z_,.])(?![1-9][0-9]{0,2},[0-9]{3}(?![0-9]))([0-9]{1,9}),(?=[0-9]{1,12}(?![0-9]*[,.][0-9]))"
)
_CALL = re.compile(r"[A-Za-z0-9_]\s?\Z")
_OF_ONE = re.compile(
    r"(?<![A-Za-z])(?:a?(?:rc)?(?:sin|cos|tan)h?|cot|exp|ln|log|sqrt|abs)\s?\Z|(?<![A-Za-z0-9_.])[0-9.]+\s?\Z|\s\Z"
)
"""What may precede the brackets of one value: a function of one argument, or a factor."""
_OPENING, _CLOSING = "([{", ")]}"


def with_decimal_points(text: str) -> str:
    """The text with decimal points; of the same length."""
    if not _COMMA.search(text):
        return text
    commas = {m.end() - 1 for m in _COMMA.finditer(text)}
    made = [*text]
    opened: list[bool] = []  # of each open bracket, whether commas in it separate
    for at, char in enumerate(text):
        if char in _OPENING:
            opened.append(char != "(" or _has_several(text[max(0, at - 12) : at]))
        elif char in _CLOSING and opened:
            opened.pop()
        elif char == "\n":
            opened = []
        elif at in commas and (not opened or not opened[-1] or _is_argument(text, at)):
            made[at] = "."
    return "".join(made)


def _has_several(before: str) -> bool:
    """Whether brackets after a text hold several arguments, as those of a function that is not known."""
    return _CALL.search(before) is not None and _OF_ONE.search(before) is None


def _is_argument(text: str, at: int) -> bool:
    r"""Whether a comma is inside the braces of a LaTeX argument, as in `\frac{2,5}{3}` or `\sqrt{0,5}`."""
    opening = text.rfind("{", 0, at)
    return opening > 0 and re.search(r"(?:\\[A-Za-z]+|\})\s*\Z", text[max(0, opening - 12) : opening]) is not None
