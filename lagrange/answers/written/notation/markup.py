r"""Answers as HTML, as Moodle stores what is typed into its editor: the text, one line for each paragraph.

Tags are omitted, line breaks and paragraphs end lines, raised and lowered characters get their `^` and `_`. One pass
over the text; nothing of it is ever shown as HTML.

A row of a table in Markdown, `| radial | m r'' = ... |`, is its cells; lines of which all begin with a dash are a list.

Letters of Mathematica, `\[Theta]` and `\[CapitalOmega]`, are written as the Greek letters that they are.
"""

from __future__ import annotations

import re
from html import unescape
from itertools import pairwise

from lagrange.expressions.characters import GREEK

_TAG = re.compile(
    r"<!--.*?(?:-->|\Z)|<(?P<closing>/?)(?P<name>[A-Za-z][A-Za-z0-9]{0,15})(?P<rest>[^<>]{0,2000})>", re.DOTALL
)
_LINES = frozenset(
    ("br", "p", "div", "li", "ul", "ol", "tr", "table", "h1", "h2", "h3", "h4", "h5", "pre", "blockquote", "hr")
)
_LEFT_OUT = frozenset(("style", "script", "head", "title"))
_BREAKS = str.maketrans({"\u00a0": " ", "\r": " "})


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
    text = "".join(pieces).translate(_BREAKS)
    return re.sub(r"\^\(\s*([0-9]{1,2})\s*\)", r"^\1", text)


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
    """Where the cells of a row of a table begin and end; none where a line is no such row."""
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
