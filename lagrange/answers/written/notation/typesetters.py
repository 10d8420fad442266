r"""Formulas in the languages of Typst, of LibreOffice and of AsciiMath, put into plain text before it is taken apart.

    Typst        $ m dot.double(x) + frac(c, 2) dot(x) = 0 \ y = 1 $     m ddot(x) + ((c)/(2)) dot(x) = 0, y = 1
    LibreOffice  m ddot x = - {c x} over {l^2 - x^2} newline ...         m (x)'' = - (c x)/(l^2 - x^2), ...
                 ddot %theta = - g over l sin %theta                     (theta)'' = - (g)/(l) sin theta
    AsciiMath    ddot theta + (g)/(l) sin theta = 0                      (theta)'' + ...

A text with a command of LaTeX is in none of them. What is no part of an equation, as alignment, becomes blank.
"""

from __future__ import annotations

import re

from lagrange.answers.limits import MOST_WRITTEN_OUT
from lagrange.expressions.edits import closings

_COMMAND = re.compile(r"\\[A-Za-z]")


def in_plain_formulas(text: str) -> str:
    """The text with formulas of these languages in plain text; the text itself where it is in none of them."""
    if _COMMAND.search(text):
        return text
    if _OF_TYPST.search(text):
        return _from_typst(text)
    return _from_starmath(text) if _OF_STARMATH.search(text) else text


# Typst


_OF_TYPST = re.compile(
    r"(?<![\w.])(?:dot\.(?:double|op)(?![\w.])|(?:theta|phi|epsilon|kappa|rho|sigma)\.alt\b|frac\((?=[^()]*[,(])|plus\.minus\b)"
    r"|\$[^$]*(?<![\w.\\])dot\([\w. ]{1,24}\)"
)
_T_WORDS = {
    "dot.double": "ddot", "dot.op": "*", "times": "*", "plus.minus": "±", "lt.eq": "<=", "gt.eq": ">=",
    "dif": "d", "upright(d)": "d", "thin": "", "med": "", "thick": "", "space": "",
    "arrow.r.double": "=>", "arrow.r": "=>",
}  # fmt: skip
_T_WORD = re.compile(
    rf"(?<![\w.\\])(?:{'|'.join(map(re.escape, sorted(_T_WORDS, key=len, reverse=True)))})(?<!\.)(?![\w.])"
)
_T_VARIANT = re.compile(r"(?<=[a-z])\.alt\b")
_T_SPACE = re.compile(r"(?P<before>[,;]\s*)?(?<![\w.\\])(?:wide|quad)(?![\w.])")
_T_TEXT = re.compile(r'(?:(?<![\w.])(?:text|op|upright)\(\s*)?"(?P<words>[^"\n]{0,80})"(?P<end>\s*\))?')
_T_LINE = re.compile(r"\\(?=\s|$)", re.MULTILINE)
_T_INDEX = re.compile(r"_\(\s*(\w{1,12})\s*\)")
_T_INDEX_OF_RATE = re.compile(r"(?P<rate>(?<![\w.])d?dot\([^()]{1,24})\)(?P<index>_\w{1,12})")
_T_GROUPS = re.compile(r"(?<![\w.])(?P<name>frac|root|cases)(?=\()")


def _from_typst(text: str) -> str:
    text = _T_TEXT.sub(_words_of_typst, text)
    text = _T_LINE.sub("\n", text)
    text = _T_WORD.sub(lambda m: _T_WORDS[m[0]], text)
    text = _T_VARIANT.sub("", text)
    text = _T_SPACE.sub(lambda m: m["before"] or " ; ", text)
    text = _T_INDEX.sub(r"_\1", text)
    text = _T_INDEX_OF_RATE.sub(r"\g<rate>\g<index>)", text)
    for _ in range(MOST_WRITTEN_OUT):
        matches = [*_T_GROUPS.finditer(text)]
        if not matches:
            break
        text = _without_group(text, matches[-1])  # the innermost is among the last
    return re.sub(r"[$&]", " ", text)


def _words_of_typst(match: re.Match[str]) -> str:
    opened = "(" in match[0][: match.start("words") - match.start()]
    return f" {match['words']} " + ("" if opened else match["end"] or "")


def _without_group(text: str, match: re.Match[str]) -> str:
    """`frac(a, b)`, `root(3, a)` or `cases(a, b)` at a match, written out."""
    end = closings(text).get(match.end())
    if end is None:
        return f"{text[: match.start()]} {text[match.end() :]}"
    parts = _at_commas(text[match.end() + 1 : end])
    match match["name"], parts:
        case "frac", [above, below]:
            made = f"(({above})/({below}))"
        case "root", [order, inside]:
            made = f"({inside})^(1/({order}))"
        case "cases", _:
            made = "\n".join(parts)
        case _:
            made = f"({', '.join(parts)})"
    return text[: match.start()] + made + text[end + 1 :]


def _at_commas(text: str) -> list[str]:
    parts, depth = [""], 0
    for char in text:
        depth += (char in "([{") - (char in ")]}")
        if char == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += char
    return [p.strip() for p in parts if p.strip()]


# LibreOffice and AsciiMath


_OF_STARMATH = re.compile(
    r"(?<!\w)ddot\s+[%{]?[^\W\d_]|(?<![\w%])%[A-Za-z]{2,8}\b|\}\s*over\s*[\w%{]|(?<!\w)[\w%]{1,8}\s+over\s+\{|(?<!\w)newline(?!\w)"
)
_S_WORDS = {"newline": "\n", "cdot": "*", "times": "*", "left": "", "right": "", "alignl": "", "alignr": "",
    "nitalic": "", "ital": "", "bold": "", "func": "", "dlarrow": "", "drarrow": "=>", "toward": "=>",
    "sup": "^", "sub": "_", "partial": "∂"}  # fmt: skip
_S_WORD = re.compile(rf"(?<![\w%])(?:{'|'.join(_S_WORDS)})(?!\w)")
_S_GREEK = re.compile(r"%(?P<var>var)?(?P<name>[A-Za-z]{2,8})(?!\w)")
_S_RATE = re.compile(
    r"(?<!\w)(?P<dots>d{0,2}dot)\s*(?P<name>\{\s*[^\W\d_]\w{0,12}\s*\}|(?<=\s)[^\W\d_][^\W_]{0,12})(?P<index>_\w{1,3})?"
)
_S_INDEX = re.compile(r"_\s*\{\s*(\w{1,12})\s*\}")
_S_OVER = re.compile(r"(?<!\w)over(?!\w)")
_S_OPERAND = re.compile(r"\(|[^\W_]\w*(?:'{0,3})(?:\s*\^\s*\w+)?")
_S_ALONE = re.compile(r"\w+'*|[d∂](?:\^\(?2\)?)?\s*(?:\w+'*(?:\s*\^\s*\(?2\)?)?)?")
_S_OPERATOR = re.compile(r"[d∂](?:\^2|\s*\w{1,12})?\s*\Z")
_S_STACK = re.compile(r"(?<!\w)(?:stack|binom|matrix)(?=\s*\{)|(?<!#)#(?!#)")


def _from_starmath(text: str) -> str:
    text = re.sub(r'"([^"\n]{0,80})"', r" \1 ", text)
    text = _S_GREEK.sub(lambda m: f" {m['name'] if m['name'].islower() else m['name'].capitalize()}", text)
    text = _S_WORD.sub(lambda m: _S_WORDS[m[0]], text)
    text = _S_INDEX.sub(r"_\1", text)
    text = _S_RATE.sub(_rate_of_starmath, text)
    text = _S_STACK.sub(lambda m: "\n" if m[0] == "#" else "", text)
    text = text.replace("`", " ").replace("~", " ").translate({ord("{"): "(", ord("}"): ")"})
    for _ in range(MOST_WRITTEN_OUT):
        match = _S_OVER.search(text)
        if match is None:
            break
        text = _with_fraction(text, match)
    return text


def _rate_of_starmath(match: re.Match[str]) -> str:
    order = {"dot": 1, "ddot": 2, "dddot": 3}[match["dots"]]
    return f" {match['name'].strip('{} ')}{match['index'] or ''}{chr(39) * order} "


def _with_fraction(text: str, match: re.Match[str]) -> str:
    """`a over b` at a match as ((a)/(b)): what is in brackets, or one name or number, on each side."""
    start, end = _before(text, match.start()), _after(text, match.end())
    above, below = _grouped(text[start : match.start()]), _grouped(text[match.end() : end])
    operator = _S_OPERATOR.match(above)
    return f"{text[:start]}{above}/{below} {text[end:]}" if operator else f"{text[:start]}({above}/{below}){text[end:]}"


def _grouped(operand: str) -> str:
    """An operand in the brackets that it needs: none for one name or number, nor for the d of a derivative."""
    operand = operand.strip()
    if operand[:1] == "(" and closings(operand).get(0) == len(operand) - 1:
        operand = operand[1:-1].strip()
    return operand if _S_ALONE.fullmatch(operand) else f"({operand})"


def _before(text: str, at: int) -> int:
    """Where the operand that ends at `at` begins."""
    at = len(text[:at].rstrip())
    if text[at - 1 : at] == ")":
        return next((start for start, end in closings(text).items() if end == at - 1), at - 1)
    while at and (text[at - 1].isalnum() or text[at - 1] in "_'^."):
        at -= 1
    return at


def _after(text: str, at: int) -> int:
    """Where the operand that begins at `at` ends."""
    at += len(text[at:]) - len(text[at:].lstrip())
    match = _S_OPERAND.match(text, at)
    if match is None:
        return at
    return closings(text).get(at, at) + 1 if match[0] == "(" else match.end()
