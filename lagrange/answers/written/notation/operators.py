"""The time derivative as an operator D: `D^2 x`, `D x`, `(D phi)^2`, `D(m r^2 D phi)`, `(m D^2 + b D + c) x`.

An operator before brackets is applied to their contents; one before a name, to that name; a sum with operators in
brackets is applied to the name or the brackets after it, term by term. D is an operator only where the problem declares
no `D`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from lagrange.answers.limits import MOST_OPERATORS
from lagrange.expressions.characters import GREEK, SUBSCRIPTS
from lagrange.expressions.edits import Draft, Edit, closings, cuts

_POWER = r"(?:\s*(?:\^\s*\{?\s*|\*\*)(?P<order>[1-3])\s*\}?|(?P<raised>[²³]))?"
_D = re.compile(rf"(?<![A-Za-z0-9_'.\\])(?:\\(?:mathrm|operatorname)\{{D\}}|D){_POWER}(?:\s*\*\s*(?=[A-Za-z(]))?")
_NAME = re.compile(
    rf"\s*(?P<name>\\?(?:[{''.join(GREEK)}]|[A-Za-z]+)(?:_\{{[A-Za-z0-9]{{1,8}}\}}|[A-Za-z0-9_{''.join(SUBSCRIPTS)}])*)(?![A-Za-z0-9_(\[])"
)
_JOINED = re.compile(rf"(?<![A-Za-z0-9_'.\\])D(?=[{''.join(GREEK)}]|\\[a-z])")
_BRACKET = re.compile(r"\s*(?=\()")
_SIGN = re.compile(r"(?<=[^\s(])\s*[+−-](?!\Z)")


def with_operators(draft: Draft, names: frozenset[str]) -> None:
    """Write the operators as derivatives; `names` are those that D, D^2 may be joined with, as in `Dx`."""
    if "D" not in draft.text:
        return
    if names:
        joined = re.compile(rf"(?<![A-Za-z0-9_'.\\])D(?=(?:{'|'.join(map(re.escape, sorted(names)))})(?![A-Za-z0-9_]))")
        draft.replace(joined, "D ")
    draft.replace(_JOINED, "D ")
    for _ in range(MOST_OPERATORS):
        if not (draft.apply(_polynomials(draft.text)) or draft.apply(_last(draft.text))):
            return


def _order(match: re.Match[str]) -> int:
    return int(match["order"] or {"²": 2, "³": 3}.get(match["raised"] or "", 1))


def _last(text: str) -> Iterator[Edit]:
    """The last operator, which is applied to a name or to brackets."""
    matches = [*_D.finditer(text)]
    if not matches:
        return
    match = matches[-1]
    order = _order(match)
    if name := _NAME.match(text, match.end()):
        yield match.start(), name.end(), f"{'diff(' * order}{name['name']}{', t)' * order}"
    elif _BRACKET.match(text, match.end()):
        opening = text.index("(", match.end())
        end = closings(text).get(opening)
        if end is not None and "," not in text[opening:end].replace(", t)", ""):
            yield match.start(), opening, "diff(" * order
            yield end + 1, end + 1, ", t)" * order


def _polynomials(text: str) -> Iterator[Edit]:
    """`(m D^2 + c) x` as m D^2 x + c x."""
    ends: dict[int, int] | None = None
    for match in _D.finditer(text):
        if _NAME.match(text, match.end()) or _BRACKET.match(text, match.end()):
            continue
        ends = closings(text) if ends is None else ends
        around = [(s, e) for s, e in ends.items() if s < match.start() < e and text[s] == "("]
        if not around:
            continue
        start, end = max(around)
        name = _NAME.match(text, end + 1)
        bracket = _BRACKET.match(text, end + 1)
        if name is None and (bracket is None or bracket.end() not in ends):
            continue
        stop = name.end() if name else ends[bracket.end()] + 1  # type: ignore[union-attr]
        operand = text[end + 1 : stop].strip()
        terms = _terms(text[start + 1 : end])
        if len(terms) > MOST_OPERATORS or any(len(_D.findall(term)) > 1 for term in terms):
            continue
        yield start, stop, f"({' '.join(_applied(term, operand) for term in terms)})"
        return


def _terms(inside: str) -> list[str]:
    places = [start for start, _ in cuts(inside, _SIGN)]
    starts = [0, *(m.start() for m in _SIGN.finditer(inside) if any(m.end() == p for p in places)), len(inside)]
    return [inside[a:b].strip() for a, b in pairwise(starts)]


def _applied(term: str, operand: str) -> str:
    match = _D.search(term)
    if match is None:
        return f"{term} {operand}"
    factor, order = f"{term[: match.start()]} {term[match.end() :]}".strip(), _order(match)
    joint = " " if factor and factor[-1] not in "+-−*/" else ""
    return f"{factor}{joint}{'diff(' * order}{operand}{', t)' * order}"
