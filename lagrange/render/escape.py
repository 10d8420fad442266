"""Escaping plain text: characters that HTML and LaTeX would interpret, and letters that pdflatex does not have.

A name or title from a problem file may hold any character of Unicode. What LaTeX has a command for becomes that
command; other letters lose their accents; what is left after that appears as its code point, [U+4E2D], so that the
document compiles and nothing vanishes without a trace. Control and format characters are dropped, as in every format
(`core/printable.py`).
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Sequence
from html import escape as html_escape

from lagrange.core.printable import printable
from lagrange.document.names import GREEK

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "%": r"\%",
    "$": r"\$",
    "#": r"\#",
    "&": r"\&",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"$<$",
    ">": r"$>$",
    "|": r"$|$",
    "\u00a0": "~",
    "\u2009": r"\,",
    "\u202f": r"\,",
    "−": "$-$",
    "×": r"$\times$",
    "·": r"$\cdot$",
    "±": r"$\pm$",
    "°": r"$^\circ$",
    "∂": r"$\partial$",
    "∇": r"$\nabla$",
    "∧": r"$\wedge$",
    "√": r"$\surd$",
    "∞": r"$\infty$",
    "≠": r"$\neq$",
    "≤": r"$\le$",
    "≥": r"$\ge$",
    "≈": r"$\approx$",
    "≡": r"$\equiv$",
    "→": r"$\to$",
    "∝": r"$\propto$",
    "′": r"$'$",
    "″": r"$''$",
    "½": r"$\tfrac{1}{2}$",
    "✓": r"$\checkmark$",
    "–": "--",
    "—": "---",
    "…": r"\dots{}",
    "§": r"\S{}",
    "‘": "`",
    "’": "'",
    "“": "``",
    "”": "''",
    "„": '"',
}
_LETTERS = {letter: f"${command}$" for letter, command in GREEK.values()}
_SCRIPTS = {c: f"$^{n}$" for n, c in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")} | {c: f"$_{n}$" for n, c in enumerate("₀₁₂₃₄₅₆₇₈₉")}
_DOTS = {"\u0307": r"\dot", "\u0308": r"\ddot"}
_KNOWN = _SPECIAL | _LETTERS | _SCRIPTS
_LATIN = 0x17F  # the end of Latin Extended-A: inputenc has the letters up to here
_CODE_OR_ROOT = re.compile(r"(`[^`]+`|√\([^()]*\)|√\d+)")
_DOTTED = re.compile("(.)([\u0307\u0308])")


def escape(text: str) -> str:
    """Text as LaTeX that prints it: `--format json` as code, √(2/7) with the bar of a root."""
    return "".join(map(_piece, _CODE_OR_ROOT.split(text)))


def _piece(text: str) -> str:
    if not _CODE_OR_ROOT.fullmatch(text):
        return _plain(text)
    if text.startswith("`"):
        return rf"\texttt{{{_plain(text[1:-1]).replace('--', '-{}-')}}}"
    return rf"$\sqrt{{{_plain(text[1:].strip('()')).replace('$', '')}}}$"


def _plain(text: str) -> str:
    # Straight quotes come in pairs; TeX needs to know which of the two opens.
    text = re.sub(r'"([^"]*)"', "“\\1”", unicodedata.normalize("NFC", text))
    # After NFC a dot is combining only where Unicode has no such letter: θ̇ stays a pair, and becomes \dot{\theta}.
    pieces = re.split("(.[\u0307\u0308])", text)
    return "".join(_dotted(p) if _DOTTED.fullmatch(p) else "".join(map(_character, p)) for p in pieces)


def slug(title: str) -> str:
    """The title as a label: `ideal-pendulum`."""
    plain = unicodedata.normalize("NFKD", title).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "-", plain).strip("-") or "derivation"


def prefixes_of(titles: Sequence[str]) -> list[str]:
    """What the labels of derivations begin with: the slugs of their titles, each once."""
    slugs = [slug(title) for title in titles]
    again = (slugs[:n].count(s) for n, s in enumerate(slugs))
    return [f"{s}-{n + 1}" if n else s for s, n in zip(slugs, again, strict=True)]


def _dotted(pair: str) -> str:
    letter = _character(pair[0]).strip("$")
    return f"${_DOTS[pair[1]]}{{{letter}}}$"


def _character(character: str) -> str:
    if character in _KNOWN:
        return _KNOWN[character]
    if character.isspace():
        return " "
    if character.isascii() or (ord(character) <= _LATIN and character.isalpha()):
        return character if character.isprintable() else ""
    if unicodedata.category(character) in ("Cc", "Cf", "Mn"):
        return ""
    apart = unicodedata.normalize("NFD", character)
    if _DOTTED.fullmatch(apart):
        return _dotted(apart)
    plain = unicodedata.normalize("NFKD", character).encode("ascii", "ignore").decode()
    return "".join(map(_character, plain)) or f"[U+{ord(character):04X}]"


_APOSTROPHE = re.compile(r"(?<=[A-Za-z])'(?=[A-Za-z])|(?<=[a-z]s)'(?=\s)")


def html_text(text: str) -> str:
    """Text as HTML that shows it, with the apostrophes of a printer; a derivative's prime is not between letters."""
    return html_escape(_APOSTROPHE.sub("’", printable(text)))
