r"""Numbers of equations, `= 0   (2)`, `\;(2)`, `~~(2)`, `[2]`, `(2a)`, `(*)`, `.... (2)`, `\eqno(2)`, are no factors.

A number in brackets after a space, or after a 0, at the end of a line with an equation or an inequality numbers it: a
factor is never written there. `(Ans.)`, `[Result]` and `q.e.d.` are not factors either. Roman numerals and letters,
which may be names, are numbers only after a wide space.

`From (2) and (3)  F = ...`, `(1) in (2): ...`: equations that words refer to are no factors either.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from lagrange.answers.limits import LONGEST_NUMBERING
from lagrange.core.diagnostics import Diagnostic, Severity, Source, Span

_WIDE = (
    r"(?:\s{2,}+|\t|(?:~\s*+){2,}+|\\q?quad\s*+|\\(?:h|dot)fill\s*+|\\hspace\*?\{[^{}]{0,20}\}\s*+"
    r"|(?:[.…]{3,}+|[&|]{1,3})\s*+)"
)
_LEADERS = r"(?:\\(?:[lc]?dots|dotfill)(?![A-Za-z])\s*+|[.…·]{3,}+\s*+|-{2,}+\s*+|[—–]++\s*+)"
"""What leads to a number; a run is taken whole, as its parts could be divided in exponentially many ways."""
_SPACE = rf"(?:{_WIDE}|(?:\s|~|\\[,;:! ])++|{_LEADERS}++|(?<=[=\s]0)|(?<=[=\s]0\.)|(?<=\$)|(?<=\\tag)|(?<=[.…]))"
_BEFORE = r"(?:eq(?:uation|n)?s?\.?\s*|gl(?:eichung)?\.?\s*|no\.?\s*|#\s*)?"
_DIGITS = r"(?:[0-9]{1,3}(?:[.\-][0-9]{1,3})?[a-z]?'*|\*{1,3}|†)"
_ANY = rf"{_SPACE}{_LEADERS}*+[.,;]?\s*{_BEFORE}\(\s*{_BEFORE}{_DIGITS}\s*\)"
_WORD = r"(?:[Ee]q(?:uation|n)?s?|G(?:l|leichung))\b\.?"
_NAMED = rf"\s+{_WORD}\s*\(?[0-9]{{1,3}}(?:\.[0-9]{{1,3}})?[a-z]?\)?"
_BRACKETS = (
    rf"{_SPACE}[.,;]?\s*(?:\[\s*{_BEFORE}[0-9]{{1,3}}(?:\.[0-9]{{1,3}})?[a-z]?\s*\]|[<⟨]\s*[0-9]{{1,3}}[a-z]?\s*[>⟩])"
)
_LETTERS = r"(?:[ivx]{1,4}|[IVX]{1,4}|[a-hA-H])"
_ROMAN = rf"{_WIDE}{_LEADERS}*+\(\s*(?:\\(?:mathrm|text|rm)\s*\{{?)?\s*{_LETTERS}\s*\}}?\s*\)"
_IN_TEXT = (
    r"\s*\\(?:text(?:rm|bf|it)?|mathrm|mathbf|mbox|tag\*?|l?eqno)\s*\{?\s*"
    rf"\(\s*(?:{_LETTERS}|{_DIGITS})\s*\)\s*\}}?"
)
_CIRCLED = r"\s*[①-⑳❶-❿➀-➓]"
_RESULT = r"(?:Ans(?:wer)?|ANS(?:WER)?|Result|Q\.?E\.?D|q\.?e\.?d|Proved|Shown|Antwort|Ergebnis)"
_ANSWER = rf"{_SPACE}[.,;]?\s*[(\[{{]?\s*{_RESULT}\.?\s*[)\]}}]?"
_BARE = r"(?<=[^\s,;:=+\-*/^({[&|~])(?:\s{3,}+|\t\s*+|\\qquad\s*+)(?:[0-9]{1,3}[a-z]?|\{[0-9]{1,3}[a-z]?\})"
"""A number without brackets, far to the right of something that ends an expression: not after a comma, as in a list."""
_NUMBER = re.compile(rf"(?:{_ANY}|{_NAMED}|{_BARE}|{_ANSWER}|{_BRACKETS}|{_ROMAN}|{_IN_TEXT}|{_CIRCLED})\s*[.,;]?\s*\Z")
_CLOSING = re.compile(
    r"(?:\s|\\\\(?:\[[^\[\]]{0,10}\])?|\\end\s?\{[a-z]{1,12}\*?\}|\\[\])]|\$|\\no(?:number|tag)|\\label\{[^{}]{0,40}\})*\Z"
)
"""What ends a line of mathematics after its number."""
_RELATION = re.compile(
    r"[=≤≥≈]|<(?!\s*[0-9]{1,3}[a-z]?\s*>)|(?<!<[0-9])(?<!<[0-9][0-9])>"
    r"|\\(?:[lg](?:t|eq?|eqslant)|approx|equiv)(?![A-Za-z])"
)
_CONTINUES = re.compile(r"\s*&?\s*[-+−=·]")
_MATRIX = re.compile(r"(?<!\\)\[[^\]]*\Z")
_ONE = rf"(?:{_WORD}\s*\(?[1-9][0-9]?[a-z]?\)?(?![\w.(])|[(\[]\s*[1-9][0-9]?[a-z]?\s*[)\]])"
_SEVERAL = rf"{_ONE}(?:\s*(?:,|&|\+|-|−|->|→|\b(?:and|und|et|in|into|with|mit)\b)\s*{_ONE}){{0,5}}"
_REFERENCE = re.compile(
    r"(?<![^\W\d_])(?:from|in|into|by|with|using|use|of|to|see|and|both|put|inserting|substituting|combining|adding"
    rf"|subtracting|aus|mit|nach|und|de|dans|avec)\s+(?P<after>{_SEVERAL})(?=[\s,.:;]|\Z)"
    rf"|^[ \t]*(?P<before>{_SEVERAL}\s*(?::(?!=)|,|=>|⇒|→|->))"
    rf"|^[ \t]*(?P<label>\[[1-9][0-9]?\])(?=\s+[^\s=])",
    re.MULTILINE | re.IGNORECASE,
)
"""The numbers of equations to which words refer, or that stand before an equation."""


def number_at_the_end(text: str) -> tuple[int, str]:
    """Where the equation ends and its number begins, and the number; the length of the text and '' if it has none."""
    relations = [*_RELATION.finditer(text)]
    if not relations:
        return len(text), ""
    return _number_after(text, relations[-1].end())


def _number_after(text: str, begin: int) -> tuple[int, str]:
    end = len(text.rstrip())
    match = _NUMBER.search(text, max(begin, end - LONGEST_NUMBERING))
    if match is None or not text[begin : match.start()].strip(" &"):
        return len(text), ""
    return match.start(), match[0].strip(" \t\n.,;~\\")


def _numbers_in(text: str) -> Iterator[tuple[int, int]]:
    """Where the numbers at the ends of the lines of a text begin and end."""
    start = 0
    for line in text.split("\n"):
        begin, start = start, start + len(line) + 1
        if not line or line[-1] in "=+-*/({[" or not (_RELATION.search(line) or _CONTINUES.match(line)):
            continue
        closing = _CLOSING.search(line, max(0, len(line) - LONGEST_NUMBERING))
        end = closing.start() if closing else len(line)
        kept, number = number_at_the_end(line[:end])
        if number and not _MATRIX.search(line[:kept]):
            yield begin + kept, begin + end


def without_numbers(text: str) -> str:
    """The text with spaces for the numbers of its equations, and for the numbers to which its words refer."""
    pieces, at = [], 0
    for start, end in _numbers_in(text):
        pieces += [text[at:start], " " * (end - start)]
        at = end
    text = "".join([*pieces, text[at:]])
    return _REFERENCE.sub(lambda m: m[0].replace(m[m.lastgroup or 0], " " * len(m[m.lastgroup or 0])), text)


def notes_on_numbers(source: Source) -> list[Diagnostic]:
    """Notes that what follows the equations of a source numbers them."""
    notes = []
    for start, end in _numbers_in(source.text):
        number = source.text[start:end].strip(" \t.,;~&|\\")
        message = f"`{number}` after the equation numbers it, and is no factor"
        notes.append(Diagnostic("read-as", message, Span(source, start, end), level=Severity.NOTE))
    return notes
