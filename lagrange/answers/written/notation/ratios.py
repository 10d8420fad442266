r"""Equations between ratios and between tuples, and the greatest and the least of several values.

h : R = 5 : 2                      (h)/(R) = (5)/(2)
A_1 : A_2 : A_3 = 1 : 2 : 1        (A_1)/(A_2) = (1)/(2),  (A_2)/(A_3) = (2)/(1)
N / W = 1 : 2                      N / W = (1)/(2)
max(a, b), min(a, b)               (a + b + |a - b|)/2, (a + b - |a - b|)/2
max(T) = ...                       T_max = ...
(x, y) = (0, 0), (a, b)            [x, y] = [0, 0],  [x, y] = [a, b]
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from lagrange.answers.limits import MOST_IN_A_RATIO
from lagrange.expressions.edits import Edit, closings, cuts

_EQUALS = re.compile(r"(?<![<>!=:])==?(?![=>])")
_COLON = re.compile(r"\\colon(?![A-Za-z])|(?<!:):(?![=:])|∶")
_WORD = re.compile(r"(?<![\\\w])[^\W\d_]{4,}(?![\w(])")
_EXTREME = re.compile(r"(?<![A-Za-z0-9_\\])\\?(max|min|Max|Min)\s*(?=[(\[{])")
_OF_A_NAME = re.compile(
    r"\s*\$?\s*\\?(?P<which>max|min|Max|Min)\s*(?:\(|\\left\s*\(|\{)\s*\|?(?P<name>\\?[A-Za-zα-ωΑ-Ω]{1,8})\|?\s*(?:\)|\\right\s*\)|\})\s*(?==)"
)


def ratios_of(text: str) -> list[str]:
    """The equations that an equation between ratios states; none if it is no such equation."""
    if not _COLON.search(text):
        return []
    sides = cuts(text, _EQUALS)
    if len(sides) != 2:
        return []
    left, right = (_members(text[start:end]) for start, end in sides)
    if len(right) < 2:
        return []
    if len(left) == len(right) + 1 and _WORD.search(left[0]):  # a label before the ratio
        left = left[1:]
    if len(left) == 1 and len(right) == 2:
        return [f"{left[0]} = ({right[0]})/({right[1]})"]
    if len(left) != len(right) or len(left) > MOST_IN_A_RATIO or any(map(_WORD.search, (*left, *right))):
        return []
    pairs = zip(left, left[1:], right, right[1:], strict=False)
    return [f"({a})/({b}) = ({c})/({d})" for a, b, c, d in pairs]


_TUPLE = re.compile(r"\(\s*[^()=]+(?:\([^()]*\)[^()=]*)*\)")
_TUPLES = re.compile(
    rf"\s*(?P<names>\((?:[^()=,]+,)+[^()=,]+\))\s*=\s*(?P<values>{_TUPLE.pattern}(?:\s*(?:,|;|or|and|oder|und)\s*{_TUPLE.pattern})*)[\s.]*\Z"
)


def tuples_of(text: str) -> list[str]:
    """`(x, y) = (0, 0), (1, 2)` as one equation between lists for each value; none if it is no such equation."""
    match = _TUPLES.match(text)
    if match is None:
        return []
    comma = re.compile(",")
    names = match["names"][1:-1]
    values = [
        match["values"][a + 1 : b] for a, b in closings(match["values"]).items() if _depth(match["values"], a) == 0
    ]
    number = len(cuts(names, comma))
    if not 2 <= number <= 3 or any(len(cuts(v, comma)) != number for v in values):
        return []
    if len(values) == 1:
        pairs = zip(cuts(names, comma), cuts(values[0], comma), strict=True)
        return [f"{names[a:b].strip()} = {values[0][c:d].strip()}" for (a, b), (c, d) in pairs]
    return [f"[{names}] = [{v}]" for v in values]


def _depth(text: str, at: int) -> int:
    return text.count("(", 0, at) - text.count(")", 0, at)


def ratio_as_fractions(text: str) -> Iterator[Edit]:
    """One equation between two ratios as one between fractions."""
    made = ratios_of(text) if ":" in text or "\\colon" in text else []
    if len(made) == 1:
        yield 0, len(text), made[0]


def _members(side: str) -> list[str]:
    """The members of a ratio; none where one of them is empty."""
    members = [side[start:end].strip(" $&~") for start, end in cuts(side, _COLON)]
    return members if all(members) else []


def name_of_extreme(text: str) -> str:
    """`max(T) = ...` as `T_max = ...`; the text itself where it is no such line."""
    match = _OF_A_NAME.match(text)
    if match is None:
        return text
    index = match["which"].lower()
    return (
        f"{match['name']}_{{{index}}} " + text[match.end() :]
        if "\\" in text
        else f"{match['name']}_{index} " + text[match.end() :]
    )


def extremes(text: str, *, latex: bool = False) -> Iterator[Edit]:
    """The greatest and the least of two to four values, by absolute values; of one, the value itself."""
    ends: dict[int, int] | None = None
    for match in _EXTREME.finditer(text):
        ends = closings(text) if ends is None else ends
        end = ends.get(match.end())
        if end is None:
            continue
        inside = text[match.end() + 1 : end]
        values = [re.sub(r"\\(?:left|right|\{|\})\s*\Z", "", inside[a:b]) for a, b in cuts(inside, re.compile(","))]
        if len(values) > MOST_IN_A_RATIO or not all(v.strip() for v in values) or len(inside) > 200:
            continue
        made, sign = f"({values[0]})", "+" if match[1].lower() == "max" else "-"
        bars = (r"\left|", r"\right|") if latex else ("abs(", ")")
        for value in values[1:]:
            made = f"(({made}+({value}){sign}{bars[0]}{made}-({value}){bars[1]})/2)"
        yield match.start(), end + 1, made
