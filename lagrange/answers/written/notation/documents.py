r"""Answers in documents: HTML as Moodle stores it, LaTeX with abbreviations of its own.

Answers as HTML, as Moodle stores what is typed into its editor: the text, one line for each paragraph.

Tags are omitted, line breaks and paragraphs end lines, raised and lowered characters get their `^` and `_`. One pass
over the text; nothing of it is ever shown as HTML.

A row of a table in Markdown, `| radial | m r'' = ... |`, is its cells; lines of which all begin with a dash are a list.

Letters of Mathematica, `\[Theta]` and `\[CapitalOmega]`, are written as the Greek letters that they are.

The abbreviations of a LaTeX document, `\newcommand{\tdd}{\ddot\theta}`, written out in its equations.

`\newcommand`, `\renewcommand`, `\providecommand`, `\def` without patterns and `\DeclareMathOperator` are known, with up
to three arguments. A definition may use those before it. Nothing is expanded twice, and no text grows beyond what an
equation may have, so that the work is bounded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from html import unescape
from itertools import pairwise

from lagrange.answers.limits import LONGEST_MACRO, MOST_MACROS
from lagrange.core.diagnostics import Fragment
from lagrange.core.records import record
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, Edit, closings
from lagrange.expressions.latex_layout import OneEquation
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS

_TAG = re.compile(
    r"<!--.*?(?:-->|\Z)|<(?P<closing>/?)(?P<name>[A-Za-z][A-Za-z0-9]{0,15})(?P<rest>[^<>]{0,2000})>", re.DOTALL
)
_LINES = frozenset(
    ("br", "p", "div", "li", "ul", "ol", "tr", "table", "h1", "h2", "h3", "h4", "h5", "pre", "blockquote", "hr")
)
_LEFT_OUT = frozenset(("style", "script", "head", "title"))
_BREAKS = str.maketrans({"\u00a0": " ", "\r": " "})


_RAISED_FRACTION = re.compile(r"\^\(([0-9]{1,4})\)\s?[⁄/∕]\s?_([0-9]{1,4})")
"""`<sup>1</sup>&frasl;<sub>4</sub>` with its tags taken out."""


def text_of_html(html: str) -> str:
    """The text of a piece of HTML."""
    pieces: list[str] = []
    at, hidden = 0, ""
    for tag in _TAG.finditer(html):
        if not hidden:
            pieces.append(unescape(html[at : tag.start()]))
        at = tag.end()
        name, closes = (tag["name"] or "").lower(), bool(tag["closing"])
        if hidden:
            hidden = "" if closes and name == hidden else hidden
        elif name in _LEFT_OUT and not closes:
            hidden = name
        elif name in _LINES:
            pieces.append("\n")
        elif name == "sup":
            pieces.append(")" if closes else "^(")
        elif name == "sub" and not closes:
            pieces.append("_")
    if not hidden:
        pieces.append(unescape(html[at:]))
    text = _RAISED_FRACTION.sub(r"(\1/\2)", "".join(pieces).translate(_BREAKS))
    return re.sub(r"\^\(\s*([0-9]{1,2})\s*\)", r"^\1", text)


_LOOKS_LIKE_HTML = re.compile(
    r"</(?:p|div|span|i|b|em|strong|sub|sup|li|ul|ol|td|var|code)>|<br\s?/?>|&(?:[a-z]{2,8}|#[0-9]{2,6});"
)
_CODE_SPAN = re.compile(r"(?<![\w`'])`(?P<code>[^`\n]*[=≈<>≤≥][^`\n]*)`(?![\w`])")
_STRONG = re.compile(r"(?<![\w)*])(?P<mark>\*\*|__)(?=[^\W\d_])(?P<words>[^*_\n=]*[^\s*_\n=])(?P=mark)(?![\w(*])")


def in_plain_text(text: str) -> str:
    """The text without the marks of HTML or Markdown, where it was pasted from such a document.

    Code spans and `**words**` keep their place: their marks become spaces.
    """
    if _LOOKS_LIKE_HTML.search(text):
        text = text_of_html(text)
    if "`" in text:
        text = _CODE_SPAN.sub(lambda m: f" {m['code']} ", text)
    if "**" in text or "__" in text:
        text = _STRONG.sub(lambda m: f"  {m['words']}  ", text)
    return text


_NAMED = re.compile(r"\\\[(?P<kind>Capital|Curly)?(?P<name>[A-Z][a-z]{1,12}D?)\]")
_SIGNS = {"Equal": "==", "Prime": "'", "Degree": " deg", "Times": "*", "DifferentialD": "d", "PartialD": "∂"}
_LETTERS = {name: letter for letter, name in GREEK.items()}


def without_named_letters(text: str) -> str:
    """The text with `\\[Theta]` as θ."""

    def letter(match: re.Match[str]) -> str:
        if not match["kind"] and match["name"] in _SIGNS:
            return _SIGNS[match["name"]]
        name = match["name"] if match["kind"] == "Capital" else match["name"].lower()
        return _LETTERS.get(f"var{name}" if match["kind"] == "Curly" else name, _LETTERS.get(name, match[0]))

    return _NAMED.sub(letter, text) if "\\[" in text else text


_CELL = re.compile(r"(?<!\\)\|")
_DASH = re.compile(r"\s*[-–—+]\s+(?=\S)")


def cells_of_row(line: str) -> list[tuple[int, int]]:
    """Where the cells of a row of a table begin and end; none if a line is no such row."""
    bars = [m.start() for m in _CELL.finditer(line)] if line.strip()[:1] == line.strip()[-1:] == "|" else []
    if len(bars) < 3:
        return []
    cells = [(a + 1, b) for a, b in pairwise(bars) if line[a + 1 : b].strip()]
    whole = all("=" not in line[a:b] or line[a:b].strip()[0] not in "=+*/^" for a, b in cells)
    return cells if whole and any("=" in line[a:b] for a, b in cells) else []


def is_list_of_dashes(text: str) -> bool:
    """Whether all lines with equations, of which there are several, begin with a dash and a space."""
    lines = [line for line in text.split("\n") if "=" in line]
    return len(lines) > 1 and all(_DASH.match(line) for line in lines)


# Macros


_DEFINES = re.compile(
    r"\\(?:(?:re)?newcommand|providecommand|DeclareRobustCommand)\*?\s*(?:\{\s*\\(?P<name>[A-Za-z]{1,20})\s*\}|\\(?P<bare>[A-Za-z]{1,20}))"
    r"\s*(?:\[(?P<arguments>[0-3])\])?\s*(?=\{)"
    r"|\\def\s*\\(?P<old>[A-Za-z]{1,20})\s*(?P<pattern>(?:#[1-3]){0,3})\s*(?=\{)"
    r"|\\DeclareMathOperator\*?\s*\{\s*\\(?P<operator>[A-Za-z]{1,20})\s*\}\s*(?=\{)"
)


@record
class Macro:
    """The replacement text of a command."""

    body: str
    arguments: int = 0


def macros_of(text: str) -> dict[str, Macro]:
    """The commands that a text defines, each written out in those before it."""
    if not re.search(r"\\(?:(?:re)?newcommand|providecommand|def|DeclareMathOperator)(?![a-z])", text):
        return {}
    ends = closings(text)
    macros: dict[str, Macro] = {}
    for match in _DEFINES.finditer(text):
        end = ends.get(match.end())
        if end is None or len(macros) >= MOST_MACROS or end - match.end() > LONGEST_MACRO:
            continue
        body = text[match.end() + 1 : end]
        if match["operator"]:
            macros[match["operator"]] = Macro(rf"\operatorname{{{body}}}")
            continue
        body = _expanded(body, macros)
        if len(body) <= LONGEST_MACRO:
            number = int(match["arguments"] or 0) or (match["pattern"] or "").count("#")
            macros[match["name"] or match["bare"] or match["old"]] = Macro(body, number)
    return macros


def with_macros(fragment: Fragment, macros: Mapping[str, Macro]) -> Fragment:
    """An equation with the commands written out."""
    draft = Draft(fragment)
    if not draft.apply(_edits(draft.text, macros)) or len(draft.text) > MAX_ANSWER_CHARACTERS:
        return fragment
    made = draft.finished(latex=True)
    beside = getattr(fragment, "beside", "")
    return replace(made, beside=beside) if isinstance(made, OneEquation) else made


def _expanded(text: str, macros: Mapping[str, Macro]) -> str:
    draft = Draft(Fragment.of(text))
    draft.apply(_edits(text, macros))
    return draft.text


def _edits(text: str, macros: Mapping[str, Macro]) -> Iterator[Edit]:
    if not macros:
        return
    ends = closings(text)
    for match in re.finditer(r"\\([A-Za-z]{1,20})(?![A-Za-z])", text):
        macro = macros.get(match[1])
        if macro is None:
            continue
        at, given = match.end(), []
        for _ in range(macro.arguments):
            while at < len(text) and text[at].isspace():
                at += 1
            if at < len(text) and text[at] == "{" and at in ends:
                given.append(text[at + 1 : ends[at]])
                at = ends[at] + 1
            elif (single := re.compile(r"\\[A-Za-z]+|[^\s{}]").match(text, at)) is not None:
                given.append(single[0])
                at = single.end()
        if len(given) == macro.arguments:
            body = re.sub(r"#([1-3])", partial(_argument, given), macro.body)
            raised = text[: match.start()].rstrip()[-1:] in ("^", "_") or text[at:].lstrip()[:1] in ("^", "_")
            yield match.start(), at, f"{{{body}}}" if raised else f"{body} "


def _argument(given: Sequence[str], match: re.Match[str]) -> str:
    number = int(match[1])
    return given[number - 1] if number <= len(given) else match[0]
