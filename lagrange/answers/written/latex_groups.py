r"""Groups in LaTeX that are written in other ways: `{a \over b}`, `x^(1/2)`; numbers after powers, `x^2 4c`."""

from __future__ import annotations

import re
from collections.abc import Iterator

from lagrange.expressions.edits import Edit, closings

_L_OVER = re.compile(r"\\over(?![A-Za-z])")
_L_POWER_GROUP = re.compile(r"\^\s*\(")
_L_BEFORE_NUMBER = re.compile(
    r"(?:(?<=[A-Za-z})\]])|(?P<power>\^\s*(?:[0-9]|\{\s*[0-9]{1,2}\s*\})))\s*"
    r"(?P<space>(?:\\[,;:! ]|~)\s*)*(?<=[\s~,;:!])(?=[0-9])"
)
_L_FUNCTION = re.compile(r"\\(?:sin|cos|tan|cot|sinh|cosh|tanh|ln|log|exp|sqrt|begin|[a-z]*arrow)\s*\Z")


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
