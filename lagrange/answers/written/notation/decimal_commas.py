"""Decimal commas, `2,5 R` for 2.5 R: a comma between two digits, without a space, outside lists and indices.

Each is replaced by a point, so that the text keeps its length and every place in it. A comma in the brackets of a
function of several arguments, in a list `[1,2]`, in braces `x_{1,2}` or in an enumeration `1,2,3` is not a decimal
comma, and neither is that of `10,000`, which may separate thousands.
"""

from __future__ import annotations

import re

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
    r"""Whether a comma stands in the braces of LaTeX that hold a value, `\frac{2,5}{3}` or `\sqrt{0,5}`."""
    opening = text.rfind("{", 0, at)
    return opening > 0 and re.search(r"(?:\\[A-Za-z]+|\})\s*\Z", text[max(0, opening - 12) : opening]) is not None
