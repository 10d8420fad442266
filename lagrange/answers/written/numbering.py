r"""Numbers of equations: `... = 0   (2)`, `\;(2)`, `~~(2)`, `[2]`, `(2a)`, `(*)`. None is a factor.

A number in brackets after a space, or after a 0, at the end of an equation with a `=` numbers it: a factor is never
written there. `(Ans.)`, `[Result]` and `q.e.d.` are not factors either. Roman numerals and letters, which may be names,
are numbers only after a wide space.
"""

from __future__ import annotations

import re

from lagrange.answers.limits import LONGEST_NUMBERING

_WIDE = r"(?:\s{2,}|\t|(?:~\s*){2,}|\\q?quad\s*|\\hfill\s*|\\hspace\*?\{[^{}]{0,20}\}\s*|[.…]{3,}\s*|\\dotfill\s*)"
_SPACE = rf"(?:{_WIDE}|(?:\s|~|\\[,;:! ])+|(?<=[=\s]0)|(?<=[=\s]0\.)|(?<=\$)|(?<=\\tag))"
_WORD = r"(?:eq(?:uation|n)?s?\.?\s*|gl(?:eichung)?\.?\s*|no\.?\s*|#\s*)?"
_ANY = rf"{_SPACE}[.,;]?\s*\(\s*{_WORD}(?:[0-9]{{1,3}}(?:[.\-][0-9]{{1,3}})?[a-z]?'*|\*{{1,3}}|†|[0-9]{{1,3}})\s*\)"
_BRACKETS = rf"{_SPACE}[.,;]?\s*\[\s*{_WORD}[0-9]{{1,3}}(?:\.[0-9]{{1,3}})?[a-z]?\s*\]"
_ROMAN = rf"{_WIDE}\(\s*(?:[ivx]{{1,4}}|[IVX]{{1,4}}|[a-hA-H])\s*\)"
_IN_TEXT = (
    r"\s*\\(?:text|textrm|mathrm|mbox|tag)\s*\{\s*\(\s*(?:[ivxIVX]{1,4}|[a-hA-H]|[0-9]{1,3}[a-z]?|\*{1,3})\s*\)\s*\}"
)
_CIRCLED = r"\s*[①-⑳❶-❿➀-➓]"
_RESULT = r"(?:Ans(?:wer)?|ANS(?:WER)?|Result|Q\.?E\.?D|q\.?e\.?d|Proved|Shown|Antwort|Ergebnis)"
_ANSWER = rf"{_SPACE}[.,;]?\s*[(\[{{]?\s*{_RESULT}\.?\s*[)\]}}]?"
_BARE = r"(?<=[^\s,;:=+\-*/^({[&|~])(?:\s{3,}|\t\s*|\\qquad\s*)[0-9]{1,3}[a-z]?"
"""A number without brackets, far to the right of something that ends an expression: not after a comma, as in a list."""
_NUMBER = re.compile(rf"(?:{_ANY}|{_BARE}|{_ANSWER}|{_BRACKETS}|{_ROMAN}|{_IN_TEXT}|{_CIRCLED})\s*[.,;]?\s*\Z")


def number_at_the_end(text: str) -> tuple[int, str]:
    """Where the equation ends and its number begins, and the number; the length of the text and '' if it has none."""
    if "=" not in text:
        return len(text), ""
    end = len(text.rstrip())
    start = max(text.rindex("=") + 1, end - LONGEST_NUMBERING)
    match = _NUMBER.search(text, start)
    if match is None or not text[text.rindex("=") + 1 : match.start()].strip():
        return len(text), ""
    return match.start(), match[0].strip(" \t\n.,;~\\")
